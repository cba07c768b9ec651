#include "engine/board/board.hpp"

#include <algorithm>

#include "engine/mechanism/rounding.hpp"
#include "engine/number/assert.hpp"

namespace kinegraph {
namespace {

template <class Of>
std::size_t position(ListIndex<Of> index) {
    KG_ASSERT(index != none, "a handle that no stroke made");
    return at_index(index);
}

Verb verb_of(const Value& given) {
    if (std::holds_alternative<ProjectivePoint>(given)) return Verb::given_point;
    return std::holds_alternative<Vector>(given) ? Verb::given_vector : Verb::given_scalar;
}

Plane plane_of(Given::Kind kind) {
    switch (kind) {
        case Given::Kind::driver_velocity:
        case Given::Kind::act_velocity: return Plane::velocity;
        case Given::Kind::driver_acceleration:
        case Given::Kind::act_acceleration:
        case Given::Kind::gravity: return Plane::acceleration;
        case Given::Kind::load_force:
        case Given::Kind::load_magnitude:
        case Given::Kind::mass:
        case Given::Kind::inertia: return Plane::force;
        default: return Plane::drawing;
    }
}

}  // namespace

const Value& Board::Memory::value(ElementIndex i) const { return values[position(i)]; }

Board::Board(const Mechanism& mechanism, const Pose& pose, std::function<const Pose&()> finer)
    : mechanism_(mechanism), pose_(pose), finer_pose_(std::move(finer)) {
    largest_.vector[static_cast<std::size_t>(Plane::drawing)] = magnitude_of(pose.size);
    constexpr std::size_t enough_for_most = 128;
    memory_.values.reserve(enough_for_most);
    protocol_.program.strokes.reserve(enough_for_most);
    if (!pose.is_rounded()) return;
    protocol_.program.doubtful_bits = bits_in_question(pose.rounding());
    constexpr int digits_of_a_shift = 200;  // a bit more than twice as fine as any precision that a file may state
    for (const ShiftedDrawing& each : *pose.shifted)
        shifted_.push_back(echo_on(each.mechanism, each.pose, digits_of_a_shift));
}

Board::Echo Board::echo_on(const Mechanism& mechanism, const Pose& pose, int digits) const {
    Echo echo{mechanism, pose, digits, {}, {}};
    echo.largest.vector[static_cast<std::size_t>(Plane::drawing)] = magnitude_of(pose.size);
    return echo;
}

StatementIndex Board::state(Statement statement) {
    protocol_.statements.push_back(std::move(statement));
    current_statement_ = StatementIndex(protocol_.statements.size() - 1);
    return current_statement_;
}

Statement& Board::statement(StatementIndex index) { return protocol_.statements[position(index)]; }

Board::Mark Board::mark() const {
    const Program& program = protocol_.program;
    return {program.strokes.size(), program.guards.size(),  program.givens.size(), protocol_.statements.size(),
            made_in_order_.size(),  asked_in_order_.size(), current_statement_,    largest_};
}

void Board::rewind(const Mark& mark) {
    Program& program = protocol_.program;
    if (program.strokes.size() == mark.strokes && program.guards.size() == mark.guards &&
        protocol_.statements.size() == mark.statements)
        return;
    const auto is_gone = [&](ElementIndex element) { return element >= ElementIndex(mark.strokes); };
    program.strokes.resize(mark.strokes);
    program.guards.resize(mark.guards);
    program.givens.resize(mark.givens);
    protocol_.statements.resize(mark.statements);
    current_statement_ = mark.statement;
    memory_.values.resize(mark.strokes);
    const auto shorten = [&](Echo& echo) {
        if (echo.memory.values.size() > mark.strokes) echo.memory.values.resize(mark.strokes);
    };
    if (finer_) shorten(*finer_);
    std::for_each(shifted_.begin(), shifted_.end(), shorten);
    largest_ = mark.largest;
    std::erase_if(givens_, [&](const auto& each) { return is_gone(each.second); });
    while (!numbers_.empty() && is_gone(numbers_.back().second)) numbers_.pop_back();
    while (!directions_.empty() && is_gone(directions_.back().second)) directions_.pop_back();
    const auto forget = [](auto& map, auto& in_order, std::size_t first, const auto& gone) {
        const auto kept = std::stable_partition(in_order.begin() + static_cast<std::ptrdiff_t>(first), in_order.end(),
                                                [&](const auto& entry) { return !gone(entry->second); });
        std::for_each(kept, in_order.end(), [&](const auto& entry) { map.erase(entry); });
        in_order.erase(kept, in_order.end());
    };
    forget(made_, made_in_order_, mark.made, is_gone);
    forget(asked_, asked_in_order_, mark.asked, [&](std::size_t guard) { return guard >= mark.guards; });
}

ElementIndex Board::enter(const Stroke& stroke) {
    const ElementIndex element(strokes());
    std::visit([&](const auto& made) { largest_.note(stroke.plane, made); }, memory_.values.back());
    protocol_.program.strokes.push_back(stroke);
    protocol_.program.strokes.back().statement = current_statement_;
    return element;
}

ElementIndex Board::enter_given(Given given) {
    memory_.values.push_back(given_value(given, mechanism_, pose_));
    Stroke stroke;
    stroke.verb = verb_of(memory_.values.back());
    stroke.plane = plane_of(given.kind);
    stroke.given = static_cast<int>(protocol_.program.givens.size());
    protocol_.program.givens.push_back(std::move(given));
    return enter(stroke);
}

ElementIndex Board::given(Given::Kind kind, int index) {
    const auto [entry, fresh] = givens_.try_emplace({kind, index}, none);
    if (fresh) entry->second = enter_given({kind, index, {}, name_of_given(kind, index, mechanism_)});
    return entry->second;
}

ScalarHandle Board::number(const Exact& value) {
    for (const auto& [known, element] : numbers_)
        if (known == value) return {element};
    numbers_.emplace_back(value, enter_given({Given::Kind::number, -1, {value, 0}, {}}));
    return {numbers_.back().second};
}

DirectionHandle Board::own_direction(const Vector& direction) {
    for (const auto& [known, element] : directions_)
        if (known == direction) return {element};
    directions_.emplace_back(direction, enter_given({Given::Kind::direction, -1, direction, {}}));
    return {directions_.back().second};
}

ElementIndex Board::pole(Plane plane) { return binary(Verb::pole, plane, none, none); }

ElementIndex Board::unary(Verb verb, Plane plane, ElementIndex a) { return binary(verb, plane, a, none); }

ElementIndex Board::binary(Verb verb, Plane plane, ElementIndex a, ElementIndex b) {
    const auto [entry, fresh] = made_.try_emplace({verb, plane, a, b}, none);
    if (fresh) {
        made_in_order_.push_back(entry);
        entry->second = make(verb, plane, a, b);
    }
    return entry->second;
}

ElementIndex Board::make(Verb verb, Plane plane, ElementIndex a, ElementIndex b) {
    Stroke stroke;
    stroke.verb = verb;
    stroke.plane = plane;
    stroke.inputs[0] = a;
    stroke.inputs[1] = b;
    // Guards every later division: it must not be by zero.
    if (verb == Verb::through || verb == Verb::ratio || verb == Verb::arm)
        ask(Guard::Question::zero_vector, before_turning(protocol_.program, b), none);
    if (verb == Verb::quotient) ask(Guard::Question::zero_scalar, b, none);
    carry_out(stroke, ElementIndex(strokes()), memory_);
    return enter(stroke);
}

ElementIndex Board::of_scalars(Verb verb, ElementIndex a, ElementIndex b) {
    const auto plane_at = [&](ElementIndex element) { return protocol_.program.strokes[position(element)].plane; };
    const Plane first = plane_at(a), second = b == none ? first : plane_at(b);
    Plane plane = std::max(first, second);
    if (verb == Verb::product && first == Plane::velocity && second == Plane::velocity) plane = Plane::acceleration;
    if (verb == Verb::quotient) plane = first == second ? Plane::drawing : first;
    return binary(verb, plane, a, b);
}

ElementIndex Board::join(Plane plane, ElementIndex p, ElementIndex q) {
    KG_ASSERT(!ask(Guard::Question::coincide, p, q), "two points that coincide have no join: ask first");
    return binary(Verb::join, plane, p, q);
}

ElementIndex Board::meet(Plane plane, ElementIndex l, ElementIndex m) {
    const auto at_infinity = [&](ElementIndex element) {
        return kinegraph::is_at_infinity(protocol_.program, element);
    };
    if (!ask(Guard::Question::parallel, l, m))
        return binary(at_infinity(l) || at_infinity(m) ? Verb::meet_at_infinity : Verb::meet, plane, l, m);
    if (at_infinity(l)) return none;
    // Parallel: the same line where a point of one lies on the other.
    const Stroke& first = protocol_.program.strokes[position(l)];
    const bool far = first.verb == Verb::join && at_infinity(first.inputs[0]);
    if (ask(Guard::Question::on_line, first.inputs[far ? 1 : 0], m)) return none;
    return binary(Verb::meet_at_infinity, plane, l, m);
}

int Board::ask(Guard::Question question, ElementIndex a, ElementIndex b, Guard::How how) {
    const auto [entry, fresh] = asked_.try_emplace({question, a, b}, protocol_.program.guards.size());
    if (!fresh) return protocol_.program.guards[entry->second].verdict;
    asked_in_order_.push_back(entry);
    Guard guard;
    guard.question = question;
    guard.how = how;
    guard.inputs[0] = a;
    guard.inputs[1] = b;
    guard.before = strokes();
    decide(guard);
    protocol_.program.guards.push_back(guard);
    return guard.verdict;
}

/// A leftover of 2^-bits grows through the intersections in between. A value more than half the bits above it is not
/// suspicious.
void Board::decide(Guard& guard) {
    const auto here = answer(guard, protocol_.program.strokes, memory_, largest_);
    guard.verdict = here.verdict;
    if (here.is_exact || guard.how == Guard::How::by_choice) return;
    const int zero = asks_for_zero(guard.question) ? 1 : 0;
    if (lies_within_precision(guard, here)) {
        guard.how = Guard::How::by_precision;
        guard.verdict = zero;
        return;
    }
    if (pose_.exact || !here.is_small(pose_.bits / 2)) return;
    if (!finer_) finer_.emplace(echo_on(mechanism_, finer_pose_(), digits_to_compare(finer_pose_().bits)));
    follow(*finer_);
    const auto finer = answer(guard, protocol_.program.strokes, finer_->memory, finer_->largest);
    guard.how = Guard::How::by_finer_pose;
    // A value that shrinks with the finer pose is zero; one that stays is not.
    const auto relative = [](const Answer<Exact>& of) { return of.excess.order - of.unit.order; };
    if (finer.is_exact || relative(finer) <= relative(here) - pose_.bits / 2) {
        guard.verdict = zero;
    } else {
        guard.verdict = zero == 1 ? 0 : here.verdict;
    }
}

bool Board::lies_within_precision(const Guard& guard, const Answer<Exact>& here) {
    if (shifted_.empty() || !here.is_small(protocol_.program.doubtful_bits)) return false;
    const auto& strokes = protocol_.program.strokes;
    const auto measured = [&](const Memory& memory, const Largest<Exact>& largest) {
        return answer(guard, strokes, memory, largest, true).measured;
    };
    const auto value = measured(memory_, largest_);
    std::vector<Vector> elsewhere;
    for (Echo& echo : shifted_) {
        follow(echo);
        if (auto found = measured(echo.memory, echo.largest)) elsewhere.push_back(*std::move(found));
    }
    return value && is_zero_within(*value, elsewhere);
}

void Board::follow(Echo& echo) const {
    const Program& program = protocol_.program;
    auto& values = echo.memory.values;
    for (std::size_t i = values.size(); i < program.strokes.size(); ++i) {
        const Stroke& stroke = program.strokes[i];
        if (stroke.given >= 0) {
            values.push_back(given_value(program.givens[at_index(stroke.given)], echo.mechanism, echo.pose));
        } else {
            carry_out(stroke, ElementIndex(i), echo.memory);
        }
        values.back() = trimmed(values.back(), echo.digits);
        std::visit([&](const auto& made) { echo.largest.note(stroke.plane, made); }, values.back());
    }
}

void for_each_drawn(Protocol& protocol, const std::function<void(ElementIndex&)>& see) {
    const auto see_vectors = [&](std::vector<DrawnVector>& vectors) {
        for (DrawnVector& vector : vectors) {
            see(vector.tail);
            see(vector.tip);
            for (ElementIndex* place : {&vector.seen.of.place, &vector.seen.to.place, &vector.seen.about})
                if (*place != none) see(*place);
        }
    };
    const auto see_images = [&](std::vector<Image>& images) {
        for (Image& image : images) see(image.point);
    };
    const auto see_lines = [&](std::vector<DrawnLine>& lines) {
        for (DrawnLine& line : lines) {
            see(line.line);
            for (ElementIndex& point : line.points) see(point);
        }
    };
    see_vectors(protocol.vectors);
    see_images(protocol.images);
    see_lines(protocol.lines);
    see_vectors(protocol.trials.vectors);
    see_images(protocol.trials.images);
    see_lines(protocol.trials.lines);
    for (DrawnMiss& miss : protocol.trials.misses)
        for (ElementIndex* element : {&miss.through, &miss.foot, &miss.tip}) see(*element);
    for (Polygon& polygon : protocol.polygons)
        for (Face& face : polygon.faces)
            for (ElementIndex& corner : face.corners) see(corner);
}

int Board::add_polygon(Polygon polygon) {
    protocol_.polygons.push_back(std::move(polygon));
    return static_cast<int>(protocol_.polygons.size()) - 1;
}

void Board::draw(DrawnVector vector) {
    if (vector.statement == none) vector.statement = current_statement_;
    if (vector.trial != 0) return protocol_.trials.vectors.push_back(std::move(vector));
    protocol_.polygons[at_index(vector.polygon)].vectors.push_back(static_cast<int>(protocol_.vectors.size()));
    protocol_.vectors.push_back(std::move(vector));
}

void Board::label(Image image) {
    image.statement = current_statement_;
    if (image.trial != 0) return protocol_.trials.images.push_back(std::move(image));
    protocol_.polygons[at_index(image.polygon)].images.push_back(static_cast<int>(protocol_.images.size()));
    protocol_.images.push_back(std::move(image));
}

void Board::add_face(int polygon, Face face) { protocol_.polygons[at_index(polygon)].faces.push_back(std::move(face)); }

void Board::draw(DrawnLine line) {
    line.statement = current_statement_;
    if (line.trial != 0) return protocol_.trials.lines.push_back(std::move(line));
    protocol_.lines.push_back(std::move(line));
}

void Board::draw(DrawnMiss miss) {
    miss.statement = current_statement_;
    protocol_.trials.misses.push_back(std::move(miss));
}

namespace {

std::size_t bits_of(const Exact& scalar) { return scalar.bits(); }
std::size_t bits_of(const Vector& vector) { return vector.x.bits() + vector.y.bits(); }
std::size_t bits_of(const ProjectivePoint& point) { return point.x.bits() + point.y.bits() + point.w.bits(); }
std::size_t bits_of(const ProjectiveLine& line) { return line.a.bits() + line.b.bits() + line.c.bits(); }
std::size_t bits_of(const std::vector<Value>& values) {
    std::size_t sum = 0;
    for (const Value& value : values) sum += std::visit([](const auto& each) { return bits_of(each); }, value);
    return sum;
}

}  // namespace

Protocol Board::finish() && {
    protocol_.values = std::move(memory_.values);
    for (Echo& echo : shifted_) {
        follow(echo);
        protocol_.bits += bits_of(echo.memory.values);
        protocol_.shifted.push_back(std::move(echo.memory.values));
    }
    protocol_.bits += bits_of(protocol_.values);
    if (finer_) protocol_.bits += bits_of(finer_->memory.values);
    return std::move(protocol_);
}

}  // namespace kinegraph
