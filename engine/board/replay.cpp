#include "engine/board/replay.hpp"

namespace kinegraph {
namespace {

/// Below this share of its reference magnitude a value may be zero in doubles: 2^-30, a millionth of a millimetre in a
/// drawing of a metre. It is six orders above the rounding of the deepest constructions met (chains of ten dyads).
constexpr int zero_bits = 30;
/// Below this share it is zero: within a thousand roundings of a double.
constexpr int vanishing_bits = 42;

enum class Kind { point, line, vector, scalar };

Kind kind_of(Verb verb) {
    switch (verb) {
        case Verb::given_point:
        case Verb::pole:
        case Verb::point_at_infinity:
        case Verb::meet:
        case Verb::meet_at_infinity:
        case Verb::carry: return Kind::point;
        case Verb::through:
        case Verb::join: return Kind::line;
        case Verb::given_scalar:
        case Verb::ratio:
        case Verb::product:
        case Verb::sum:
        case Verb::difference:
        case Verb::opposite:
        case Verb::quotient:
        case Verb::moment:
        case Verb::projection: return Kind::scalar;
        default: return Kind::vector;
    }
}

}  // namespace

Replay::Replay(const Program& program, const std::vector<Value>& givens, double size)
    : strokes_(program.strokes), doubtful_bits_(program.doubtful_bits) {
    const std::size_t count = strokes_.size();
    memory_.cells.resize(count);
    memory_.lines.resize(count);
    element_of_given_.resize(program.givens.size(), none);
    std::vector<int> made(count + 1, 0);  // by stroke: number of steps before it
    for (std::size_t i = 0; i < count; ++i) {
        const Stroke& stroke = strokes_[i];
        const ElementIndex element(i);
        const Kind kind = kind_of(stroke.verb);
        const bool is_small_beside_size = stroke.plane == Plane::drawing && kind != Kind::scalar;
        memory_.lines[i] = kind == Kind::line ? 1 : 0;
        const Noted noted = kind == Kind::line || is_small_beside_size ? Noted::nothing
                            : kind == Kind::scalar                     ? Noted::scalar
                                                                       : Noted::vector;
        if (stroke.given >= 0) {
            element_of_given_[at_index(stroke.given)] = element;
            if (noted != Noted::nothing) noted_givens_.push_back({stroke, element, noted});
        } else if (stroke.verb == Verb::pole) {
            carry_out(stroke, element, memory_);
        } else {
            steps_.push_back({stroke, element, noted});
        }
        made[i + 1] = static_cast<int>(steps_.size());
    }
    for (Guard guard : program.guards) {
        guard.before = made[at_index(guard.before)];
        guards_.push_back(guard);
    }
    at_start_.vector[static_cast<std::size_t>(Plane::drawing)] = {size};
    for (std::size_t i = 0; i < givens.size(); ++i) give(static_cast<int>(i), to_double(givens[i]));
}

void Replay::give(int given, const ValueOf<double>& value) {
    const ElementIndex element = element_of_given_[at_index(given)];
    std::visit([&](const auto& number) { memory_.put(element, number); }, value);
}

// Inlined as one function: calls would take as long as the strokes.
[[gnu::flatten]] std::optional<int> Replay::run() {
    largest_ = at_start_;
    for (const Step& given : noted_givens_) note(given);
    next_ = 0;
    const std::size_t count = guards_.size();
    for (std::size_t i = 0; i < count; ++i) {
        carry_out_until(at_index(guards_[i].before));
        if (!holds(guards_[i])) return static_cast<int>(i);
    }
    carry_out_until(steps_.size());
    return std::nullopt;
}

inline void Replay::note(const Step& step) {
    if (step.noted == Noted::vector) largest_.note(step.stroke.plane, memory_.vector(step.element));
    if (step.noted == Noted::scalar) largest_.note(step.stroke.plane, memory_.scalar(step.element));
}

inline void Replay::carry_out_until(std::size_t end) {
    for (; next_ < end; ++next_) {
        const Step& step = steps_[next_];
        carry_out(step.stroke, step.element, memory_);
        note(step);
    }
}

/// A value that was zero may contain rounding relative to its operands; one that was not zero must not vanish.
inline bool Replay::holds(const Guard& guard) const {
    const auto now = answer(guard, strokes_, memory_, largest_);
    const int zero = asks_for_zero(guard.question) ? 1 : 0;
    if (guard.how == Guard::How::by_precision && now.is_small(doubtful_bits_)) return true;
    if (guard.verdict != zero) return now.verdict == guard.verdict && (now.is_exact || !now.is_small(vanishing_bits));
    if (now.verdict == zero || (!now.is_exact && now.is_small(zero_bits))) return true;
    return guard.question == Guard::Question::parallel && !now.is_exact &&
           now.excess.is_below(slack_of_parallels(guard, strokes_, memory_, largest_), zero_bits);
}

}  // namespace kinegraph
