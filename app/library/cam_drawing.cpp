// Drawing of a cam: its curves and the construction behind them, the table of its motion.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/library/cam_state.hpp"
#include "constructions/solving/solve.hpp"
#include "engine/mechanism/law_breaks.hpp"
#include "engine/motion/closure.hpp"
#include "engine/number/functions.hpp"
#include "lang/keys/sheet.hpp"
#include "render/live/cam/cam_page.hpp"
#include "render/sheet/cam_notes.hpp"
#include "render/sheet/cycle_sheet.hpp"
#include "render/text/words.hpp"

namespace kinegraph {
namespace {

using Spot = VectorOf<double>;

/// The mechanism to draw, with the profile itself in place of the circle that replaces it at the contact.
tl::expected<Solution, Errors> drawn_at(const Cam& cam, const CamGeometry& geometry, double turn) {
    auto mechanism = read_mechanism(mechanism_file_of(cam, geometry, turn), cam.source);
    if (!mechanism) return tl::unexpected(mechanism.error());
    Body& body = mechanism->bodies[1];
    body.circle.reset();
    body.points.resize(1);
    std::erase_if(mechanism->joints, [](const Joint& joint) { return joint.pair().touches(); });
    mechanism->find = {};
    mechanism->find.stated = true;
    return solve(*std::move(mechanism));
}

/// Draws one cam in one language.
class CamScene {
public:
    CamScene(const CamCycle::State& cycle, Language language)
        : cycle_(cycle), cam_(cycle.cam()), geometry_(cycle.geometry()), language_(language) {}

    CycleTable table(const Solution& drawn) const {
        CycleTable table;
        table.driver = drawn.mechanism.bodies[1].name;
        table.travel.to = 2 * std::numbers::pi;
        table.is_of_cam = true;
        const auto add = [&](Column::Kind kind, const Quantity& quantity, std::string name, QuantityKind unit) {
            table.columns.push_back({kind, quantity, std::move(name), unit});
        };
        const auto add_named = [&](std::string name, QuantityKind unit, Key said) {
            add(Column::Kind::named, {}, std::move(name), unit);
            table.columns.back().said = said;
        };
        using Kind = Quantity::Kind;
        add(Column::Kind::turn, {}, "turn", QuantityKind::angle);
        if (cycle_.translates()) {
            const Quantity slides{.kind = Kind::sliding_velocity,
                                  .joint = JointIndex(drawn.mechanism.joints.size() - 1)};
            add(Column::Kind::slid, slides, "s", QuantityKind::length);
            add(Column::Kind::along, slides, "v", QuantityKind::velocity);
            add(Column::Kind::along, {.kind = Kind::sliding_acceleration, .joint = slides.joint}, "a",
                QuantityKind::acceleration);
        } else {
            // Away from the cam is not always counter-clockwise, so these are not ω and α.
            add_named("rise angle", QuantityKind::angle, lang::sheet::rise_angle);
            add_named("rise angle rate", QuantityKind::angular_velocity, lang::sheet::rise_angle_rate);
            add_named("rise angle acceleration", QuantityKind::angular_acceleration,
                      lang::sheet::rise_angle_acceleration);
        }
        add_named("pressure angle", QuantityKind::angle, lang::sheet::pressure_angle);
        for (const CamState& state : drawn_states()) {
            const auto [rise, speed, acceleration, pressure] = values_of(state);
            table.rows.push_back({state.turn, rise, speed, acceleration, pressure});
        }
        table.facts = cycle_.facts();
        for (Words& jump : cycle_.jumps()) table.facts.push_back(std::move(jump));
        return table;
    }
    /// Working profile, pitch curve and base circle in the position that is drawn, and the construction behind them.
    std::vector<render::Way> curves() const {
        constexpr int samples = 1440;
        render::Way profile{.name = "profile", .is_path = true, .places = {}, .outline = BodyIndex(1)},
            pitch{.name = "pitch curve",
                  .is_path = true,
                  .places = {},
                  .is_thin = true,
                  .label = named(lang::sheet::pitch_curve)},
            base{.name = "base circle",
                 .is_path = true,
                 .places = {},
                 .is_thin = true,
                 .label = named(lang::sheet::base_circle)};
        // On the side of the cam opposite to the follower.
        pitch.label_at = base.label_at = samples * 5 / 8;
        for (const Spot& place : working_profile(cam_, geometry_, samples)) profile.places.push_back(placed(place));
        for (int i = 0; i <= samples; ++i) {
            const double turn = 2 * std::numbers::pi * i / samples;
            const CamState state = geometry_.at(turn);
            pitch.places.push_back(placed(state, state.trace));
            base.places.push_back(circle_about({0, 0}, cam_.base_circle.to_double(), turn));
        }
        std::vector<render::Way> ways = inversion();
        ways.insert(ways.end(), {base, profile});
        if (cycle_.is_flat())
            ways.push_back(
                {.name = "plate", .is_path = true, .places = plate(geometry_.at(cycle_.at)), .outline = BodyIndex(2)});
        if (cam_.follower.face == Follower::Face::roller) ways.push_back(pitch);
        return ways;
    }

