// Sockets and poll. A connection reads a head, perhaps a body, waits for its answer, writes it, and drains further
// input; each of these states has a time limit, except waiting for an answer. If there are too many connections, the
// oldest is closed.
#include "app/server/local_server.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
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
constexpr std::chrono::milliseconds time_to_read = 2s, time_to_read_body = 10s, time_to_write = 10s,
                                    time_to_drain = 500ms, time_to_answer = 24h;
constexpr int request_too_slow = 408, length_required = 411, body_too_large = 413, head_too_large = 431,
              forbidden = 403;

const char* phrase_of(int status) {
    switch (status) {
        case 200: return "OK";
        case 400: return "Bad Request";
        case forbidden: return "Forbidden";
        case 404: return "Not Found";
        case 405: return "Method Not Allowed";
        case request_too_slow: return "Request Timeout";
        case 409: return "Conflict";
        case length_required: return "Length Required";
        case body_too_large: return "Content Too Large";
        case head_too_large: return "Request Header Fields Too Large";
        case 500: return "Internal Server Error";
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
    enum class State { reading, reading_body, waiting, writing, draining };

    int socket = -1;
    Clock::time_point until;
    State state = State::reading;
    std::string received;  ///< the head while it is read, then the body
    HttpHead request = {};
    HttpAnswer pending = {};  ///< while its body is made
    std::string head = {};
    std::shared_ptr<const std::string> body = {};
    std::size_t sent = 0;

    bool is_read() const { return state == State::reading || state == State::reading_body; }
    void go_to(State next, std::chrono::milliseconds time) {
        state = next;
        until = Clock::now() + time;
    }
    void answer(HttpAnswer answer, bool with_body = true) {
        if (answer.later) {
            pending = std::move(answer);
            return go_to(State::waiting, time_to_answer);
        }
        if (!answer.body) answer.body = plain(answer.status).body;
        head = head_of(answer);
        if (with_body) body = std::move(answer.body);
        go_to(State::writing, time_to_write);
    }
};

LocalServer::LocalServer() = default;
LocalServer::LocalServer(LocalServer&& other) noexcept
    : accepts_(std::move(other.accepts_)),
      listening_(std::exchange(other.listening_, -1)),
      waking_(std::exchange(other.waking_, -1)),
      port_(other.port_),
      connections_(std::move(other.connections_)) {}
LocalServer::~LocalServer() {
    for (const Connection& connection : connections_) ::close(connection.socket);
    if (listening_ >= 0) ::close(listening_);
    if (waking_ >= 0) ::close(waking_);
}

tl::expected<LocalServer, std::string> LocalServer::open(int port, Accepting accepts) {
    LocalServer server;
    server.accepts_ = std::move(accepts);
    const auto refused = [] { return tl::unexpected(std::string(std::strerror(errno))); };
    server.waking_ = ::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
    if (server.waking_ < 0) return refused();
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

/// Answers by the head, unless a body is to be read first.
bool LocalServer::read_head(Connection& connection, std::size_t size, const Answering& answer) const {
    auto read = read_http_head(std::string_view(connection.received).substr(0, size));
    const auto refuse = [&](int status) {
        connection.answer(plain(status));
        return write_to(connection);
    };
    if (!read) return refuse(read.error());
    if (!is_from_here(*read, port_)) return refuse(forbidden);
    connection.request = *std::move(read);
    const std::size_t most = accepts_ ? accepts_(connection.request) : 0;
    if (most == 0) {
        connection.answer(answer(connection.request, {}), connection.request.method != "HEAD");
        return connection.state == Connection::State::waiting || write_to(connection);
    }
    if (!connection.request.length || connection.request.in_pieces) return refuse(length_required);
    if (*connection.request.length > most) return refuse(body_too_large);
    connection.received.erase(0, size);
    connection.go_to(Connection::State::reading_body, time_to_read_body);
    return read_body(connection, answer);
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
        if (end && *end <= longest_head) return read_head(connection, *end, answer);
    }
    connection.answer(plain(head_too_large));
    return write_to(connection);
}

bool LocalServer::read_body(Connection& connection, const Answering& answer) {
    std::array<char, 65536> piece{};
    const auto size = static_cast<std::size_t>(*connection.request.length);
    while (connection.received.size() < size) {
        const std::size_t wanted = std::min(piece.size(), size - connection.received.size());
        const ssize_t got = ::recv(connection.socket, piece.data(), wanted, 0);
        if (got == 0) return false;
        if (got < 0) return would_block();
        connection.received.append(piece.data(), static_cast<std::size_t>(got));
    }
    connection.received.resize(size);
    connection.answer(answer(connection.request, std::exchange(connection.received, {})));
    return connection.state == Connection::State::waiting || write_to(connection);
}

/// False if nobody waits for the answer any more.
bool LocalServer::wait_for_answer(Connection& connection) {
    auto body = connection.pending.later->get();
    if (body) {
        HttpAnswer made = std::move(connection.pending);
        made.later.reset();
        made.body = std::move(body);
        connection.answer(std::move(made));
        return write_to(connection);
    }
    char more = 0;
    const ssize_t got = ::recv(connection.socket, &more, 1, 0);
    return got > 0 || (got < 0 && would_block());
}

void LocalServer::wake() const {
    constexpr std::uint64_t once = 1;
    // Fails only where it is readable already.
    [[maybe_unused]] const ssize_t wrote = ::write(waking_, &once, sizeof once);
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
        case Connection::State::reading_body: return read_body(connection, answer);
        case Connection::State::waiting: return wait_for_answer(connection);
        case Connection::State::writing: return write_to(connection);
        case Connection::State::draining: return drain(connection);
    }
    return false;
}

void LocalServer::serve(int milliseconds, int signals, const Answering& answer) {
    const auto end = Clock::now() + std::chrono::milliseconds(milliseconds);
    for (auto now = Clock::now(); now < end; now = Clock::now()) {
        std::vector<pollfd> watched{{signals, POLLIN, 0}, {listening_, POLLIN, 0}, {waking_, POLLIN, 0}};
        const std::size_t own = watched.size();
        for (const Connection& each : connections_) {
            const bool writes = each.state == Connection::State::writing;
            watched.push_back({each.socket, static_cast<short>(writes ? POLLOUT : POLLIN), 0});
        }
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - now).count() + 1;
        if (::poll(watched.data(), watched.size(), static_cast<int>(left)) < 0 && errno != EINTR) return;
        if (watched[0].revents != 0) return;
        now = Clock::now();
        std::uint64_t wakings = 0;
        const bool is_woken = ::read(waking_, &wakings, sizeof wakings) > 0;
        std::size_t i = own;
        for (auto connection = connections_.begin(); connection != connections_.end(); ++i) {
            const auto next = std::next(connection);
            const bool turn = watched[i].revents != 0 || (is_woken && connection->state == Connection::State::waiting);
            bool goes_on = !turn || advance(*connection, answer);
            if (goes_on && connection->until <= now) {
                // A client whose request is too slow gets an answer; a client that reads too slowly does not.
                const bool asks = connection->is_read();
                if (asks) connection->answer(plain(request_too_slow));
                goes_on = asks && write_to(*connection);
            }
            if (!goes_on) close(connection);
            connection = next;
        }
        if (watched[1].revents != 0) take_in();
    }
}

}  // namespace kinegraph::app
