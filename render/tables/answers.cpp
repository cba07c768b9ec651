// Answers: see answers.hpp. The tolerance of a product or quotient follows from its two readings, each with an error of
// half a millimetre.
#include "render/tables/answers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/file/units.hpp"
#include "engine/number/functions.hpp"
#include "engine/results/result_expression.hpp"
#include "engine/results/result_names.hpp"
#include "engine/sentences/centre_symbol.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "engine/solution/displacements.hpp"
#include "engine/solution/sliding.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/sheet.hpp"
#include "render/page/shapes.hpp"
#include "render/tables/force_tables.hpp"
#include "render/tables/tables.hpp"

namespace kinegraph::render {
namespace {

using Kind = Quantity::Kind;

/// To the range from 0 to 360.
double whole_turn(double degrees) { return degrees < 0 ? degrees + 360 : degrees; }
double degrees_of(const Vector& vector) {
    return whole_turn(nearest::atan2(vector.y.to_double(), vector.x.to_double()) * 180 / std::numbers::pi);
}

/// Whether the file's drivers give the quantity.
bool is_driven(const Mechanism& mechanism, const Quantity& quantity) {
    return std::any_of(mechanism.drivers.begin(), mechanism.drivers.end(), [&](const Driver& driver) {
        const auto* spin = std::get_if<SpinDriver>(&driver);
        return spin != nullptr && spin->relative_to == frame && spin->body == quantity.body;
    });
}

/// The bodies with the same rotation as `body`, itself first: sleeves, guides and clamps prevent relative rotation.
std::vector<BodyIndex> turning_with(const Mechanism& mechanism, BodyIndex body) {
    std::vector<BodyIndex> all{body};
    for (std::size_t known = 0; known < all.size(); ++known)
        for (const Joint& joint : mechanism.joints) {
            if (!joint.pair().holds_rotation || !joint.connects(all[known])) continue;
            for (const BodyIndex other : joint.bodies)
                if (std::find(all.begin(), all.end(), other) == all.end()) all.push_back(other);
        }
    return all;
}

class Answers {
public:
    Answers(const DrawingContext& context, const std::vector<Figure>& drawn)
        : solution_(context.solution),
          mechanism_(context.solution.mechanism),
          motion_(result_rows(context, drawn)),
          forces_(force_rows(context, drawn)) {
        for (const Figure& figure : drawn) {
            if (!length_scale_ && figure.traits.measured == QuantityKind::length) length_scale_ = figure.scale;
            if (figure.traits.measured == QuantityKind::force)
                force_scale_ = std::max(force_scale_.value_or(0), figure.scale * mechanism_.units.force.si.to_double());
        }
    }

    std::vector<Answer> all(bool with_centres) && {
        if (with_centres) add_centres();
        for (const ResultRow& row : motion_) add_motion(row);
        for (const ResultRow& row : forces_) add_force(row);
        add_efforts();
        return std::move(answers_);
    }

private:
    void add_centres() {
        const Find& find = mechanism_.find;
        if (find.stated && !find.instant_centres && !solution_.instantaneous_motion) return;
        const Unit& unit = mechanism_.units.length;
        const double si = unit.si.to_double();
        for (const InstantCentre& centre : solution_.centres) {
            if (!centre.at || centre.everywhere || centre.how == InstantCentre::How::primary) continue;
            Answer answer{centre_symbol(mechanism_, centre.first, centre.second, centre.at->at_infinity()),
                          Topic::centres, 0, unit.symbol};
            if (centre.at->at_infinity()) {
                answer.direction = std::fmod(degrees_of(centre.at->place()), 180.0);
            } else {
                const Vector place = centre.at->place();
                answer.at = {place.x.to_double() / si, place.y.to_double() / si};
                if (length_scale_) answer.tolerance = reading_by_hand * *length_scale_ / si;
            }
            answers_.push_back(std::move(answer));
        }
    }

