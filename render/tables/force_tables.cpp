// Force tables: see force_tables.hpp. All numbers come from the Solution and its checks; here they are only paired and
// typeset.
#include "render/tables/force_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "engine/number/assert.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/sheet.hpp"
#include "render/page/shapes.hpp"
#include "render/tables/checked_numbers.hpp"
#include "render/tables/truss_table.hpp"
#include "render/text/rich_text.hpp"

namespace kinegraph::render {
namespace {

std::size_t at_index(int index) { return static_cast<std::size_t>(index); }

RichText point(const Mechanism& mechanism, PointIndex p, Language language) {
    return typeset(Symbol{Symbol::Letter::point, mechanism.points[at_index(p)].name, ""}, language);
}
bool is_load(const AppliedForce& applied) { return !applied.is_reaction() && applied.kind != Quantity::Kind::effort; }

/// The given loads are not in equilibrium, and nothing is unknown.
bool is_open(const FreeBody& body) {
    return std::any_of(body.forces.begin(), body.forces.end(),
                       [](const AppliedForce& each) { return each.is_resultant(); });
}

/// The free body on which the opposite of a reaction acts; none for the frame.
const FreeBody* opposite(const LoadCase& loads, const FreeBody& body, const AppliedForce& applied) {
    for (const FreeBody& other : loads.bodies()) {
        if (&other == &body) continue;
        for (const AppliedForce& its : other.forces)
            if (its.joint != none && its.joint == applied.joint && its.from == body.body &&
                (applied.from == other.body || (applied.from == none && other.body == none)))
                return &other;
    }
    return nullptr;
}

/// Relative threshold for lengths (of the drawing's size) and forces: anything smaller is zero. On rounded data it is
/// their precision, with some amplification.
double least_share(const Pose& pose, double least) {
    constexpr double amplified = 64;
    return std::max(least, amplified * pose.rounding());
}
/// Whether a place lies on the line of action, within the accuracy of a drawing.
bool on_line(const AppliedForce& applied, const Vector& place, const Pose& pose) {
    const Vector d = place - applied.at;
    const double away =
        std::abs(cross(applied.force, d).to_double()) / std::max(kinegraph::length(applied.force), 1e-300);
    return away < least_share(pose, 1e-7) * pose.size.to_double();
}

/// The line of a force for the table. Empty: any line, none was deduced.
std::optional<RichText> line_of(const DrawingContext& context, const LoadCase& loads, const FreeBody& body,
                                const AppliedForce& applied) {
    const Solution& solution = context.solution;
    const Mechanism& mechanism = solution.mechanism;
    const Language language = context.language;
    if (applied.kind == Quantity::Kind::weight && applied.force.x.is_zero())
        return one_piece(word(lang::sheet::vertical, language));
    if (is_load(applied)) return one_piece(word(lang::common::given, language));
    if (applied.joint == none) return one_piece(word(lang::common::given, language));
    const Joint& joint = mechanism.joints[at_index(applied.joint)];
    if (applied.kind == Quantity::Kind::effort) return one_piece("∥ " + word(lang::sheet::guide, language));
    if (joint.pair().is_sleeve()) return one_piece("⟂ " + word(lang::sheet::guide, language));
    // Teeth transmit force at the pressure angle, not along the common normal of the pitch curves.
    if (joint.pair().meshes()) return one_piece(word(lang::sheet::line_of_the_teeth, language));
    if (!joint.pair().holds_point()) return one_piece(word(lang::sheet::normal, language));
    const Vector& own = solution.pose.at(joint.point);
    RichText text = point(mechanism, joint.point, language);
    // A two-force body: the line passes through its other joint.
    if (applied.from > frame)
        for (const Joint& other : mechanism.joints) {
            if (other.point == joint.point || (solution.pose.at(other.point) - own).is_zero()) continue;
            if (std::find(other.bodies.begin(), other.bodies.end(), applied.from) == other.bodies.end()) continue;
            if (!on_line(applied, solution.pose.at(other.point), solution.pose)) continue;
            append_point(text, point(mechanism, other.point, language));
            return text;
        }
    // The concurrency of the forces on this body, or on the body that the force comes from.
    std::vector<FreeBody::Meet> meets = body.meets;
    for (const FreeBody& other : loads.bodies())
        if (other.body == applied.from && applied.from > frame)
            meets.insert(meets.end(), other.meets.begin(), other.meets.end());
    for (const FreeBody::Meet& meet : meets)
        if (on_line(applied, meet.place, solution.pose) &&
            kinegraph::length(meet.place - own) > least_share(solution.pose, 0) * solution.pose.size.to_double()) {
            append_point(text, typeset(Symbol{Symbol::Letter::point, meet.name, ""}, language));
            return text;
        }
    return std::nullopt;
}

/// Parallel forces are found by moments; there is no triangle to close.
bool are_parallel(const Solution& solution, const FreeBody& body) {
    return std::all_of(body.forces.begin(), body.forces.end(), [&](const AppliedForce& each) {
        const Vector& first = body.forces.front().force;
        return std::abs(cross(each.force, first).to_double()) <=
               least_share(solution.pose, 0) * kinegraph::length(each.force) * kinegraph::length(first);
    });
}

/// A force of the equation, with its known and sought properties.
struct EquationColumn {
    ShapedLine symbol, line;
    bool magnitude = false, direction = true;
    double middle = 0;
};

EquationColumn equation_column(const DrawingContext& context, const LoadCase& loads, const FreeBody& body,
                               const AppliedForce& applied, const Symbol& symbol) {
    EquationColumn column;
    // What an earlier sentence found is known.
    column.magnitude =
        is_load(applied) || (applied.force_statement != none && applied.force_statement < body.statement);
    // Nothing determines the line of this hinge force: magnitude and direction are both sought, and the polygon gives
    // them together.
    const std::optional<RichText> line = line_of(context, loads, body, applied);
    column.direction = column.magnitude || !applied.is_reaction() || line;
    column.symbol = context.fonts.shape(typeset(symbol, context.language), context.theme.equation);
    column.line = context.fonts.shape(line ? *line : one_piece(word(lang::sheet::any_line, context.language)),
                                      context.theme.small);
    return column;
}

/// In the order of the polygon. Empty if a side of it is not a force of the body, or if there are more forces or
/// unknowns than one polygon can give.
std::optional<std::vector<EquationColumn>> equation_columns(const DrawingContext& context, const LoadCase& loads,
                                                            const FreeBody& body) {
    const Protocol& protocol = context.solution.protocol;
    std::vector<EquationColumn> columns;
    int sought = 0;
    for (const int index : protocol.polygons[at_index(body.polygon)].vectors) {
        const DrawnVector& vector = protocol.vectors[at_index(index)];
        const auto applied = std::find_if(body.forces.begin(), body.forces.end(), [&](const AppliedForce& each) {
            return !each.force.is_zero() && quantity_of(body, each) == vector.quantity;
        });
        if (applied == body.forces.end()) return std::nullopt;
        columns.push_back(equation_column(context, loads, body, *applied, vector.symbol));
        sought += (columns.back().magnitude ? 0 : 1) + (columns.back().direction ? 0 : 1);
    }
    if (columns.size() < 3 || columns.size() > 5 || sought > 2) return std::nullopt;
    return columns;
}

constexpr std::array<Key, 3> equation_rows{lang::common::magnitude, lang::sheet::direction, lang::sheet::line};

/// The equation F_g + F_01 + F_21 = 0, with rows of known and sought properties below it.
class ForceEquation {
public:
    /// Lengths in mm.
    struct Spacing {
        double column;       ///< least width of a column
        double about;        ///< about a symbol
        double about_line;   ///< about the name of a line
        double between;      ///< between columns
        double after_names;  ///< after the names of the rows
    };
    ForceEquation(const DrawingContext& context, std::vector<EquationColumn> columns, bool with_names,
                  const Spacing& spacing)
        : theme_(context.theme), fonts_(context.fonts), columns_(std::move(columns)), with_names_(with_names) {
        for (std::size_t i = 0; i < equation_rows.size() && with_names; ++i) {
            names_[i] = fonts_.shape(one_piece(word(equation_rows[i], context.language)), theme_.small);
            right_ = std::max(right_, names_[i].width + spacing.after_names);
        }
        for (EquationColumn& column : columns_) {
            if (&column != &columns_.front()) right_ += spacing.between;
            const double width =
                std::max({spacing.column, column.symbol.width + spacing.about, column.line.width + spacing.about_line});
            column.middle = right_ + width / 2;
            right_ += width;
        }
    }

