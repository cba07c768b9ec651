#include "app/editor/framing.hpp"

#include <algorithm>
#include <charconv>

namespace kinegraph::app {
namespace {

/// The longest head that is read, bytes. Editors write less than a hundred.
constexpr std::size_t longest_head = 4096;
constexpr std::string_view line_end = "\r\n", head_end = "\r\n\r\n", name_of_length = "content-length:";

/// The length that a head gives; empty where it gives none, or two.
std::optional<std::size_t> length_in(std::string_view head) {
    std::optional<std::size_t> length;
    while (!head.empty()) {
        const std::size_t end = std::min(head.find(line_end), head.size());
        std::string_view line = head.substr(0, end);
        head.remove_prefix(std::min(end + line_end.size(), head.size()));
        const bool is_length =
            line.size() >= name_of_length.size() &&
            std::equal(name_of_length.begin(), name_of_length.end(), line.begin(), [](char wanted, char written) {
                return wanted == (written >= 'A' && written <= 'Z' ? static_cast<char>(written - 'A' + 'a') : written);
            });
        if (!is_length) continue;
        line.remove_prefix(name_of_length.size());
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        std::size_t value = 0;
        const auto [stop, fault] = std::from_chars(line.data(), line.data() + line.size(), value);
        const std::string_view rest(stop, static_cast<std::size_t>(line.data() + line.size() - stop));
        if (fault != std::errc() || rest.find_first_not_of(" \t") != std::string_view::npos || length)
            return std::nullopt;
        length = value;
    }
    return length;
}

}  // namespace

std::optional<Framing::Event> Framing::read_head() {
    const std::size_t end = waiting_.find(head_end, at_);
    const bool is_whole = end != std::string::npos;
    if (!is_whole && waiting_.size() - at_ <= longest_head) return std::nullopt;
    if (is_whole && end - at_ <= longest_head) length_ = length_in(std::string_view(waiting_).substr(at_, end - at_));
    if (!length_) {
        is_lost_ = true;
        return Event::lost;
    }
    at_ = end + head_end.size();
    return std::nullopt;
}

std::optional<Framing::Event> Framing::next(std::string& message) {
    // What is refused is dropped as it arrives: it needs no memory.
    const std::size_t dropped = std::min(left_out_, waiting_.size() - at_);
    left_out_ -= dropped;
    at_ += dropped;
    if (!is_lost_ && left_out_ == 0) {
        if (!length_)
            if (const auto fault = read_head()) return fault;
        if (length_ && *length_ > largest_message) {
            left_out_ = *length_;
            length_.reset();
            return Event::refused;
        }
        if (length_ && *length_ <= waiting_.size() - at_) {
            message.assign(waiting_, at_, *length_);
            at_ += *length_;
            length_.reset();
            return Event::message;
        }
    }
    waiting_.erase(0, at_);
    at_ = 0;
    return std::nullopt;
}

std::string framed(std::string_view message) {
    return "Content-Length: " + std::to_string(message.size()) + "\r\n\r\n" + std::string(message);
}

}  // namespace kinegraph::app
