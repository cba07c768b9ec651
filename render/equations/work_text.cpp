#include "render/equations/chapters.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/number/functions.hpp"
#include "engine/solution/solution.hpp"
#include "lang/keys/equations.hpp"
#include "lang/keys/sheet.hpp"
#include "render/equations/equation_chapters.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

using Entry = VirtualWork::Entry;
using Share = VirtualWork::Share;

constexpr int digits_of_work = 4;

/// The subscript of δ for a coordinate: the rotating body, the sliding joint or the moved point.
std::pair<std::string, std::string> letter_of(const Mechanism& mechanism, const Driver& driver) {
    if (const auto* spin = std::get_if<SpinDriver>(&driver)) {
        const std::string body = mechanism.body(spin->body).name;
        return {"theta", spin->relative_to == frame ? body : body + "," + mechanism.body(spin->relative_to).name};
    }
    if (const auto* slide = std::get_if<SlideDriver>(&driver)) return {"s", mechanism.joint(slide->joint).name};
    return {"s", mechanism.point(std::get<PointDriver>(driver).at).name};
}

/// Notation of displacements, loads and works, in the file's units.
class WorkFormulas {
protected:
    WorkFormulas(const Solution& solution, Language language)
        : solution_(solution), mechanism_(solution.mechanism), found_(*solution.displacements), language_(language) {}

    std::string in(const Words& words) const { return kinegraph::in(words, language_); }
    Formula upright(const std::string& text) const { return Formula::upright(text); }
    Formula number_of(double value) const { return upright(render::number(value, digits_of_work, language_)); }
    std::string written(double value) const { return render::number(value, digits_of_work, language_); }
    /// "O_2".
    static Formula named(const std::string& name) {
        std::size_t stem = name.find('_');
        if (stem != std::string::npos && stem > 0) return Formula::letter(name.substr(0, stem), name.substr(stem + 1));
        stem = name.size();
        while (stem > 1 && name[stem - 1] >= '0' && name[stem - 1] <= '9') --stem;
        return Formula::letter(name.substr(0, stem), name.substr(stem));
    }
    static Formula force(const Symbol& symbol) {
        if (has_own_name(symbol)) return named(symbol.about);
        return Formula::letter(symbol.letter == Symbol::Letter::M ? "M" : "F", symbol.about);
    }
    Symbol symbol_of(int effort) const {
        const Effort& given = mechanism_.efforts[at_index(effort)];
        const std::string& name = std::visit([](const auto& each) -> const std::string& { return each.name; }, given);
        return {std::holds_alternative<CoupleEffort>(given) ? Symbol::Letter::M : Symbol::Letter::F, name, {}};
    }
    bool is_couple(int effort) const {
        return std::holds_alternative<CoupleEffort>(mechanism_.efforts[at_index(effort)]);
    }
    const std::string& body(BodyIndex index) const { return mechanism_.body(index).name; }
    Formula coordinate(const Displacements::Freedom& freedom, bool delta) const {
        const auto [letter, sub] = letter_of(mechanism_, freedom.driver);
        Formula own = Formula::letter(letter, sub);
        return delta ? Formula::letter("delta") + std::move(own) : own;
    }
    std::string spoken(const Displacements::Freedom& freedom) const {
        const auto [letter, sub] = letter_of(mechanism_, freedom.driver);
        return "{δ}{" + unicode_letter(letter) + "_" + sub + "}";
    }
    std::string point_at(const Vector& place) const {
        for (const PointIndex point : indices_of(mechanism_.points))
            if (solution_.pose.at(point) == place) return mechanism_.point(point).name;
        return {};
    }
    /// The point at which an input force acts.
    PointIndex point_of(int effort) const {
        const Effort& given = mechanism_.efforts[at_index(effort)];
        if (const auto* at = std::get_if<ForceEffort>(&given)) return at->at;
        return mechanism_.joint(std::get<ActuatorEffort>(given).joint).point;
    }
    // Units per unit of δq.

