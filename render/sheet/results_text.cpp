// The results as plain text for a terminal: one aligned table for each kind of quantity, in the units of the file.
// Depends on no font.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>

#include "engine/results/quantity_name.hpp"
#include "engine/results/result_names.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/magnitudes.hpp"
#include "engine/solution/problem_solution.hpp"
#include "engine/solution/result_values.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/sheet.hpp"
#include "render/page/shapes.hpp"
#include "render/problems/contact_pages.hpp"
#include "render/problems/problem_sheet.hpp"
#include "render/sheet/sheet.hpp"
#include "render/text/utf8.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {
namespace {

using Cells = std::vector<std::string>;
using Kind = Quantity::Kind;

/// Rows under a heading; the first column is aligned left, the others right.
std::string table(const std::string& heading, const std::vector<Cells>& rows) {
    if (rows.size() < 2) return {};  // only the head
    std::vector<std::size_t> widths;
    for (const Cells& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], character_count(row[c]));
    }
    std::string text = "\n" + heading + "\n";
    for (const Cells& row : rows) {
        std::string each = " ";
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string space(widths[c] - character_count(row[c]), ' ');
            each += c == 0 ? " " + row[c] + space : "  " + space + row[c];
        }
        while (!each.empty() && each.back() == ' ') each.pop_back();
        text += each + "\n";
    }
    return text;
}

class Text {
public:
    Text(const Solution& solution, Language language)
        : solution_(solution), language_(language), magnitudes_(solution) {
        for_each_sought(solution, [&](const Quantity& quantity, const auto& found, const auto& of) {
            sought_.push_back({quantity, &of});
            if constexpr (std::is_constructible_v<Value, decltype(*found)>)
                if (found) sought_.back().value = *found;
        });
    }

