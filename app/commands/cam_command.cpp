// cam FILE: computes the disc cam that gives its follower a law, solves every position of it as a mechanism and
// compares the result with the law.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include "app/commands/commands.hpp"
#include "app/commands/outputs.hpp"
#include "app/library/driver_choice.hpp"
#include "constructions/solving/solve.hpp"
#include "engine/file/units.hpp"
#include "engine/mechanism/cam.hpp"
#include "engine/motion/closure.hpp"
#include "render/sheet/cam_notes.hpp"
#include "render/sheet/cycle_sheet.hpp"
#include "render/text/words.hpp"

namespace kinegraph::app {
namespace {

using Spot = VectorOf<double>;

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

/// The same for drawing, with the profile itself in place of the circle that replaces it at the contact.
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

void append(std::string& text, double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value == 0 ? 0.0 : value);
    text.append(digits.data(), end.ptr);
}

class CamRun {
public:
    CamRun(const CamRequest& request, const Cam& cam, const CamGeometry& geometry, double at)
        : request_(request), cam_(cam), geometry_(geometry), at_(at), rate_(std::abs(cam.omega.to_double())) {}

    Status run(const std::vector<Target>& targets) {
        const auto theme = theme_of(request_.theme, request_.file, language());
        if (!theme) return theme.error();
        fill_rows();
        summary_ = summary_of(cam_, geometry_);
        confirm();
        for (const Words& jump : jumps()) remarks_.push_back(render::in(jump, language()));
        std::vector<Output> outputs;
        const bool draws =
            std::any_of(targets.begin(), targets.end(), [](const Target& target) { return target.is_drawn(); });
        for (const Target& target : targets) {
            if (target.format == Format::csv) outputs.push_back({target.path, csv()});
            if (target.format == Format::json)
                outputs.push_back({target.path, mechanism_file_of(cam_, geometry_, at_)});
        }
        if (draws)
            if (const auto status = draw(targets, *theme, outputs)) return *status;
        if (names_clash(outputs, request_.file, language())) return Status::bad_input;
        if (const auto failure = write_all(outputs)) return fail_to_write(*failure, language());
        for (const Words& line : facts()) say_line(line);
        for (const std::string& remark : remarks_)
            say_line(Words(render::word("a remark", language()) + ": " + remark));
        say_confirmed();
        return !summary_.undercuts.empty() || not_solved_ > 0 ? Status::unsolved : Status::done;
    }

private:
    Language language() const { return request_.sheet.language; }
    void say_line(const Words& line) const { say(spoken(request_.file), line, language()); }
    bool translates() const { return cam_.follower.moves == Follower::Moves::translating; }
    bool is_flat() const { return cam_.follower.face == Follower::Face::flat; }

    void fill_rows() {
        for (long i = 0; i <= request_.steps; ++i)
            states_.push_back(
                geometry_.at(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(request_.steps)));
    }
    double speed(const CamState& state) const { return state.rise.first * rate_; }
    double acceleration(const CamState& state) const { return state.rise.second * rate_ * rate_; }

    /// Solves every position as a mechanism; where the law jumps, uses the piece that begins there.
    void confirm() {
        double most_speed = 0, most_acceleration = 0, off_speed = 0, off_acceleration = 0;
        for (const CamState& state : states_) {
            if (!std::isfinite(state.curvature)) continue;
            const auto solution = solved_at_turn(cam_, geometry_, state.turn);
            const auto found = solution ? follower_of(*solution, translates(), geometry_.rises()) : std::nullopt;
            if (!found) {
                ++not_solved_;
                continue;
            }
            ++solved_;
            most_speed = std::max(most_speed, std::abs(speed(state)));
            most_acceleration = std::max(most_acceleration, std::abs(acceleration(state)));
            off_speed = std::max(off_speed, std::abs(found->speed - speed(state)));
            off_acceleration = std::max(off_acceleration, std::abs(found->acceleration - acceleration(state)));
        }
        if (most_speed > 0) difference_ = off_speed / most_speed;
        if (most_acceleration > 0) difference_ = std::max(difference_, off_acceleration / most_acceleration);
    }
    void say_confirmed() const {
        std::array<char, 32> share{};
        std::snprintf(share.data(), share.size(), "%.1e", difference_);
        say_line(
            {"{0} positions solved as mechanisms: speed and acceleration of the follower differ from the law by {1} of "
             "the "
             "largest at most",
             "{0} posizioni risolte come meccanismi: velocità e accelerazione della punteria differiscono dalla legge "
             "al più di "
             "{1} della maggiore",
             std::to_string(solved_), decimal(share.data())});
        if (not_solved_ > 0)
            say_line({"{0} positions have no unique answer", "{0} posizioni non hanno risposta unica",
                      std::to_string(not_solved_)});
    }

