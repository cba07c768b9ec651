#include "engine/mechanism/cam.hpp"
#include "engine/number/functions.hpp"
#include "lang/keys/cams.hpp"
#include "lang/keys/positions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace kinegraph {
namespace {

using Spot = VectorOf<double>;

Spot direction(double angle) { return {nearest::cos(angle), nearest::sin(angle)}; }
Spot turned_back(const Spot& a) { return {a.y, -a.x}; }
double size_of(const Spot& a) { return nearest::hypot(a.x, a.y); }
double angle_from(const Spot& from, const Spot& to) { return nearest::atan2(cross(from, to), dot(from, to)); }
bool is_trace(const Follower& follower) { return follower.face != Follower::Face::flat; }

Error fault(std::string where, Words message) { return {ErrorCode::bad_input, std::move(where), std::move(message)}; }

}  // namespace

VectorOf<double> CamState::on_cam(const VectorOf<double>& place, double sense) const {
    const Spot facing = direction(-sense * turn);
    return {facing.x * place.x - facing.y * place.y, facing.x * place.y + facing.y * place.x};
}

Result<CamGeometry> CamGeometry::of(const Cam& cam) {
    const Follower& follower = cam.follower;
    CamGeometry made;
    made.cam_ = &cam;
    made.law_ = LawCurve(cam.law);
    made.sense_ = cam.omega.sign();
    made.base_ = cam.base_circle.to_double();
    made.roller_ = follower.radius.to_double();
    made.offset_ = follower.offset.to_double();
    made.arm_ = follower.arm.to_double();
    made.pivot_ = {follower.pivot.x.to_double(), follower.pivot.y.to_double()};
    const double prime = made.base_ + made.roller_, away = size_of(made.pivot_), side = follower.on_left ? 1 : -1;
    if (follower.moves == Follower::Moves::translating) {
        if (is_trace(follower)) {
            const double height = prime * prime - made.offset_ * made.offset_;
            if (height <= 0)
                return tl::unexpected(
                    Errors{fault("/cam/follower/offset", {lang::positions::the_follower_line_passes_the_prime})});
            made.height_ = std::sqrt(height);
        }
        return made;
    }
    // Triangle of cam centre, pivot and contact; for a flat face the angle between its normal and the line to the
    // pivot.
    const double of_arm = (away * away + made.arm_ * made.arm_ - prime * prime) / (2 * away * made.arm_);
    const double of_face = (made.base_ + made.offset_) / away;
    const double cosine = is_trace(follower) ? of_arm : of_face;
    if (!(std::abs(cosine) < 1))
        return tl::unexpected(Errors{fault("/cam/follower", {lang::positions::the_follower_does_not_reach})});
    const double to_pivot = nearest::atan2(made.pivot_.y, made.pivot_.x);
    made.first_angle_ = is_trace(follower) ? to_pivot + std::numbers::pi - side * nearest::acos(cosine)
                                           : to_pivot + side * nearest::acos(cosine);
    // The rise moves the follower away from the cam's centre: |C| grows, or the face's distance.
    const double grows = cross(direction(made.first_angle_), made.pivot_);
    made.rises_ = grows > 0 ? 1 : -1;
    return made;
}

CamState CamGeometry::at(double turn) const { return at(turn, law_.at(turn)); }
CamState CamGeometry::at(double turn, const LawState& rise) const {
    return is_trace(cam_->follower) ? of_trace(turn, rise) : of_face(turn, rise);
}

/// In complex numbers, with ψ the cam's rotation and c the trace point in the frame, the pitch curve on the cam is p =
/// e^{−iψ} c, so that e^{iψ} p′ = c′ − i c and e^{iψ} p″ = c″ − 2i c′ − c. It is traversed clockwise: convex is κ > 0.
CamState CamGeometry::of_trace(double turn, const LawState& rise) const {
    CamState state;
    state.turn = turn;
    state.rise = rise;
    const double first = sense_ * state.rise.first, second = state.rise.second;
    Spot c, c_1, c_2, way{0, 1};
    if (cam_->follower.moves == Follower::Moves::translating) {
        c = {offset_, height_ + state.rise.s};
        c_1 = {0, first};
        c_2 = {0, second};
    } else {
        const Spot along = direction(first_angle_ + rises_ * state.rise.s);
        c = pivot_ + arm_ * along;
        c_1 = (arm_ * rises_ * first) * quarter_turn(along);
        c_2 = (arm_ * rises_ * second) * quarter_turn(along) - (arm_ * first * first) * along;
        way = rises_ * quarter_turn(along);
    }
    const Spot p_1 = c_1 - quarter_turn(c), p_2 = c_2 - 2.0 * quarter_turn(c_1) - c;
    const double speed = size_of(p_1);
    state.trace = c;
    state.outward = (1 / speed) * quarter_turn(p_1);
    state.pitch_curvature = -cross(p_1, p_2) / (speed * speed * speed);
    state.contact = c - roller_ * state.outward;
    // The radius of curvature of a parallel is smaller by the distance: κ/(1 − κ r), without a division where the pitch
    // curve is straight.
    state.curvature = state.pitch_curvature / (1 - state.pitch_curvature * roller_);
    state.pressure_angle = angle_from(way, state.outward);
    return state;
}