    /// At the beginning of the law, for the page on which the cam turns.
    render::CamPicture picture() const {
        constexpr int samples = 720;
        render::CamPicture picture;
        picture.profile = working_profile(cam_, geometry_, samples);
        picture.base = cam_.base_circle.to_double();
        const CamState first = geometry_.at(0);
        picture.trace = first.trace;
        if (cycle_.is_flat()) picture.face = plate(first);
        if (cam_.follower.face == Follower::Face::roller) {
            picture.roller = cam_.follower.radius.to_double();
            for (int i = 0; i <= samples; ++i) {
                const CamState state = geometry_.at(2 * std::numbers::pi * i / samples);
                picture.pitch.push_back(state.on_cam(state.trace, geometry_.sense()));
            }
        }
        if (!cycle_.translates())
            picture.pivot = Spot{cam_.follower.pivot.x.to_double(), cam_.follower.pivot.y.to_double()};
        return picture;
    }
    render::CamRows rows() const {
        constexpr int intervals = 720;
        render::CamRows rows;
        rows.columns.resize(4);
        for (int i = 0; i <= intervals; ++i) {
            const CamState state = geometry_.at(2 * std::numbers::pi * i / intervals);
            const std::array values = values_of(state);
            for (std::size_t column = 0; column < values.size(); ++column)
                rows.columns[column].push_back(values[column]);
            rows.states.push_back(state);
        }
        return rows;
    }

private:
    /// Rise, speed, acceleration, pressure angle.
    std::array<double, 4> values_of(const CamState& state) const {
        return {state.rise.s, cycle_.speed(state), cycle_.acceleration(state), state.pressure_angle};
    }
    /// As many states as a plot shows; where the law jumps, both sides.
    std::vector<CamState> drawn_states() const {
        const std::vector<LawBreak> breaks = breaks_of_cycle(cam_.law);
        // A jump at the beginning of the law lies on the edge of the plot.
        auto next = std::find_if(breaks.begin(), breaks.end(), [](const LawBreak& each) { return each.at > 0; });
        constexpr double same = 1e-12;
        const std::size_t stride = std::max<std::size_t>(1, (cycle_.states.size() - 1) / 3600);
        std::vector<CamState> drawn;
        for (std::size_t i = 0; i < cycle_.states.size(); i += stride) {
            bool is_break = false;
            for (; next != breaks.end() && next->at <= cycle_.states[i].turn + same; ++next) {
                for (const LawState& side : {next->before, next->after}) drawn.push_back(geometry_.at(next->at, side));
                is_break = next->at >= cycle_.states[i].turn - same;
            }
            if (!is_break) drawn.push_back(cycle_.states[i]);
        }
        return drawn;
    }
    /// Transforms from the cam to the position that is drawn.
    Spot placed(const Spot& on_cam) const {
        const double angle = geometry_.sense() * cycle_.at;
        return faced(Spot{nearest::cos(angle), nearest::sin(angle)}, on_cam);
    }
    Spot placed(const CamState& state, const Spot& place) const {
        return placed(state.on_cam(place, geometry_.sense()));
    }
    render::RichText named(Key key) const { return render::one_piece(render::word(key, language_)); }

