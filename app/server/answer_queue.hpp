// Makes answers on a thread of their own, one after the other, while the server stays responsive. Knows no sockets.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace kinegraph::app {

/// An answer's body that is made by another thread.
class PreparedBody {
public:
    void give(std::string body);
    /// Null until it is there.
    std::shared_ptr<const std::string> get() const;

private:
    mutable std::mutex mutex_;
    std::shared_ptr<const std::string> body_;
};

class AnswerQueue {
public:
    /// `make` is called on the queue's thread; `made` after each answer, on the same thread.
    using Making = std::function<std::string(const std::string& request)>;
    AnswerQueue(Making make, std::function<void()> made);
    AnswerQueue(const AnswerQueue&) = delete;
    AnswerQueue& operator=(const AnswerQueue&) = delete;
    /// Waits for work in progress, see is_busy().
    ~AnswerQueue();

    /// A request whose answer nobody holds any more when its turn comes is skipped.
    std::shared_ptr<PreparedBody> ask(std::string request);
    bool is_busy() const;

private:
    struct Asked {
        std::string request;
        std::weak_ptr<PreparedBody> answer;
    };
    void work();

    const Making make_;
    const std::function<void()> made_;
    mutable std::mutex mutex_;
    std::condition_variable wakes_;
    std::deque<Asked> waiting_;
    bool working_ = false, ends_ = false;
    std::thread worker_;
};

}  // namespace kinegraph::app
