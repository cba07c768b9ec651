// Lines through several workers, answers out in the order of the lines. Owns the threads and the window of lines under
// way; knows nothing of what a line means.
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
    /// Answers a line; each worker is called by one thread alone. No exception leaves it.
    using Worker = std::function<std::string(const std::string& line)>;
    /// Takes the answers one after the other; false: it takes no more.
    using Sink = std::function<bool(const std::string& answer)>;

    /// Whether no further line is to be begun; asked by workers, before each.
    using Stops = std::function<bool()>;

    /// Where the machine refuses a thread, so many workers as it gave.
    InOrder(std::vector<Worker> workers, Sink sink, Stops stops);
    InOrder(const InOrder&) = delete;
    InOrder& operator=(const InOrder&) = delete;
    ~InOrder() { finish(); }

    /// Waits while so many lines are under way that an answer must come first. False: the sink takes no more, or no
    /// further line is begun.
    bool add(std::string line);
    /// Waits for the answers of all lines that are begun. False: the sink did not take them all.
    bool finish();

private:
    struct Line {
        std::string text;  ///< and once it is done the answer
        bool done = false;
    };
    void work(const Worker& worker);
    bool has_much_room() const { return lines_.size() <= window_ / 2; }
    /// Hands on what is done at the head; `lock` holds mutex_.
    void hand_on(std::unique_lock<std::mutex>& lock);

    Sink sink_;
    Stops stops_;
    std::size_t window_;
    std::mutex mutex_;
    std::condition_variable to_do_, room_;
    std::deque<Line> lines_;  ///< under way; a deque, so that a line stays in its place while others come and go
    std::size_t taken_ = 0;   ///< of lines_, by workers
    bool handing_on_ = false, closed_ = false, refused_ = false, stopped_ = false;
    std::vector<std::thread> threads_;
};

}  // namespace kinegraph::app