    static Spot circle_about(const Spot& centre, double radius, double angle) {
        return centre + radius * Spot{nearest::cos(angle), nearest::sin(angle)};
    }
    /// Kinematic inversion: the cam fixed, the follower turned round it against the cam's rotation, in twelve numbered
    /// positions from the beginning of the law.
    std::vector<render::Way> inversion() const {
        constexpr int positions = 12, corners = 48;
        std::vector<render::Way> ways;
        for (int k = 0; k < positions; ++k) {
            const CamState state = geometry_.at(2 * std::numbers::pi * k / positions);
            render::Way way{
                .name = "3", .places = line_of_follower(state), .label = render::one_piece(std::to_string(k))};
            for (Spot& place : way.places) place = placed(state, place);
            way.label_at = way.places.size() - 1;
            ways.push_back(std::move(way));
            if (cam_.follower.face != Follower::Face::roller) continue;
            render::Way roller{.name = "3", .places = {}};
            for (int i = 0; i <= corners; ++i)
                roller.places.push_back(placed(state, circle_about(state.trace, cam_.follower.radius.to_double(),
                                                                   2 * std::numbers::pi * i / corners)));
            ways.push_back(std::move(roller));
        }
        return ways;
    }
    /// The line of motion of the follower, seen from the frame, from the beginning of the law to past its position; the
    /// flat face; the arm from its pivot.
    std::vector<Spot> line_of_follower(const CamState& state) const {
        const double base = cam_.base_circle.to_double();
        if (cycle_.is_flat()) {
            // Long enough to intersect its neighbours.
            const Spot half = 0.6 * base * quarter_turn(state.outward);
            return {state.contact - half, state.contact + half};
        }
        if (cycle_.translates())
            return {{state.trace.x, state.trace.y - state.rise.s},
                    {state.trace.x, state.trace.y + cam_.follower.radius.to_double() + 0.2 * base}};
        return {state.trace, {cam_.follower.pivot.x.to_double(), cam_.follower.pivot.y.to_double()}};
    }
    /// A flat face, perpendicular to the motion: as long as the part touched over the whole turn, with a margin at both
    /// ends.
    std::vector<Spot> plate(const CamState& state) const {
        constexpr double beyond = 0.12, thickness = 0.09;  // of the base circle's radius
        const double radius = cam_.base_circle.to_double();
        const Spot along = quarter_turn(state.outward), foot = dot(state.outward, state.contact) * state.outward;
        const Spot from = foot + ((*cycle_.summary.face)[0] - beyond * radius) * along;
        const Spot to = foot + ((*cycle_.summary.face)[1] + beyond * radius) * along;
        const Spot up = thickness * radius * state.outward;
        return {from, to, to + up, from + up, from};
    }

    const CamCycle::State& cycle_;
    const Cam& cam_;
    const CamGeometry& geometry_;
    Language language_;
};

}  // namespace

Expected<Drawing> draw(const CamCycle& cycle, const DrawingOptions& options) {
    return drawing_of(
        options,
        [&](const render::SheetOptions& sheet, const render::Fonts& fonts,
            std::vector<Text>&) -> Expected<std::vector<render::Page>> {
            const CamCycle::State& state = cycle.state();
            const auto drawn = drawn_at(state.cam(), state.geometry(), state.at);
            if (!drawn) return tl::unexpected(diagnostics_of(drawn.error()));
            const CamScene scene(state, sheet.language);
            const CycleTable rows = scene.table(*drawn);
            const render::CamNotes notes =
                render::notes_of(state.cam(), state.geometry(), state.at, rows, drawn->mechanism, sheet.language);
            return render::lay_out_cycle(*drawn, rows, {{1}, {2}, {3}, {4}}, scene.curves(), sheet, fonts, &notes);
        });
}

Expected<LivePage> live_page(const CamCycle& cycle, const DrawingOptions& options) {
    const auto sheet = sheet_options_of(options);
    if (!sheet) return tl::unexpected(sheet.error());
    const CamCycle::State& state = cycle.state();
    const auto drawn = drawn_at(state.cam(), state.geometry(), 0);
    if (!drawn) return tl::unexpected(diagnostics_of(drawn.error()));
    const CamScene scene(state, sheet->language);
    const CycleTable table = scene.table(*drawn);
    const render::CamNotes notes =
        render::notes_of(state.cam(), state.geometry(), 0, table, drawn->mechanism, sheet->language);
    std::vector<std::string> facts;
    for (const Words& fact : table.facts) facts.push_back(fact.in(sheet->language));
    return LivePage{render::cam_page(state.cam().title, state.geometry(), scene.picture(), scene.rows(), table, notes,
                                     facts, drawn->mechanism, *sheet, dark_beside(options)),
                    {}};
}

}  // namespace kinegraph
