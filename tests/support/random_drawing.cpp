#include "tests/support/random_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kinegraph {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double reach = 150;  // mm: half the width of the drawing

Spot turned(Spot a, double angle) {
    return {a.x * std::cos(angle) - a.y * std::sin(angle), a.x * std::sin(angle) + a.y * std::cos(angle)};
}

/// value / 10^digits as a decimal.
std::string decimal(long value, int digits) {
    std::string text = std::to_string(std::labs(value));
    if (digits > 0) {
        const auto places = static_cast<std::size_t>(digits);
        if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
        text.insert(text.size() - places, ".");
    }
    return (value < 0 ? "-" : "") + text;
}
std::string tenths(double value) { return decimal(std::lround(value * 10), 1); }
double to_tenths(double value) { return static_cast<double>(std::lround(value * 10)) / 10; }
std::string quoted(const std::string& text) { return "\"" + text + "\""; }
std::string pair(const std::string& a, const std::string& b) { return "[" + a + ", " + b + "]"; }

}  // namespace

const double least_sine = std::sin(6 * pi / 180);

double length(Spot a) { return std::hypot(a.x, a.y); }
double sine(Spot a, Spot b) { return std::abs(cross(a, b)) / (length(a) * length(b)); }

RandomDrawing::RandomDrawing(Random& random, bool by_compass) : random_(random), by_compass_(by_compass) {
    bodies_.push_back({"1", {}});
}

Spot RandomDrawing::anywhere() {
    // An initialiser list fixes the order of evaluation; the order of function arguments depends on the compiler.
    return {to_tenths(random_.real(-reach, reach)), to_tenths(random_.real(-reach, reach))};
}
int RandomDrawing::given(Spot spot) { return add(spot, pair(tenths(spot.x), tenths(spot.y))); }
std::string RandomDrawing::body_pair(int i, int j) const { return pair(quoted(body_name(i)), quoted(body_name(j))); }

bool RandomDrawing::is_free(Spot spot) const {
    for (const Point& point : points_) {
        if (length(point.spot - spot) < least_distance) return false;
    }
    return true;
}

std::string RandomDrawing::unused_name() {
    const std::size_t count = points_.size();
    const std::string letter(1, static_cast<char>('A' + count % 26));
    return count < 26 ? letter : letter + std::to_string(count / 26);
}

int RandomDrawing::add(Spot spot, std::string placement) {
    points_.push_back({unused_name(), spot, std::move(placement)});
    return static_cast<int>(points_.size()) - 1;
}

std::optional<int> RandomDrawing::place() {
    for (int attempt = 0; attempt < 40; ++attempt) {
        const Spot spot = anywhere();
        if (!by_compass_ || points_.empty() || random_.chance(40)) {
            if (is_free(spot)) return given(spot);
            continue;
        }
        const int from = any_point();
        const Spot away = spot - at(from);
        if (random_.chance(60)) {
            const double distance = to_tenths(length(away));
            const long degrees = std::lround(std::atan2(away.y, away.x) * 180 / pi * 10);
            const Spot there = at(from) + distance * turned({1, 0}, static_cast<double>(degrees) / 10 * pi / 180);
            if (!is_free(there)) continue;
            return add(there, "{\"from\": " + quoted(name(from)) + ", \"distance\": " + tenths(distance) +
                                  ", \"angle\": " + decimal(degrees, 1) + "}");
        }
        const int to = any_point();
        if (to == from) continue;
        const double ratio = to_tenths(random_.real(-0.6, 1.6));
        const Spot there = at(from) + ratio * (at(to) - at(from));
        if (!is_free(there) || std::abs(there.x) > 2 * reach || std::abs(there.y) > 2 * reach) continue;
        return add(there, "{\"from\": " + quoted(name(from)) + ", \"to\": " + quoted(name(to)) +
                              ", \"ratio\": " + tenths(ratio) + "}");
    }
    return std::nullopt;
}

std::optional<int> RandomDrawing::given_anywhere() {
    for (int attempt = 0; attempt < 40; ++attempt) {
        const Spot spot = anywhere();
        if (is_free(spot)) return given(spot);
    }
    return std::nullopt;
}

std::optional<int> RandomDrawing::on_line(int from, int to, double ratio) {
    const Spot there = at(from) + ratio * (at(to) - at(from));
    if (!is_free(there) || std::abs(there.x) > 2 * reach || std::abs(there.y) > 2 * reach) return std::nullopt;
    return add(there, "{\"from\": " + quoted(name(from)) + ", \"to\": " + quoted(name(to)) +
                          ", \"ratio\": " + tenths(ratio) + "}");
}

