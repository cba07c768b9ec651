/// \file
/// Mechanism files: reading, checking and solving them.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <kinegraph/error.hpp>
#include <kinegraph/solution.hpp>

namespace kinegraph {

/// A new value for a parameter of a file: {"r", "45 mm"}.
struct ParameterValue {
    std::string name;   ///< a name from the file's "parameters"
    std::string value;  ///< a number, a quantity or a formula, written as in a file
};

/// What to solve in addition to what the file asks for.
struct SolveOptions {
    bool equations = false;     ///< the closure equations and their derivatives
    bool virtual_work = false;  ///< the input forces and couples by virtual work
    bool sentences = true;      ///< false: omits the arithmetic from the sentences, which saves a tenth of the time
};

/// The positions in which to solve a mechanism, other than the drawn one.
struct PositionsWanted {
    /// Coordinates of the driver: "30°", "20 mm", "every 30°"; for a driver with a law also times: "0.2 s".
    std::vector<std::string> at;
    std::string driver = {};  ///< name of its body, joint or point; empty: the first driver of the file
    int branch = 0;           ///< branch to take if the drawn position is a change point, from 1; 0: the first
    std::string dashes = {};  ///< stands before the names of these options in messages: "--" in a command line's
};

/// Where the points and directions of a file are, for programs that draw it themselves.
struct DrawnPosition {
    /// A point of the file.
    struct Point {
        std::string name;            ///< as in the file
        std::array<double, 2> at{};  ///< in the file's unit of length
    };
    /// The direction of a joint (its guide, or the common tangent of a contact), of a load or of a driver.
    struct Direction {
        std::string place;  ///< JSON pointer of the joint, load or driver: "/joints/3"
        double angle = 0;   ///< rad, from +x, counter-clockwise
    };
    std::string length_unit;            ///< the file's unit of length: "mm"
    double metres = 1;                  ///< its size, m
    std::vector<Point> points;          ///< in the file's order
    std::vector<Direction> directions;  ///< of joints, then of loads, then of drivers; where there is one
};

/// Format of a text.
enum class TextForm {
    plain,     ///< for a terminal
    markdown,  ///< a table for a document; equations as in `plain`
    latex,     ///< equations as a LaTeX document; tables as in `plain`
    json,      ///< for programs
    formulas   ///< the text of that document alone, for MathJax and notebooks; tables as in `plain`
};

/// A mechanism file that was read and has no faults. It contains a mechanism, or a problem without joints
/// (docs/file_problems.md). An immutable value: copies share their state, and several threads may use the same one. For
/// the file format see docs/file.md.
class MechanismFile {
public:
    /// Reads the text of a file (JSON, UTF-8). `name` identifies it in messages and title blocks; `set` replaces
    /// parameter values. Fails with all faults of the file at once, each with its JSON pointer.
    static Expected<MechanismFile> parse(std::string_view text, std::string name,
                                         const std::vector<ParameterValue>& set = {});
    /// Reads a file of at most 64 MiB. Fails as parse() does, and if the file cannot be read.
    static Expected<MechanismFile> open(const std::string& path, const std::vector<ParameterValue>& set = {});

    /// The title; empty if the file has none.
    Text title() const;
    /// Whether it has joints; if not, it states a problem without joints.
    bool has_joints() const;
    /// Whether equations() can apply: a mechanism, or the motion of a point.
    bool has_equations() const;
    /// How many bodies, joints and drivers it has.
    struct Counts {
        std::size_t bodies = 0;   ///< with the frame
        std::size_t joints = 0;   ///< of all kinds
        std::size_t drivers = 0;  ///< of all kinds
    };
    /// Counts what the file lists.
    Counts counts() const;
    /// Places the points and looks for likely mistakes: points that two bodies share without a joint, unsupported
    /// bodies, conditions of an exercise that are not fulfilled. Fails if curves do not meet.
    Expected<std::vector<Text>> check(Remedies remedies = Remedies::in_file) const;
    /// Places the points without solving anything. Fails if curves do not meet.
    Expected<DrawnPosition> drawn_position() const;

    /// Solves it in the drawn position by the textbook's constructions: instant centres by Aronhold–Kennedy, velocity
    /// and acceleration polygons, forces by lines of action and force polygons. Results are exact for the drawn
    /// position. Fails if the mechanism cannot be drawn. Results that are not determined are listed by
    /// Solved::unsolved().
    Expected<Solved> solve(const SolveOptions& options = {}) const;
    /// Solves it in other positions of a driver, in the given order. Fails if a position is out of reach or is a change
    /// point, or if the mechanism has no driver.
    Expected<std::vector<Solved>> solve_at(const PositionsWanted& positions, const SolveOptions& options = {}) const;

    /// Its pairs and its degrees of freedom, by count and by the rank of the constraints. Fails for a file without
    /// joints.
    Expected<std::string> pairs(TextForm form = TextForm::plain, Language language = Language::en) const;
    /// Its closure equations as vector loops, or the derivatives of a point's laws. Fails if there are no loops.
    Expected<std::string> equations(TextForm form = TextForm::plain, Language language = Language::en) const;

    /// \cond private
    struct State;
    explicit MechanismFile(Shared<const State> state) : state_(std::move(state)) {}
    const State& state() const { return *state_; }
    /// \endcond

private:
    Shared<const State> state_;
};

/// A mechanism file made from the data of another program.
struct Imported {
    std::string file;           ///< the text of the file; MechanismFile::parse() reads it
    std::vector<Text> remarks;  ///< what was rounded, changed or left out
};
/// Makes a mechanism file from a link of PMKS+, from what stands behind its question mark, or from the text of a saved
/// file. Fails where the link is cut off or changed, and where its mechanism makes no file.
Expected<Imported> import_pmks(std::string_view link);

/// The catalogue of supported pairs.
std::string pair_catalogue(TextForm form = TextForm::plain, Language language = Language::en);

/// The JSON Schema of the mechanism file (draft 7).
std::string_view mechanism_schema();

}  // namespace kinegraph
