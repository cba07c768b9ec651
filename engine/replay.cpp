#include "engine/replay.hpp"

namespace kinegraph {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// What is this much smaller than what it is small beside may be zero in doubles: 2^-30, a millionth of a millimetre in a drawing
/// of a metre, and some six orders above what rounding leaves of the deepest constructions met (chains of ten dyads).
constexpr int zero_bits = 30;
/// And this much smaller it is nothing: within a thousand roundings of a double.
constexpr int vanishing_bits = 42;

enum class Kind { point, line, vector, scalar };

Kind kind_of(Verb verb) {
    switch (verb) {
        case Verb::given_point:
        case Verb::pole:
        case Verb::point_at_infinity:
        case Verb::meet:
        case Verb::meet_at_infinity:
        case Verb::carry:
            return Kind::point;
        case Verb::through:
        case Verb::join:
            return Kind::line;
        case Verb::given_scalar:
        case Verb::ratio:
        case Verb::product:
        case Verb::sum:
        case Verb::difference:
        case Verb::opposite:
        case Verb::quotient:
        case Verb::moment:
        case Verb::projection:
            return Kind::scalar;
        default:
            return Kind::vector;
    }
}

}  // namespace

Replay::Replay(const Program& program, const std::vector<Value>& givens, double size) {
    const std::size_t count = program.strokes.size();
    memory_.cells.resize(count);
    memory_.lines.resize(count);
    cells_of_given_.resize(program.givens.size(), -1);
    std::vector<int> made(count + 1, 0);  // by stroke: how many are carried out before it
    for (std::size_t i = 0; i < count; ++i) {
        const Stroke& stroke = program.strokes[i];
        const auto cell = static_cast<int>(i);
        slots_.push_back(cell);
        planes_.push_back(stroke);
        memory_.lines[i] = kind_of(stroke.verb) == Kind::line ? 1 : 0;
        if (stroke.given >= 0) {
            cells_of_given_[at(stroke.given)] = cell;
        } else if (stroke.verb == Verb::pole) {
            carry_out(stroke, cell, memory_);
        } else {
            strokes_.push_back(stroke);
            outputs_.push_back(cell);
        }
        made[i + 1] = static_cast<int>(strokes_.size());
    }
    for (Guard guard : program.guards) {
        guard.before = made[at(guard.before)];
        guards_.push_back(guard);
    }
    at_start_.vector[static_cast<std::size_t>(Plane::drawing)] = {size};
    for (std::size_t i = 0; i < givens.size(); ++i) give(static_cast<int>(i), to_double(givens[i]));
}

void Replay::give(int given, const ValueOf<double>& value) {
    const int cell = cells_of_given_[at(given)];
    std::visit([&](const auto& number) { memory_.put(cell, number); }, value);
}

std::optional<int> Replay::run() {
    largest_ = at_start_;
    for (const int cell : cells_of_given_) note(cell);
    next_ = 0;
    for (std::size_t i = 0; i < guards_.size(); ++i) {
        carry_out_until(at(guards_[i].before));
        if (!holds(guards_[i])) return static_cast<int>(i);
    }
    carry_out_until(strokes_.size());
    return std::nullopt;
}

void Replay::note(int cell) {
    const Stroke& stroke = planes_[at(cell)];
    switch (kind_of(stroke.verb)) {
        case Kind::scalar:
            return largest_.note(stroke.plane, memory_.scalar(cell));
        case Kind::line:
            return;
        default:
            return largest_.note(stroke.plane, memory_.vector(cell));
    }
}

void Replay::carry_out_until(std::size_t end) {
    for (; next_ < end; ++next_) {
        carry_out(strokes_[next_], outputs_[next_], memory_);
        note(outputs_[next_]);
    }
}

/// What was zero may show the rounding of what it is the difference of; what was not must not vanish.
bool Replay::holds(const Guard& guard) const {
    const auto now = answer(guard, planes_, memory_, largest_);
    const int zero = asks_for_zero(guard.question) ? 1 : 0;
    if (guard.verdict == zero) return now.verdict == zero || (!now.is_exact && now.may_be_zero(zero_bits));
    return now.verdict == guard.verdict && (now.is_exact || !now.is_small(vanishing_bits));
}

}  // namespace kinegraph
