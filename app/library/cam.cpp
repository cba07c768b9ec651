// Cams: the cam file, and the whole turn of a cam with every position solved as a mechanism.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <utility>

#include "app/library/cam_state.hpp"
#include "app/library/driver_choice.hpp"
#include "constructions/solving/solve.hpp"
#include "engine/file/units.hpp"
#include "lang/keys/cams.hpp"
#include "lang/keys/common.hpp"
#include "render/text/words.hpp"

namespace kinegraph {

template class Shared<const CamFile::State>;
template class Shared<const CamCycle::State>;

namespace {

/// Speed and acceleration of the follower as the solver finds them, m/s or rad/s; empty if it finds none.
struct Found {
    double speed = 0, acceleration = 0;
};
std::optional<Found> follower_of(const Solution& solution, bool translates, double rises) {
    if (translates) {
        for (const Sliding& each : solution.sliding)
            if (solution.mechanism.joint(each.joint).along && each.velocity && each.acceleration)
                return Found{each.velocity->y.to_double(), each.acceleration->y.to_double()};
        return std::nullopt;
    }
    const BodyMotion& body = solution.bodies.back();
    if (!body.omega || !body.alpha) return std::nullopt;
    return Found{rises * body.omega->to_double(), rises * body.alpha->to_double()};
}

tl::expected<Solution, Errors> solved_at_turn(const Cam& cam, const CamGeometry& geometry, double turn) {
    auto mechanism = read_mechanism(mechanism_file_of(cam, geometry, turn), cam.source);
    if (!mechanism) return tl::unexpected(mechanism.error());
    // The numbers are taken as exact: to compute in each position what their last digits leave open would triple the
    // time.
    mechanism->precision.reset();
    mechanism->find.instant_centres = false;
    return solve(*std::move(mechanism));
}

/// Solves every position as a mechanism; where the law jumps, uses the piece that begins there.
void compare_with_law(CamCycle::State& cycle) {
    double most_speed = 0, most_acceleration = 0, off_speed = 0, off_acceleration = 0;
    for (const CamState& state : cycle.states) {
        if (!std::isfinite(state.curvature)) continue;
        const auto solution = solved_at_turn(cycle.cam(), cycle.geometry(), state.turn);
        const auto found =
            solution ? follower_of(*solution, cycle.translates(), cycle.geometry().rises()) : std::nullopt;
        if (!found) {
            ++cycle.not_solved;
            continue;
        }
        ++cycle.solved;
        most_speed = std::max(most_speed, std::abs(cycle.speed(state)));
        most_acceleration = std::max(most_acceleration, std::abs(cycle.acceleration(state)));
        off_speed = std::max(off_speed, std::abs(found->speed - cycle.speed(state)));
        off_acceleration = std::max(off_acceleration, std::abs(found->acceleration - cycle.acceleration(state)));
    }
    if (most_speed > 0) cycle.difference = off_speed / most_speed;
    if (most_acceleration > 0) cycle.difference = std::max(cycle.difference, off_acceleration / most_acceleration);
}

/// The angle of the cam at which the mechanism is written and drawn, rad.
tl::expected<double, Words> turn_asked(const CamOptions& options, const Cam& cam) {
    const std::string& dashes = options.dashes;
    if (options.steps < 2) return tl::unexpected(Words(lang::common::at_least_2_steps, dashes));
    if (options.at.empty()) return 0.0;
    const auto turn = app::quantity_of(options.at, QuantityKind::angle, cam.units.angle.si);
    if (!turn) return tl::unexpected(dashes + "at " + turn.error());
    if (turn->sign() < 0 || *turn > 2 * pi())
        return tl::unexpected(Words(lang::cams::at_the_cam_turn_lies, dashes, options.at));
    return turn->to_double();
}

// --- texts for the designer ---

Words decimal_text(const char* form, double value, const std::string& unit) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), form, value == 0 ? 0 : std::abs(value));  // no "−0"
    return decimal_words((value < 0 ? "−" : "") + (text.data() + unit));
}
Words turn_text(double turn) { return decimal_text("%.4g", turn * 180 / std::numbers::pi, "°"); }
Words length_text(const Cam& cam, double length) {
    return decimal_text("%.4g", length / cam.units.length.si.to_double(), " " + cam.units.length.symbol);
}

Words undercut(const CamCycle::State& cycle, double first, double last) {
    const Words from = turn_text(first), to = turn_text(last);
    if (cycle.is_flat()) return {lang::cams::undercut_between_and_the_profile_turns, from, to};
    const auto lies_within = [&](double turn) {
        return first <= last ? first <= turn && turn <= last : turn >= first || turn <= last;
    };
    if (std::any_of(cycle.summary.corners.begin(), cycle.summary.corners.end(),
                    [&](const CamCorner& corner) { return corner.is_cut && lies_within(corner.after.turn); }))
        return {lang::cams::undercut_between_and_the_pitch_curve, from, to};
    return {lang::cams::undercut_between_and_the_pitch_curve_is, from, to};
}

}  // namespace

// --- state ---

CamCycle::State::State(CamFile cam, long steps, double turn)
    : file(std::move(cam)), at(turn), rate(std::abs(file.state().cam.omega.to_double())) {
    for (long i = 0; i <= steps; ++i)
        states.push_back(geometry().at(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(steps)));
    summary = summary_of(file.state().cam, geometry());
    compare_with_law(*this);
}

