// RFC 9112, as far as GET needs it, and POST with a body of known length.
#include "app/server/http_head.hpp"

#include <algorithm>
#include <charconv>

namespace kinegraph::app {
namespace {

constexpr std::string_view line_end = "\r\n";
constexpr int bad_request = 400, version_not_supported = 505;

bool is_letter_of_token(char c) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    return letter || std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
}
bool is_token(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), is_letter_of_token);
}
bool is_visible(char c) { return c > 0x20 && c < 0x7f; }
bool is_of_value(char c) { return static_cast<unsigned char>(c) >= 0x20 ? c != 0x7f : c == '\t'; }

std::string in_small_letters(std::string_view text) {
    std::string small(text);
    for (char& c : small)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return small;
}
std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Parses "GET /path HTTP/1.1"; returns the error status if the line differs.
std::optional<int> read_first_line(std::string_view line, HttpHead& head) {
    const std::size_t first = line.find(' ');
    const std::size_t last = first == std::string_view::npos ? first : line.find(' ', first + 1);
    if (last == std::string_view::npos) return bad_request;
    const std::string_view method = line.substr(0, first), target = line.substr(first + 1, last - first - 1);
    const std::string_view version = line.substr(last + 1);
    if (!is_token(method) || target.empty() || !std::all_of(target.begin(), target.end(), is_visible))
        return bad_request;
    if (version != "HTTP/1.1" && version != "HTTP/1.0")
        return version.starts_with("HTTP/") ? version_not_supported : bad_request;
    head.method = method;
    head.target = target;
    return std::nullopt;
}

/// A number of at most 18 digits; none for anything else.
std::optional<std::uint64_t> read_length(std::string_view digits) {
    constexpr std::size_t most_digits = 18;
    std::uint64_t length = 0;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), length);
    if (digits.empty() || digits.size() > most_digits || fault != std::errc() || end != digits.data() + digits.size())
        return std::nullopt;
    return length;
}

}  // namespace

std::optional<std::size_t> end_of_head(std::string_view received) {
    const std::size_t end = received.find("\r\n\r\n");
    return end == std::string_view::npos ? std::nullopt : std::optional(end + 4);
}

tl::expected<HttpHead, int> read_http_head(std::string_view head) {
    HttpHead read;
    int hosts = 0, origins = 0;
    bool is_first = true;
    while (true) {
        const std::size_t end = head.find(line_end);
        if (end == std::string_view::npos) return tl::unexpected(bad_request);
        const std::string_view line = head.substr(0, end);
        head.remove_prefix(end + line_end.size());
        if (is_first) {
            if (const auto status = read_first_line(line, read)) return tl::unexpected(*status);
            is_first = false;
            continue;
        }
        if (line.empty()) break;
        const std::size_t colon = line.find(':');
        if (colon == std::string_view::npos || !is_token(line.substr(0, colon))) return tl::unexpected(bad_request);
        const std::string_view value = trimmed(line.substr(colon + 1));
        if (!std::all_of(value.begin(), value.end(), is_of_value)) return tl::unexpected(bad_request);
        const std::string name = in_small_letters(line.substr(0, colon));
        if (name == "host") {
            read.host = in_small_letters(value);
            ++hosts;
        } else if (name == "origin") {
            read.origin = in_small_letters(value);
            ++origins;
        } else if (name == "content-length") {
            const auto length = read_length(value);
            if (!length || read.length) return tl::unexpected(bad_request);
            read.length = length;
        } else if (name == "transfer-encoding") {
            read.in_pieces = true;
        }
    }
    if (hosts != 1 || origins > 1) return tl::unexpected(bad_request);
    return read;
}

bool is_from_here(const HttpHead& head, int port) {
    constexpr int port_of_http = 80;  // browsers omit it
    for (const std::string name : {"127.0.0.1", "localhost"}) {
        const std::string with_port = name + ":" + std::to_string(port);
        const bool is_named = head.host == with_port || (port == port_of_http && head.host == name);
        if (is_named) return !head.origin || *head.origin == "http://" + head.host;
    }
    return false;
}

}  // namespace kinegraph::app
