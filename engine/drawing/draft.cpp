#include "engine/drawing/draft.hpp"
#include "lang/keys/drawing.hpp"
#include "lang/keys/sentences.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <variant>

namespace kinegraph::drafting {
namespace {

std::string number_text(double value) {
    constexpr int digits = 6;
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
    return {text.data(), end.ptr};
}

}  // namespace

Vector turned(const Vector& x, const Vector& y) { return {x.x * y.x - x.y * y.y, x.x * y.y + x.y * y.x}; }

int magnitude(const Exact& value) {
    if (value.is_zero()) return 0;
    return static_cast<int>(mpz_sizeinbase(value.rational().get_num_mpz_t(), 2)) -
           static_cast<int>(mpz_sizeinbase(value.rational().get_den_mpz_t(), 2));
}
int magnitude_of_length(const Vector& a) { return static_cast<int>(std::floor(magnitude(squared_length(a)) / 2.0)); }

bool is_rational(const Angle& angle) {
    if (!angle.in_degrees) return angle.value.is_zero();
    return (angle.value / 45).rational().get_den() == 1;
}

Words length_text(double metres, const Unit& unit) {
    return decimal_words(number_text(metres / unit.si.to_double()) + " " + unit.symbol);
}

Draft::Draft(const Mechanism& of, int bits, int size_exponent, std::size_t longest_given, Exact of_slack)
    : mechanism(of),
      grid(bits - size_exponent),
      rounds(longest_given > most_bits),
      slack(std::move(of_slack)),
      estimated_size(Exact::power_of_two(size_exponent)),
      is_touched(of.points.size(), false),
      is_placed(of.points.size(), false),
      rough_x(of.points.size()) {
    pose.bits = bits;
    pose.points.resize(of.points.size());
    pose.leftover.resize(of.points.size());
    if (!rounds) return;
    constexpr double digits_of_bit = 0.30103;  // log10 2
    const auto digits = [](std::size_t count) {
        return Count{static_cast<int>(digits_of_bit * static_cast<double>(count))};
    };
    pose.remarks.push_back(
        {lang::sentences::rounded_givens, {digits(longest_given / 2), digits(static_cast<std::size_t>(bits))}});
}

Errors Draft::in_order_of_file() {
    const auto rank = [&](const Error& error) {
        std::size_t i = 0;
        while (i < mechanism.points.size() && error.where != mechanism.points[i].where) ++i;
        return i;
    };
    std::stable_sort(errors.begin(), errors.end(), [&](const Error& a, const Error& b) { return rank(a) < rank(b); });
    return std::move(errors);
}

void Draft::measure() {
    pose.size = 1;
    if (pose.points.empty()) return;
    Vector low = pose.points.front();
    Vector high = low;
    for (const Vector& point : pose.points) {
        low = {std::min(low.x, point.x), std::min(low.y, point.y)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
    const Exact largest = std::max(high.x - low.x, high.y - low.y);
    if (!largest.is_zero()) pose.size = largest;
}

Amount Draft::amount(double metres) const {
    return {metres / mechanism.units.length.si.to_double(), mechanism.units.length.symbol};
}

std::string Draft::name_of(const Place& place) const {
    if (const auto* point = std::get_if<PointIndex>(&place)) return mechanism.point(*point).name;
    const auto& at = std::get<Vector>(place);
    const double unit = mechanism.units.length.si.to_double();
    return "[" + number_text(at.x.to_double() / unit) + ", " + number_text(at.y.to_double() / unit) + "]";
}

bool Draft::fail(std::string where, Words message, ErrorCode code) {
    errors.push_back({code, std::move(where), std::move(message)});
    return false;
}

Vector Draft::at(const Place& place) const {
    if (const auto* point = std::get_if<PointIndex>(&place)) return pose.at(*point);
    return std::get<Vector>(place);
}

bool Draft::touched(const Place& place) const {
    const auto* point = std::get_if<PointIndex>(&place);
    return point != nullptr && is_touched[at_index(*point)];
}

bool Draft::touched(const Bearing::Between& between) const {
    return is_touched[at_index(between.from)] || is_touched[at_index(between.to)];
}

std::optional<Vector> Draft::direction_between(const Bearing::Between& between, const std::string& where) {
    const Vector direction = pose.at(between.to) - pose.at(between.from);
    const bool nothing = touched(between) ? is_small(direction) : squared_length(direction) <= square(slack);
    if (!nothing) return direction;
    fail(where, {lang::drawing::and_coincide_so_they_give_no, name_of(between.from), name_of(between.to)});
    return std::nullopt;
}

bool Draft::is_small(const Vector& a) const {
    return squared_length(a) < square(Exact::power_of_two(bits_in_doubt - pose.bits) * estimated_size);
}

void Draft::set(const NamedPoint& named, const Vector& exact_place, const Exact& own_leftover, bool by_root) {
    const auto index = static_cast<std::size_t>(&named - mechanism.points.data());
    const bool is_long = rounds && std::max(exact_place.x.bits(), exact_place.y.bits()) > most_bits;
    const Vector place = is_long ? on_grid(exact_place) : exact_place;
    const Exact leftover = is_long ? own_leftover + grid_step() : own_leftover;
    pose.points[index] = place;
    pose.leftover[index] = leftover;
    rough_x[index] = place.x.to_double();
    is_touched[index] = by_root || !leftover.is_zero();
    is_placed[index] = true;
}

std::pair<Vector, Exact> Draft::along(const Vector& direction, const Exact& distance) const {
    const int scale = magnitude_of_length(direction) + 1;
    const Root factor = square_root(square(distance) / squared_length(direction), std::max(grid + scale, 1));
    const Vector reach = factor.value * direction;
    return {distance.sign() < 0 ? -reach : reach, factor.leftover * Exact::power_of_two(scale)};
}

Vector Draft::on_line(const Vector& through, const Vector& direction, const Exact& factor, bool inexact) const {
    if (!inexact) return through + factor * direction;
    return through + rounded(factor, std::max(grid + magnitude_of_length(direction) + 1, 1)) * direction;
}

}  // namespace kinegraph::drafting
