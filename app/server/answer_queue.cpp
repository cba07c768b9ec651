#include "app/server/answer_queue.hpp"

#include <utility>

namespace kinegraph::app {

void PreparedBody::give(std::string body) {
    auto shared = std::make_shared<const std::string>(std::move(body));
    const std::lock_guard lock(mutex_);
    body_ = std::move(shared);
}
std::shared_ptr<const std::string> PreparedBody::get() const {
    const std::lock_guard lock(mutex_);
    return body_;
}

AnswerQueue::AnswerQueue(Making make, std::function<void()> made)
    : make_(std::move(make)), made_(std::move(made)), worker_([this] { work(); }) {}
AnswerQueue::~AnswerQueue() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    wakes_.notify_one();
    worker_.join();
}

std::shared_ptr<PreparedBody> AnswerQueue::ask(std::string request) {
    auto answer = std::make_shared<PreparedBody>();
    const std::lock_guard lock(mutex_);
    waiting_.push_back({std::move(request), answer});
    wakes_.notify_one();
    return answer;
}

bool AnswerQueue::is_busy() const {
    const std::lock_guard lock(mutex_);
    return working_ || !waiting_.empty();
}

void AnswerQueue::work() {
    while (true) {
        Asked asked;
        {
            std::unique_lock lock(mutex_);
            working_ = false;
            wakes_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
            if (ends_) return;
            asked = std::move(waiting_.front());
            waiting_.pop_front();
            working_ = true;
        }
        if (asked.answer.expired()) continue;
        std::string body = make_(asked.request);
        if (const auto answer = asked.answer.lock()) answer->give(std::move(body));
        made_();
    }
}

}  // namespace kinegraph::app
