/// \file
/// The solution of a file: results by name, sentences, the comparison with the numeric check.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <kinegraph/error.hpp>
#include <kinegraph/exact.hpp>

namespace kinegraph {

/// \cond private
/// A state that copies of a value share. The library makes and deletes it and counts its owners. (The standard's
/// shared_ptr would make every program that includes this header a third larger to compile.)
template <class State>
class Shared {
public:
    explicit Shared(State* state) noexcept : state_(state) {}
    Shared(const Shared& other) noexcept;
    Shared(Shared&& other) noexcept : state_(other.state_) { other.state_ = nullptr; }
    Shared& operator=(Shared other) noexcept {
        State* const before = state_;
        state_ = other.state_;
        other.state_ = before;
        return *this;
    }
    ~Shared();
    State& operator*() const { return *state_; }

private:
    State* state_;
};
/// \endcond

/// A result by its name ("omega 3", "vx B", "F A 3 on 2", "M"), as columns of a sweep and the file's "ask" call it
/// (docs/results.md).
struct ResultValue {
    std::string name;                  ///< its name
    double value = 0;                  ///< in SI units; angles in radians; couples and ω counter-clockwise positive
    double in_file_unit = 0;           ///< the same in the unit that the file tells such quantities in
    std::string unit;                  ///< that unit: "rad/s", "mm/s"; empty of a bare number
    std::optional<ExactNumber> exact;  ///< in SI units; none where a root was taken (a length, an angle) or where the
                                       ///< drawing itself is rounded
};

/// A result of the construction beside the same one from the numeric check.
struct CheckedValue {
    std::string name;       ///< "velocity B x", as in "checks" of the results file
    double graphical = 0;   ///< by the construction, SI
    double numeric = 0;     ///< by linear algebra in doubles, SI
    double difference = 0;  ///< graphical − numeric, SI
};

/// A solved file. An immutable value: copies share it, and several threads may read one at the same time.
///
/// What a mechanism does not determine (a dead point, too few equations) is no error: it is listed by unsolved() with
/// the reason, and everything else is there.
class Solved {
public:
    /// A result that was sought and has no unique answer.
    struct Missing {
        Text what;    ///< the result
        Text reason;  ///< why there is none
    };

    /// All results in the order of the results file, lengths of vectors among them. Never NaN or infinite.
    std::vector<ResultValue> values() const;
    /// The result of that name; none where the solution holds no such result.
    std::optional<ResultValue> value(std::string_view name) const;
    /// A vector by its name ("v B", "a B", "F A 3 on 2"): x and y in SI units, the results "vx B" and "vy B"; none
    /// where there is no vector of that name.
    std::optional<std::array<double, 2>> vector(std::string_view name) const;
    /// The sentences of the worked solution, in order.
    std::vector<Text> statements() const;
    /// What is not determined, with the reason.
    std::vector<Missing> unsolved() const;
    /// What a reader should know besides: redundant constraints, points that were moved onto curves, bodies that part.
    std::vector<Text> remarks() const;
    /// Each result beside the numeric check, which shares nothing with the construction but the file.
    std::vector<CheckedValue> checks() const;

    /// The results file (docs/results.md): JSON, SI units, the same bytes on every machine. `exact` adds fractions.
    std::string json(bool exact = false) const;
    /// The table of results as plain text for a terminal, UTF-8.
    std::string table(Language language = Language::en) const;
    /// The closure equations, where they were asked for and the mechanism has loops, as plain text.
    /// Source of the method: vector loops in complex form (Raven 1958).
    Expected<std::string> equations(Language language = Language::en) const;

    /// \cond private
    struct State;
    explicit Solved(Shared<const State> state) : state_(std::move(state)) {}
    const State& state() const { return *state_; }
    /// \endcond

private:
    Shared<const State> state_;
};

}  // namespace kinegraph