    void add_motion(const ResultRow& row) {
        const Quantity& quantity = row.quantity;
        const bool turning = result_kind(quantity).turns();
        if (turning && is_driven(mechanism_, quantity)) return;
        const bool relative_motion = row.group.section == Topic::relative_motion;
        const bool sought = turning || quantity.part == Quantity::Part::whole ||
                            quantity.part == Quantity::Part::sliding ||
                            (relative_motion && quantity.part != Quantity::Part::transport);
        if (!sought || quantity.kind == Kind::unnamed) return;
        Answer answer{row.symbol, row.group.section, row.drawing, row.unit};
        answer.quantity = quantity;
        if (turning) {
            read_turning(row, answer);
        } else {
            read_vector(row, answer);
            answer.direction = direction_of_motion(row);
        }
        answers_.push_back(std::move(answer));
    }
    static void read_vector(const ResultRow& row, Answer& answer) {
        answer.tolerance = tolerance_of_vector(row);
        answer.read_off = row.symbol;
        answer.detail = row.detail;
    }
    static std::optional<double> tolerance_of_vector(const ResultRow& row) {
        if (!row.millimetres || !(*row.millimetres > 0)) return std::nullopt;
        return reading_by_hand * std::abs(row.drawing) / *row.millimetres;
    }
    std::optional<double> direction_of_motion(const ResultRow& row) const {
        for (const DrawnVector& vector : solution_.protocol.vectors)
            if (vector.quantity == row.quantity && name_of(vector.symbol) == row.name)
                if (const Vector value = solution_.protocol.value_of(vector); !value.is_zero())
                    return degrees_of(value);
        return std::nullopt;
    }

    /// Tolerance of ω or α as the quotient of a vector and a length: the pair that reads most accurately, on any of the
    /// bodies that rotate together.
    void read_turning(const ResultRow& row, Answer& answer) const {
        if (!length_scale_ || row.drawing == 0) return;
        const bool is_omega = result_kind(row.quantity).is_velocity();
        const double turning = std::abs(found_turning(row.quantity));
        const std::vector<BodyIndex> together = turning_with(mechanism_, row.quantity.body);
        const ResultRow* best = nullptr;
        double least = 0;
        for (const ResultRow& other : motion_) {
            const Quantity& q = other.quantity;
            if (!other.millimetres || !(*other.millimetres > 0) ||
                q.kind != (is_omega ? Kind::velocity : Kind::acceleration))
                continue;
            double radius = 0;
            if (q.part == (is_omega ? Quantity::Part::relative : Quantity::Part::tangential)) {
                const Unit& unit = is_omega ? mechanism_.units.velocity : mechanism_.units.acceleration;
                const bool own =
                    std::any_of(together.begin(), together.end(), [&](BodyIndex body) { return is_across(body, q); });
                if (own) radius = other.drawing * unit.si.to_double() / turning;
            } else if (is_omega && q.part == Quantity::Part::whole) {
                for (const BodyIndex body : together) radius = std::max(radius, distance_from_pivot(body, q));
            }
            if (!(radius > 0)) continue;
            const double share = reading_by_hand / *other.millimetres + reading_by_hand * *length_scale_ / radius;
            if (best == nullptr || share < least) best = &other, least = share;
        }
        if (best == nullptr) return;
        answer.tolerance = least * std::abs(row.drawing);
        answer.read_off = best->symbol;
        answer.detail = best->detail;
    }
    /// Whether a component of a motion is that of one point of the body relative to another point of the same body. (A
    /// pin is attributed to one of its bodies, but a pin of coupler and rocker turns about the rocker's pivot with the
    /// rocker.)
    bool is_across(BodyIndex body, const Quantity& part) const {
        const bool has_tip = part.body == body || carries(body, part.point);
        return has_tip && (part.seen_from == none || part.other == body || carries(body, part.seen_from));
    }
    double found_turning(const Quantity& quantity) const {
        const BodyMotion& motion = solution_.bodies[at_index(quantity.body)];
        const auto& value = result_kind(quantity).is_velocity() ? motion.omega : motion.alpha;
        return value ? value->to_double() : 0;
    }
    bool carries(BodyIndex body, PointIndex point) const {
        const std::vector<PointIndex>& points = mechanism_.body(body).points;
        return point != none && std::find(points.begin(), points.end(), point) != points.end();
    }
    /// Distance (m) of a point from the frame pin about which its body rotates; 0 if there is none.
    double distance_from_pivot(BodyIndex body, const Quantity& velocity) const {
        const PointIndex point = velocity.point;
        if (velocity.body != body && !carries(body, point)) return 0;
        for (const Joint& joint : mechanism_.joints)
            if (joint.pair().is_hinge() && joint.connects(body) && joint.connects(frame))
                return kinegraph::length(solution_.pose.at(point) - solution_.pose.at(joint.point));
        return 0;
    }