    // --- values for the designer ---
    Words turn_text(double turn) const {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%.4g°", turn * 180 / std::numbers::pi);
        return decimal(text.data());
    }
    Words length_text(double length) const {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%.4g ", length / cam_.units.length.si.to_double());
        return decimal(text.data() + cam_.units.length.symbol);
    }
    std::vector<Words> facts() const {
        std::vector<Words> said;
        said.emplace_back("largest pressure angle: {0} at {1}", "massimo angolo di pressione: {0} a {1}",
                          turn_text(summary_.most_pressure), turn_text(summary_.most_pressure_at));
        for (const auto& [from, to] : summary_.undercuts) said.push_back(undercut(from, to));
        if (summary_.least_convex && summary_.undercuts.empty())
            said.emplace_back("least radius of curvature of the profile, convex: {0} at {1}",
                              "minimo raggio di curvatura del profilo, convesso: {0} a {1}",
                              length_text(*summary_.least_convex), turn_text(summary_.least_convex_at));
        if (summary_.least_concave)
            said.emplace_back("least radius of curvature of the profile, hollow: {0} at {1}",
                              "minimo raggio di curvatura del profilo, concavo: {0} a {1}",
                              length_text(*summary_.least_concave), turn_text(summary_.least_concave_at));
        if (summary_.face)
            said.emplace_back(
                "the flat face is touched from {0} to {1}, counted from the foot of its normal through the cam’s "
                "centre",
                "il piattello è toccato da {0} a {1}, contati dal piede della sua normale per il centro della camma",
                length_text((*summary_.face)[0]), length_text((*summary_.face)[1]));
        return said;
    }

    Words undercut(double first, double last) const {
        const Words from = turn_text(first), to = turn_text(last);
        if (is_flat())
            return {
                "undercut between {0} and {1}: the profile turns back there, and the follower will not keep its law; "
                "take a "
                "larger base radius",
                "sottotaglio fra {0} e {1}: lì il profilo torna indietro, e la punteria non seguirà la legge; prendere "
                "un raggio "
                "di base maggiore",
                from, to};
        const auto lies_within = [&](double turn) {
            return first <= last ? first <= turn && turn <= last : turn >= first || turn <= last;
        };
        if (std::any_of(summary_.corners.begin(), summary_.corners.end(),
                        [&](const CamCorner& corner) { return corner.is_cut && lies_within(corner.after.turn); }))
            return {
                "undercut between {0} and {1}: the pitch curve has a convex corner there, which no roller leaves, and "
                "the follower "
                "will not keep its law; take a law whose speed does not jump",
                "sottotaglio fra {0} e {1}: lì la curva primitiva ha uno spigolo convesso, che nessuna rotella può "
                "percorrere, e la "
                "punteria non seguirà la legge; prendere una legge senza salti di velocità",
                from, to};
        return {
            "undercut between {0} and {1}: the pitch curve is tighter than the roller there, and the follower will not "
            "keep its "
            "law; take a larger base radius or a smaller roller",
            "sottotaglio fra {0} e {1}: lì la curva primitiva è più stretta della rotella, e la punteria non seguirà "
            "la legge; "
            "prendere un raggio di base maggiore o una rotella minore",
            from, to};
    }
    /// Speeds are positive away from the cam, like the rise of the law.
    std::vector<Words> jumps() const {
        const auto text = [&](const CamState& state) {
            std::array<char, 32> value{};
            std::snprintf(value.data(), value.size(), "%.4g ", speed(state));
            return decimal(value.data() + std::string(translates() ? "m/s" : "rad/s"));
        };
        std::vector<Words> said;
        for (const CamCorner& corner : summary_.corners)
            said.emplace_back(
                "at {0} the speed of the follower jumps from {1} to {2}: its acceleration is infinite there (a shock)",
                "a {0} la velocità della punteria salta da {1} a {2}: lì l’accelerazione è infinita (urto)",
                turn_text(corner.after.turn), text(corner.before), text(corner.after));
        return said;
    }