    Block drawn(Colour letters) {
        put_equation(letters);
        put_rows();
        return std::move(block_);
    }

private:
    void centred(const ShapedLine& shaped, double middle, double baseline, Colour colour) {
        set_text(block_.marks, shaped, {middle - shaped.width / 2, baseline}, colour, "text");
    }
    void put_rule(double y) {
        block_.marks.emplace_back(line({0, y}, {block_.width, y}, {theme_.thin, theme_.text, {}, false}));
    }

    void put_equation(Colour letters) {
        const ShapedLine plus = fonts_.shape(one_piece("+"), theme_.equation),
                         zero = fonts_.shape(one_piece("= 0"), theme_.equation);
        constexpr double baseline = 4.6;
        double before = 0;
        for (const EquationColumn& column : columns_) {
            if (&column != &columns_.front())
                centred(plus, 0.5 * (before + column.middle - column.symbol.width / 2), baseline, theme_.text);
            centred(column.symbol, column.middle, baseline, letters);
            before = column.middle + column.symbol.width / 2;
        }
        set_text(block_.marks, zero, {before + 1.8, baseline}, theme_.text, "text");
        block_.width = std::max(right_, before + 1.8 + zero.width);
    }

    void put_rows() {
        const ShapedLine tick = fonts_.shape(one_piece("✓"), 10),
                         question = fonts_.shape(one_piece("?", Face::bold), 10);
        constexpr double top = 6.6;
        put_rule(top);
        double baseline = top;
        for (std::size_t row = 0; row < equation_rows.size(); ++row) {
            baseline = top + 3.4 + 4.1 * static_cast<double>(row);
            if (with_names_) set_text(block_.marks, names_[row], {0, baseline}, theme_.secondary, "text");
            for (const EquationColumn& column : columns_)
                if (row == 2)
                    centred(column.line, column.middle, baseline, theme_.secondary);
                else
                    centred((row == 0 ? column.magnitude : column.direction) ? tick : question, column.middle, baseline,
                            theme_.text);
        }
        block_.height = baseline + 1.8;
        put_rule(block_.height);
    }