    void add_force(const ResultRow& row) {
        const Kind kind = row.quantity.kind;
        if (kind != Kind::force && kind != Kind::couple && kind != Kind::effort && kind != Kind::bar) return;
        if (row.symbol.letter == Symbol::Letter::length) return;  // the displacement of a force follows from its couple
        Answer answer{row.symbol, Topic::forces, row.drawing, row.unit};
        answer.quantity = row.quantity;
        if (row.group.couples) {
            if (kind == Kind::force) answer.quantity.kind = Kind::couple;
            read_couple(row, answer);
        } else {
            read_vector(row, answer);
            for (const FreeBody& body : solution_.free_bodies)
                for (const AppliedForce& applied : body.forces)
                    if (!answer.direction && !applied.force.is_zero() && name_of(applied.symbol) == row.name)
                        answer.direction = degrees_of(applied.force);
            if (solution_.truss && kind == Kind::force)
                for (const Truss::External& external : solution_.truss->externals)
                    if (external.joint == row.quantity.joint && !answer.direction)
                        answer.direction = degrees_of(*external.force);
        }
        if (kind == Kind::effort && !row.group.couples) count_along_its_line(answer);
        answers_.push_back(std::move(answer));
    }
    /// A balancing force is requested with its sense, so the answer is its signed component, not its magnitude.
    void count_along_its_line(Answer& answer) const {
        const std::size_t e = at_index(answer.quantity.given);
        if (e >= solution_.efforts.size() || !solution_.efforts[e].value) return;
        answer.value = std::copysign(answer.value, solution_.efforts[e].value->to_double());
        answer.direction = sense_of(mechanism_.efforts[e]);
    }
    /// Degrees; empty for a couple.
    std::optional<double> sense_of(const Effort& effort) const {
        if (const auto* force = std::get_if<ForceEffort>(&effort))
            return degrees_of(direction_of(force->along, solution_.pose));
        if (const auto* actuator = std::get_if<ActuatorEffort>(&effort)) {
            const VectorOf<double> along = direction_of_sliding(solution_.pose, actuator->joint);
            return whole_turn(nearest::atan2(along.y, along.x) * 180 / std::numbers::pi);
        }
        return std::nullopt;
    }
    /// Input forces and couples that virtual work found without reactions: positive along their lines, and calculated
    /// rather than read.
    void add_efforts() {
        const std::vector<EffortValue> efforts = efforts_found(solution_);
        for (std::size_t e = 0; e < efforts.size(); ++e) {
            if (!efforts[e].value || (e < solution_.efforts.size() && solution_.efforts[e].value)) continue;
            const bool couple = std::holds_alternative<CoupleEffort>(mechanism_.efforts[e]);
            const Unit& unit = couple ? mechanism_.units.moment : mechanism_.units.force;
            Answer answer{Symbol{couple ? Symbol::Letter::M : Symbol::Letter::F, efforts[e].name, ""}, Topic::forces,
                          efforts[e].value->to_double() / unit.si.to_double(), unit.symbol};
            answer.quantity = {.kind = Kind::effort, .given = static_cast<int>(e)};
            answer.direction = sense_of(mechanism_.efforts[e]);
            answers_.push_back(std::move(answer));
        }
    }
    /// The row that reads most accurately, in a detail or not.
    const ResultRow* row_of_force(const std::string& name) const {
        for (const ResultRow& row : forces_)
            if (row.name == name && !row.group.couples && tolerance_of_vector(row)) return &row;
        return nullptr;
    }
    /// M = F·h with the largest force on the body; both are read.
    void read_couple(const ResultRow& row, Answer& answer) const {
        if (!length_scale_ || !force_scale_) return;
        const AppliedForce* largest = nullptr;
        BodyIndex on = row.quantity.body;
        if (row.quantity.kind == Kind::effort)
            if (const auto* effort = std::get_if<CoupleEffort>(&mechanism_.efforts[at_index(row.quantity.given)]))
                on = effort->body;
        for (const FreeBody& body : solution_.free_bodies)
            if (body.body == on)
                for (const AppliedForce& applied : body.forces)
                    if (largest == nullptr || kinegraph::length(applied.force) > kinegraph::length(largest->force))
                        largest = &applied;
        const double force = largest == nullptr ? 0 : kinegraph::length(largest->force);
        if (!(force > 0)) return;
        const ResultRow* read = row_of_force(name_of(largest->symbol));
        const double off = read == nullptr ? reading_by_hand * *force_scale_
                                           : *tolerance_of_vector(*read) * mechanism_.units.force.si.to_double();
        const double si = mechanism_.units.moment.si.to_double(), arm = std::abs(row.drawing) * si / force;
        answer.tolerance = (reading_by_hand * *length_scale_ * force + arm * off) / si;
        if (read != nullptr) answer.read_off = read->symbol, answer.detail = read->detail;
    }