    // --- rows ---
    std::string csv() const {
        std::string text = "turn,time,s,v,a,";
        if (!is_flat()) text += "x pitch,y pitch,";
        text += "x profile,y profile,pressure angle,curvature\n";
        for (const CamState& state : states_) {
            const Spot pitch = state.on_cam(state.trace, geometry_.sense());
            const Spot profile = state.on_cam(state.contact, geometry_.sense());
            if (!std::isfinite(state.curvature)) continue;
            std::vector<double> values{state.turn, state.turn / rate_, state.rise.s, speed(state), acceleration(state)};
            if (!is_flat()) values.insert(values.end(), {pitch.x, pitch.y});
            values.insert(values.end(), {profile.x, profile.y, state.pressure_angle, state.curvature});
            for (std::size_t i = 0; i < values.size(); ++i) {
                if (i > 0) text += ',';
                append(text, values[i]);
            }
            text += '\n';
        }
        return text;
    }

    // --- the sheet ---
    CycleTable table(const Solution& drawn) const {
        CycleTable table;
        table.driver = drawn.mechanism.bodies[1].name;
        table.travel.to = 2 * std::numbers::pi;
        table.is_of_cam = true;
        const auto add = [&](Column::Kind kind, const Quantity& quantity, std::string name, QuantityKind unit) {
            table.columns.push_back({kind, quantity, std::move(name), unit});
        };
        using Kind = Quantity::Kind;
        add(Column::Kind::turn, {}, "turn", QuantityKind::angle);
        if (translates()) {
            const Quantity slides{.kind = Kind::sliding_velocity,
                                  .joint = JointIndex(drawn.mechanism.joints.size() - 1)};
            add(Column::Kind::slid, slides, "s", QuantityKind::length);
            add(Column::Kind::along, slides, "v", QuantityKind::velocity);
            add(Column::Kind::along, {.kind = Kind::sliding_acceleration, .joint = slides.joint}, "a",
                QuantityKind::acceleration);
        } else {
            // Away from the cam is not always counter-clockwise, so these are not ω and α.
            add(Column::Kind::named, {}, "rise angle", QuantityKind::angle);
            add(Column::Kind::named, {}, "rise angle rate", QuantityKind::angular_velocity);
            add(Column::Kind::named, {}, "rise angle acceleration", QuantityKind::angular_acceleration);
        }
        add(Column::Kind::named, {}, "pressure angle", QuantityKind::angle);
        for (const CamState& state : drawn_states())
            table.rows.push_back({state.turn, state.rise.s, speed(state), acceleration(state), state.pressure_angle});
        for (const Words& fact : facts()) table.facts.push_back(fact);
        for (const Words& jump : jumps()) table.facts.push_back(jump);
        return table;
    }
    /// As many states as a plot shows; where the law jumps, both sides.
    std::vector<CamState> drawn_states() const {
        const std::vector<LawBreak> breaks = breaks_of_cycle(cam_.law);
        // A jump at the beginning of the law lies on the edge of the plot.
        auto next = std::find_if(breaks.begin(), breaks.end(), [](const LawBreak& each) { return each.at > 0; });
        constexpr double same = 1e-12;
        const auto stride = static_cast<std::size_t>(std::max(1L, request_.steps / 3600));
        std::vector<CamState> drawn;
        for (std::size_t i = 0; i < states_.size(); i += stride) {
            bool is_break = false;
            for (; next != breaks.end() && next->at <= states_[i].turn + same; ++next) {
                for (const LawState& side : {next->before, next->after}) drawn.push_back(geometry_.at(next->at, side));
                is_break = next->at >= states_[i].turn - same;
            }
            if (!is_break) drawn.push_back(states_[i]);
        }
        return drawn;
    }
    /// Transforms from the cam to the position that is drawn.
    Spot placed(const Spot& on_cam) const {
        const double angle = geometry_.sense() * at_;
        return faced(Spot{std::cos(angle), std::sin(angle)}, on_cam);
    }
    Spot placed(const CamState& state, const Spot& place) const {
        return placed(state.on_cam(place, geometry_.sense()));
    }
    render::RichText named(const char* key) const { return render::one_piece(render::word(key, language())); }