    std::string write() const {
        const std::string& title = in(solution_.mechanism.title, language_);
        std::string text = title.empty() ? "" : title + "\n";
        text += mobility();
        text += bodies() + points(true) + points(false) + sliding() + relative() + apart() + centres() +
                transmission_angles() + reactions() + efforts() + powers() + bars() + cuts(true) + cuts(false) +
                resultants();
        const auto list = [&](Key key, const std::vector<std::string>& lines) {
            if (lines.empty()) return;
            text += "\n" + word(key, language_) + "\n";
            for (const std::string& each : lines) text += "  " + each + "\n";
        };
        std::vector<std::string> open;
        for (const Unsolved& each : solution_.unsolved)
            open.push_back(tell(each.what, language_) + colon() + tell(each.why, language_));
        list(lang::sheet::unsolved, open);
        std::vector<std::string> remarks;
        for (const Message& each : solution_.remarks) remarks.push_back(tell(each, language_));
        list(lang::sheet::remarks, remarks);
        if (!solution_.checks.empty()) {
            double worst = 0;
            for (const CheckRow& row : solution_.checks) worst = std::max(worst, std::abs(row.difference));
            text += "\n" + word(lang::sheet::largest_difference, language_) + colon() + number(worst, 2, language_) +
                    " (SI)\n";
        }
        return text;
    }

private:
    std::string value(double v) const { return number(v, 6, language_); }
    std::string value(const Exact& v, const Unit& unit) const { return value((v / unit.si).to_double()); }
    /// A value that is only rounding error relative to the largest of its kind is shown as 0.
    std::string value(const Quantity& quantity, const Exact& v, const Unit& unit) const {
        return magnitudes_.is_noise(quantity, v.to_double()) ? value(0.0) : value(v, unit);
    }
    std::string length_of(Quantity::Kind kind, const Vector& v, const Unit& unit) const {
        if (magnitudes_.is_noise({.kind = kind}, length(v))) return value(0.0);
        return value(length(Spot{(v.x / unit.si).to_double(), (v.y / unit.si).to_double()}));
    }
    using Value = std::variant<Exact, Vector, ProjectivePoint>;
    /// A result that is sought, with what says more than its value, and its value where it is known.
    struct Sought {
        Quantity quantity;
        std::variant<const Solution*, const JointForce*, const InstantCentre*, const Truss::Cut*, const Resultant*,
                     const RelativeMotion*>
            of;
        std::optional<Value> value{};
    };
    /// A column of a table: a kind of results, or a part of them.
    struct Of {
        Kind kind;
        Quantity::Part part = Quantity::Part::whole;
    };
    /// A row of a table: the results of one subject, by column; null where none is sought.
    using Row = std::vector<const Sought*>;
    /// A row for each subject, in the order of the solution.
    std::vector<Row> rows_of(std::span<const Of> columns) const {
        std::vector<std::pair<Quantity, Row>> rows;
        for (const Sought& each : sought_)
            for (std::size_t c = 0; c < columns.size(); ++c) {
                if (each.quantity.kind != columns[c].kind || each.quantity.part != columns[c].part) continue;
                Quantity subject = each.quantity;
                subject.kind = Kind::unnamed;
                subject.part = Quantity::Part::whole;
                auto row =
                    std::find_if(rows.begin(), rows.end(), [&](const auto& other) { return other.first == subject; });
                if (row == rows.end()) row = rows.emplace(rows.end(), subject, Row(columns.size()));
                row->second[c] = &each;
            }
        std::vector<Row> all;
        for (auto& [subject, row] : rows) all.push_back(std::move(row));
        return all;
    }
    static bool is_known(const Sought* each) { return each != nullptr && each->value.has_value(); }
    static const Exact& scalar(const Sought& each) { return std::get<Exact>(*each.value); }
    static const Vector& vector(const Sought& each) { return std::get<Vector>(*each.value); }
    Unit unit_of(const Sought& each) const {
        return kinegraph::unit_of(unit_kind_of(each.quantity, solution_.mechanism), solution_.mechanism.units);
    }
    /// A scalar, or the length of a vector, in its unit; a dash where it is not known.
    std::string cell(const Sought* each) const {
        if (!is_known(each)) return "–";
        const Unit unit = unit_of(*each);
        if (const auto* scalar = std::get_if<Exact>(&*each->value)) return value(each->quantity, *scalar, unit);
        return length_of(each->quantity.kind, vector(*each), unit);
    }
    /// "AB, BC"
    template <class Indices, class Name>
    static std::string joined(const Indices& indices, Name name) {
        std::string all;
        for (const auto index : indices) all += (all.empty() ? "" : ", ") + name(index);
        return all;
    }
    std::string colon() const { return word(lang::notation::colon, language_); }
    const std::string& body(BodyIndex index) const { return solution_.mechanism.body(index).name; }

    std::string mobility() const {
        const Mobility& m = solution_.mobility;
        const auto n = [](int v) { return (v < 0 ? "−" : "") + std::to_string(std::abs(v)); };
        std::string text = word(lang::sheet::mobility, language_) + colon() + "n = 3·" + n(m.bodies - 1) + " − 2·" +
                           n(m.class_1) + " − " + n(m.class_2);
        if (m.welds > 0) text += " − 3·" + n(m.welds);
        text += " = " + n(m.gruebler) + " " + word(lang::sheet::by_gruebler, language_) + ", " + n(m.effective) + " " +
                word(m.effective == 1 ? lang::sheet::effective_one : lang::sheet::effective, language_) + colon() +
                verdict_words(m, language_);
        return text + "\n";
    }

    std::string bodies() const {
        const Units& units = solution_.mechanism.units;
        const std::string alpha = plain(typeset(Symbol{Symbol::Letter::alpha, "", ""}, language_));
        const std::vector<Row> found = rows_of(std::array{Of{Kind::omega}, Of{Kind::alpha}});
        const bool has_alpha = std::any_of(found.begin(), found.end(), [](const Row& row) { return is_known(row[1]); });
        std::vector<Cells> rows{{word(lang::sheet::body, language_), "ω [" + units.angular_velocity.symbol + "]"}};
        if (has_alpha) rows[0].push_back(alpha + " [rad/s²]");
        for (const Row& row : found) {
            if (!is_known(row[0]) && !is_known(row[1])) continue;
            rows.push_back({body(row[0]->quantity.body), cell(row[0])});
            if (has_alpha) rows.back().push_back(cell(row[1]));
        }
        return table(word(lang::sheet::bodies, language_), rows);
    }