    const Theme& theme_;
    const Fonts& fonts_;
    std::vector<EquationColumn> columns_;
    bool with_names_;
    std::array<ShapedLine, 3> names_;
    double right_ = 0;
    Block block_;
};

std::optional<Measured> measured(const std::vector<Figure>& figures, const std::string& name) {
    std::optional<Measured> longest;  // the first, unless it has a detail
    for (const Figure& figure : figures) {
        if (figure.traits.measured != QuantityKind::force) continue;
        auto found = measured_on(figure, name);
        if (found && (!longest || found->millimetres > longest->millimetres)) longest = std::move(found);
    }
    return longest;
}

}  // namespace

Symbol couple_symbol(const AppliedForce& applied) {
    Symbol symbol = applied.symbol;
    symbol.letter = Symbol::Letter::M;
    return symbol;
}

Block force_row_names(const DrawingContext& context) {
    Block block;
    for (std::size_t i = 0; i < equation_rows.size(); ++i) {
        const ShapedLine shaped =
            context.fonts.shape(one_piece(word(equation_rows[i], context.language)), context.theme.small);
        set_text(block.marks, shaped, {0, 6.6 + 3.4 + 4.1 * static_cast<double>(i)}, context.theme.secondary, "text");
        block.width = std::max(block.width, shaped.width);
    }
    block.height = 20;
    return block;
}

Block force_equation_block(const DrawingContext& context, const LoadCase& loads, const FreeBody& body, bool with_names,
                           double most) {
    if (body.polygon < 0 || body.in_parts || is_open(body) || are_parallel(context.solution, body)) return {};
    const std::optional<std::vector<EquationColumn>> columns = equation_columns(context, loads, body);
    if (!columns) return {};
    // The normal setting first; if it is too wide, closer, then smaller.
    constexpr std::array spacings{ForceEquation::Spacing{9, 2, 2.4, 2.4, 1.8},
                                  ForceEquation::Spacing{6.5, 2, 1.4, 2, 1.2}};
    const Colour letters = context.theme.colour_of(body.body).letter;
    Block block;
    for (const ForceEquation::Spacing& spacing : spacings) {
        block = ForceEquation(context, *columns, with_names, spacing).drawn(letters);
        if (block.width <= most) return block;
    }
    constexpr double legible = 0.8;  // letters of lines are not lower than 2.2 mm
    return block.width * legible <= most ? scaled(block, most / block.width) : Block{};
}

const JointForce* at_the_pair(const Solution& solution, const FreeBody& body, const AppliedForce& applied) {
    if (!applied.is_reaction() || applied.force.is_zero()) return nullptr;
    for (const JointForce& each : solution.forces)
        if (each.joint == applied.joint && each.on == body.body && each.from == applied.from && each.couple &&
            !each.couple->is_zero())
            return &each;
    return nullptr;
}

RichText beside_guide(const DrawingContext& context, const FreeBody& body, const AppliedForce& applied,
                      bool is_dimensioned) {
    const Solution& solution = context.solution;
    const Mechanism& mechanism = solution.mechanism;
    if (applied.joint == none || body.body == none || !applied.is_reaction() || applied.force.is_zero()) return {};
    const Joint& joint = mechanism.joints[at_index(applied.joint)];
    if (!joint.pair().is_sleeve()) return {};
    const Vector own = solution.pose.at(joint.point), guide = solution.pose.guides[at_index(applied.joint)];
    const double unit_length = kinegraph::length(guide);
    const auto along = [&](const Vector& place) { return dot(place - own, guide).to_double() / unit_length; };
    const double at = along(applied.at), small = 1e-9 * solution.pose.size.to_double();
    if (std::abs(at) <= small) return {};
    // The range of the slider's points on the guide's line.
    double least = 0, most = 0;
    for (const PointIndex p : mechanism.bodies[at_index(joint.bodies[0])].points) {
        const Vector& place = solution.pose.at(p);
        if (std::abs(cross(guide, place - own).to_double()) > small * unit_length) continue;
        least = std::min(least, along(place));
        most = std::max(most, along(place));
    }
    if (most - least > small && (at < least - small || at > most + small))
        return one_piece(word(lang::sheet::passes_outside, context.language));
    if (is_dimensioned) return {};
    const Unit& unit = mechanism.units.length;
    RichText text = one_piece(number(std::abs(at) / unit.si.to_double(), 4, context.language) + " " + unit.symbol +
                              " " + word(lang::sheet::passes_beside, context.language) + " ");
    append(text, point(mechanism, joint.point, context.language));
    return text;
}

namespace {

/// Rows of forces and couples; each action and its reaction appear once.
class ForceRows {
public:
    ForceRows(const DrawingContext& context, const std::vector<Figure>& figures, bool at_pairs,
              std::vector<const FreeBody*> beside)
        : solution_(context.solution),
          mechanism_(context.solution.mechanism),
          figures_(figures),
          at_pairs_(at_pairs),
          beside_(std::move(beside)),
          checks_(context.solution) {}

