#include "engine/reading/file_text.hpp"

#include <algorithm>
#include <array>

#include "engine/file/units.hpp"

namespace kinegraph {
namespace {

std::string in_quotes(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string quoted = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            quoted += '\\';
            quoted += c;
        } else if (code < 0x20) {
            quoted += "\\u00";
            quoted += digits[code >> 4U];
            quoted += digits[code & 15U];
        } else {
            quoted += c;
        }
    }
    return quoted + '"';
}

class Writer {
public:
    Writer(std::span<const Setting> set, std::span<const std::string_view> without) : set_(set), without_(without) {}

    std::string whole(JsonValue root) const {
        std::string text = "{";
        const char* between = "\n  ";
        for (const JsonValue member : root) {
            if (std::find(without_.begin(), without_.end(), member.key()) != without_.end()) continue;
            const std::string head = between + in_quotes(member.key()) + ": ";
            text += head + (member.key() == "parameters" ? parameters(member) : value(member, 2, head.size() - 2));
            between = ",\n  ";
        }
        return text + "\n}\n";
    }

private:
    static constexpr std::size_t line_width = 120;

    std::string parameters(JsonValue all) const {
        std::string text = "{";
        const char* between = "";
        for (const JsonValue member : all) {
            text += between + in_quotes(member.key()) + ": ";
            const auto set =
                std::find_if(set_.begin(), set_.end(), [&](const Setting& s) { return s.name == member.key(); });
            const bool is_number = set != set_.end() && read_decimal(set->value).has_value();
            text += set == set_.end() ? on_one_line(member) : is_number ? set->value : in_quotes(set->value);
            between = ", ";
        }
        return text + "}";
    }

    std::string value(JsonValue of, std::size_t indent, std::size_t before) const {
        std::string line = on_one_line(of);
        const bool is_structured = of.is_object() || of.is_array();
        if (!is_structured || of.size() == 0 || indent + before + line.size() <= line_width) return line;
        const std::string begin = '\n' + std::string(indent + 2, ' ');
        std::string text(1, of.is_object() ? '{' : '[');
        bool first = true;
        for (const JsonValue each : of) {
            const std::string head = of.is_object() ? in_quotes(each.key()) + ": " : "";
            text += (first ? begin : "," + begin) + head + value(each, indent + 2, head.size());
            first = false;
        }
        return text + '\n' + std::string(indent, ' ') + (of.is_object() ? '}' : ']');
    }

    std::string on_one_line(JsonValue of) const {
        if (of.is_string()) return in_quotes(of.text());
        if (!of.is_object() && !of.is_array()) return std::string(of.text());
        std::string text(1, of.is_object() ? '{' : '[');
        const char* between = "";
        for (const JsonValue each : of) {
            text += between + (of.is_object() ? in_quotes(each.key()) + ": " : std::string()) + on_one_line(each);
            between = ", ";
        }
        return text + (of.is_object() ? '}' : ']');
    }

    std::span<const Setting> set_;
    std::span<const std::string_view> without_;
};

}  // namespace

std::string file_with(const JsonSource& file, std::span<const Setting> set, std::span<const std::string_view> without) {
    return Writer(set, without).whole(file.root());
}

}  // namespace kinegraph