    std::string points(bool velocity) const {
        const Unit& unit = velocity ? solution_.mechanism.units.velocity : solution_.mechanism.units.acceleration;
        const std::string v = velocity ? "v" : "a", in_unit = " [" + unit.symbol + "]";
        std::vector<Cells> rows{
            {word(lang::sheet::point, language_), v + "x" + in_unit, v + "y" + in_unit, "|" + v + "|" + in_unit}};
        for (const Row& row : rows_of(std::array{Of{velocity ? Kind::velocity : Kind::acceleration}})) {
            if (!is_known(row[0])) continue;
            const Quantity& quantity = row[0]->quantity;
            rows.push_back({carried(quantity), value(quantity, vector(*row[0]).x, unit),
                            value(quantity, vector(*row[0]).y, unit), cell(row[0])});
        }
        return table(word(velocity ? lang::common::velocities : lang::common::accelerations, language_), rows);
    }

    /// "A", or "A on 3, 4" where other bodies have this point with another motion.
    std::string carried(const Quantity& quantity) const {
        std::string label = solution_.mechanism.point(quantity.point).name;
        const auto is_of = [&](const PointMotion& motion) { return motion.point == quantity.point; };
        if (std::count_if(solution_.points.begin(), solution_.points.end(), is_of) < 2) return label;
        const auto own = std::find_if(solution_.points.begin(), solution_.points.end(), [&](const PointMotion& motion) {
            return is_of(motion) && velocity_of(motion).body == quantity.body;
        });
        for (std::size_t i = 0; own != solution_.points.end() && i < own->bodies.size(); ++i)
            label += (i > 0 ? ", " : " " + word(lang::sheet::on, language_) + " ") + body(own->bodies[i]);
        return label;
    }

    std::string sliding() const {
        const Units& units = solution_.mechanism.units;
        std::vector<Cells> rows{{word(lang::sheet::at, language_), "|v| [" + units.velocity.symbol + "]",
                                 "|a| [" + units.acceleration.symbol + "]",
                                 word(lang::sheet::coriolis, language_) + " [" + units.acceleration.symbol + "]"}};
        for (const Row& row : rows_of(
                 std::array{Of{Kind::sliding_velocity}, Of{Kind::sliding_acceleration}, Of{Kind::sliding_coriolis}})) {
            const Joint& joint = solution_.mechanism.joint(row[0]->quantity.joint);
            std::string label = joint.name;
            if (joint.bodies.size() == 2)
                label += colon() + body(joint.bodies[0]) + " " + word(lang::sheet::on, language_) + " " +
                         body(joint.bodies[1]);
            rows.push_back({label, cell(row[0]), cell(row[1]), cell(row[2])});
        }
        return table(word(lang::sheet::sliding, language_), rows);
    }