    std::vector<ResultRow> rows() && {
        for (const FreeBody& body : solution_.free_bodies)
            for (const AppliedForce& applied : body.forces) {
                if (!is_first(body, applied)) continue;
                const auto [on, own] = own_end(body, applied);
                if (!own->force.is_zero()) forces_.push_back(force_row(*on, *own));
                if (!own->couple.is_zero()) couples_.push_back(couple_row(*on, *own));
                if (const JointForce* pair = at_the_pair(solution_, *on, *own); pair != nullptr && at_pairs_) {
                    AppliedForce there = *own;
                    there.couple = *pair->couple;
                    couples_.push_back(couple_row(*on, there));
                    couples_.push_back(shift_row(*on, there));
                }
            }
        add_idle_efforts();
        forces_.insert(forces_.end(), std::make_move_iterator(couples_.begin()),
                       std::make_move_iterator(couples_.end()));
        return std::move(forces_);
    }

private:
    /// Sought input forces and couples that are zero act on no body, but are answers as well.
    void add_idle_efforts() {
        for (std::size_t e = 0; e < solution_.efforts.size(); ++e) {
            const EffortValue& effort = solution_.efforts[e];
            if (!effort.value || !effort.value->is_zero()) continue;
            const bool couple = std::holds_alternative<CoupleEffort>(mechanism_.efforts[e]);
            const Unit& unit = couple ? mechanism_.units.moment : mechanism_.units.force;
            ResultRow row;
            row.quantity = {.kind = Quantity::Kind::effort, .given = static_cast<int>(e)};
            row.symbol = {couple ? Symbol::Letter::M : Symbol::Letter::F, effort.name, {}};
            row.name = name_of(row.symbol);
            if (const auto numeric = checks_.of(row.quantity)) row.numeric = *numeric / unit.si.to_double();
            row.unit = unit.symbol;
            row.group = {Topic::forces, -1, couple};
            (couple ? couples_ : forces_).push_back(std::move(row));
        }
    }
    /// Whether this is the first occurrence of an action on two bodies, or of a mass's force and couple.
    bool is_first(const FreeBody& body, const AppliedForce& applied) {
        Quantity quantity = quantity_of(body, applied);
        if (quantity.body > quantity.other) std::swap(quantity.body, quantity.other);
        return seen_.emplace(quantity, applied.force.is_zero()).second;
    }
    /// A reaction is listed as it acts on the body beside whose polygon it stands; a couple between two bodies as it
    /// acts on the body that the file names first.
    std::pair<const FreeBody*, const AppliedForce*> own_end(const FreeBody& body, const AppliedForce& applied) const {
        const auto* couple = applied.kind == Quantity::Kind::effort
                                 ? std::get_if<CoupleEffort>(&mechanism_.efforts[at_index(applied.given)])
                                 : nullptr;
        if (applied.is_reaction())
            for (const FreeBody* other : beside_)
                for (const AppliedForce& its : other->forces)
                    if (are_one_action(quantity_of(*other, its), quantity_of(body, applied))) return {other, &its};
        if (couple == nullptr) return {&body, &applied};
        for (const FreeBody& other : solution_.free_bodies)
            for (const AppliedForce& its : other.forces)
                if (other.body == couple->body && its.kind == Quantity::Kind::effort && its.given == applied.given)
                    return {&other, &its};
        return {&body, &applied};
    }
    /// If only the reverse is drawn, its length is measured.
    Symbol symbol_measured(const FreeBody& body, const AppliedForce& applied) const {
        if (!applied.is_reaction() || measured(figures_, name_of(applied.symbol))) return applied.symbol;
        if (const FreeBody* other = opposite(solution_, body, applied))
            for (const AppliedForce& its : other->forces)
                if (its.joint == applied.joint && its.from == body.body && measured(figures_, name_of(its.symbol)))
                    return its.symbol;
        return applied.symbol;
    }
    ResultRow force_row(const FreeBody& body, const AppliedForce& applied) const {
        const Unit& unit = mechanism_.units.force;
        ResultRow row;
        row.quantity = quantity_of(body, applied);
        row.symbol = symbol_measured(body, applied);
        row.name = name_of(row.symbol);
        row.drawing = kinegraph::length(Vector{applied.force.x / unit.si, applied.force.y / unit.si});
        if (const auto found = measured(figures_, row.name)) {
            row.millimetres = found->millimetres;
            row.detail = found->detail;
        }
        if (const auto numeric = checks_.force_of(body, applied)) row.numeric = *numeric / unit.si.to_double();
        row.unit = unit.symbol;
        row.group.section = Topic::forces;
        return row;
    }
    ResultRow couple_row(const FreeBody& body, const AppliedForce& applied) const {
        const Unit& unit = mechanism_.units.moment;
        ResultRow row;
        row.quantity = quantity_of(body, applied);
        row.symbol = couple_symbol(applied);
        row.name = name_of(row.symbol);
        row.drawing = (applied.couple / unit.si).to_double();
        if (const auto numeric = checks_.couple_of(body, applied)) row.numeric = *numeric / unit.si.to_double();
        row.unit = unit.symbol;
        row.group = {Topic::forces, -1, true};
        return row;
    }

