// Force tables: see force_tables.hpp. Numbers come from the Solution and its checks; here they are only paired and set.
#include "render/tables/force_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "engine/number/assert.hpp"
#include "render/page/shapes.hpp"
#include "render/scene/polygon_scene.hpp"
#include "render/tables/checked_numbers.hpp"
#include "render/tables/long_names.hpp"
#include "render/tables/truss_table.hpp"
#include "render/text/joined_names.hpp"

namespace kinegraph::render {
namespace {

using ForceKind = AppliedForce::Kind;

std::size_t at_index(int index) { return static_cast<std::size_t>(index); }

const std::string& body_name(const Mechanism& mechanism, BodyIndex body) {
    return mechanism.bodies[at_index(body)].name;
}
/// "1 frame"; its name alone where that says so itself.
std::string frame_name(const Mechanism& mechanism, Language language) {
    const std::string& name = body_name(mechanism, frame);
    const bool says_so = name == word("frame", Language::en) || name == word("frame", Language::it);
    return says_so ? name : name + " " + word("frame", language);
}
RichText point(const Mechanism& mechanism, PointIndex p, Language language) {
    return typeset(Symbol{Symbol::Letter::point, mechanism.points[at_index(p)].name, ""}, language);
}
bool is_load(ForceKind kind) { return kind != ForceKind::reaction && kind != ForceKind::effort; }

/// What is given on it does not close: there is nothing to be found.
bool is_open(const FreeBody& body) {
    return std::any_of(body.forces.begin(), body.forces.end(),
                       [](const AppliedForce& each) { return each.kind == ForceKind::resultant; });
}

/// The free body on which the other end of a reaction acts; none for the frame.
const FreeBody* opposite(const Solution& solution, const FreeBody& body, const AppliedForce& applied) {
    for (const FreeBody& other : solution.free_bodies) {
        if (&other == &body) continue;
        for (const AppliedForce& its : other.forces)
            if (its.joint != none && its.joint == applied.joint && its.from == body.body &&
                (applied.from == other.body || (applied.from == none && other.body == none)))
                return &other;
    }
    return nullptr;
}

/// As a share of the drawing's size, of a force: what is this small beside it is zero, on rounded data to their
/// precision, amplified a little.
double least_share(const Pose& pose, double least) {
    constexpr double amplified = 64;
    return std::max(least, amplified * pose.rounding());
}
/// Whether a place lies on the line of action, to what a drawing can show.
bool on_line(const AppliedForce& applied, const Vector& place, const Pose& pose) {
    const Vector d = place - applied.at;
    const double away =
        std::abs(cross(applied.force, d).to_double()) / std::max(kinegraph::length(applied.force), 1e-300);
    return away < least_share(pose, 1e-7) * pose.size.to_double();
}

/// The line of a force as the table names it; nothing: any line, none was deduced.
std::optional<RichText> line_of(const DrawingContext& context, const FreeBody& body, const AppliedForce& applied) {
    const Solution& solution = context.solution;
    const Mechanism& mechanism = solution.mechanism;
    const Language language = context.language;
    if (applied.kind == ForceKind::weight && applied.force.x.is_zero()) return one_piece(word("vertical", language));
    if (is_load(applied.kind)) return one_piece(word("given", language));
    if (applied.joint == none) return one_piece(word("given", language));
    const Joint& joint = mechanism.joints[at_index(applied.joint)];
    if (applied.kind == ForceKind::effort) return one_piece("∥ " + word("guide", language));
    if (joint.pair().is_sleeve()) return one_piece("⟂ " + word("guide", language));
    // Teeth press at the pressure angle, not along the common normal of the pitch curves.
    if (joint.pair().meshes()) return one_piece(word("line of the teeth", language));
    if (!joint.pair().holds_point()) return one_piece(word("normal", language));
    const Vector& own = solution.pose.at(joint.point);
    RichText text = point(mechanism, joint.point, language);
    // Along a two-force body: its other joint lies on the line.
    if (applied.from > frame)
        for (const Joint& other : mechanism.joints) {
            if (other.point == joint.point || (solution.pose.at(other.point) - own).is_zero()) continue;
            if (std::find(other.bodies.begin(), other.bodies.end(), applied.from) == other.bodies.end()) continue;
            if (!on_line(applied, solution.pose.at(other.point), solution.pose)) continue;
            append_point(text, point(mechanism, other.point, language));
            return text;
        }
    // Its own concurrency, or that of the body it comes from.
    std::vector<FreeBody::Meet> meets = body.meets;
    for (const FreeBody& other : solution.free_bodies)
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

std::optional<Measured> measured(const std::vector<Figure>& figures, const std::string& name) {
    std::optional<Measured> longest;  // the first one, or where it has a detail
    for (const Figure& figure : figures) {
        if (figure.kind != "forces" && figure.kind != "closure") continue;
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
    for (std::size_t i = 0; i < 3; ++i) {
        const ShapedLine shaped = context.fonts.shape(
            one_piece(word(std::array{"magnitude", "direction", "line"}[i], context.language)), context.theme.small);
        set_text(block.marks, shaped, {0, 6.6 + 3.4 + 4.1 * static_cast<double>(i)}, context.theme.secondary, "text");
        block.width = std::max(block.width, shaped.width);
    }
    block.height = 20;
    return block;
}

Block force_equation_block(const DrawingContext& context, const FreeBody& body, bool with_names) {
    const Solution& solution = context.solution;
    const Theme& theme = context.theme;
    const Language language = context.language;
    Block block;
    if (body.polygon < 0 || body.in_parts || is_open(body)) return block;
    // Forces of one direction are found by moments: no triangle to be closed.
    const auto is_parallel = [&](const AppliedForce& each) {
        const Vector& first = body.forces.front().force;
        return std::abs(cross(each.force, first).to_double()) <=
               least_share(solution.pose, 0) * kinegraph::length(each.force) * kinegraph::length(first);
    };
    if (std::all_of(body.forces.begin(), body.forces.end(), is_parallel)) return block;
    struct Column {
        ShapedLine symbol, line;
        bool magnitude = false, direction = true;
        double width = 0, middle = 0;
    };
    std::vector<Column> columns;
    int sought = 0;
    for (const int index : solution.protocol.polygons[at_index(body.polygon)].vectors) {
        const DrawnVector& vector = solution.protocol.vectors[at_index(index)];
        const auto applied = std::find_if(body.forces.begin(), body.forces.end(), [&](const AppliedForce& each) {
            return !each.force.is_zero() && quantity_of(body, each) == vector.quantity;
        });
        if (applied == body.forces.end()) return {};
        Column column;
        column.magnitude = is_load(applied->kind);
        if (applied->kind == ForceKind::reaction)
            if (const FreeBody* other = opposite(solution, body, *applied)) column.magnitude = other < &body;
        // A hinge whose line nothing gave: both are sought, the polygon has them at once.
        const std::optional<RichText> line = line_of(context, body, *applied);
        column.direction = column.magnitude || applied->kind != ForceKind::reaction || line;
        sought += (column.magnitude ? 0 : 1) + (column.direction ? 0 : 1);
        column.symbol = context.fonts.shape(typeset(vector.symbol, language), theme.equation);
        column.line = context.fonts.shape(line ? *line : one_piece(word("any line", language)), theme.small);
        column.width = std::max({9.0, column.symbol.width + 2, column.line.width + 2.4});
        columns.push_back(std::move(column));
    }
    if (columns.size() < 3 || columns.size() > 5 || sought > 2) return block;

    const ShapedLine tick = context.fonts.shape(one_piece("✓"), 10),
                     question = context.fonts.shape(one_piece("?", Face::bold), 10),
                     plus = context.fonts.shape(one_piece("+"), theme.equation),
                     zero = context.fonts.shape(one_piece("= 0"), theme.equation);
    std::array<ShapedLine, 3> names;
    double x = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!with_names) break;
        names[i] = context.fonts.shape(one_piece(word(std::array{"magnitude", "direction", "line"}[i], language)),
                                       theme.small);
        x = std::max(x, names[i].width + 1.8);
    }
    for (Column& column : columns) {
        if (&column != &columns.front()) x += 2.4;
        column.middle = x + column.width / 2;
        x += column.width;
    }
    const auto centred = [&](const ShapedLine& shaped, double middle, double baseline, Colour colour) {
        set_text(block.marks, shaped, {middle - shaped.width / 2, baseline}, colour, "text");
    };
    const Colour letters = theme.colour_of(body.body).letter;
    double baseline = 4.6, before = 0;
    for (const Column& column : columns) {
        if (&column != &columns.front())
            centred(plus, 0.5 * (before + column.middle - column.symbol.width / 2), baseline, theme.text);
        centred(column.symbol, column.middle, baseline, letters);
        before = column.middle + column.symbol.width / 2;
    }
    set_text(block.marks, zero, {before + 1.8, baseline}, theme.text, "text");
    block.width = std::max(x, before + 1.8 + zero.width);
    const double top = 6.6;
    block.marks.emplace_back(line({0, top}, {block.width, top}, {theme.thin, theme.text, {}, false}));
    for (std::size_t row = 0; row < 3; ++row) {
        baseline = top + 3.4 + 4.1 * static_cast<double>(row);
        if (with_names) set_text(block.marks, names[row], {0, baseline}, theme.secondary, "text");
        for (const Column& column : columns)
            if (row == 2)
                centred(column.line, column.middle, baseline, theme.secondary);
            else
                centred((row == 0 ? column.magnitude : column.direction) ? tick : question, column.middle, baseline,
                        theme.text);
    }
    block.height = baseline + 1.8;
    block.marks.emplace_back(line({0, block.height}, {block.width, block.height}, {theme.thin, theme.text, {}, false}));
    return block;
}

const JointForce* at_the_pair(const Solution& solution, const FreeBody& body, const AppliedForce& applied) {
    if (applied.kind != ForceKind::reaction || applied.force.is_zero()) return nullptr;
    for (const JointForce& each : solution.forces)
        if (each.joint == applied.joint && each.on == body.body && each.from == applied.from && each.couple &&
            !each.couple->is_zero())
            return &each;
    return nullptr;
}

RichText beside_guide(const DrawingContext& context, const FreeBody& body, const AppliedForce& applied) {
    const Solution& solution = context.solution;
    const Mechanism& mechanism = solution.mechanism;
    if (applied.joint == none || body.body == none || applied.kind != ForceKind::reaction || applied.force.is_zero())
        return {};
    const Joint& joint = mechanism.joints[at_index(applied.joint)];
    if (!joint.pair().is_sleeve()) return {};
    const Vector own = solution.pose.at(joint.point), guide = solution.pose.guides[at_index(applied.joint)];
    const double unit_length = kinegraph::length(guide);
    const auto along = [&](const Vector& place) { return dot(place - own, guide).to_double() / unit_length; };
    const double at = along(applied.at), small = 1e-9 * solution.pose.size.to_double();
    if (std::abs(at) <= small) return {};
    // What the guide holds of the slider: its points on the guide's line.
    double least = 0, most = 0;
    for (const PointIndex p : mechanism.bodies[at_index(joint.bodies[0])].points) {
        const Vector& place = solution.pose.at(p);
        if (std::abs(cross(guide, place - own).to_double()) > small * unit_length) continue;
        least = std::min(least, along(place));
        most = std::max(most, along(place));
    }
    if (most - least > small && (at < least - small || at > most + small))
        return one_piece(word("passes outside", context.language));
    const Unit& unit = mechanism.units.length;
    RichText text = one_piece(number(std::abs(at) / unit.si.to_double(), 4, context.language) + " " + unit.symbol +
                              " " + word("passes beside", context.language) + " ");
    append(text, point(mechanism, joint.point, context.language));
    return text;
}

namespace {

/// Rows of forces and couples, each action and its reaction once.
class ForceRows {
public:
    ForceRows(const DrawingContext& context, const std::vector<Figure>& figures, bool at_pairs)
        : solution_(context.solution),
          mechanism_(context.solution.mechanism),
          figures_(figures),
          at_pairs_(at_pairs),
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
    /// Sought efforts that come out as nothing act on no body, and are answers all the same.
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
    /// Of an action on two bodies, of a mass's force and couple.
    bool is_first(const FreeBody& body, const AppliedForce& applied) {
        Quantity quantity = quantity_of(body, applied);
        if (quantity.body > quantity.other) std::swap(quantity.body, quantity.other);
        return seen_.emplace(quantity, applied.force.is_zero()).second;
    }
    /// A couple between two bodies is told as it acts on the one that the file names first.
    std::pair<const FreeBody*, const AppliedForce*> own_end(const FreeBody& body, const AppliedForce& applied) const {
        const auto* couple = applied.kind == ForceKind::effort
                                 ? std::get_if<CoupleEffort>(&mechanism_.efforts[at_index(applied.given)])
                                 : nullptr;
        if (couple == nullptr) return {&body, &applied};
        for (const FreeBody& other : solution_.free_bodies)
            for (const AppliedForce& its : other.forces)
                if (other.body == couple->body && its.kind == ForceKind::effort && its.given == applied.given)
                    return {&other, &its};
        return {&body, &applied};
    }
    /// Where only the reverse is drawn, that is measured.
    Symbol symbol_measured(const FreeBody& body, const AppliedForce& applied) const {
        if (applied.kind != ForceKind::reaction || measured(figures_, name_of(applied.symbol))) return applied.symbol;
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

    /// By how much the one force lies beside the pair: d = M/F.
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
    CheckedNumbers checks_;
    std::set<std::pair<Quantity, bool>> seen_;
    std::vector<ResultRow> forces_, couples_;
};

}  // namespace

std::vector<ResultRow> force_rows(const DrawingContext& context, const std::vector<Figure>& figures, bool at_pairs) {
    if (context.solution.truss && context.solution.free_bodies.empty()) return truss_rows(context, figures);
    if (context.solution.free_bodies.empty() && context.solution.efforts.empty()) return {};
    return ForceRows(context, figures, at_pairs).rows();
}

std::vector<const FreeBody*> closed_by(const Solution& solution, StatementIndex statement) {
    std::vector<const FreeBody*> closed;
    for (const FreeBody& body : solution.free_bodies)
        if (!body.in_parts && body.statement == statement) closed.push_back(&body);
    return closed;
}

std::vector<Block> reaction_lines(const DrawingContext& context, double width) {
    const Solution& solution = context.solution;
    const Mechanism& mechanism = solution.mechanism;
    const Theme& theme = context.theme;
    const Language language = context.language;
    std::vector<Block> lines;
    if (solution.free_bodies.empty()) return lines;
    const auto symbol_of = [&](const AppliedForce& applied) {
        return typeset(applied.force.is_zero() ? couple_symbol(applied) : applied.symbol, language);
    };
    const auto joined = [&](const std::vector<RichText>& parts) {
        RichText all;
        for (const RichText& part : parts) {
            if (!all.empty()) append(all, ", ");
            append(all, part);
        }
        return parts.empty() ? one_piece("–") : all;
    };
    // As wide as the words ask, and no name takes the room of what acts.
    constexpr double most_of_name = 0.3;
    double name_width = context.fonts.shape(one_piece(word("body", language)), theme.small).width,
           active_width = context.fonts.shape(one_piece(word("active forces", language)), theme.small).width;
    for (const FreeBody& body : solution.free_bodies) {
        const std::string name = body.body != none
                                     ? body_name(mechanism, body.body)
                                     : word("pin", language) + " " + mechanism.points[at_index(body.pin)].name;
        name_width = std::max(name_width, context.fonts.shape(one_piece(name), theme.body_text).width);
        std::vector<RichText> active;
        for (const AppliedForce& applied : body.forces)
            if (applied.kind != ForceKind::reaction && applied.kind != ForceKind::resultant) {
                active.push_back(symbol_of(applied));
                if (applied.joint != none) append(active.back(), " (M)");
            }
        active_width = std::max(active_width, context.fonts.shape(joined(active), theme.body_text).width);
    }
    name_width =
        std::max(name_width, context.fonts.shape(one_piece(frame_name(mechanism, language)), theme.body_text).width);
    name_width = std::min(name_width, most_of_name * width);
    const double active_left = name_width + 4, active_room = std::min(active_width + 0.5, 0.4 * width);
    const double reactions_left = active_left + active_room + 4;
    const auto add = [&](const std::string& name, Colour colour, const RichText& active, const RichText& reactions,
                         bool rule_above) {
        Block block;
        if (rule_above) block.marks.emplace_back(line({0, 0}, {width, 0}, {theme.thin, theme.secondary, {}, false}));
        block.width = width;
        double deepest = 0;
        const auto fill = [&](std::vector<ShapedLine> set, double left, Colour letters) {
            double baseline = 3.6;
            for (ShapedLine& each : set) {
                block.width = std::max(block.width, left + each.width);
                set_text(block.marks, std::move(each), {left, baseline}, letters, "text");
                baseline += 4.3;
            }
            deepest = std::max(deepest, baseline);
        };
        const auto broken = [&](const RichText& text, double room) {
            return lines_in_cell(text, theme.body_text, context.fonts, room);
        };
        fill(broken(one_piece(name), name_width), 0, colour);
        fill(broken(active, active_room), active_left, theme.text);
        // Reactions that would have to shrink in a narrow column leave it, by which it is known to be too narrow for
        // the table.
        constexpr double narrow = 60;
        const double room = width - reactions_left;
        fill(width < narrow ? context.fonts.wrap(reactions, theme.body_text, room) : broken(reactions, room),
             reactions_left, theme.text);
        block.height = deepest - 3.6 + 0.5;
        lines.push_back(std::move(block));
    };
    {
        Block head;
        head.marks.emplace_back(line({0, 0}, {width, 0}, {theme.outline, theme.text, {}, false}));
        const auto put = [&](const std::string& key, double x) {
            set_text(head.marks, context.fonts.shape(one_piece(word(key, language)), theme.small), {x, 3.4},
                     theme.secondary, "text");
        };
        put("body", 0);
        put("active forces", active_left);
        put("reactions", reactions_left);
        head.marks.emplace_back(line({0, 4.8}, {width, 4.8}, {theme.thin, theme.text, {}, false}));
        head.width = width;
        head.height = 5.0;
        lines.push_back(std::move(head));
    }
    std::vector<RichText> on_frame;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < solution.free_bodies.size(); ++i) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const auto rank = [&](std::size_t i) {
            const BodyIndex body = solution.free_bodies[i].body;
            return std::pair{body == none, body};
        };
        return rank(a) < rank(b);
    });
    const RichText* example = nullptr;
    std::pair<BodyIndex, BodyIndex> example_bodies{none, none};
    std::vector<RichText> kept;
    kept.reserve(solution.free_bodies.size() * 8);
    for (const std::size_t i : order) {
        const FreeBody& body = solution.free_bodies[i];
        std::vector<RichText> active, reactions;
        for (const AppliedForce& applied : body.forces) {
            if (applied.kind == ForceKind::resultant) continue;  // it acts on nothing
            RichText text = symbol_of(applied);
            if (applied.kind == ForceKind::reaction && !example && applied.from != none && body.body != none) {
                kept.push_back(text);
                example = &kept.back();
                example_bodies = {applied.from, body.body};
            }
            if (applied.joint != none) {
                append(text, " (");
                append(text, point(mechanism, mechanism.joints[at_index(applied.joint)].point, language));
                append(text, ")");
            }
            (applied.kind == ForceKind::reaction ? reactions : active).push_back(std::move(text));
            if (applied.kind == ForceKind::reaction && applied.from == frame && body.body > frame) {
                const std::string& own = body_name(mechanism, body.body);
                const std::string& fixed = body_name(mechanism, frame);
                Symbol back{applied.force.is_zero() ? Symbol::Letter::M : Symbol::Letter::F,
                            own.size() == 1 && fixed.size() == 1 ? own + fixed : own + "," + fixed,
                            applied.symbol.term};
                RichText action = typeset(back, language);
                append(action, " = −");
                append(action, symbol_of(applied));
                on_frame.push_back(std::move(action));
            }
        }
        const std::string name = body.body != none
                                     ? body_name(mechanism, body.body)
                                     : word("pin", language) + " " + mechanism.points[at_index(body.pin)].name;
        add(name, theme.colour_of(body.body).letter, joined(active), joined(reactions), false);
    }
    if (!on_frame.empty())
        add(frame_name(mechanism, language), theme.secondary, one_piece("–"), joined(on_frame), true);
    lines.back().marks.emplace_back(line({0, lines.back().height + 0.3}, {width, lines.back().height + 0.3},
                                         {theme.outline, theme.text, {}, false}));
    lines.back().height += 0.6;
    if (example) {
        std::string words = word("action and reaction", language);
        const auto fill = [&](const std::string& place, BodyIndex body) {
            if (const std::size_t found = words.find(place); found != std::string::npos)
                words.replace(found, place.size(), body_name(mechanism, body));
        };
        fill("{0}", example_bodies.first);
        fill("{1}", example_bodies.second);
        RichText text = *example;
        append(text, " " + words);
        if (!closed_polygons(solution).empty()) append(text, " " + word("internal sides", language));
        Block note;
        double baseline = 4.2;
        for (ShapedLine& each : context.fonts.wrap(text, theme.small, width)) {
            set_text(note.marks, std::move(each), {0, baseline}, theme.secondary, "text");
            baseline += 3.9;
        }
        note.width = width;
        note.height = baseline - 3.4;
        lines.push_back(std::move(note));
    }
    return lines;
}

}  // namespace kinegraph::render
