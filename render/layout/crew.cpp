// One piece of work at a time is shared out; who is free takes the next number.
#include "render/layout/crew.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace kinegraph::render {

struct Crew::Shared {
    std::mutex mutex;
    std::condition_variable begun, ended;
    const std::function<void(std::size_t)>* work = nullptr;  // none: nothing is to be done
    std::size_t count = 0, next = 0, done = 0;
    std::vector<std::exception_ptr> thrown;  // by number
    bool closed = false;
    std::vector<std::thread> helpers;

    /// Takes numbers until there are none left. Called and left with the lock held.
    void take_part(std::unique_lock<std::mutex>& lock) {
        while (work != nullptr && next < count) {
            const std::size_t own = next++;
            const auto& call = *work;
            lock.unlock();
            std::exception_ptr fault;
            try {
                call(own);
            } catch (...) {
                fault = std::current_exception();
            }
            lock.lock();
            thrown[own] = std::move(fault);
            if (++done == count) ended.notify_all();
        }
    }
    void help() {
        std::unique_lock lock(mutex);
        while (!closed) {
            take_part(lock);
            begun.wait(lock, [this] { return closed || (work != nullptr && next < count); });
        }
    }
};

Crew::Crew(int helpers, const std::function<void()>& first, const std::function<void()>& last)
    : shared_(std::make_unique<Shared>()) {
    shared_->helpers.reserve(static_cast<std::size_t>(std::max(helpers, 0)));
    for (int i = 0; i < helpers; ++i) {
        try {
            shared_->helpers.emplace_back([shared = shared_.get(), first, last] {
                if (first) first();
                shared->help();
                if (last) last();
            });
        } catch (const std::exception&) {
            break;  // those that are there will do
        }
    }
}

Crew::~Crew() {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->closed = true;
    }
    shared_->begun.notify_all();
    for (std::thread& helper : shared_->helpers) helper.join();
}

void Crew::share(std::size_t count, const std::function<void(std::size_t)>& work) {
    if (count == 0) return;
    Shared& shared = *shared_;
    std::unique_lock lock(shared.mutex);
    shared.thrown.assign(count, nullptr);
    shared.work = &work;
    shared.count = count;
    shared.next = shared.done = 0;
    if (count > 1) shared.begun.notify_all();
    shared.take_part(lock);
    shared.ended.wait(lock, [&] { return shared.done == count; });
    shared.work = nullptr;
    for (const std::exception_ptr& fault : shared.thrown)
        if (fault) std::rethrow_exception(fault);
}

void share_out(Crew* crew, std::size_t count, const std::function<void(std::size_t)>& work) {
    if (crew != nullptr && count > 1) return crew->share(count, work);
    for (std::size_t i = 0; i < count; ++i) work(i);
}

}  // namespace kinegraph::render
