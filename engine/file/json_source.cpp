#include "engine/file/json_source.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "engine/file/units.hpp"
#include "engine/number/assert.hpp"
#include "lang/keys/files.hpp"
#include "lang/keys/json_parser.hpp"

namespace kinegraph {
namespace {

constexpr std::size_t deepest_nesting = 64;
constexpr std::size_t longest_file = std::size_t{1} << 30U;
constexpr std::size_t longest_segment = 200;

/// "line 3, column 5" of the byte at `offset`; columns count characters.
Words line_and_column(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, offset);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t newline = before.rfind('\n');
    const std::string_view in_line = newline == std::string_view::npos ? before : before.substr(newline + 1);
    const auto column = 1 + std::count_if(in_line.begin(), in_line.end(),
                                          [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
    return {lang::files::line_column, std::to_string(line), std::to_string(column)};
}

/// The parser's message without its number, place and the text it last read.
Words reason(std::string_view what) {
    const auto cut_before = [&](std::string_view mark) {
        if (const std::size_t at = what.find(mark); at != std::string_view::npos) what.remove_prefix(at + mark.size());
    };
    cut_before(" - ");
    what = what.substr(0, what.find("; last read"));
    const std::string english = shown(what, longest_segment);
    return library_message(english, lang::json_parser_section);
}

/// Literals beyond the range of doubles. The parser rejects them, but the reader must report a better fault. They are
/// stored by their index among all numbers; the text passed to the parser contains harmless ones of the same length.
struct Overflows {
    std::string text;
    std::vector<std::pair<std::size_t, std::string>> literals;
};
Overflows without_overflows(std::string_view text) {
    Overflows found;
    found.text = text;
    const auto is_digit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
    bool in_string = false;
    std::size_t number = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] == '"') in_string = !in_string;
        if (in_string) {
            if (text[at] == '\\') ++at;
            continue;
        }
        if (!is_digit(at)) continue;
        const std::size_t first = at;
        std::size_t point = std::string_view::npos;
        std::size_t exponent = std::string_view::npos;
        for (; at < text.size(); ++at) {
            if (text[at] == '.') {
                point = std::min(point, at);
            } else if (text[at] == 'e' || text[at] == 'E') {
                exponent = at;
            } else if (!is_digit(at) && text[at] != '+' && text[at] != '-') {
                break;
            }
        }
        constexpr std::size_t safe_length = 300;
        if (exponent != std::string_view::npos || at - first > safe_length) {
            const std::size_t sign = first > 0 && text[first - 1] == '-' ? 1 : 0;
            found.literals.emplace_back(number, text.substr(first - sign, at - first + sign));
            if (exponent != std::string_view::npos)
                std::replace_if(
                    found.text.begin() + static_cast<std::ptrdiff_t>(exponent),
                    found.text.begin() + static_cast<std::ptrdiff_t>(at), [](char c) { return c >= '1' && c <= '9'; },
                    '0');
            const std::size_t integer_end = std::min({point, exponent, at});
            if (integer_end - first > safe_length) {
                if (point != std::string_view::npos) found.text[point] = '0';
                found.text[first + 1] = '.';
            }
        }
        ++number;
        --at;
    }
    return found;
}

}  // namespace

/// The callbacks of nlohmann's parser, one per token.
class JsonTreeBuilder {
public:
    using Json = nlohmann::json;
    explicit JsonTreeBuilder(std::string_view text) : text_(text) {}
    void use(std::vector<std::pair<std::size_t, std::string>> literals) { literals_ = std::move(literals); }