std::optional<int> RandomDrawing::pin_between(int a, int c) {
    for (int attempt = 0; attempt < 60; ++attempt) {
        Spot spot = anywhere();
        if (length(spot - at(a)) < least_distance || length(spot - at(c)) < least_distance) continue;
        if (by_compass_ && random_.chance(70)) {
            const double r = to_tenths(length(spot - at(a))), s = to_tenths(length(spot - at(c)));
            const Spot between = at(c) - at(a);
            const double d = length(between);
            const double along = (d * d + r * r - s * s) / (2 * d);
            const double square = r * r - along * along;
            if (square < 1) continue;
            const bool left = cross(between, spot - at(a)) > 0;
            const Spot unit = 1 / d * between;
            spot = at(a) + along * unit + (left ? 1 : -1) * std::sqrt(square) * Spot{-unit.y, unit.x};
            if (!is_free(spot) || sine(spot - at(a), spot - at(c)) < least_sine) continue;
            return add(spot, "{\"meet\": [{\"circle\": " + quoted(name(a)) + ", \"radius\": " + tenths(r) +
                                 "}, {\"circle\": " + quoted(name(c)) + ", \"radius\": " + tenths(s) +
                                 "}], \"side\": \"" + (left ? "left" : "right") + "\"}");
        }
        if (is_free(spot) && sine(spot - at(a), spot - at(c)) >= least_sine) return given(spot);
    }
    return std::nullopt;
}

int RandomDrawing::add_body(std::vector<int> points) {
    bodies_.push_back({std::to_string(bodies_.size() + 1), std::move(points)});
    return static_cast<int>(bodies_.size()) - 1;
}

std::optional<int> RandomDrawing::point_on(int body) {
    std::vector<int>& points = points_of(body);
    if (!points.empty() && !random_.chance(body == 0 ? 70 : 25))
        return points[static_cast<std::size_t>(random_.whole(0, static_cast<int>(points.size()) - 1))];
    const auto fresh = place();
    if (fresh) points_of(body).push_back(*fresh);
    return fresh;
}

void RandomDrawing::further_point(int body) {
    if (!random_.chance(45)) return;
    if (const auto fresh = place()) points_of(body).push_back(*fresh);
}

void RandomDrawing::revolute(int point, int i, int j) {
    for (Hinge& hinge : hinges_) {
        const bool holds =
            hinge.point == point && std::find(hinge.bodies.begin(), hinge.bodies.end(), i) != hinge.bodies.end();
        if (holds && random_.chance(50)) return hinge.bodies.push_back(j);
    }
    hinges_.push_back({point, {i, j}, joints_.size()});
    joints_.emplace_back();
}

void RandomDrawing::weld(int point, int i, int j) {
    joints_.push_back("{\"weld\": " + quoted(name(point)) + ", \"bodies\": " + body_pair(i, j) + "}");
}

std::string RandomDrawing::slide(const char* kind, int point, int i, int j, const std::string& along) {
    std::string title = "s" + std::to_string(++slides_);
    joints_.push_back("{\"" + std::string(kind) + "\": " + quoted(name(point)) + ", \"bodies\": " + body_pair(i, j) +
                      ", " + along + ", \"name\": " + quoted(title) + "}");
    return title;
}

std::string RandomDrawing::prismatic(int point, int i, int j, const Guide& guide) {
    return slide("prismatic", point, i, j, "\"along\": " + guide.text);
}

std::string RandomDrawing::pin_slot(int point, int i, int j, const Guide& guide) {
    return slide("pin-slot", point, i, j, "\"along\": " + guide.text);
}

std::string RandomDrawing::pin_in_arc(int point, int i, int j, int centre) {
    return slide("pin-slot", point, i, j, "\"arc\": " + quoted(name(centre)));
}

Guide RandomDrawing::any_guide() {
    if (by_compass_ && random_.chance(50)) {
        const long degrees = random_.whole(-1799, 1800);
        return {decimal(degrees, 1), turned({1, 0}, static_cast<double>(degrees) / 10 * pi / 180)};
    }
    if (points_.size() > 1 && random_.chance(30)) {
        const int from = any_point(), to = any_point();
        if (from != to) return {pair(quoted(name(from)), quoted(name(to))), at(to) - at(from)};
    }
    int dx = 0, dy = 0;
    while (dx == 0 && dy == 0) dx = random_.whole(-9, 9), dy = random_.whole(-9, 9);
    return {pair(std::to_string(dx), std::to_string(dy)), {static_cast<double>(dx), static_cast<double>(dy)}};
}

std::string RandomDrawing::speed(double most) {
    long value = 0;
    while (value == 0) value = std::lround(random_.real(-most, most) * 100);
    return decimal(value, 2);
}

void RandomDrawing::spin(int body, int relative_to) {
    std::string text = "{\"body\": " + quoted(body_name(body));
    if (relative_to != 0) text += ", \"relative to\": " + quoted(body_name(relative_to));
    const std::string omega = random_.chance(8) ? quoted(std::to_string(random_.whole(10, 300)) + " rpm") : speed(12);
    drivers_.push_back(text + ", \"omega\": " + omega + ", \"alpha\": " + speed(20) + "}");
}

void RandomDrawing::drive_slide(const std::string& joint) {
    drivers_.push_back("{\"joint\": " + quoted(joint) + ", \"speed\": " + speed(2) + ", \"acceleration\": " + speed(5) +
                       "}");
}

