// A file that is watched: each time it was saved it is read, solved and made a live page, on a thread of its own, while
// whoever looks at it is answered. Knows no sockets.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/files/place_in_file.hpp"
#include "engine/file/error.hpp"

namespace kinegraph::app {

/// What is wrong with a file, and where.
struct FileFault {
    std::optional<PlaceInFile> place;
    Error error;
};

/// What there is to see: the last page that could be made, and what is wrong with the file since.
struct Watched {
    std::shared_ptr<const std::string> page;  ///< none before the first that could be made
    int pages = 0;                            ///< how many have been made, the number of `page`
    std::vector<FileFault> faults;
};

class WatchedFile {
public:
    /// A page of a file's text, under its number; else what is wrong with the file. Called on the thread of the work
    /// alone.
    using Making = std::function<Result<std::string>(const std::string& text, int number)>;

    WatchedFile(std::string path, Making making);
    WatchedFile(const WatchedFile&) = delete;
    WatchedFile& operator=(const WatchedFile&) = delete;
    /// Waits for work under way, see is_busy().
    ~WatchedFile();

    /// Looks whether the file was saved; to be called again and again. A file is read when it has rested from one look
    /// to the next: an editor may still be writing it. Returns what there is to see where that has changed.
    std::optional<Watched> look();
    bool is_busy();

private:
    /// By which one state of a file is known from another; all zero where there is none.
    struct Stamp {
        long long inode = 0, size = 0, seconds = 0, nanoseconds = 0;
        bool operator==(const Stamp&) const = default;
    };
    static Stamp stamp_of(const std::string& path);
    void hand_over();
    void work();
    void finish(Result<std::string> made, const std::string& text);

    const std::string path_;
    const Making making_;
    std::optional<Stamp> read_, seen_;   ///< as it was read last, as it was seen last
    std::optional<std::string> solved_;  ///< its text when it was handed over last

    std::mutex mutex_;
    std::condition_variable wakes_;
    std::optional<std::string> waiting_;  ///< a text to be worked on
    bool working_ = false, ends_ = false, changed_ = false;
    Watched watched_;
    std::thread worker_;
};

}  // namespace kinegraph::app
