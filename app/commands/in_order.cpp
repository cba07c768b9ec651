#include "app/commands/in_order.hpp"

#include <pthread.h>

#include <csignal>
#include <system_error>
#include <utility>

namespace kinegraph::app {
namespace {

constexpr std::size_t window_of_a_worker = 16;

/// While it exists, new threads block all signals, so that only the existing threads receive them.
class NoSignals {
public:
    NoSignals() {
        sigset_t all;
        ::sigfillset(&all);
        ::pthread_sigmask(SIG_SETMASK, &all, &before_);
    }
    NoSignals(const NoSignals&) = delete;
    NoSignals& operator=(const NoSignals&) = delete;
    ~NoSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

private:
    sigset_t before_{};
};

}  // namespace

InOrder::InOrder(std::vector<Worker> workers, Sink sink, Stops stops)
    : sink_(std::move(sink)), stops_(std::move(stops)), window_(window_of_a_worker * workers.size()) {
    const NoSignals blocked;
    for (Worker& worker : workers) {
        try {
            threads_.emplace_back([this, worker = std::move(worker)] { work(worker); });
        } catch (const std::system_error&) {
            if (threads_.empty()) throw;
            break;  // the system gives no more threads: continue with those we have
        }
    }
}

bool InOrder::add(std::string line) {
    std::unique_lock lock(mutex_);
    // Waits until the window is well below its limit: a wake-up for each line costs a tenth of an answer.
    if (lines_.size() >= window_) room_.wait(lock, [this] { return has_much_room() || refused_ || stopped_; });
    if (refused_ || stopped_) return false;
    lines_.push_back({std::move(line)});
    to_do_.notify_one();
    return true;
}

bool InOrder::finish() {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    to_do_.notify_all();
    for (std::thread& thread : threads_)
        if (thread.joinable()) thread.join();
    return !refused_;
}

void InOrder::work(const Worker& worker) {
    std::unique_lock lock(mutex_);
    while (true) {
        to_do_.wait(lock, [this] { return taken_ < lines_.size() || closed_ || refused_ || stopped_; });
        if (refused_ || stopped_ || taken_ == lines_.size()) return;
        if (stops_()) {
            stopped_ = true;
            room_.notify_all();
            to_do_.notify_all();
            return;
        }
        Line& line = lines_[taken_++];
        lock.unlock();
        line.text = worker(line.text);
        lock.lock();
        line.done = true;
        hand_on(lock);
    }
}

void InOrder::hand_on(std::unique_lock<std::mutex>& lock) {
    if (handing_on_) return;  // another thread writes answers and will find this one too
    handing_on_ = true;
    while (!refused_ && !lines_.empty() && lines_.front().done) {
        const std::string answer = std::move(lines_.front().text);
        lines_.pop_front();
        --taken_;
        if (has_much_room()) room_.notify_one();
        lock.unlock();
        const bool taken = sink_(answer);
        lock.lock();
        refused_ = refused_ || !taken;
    }
    handing_on_ = false;
    if (refused_) {
        room_.notify_all();
        to_do_.notify_all();
    }
}

}  // namespace kinegraph::app
