/// \file
/// The solution of a file: named results, sentences, the comparison with the numeric check.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <kinegraph/error.hpp>

namespace kinegraph {

/// \cond private
/// A reference-counted state that copies of a value share. The library creates, counts and deletes it. (std::shared_ptr
/// would make every program that includes this header compile a third longer.)
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

/// A rational number in lowest terms.
struct ExactNumber {
    std::string numerator;    ///< decimal digits, with a minus sign if the number is negative
    std::string denominator;  ///< decimal digits, positive; "1" for an integer
    double value = 0;         ///< the nearest double

    /// "3/4", or "3" for an integer.
    std::string text() const { return denominator == "1" ? numerator : numerator + "/" + denominator; }
};

/// A named result ("omega 3", "vx B", "F A 3 on 2", "M"). Columns of a sweep and "ask" in a file use the same names
/// (docs/results.md).
struct ResultValue {
    std::string name;                  ///< as in the results file
    double value = 0;                  ///< in SI units; angles in radians; couples and ω counter-clockwise positive
    double in_file_unit = 0;           ///< the value in the unit that the file uses for this quantity
    std::string unit;                  ///< that unit: "rad/s", "mm/s"; empty for a bare number
    std::optional<ExactNumber> exact;  ///< in SI units; none for roots (lengths, angles) and rounded drawings
};

/// A result of the construction and the same result of the numeric check.
struct CheckedValue {
    std::string name;       ///< "velocity B x", as in "checks" of the results file
    double graphical = 0;   ///< by the construction, SI
    double numeric = 0;     ///< by linear algebra in doubles, SI
    double difference = 0;  ///< graphical − numeric, SI
};

/// How a remark or a reason says what to do.
enum class Remedies {
    in_file,  ///< what to write in the file: "add {\"revolute\": …}"
    by_tools  ///< what to do in the workbench, by its tools and panels: "choose Link (L) …"
};

/// A solved file. An immutable value: copies share their state, and several threads may read the same one.
///
/// A result that the mechanism does not determine (a dead point, too few equations) is not an error: unsolved() lists
/// it with the reason, and all other results are available.
class Solved {
public:
    /// A result without a unique value.
    struct Missing {
        Text what;    ///< the result
        Text reason;  ///< why it has no unique value
    };

    /// What a solution may contain in addition to its figures and results.
    enum class Addition {
        lever,         ///< Joukowsky's lever (DrawingOptions::lever)
        equations,     ///< the closure equations (SolveOptions::equations)
        virtual_work,  ///< input forces and couples by virtual work (SolveOptions::virtual_work)
    };

    /// The title of the file; in another position than the drawn one followed by the position. Empty if the file has
    /// none and the position is the drawn one.
    Text title() const;
    /// What a file without joints is about: "impact of two bodies". Empty for a mechanism.
    Text subject() const;
    /// All results in the order of the results file, including lengths of vectors. Never NaN or infinite.
    std::vector<ResultValue> values() const;
    /// The result with that name; none if it does not exist.
    std::optional<ResultValue> value(std::string_view name) const;
    /// The value of a result, or of an expression of results and parameters as "ask" takes them ("omega 4 / omega 2",
    /// "|v B|"), in docs/results.md. An expression has no exact value. Fails with Kind::bad_input for an unknown name,
    /// with the nearest one, and for what cannot be read; with Kind::no_unique_answer for what is not determined here.
    Expected<ResultValue> evaluate(std::string_view expression) const;
    /// A vector by its name ("v B", "a B", "F A 3 on 2"): x and y in SI units, the results "vx B" and "vy B"; none if
    /// it does not exist.
    std::optional<std::array<double, 2>> vector(std::string_view name) const;
    /// The sentences of the worked solution, in order.
    std::vector<Text> statements() const;
    /// Results that are not determined, with the reason.
    std::vector<Missing> unsolved(Remedies remedies = Remedies::in_file) const;
    /// Why the solution has no such addition; none if it has, or could have, one.
    std::optional<Text> why_without(Addition addition) const;
    /// Remarks: redundant constraints, points that were moved onto curves, bodies that separate.
    std::vector<Text> remarks(Remedies remedies = Remedies::in_file) const;
    /// Each result and its value by the numeric check, which shares only the file with the construction.
    std::vector<CheckedValue> checks() const;

    /// The results file (docs/results.md): JSON, SI units, the same bytes on every machine. `exact` adds fractions.
    std::string json(bool exact = false) const;
    /// The table of results as plain text for a terminal, UTF-8.
    std::string table(Language language = Language::en) const;
    /// The closure equations as plain text, if SolveOptions::equations was set and the mechanism has loops.
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