std::vector<Words> CamCycle::State::facts() const {
    std::vector<Words> said;
    said.emplace_back(lang::cams::largest_pressure_angle, turn_text(summary.most_pressure),
                      turn_text(summary.most_pressure_at));
    for (const auto& [from, to] : summary.undercuts) said.push_back(undercut(*this, from, to));
    if (summary.least_convex && summary.undercuts.empty())
        said.emplace_back(lang::cams::least_radius_of_curvature, length_text(cam(), *summary.least_convex),
                          turn_text(summary.least_convex_at));
    if (summary.least_concave)
        said.emplace_back(lang::cams::least_radius_of_curvature_of_the_profile,
                          length_text(cam(), *summary.least_concave), turn_text(summary.least_concave_at));
    if (summary.face)
        said.emplace_back(lang::cams::the_flat_face_is_touched, length_text(cam(), (*summary.face)[0]),
                          length_text(cam(), (*summary.face)[1]));
    return said;
}

/// Speeds are positive away from the cam, like the rise of the law.
std::vector<Words> CamCycle::State::jumps() const {
    const auto text = [&](const CamState& state) {
        return decimal_text("%.4g", speed(state), translates() ? " m/s" : " rad/s");
    };
    std::vector<Words> said;
    for (const CamCorner& corner : summary.corners)
        said.emplace_back(lang::cams::at_the_speed_of_the_follower, turn_text(corner.after.turn), text(corner.before),
                          text(corner.after));
    return said;
}

// --- public ---

CamFile::CamFile(Shared<const State> state) : state_(std::move(state)) {}
CamCycle::CamCycle(Shared<const State> state) : state_(std::move(state)) {}

Expected<CamFile> CamFile::parse(std::string_view text, std::string name) {
    auto cam = read_cam(text, std::move(name));
    if (!cam) return tl::unexpected(diagnostics_of(cam.error()));
    // The geometry refers to the cam, which must not move after this.
    auto* const state = new State(*std::move(cam));
    CamFile file{Shared<const State>(state)};
    auto geometry = CamGeometry::of(state->cam);
    if (!geometry) return tl::unexpected(diagnostics_of(geometry.error()));
    state->geometry = *geometry;
    return file;
}

Expected<CamFile> CamFile::open(const std::string& path) {
    const auto text = read_file(path, {lang::common::cam_file});
    if (!text) return tl::unexpected(text.error());
    return parse(*text, path.substr(path.rfind('/') + 1));
}

CamPosition CamFile::at(double turn) const {
    const CamState found = state().geometry.at(turn);
    return {found.turn, found.rise.s, {found.contact.x, found.contact.y}, found.pressure_angle, found.curvature};
}

std::vector<std::array<double, 2>> CamFile::profile(int positions) const {
    std::vector<std::array<double, 2>> places;
    for (const VectorOf<double>& each : working_profile(state().cam, state().geometry, positions))
        places.push_back({each.x, each.y});
    return places;
}

std::string CamFile::mechanism_at(double turn) const { return mechanism_file_of(state().cam, state().geometry, turn); }

Expected<CamCycle> CamCycle::of(const CamFile& cam, const CamOptions& options) {
    const auto turn = turn_asked(options, cam.state().cam);
    if (!turn) return refused(Diagnostic::Kind::bad_input, turn.error());
    return CamCycle(Shared<const State>(new State(cam, options.steps, *turn)));
}

std::string CamCycle::csv() const {
    const State& cycle = state();
    const double sense = cycle.geometry().sense();
    std::string text = "turn,time,s,v,a,";
    if (!cycle.is_flat()) text += "x pitch,y pitch,";
    text += "x profile,y profile,pressure angle,curvature\n";
    for (const CamState& state : cycle.states) {
        const VectorOf<double> pitch = state.on_cam(state.trace, sense);
        const VectorOf<double> profile = state.on_cam(state.contact, sense);
        if (!std::isfinite(state.curvature)) continue;
        std::vector<double> values{state.turn, state.turn / cycle.rate, state.rise.s, cycle.speed(state),
                                   cycle.acceleration(state)};
        if (!cycle.is_flat()) values.insert(values.end(), {pitch.x, pitch.y});
        values.insert(values.end(), {profile.x, profile.y, state.pressure_angle, state.curvature});
        for (std::size_t i = 0; i < values.size(); ++i) text += (i > 0 ? "," : "") + render::shortest(values[i]);
        text += '\n';
    }
    return text;
}

std::string CamCycle::mechanism() const { return state().file.mechanism_at(state().at); }
std::vector<Text> CamCycle::facts() const { return texts_of(state().facts()); }
std::vector<Text> CamCycle::remarks() const { return texts_of(state().jumps()); }
std::vector<Text> CamCycle::comparison() const {
    std::vector<Words> lines{{lang::cams::positions_solved_as_mechanisms_speed, std::to_string(state().solved),
                              decimal_text("%.1e", state().difference, "")}};
    if (state().not_solved > 0)
        lines.emplace_back(lang::cams::positions_have_no_unique_answer, std::to_string(state().not_solved));
    return texts_of(lines);
}
bool CamCycle::keeps_law() const { return state().summary.undercuts.empty() && state().not_solved == 0; }

}  // namespace kinegraph
