// Sockets and poll. A connection reads a head, writes an answer, and drains further input; each of the three states has
// a time limit. If there are too many connections, the oldest is closed.
#include "app/server/local_server.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>
#include <vector>

namespace kinegraph::app {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr std::size_t most_connections = 256;
constexpr std::chrono::milliseconds time_to_read = 2s, time_to_write = 10s, time_to_drain = 500ms;
constexpr int request_too_slow = 408, head_too_large = 431, forbidden = 403;

const char* phrase_of(int status) {
    switch (status) {
        case 200: return "OK";
        case 400: return "Bad Request";
        case forbidden: return "Forbidden";
        case 404: return "Not Found";
        case 405: return "Method Not Allowed";
        case request_too_slow: return "Request Timeout";
        case head_too_large: return "Request Header Fields Too Large";
        case 505: return "HTTP Version Not Supported";
        default: return "Error";
    }
}

/// The head of an answer. It forbids browsers to guess the type, to cache, and to show the page in a frame of another
/// site.
std::string head_of(const HttpAnswer& answer) {
    std::string head = "HTTP/1.1 " + std::to_string(answer.status) + " " + phrase_of(answer.status) + "\r\n";
    head += "Content-Type: " + answer.type + "\r\n";
    head += "Content-Length: " + std::to_string(answer.body ? answer.body->size() : 0) + "\r\n";
    head +=
        "Connection: close\r\nCache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nX-Frame-Options: DENY\r\n";
    head += "Referrer-Policy: no-referrer\r\nCross-Origin-Resource-Policy: same-origin\r\n";
    head += "Cross-Origin-Opener-Policy: same-origin\r\n";
    return head + answer.more + "\r\n";
}

HttpAnswer plain(int status) {
    HttpAnswer answer;
    answer.status = status;
    answer.body = std::make_shared<const std::string>(std::string(phrase_of(status)) + "\n");
    return answer;
}

bool would_block() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

}  // namespace

struct LocalServer::Connection {
    enum class State { reading, writing, draining };

    int socket = -1;
    Clock::time_point until;
    State state = State::reading;
    std::string received, head = {};
    std::shared_ptr<const std::string> body = {};
    std::size_t sent = 0;

    void answer(std::string answer_head, std::shared_ptr<const std::string> answer_body) {
        head = std::move(answer_head);
        body = std::move(answer_body);
        state = State::writing;
        until = Clock::now() + time_to_write;
    }
};

LocalServer::LocalServer() = default;
LocalServer::LocalServer(LocalServer&& other) noexcept
    : listening_(std::exchange(other.listening_, -1)),
      port_(other.port_),
      connections_(std::move(other.connections_)) {}
LocalServer::~LocalServer() {
    for (const Connection& connection : connections_) ::close(connection.socket);
    if (listening_ >= 0) ::close(listening_);
}