    std::string relative() const {
        const Units& units = solution_.mechanism.units;
        std::vector<Cells> rows{
            {word(lang::sheet::point, language_), "|v| [" + units.velocity.symbol + "]",
             "|a| [" + units.acceleration.symbol + "]", named(Symbol::Letter::v, "tr", units.velocity),
             named(Symbol::Letter::a, "tr", units.acceleration), named(Symbol::Letter::a, "cor", units.acceleration)}};
        using Part = Quantity::Part;
        for (const Row& row :
             rows_of(std::array{Of{Kind::velocity, Part::relative}, Of{Kind::acceleration, Part::relative},
                                Of{Kind::velocity, Part::transport}, Of{Kind::acceleration, Part::transport},
                                Of{Kind::acceleration, Part::coriolis}})) {
            Cells& cells = rows.emplace_back(Cells{observed(row[0]->quantity)});
            for (const Sought* each : row) cells.push_back(cell(each));
        }
        return table(word(lang::sheet::relative_motion, language_), rows);
    }
    /// "|v^tr| [m/s]"
    std::string named(Symbol::Letter letter, const std::string& term, const Unit& unit) const {
        return "|" + plain(typeset(Symbol{letter, "", term}, language_)) + "| [" + unit.symbol + "]";
    }
    std::string observed(const Quantity& part) const {
        const auto point = [&](PointIndex p) { return solution_.mechanism.point(p).name; };
        const std::string observer =
            part.seen_from != none
                ? word(lang::sheet::seen_from_axes_translating_with, language_) + " " + point(part.seen_from)
                : word(lang::sheet::seen_from_body, language_) + " " + body(part.other);
        return point(part.point) + " " + observer;
    }
    /// The transport terms, split at the origin of the moving axes.
    std::string apart() const {
        const Units& units = solution_.mechanism.units;
        const std::string speed = " [" + units.velocity.symbol + "]", rate = " [" + units.acceleration.symbol + "]";
        const std::string alpha = plain(typeset(Symbol{Symbol::Letter::alpha, "", ""}, language_));
        std::vector<Cells> rows{{word(lang::sheet::point, language_), "O′", "|v O′|" + speed, "|ω ∧ O′P|" + speed,
                                 "|a O′|" + rate, "|" + alpha + " ∧ O′P|" + rate, "|ω² O′P|" + rate}};
        for (const Row& row : rows_of(std::array{Of{Kind::velocity, Quantity::Part::transport}})) {
            const RelativeMotion& motion = *std::get<const RelativeMotion*>(row[0]->of);
            if (!motion.apart) continue;
            const RelativeMotion::Apart& parts = *motion.apart;
            rows.push_back({observed(row[0]->quantity), solution_.mechanism.point(parts.origin).name,
                            length_of(Kind::velocity, *parts.origin_velocity, units.velocity),
                            length_of(Kind::velocity, *parts.turning_velocity, units.velocity),
                            length_of(Kind::acceleration, *parts.origin_acceleration, units.acceleration),
                            length_of(Kind::acceleration, *parts.tangential, units.acceleration),
                            length_of(Kind::acceleration, *parts.normal, units.acceleration)});
        }
        return table(word(lang::sheet::transport_motion, language_), rows);
    }

    std::string transmission_angles() const {
        const Unit& unit = solution_.mechanism.units.angle;
        std::vector<Cells> rows{
            {word(lang::common::joint, language_), "γ [" + (unit.symbol == "deg" ? "°" : unit.symbol) + "]"}};
        for (const Row& row : rows_of(std::array{Of{Kind::transmission_angle}})) {
            const Quantity& angle = row[0]->quantity;
            rows.push_back({solution_.mechanism.joint(angle.joint).name + colon() + body(angle.other) + " " +
                                word(lang::sheet::on, language_) + " " + body(angle.body),
                            cell(row[0])});
        }
        return table(word(lang::sheet::transmission_angles, language_), rows);
    }

    /// "750 ∥ (0, 1)".
    std::string component(const Sought& each) const {
        const Vector along = unit_of_component(*std::get<const JointForce*>(each.of));
        constexpr int digits = 4;
        const auto written = [&](const Exact& v) { return number(v.to_double(), digits, language_); };
        return written(scalar(each) / unit_of(each).si) + " ∥ " +
               pair_of(written(along.x), written(along.y), language_);
    }
    /// Where a pair transmits no couple, it vanishes as soon as the force is known, or a component of it.
    std::string couple(const Row& row) const {
        if (row[1] != nullptr) return cell(row[1]);
        return is_known(row[0]) || is_known(row[2]) ? value(0.0) : "–";
    }

