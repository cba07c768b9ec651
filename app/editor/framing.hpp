// The frames of the Language Server Protocol: a head with the length of what follows, a message. Knows no message.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace kinegraph::app {

/// The largest message that is read, bytes. A mechanism file has some thousand.
constexpr std::size_t largest_message = std::size_t{8} << 20;

/// Cuts a stream of bytes into messages.
class Framing {
public:
    enum class Event {
        message,
        refused,  ///< a message was too large; it is left out
        lost      ///< a head without a length: where the next message begins is not known
    };
    void add(std::string_view bytes) { waiting_ += bytes; }
    /// The next message or fault; empty: more bytes are needed. After `lost` there is nothing more.
    std::optional<Event> next(std::string& message);

private:
    std::optional<Event> read_head();
    std::string waiting_;
    std::size_t at_ = 0;                 ///< where the next head or message begins
    std::optional<std::size_t> length_;  ///< of the message whose head was read
    std::size_t left_out_ = 0;           ///< bytes still to come of a message that is refused
    bool is_lost_ = false;
};

/// A message with its head.
std::string framed(std::string_view message);

}  // namespace kinegraph::app
