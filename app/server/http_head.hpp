// The head of an HTTP request, read strictly: what a browser sends is taken, all else is refused with its status. Knows
// no socket.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace kinegraph::app {

/// The longest head that is read, bytes.
constexpr std::size_t longest_head = 8192;

struct HttpHead {
    std::string method, target, host;
    std::optional<std::string> origin;
};

/// Where the head in `received` ends, its empty line counted; nothing where it has not come to an end.
std::optional<std::size_t> end_of_head(std::string_view received);

/// `head` with its empty line. Error: the status to answer with, 400 or 505.
tl::expected<HttpHead, int> read_http_head(std::string_view head);

/// True where the request is meant for the server at `port` of this machine, and no page of another site sends it: by
/// its Host, and its Origin where it has one. So no foreign page reads what is served, and no name that was made to
/// lead here does.
bool is_from_here(const HttpHead& head, int port);

}  // namespace kinegraph::app