    /// The displacement of the single force from the pair: d = M/F.
    ResultRow shift_row(const FreeBody& body, const AppliedForce& applied) const {
        ResultRow row = couple_row(body, applied);
        const Unit& unit = mechanism_.units.length;
        row.symbol = {Symbol::Letter::length, "d" + applied.symbol.about, {}};
        row.name = name_of(row.symbol);
        const double si = unit.si.to_double();
        row.drawing = std::abs(applied.couple.to_double()) / kinegraph::length(applied.force) / si;
        const auto force = checks_.force_of(body, applied), couple = checks_.couple_of(body, applied);
        row.numeric.reset();
        if (force && couple && *force > 0) row.numeric = std::abs(*couple) / *force / si;
        row.unit = unit.symbol;
        return row;
    }

    const Solution& solution_;
    const Mechanism& mechanism_;
    const std::vector<Figure>& figures_;
    bool at_pairs_;
    std::vector<const FreeBody*> beside_;
    CheckedNumbers checks_;
    std::set<std::pair<Quantity, bool>> seen_;
    std::vector<ResultRow> forces_, couples_;
};

}  // namespace

std::vector<ResultRow> force_rows(const DrawingContext& context, const std::vector<Figure>& figures, bool at_pairs,
                                  std::vector<const FreeBody*> beside) {
    if (context.solution.truss && context.solution.free_bodies.empty()) return truss_rows(context, figures);
    if (context.solution.free_bodies.empty() && context.solution.efforts.empty()) return {};
    return ForceRows(context, figures, at_pairs, std::move(beside)).rows();
}

bool are_one_action(Quantity one, const Quantity& other) {
    const auto of_a_joint = [](Quantity::Kind kind) {
        return kind == Quantity::Kind::force || kind == Quantity::Kind::couple;
    };
    if (of_a_joint(one.kind) && of_a_joint(other.kind)) one.kind = other.kind;
    Quantity turned = one;
    std::swap(turned.body, turned.other);
    return one == other || turned == other;
}

std::vector<const FreeBody*> closed_by(const LoadCase& loads, StatementIndex statement) {
    std::vector<const FreeBody*> closed;
    for (const FreeBody& body : loads.bodies())
        if (!body.in_parts && body.statement == statement) closed.push_back(&body);
    return closed;
}

std::vector<const FreeBody*> solved_by(const LoadCase& loads, StatementIndex statement) {
    const Solution& solution = loads.solution();
    const Statement& said = solution.protocol.statements[at_index(statement)];
    const BodyName* const about =
        said.message.arguments.empty() ? nullptr : std::get_if<BodyName>(&said.message.arguments.front());
    std::vector<const FreeBody*> solved = closed_by(loads, statement);
    std::erase_if(solved, [&](const FreeBody* body) {
        if (about == nullptr) return true;
        if (body->body == none)
            return about->as != BodyName::As::pin || about->name != solution.mechanism.point(body->pin).name;
        return said.bodies != std::vector{body->body} || about->as == BodyName::As::with_pin;
    });
    return solved;
}

}  // namespace kinegraph::render
