// Watches a file: whenever it is saved, a separate thread reads it, solves it and makes a live page, while the server
// stays responsive. Knows no sockets.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <kinegraph/error.hpp>

#include "app/files/place_in_file.hpp"

namespace kinegraph::app {

/// A fault of a file and its position.
struct FileFault {
    std::optional<PlaceInFile> place;
    Diagnostic fault;
};

/// The state to show: the last page that could be made, and the faults of the file since then.
struct Watched {
    std::shared_ptr<const std::string> page;  ///< null until the first page is made
    int pages = 0;                            ///< number of pages made so far, which is the number of `page`
    std::vector<FileFault> faults;
};

class WatchedFile {
public:
    /// Makes page `number` from a file's text. Error: the faults of the file. Called on the worker thread only.
    using Making = std::function<Expected<std::string>(const std::string& text, int number)>;

    WatchedFile(std::string path, Making making);
    WatchedFile(const WatchedFile&) = delete;
    WatchedFile& operator=(const WatchedFile&) = delete;
    /// Waits for work in progress, see is_busy().
    ~WatchedFile();

    /// Checks whether the file was saved; call it periodically. The file is read when two successive calls find it
    /// unchanged, because an editor may still be writing it. Returns the new state if it has changed.
    std::optional<Watched> look();
    bool is_busy();

private:
    /// Identifies a version of the file; all zero if there is no file.
    struct Stamp {
        long long inode = 0, size = 0, seconds = 0, nanoseconds = 0;
        bool operator==(const Stamp&) const = default;
    };
    static Stamp stamp_of(const std::string& path);
    void hand_over();
    void work();
    void finish(Expected<std::string> made, const std::string& text);

    const std::string path_;
    const Making making_;
    std::optional<Stamp> read_, seen_;   ///< as last read, as last seen
    std::optional<std::string> solved_;  ///< text passed to the worker last

    std::mutex mutex_;
    std::condition_variable wakes_;
    std::optional<std::string> waiting_;  ///< text to be processed next
    bool working_ = false, ends_ = false, changed_ = false;
    Watched watched_;
    std::thread worker_;
};

}  // namespace kinegraph::app
