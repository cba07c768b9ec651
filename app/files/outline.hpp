// The structure of a JSON text with the place of every key and value; also of a text that is being typed, in which
// brackets, quotes, commas and values are missing. Knows no mechanism.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace kinegraph::app {

/// The text must outlive it. Its values are nodes in the order of the text; node 0 is the text itself, whose children
/// are the outermost values.
class Outline {
public:
    enum class Kind : std::uint8_t {
        missing,  ///< of a member: a key whose value is not there
        object,
        array,
        string,
        word  ///< a number, true, or whatever stands there without quotes
    };
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    struct Node {
        Kind kind = Kind::missing;
        bool is_closed = true;   ///< its closing bracket or quote is there
        bool has_colon = false;  ///< behind its key
        std::size_t begin = 0, end = 0;
        std::size_t key_begin = 0, key_end = 0;  ///< with the quotes; equal where it has no key
        std::uint32_t parent = none, first_child = none, last_child = none, next = none;

        bool has_key() const { return key_end > key_begin; }
        bool is_container() const { return kind == Kind::object || kind == Kind::array; }
    };

    explicit Outline(std::string_view text);

    std::string_view text() const { return text_; }
    const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
    /// The outermost value; none where there is none.
    std::uint32_t root() const { return nodes_[0].first_child; }
    /// The first member of an object that has this key; none where it has none, or is no object.
    std::uint32_t member(std::uint32_t object, std::string_view key) const;
    std::string key_of(std::uint32_t node) const;
    /// What a string says, or a word as it is written.
    std::string text_of(std::uint32_t node) const;
    /// The value that a JSON pointer names or, where it leads to nothing, the nearest that encloses it.
    std::uint32_t at(std::string_view pointer) const;

private:
    class Scanner;
    std::string_view text_;
    std::vector<Node> nodes_;
};

}  // namespace kinegraph::app
