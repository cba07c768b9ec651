// A server for one reader on this machine: plain HTTP on 127.0.0.1, one request a connection, one thread, nothing that
// blocks. Knows what is asked only by the function that answers.
//
// Why not cpp-httplib: its time-outs hold for one read, not for a request, and each open request holds a thread. Tried
// with 0.11.4, time-outs of 2 s to read, one request a connection:
//   - its pool of 8 threads: 256 half requests keep everyone else waiting for 47 s, and eight heads that come a byte a
//     second, for ever;
//   - a thread for each connection: 1,100 such heads take all of 1,024 descriptors and keep them;
//   - a head without end is kept whole: 200 MB sent took 427 MB of memory.
// Here a request has 2 s and 8 kB for its head, and where there are 256 connections the oldest gives way.
// tests/live/watch_test.mjs holds the server to that.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <string>

#include <tl/expected.hpp>

#include "app/server/http_head.hpp"

namespace kinegraph::app {

struct HttpAnswer {
    int status = 200;
    std::string type = "text/plain; charset=utf-8";
    std::shared_ptr<const std::string> body;  ///< shared: a page is large, and many may be on their way
    std::string more = {};                    ///< header lines, each with its line end
};
/// Of a request that is well formed and comes from here.
using Answering = std::function<HttpAnswer(const HttpHead&)>;

class LocalServer {
public:
    /// Listens on 127.0.0.1; port 0: any that is free. Error: what the system says.
    static tl::expected<LocalServer, std::string> open(int port);
    LocalServer(LocalServer&& other) noexcept;
    LocalServer& operator=(LocalServer&&) = delete;
    ~LocalServer();

    int port() const { return port_; }
    /// Serves what comes within `milliseconds`; returns early where `signals` (a descriptor) can be read.
    void serve(int milliseconds, int signals, const Answering& answer);

private:
    struct Connection;

    LocalServer();
    void take_in();
    void close(std::list<Connection>::iterator connection);
    bool advance(Connection& connection, const Answering& answer) const;
    bool read_from(Connection& connection, const Answering& answer) const;
    static bool write_to(Connection& connection);
    static bool drain(Connection& connection);
    std::string reply_to(std::string_view head, const Answering& answer,
                         std::shared_ptr<const std::string>& body) const;

    int listening_ = -1;
    int port_ = 0;
    std::list<Connection> connections_;  ///< the oldest first
};

}  // namespace kinegraph::app