    const Unit& length() const { return mechanism_.units.length; }
    std::string per() const { return turn_ ? "/rad" : ""; }
    std::string way_unit() const { return turn_ ? length().symbol + "/rad" : std::string(); }
    double way_si() const { return turn_ ? length().si.to_double() : 1; }
    const Unit& work_unit() const { return turn_ ? mechanism_.units.moment : mechanism_.units.force; }
    std::string turn_unit() const { return turn_ ? std::string() : "rad/" + length().symbol; }
    double turn_si() const { return turn_ ? 1 : 1 / length().si.to_double(); }
    Formula with_unit(Formula name, const std::string& unit) const {
        return unit.empty() ? std::move(name) : std::move(name) + upright(", " + unit);
    }
    Formula pair_of(double x, double y) const {
        return upright(render::pair_of(written(clean(x)), written(clean(y)), language_));
    }
    /// Without −0 and rounding noise.
    double clean(double value) const { return std::abs(value) < 1e-14 * largest_ ? 0 : value; }
    Formula moved_point(const std::string& point) const {
        return Formula::letter("delta") + Formula::letter("r", point.empty() ? "?" : point);
    }
    /// Work of an input force or couple in the file's units, per unit of it.
    Formula per_effort(double si, int effort) const {
        const double unit =
            is_couple(effort) ? mechanism_.units.moment.si.to_double() : mechanism_.units.force.si.to_double();
        return upright(written(si * unit / work_unit().si.to_double()));
    }
    Formula work_of(double si) const { return upright(written(si / work_unit().si.to_double())); }
    Formula turned(const std::string& of, double omega, const Formula& q) const {
        Formula moved =
            Formula::letter("delta") + Formula::letter("theta", of) + Formula::sign("=") + number_of(omega / turn_si());
        if (!turn_unit().empty()) moved += upright(" " + turn_unit());
        return std::move(moved) + q;
    }
    std::string amount_of(int effort, double si) const {
        return amount(si, is_couple(effort) ? QuantityKind::moment : QuantityKind::force, mechanism_.units, language_,
                      5);
    }

    const Solution& solution_;
    const Mechanism& mechanism_;
    const Displacements& found_;
    Language language_;
    bool turn_ = true;    // the displaced coordinate is an angle
    double largest_ = 0;  // relative to which smaller numbers vanish
};

class WorkText : WorkFormulas, closure::EquationList {
public:
    WorkText(const Solution& solution, Language language) : WorkFormulas(solution, language), EquationList(language) {}

    std::vector<EquationItem> items() {
        heading({lang::equations::virtual_work}, true);
        if (!found_.why_not.empty()) {
            say(Words(lang::equations::there_are_no_virtual_displacements, found_.why_not));
            return taken();
        }
        for (std::size_t i = 0; i < found_.freedoms.size(); ++i) write_drawn(i);
        write_efforts();
        write_ratios();
        return taken();
    }

private:
    // --- the displacements drawn
    // ----------------------------------------------------------------------------------------------