    const Solution& solution_;
    const Mechanism& mechanism_;
    std::vector<ResultRow> motion_, forces_;
    std::optional<double> length_scale_;  // m per mm
    std::optional<double> force_scale_;   // N per mm, the coarsest
    std::vector<Answer> answers_;
};

/// The significant decimals for a tolerance.
int decimals_of(double tolerance) {
    return std::clamp(static_cast<int>(-std::floor(nearest::log10(tolerance) + 1e-9)), 0, 9);
}
struct AnswerCells {
    std::array<ShapedLine, 5> all;  // quantity, value, tolerance, unit, direction
};

class AnswerTable {
public:
    AnswerTable(const DrawingContext& context, const std::vector<Answer>& answers) : context_(context) {
        const auto is_told = [](const Answer& each) { return each.tolerance.has_value(); };
        tolerances_ = std::any_of(answers.begin(), answers.end(), is_told);
        for (std::size_t c = 0; c < 5; ++c) head_.all[c] = shape(head_word(c), context.theme.small);
        for (const Answer& each : answers) lines_.push_back(cells_of(each));
    }

    std::vector<Block> lines(double width) const {
        std::array<double, 5> widths{};
        for (std::size_t c = 0; c < 5; ++c) {
            widths[c] = head_.all[c].width;
            for (const AnswerCells& line : lines_) widths[c] = std::max(widths[c], line.all[c].width);
        }
        double sum = 0;
        for (const double each : widths) sum += each;
        const double between = std::clamp((width - sum) / 4, 1.2, 6.0);
        std::vector<Block> blocks{row(head_, widths, between, context_.theme.secondary)};
        const double whole = sum + 4 * between;
        add_rule(blocks.front(), 0, whole, context_.theme.outline);
        add_rule(blocks.front(), 4.8, whole, context_.theme.thin);
        blocks.front().height = 5.2;
        for (const AnswerCells& line : lines_) blocks.push_back(row(line, widths, between, context_.theme.text));
        if (blocks.size() > 1) add_rule(blocks.back(), blocks.back().height, whole, context_.theme.outline);
        return blocks;
    }

private:
    ShapedLine shape(const std::string& text, double size) const {
        return context_.fonts.shape(with_powers(text), size);
    }
    std::string head_word(std::size_t column) const {
        switch (column) {
            case 1: return word(lang::common::value, context_.language);
            case 2: return tolerances_ ? "±" : "";
            case 3: return word(lang::sheet::unit, context_.language);
            case 4: return word(lang::sheet::direction, context_.language);
            default: return "";
        }
    }
    AnswerCells cells_of(const Answer& answer) const {
        const Language language = context_.language;
        const double size = context_.theme.body_text;
        RichText name = answer.words.empty() ? typeset(answer.symbol, language) : answer.words;
        if (!answer.at)
            for (Piece& piece : name)
                if (piece.face == Face::bold_italic) piece.face = Face::italic;  // the magnitude of the vector
        AnswerCells cells;
        cells.all[0] = context_.fonts.shape(name, size + 0.5);
        const auto value = [&](double v) {
            constexpr double too_long = 1e6;
            if (!answer.tolerance || std::abs(v) >= too_long) return number(v, 4, language);
            return fixed(v, decimals_of(*answer.tolerance), language);
        };
        const bool turns =
            answer.symbol.letter == Symbol::Letter::omega || answer.symbol.letter == Symbol::Letter::alpha;
        std::string text = value(answer.value);
        if (turns && answer.value > 0) text.insert(0, "+");
        if (answer.at) text = pair_of(value((*answer.at)[0]), value((*answer.at)[1]), language);
        // A coordinate of a centre is a number.
        const bool at_infinity =
            answer.section == Topic::centres && !answer.at && answer.quantity.component == Quantity::Component::whole;
        cells.all[1] = shape(at_infinity ? word(lang::sheet::at_infinity, language) : text, size);
        if (answer.tolerance) cells.all[2] = shape(number(rounded_up(*answer.tolerance), 1, language), size);
        if (!at_infinity) cells.all[3] = shape(answer.unit, size);
        if (answer.direction) cells.all[4] = shape(fixed(*answer.direction, 1, language) + "°", size);
        return cells;
    }
    Block row(const AnswerCells& cells, const std::array<double, 5>& widths, double between, Colour colour) const {
        constexpr double pitch = 4.6, baseline = 3.5;
        Block block;
        double x = 0;
        for (std::size_t c = 0; c < 5; ++c) {
            const bool right = c == 1 || c == 2 || c == 4;
            const double at = right ? x + widths[c] - cells.all[c].width : x;
            if (cells.all[c].width > 0) set_text(block.marks, cells.all[c], {at, baseline}, colour, "text");
            x += widths[c] + between;
        }
        block.width = x - between;
        block.height = pitch;
        return block;
    }
    void add_rule(Block& block, double y, double width, double pen) const {
        block.marks.emplace_back(line({0, y}, {width, y}, {pen, context_.theme.text, {}, false}));
    }

