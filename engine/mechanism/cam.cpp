#include "engine/mechanism/cam.hpp"
#include "engine/file/json_writer.hpp"
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
        constexpr auto on_lines = JsonWriter::Entries::on_lines;
        json_.open('{', on_lines).member("kinegraph", 1);
        const std::string at = " (" + written(turn_ * 180 / std::numbers::pi) + "°)";
        in_languages("title", (cam_.title.empty() ? Words(lang::cams::disc_cam) : cam_.title) + at);
        json_.member("position of cam", cam_.source);
        write_units();
        json_.key("precision").json(precision_of(cam_)).member("frame", 1).key("points").open('{', on_lines);
        point("O", {0, 0});
        write_follower_points();
        json_.close().key("bodies").open('{', on_lines);
        write_cam_body();
        write_follower_body();
        json_.close().key("joints").open('[', on_lines);
        json_.open('{').member("revolute", "O").member("bodies", std::array{1, 2}).close();
        write_contact();
        json_.open('{').member(translates() ? "prismatic" : "revolute", translates() ? "H" : "Q");
        json_.member("bodies", translates() ? std::array{3, 1} : std::array{1, 3});
        if (translates()) json_.member("along", 90);
        json_.close().close().key("drivers").open('[').open('{').member("body", 2);
        number("omega", (cam_.omega / cam_.units.angular_velocity.si).to_double());
        json_.close().close().member("find", std::array{"instant centres", "velocity", "acceleration"});
        return json_.close().take() + '\n';
    }

private:
    void number(const char* key, double value) { json_.key(key).json(written(value)); }
    void place(const char* key, const Spot& place) {
        json_.key(key).open('[').json(written(place.x)).json(written(place.y)).close();
    }
    /// {"en": …, "it": …}: a language that says what English says is left out.
    void in_languages(const char* key, const Words& words) {
        json_.key(key).open('{');
        for (const Language language : languages)
            if (language == Language::en || words.in(language) != words.in(Language::en))
                json_.member(code_of(language), words.in(language));
        json_.close();
    }
    void circle(const char* centre, double radius) {
        json_.key("circle").open('{').member("centre", centre);
        number("radius", radius / unit_);
        json_.close();
    }
    /// The cam's own units; its angles are written in degrees.
    void write_units() {
        const Unit &length = cam_.units.length, &rate = cam_.units.angular_velocity;
        json_.key("units").open('{').member("length", length.symbol);
        if (rate.si != 1) json_.member("angular velocity", rate.symbol);
        json_.close();
    }
    bool translates() const { return cam_.follower.moves == Follower::Moves::translating; }
    bool is_flat() const { return cam_.follower.face == Follower::Face::flat; }
    bool is_roller() const { return cam_.follower.face == Follower::Face::roller; }
    const char* centre() const { return is_round_about_origin_ ? "O" : "K"; }
    void point(const char* name, const Spot& at) { place(name, (1 / unit_) * at); }

    /// P lies exactly on the line of the centres of curvature: along the roller's path, or across the face.
    void write_follower_points() {
        const Spot centre_of_curvature = state_.contact - (1 / state_.curvature) * state_.outward;
        const bool has_centre = !is_straight_ && !is_round_about_origin_;
        if (has_centre) point("K", centre_of_curvature);
        if (is_roller()) point("C", state_.trace);
        if (is_roller() && !is_straight_) {
            json_.key("P").open('{').member("from", "C").member("to", centre());
            number("distance", (state_.curvature > 0 ? 1 : -1) * cam_.follower.radius.to_double() / unit_);
            json_.close();
        } else {
            point("P", state_.contact);
        }
        if (translates()) {
            const double rise = 1.2 * cam_.base_circle.to_double();
            point("H", {is_flat() ? 0 : state_.trace.x, state_.trace.y + rise});
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
    void write_cam_body() {
        const bool is_disc =
            !is_straight_ && state_.curvature > 0 && state_.curvature * cam_.base_circle.to_double() > 0.3;
        json_.key("2").open('{').key("points").open('[').value("O");
        if (!is_straight_ && !is_round_about_origin_) json_.value("K");
        json_.close();
        if (is_disc || is_round_about_origin_) circle(centre(), 1 / state_.curvature);
        in_languages("label", lang::cams::cam);
        json_.close();
    }
    void write_follower_body() {
        json_.key("3").open('{').key("points").open('[').value(is_roller() ? "C" : is_flat() ? "F" : "P");
        json_.value(translates() ? "H" : "Q").close();
        if (is_roller()) circle("C", cam_.follower.radius.to_double());
        in_languages("label", lang::cams::follower);
        json_.close();
    }
    void write_contact() {
        const Spot along = turned_back(state_.outward);
        json_.open('{').member("contact", "P").member("bodies", std::array{3, 2}).key("profiles").open('{');
        json_.key("2").open('{');
        if (is_straight_)
            place("line", along);
        else
            json_.member("circle", centre());
        json_.close().key("3").open('{');
        if (is_flat())
            place("line", along);
        else if (is_roller())
            json_.member("circle", "C");
        else
            json_.member("tip", true);
        json_.close().close();
        place("pushes", state_.outward);
        json_.close();
    }

    const Cam& cam_;
    CamState state_;
    double unit_, turn_;
    bool is_straight_ = false, is_round_about_origin_ = false;
    JsonWriter json_;
};

}  // namespace

std::string mechanism_file_of(const Cam& cam, const CamGeometry& geometry, double turn) {
    return FileOfCam(cam, geometry, turn).text();
}

}  // namespace kinegraph