    /// Working profile, pitch curve and base circle in the position that is drawn, and the construction behind them.
    std::vector<render::Way> curves() const {
        constexpr int samples = 1440;
        render::Way profile{.name = "profile", .is_path = true, .places = {}, .outline = BodyIndex(1)},
            pitch{.name = "pitch curve", .is_path = true, .places = {}, .is_thin = true, .label = named("pitch curve")},
            base{.name = "base circle", .is_path = true, .places = {}, .is_thin = true, .label = named("base circle")};
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
        if (is_flat()) ways.push_back(plate());
        if (cam_.follower.face == Follower::Face::roller) ways.push_back(pitch);
        return ways;
    }
    static Spot circle_about(const Spot& centre, double radius, double angle) {
        return centre + radius * Spot{std::cos(angle), std::sin(angle)};
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
        if (is_flat()) {
            // Long enough to intersect its neighbours.
            const Spot half = 0.6 * base * quarter_turn(state.outward);
            return {state.contact - half, state.contact + half};
        }
        if (translates())
            return {{state.trace.x, state.trace.y - state.rise.s},
                    {state.trace.x, state.trace.y + cam_.follower.radius.to_double() + 0.2 * base}};
        return {state.trace, {cam_.follower.pivot.x.to_double(), cam_.follower.pivot.y.to_double()}};
    }
    /// A flat face, perpendicular to the motion: as long as the part touched over the whole turn, with a margin at both
    /// ends.
    render::Way plate() const {
        constexpr double beyond = 0.12, thickness = 0.09;  // of the base circle's radius
        const double radius = cam_.base_circle.to_double();
        const CamState state = geometry_.at(at_);
        const Spot along = quarter_turn(state.outward), foot = dot(state.outward, state.contact) * state.outward;
        const Spot from = foot + ((*summary_.face)[0] - beyond * radius) * along;
        const Spot to = foot + ((*summary_.face)[1] + beyond * radius) * along;
        const Spot up = thickness * radius * state.outward;
        return {
            .name = "plate", .is_path = true, .places = {from, to, to + up, from + up, from}, .outline = BodyIndex(2)};
    }
    /// Returns a status after an error was reported.
    std::optional<Status> draw(const std::vector<Target>& targets, const render::Theme& theme,
                               std::vector<Output>& outputs) {
        auto drawn = drawn_at(cam_, geometry_, at_);
        if (!drawn) return say(spoken(request_.file), drawn.error(), language());
        const auto press =
            OutputWriter::open(targets, language(), request_.live_text ? Lettering::live : Lettering::outlines);
        if (!press) return press.error();
        render::SheetOptions options = request_.sheet;
        options.theme = theme;
        const CycleTable rows = table(*drawn);
        const render::CamNotes notes = render::notes_of(cam_, geometry_, at_, rows, drawn->mechanism, language());
        const auto pages =
            render::lay_out_cycle(*drawn, rows, {{1}, {2}, {3}, {4}}, curves(), options, press->fonts(), &notes);
        for (const Target& target : targets)
            if (target.is_drawn()) press->print(pages, target, request_.dpi, outputs, remarks_);
        press->remark_missing(remarks_);
        return std::nullopt;
    }

    const CamRequest& request_;
    const Cam& cam_;
    const CamGeometry& geometry_;
    double at_, rate_;
    std::vector<CamState> states_;
    CamSummary summary_;
    long solved_ = 0, not_solved_ = 0;
    double difference_ = 0;
    std::vector<std::string> remarks_;
};

/// The angle of the cam at which the mechanism is written and drawn, rad.
tl::expected<double, Words> turn_asked(const CamRequest& request, const Cam& cam) {
    if (request.steps < 2)
        return tl::unexpected(Words("--steps: at least 2 are needed", "--steps: ne occorrono almeno 2"));
    if (request.at.empty()) return 0.0;
    const auto turn = quantity_of(request.at, QuantityKind::angle, cam.units.angle.si);
    if (!turn) return tl::unexpected(std::string("--at ") + turn.error());
    if (turn->sign() < 0 || *turn > 2 * pi())
        return tl::unexpected(Words("--at {0}: the cam's turn lies between 0 and 360°",
                                    "--at {0}: la rotazione della camma è fra 0 e "
                                    "360°",
                                    request.at));
    return turn->to_double();
}

}  // namespace

Status cam_command(const CamRequest& request) {
    const Language language = request.sheet.language;
    constexpr std::array formats{Format::csv, Format::json, Format::svg, Format::png, Format::pdf, Format::tex};
    auto targets = targets_of(request.outputs, request.format, request.file, formats);
    if (!targets) return refuse(targets.error(), language);
    if (targets->empty()) targets->push_back({"-", Format::csv});
    const auto text = read_whole(request.file, {"cam file", "file di camma"});
    if (!text) {
        say(spoken(request.file), text.error(), language);
        return Status::bad_input;
    }
    const auto cam = read_cam(*text, bare_name(request.file));
    if (!cam) return say(spoken(request.file), cam.error(), language);
    const auto geometry = CamGeometry::of(*cam);
    if (!geometry) return say(spoken(request.file), geometry.error(), language);
    const auto at = turn_asked(request, *cam);
    if (!at) {
        say(spoken(request.file), at.error(), language);
        return Status::bad_input;
    }
    return CamRun(request, *cam, *geometry, *at).run(*targets);
}

}  // namespace kinegraph::app