/// The face is the line X·N = H, N = e^{iγ} its normal away from the cam; on the cam its angle is φ = γ − ψ. The
/// profile is the envelope with support function H(φ): contact at H N + (dH/dφ) iN, radius of curvature H + d²H/dφ².
CamState CamGeometry::of_face(double turn, const LawState& rise) const {
    CamState state;
    state.turn = turn;
    state.rise = rise;
    const double s_1 = sense_ * state.rise.first, s_2 = state.rise.second;
    Spot normal{0, 1};
    double height = base_ + state.rise.s, height_1 = s_1, height_2 = s_2, phi_1 = -1, phi_2 = 0;
    if (cam_->follower.moves == Follower::Moves::oscillating) {
        normal = direction(first_angle_ + rises_ * state.rise.s);
        const double gamma_1 = rises_ * s_1, gamma_2 = rises_ * s_2;
        const double across = dot(quarter_turn(normal), pivot_), along = dot(normal, pivot_);
        height = along - offset_;
        height_1 = gamma_1 * across;
        height_2 = gamma_2 * across - gamma_1 * gamma_1 * along;
        phi_1 = gamma_1 - 1;
        phi_2 = gamma_2;
    }
    const double slope = height_1 / phi_1;
    const double radius = height + (height_2 * phi_1 - height_1 * phi_2) / (phi_1 * phi_1 * phi_1);
    state.outward = normal;
    state.contact = height * normal + slope * quarter_turn(normal);
    state.trace = state.contact;
    state.curvature = state.pitch_curvature = 1 / radius;
    const Spot way = cam_->follower.moves == Follower::Moves::translating
                         ? Spot{0, 1}
                         : rises_ * quarter_turn(state.contact - pivot_);
    state.pressure_angle = angle_from(way, normal);
    return state;
}

// --- as a mechanism file
// ------------------------------------------------------------------------------------------------------

namespace {

/// Thirteen digits: coordinates of fifteen digits would count as rounded.
std::string written(double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.13g", value == 0 ? 0.0 : value);
    return text.data();
}
/// Error of such a coordinate near the cam, in the cam's unit of length: points on a circle miss it by some units in
/// the last place.
std::string precision_of(const Cam& cam) {
    constexpr int digits = 10;
    const double base = (cam.base_circle / cam.units.length.si).to_double();
    return "1e" + std::to_string(static_cast<int>(std::floor(nearest::log10(base))) - digits);
}
std::string written(const Spot& place) { return "[" + written(place.x) + ", " + written(place.y) + "]"; }

std::string in_quotes(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + '"';
}
/// {"en": …, "it": …}: a language that says what English says is left out.
std::string in_languages(const Words& words) {
    std::string members;
    for (const Language language : languages)
        if (language == Language::en || words.in(language) != words.in(Language::en))
            members +=
                (members.empty() ? "" : ", ") + in_quotes(code_of(language)) + ": " + in_quotes(words.in(language));
    return "{" + members + "}";
}
std::string title_of(const Cam& cam, double turn) {
    const std::string at = " (" + written(turn * 180 / std::numbers::pi) + "°)";
    return in_languages((cam.title.empty() ? Words(lang::cams::disc_cam) : cam.title) + at);
}

/// Writes the file; lengths in the cam's own unit.
class FileOfCam {
public:
    FileOfCam(const Cam& cam, const CamGeometry& geometry, double turn)
        : cam_(cam), state_(geometry.at(turn)), unit_(cam.units.length.si.to_double()), turn_(turn) {
        // A more distant centre of curvature cannot be drawn, and the profile is practically straight.
        is_straight_ = std::abs(state_.curvature) * cam.base_circle.to_double() < 1e-6;
        is_round_about_origin_ = state_.rise.first == 0 && state_.rise.second == 0;
    }

