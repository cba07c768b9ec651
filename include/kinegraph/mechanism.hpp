/// \file
/// Mechanism files: read, checked, solved.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <kinegraph/error.hpp>
#include <kinegraph/solution.hpp>

namespace kinegraph {

/// A parameter of a file with another value: {"r", "45 mm"}.
struct ParameterValue {
    std::string name;   ///< as the file's "parameters" name it
    std::string value;  ///< a number, a quantity or a formula, as a file writes it
};

/// What is solved besides what the file asks for.
struct SolveOptions {
    bool equations = false;     ///< the closure equations with their derivatives
    bool virtual_work = false;  ///< the input forces and couples by virtual work
    bool sentences = true;      ///< false: the arithmetic in the sentences is left out, which saves a tenth of the time
};

/// In which positions a mechanism is solved, apart from the drawn one.
struct PositionsWanted {
    /// Coordinates of the driver: "30°", "20 mm", "every 30°"; where the driver has a law also times: "0.2 s".
    std::vector<std::string> at;
    std::string driver;  ///< by its body's, joint's or point's name; empty: the first of the file
    int branch = 0;      ///< at a drawn change point: which branch is taken, from 1; 0: the first
};

/// How a text is laid out.
enum class TextForm {
    plain,     ///< for a terminal
    markdown,  ///< a table for a document; of equations as plain
    latex,     ///< formulas for LaTeX; of tables as plain
    json       ///< for programs
};

/// A mechanism file, read and without faults: a mechanism, or a problem that a file states in place of joints (contact,
/// wear, impact, the motion of a point, positions of a body). An immutable value: copies share it, and several threads
/// may use one at the same time. The form of the file is docs/file.md.
class MechanismFile {
public:
    /// Reads the text of a file (JSON, UTF-8). `name` is what messages and title blocks call it; `set` gives
    /// parameters other values. Fails with every fault of the file at once, each with its JSON pointer.
    static Expected<MechanismFile> parse(std::string_view text, std::string name,
                                         const std::vector<ParameterValue>& set = {});
    /// Reads the file at a path, at most 64 MiB. Fails as parse() does, and where the file cannot be read.
    static Expected<MechanismFile> open(const std::string& path, const std::vector<ParameterValue>& set = {});

    /// Its title; empty where the file gives none.
    Text title() const;
    /// Whether it has joints; if not, it states a problem in their place.
    bool has_joints() const;
    /// Draws the points and looks for likely mistakes: points that two bodies share without a joint, bodies that
    /// nothing holds, conditions of an exercise that do not hold. Fails where curves do not meet.
    Expected<std::vector<Text>> check() const;

    /// Solves it in the drawn position by the textbook's constructions: instant centres by Aronhold–Kennedy, velocity
    /// and acceleration polygons, forces by lines of action and force polygons. Every result is exact on the drawing.
    /// Fails where the drawing cannot be made; what is not determined is in Solved::unsolved().
    Expected<Solved> solve(const SolveOptions& options = {}) const;
    /// Solves it in other positions of a driver, in the order asked for. Fails where a position is out of reach, is a
    /// change point, or where nothing drives the mechanism.
    Expected<std::vector<Solved>> solve_at(const PositionsWanted& positions, const SolveOptions& options = {}) const;

    /// Its pairs with their freedoms, counted and by the rank of their constraints. Fails for a file without joints.
    Expected<std::string> pairs(TextForm form = TextForm::plain, Language language = Language::en) const;
    /// Its closure equations as vector loops, or the derivatives of a point's laws. Fails where it has no loops.
    Expected<std::string> equations(TextForm form = TextForm::plain, Language language = Language::en) const;

    /// \cond private
    struct State;
    explicit MechanismFile(Shared<const State> state) : state_(std::move(state)) {}
    const State& state() const { return *state_; }
    /// \endcond

private:
    Shared<const State> state_;
};

/// The catalogue of pairs that a file may have.
std::string pair_catalogue(TextForm form = TextForm::plain, Language language = Language::en);

/// The JSON Schema of the mechanism file (draft 7).
std::string_view mechanism_schema();

}  // namespace kinegraph