void RandomDrawing::drive_point(int body, int point, const Guide& along) {
    drivers_.push_back("{\"body\": " + quoted(body_name(body)) + ", \"at\": " + quoted(name(point)) + ", \"along\": " +
                       along.text + ", \"speed\": " + speed(2) + ", \"acceleration\": " + speed(5) + "}");
}

Guide RandomDrawing::tangent(int point, int centre) const {
    const Spot radius = at(point) - at(centre);
    return {pair(tenths(-radius.y), tenths(radius.x)), {-radius.y, radius.x}};
}

void RandomDrawing::higher_pair(const char* kind, int point, int i, int j, int centre_i, std::optional<int> centre_j,
                                const std::string& more) {
    const auto circle = [&](int centre) { return "{\"circle\": " + quoted(name(centre)) + "}"; };
    const std::string other = centre_j ? circle(*centre_j) : "{\"line\": " + tangent(point, centre_i).text + "}";
    joints_.push_back("{\"" + std::string(kind) + "\": " + quoted(name(point)) + ", \"bodies\": " + body_pair(i, j) +
                      ", \"profiles\": {" + quoted(body_name(i)) + ": " + circle(centre_i) + ", " +
                      quoted(body_name(j)) + ": " + other + "}" + more +
                      ", \"name\": " + quoted("h" + std::to_string(joints_.size())) + "}");
}
void RandomDrawing::rolling(int point, int i, int j, int centre_i, std::optional<int> centre_j) {
    higher_pair("rolling", point, i, j, centre_i, centre_j);
}
void RandomDrawing::contact(int point, int i, int j, int centre_i, std::optional<int> centre_j) {
    higher_pair("contact", point, i, j, centre_i, centre_j);
}

void RandomDrawing::gear(int point, int i, int j, int centre_i, std::optional<int> centre_j, int arm) {
    higher_pair("gear", point, i, j, centre_i, centre_j,
                (arm != 0 ? ", \"arm\": " + quoted(body_name(arm)) : std::string()) + ", \"pressure angle\": 20");
}

void RandomDrawing::balance(const char* kind, const std::string& where) {
    efforts_.push_back("{\"" + std::string(kind) + "\": " + quoted("E" + std::to_string(efforts_.size())) + ", " +
                       where + "}");
}
void RandomDrawing::balance_by_couple(int body, int from) {
    balance("couple",
            "\"body\": " + quoted(body_name(body)) + (from != 0 ? ", \"from\": " + quoted(body_name(from)) : ""));
}
void RandomDrawing::balance_by_force(int body, int point, const Guide& along) {
    balance("force",
            "\"body\": " + quoted(body_name(body)) + ", \"at\": " + quoted(name(point)) + ", \"along\": " + along.text);
}
void RandomDrawing::balance_in_slide(const std::string& joint) { balance("force", "\"joint\": " + quoted(joint)); }

std::string RandomDrawing::text() const {
    std::string out = "{\n  \"kinegraph\": 1,\n  \"units\": {\"length\": \"mm\"},\n  \"frame\": 1,\n  \"points\": {\n";
    for (std::size_t i = 0; i < points_.size(); ++i)
        out += "    " + quoted(points_[i].name) + ": " + points_[i].placement + (i + 1 < points_.size() ? ",\n" : "\n");
    out += "  },\n  \"bodies\": {\n";
    for (std::size_t i = 1; i < bodies_.size(); ++i) {
        out += "    " + quoted(bodies_[i].name) + ": [";
        for (std::size_t k = 0; k < bodies_[i].points.size(); ++k)
            out += (k > 0 ? ", " : "") + quoted(name(bodies_[i].points[k]));
        out += i + 1 < bodies_.size() ? "],\n" : "]\n";
    }
    out += "  },\n  \"joints\": [\n";
    for (std::size_t i = 0; i < joints_.size(); ++i)
        out += "    " + joint_text(i) + (i + 1 < joints_.size() ? ",\n" : "\n");
    out += "  ],\n  \"drivers\": [";
    for (std::size_t i = 0; i < drivers_.size(); ++i) out += (i > 0 ? ", " : "") + drivers_[i];
    out += "]";
    if (!efforts_.empty()) {
        out += ",\n  \"effort\": [";
        for (std::size_t i = 0; i < efforts_.size(); ++i) out += (i > 0 ? ", " : "") + efforts_[i];
        out += "]";
    }
    return out + "\n}\n";
}

std::string RandomDrawing::joint_text(std::size_t index) const {
    for (const Hinge& hinge : hinges_) {
        if (hinge.joint != index) continue;
        std::string names;
        for (const int body : hinge.bodies) names += (names.empty() ? "" : ", ") + quoted(body_name(body));
        return "{\"revolute\": " + quoted(name(hinge.point)) + ", \"bodies\": [" + names + "]}";
    }
    return joints_[index];
}

}  // namespace kinegraph
