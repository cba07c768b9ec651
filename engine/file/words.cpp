#include "engine/file/words.hpp"

namespace kinegraph {
namespace {

/// `pattern` with the arguments' texts, which `in` gives, in the places {0} to {9}.
template <class In>
std::string filled(std::string_view pattern, const Words* arguments, std::size_t count, In in) {
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const bool is_place = pattern[i] == '{' && i + 2 < pattern.size() && pattern[i + 2] == '}' &&
                              pattern[i + 1] >= '0' && static_cast<std::size_t>(pattern[i + 1] - '0') < count;
        if (!is_place) {
            text += pattern[i];
            continue;
        }
        text += in(arguments[pattern[i + 1] - '0']);
        i += 2;
    }
    return text;
}

}  // namespace

Words::Words() = default;
Words::Words(const Words&) = default;
Words::Words(Words&&) noexcept = default;
Words& Words::operator=(const Words&) = default;
Words& Words::operator=(Words&&) noexcept = default;
Words::~Words() = default;

Words::Words(std::string every) : en(every), it(std::move(every)) {}
Words::Words(std::string_view every) : Words(std::string(every)) {}
Words::Words(std::string english, std::string italian) : en(std::move(english)), it(std::move(italian)) {}
Words::Words(const char* english, const char* italian) : en(english), it(italian) {}
Words::Words(std::string_view english, std::string_view italian, const Words* arguments, std::size_t count)
    : en(filled(english, arguments, count, [](const Words& each) -> const std::string& { return each.en; })),
      it(filled(italian, arguments, count, [](const Words& each) -> const std::string& { return each.it; })) {}

Words& Words::operator+=(const Words& more) {
    en += more.en;
    it += more.it;
    return *this;
}
Words operator+(Words first, const Words& second) { return first += second; }
bool operator==(const Words& one, const Words& other) { return one.en == other.en && one.it == other.it; }

}  // namespace kinegraph