    const DrawingContext& context_;
    bool tolerances_ = false;
    AnswerCells head_;
    std::vector<AnswerCells> lines_;
};

/// Whether an answer is the requested result, or the vector of which it is a component. Action and reaction count as
/// one.
bool is_of(const Answer& answer, const Column& column, const Mechanism& mechanism) {
    if (column.kind != Column::Kind::result && column.kind != Column::Kind::along) return false;
    const Quantity wanted = column.quantity.along(Quantity::Component::whole);
    Quantity own = answer.quantity;
    if (own == wanted) return true;
    if (wanted.kind == Kind::sliding_velocity || wanted.kind == Kind::sliding_acceleration)
        return is_of_sliding(own, wanted.joint, wanted.kind == Kind::sliding_acceleration, mechanism);
    if (own.kind != wanted.kind) return false;
    if (own.kind == Kind::velocity || own.kind == Kind::acceleration) {
        own.body = wanted.body;  // any body that contains the point, if only one vector has this name
        return own == wanted;
    }
    if (own.kind != Kind::force && own.kind != Kind::couple) return false;
    std::swap(own.body, own.other);
    return own == wanted;
}

/// The value of half a millimetre on the first figure with a scale of that kind; 0 if there is none.
double half_a_millimetre(const std::vector<Figure>& drawn, QuantityKind kind, const Units& units) {
    for (const Figure& figure : drawn) {
        if (!figure.has_scale) continue;
        if (figure.traits.measured != kind) continue;
        // Polygons: in the file's unit per millimetre.
        const double unit = kind == QuantityKind::length ? 1 : unit_of(kind, units).si.to_double();
        return reading_by_hand * (figure.scale * unit);
    }
    return 0;
}

/// Whether the velocities or accelerations of a section are only intermediate results of what `find` requests.
bool is_on_the_way(const Find& find, Topic section) {
    if (!find.stated) return false;
    const bool later = find.acceleration || find.forces;
    return (section == Topic::velocity && !find.velocity && later) ||
           (section == Topic::acceleration && !find.acceleration && find.forces);
}

/// The section of the key that lists results of this kind.
Topic section_of(const Column& column) {
    switch (column.unit) {
        case QuantityKind::velocity:
        case QuantityKind::angular_velocity: return Topic::velocity;
        case QuantityKind::acceleration:
        case QuantityKind::angular_acceleration: return Topic::acceleration;
        case QuantityKind::force:
        case QuantityKind::moment:
        case QuantityKind::power: return Topic::forces;
        case QuantityKind::length:
            return column.quantity.kind == Quantity::Kind::centre ? Topic::centres : Topic::unnamed;
        default: return Topic::unnamed;
    }
}

/// Of an expression: what it may be off where each of its parts is off by its own tolerance. None: not determined.
std::optional<double> tolerance_of_expression(const ResultExpression& expression, const std::vector<Answer>& answers,
                                              const std::vector<Figure>& drawn,
                                              const std::vector<RequestedResult>& found, const Mechanism& mechanism) {
    std::vector<ValueWithin> parts;
    for (const Column& part : expression.parts()) {
        const auto value = std::find_if(found.begin(), found.end(),
                                        [&](const RequestedResult& each) { return each.column.name == part.name; });
        if (value == found.end()) return std::nullopt;
        if (part.kind == Column::Kind::parameter) {
            parts.push_back({value->value, 0});
            continue;
        }
        const auto made_of = expression_called(part.name, mechanism);
        const auto off = made_of ? tolerance_of_expression(*made_of, answers, drawn, found, mechanism)
                                 : reading_tolerance(answers, drawn, part, value->value, mechanism);
        if (!off) return std::nullopt;
        parts.push_back({value->value, *off});
    }
    const auto within = expression.value(parts);
    return within ? std::optional(within->error) : std::nullopt;
}

/// `found`: all values, of which an expression is made.
Answer told_by_name(const DrawingContext& context, const std::vector<Answer>& answers, const std::vector<Figure>& drawn,
                    const RequestedResult& asked, const std::vector<RequestedResult>& found) {
    const Mechanism& mechanism = context.solution.mechanism;
    Answer answer{{}, section_of(asked.column), asked.value / asked.unit_size, asked.unit};
    if (const auto expression = expression_called(asked.column.name, mechanism)) {
        answer.tolerance = tolerance_of_expression(*expression, answers, drawn, found, mechanism);
    } else {
        answer.tolerance = reading_tolerance(answers, drawn, asked.column, asked.value, mechanism);
    }
    answer.words = asked.symbol;
    if (answer.tolerance) *answer.tolerance /= asked.unit_size;
    if (answer.tolerance && !(*answer.tolerance > 0)) answer.tolerance.reset();
    answer.quantity = asked.column.quantity;
    if (asked.column.kind == Column::Kind::along) {
        const VectorOf<double> positive = direction_of_sliding(context.solution.pose, asked.column.quantity.joint);
        answer.direction = whole_turn(nearest::atan2(positive.y, positive.x) * 180 / std::numbers::pi);
    }
    return answer;
}

/// A force or a couple as it acts on the body for which it is requested; other answers unchanged.
Answer as_asked(Answer answer, const Column& column, const Solution& solution) {
    const Quantity& wanted = column.quantity;
    if (wanted.kind != Kind::force && wanted.kind != Kind::couple) return answer;
    for (const JointForce& each : solution.forces) {
        if (each.joint != wanted.joint || each.on != wanted.body || each.from != wanted.other) continue;
        answer.quantity = wanted;
        answer.symbol = symbol_of_action(wanted, solution.mechanism);
        if (wanted.kind == Kind::couple && each.couple)
            answer.value = std::copysign(answer.value, each.couple->to_double());
        if (answer.direction && each.force) answer.direction = degrees_of(*each.force);
    }
    return answer;
}

/// Rank of a section among those of a solution; results without a section come first.
int order_of(Topic section) {
    switch (section) {
        case Topic::unnamed: return 0;
        case Topic::centres: return 1;
        case Topic::velocity: return 2;
        case Topic::acceleration: return 3;
        case Topic::relative_motion: return 4;
        case Topic::curvature: return 5;
        case Topic::forces: break;
    }
    return 6;
}

}  // namespace

double rounded_up(double tolerance) {
    const double power = nearest::pow(10.0, std::floor(nearest::log10(tolerance) + 1e-9));
    return std::ceil(tolerance / power - 1e-6) * power;
}

double reading_tolerance(const std::vector<Answer>& answers, const std::vector<Figure>& drawn, const Column& column,
                         double value, const Mechanism& mechanism) {
    constexpr double half_a_degree = std::numbers::pi / 360, calculated = 0.01;
    for (const Answer& each : answers)
        if (each.tolerance && is_of(each, column, mechanism))
            if (const KnownUnit* unit = unit_spelt(each.unit)) return *each.tolerance * unit->si.to_double();
    const Tolerance::Reading reading = tolerance_of(column.unit).reading;
    if (reading == Tolerance::Reading::protractor) return half_a_degree;
    const double on_paper =
        reading == Tolerance::Reading::in_scale ? half_a_millimetre(drawn, column.unit, mechanism.units) : 0;
    return on_paper > 0 ? on_paper : calculated * std::abs(value);
}

std::vector<Answer> answers_of(const DrawingContext& context, const std::vector<Figure>& drawn, bool with_centres) {
    return Answers(context, drawn).all(with_centres);
}

std::vector<Answer> answers_sought(const Mechanism& mechanism, std::vector<Answer> answers) {
    const std::vector<Column> columns = asked_columns(mechanism);
    if (columns.empty()) return answers;
    std::erase_if(answers, [&](const Answer& each) {
        return std::none_of(columns.begin(), columns.end(),
                            [&](const Column& column) { return is_of(each, column, mechanism); });
    });
    return answers;
}

std::vector<Answer> key_of(const DrawingContext& context, const std::vector<Figure>& drawn,
                           const std::vector<RequestedResult>& asked) {
    const Mechanism& mechanism = context.solution.mechanism;
    std::vector<Answer> answers = answers_of(context, drawn);
    const std::vector<Column> columns = asked_columns(mechanism);
    if (columns.empty()) {
        std::erase_if(answers, [&](const Answer& each) { return is_on_the_way(mechanism.find, each.section); });
        return answers;
    }
    // Section by section: a component follows its vector, and results without a vector come first.
    std::vector<std::pair<std::pair<int, std::ptrdiff_t>, Answer>> placed;
    const auto put = [&](std::ptrdiff_t place, Answer answer) {
        const int section = order_of(answer.section);
        placed.emplace_back(std::pair(section, place), std::move(answer));
    };
    for (const Column& column : columns) {
        const auto of = std::find_if(answers.begin(), answers.end(),
                                     [&](const Answer& each) { return is_of(each, column, mechanism); });
        const std::ptrdiff_t place = of == answers.end() ? -1 : of - answers.begin();
        const auto has_name = [&](const RequestedResult& each) { return each.column.name == column.name; };
        const auto value = std::find_if(asked.begin(), asked.end(), has_name);
        const bool is_whole =
            column.kind == Column::Kind::result && column.quantity.component == Quantity::Component::whole;
        if (place >= 0 && is_whole) {
            Answer whole = as_asked(*of, column, context.solution);
            if (!whole.tolerance && value != asked.end())
                whole.tolerance = told_by_name(context, answers, drawn, *value, asked).tolerance;
            put(place, std::move(whole));
        } else if (value != asked.end())
            put(place, told_by_name(context, answers, drawn, *value, asked));
    }
    std::stable_sort(placed.begin(), placed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Answer> key;
    for (auto& [place, answer] : placed) key.push_back(std::move(answer));
    return key;
}

std::vector<Answer> unreadable(const std::vector<Answer>& answers) {
    std::vector<Answer> all;
    for (const Answer& each : answers)
        if (!each.at && each.tolerance && each.value != 0 && rounded_up(*each.tolerance) >= std::abs(each.value))
            all.push_back(each);
    return all;
}

std::vector<Block> answer_lines(const DrawingContext& context, const std::vector<Answer>& answers, double width) {
    return AnswerTable(context, answers).lines(width);
}

}  // namespace kinegraph::render