    std::string text() && {
        point("O", {0, 0});
        write_follower_points();
        std::string file = "{\n  \"kinegraph\": 1,\n  \"title\": " + title_of(cam_, turn_) +
                           ",\n  \"position of cam\": " + in_quotes(cam_.source) + ",\n  \"units\": " + units() +
                           ",\n  \"precision\": " + precision_of(cam_) + ",\n  \"frame\": 1,\n  \"points\": {" +
                           points_ + "\n  },\n  \"bodies\": {\n    \"2\": " + cam_body() +
                           ",\n    \"3\": " + follower_body() +
                           "\n  },\n  \"joints\": [\n    {\"revolute\": \"O\", \"bodies\": [1, 2]},\n    " + contact() +
                           ",\n    " + guide() + "\n  ],\n  \"drivers\": [{\"body\": 2, \"omega\": " +
                           written((cam_.omega / cam_.units.angular_velocity.si).to_double()) +
                           "}],\n  \"find\": [\"instant centres\", \"velocity\", \"acceleration\"]\n}\n";
        return file;
    }

private:
    /// The cam's own units; its angles are written in degrees.
    std::string units() const {
        const Unit &length = cam_.units.length, &rate = cam_.units.angular_velocity;
        const std::string of_rate = rate.si == 1 ? "" : R"(, "angular velocity": ")" + rate.symbol + '"';
        return R"({"length": ")" + length.symbol + '"' + of_rate + "}";
    }
    bool translates() const { return cam_.follower.moves == Follower::Moves::translating; }
    bool is_flat() const { return cam_.follower.face == Follower::Face::flat; }
    const char* centre() const { return is_round_about_origin_ ? "O" : "K"; }
    Spot in_unit(const Spot& place) const { return (1 / unit_) * place; }
    void point(const std::string& name, const Spot& place) { placed(name, written(in_unit(place))); }
    void placed(const std::string& name, const std::string& placement) {
        points_ += (points_.empty() ? "\n    \"" : ",\n    \"") + name + "\": " + placement;
    }

    /// P lies exactly on the line of the centres of curvature: along the roller's path, or across the face.
    void write_follower_points() {
        const Spot centre_of_curvature = state_.contact - (1 / state_.curvature) * state_.outward;
        const bool has_centre = !is_straight_ && !is_round_about_origin_;
        if (has_centre) point("K", centre_of_curvature);
        if (cam_.follower.face == Follower::Face::roller) {
            point("C", state_.trace);
            if (is_straight_)
                point("P", state_.contact);
            else
                placed("P", "{\"from\": \"C\", \"to\": \"" + std::string(centre()) + "\", \"distance\": " +
                                written((state_.curvature > 0 ? 1 : -1) * cam_.follower.radius.to_double() / unit_) +
                                "}");
        } else {
            point("P", state_.contact);
        }
        if (translates()) {
            const double rise = 1.2 * cam_.base_circle.to_double();
            point("H", {cam_.follower.face == Follower::Face::flat ? 0 : state_.trace.x, state_.trace.y + rise});
            if (is_flat()) point("F", {0, state_.contact.y});
        } else {
            const Spot pivot{cam_.follower.pivot.x.to_double(), cam_.follower.pivot.y.to_double()};
            point("Q", pivot);
            // A point of the face, beyond the contact as seen from the pivot.
            const Spot along = quarter_turn(state_.outward);
            const double way = dot(along, state_.contact - pivot) < 0 ? -1 : 1;
            if (is_flat()) point("F", state_.contact + (0.4 * way * cam_.base_circle.to_double()) * along);
        }
    }
    std::string cam_body() const {
        if (is_round_about_origin_)
            return "{\"points\": [\"O\"], \"circle\": {\"centre\": \"O\", \"radius\": " +
                   written(1 / state_.curvature / unit_) + "}, \"label\": " + in_languages(lang::cams::cam) + "}";
        const bool is_disc =
            !is_straight_ && state_.curvature > 0 && state_.curvature * cam_.base_circle.to_double() > 0.3;
        std::string body = is_straight_ ? "{\"points\": [\"O\"]" : "{\"points\": [\"O\", \"K\"]";
        if (is_disc)
            body += ", \"circle\": {\"centre\": \"K\", \"radius\": " + written(1 / state_.curvature / unit_) + "}";
        return body + ", \"label\": " + in_languages(lang::cams::cam) + "}";
    }
    std::string follower_body() const {
        const std::string label = ", \"label\": " + in_languages(lang::cams::follower) + "}";
        const std::string guide = translates() ? "H" : "Q";
        if (cam_.follower.face == Follower::Face::roller)
            return "{\"points\": [\"C\", \"" + guide + "\"], \"circle\": {\"centre\": \"C\", \"radius\": " +
                   written(cam_.follower.radius.to_double() / unit_) + "}" + label;
        if (is_flat()) return "{\"points\": [\"F\", \"" + guide + "\"]" + label;
        return "{\"points\": [\"P\", \"" + guide + "\"]" + label;
    }
    std::string contact() const {
        const Spot along = turned_back(state_.outward);
        const std::string line = "{\"line\": " + written(along) + "}";
        const std::string of_cam = is_straight_ ? line : "{\"circle\": \"" + std::string(centre()) + "\"}";
        const std::string of_follower = is_flat()                                          ? line
                                        : cam_.follower.face == Follower::Face::knife_edge ? "{\"tip\": true}"
                                                                                           : "{\"circle\": \"C\"}";
        return "{\"contact\": \"P\", \"bodies\": [3, 2], \"profiles\": {\"2\": " + of_cam + ", \"3\": " + of_follower +
               "}, \"pushes\": " + written(state_.outward) + "}";
    }
    std::string guide() const {
        return translates() ? "{\"prismatic\": \"H\", \"bodies\": [3, 1], \"along\": 90}"
                            : "{\"revolute\": \"Q\", \"bodies\": [1, 3]}";
    }

    const Cam& cam_;
    CamState state_;
    double unit_, turn_;
    bool is_straight_ = false, is_round_about_origin_ = false;
    std::string points_;
};

}  // namespace

std::string mechanism_file_of(const Cam& cam, const CamGeometry& geometry, double turn) {
    return FileOfCam(cam, geometry, turn).text();
}

}  // namespace kinegraph
