// A server for one reader on this machine: plain HTTP on 127.0.0.1, one request for each connection, one thread, no
// blocking calls. A callback gives the answers, which another thread may finish.
//
// Why not cpp-httplib: its time-outs apply to one read, not to a request, and each open request occupies a thread.
// Measured with version 0.11.4, a read time-out of 2 s and one request for each connection:
//   - with its pool of 8 threads: 256 incomplete requests delayed all others by 47 s; eight heads sent at a byte a
//     second shut everyone else out for the whole 40 s of the trial;
//   - with a thread for each connection: under 1,100 such heads and a limit of 1,024 descriptors, there was no answer
//     after some 8 s;
//   - a head without end is stored whole: 200 MB sent took 427 MB of memory.
// This server gives a request 2 s and 8 kB for its head, and closes the oldest of more than 256 connections
// (tests/live/watch_test.mjs tests this). Its limit: under 1,100 slow heads that reopen at once it cuts some honest
// requests too (3 of 5 in a trial); its memory stays flat.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "app/server/answer_queue.hpp"
#include "app/server/http_head.hpp"

namespace kinegraph::app {

struct HttpAnswer {
    int status = 200;
    std::string type = "text/plain; charset=utf-8";
    std::shared_ptr<const std::string> body;   ///< shared: a page is large, and many answers may be in progress
    std::string more = {};                     ///< additional header lines, each with its line end
    std::shared_ptr<PreparedBody> later = {};  ///< not null: the body comes from there, when it is made
};
/// Called for well-formed requests of this machine only. `body` is empty unless it was accepted.
using Answering = std::function<HttpAnswer(const HttpHead&, const std::string& body)>;
/// The largest body that is accepted with such a request, bytes. Of 0 the body is not read, and the answer is given by
/// the head alone.
using Accepting = std::function<std::size_t(const HttpHead&)>;

class LocalServer {
public:
    /// Listens on 127.0.0.1; port 0: any free port. Error: the system's message.
    static tl::expected<LocalServer, std::string> open(int port, Accepting accepts = {});
    LocalServer(LocalServer&& other) noexcept;
    LocalServer& operator=(LocalServer&&) = delete;
    ~LocalServer();

    int port() const { return port_; }
    /// Serves for `milliseconds`; returns early if `signals` (a descriptor) becomes readable.
    void serve(int milliseconds, int signals, const Answering& answer);
    /// Makes serve() look for answers that have been finished. May be called by any thread.
    void wake() const;

private:
    struct Connection;

    LocalServer();
    void take_in();
    void close(std::list<Connection>::iterator connection);
    bool advance(Connection& connection, const Answering& answer) const;
    bool read_from(Connection& connection, const Answering& answer) const;
    bool read_head(Connection& connection, std::size_t size, const Answering& answer) const;
    static bool read_body(Connection& connection, const Answering& answer);
    static bool write_to(Connection& connection);
    static bool wait_for_answer(Connection& connection);
    static bool drain(Connection& connection);

    Accepting accepts_;
    int listening_ = -1;
    int waking_ = -1;  ///< a descriptor that wake() makes readable
    int port_ = 0;
    std::list<Connection> connections_;  ///< oldest first
};

}  // namespace kinegraph::app