    std::string reactions() const {
        const Unit &force = solution_.mechanism.units.force, &moment = solution_.mechanism.units.moment;
        const std::string in_force = " [" + force.symbol + "]";
        const std::vector<Row> found =
            rows_of(std::array{Of{Kind::force}, Of{Kind::couple}, Of{Kind::force_component}});
        const bool couples = std::any_of(found.begin(), found.end(),
                                         [](const Row& row) { return is_known(row[1]) && !scalar(*row[1]).is_zero(); });
        std::vector<Cells> rows{
            {word(lang::common::joint, language_), "Fx" + in_force, "Fy" + in_force, "|F|" + in_force}};
        if (couples) rows[0].push_back("M [" + moment.symbol + "]");
        const auto acting = [&](BodyIndex b) { return b == none ? word(lang::sheet::pin, language_) : body(b); };
        for (const Row& row : found) {
            const Quantity& action = row[0]->quantity;
            Cells& cells = rows.emplace_back();
            cells.push_back(solution_.mechanism.joint(action.joint).name + colon() + acting(action.other) + " " +
                            word(lang::sheet::on, language_) + " " + acting(action.body));
            for (const Exact Vector::*axis : {&Vector::x, &Vector::y})
                cells.push_back(is_known(row[0]) ? value(action, vector(*row[0]).*axis, force) : "–");
            cells.push_back(!is_known(row[0]) && is_known(row[2]) ? component(*row[2]) : cell(row[0]));
            if (couples) cells.push_back(couple(row));
        }
        return table(word(lang::sheet::reactions_heading, language_), rows);
    }

    /// From the reactions, else by virtual displacements.
    std::string efforts() const {
        std::vector<Cells> rows{{word(lang::sheet::effort, language_), "", ""}};
        for (const Row& row : rows_of(std::array{Of{Kind::effort}, Of{Kind::virtual_effort}})) {
            const Sought& effort = is_known(row[0]) || row[1] == nullptr ? *row[0] : *row[1];
            const Unit unit = unit_of(effort);
            rows.push_back({subject_of(effort.quantity, solution_),
                            is_known(&effort) ? value(scalar(effort), unit) : "–", unit.symbol});
        }
        return table(word(lang::sheet::efforts, language_), rows);
    }

    /// W; positive where it drives.
    std::string powers() const {
        std::vector<Cells> rows{{"", word(lang::sheet::power, language_) + " [W]"}};
        for (const Sought& each : sought_)
            if (result_kind(each.quantity).unit == QuantityKind::power)
                rows.push_back({subject_of_power(each.quantity), cell(&each)});
        return table(word(lang::sheet::powers, language_), rows);
    }
    std::string subject_of_power(const Quantity& power) const {
        std::string subject = subject_on_request(power, solution_.mechanism);
        switch (power.kind) {
            case Kind::power_of_weight: return Words(lang::sheet::weight_of_body, subject).in(language_);
            case Kind::power_of_inertia: return Words(lang::sheet::inertia_force_of_body, subject).in(language_);
            default: return subject;
        }
    }

    std::string bars() const {
        const Unit& unit = solution_.mechanism.units.force;
        std::vector<Cells> rows{{word(lang::sheet::bar, language_), "N [" + unit.symbol + "]", ""}};
        for (const Row& row : rows_of(std::array{Of{Kind::bar}})) {
            const Exact& pull = scalar(*row[0]);
            const Key sense = pull > 0 ? lang::sheet::tension : pull < 0 ? lang::sheet::compression : lang::sheet::idle;
            rows.push_back({subject_of(row[0]->quantity, solution_), cell(row[0]), word(sense, language_)});
        }
        return table(word(lang::sheet::bars, language_), rows);
    }
    /// The equations of the cuts: about the meet of two bars, or across bars that are parallel.
    std::string cuts(bool by_moments) const {
        const Units& units = solution_.mechanism.units;
        const std::string &cut = word(lang::sheet::cut, language_), &bar = word(lang::sheet::bar, language_);
        std::vector<Cells> rows{by_moments ? Cells{cut, bar, word(lang::sheet::about, language_),
                                                   "M [" + units.moment.symbol + "]",
                                                   word(lang::sheet::arm, language_) + " [" + units.length.symbol + "]"}
                                           : Cells{cut, bar, "F ⟂ [" + units.force.symbol + "]", "sin φ"}};
        const std::array of_moments{Of{Kind::cut_moment}, Of{Kind::cut_arm}};
        const std::array of_forces{Of{Kind::cut_across}, Of{Kind::cut_sine}};
        for (const Row& row : rows_of(by_moments ? of_moments : of_forces)) {
            const Truss::Cut& made = *std::get<const Truss::Cut*>(row[0]->of);
            const auto name = [&](int b) { return solution_.truss->structure.bars[at_index(b)].name; };
            Cells& cells = rows.emplace_back(Cells{joined(made.bars, name), subject_of(row[0]->quantity, solution_)});
            if (by_moments) cells.push_back(made.pivot_name);
            for (const Sought* each : row) cells.push_back(value(scalar(*each), unit_of(*each)));
        }
        return table(word(by_moments ? lang::sheet::cuts_by_moments : lang::sheet::cuts_across, language_), rows);
    }

