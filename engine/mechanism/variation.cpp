#include "engine/mechanism/variation.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <string>

namespace kinegraph {
namespace {

/// Steele, Lea and Flood, Fast splittable pseudorandom number generators, 2014: its finalizer.
std::uint64_t mixed(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
}

}  // namespace

std::optional<std::string> decimal_text(const Exact& value) {
    mpz_class rest = value.rational().get_den();
    unsigned long twos = 0, fives = 0;
    for (; rest % 2 == 0; ++twos) rest /= 2;
    for (; rest % 5 == 0; ++fives) rest /= 5;
    if (rest != 1) return std::nullopt;
    const unsigned long digits = std::max(twos, fives);
    mpz_class power;
    mpz_ui_pow_ui(power.get_mpz_t(), 10, digits);
    const mpz_class scaled = value.rational().get_num() * (power / value.rational().get_den());
    std::string text = mpz_class(abs(scaled)).get_str();
    if (digits > 0) {
        if (text.size() <= digits) text.insert(0, digits + 1 - text.size(), '0');
        text.insert(text.size() - digits, ".");
    }
    return (scaled < 0 ? "-" : "") + text;
}

std::string Variation::value(std::uint64_t i) const {
    return choices.empty() ? text_of(from + Exact::ratio(static_cast<long>(i), 1) * step)
                           : choices[static_cast<std::size_t>(i)];
}

std::string Variation::text_of(const Exact& value) const {
    const auto decimal = decimal_text(value);
    if (decimal) return unit.empty() ? *decimal : unit == "deg" ? *decimal + "°" : *decimal + " " + unit;
    const std::string fraction =
        "= " + value.rational().get_num().get_str() + "/" + value.rational().get_den().get_str();
    return unit.empty() ? fraction : fraction + " * 1 " + unit;
}

std::optional<std::uint64_t> Lattice::size(const std::vector<Variation>& vary) {
    std::uint64_t size = 1;
    for (const Variation& each : vary) {
        if (size > most / each.count) return std::nullopt;
        size *= each.count;
    }
    return size;
}

std::vector<Setting> Lattice::at(const std::vector<Variation>& vary, std::uint64_t number) {
    std::vector<Setting> set;
    for (const Variation& each : vary) {
        set.push_back({each.parameter, each.value(number % each.count)});
        number /= each.count;
    }
    return set;
}

Shuffle::Shuffle(std::uint64_t seed, std::uint64_t size) : size_(size), half_bits_(1) {
    while (half_bits_ < 31 && (std::uint64_t{1} << (2 * half_bits_)) < size) ++half_bits_;
    std::uint64_t key = mixed(seed);
    for (std::uint64_t& each : keys_) each = key = mixed(key);
}

std::uint64_t Shuffle::encrypted(std::uint64_t number) const {
    const std::uint64_t mask = (std::uint64_t{1} << half_bits_) - 1;
    std::uint64_t left = number >> half_bits_, right = number & mask;
    for (const std::uint64_t key : keys_) {
        const std::uint64_t next = left ^ (mixed(right ^ key) & mask);
        left = right;
        right = next;
    }
    return (left << half_bits_) | right;
}

std::uint64_t Shuffle::at(std::uint64_t place) const {
    do place = encrypted(place);
    while (place >= size_);
    return place;
}

}  // namespace kinegraph