    void write_drawn(std::size_t i) {
        const Displacements::Freedom& freedom = found_.freedoms[i];
        turn_ = is_turn(freedom.driver);
        say_what_moves(freedom);
        const VirtualWork& work = *freedom.moved->virtual_work;
        const Formula q = coordinate(freedom, true);
        std::vector<std::vector<Formula>> rows{{upright(in({lang::equations::action})),
                                                upright(in({lang::equations::on_body})),
                                                with_unit(Formula::letter("F"), mechanism_.units.force.symbol) +
                                                    upright("  " + in({lang::equations::or_word}) + " ") +
                                                    with_unit(Formula::letter("M"), mechanism_.units.moment.symbol),
                                                upright(in({lang::equations::displaced_by})),
                                                upright(in({lang::equations::work}) + ", " + work_unit().symbol)}};
        for (const Entry& entry : work.entries) {
            if (!entry.force.is_zero()) rows.push_back(force_row(entry, freedom.moved->mechanism.loads, q));
            if (!entry.couple.is_zero()) rows.push_back(couple_row(entry, q));
        }
        for (const Share& share : work.shares) rows.push_back(share_row(share, q));
        table(std::move(rows));
        announce({lang::equations::ideal_pairs_do_no_work});
        set(Formula::letter("delta") + Formula::letter(notation(language_).work) + Formula::sign("=") + symbols(work) +
            Formula::sign("=") + upright("0"));
        set(numbers(work.total.to_double(), work, q) + Formula::sign("=") + upright("0"));
    }
    void say_what_moves(const Displacements::Freedom& freedom) {
        const std::string others =
            found_.freedoms.size() > 1 ? in({lang::equations::the_other_coordinates_are_held_still}) : std::string();
        const auto said = [&](const Words& words) { say_text(in(words) + others); };
        if (freedom.chosen)
            said(Words(lang::equations::constraints_held_as_they_stand, spoken(freedom)));
        else
            said(Words(lang::equations::constraints_held_as_they_stand_the_driven, spoken(freedom)));
    }
    /// The body, or the pin that bears the load. `loads`: those of the displaced mechanism, inertia forces among them.
    std::string acts_on(const Entry& entry, const std::vector<Load>& loads) const {
        const auto* load = entry.quantity.kind == Quantity::Kind::load
                               ? std::get_if<ForceLoad>(&loads[at_index(entry.quantity.given)])
                               : nullptr;
        if (load == nullptr || load->body != none) return body(entry.body);
        return word(lang::sheet::pin, language_) + " " + mechanism_.point(load->at).name;
    }
    std::vector<Formula> force_row(const Entry& entry, const std::vector<Load>& loads, const Formula& q) {
        const double fx = entry.force.x.to_double() / mechanism_.units.force.si.to_double(),
                     fy = entry.force.y.to_double() / mechanism_.units.force.si.to_double();
        largest_ = nearest::hypot(fx, fy);
        Formula acting = pair_of(fx, fy);
        return {force(entry.symbol), upright(acts_on(entry, loads)), std::move(acting),
                way(point_at(entry.at), entry.velocity, q), work_of(dot(entry.force, entry.velocity).to_double())};
    }
    /// "δr_A = (0.2; −0.1) m/rad δθ_1".
    Formula way(const std::string& point, const Vector& velocity, const Formula& q) {
        const double x = velocity.x.to_double() / way_si(), y = velocity.y.to_double() / way_si();
        largest_ = nearest::hypot(x, y);
        Formula moved = moved_point(point) + Formula::sign("=") + pair_of(x, y);
        if (!way_unit().empty()) moved += upright(" " + way_unit());
        return std::move(moved) + q;
    }
    std::vector<Formula> couple_row(const Entry& entry, const Formula& q) const {
        Symbol symbol = entry.symbol;
        symbol.letter = Symbol::Letter::M;
        return {force(symbol), upright(body(entry.body)),
                number_of(entry.couple.to_double() / mechanism_.units.moment.si.to_double()),
                turned(body(entry.body), entry.omega.to_double(), q),
                work_of((entry.couple * entry.omega).to_double())};
    }
    /// The unknown input forces and couples: the works of several at once.
    std::vector<Formula> share_row(const Share& share, const Formula& q) {
        const Effort& given = mechanism_.efforts[at_index(share.effort)];
        Formula moved;
        std::string on;
        if (const auto* couple = std::get_if<CoupleEffort>(&given)) {
            on = body(couple->body) + (couple->from == frame ? "" : "," + body(couple->from));
            moved = turned(on, share.omega->to_double(), q);
        } else {
            const auto* actuator = std::get_if<ActuatorEffort>(&given);
            on = actuator != nullptr ? body(mechanism_.joint(actuator->joint).bodies[0])
                                     : body(std::get<ForceEffort>(given).body);
            moved = way(mechanism_.point(point_of(share.effort)).name, share.velocity.value_or(Vector{}), q);
        }
        return {force(symbol_of(share.effort)), upright(on), upright("?"), std::move(moved),
                per_effort(share.power->to_double(), share.effort) + force(symbol_of(share.effort))};
    }
    Formula symbols(const VirtualWork& work) const {
        Formula sum;
        const auto add = [&](Formula term) {
            if (!sum.empty()) sum += Formula::sign("+");
            sum += std::move(term);
        };
        for (const Entry& entry : work.entries) {
            if (!entry.force.is_zero()) add(force(entry.symbol) + upright(" · ") + moved_point(point_at(entry.at)));
            if (entry.couple.is_zero()) continue;
            Symbol symbol = entry.symbol;
            symbol.letter = Symbol::Letter::M;
            add(force(symbol) + Formula::letter("delta") + Formula::letter("theta", body(entry.body)));
        }
        for (const Share& share : work.shares) {
            const Formula own = force(symbol_of(share.effort));
            if (is_couple(share.effort)) {
                const auto& couple = std::get<CoupleEffort>(mechanism_.efforts[at_index(share.effort)]);
                const std::string of = body(couple.body) + (couple.from == frame ? "" : "," + body(couple.from));
                add(own + Formula::letter("delta") + Formula::letter("theta", of));
            } else {
                add(own + upright(" · ") + moved_point(mechanism_.point(point_of(share.effort)).name));
            }
        }
        return sum.empty() ? upright("0") : sum;
    }
    /// (given + share E) δq.
    Formula numbers(double given, const VirtualWork& work, const Formula& q) const {
        Formula sum;
        if (given != 0 || work.shares.empty()) sum = work_of(given);
        for (const Share& share : work.shares) {
            if (share.rests) continue;
            const double own = share.power->to_double();
            if (!sum.empty())
                sum += Formula::sign(own < 0 ? "−" : "+");
            else if (own < 0)
                sum += upright("−");
            sum += per_effort(std::abs(own), share.effort) + force(symbol_of(share.effort));
        }
        if (sum.empty()) sum = upright("0");
        return Formula::fenced(std::move(sum)) + q;
    }