    std::string resultants() const {
        const Unit &force = solution_.mechanism.units.force, &moment = solution_.mechanism.units.moment;
        std::vector<Cells> rows{{word(lang::sheet::body, language_), "Fx [" + force.symbol + "]",
                                 "Fy [" + force.symbol + "]", "M [" + moment.symbol + "]", ""}};
        for (const Row& row : rows_of(std::array{Of{Kind::resultant}, Of{Kind::resultant_couple}})) {
            const Resultant& found = *std::get<const Resultant*>(row[0]->of);
            const Vector& sum = vector(*row[0]);
            rows.push_back(
                {joined(found.bodies, [&](BodyIndex b) { return body(b); }), value(sum.x, force), value(sum.y, force),
                 value(scalar(*row[1]), moment),
                 word(found.vanishes ? lang::sheet::in_equilibrium : lang::sheet::not_in_equilibrium, language_)});
        }
        return table(word(lang::sheet::resultant_of_what_is_given, language_), rows);
    }

    std::string centres() const {
        const Unit& unit = solution_.mechanism.units.length;
        std::vector<Cells> rows{
            {word(lang::sheet::centre, language_), "x [" + unit.symbol + "]", "y [" + unit.symbol + "]"}};
        for (const Row& row : rows_of(std::array{Of{Kind::centre}})) {
            const Quantity& of = row[0]->quantity;
            const InstantCentre& centre = *std::get<const InstantCentre*>(row[0]->of);
            Cells& cells = rows.emplace_back(Cells{body(of.body) + "," + body(of.other)});
            if (centre.as_one || !is_known(row[0])) {
                const bool is_everywhere = centre.as_one || centre.everywhere;
                cells.push_back(word(is_everywhere ? lang::sheet::everywhere : lang::sheet::not_found, language_));
                continue;
            }
            const auto& at = std::get<ProjectivePoint>(*row[0]->value);
            if (at.at_infinity()) {
                const Spot along = direction(at.place());
                for (const double share : {along.x, along.y}) cells.push_back("∞ · " + value(share));
            } else {
                for (const Exact& coordinate : {at.x, at.y}) cells.push_back(value(of, coordinate, unit));
            }
        }
        return table(word(lang::sheet::instant_centres, language_), rows);
    }
    static Spot direction(const Vector& v) {
        const Exact largest = std::max(abs(v.x), abs(v.y));
        Spot along = render::unit({(v.x / largest).to_double(), (v.y / largest).to_double()});
        return along.x < 0 || (along.x == 0 && along.y < 0) ? -1.0 * along : along;
    }

    const Solution& solution_;
    Language language_;
    Magnitudes magnitudes_;
    std::vector<Sought> sought_;
};

}  // namespace

std::string results_table(const Solution& solution, Language language) {
    if (stands_for_joints(solution.mechanism)) return problem_table(solution, language);
    return Text(solution, language).write() + contact_tables(solution, language);
}

}  // namespace kinegraph::render
