#include "app/server/watched_file.hpp"

#include <sys/stat.h>

#include <exception>
#include <utility>

#include "app/files/files.hpp"
#include "lang/keys/command_line.hpp"
#include "lang/keys/common.hpp"

namespace kinegraph::app {
namespace {

Diagnostics ours(const char* what) {
    return {{Diagnostic::Kind::bad_input, "", Words(lang::command_line::this_is_a_fault_of_ours, std::string(what))}};
}

}  // namespace

WatchedFile::WatchedFile(std::string path, Making making)
    : path_(std::move(path)), making_(std::move(making)), worker_([this] { work(); }) {}
WatchedFile::~WatchedFile() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    wakes_.notify_one();
    worker_.join();
}

WatchedFile::Stamp WatchedFile::stamp_of(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return {};
    return {static_cast<long long>(status.st_ino), status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

std::optional<Watched> WatchedFile::look() {
    const Stamp now = stamp_of(path_);
    const bool rests = !seen_ || *seen_ == now;  // the first time the file is read at once
    if (rests && read_ != now) {
        read_ = now;
        hand_over();
    }
    seen_ = now;
    const std::lock_guard lock(mutex_);
    return std::exchange(changed_, false) ? std::optional(watched_) : std::nullopt;
}

bool WatchedFile::is_busy() {
    const std::lock_guard lock(mutex_);
    return working_ || waiting_.has_value();
}

void WatchedFile::hand_over() {
    struct stat status {};
    // Reading a pipe would block.
    const bool can_be_read = ::stat(path_.c_str(), &status) != 0 || S_ISREG(status.st_mode) || S_ISDIR(status.st_mode);
    auto text = can_be_read ? read_whole(path_, {lang::common::mechanism_file})
                            : tl::unexpected(Words(lang::command_line::is_no_plain_file_which_could));
    const std::lock_guard lock(mutex_);
    if (!text) {
        // The earlier content no longer counts: if the same content returns, it is solved again.
        solved_.reset();
        waiting_.reset();
        watched_.faults = {{std::nullopt, Diagnostic{Diagnostic::Kind::bad_input, "", text.error()}}};
        changed_ = true;
        return;
    }
    if (solved_ == *text) return;
    solved_ = *text;
    waiting_ = *std::move(text);
    wakes_.notify_one();
}

void WatchedFile::work() {
    while (true) {
        std::string text;
        int number = 0;
        {
            std::unique_lock lock(mutex_);
            wakes_.wait(lock, [this] { return ends_ || waiting_; });
            if (ends_) return;
            text = *std::exchange(waiting_, std::nullopt);
            number = watched_.pages + 1;
            working_ = true;
        }
        Expected<std::string> made;
        try {
            made = making_(text, number);
        } catch (const std::exception& fault) {
            made = tl::unexpected(ours(fault.what()));
        } catch (...) {
            made = tl::unexpected(ours("unknown"));
        }
        finish(std::move(made), text);
    }
}

void WatchedFile::finish(Expected<std::string> made, const std::string& text) {
    const std::lock_guard lock(mutex_);
    working_ = false;
    if (waiting_ || !solved_) return;  // the file was saved again or removed: this result is obsolete
    watched_.faults.clear();
    if (made) {
        watched_.page = std::make_shared<const std::string>(*std::move(made));
        ++watched_.pages;
    } else {
        for (Diagnostic& fault : made.error()) {
            auto place = place_in_file(text, fault.place);
            watched_.faults.push_back({place, std::move(fault)});
        }
    }
    changed_ = true;
}

}  // namespace kinegraph::app
