// Strict parser for the head of an HTTP request: accepts what browsers send; for anything else it returns the error
// status. Knows no sockets.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

namespace kinegraph::app {

/// The size limit of a head, bytes.
constexpr std::size_t longest_head = 8192;

struct HttpHead {
    std::string method, target, host;
    std::optional<std::string> origin;
    std::optional<std::uint64_t> length;  ///< bytes of the body; none: not stated
    bool in_pieces = false;               ///< has a Transfer-Encoding, which is not supported
};

/// The length of the head in `received`, with its empty line; empty if the head is incomplete.
std::optional<std::size_t> end_of_head(std::string_view received);

/// `head` includes its empty line. Error: the status to answer with, 400 or 505.
tl::expected<HttpHead, int> read_http_head(std::string_view head);

/// True if the request is for this server, by its Host, and not from a page of another site, by its Origin if it has
/// one. So no other site can read what is served, not even by a domain name that resolves to this machine.
bool is_from_here(const HttpHead& head, int port);

}  // namespace kinegraph::app