    bool null() { return leaf(JsonValue::Kind::null, "null"); }
    bool boolean(bool value) { return leaf(JsonValue::Kind::boolean, value ? "true" : "false"); }
    bool number_integer(Json::number_integer_t value) { return whole_number(value); }
    bool number_unsigned(Json::number_unsigned_t value) { return whole_number(value); }
    bool number_float(Json::number_float_t /*value*/, const std::string& literal) {
        std::string plain = literal;
        // The parser writes the decimal point of the process's locale.
        std::replace_if(
            plain.begin(), plain.end(),
            [](char c) { return std::string_view("0123456789+-eE").find(c) == std::string_view::npos; }, '.');
        return number(plain);
    }
    bool string(const std::string& value) { return leaf(JsonValue::Kind::string, value); }
    bool binary(const Json::binary_t& /*value*/) { return false; }
    bool start_object(std::size_t /*size*/) { return open(JsonValue::Kind::object); }
    bool start_array(std::size_t /*size*/) { return open(JsonValue::Kind::array); }
    bool end_object() {
        find_duplicates(open_.back().node);
        return close();
    }
    bool end_array() { return close(); }
    bool key(const std::string& name) {
        key_at_ = at_end();
        key_size_ = static_cast<std::uint32_t>(name.size());
        source_.characters_ += name;
        return true;
    }
    bool parse_error(std::size_t position, const std::string& /*last*/, const nlohmann::detail::exception& error) {
        constexpr int number_overflow = 406;
        overflow_ = error.id == number_overflow;
        const bool blank = text_.find_first_not_of(" \t\r\n") == std::string_view::npos;
        const std::size_t offset = std::min(position == 0 ? 0 : position - 1, text_.size());
        const Words empty(lang::files::the_file_is_empty_a_mechanism);
        fault_ = Error{
            ErrorCode::bad_input, "",
            blank ? empty : Words(lang::files::this_is_not_json, line_and_column(text_, offset), reason(error.what()))};
        return false;
    }

    bool overflow() const { return overflow_; }
    Error fault() const { return fault_.value_or(Error{}); }
    JsonSource take() { return std::move(source_); }

private:
    struct Open {
        std::uint32_t node = 0;
        std::uint32_t last_child = JsonSource::none;
    };
    std::uint32_t at_end() const { return static_cast<std::uint32_t>(source_.characters_.size()); }

    template <class Integer>
    bool whole_number(Integer value) {
        std::array<char, std::numeric_limits<Integer>::digits10 + 3> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
        return number(std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data())));
    }
    bool number(std::string_view literal) {
        if (next_literal_ < literals_.size() && literals_[next_literal_].first == numbers_)
            literal = literals_[next_literal_++].second;
        ++numbers_;
        return leaf(JsonValue::Kind::number, literal);
    }
    bool leaf(JsonValue::Kind kind, std::string_view text) {
        JsonSource::Node& node = add(kind);
        node.text_at = at_end();
        node.text_size = static_cast<std::uint32_t>(text.size());
        source_.characters_ += text;
        return true;
    }
    JsonSource::Node& add(JsonValue::Kind kind) {
        const auto self = static_cast<std::uint32_t>(source_.nodes_.size());
        JsonSource::Node node;
        node.kind = kind;
        if (!open_.empty()) {
            JsonSource::Node& parent = source_.nodes_[open_.back().node];
            node.parent = open_.back().node;
            node.index = parent.size++;
            if (parent.kind == JsonValue::Kind::object) {
                node.key_at = key_at_;
                node.key_size = key_size_;
            }
            if (open_.back().last_child == JsonSource::none) {
                parent.first_child = self;
            } else {
                source_.nodes_[open_.back().last_child].next = self;
            }
            open_.back().last_child = self;
        }
        return source_.nodes_.emplace_back(node);
    }
    bool open(JsonValue::Kind kind) {
        const auto self = static_cast<std::uint32_t>(source_.nodes_.size());
        add(kind);
        open_.push_back({self, JsonSource::none});
        if (open_.size() <= deepest_nesting) return true;
        // Shows the place only up to this depth, to stay readable.
        constexpr std::size_t readable = 3;
        fault_ = Error{ErrorCode::bad_input, JsonValue(&source_, open_[readable].node).pointer(),
                       Words(lang::files::nested_deeper_than_levels_no_mechanism, std::to_string(deepest_nesting))};
        return false;
    }
    bool close() {
        open_.pop_back();
        return true;
    }
    void find_duplicates(std::uint32_t object) {
        std::vector<std::pair<std::string_view, std::uint32_t>> keys;
        keys.reserve(source_.nodes_[object].size);
        for (std::uint32_t at = source_.nodes_[object].first_child; at != JsonSource::none;
             at = source_.nodes_[at].next) {
            keys.emplace_back(source_.slice(source_.nodes_[at].key_at, source_.nodes_[at].key_size), at);
        }
        std::sort(keys.begin(), keys.end());
        for (std::size_t i = 1; i < keys.size(); ++i) {
            if (keys[i].first == keys[i - 1].first) source_.duplicates_.push_back(keys[i].second);
        }
    }

    std::string_view text_;
    JsonSource source_;
    std::vector<Open> open_;
    std::uint32_t key_at_ = 0, key_size_ = 0;
    std::size_t numbers_ = 0, next_literal_ = 0;
    std::vector<std::pair<std::size_t, std::string>> literals_;
    std::optional<Error> fault_;
    bool overflow_ = false;
};

