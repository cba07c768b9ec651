// Conversions between doubles and decimals for web/module/standard/charconv, with the bytes of the native library.
#define FMT_HEADER_ONLY
#include <fmt/format.h>

#include <fast_float/fast_float.h>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>

namespace {

std::to_chars_result copied(char* first, char* last, std::string_view text) {
    if (last - first < static_cast<std::ptrdiff_t>(text.size())) return {last, std::errc::value_too_large};
    std::memcpy(first, text.data(), text.size());
    return {first + text.size(), {}};
}

std::string printed(const char* format, int precision, double value) {
    std::string text(512, '\0');  // more than the 309 digits before the point and the decimals that we print
    const int length = std::snprintf(text.data(), text.size(), format, precision, value);
    text.resize(static_cast<std::size_t>(length) + 1);
    if (text.size() > 512) std::snprintf(text.data(), text.size(), format, precision, value);
    text.resize(static_cast<std::size_t>(length));
    return text;
}

/// The shortest digits that give the double back; of these the nearest to it.
struct Shortest {
    bool is_negative;
    std::string digits;  ///< without zeros at the end
    int point;           ///< digits before the decimal point, ≤ 0 for a number below 0.1
};
Shortest shortest(double value) {
    const auto decimal = fmt::detail::dragonbox::to_decimal(std::abs(value));
    std::string digits = std::to_string(decimal.significand);
    int point = static_cast<int>(digits.size()) + decimal.exponent;
    while (digits.size() > 1 && digits.back() == '0') digits.pop_back();
    return {std::signbit(value), digits, point};
}

std::string scientific(const Shortest& number) {
    const int exponent = number.point - 1;
    std::string text = number.is_negative ? "-" : "";
    text += number.digits[0];
    if (number.digits.size() > 1) text += '.' + number.digits.substr(1);
    text += exponent < 0 ? "e-" : "e+";
    if (std::abs(exponent) < 10) text += '0';
    return text + std::to_string(std::abs(exponent));
}

std::string fixed(const Shortest& number, double value) {
    const int count = static_cast<int>(number.digits.size());
    // An integer beyond its shortest digits is printed exactly: no longer than with zeros, and nearer.
    if (number.point > count) return printed("%.*f", 0, value);
    std::string text = number.is_negative ? "-" : "";
    if (number.point <= 0)
        return text + "0." + std::string(static_cast<std::size_t>(-number.point), '0') + number.digits;
    const auto before = static_cast<std::size_t>(number.point);
    text += number.digits.substr(0, before);
    return number.point == count ? text : text + '.' + number.digits.substr(before);
}

std::string unusual(double value) {
    if (std::isnan(value)) return std::signbit(value) ? "-nan" : "nan";
    if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
    return std::signbit(value) ? "-0" : "0";
}
bool is_unusual(double value) { return !std::isfinite(value) || value == 0; }

}  // namespace

_LIBCPP_BEGIN_NAMESPACE_STD

to_chars_result to_chars(char* first, char* last, double value) {
    if (is_unusual(value)) return copied(first, last, unusual(value));
    const Shortest number = shortest(value);
    const string with_exponent = scientific(number), without = fixed(number, value);
    return copied(first, last, without.size() <= with_exponent.size() ? without : with_exponent);
}

to_chars_result to_chars(char* first, char* last, double value, chars_format format) {
    if (format == chars_format::fixed)
        return copied(first, last, is_unusual(value) ? unusual(value) : fixed(shortest(value), value));
    if (format == chars_format::scientific && value != 0)
        return copied(first, last, is_unusual(value) ? unusual(value) : scientific(shortest(value)));
    return to_chars(first, last, value);
}

to_chars_result to_chars(char* first, char* last, double value, chars_format format, int precision) {
    if (!isfinite(value)) return copied(first, last, unusual(value));
    const char* const as = format == chars_format::fixed        ? "%.*f"
                           : format == chars_format::scientific ? "%.*e"
                                                                : "%.*g";
    return copied(first, last, printed(as, precision, value));
}

from_chars_result from_chars(const char* first, const char* last, double& value, chars_format format) {
    const auto read = fast_float::from_chars(
        first, last, value,
        static_cast<fast_float::chars_format>(format == chars_format::general ? fast_float::general
                                              : format == chars_format::fixed ? fast_float::fixed
                                                                              : fast_float::scientific));
    return {read.ptr, read.ec};
}

_LIBCPP_END_NAMESPACE_STD