tl::expected<LocalServer, std::string> LocalServer::open(int port) {
    LocalServer server;
    const auto refused = [] { return tl::unexpected(std::string(std::strerror(errno))); };
    server.listening_ = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (server.listening_ < 0) return refused();
    const int yes = 1;
    ::setsockopt(server.listening_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    socklen_t size = sizeof address;
    // The socket interface takes every kind of address by a pointer to sockaddr.
    auto* const any = reinterpret_cast<sockaddr*>(&address);  // NOLINT(cppcoreguidelines-pro-type-reinterpret-cast)
    if (::bind(server.listening_, any, size) != 0 || ::listen(server.listening_, SOMAXCONN) != 0) return refused();
    if (::getsockname(server.listening_, any, &size) != 0) return refused();
    server.port_ = ntohs(address.sin_port);
    return server;
}

void LocalServer::take_in() {
    while (true) {
        const int socket = ::accept4(listening_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (socket < 0) {
            if (errno == ECONNABORTED || errno == EINTR) continue;
            // No descriptor left: close the oldest connection.
            if ((errno == EMFILE || errno == ENFILE) && !connections_.empty()) {
                close(connections_.begin());
                continue;
            }
            return;
        }
        if (connections_.size() >= most_connections) close(connections_.begin());
        Connection& connection = connections_.emplace_back();
        connection.socket = socket;
        connection.until = Clock::now() + time_to_read;
    }
}

void LocalServer::close(std::list<Connection>::iterator connection) {
    ::close(connection->socket);
    connections_.erase(connection);
}

std::string LocalServer::reply_to(std::string_view head, const Answering& answer,
                                  std::shared_ptr<const std::string>& body) const {
    const auto read = read_http_head(head);
    HttpAnswer reply = !read ? plain(read.error()) : !is_from_here(*read, port_) ? plain(forbidden) : answer(*read);
    if (!reply.body) reply.body = plain(reply.status).body;
    std::string text = head_of(reply);
    if (!read || read->method != "HEAD") body = std::move(reply.body);
    return text;
}

/// False if the connection has ended.
bool LocalServer::read_from(Connection& connection, const Answering& answer) const {
    std::array<char, 4096> piece{};
    while (connection.received.size() <= longest_head) {
        const ssize_t got = ::recv(connection.socket, piece.data(), piece.size(), 0);
        if (got == 0) return false;
        if (got < 0) return would_block();
        connection.received.append(piece.data(), static_cast<std::size_t>(got));
        const auto end = end_of_head(connection.received);
        if (!end || *end > longest_head) continue;
        std::shared_ptr<const std::string> body;
        std::string head = reply_to(std::string_view(connection.received).substr(0, *end), answer, body);
        connection.answer(std::move(head), std::move(body));
        return write_to(connection);
    }
    const HttpAnswer too_large = plain(head_too_large);
    connection.answer(head_of(too_large), too_large.body);
    return write_to(connection);
}

bool LocalServer::write_to(Connection& connection) {
    const std::size_t body_size = connection.body ? connection.body->size() : 0;
    while (connection.sent < connection.head.size() + body_size) {
        const bool in_head = connection.sent < connection.head.size();
        const std::string& text = in_head ? connection.head : *connection.body;
        const std::size_t from = in_head ? connection.sent : connection.sent - connection.head.size();
        const ssize_t wrote = ::send(connection.socket, text.data() + from, text.size() - from, MSG_NOSIGNAL);
        if (wrote < 0) return would_block();
        connection.sent += static_cast<std::size_t>(wrote);
    }
    ::shutdown(connection.socket, SHUT_WR);
    connection.state = Connection::State::draining;
    connection.until = Clock::now() + time_to_drain;
    return drain(connection);
}

/// Reads and discards input after the head: closing a socket with unread input can lose the answer.
bool LocalServer::drain(Connection& connection) {
    std::array<char, 4096> piece{};
    constexpr int most_at_a_time = 16;
    for (int i = 0; i < most_at_a_time; ++i) {
        const ssize_t got = ::recv(connection.socket, piece.data(), piece.size(), 0);
        if (got == 0) return false;
        if (got < 0) return would_block();
    }
    return true;
}

bool LocalServer::advance(Connection& connection, const Answering& answer) const {
    switch (connection.state) {
        case Connection::State::reading: return read_from(connection, answer);
        case Connection::State::writing: return write_to(connection);
        case Connection::State::draining: return drain(connection);
    }
    return false;
}

void LocalServer::serve(int milliseconds, int signals, const Answering& answer) {
    const auto end = Clock::now() + std::chrono::milliseconds(milliseconds);
    for (auto now = Clock::now(); now < end; now = Clock::now()) {
        std::vector<pollfd> watched{{signals, POLLIN, 0}, {listening_, POLLIN, 0}};
        for (const Connection& each : connections_) {
            const bool writes = each.state == Connection::State::writing;
            watched.push_back({each.socket, static_cast<short>(writes ? POLLOUT : POLLIN), 0});
        }
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - now).count() + 1;
        if (::poll(watched.data(), watched.size(), static_cast<int>(left)) < 0 && errno != EINTR) return;
        if (watched[0].revents != 0) return;
        now = Clock::now();
        std::size_t i = 2;
        for (auto connection = connections_.begin(); connection != connections_.end(); ++i) {
            const auto next = std::next(connection);
            bool goes_on = watched[i].revents == 0 || advance(*connection, answer);
            if (goes_on && connection->until <= now) {
                // A client whose request is too slow gets an answer; a client that reads too slowly does not.
                const bool asks = connection->state == Connection::State::reading;
                const HttpAnswer too_slow = plain(request_too_slow);
                if (asks) connection->answer(head_of(too_slow), too_slow.body);
                goes_on = asks && write_to(*connection);
            }
            if (!goes_on) close(connection);
            connection = next;
        }
        if (watched[1].revents != 0) take_in();
    }
}

}  // namespace kinegraph::app
