// Runs lines through several workers and delivers the answers in the order of the lines. Owns the threads and the
// window of lines in progress; does not interpret the lines.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace kinegraph::app {

class InOrder {
public:
    /// Answers a line. Each worker is called by one thread only, and must not throw.
    using Worker = std::function<std::string(const std::string& line)>;
    /// Receives the answers one after the other; false: accepts no more.
    using Sink = std::function<bool(const std::string& answer)>;

    /// True if no further line is to be started; called by workers before each line.
    using Stops = std::function<bool()>;

    /// If the system refuses a thread, uses fewer workers.
    InOrder(std::vector<Worker> workers, Sink sink, Stops stops);
    InOrder(const InOrder&) = delete;
    InOrder& operator=(const InOrder&) = delete;
    ~InOrder() { finish(); }

    /// Waits while the window of lines in progress is full. False: the sink accepts no more, or no further line is
    /// started.
    bool add(std::string line);
    /// Waits for the answers of all started lines. False: the sink did not accept them all.
    bool finish();

private:
    struct Line {
        std::string text;  ///< the line; once done, its answer
        bool done = false;
    };
    void work(const Worker& worker);
    bool has_much_room() const { return lines_.size() <= window_ / 2; }
    /// Delivers the finished answers at the head; `lock` must own mutex_.
    void hand_on(std::unique_lock<std::mutex>& lock);

    Sink sink_;
    Stops stops_;
    std::size_t window_;
    std::mutex mutex_;
    std::condition_variable to_do_, room_;
    std::deque<Line> lines_;  ///< in progress; a deque, so that references stay valid when others are added or removed
    std::size_t taken_ = 0;   ///< number of lines_ that workers have taken
    bool handing_on_ = false, closed_ = false, refused_ = false, stopped_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace kinegraph::app