    void write_efforts() {
        if (found_.efforts.empty()) {
            say(found_.balanced ? Words(lang::equations::the_sum_vanishes_for_every_displacement)
                                : Words(lang::equations::the_sum_does_not_vanish));
            return;
        }
        if (!found_.balanced) return say({lang::equations::no_effort_makes_all_the_works});
        const bool all =
            std::all_of(found_.efforts.begin(), found_.efforts.end(), [](const auto& each) { return each.value; });
        if (all)
            announce(found_.freedoms.size() > 1 ? Words(lang::equations::as_the_coordinates_are_independent_every)
                                                : Words(lang::equations::as_is_arbitrary_the_bracket_vanishes,
                                                        spoken(found_.freedoms.front())));
        for (const Displacements::Effort& effort : found_.efforts) {
            const Formula symbol = force(symbol_of(effort.given));
            if (effort.value) {
                set(symbol + Formula::sign("=") + upright(amount_of(effort.given, effort.value->to_double())));
            } else {
                say(Words(lang::equations::the_work_of_leaves_it_open, "{" + name_of(symbol_of(effort.given)) + "}"));
            }
        }
    }

    // --- the same by velocity ratios
    // ------------------------------------------------------------------------------------------

    void write_ratios() {
        if (!std::all_of(found_.freedoms.begin(), found_.freedoms.end(),
                         [](const auto& each) { return each.equations->why_not.empty(); }))
            return;
        heading({lang::equations::the_same_by_velocity_ratios});
        for (const Displacements::Freedom& freedom : found_.freedoms) write_ratios_of(freedom);
        if (found_.efforts.empty()) return;
        bool said = false;
        for (const Displacements::Effort& effort : found_.efforts) {
            if (!effort.ratio) continue;
            if (!std::exchange(said, true)) announce({lang::equations::set_to_zero});
            set(force(symbol_of(effort.given)) + Formula::sign("=") + upright(amount_of(effort.given, *effort.ratio)));
        }
    }
    void write_ratios_of(const Displacements::Freedom& freedom) {
        turn_ = is_turn(freedom.driver);
        const VirtualWork& work = *freedom.moved->virtual_work;
        say(Words(lang::equations::the_closure_equations_give_d_d,
                  "{" + unicode_letter(letter_of(mechanism_, freedom.driver).first) + "_" +
                      letter_of(mechanism_, freedom.driver).second + "}"));
        std::vector<std::vector<Formula>> rows{{upright(in({lang::equations::action})),
                                                upright(in({lang::equations::ratios})),
                                                upright(in({lang::equations::work}) + " / ") +
                                                    coordinate(freedom, true) + upright(", " + work_unit().symbol)}};
        const Equations& equations = *freedom.equations;
        for (const Entry& entry : work.entries) {
            const auto own = work_by_ratios(equations, entry);
            if (!own) return;
            Symbol symbol = entry.symbol;
            if (entry.force.is_zero()) symbol.letter = Symbol::Letter::M;
            rows.push_back(
                {force(symbol), ratios_of(equations, entry.body, entry.at, !entry.force.is_zero()), work_of(*own)});
        }
        for (const Share& share : work.shares) {
            const auto own = work_by_ratios(equations, freedom.moved->mechanism, freedom.moved->pose, share.effort);
            if (!own) return;
            const Formula symbol = force(symbol_of(share.effort));
            rows.push_back({symbol, ratios_of(equations, share.effort), per_effort(*own, share.effort) + symbol});
        }
        table(std::move(rows));
    }
    Formula ratios_of(const Equations& equations, BodyIndex of, const Vector& place, bool is_force) {
        const auto& state = equations.bodies[at_index(of)];
        if (!is_force) {
            Formula ratio =
                Formula::letter("Lambda", "θ" + body(of)) + Formula::sign("=") + number_of(*state.omega / turn_si());
            return turn_unit().empty() ? ratio : std::move(ratio) + upright(" " + turn_unit());
        }
        const auto moved = *state.velocity_of(place);
        const std::string point = point_at(place);
        largest_ = nearest::hypot(moved[0], moved[1]) / way_si();
        return components("x" + point, moved[0]) + upright(",  ") + components("y" + point, moved[1]);
    }
    Formula components(const std::string& of, double si) const {
        Formula ratio = Formula::letter("Lambda", of) + Formula::sign("=") + number_of(clean(si / way_si()));
        return way_unit().empty() ? ratio : std::move(ratio) + upright(" " + way_unit());
    }
    Formula ratios_of(const Equations& equations, int effort) {
        const Effort& given = mechanism_.efforts[at_index(effort)];
        if (const auto* couple = std::get_if<CoupleEffort>(&given))
            return couple->from == frame ? ratios_of(equations, couple->body, Vector{}, false)
                                         : ratios_of(equations, couple->body, Vector{}, false) + upright(",  ") +
                                               ratios_of(equations, couple->from, Vector{}, false);
        const Vector& place = solution_.pose.at(point_of(effort));
        if (const auto* force = std::get_if<ForceEffort>(&given)) return ratios_of(equations, force->body, place, true);
        const Joint& joint = mechanism_.joint(std::get<ActuatorEffort>(given).joint);
        const BodyIndex on = joint.bodies[0] == frame ? joint.bodies[1] : joint.bodies[0];
        return ratios_of(equations, on, place, true);
    }
};

}  // namespace

std::vector<EquationItem> virtual_work_items(const Solution& solution, Language language) {
    if (!solution.displacements) return {};
    return WorkText(solution, language).items();
}

RichText displaced_coordinate(const Mechanism& mechanism, const Driver& driver) {
    const auto [letter, sub] = letter_of(mechanism, driver);
    Piece piece;
    piece.text = "δ" + unicode_letter(letter);
    piece.face = Face::italic;
    piece.sub = sub;
    piece.sub_face = Face::regular;
    return {piece};
}

}  // namespace kinegraph::render
