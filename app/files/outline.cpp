// One pass from left to right. What does not fit is taken as what it most probably is meant to be.
#include "app/files/outline.hpp"

#include <algorithm>
#include <charconv>

#include <nlohmann/json.hpp>

namespace kinegraph::app {
namespace {

constexpr std::string_view blanks = " \t\r\n";

/// A segment of a JSON pointer.
std::string unescaped(std::string_view segment) {
    std::string key;
    for (std::size_t i = 0; i < segment.size(); ++i) {
        const bool is_escape =
            segment[i] == '~' && i + 1 < segment.size() && (segment[i + 1] == '0' || segment[i + 1] == '1');
        key += !is_escape ? segment[i] : segment[i + 1] == '0' ? '~' : '/';
        if (is_escape) ++i;
    }
    return key;
}

/// What stands between the quotes of a JSON string; as it is written where that is no JSON.
std::string unquoted(std::string_view written) {
    if (!written.starts_with('"')) return std::string(written);
    const bool is_closed = written.size() > 1 && written.ends_with('"');
    const std::string_view inner = written.substr(1, written.size() - (is_closed ? 2 : 1));
    if (inner.find('\\') == std::string_view::npos) return std::string(inner);
    const auto read = nlohmann::json::parse('"' + std::string(inner) + '"', nullptr, false);
    return read.is_string() ? read.get<std::string>() : std::string(inner);
}

}  // namespace

class Outline::Scanner {
public:
    Scanner(std::string_view text, std::vector<Node>& nodes) : text_(text), nodes_(nodes) {
        nodes_.push_back({.kind = Kind::array, .is_closed = false, .end = text.size()});
        open_.push_back(0);
    }

    void scan() {
        while ((at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size())) < text_.size()) {
            switch (text_[at_]) {
                case '{':
                case '[': open(); break;
                case '}':
                case ']': close(); break;
                case ',':
                    member_ = none;
                    ++at_;
                    break;
                case ':':
                    if (member_ != none) nodes_[member_].has_colon = true;
                    ++at_;
                    break;
                case '"': string(); break;
                default: word();
            }
        }
        while (open_.size() > 1) leave(text_.size());
    }

private:
    Kind container() const { return nodes_[open_.back()].kind; }

    std::uint32_t add(Node node) {
        const auto number = static_cast<std::uint32_t>(nodes_.size());
        node.parent = open_.back();
        nodes_.push_back(node);
        Node& parent = nodes_[node.parent];
        (parent.first_child == none ? parent.first_child : nodes_[parent.last_child].next) = number;
        parent.last_child = number;
        return number;
    }
    /// A value from here to `end`: that of the member whose colon has been read, or a further one.
    std::uint32_t value(Kind kind, std::size_t end, bool is_closed) {
        if (container() != Kind::object || member_ == none || !nodes_[member_].has_colon)
            return add({.kind = kind, .is_closed = is_closed, .begin = at_, .end = end});
        Node& node = nodes_[member_];
        node.kind = kind;
        node.is_closed = is_closed;
        node.begin = at_;
        node.end = end;
        return std::exchange(member_, none);
    }

    void open() {
        const std::uint32_t node = value(text_[at_] == '{' ? Kind::object : Kind::array, text_.size(), false);
        open_.push_back(node);
        member_ = none;
        ++at_;
    }
    void leave(std::size_t end) {
        nodes_[open_.back()].end = end;
        open_.pop_back();
        member_ = none;
    }
    /// Closes the nearest container that this bracket can close; those within it have lost theirs.
    void close() {
        const Kind kind = text_[at_] == '}' ? Kind::object : Kind::array;
        std::size_t depth = open_.size();
        while (depth > 1 && nodes_[open_[depth - 1]].kind != kind) --depth;
        if (depth > 1) {
            while (open_.size() > depth) leave(at_);
            nodes_[open_.back()].is_closed = true;
            leave(at_ + 1);
        }
        ++at_;
    }
    /// A string ends on its line: where its quote is missing, the rest of the text is no part of it.
    void string() {
        std::size_t end = at_ + 1;
        while (end < text_.size() && text_[end] != '"' && text_[end] != '\n' && text_[end] != '\r')
            end += text_[end] == '\\' && end + 1 < text_.size() && text_[end + 1] != '\n' ? 2 : 1;
        const bool is_closed = end < text_.size() && text_[end] == '"';
        if (is_closed) ++end;
        const bool is_key = container() == Kind::object && (member_ == none || !nodes_[member_].has_colon);
        if (is_key)
            member_ = add({.is_closed = is_closed, .begin = end, .end = end, .key_begin = at_, .key_end = end});
        else
            value(Kind::string, end, is_closed);
        at_ = end;
    }
    void word() {
        const std::size_t end = std::min(text_.find_first_of("{}[],:\" \t\r\n", at_), text_.size());
        value(Kind::word, end, true);
        at_ = end;
    }

    std::string_view text_;
    std::vector<Node>& nodes_;
    std::size_t at_ = 0;
    std::vector<std::uint32_t> open_;
    std::uint32_t member_ = none;  ///< the last key, until its value or a comma is read
};

Outline::Outline(std::string_view text) : text_(text) { Scanner(text, nodes_).scan(); }

std::uint32_t Outline::member(std::uint32_t object, std::string_view key) const {
    if (object == none || nodes_[object].kind != Kind::object) return none;
    for (std::uint32_t each = nodes_[object].first_child; each != none; each = nodes_[each].next)
        if (nodes_[each].has_key() && key_of(each) == key) return each;
    return none;
}

std::string Outline::key_of(std::uint32_t node) const {
    const Node& member = nodes_[node];
    return unquoted(text_.substr(member.key_begin, member.key_end - member.key_begin));
}

std::string Outline::text_of(std::uint32_t node) const {
    return unquoted(text_.substr(nodes_[node].begin, nodes_[node].end - nodes_[node].begin));
}

std::uint32_t Outline::at(std::string_view pointer) const {
    std::uint32_t node = root();
    while (node != none && pointer.starts_with('/')) {
        pointer.remove_prefix(1);
        const std::size_t end = std::min(pointer.find('/'), pointer.size());
        const std::string segment = unescaped(pointer.substr(0, end));
        pointer.remove_prefix(end);
        std::uint32_t child = member(node, segment);
        std::size_t index = 0;
        const auto [stop, fault] = std::from_chars(segment.data(), segment.data() + segment.size(), index);
        if (nodes_[node].kind == Kind::array && fault == std::errc() && stop == segment.data() + segment.size())
            for (child = nodes_[node].first_child; child != none && index > 0; --index) child = nodes_[child].next;
        if (child == none) return node;
        node = child;
    }
    return node;
}

}  // namespace kinegraph::app