Result<JsonSource> JsonSource::read(std::string_view text) {
    if (text.size() > longest_file) {
        return tl::make_unexpected(Errors{{ErrorCode::bad_input, "", {lang::files::the_file_is_larger_than_1}}});
    }
    // The parser treats a NUL between tokens as the end of the text; within a string it rejects it.
    const auto whole = [&](JsonTreeBuilder& builder) -> Result<JsonSource> {
        const std::size_t nul = text.find('\0');
        if (nul == std::string_view::npos) return builder.take();
        return tl::make_unexpected(
            Errors{{ErrorCode::bad_input, "", {lang::files::this_is_not_json_a_nul, line_and_column(text, nul)}}});
    };
    JsonTreeBuilder builder(text);
    if (nlohmann::json::sax_parse(text, &builder)) return whole(builder);
    if (!builder.overflow()) return tl::make_unexpected(Errors{builder.fault()});
    Overflows harmless = without_overflows(text);
    JsonTreeBuilder second(harmless.text);
    second.use(std::move(harmless.literals));
    if (nlohmann::json::sax_parse(harmless.text, &second)) return whole(second);
    return tl::make_unexpected(Errors{second.fault()});
}

std::vector<JsonValue> JsonSource::duplicates() const {
    std::vector<JsonValue> values;
    values.reserve(duplicates_.size());
    for (const std::uint32_t node : duplicates_) values.push_back({this, node});
    return values;
}

JsonValue::Kind JsonValue::kind() const { return source_->nodes_[node_].kind; }
std::string_view JsonValue::text() const {
    const JsonSource::Node& node = source_->nodes_[node_];
    return source_->slice(node.text_at, node.text_size);
}
std::string_view JsonValue::key() const {
    const JsonSource::Node& node = source_->nodes_[node_];
    return source_->slice(node.key_at, node.key_size);
}
std::size_t JsonValue::size() const { return source_->nodes_[node_].size; }

JsonValue JsonValue::operator[](std::string_view key) const {
    for (const JsonValue member : *this) {
        if (member.key() == key) return member;
    }
    return {};
}

std::string JsonValue::pointer() const {
    std::vector<std::string> segments;
    for (std::uint32_t at = node_; source_->nodes_[at].parent != JsonSource::none; at = source_->nodes_[at].parent) {
        const JsonSource::Node& node = source_->nodes_[at];
        if (source_->nodes_[node.parent].kind == Kind::array) {
            segments.push_back(std::to_string(node.index));
            continue;
        }
        std::string segment;
        for (const char c : shown(source_->slice(node.key_at, node.key_size), longest_segment)) {
            if (c == '~') {
                segment += "~0";
            } else if (c == '/') {
                segment += "~1";
            } else {
                segment += c;
            }
        }
        segments.push_back(std::move(segment));
    }
    std::reverse(segments.begin(), segments.end());
    std::string pointer;
    for (const std::string& segment : segments) pointer.append(1, '/').append(segment);
    return pointer;
}

JsonValue::Iterator JsonValue::begin() const { return Iterator({source_, source_->nodes_[node_].first_child}); }
JsonValue::Iterator JsonValue::end() const { return Iterator({source_, JsonSource::none}); }

JsonValue::Iterator& JsonValue::Iterator::operator++() {
    at_.node_ = at_.source_->nodes_[at_.node_].next;
    return *this;
}

}  // namespace kinegraph
