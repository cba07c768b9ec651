/// \file
/// Variants of an exercise: the same problem with different numbers, for example one for each student, with the answer
/// key and the files for learning platforms.
///
/// \code
/// auto variants = kinegraph::ExerciseVariants::parse(text, "truss.json", 7);
/// kinegraph::AnswerKey key;
/// for (int i = 1; i <= 30; ++i) {
///     const auto variant = variants->next();             // an error, or none where no combination is left
///     if (!variant || !*variant) break;
///     kinegraph::DrawingOptions question;
///     question.sheet = kinegraph::DrawingOptions::Sheet::question;
///     const auto pdf = kinegraph::draw((*variant)->solved, question)->pdf();
///     key.add(std::to_string(i), "", **variant);
/// }
/// const std::string answers = key.csv();
/// \endcode
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <kinegraph/error.hpp>
#include <kinegraph/mechanism.hpp>
#include <kinegraph/sheet.hpp>

namespace kinegraph {

/// One variant of an exercise.
struct ExerciseVariant {
    std::vector<ParameterValue> values;  ///< parameters that vary, in the file's order
    Solved solved;                   ///< its solution; draw() makes both the question and the solution sheet from it
    std::vector<ResultValue> asked;  ///< the results in "ask"; if the file has none, a default choice
    std::string file;                ///< the mechanism file of this variant alone
};

/// The variants of a file with "vary", in an order that depends on the seed only. The n-th variant does not depend on
/// how many are requested. No two variants are the same mechanism, and each fulfils the file's conditions ("require").
/// An object may be used by one thread at a time. Several objects with the same file and seed give the same variants.
class ExerciseVariants {
public:
    /// Reads the file. `set` replaces values of parameters that do not vary. `options` give the paper on which a
    /// condition on readable polygons must hold. Fails with the faults of the file, and if no parameter varies.
    static Expected<ExerciseVariants> parse(std::string_view text, std::string name, std::uint64_t seed,
                                            const std::vector<ParameterValue>& set = {},
                                            const DrawingOptions& options = {});
    /// Moves; a moved-from object may only be destroyed or assigned to.
    ExerciseVariants(ExerciseVariants&&) noexcept;
    /// Moves, as the constructor does.
    ExerciseVariants& operator=(ExerciseVariants&&) noexcept;
    ~ExerciseVariants();

    /// The title of the exercise; empty if the file has none.
    Text title() const;
    /// Names of the parameters that vary, in the file's order.
    std::vector<std::string> parameters() const;
    /// Number of combinations in the file.
    std::uint64_t combinations() const;

    /// The next variant; none if all combinations have been tried, `most_in_a_row` were rejected one after the other,
    /// or `stops`, called before each combination, returns true. `name`: the variant's file name in title blocks;
    /// empty: that of the exercise. Fails if the file asks for or compares a result that does not exist, and with
    /// Kind::output if a condition needs a drawing and the font is missing.
    Expected<std::optional<ExerciseVariant>> next(const std::string& name = {},
                                                  const std::function<bool()>& stops = {});
    /// The number of combinations rejected one after the other at which next() gives up.
    static constexpr std::uint64_t most_in_a_row = 20'000;
    /// Number of combinations tried so far.
    std::uint64_t looked_at() const;
    /// A reason for which combinations were rejected: a condition, or values that make no mechanism.
    struct Rejection {
        Text why;                 ///< the condition as the file has it, or the reason in words
        std::uint64_t count = 0;  ///< combinations rejected for it so far
    };
    /// Why combinations were rejected, in order of first occurrence.
    std::vector<Rejection> rejections() const;

private:
    struct State;
    explicit ExerciseVariants(State* state) : state_(state) {}
    State* state_;  ///< owned; null after a move
};

/// The answer key of a class: one row for each variant with its number, the student's name, the parameters that vary
/// and the results asked for, in the units of the file. The columns of results are those of the first variant; a later
/// variant that lacks one has an empty cell. An object may be changed by one thread at a time.
class AnswerKey {
public:
    /// Adds a row. `number` ("007") identifies the variant. `name` may be empty; there is a column of names if any is
    /// not.
    void add(std::string number, std::string name, const ExerciseVariant& variant);
    /// Number of rows.
    std::size_t size() const { return rows_.size(); }
    /// As CSV (RFC 4180, LF): "variant,name,r,omega 3 [rad/s]". A decimal point, and as many digits as a double has. A
    /// name that a spreadsheet would read as a formula begins with an apostrophe.
    std::string csv() const;
    /// As a table on as many pages as it needs, with the symbols of the question sheets and four digits. `title`: of
    /// the exercise. Uses language, paper, orientation, theme, author and date. Fails as draw() does, and without rows.
    Expected<Drawing> drawing(const std::string& title, const DrawingOptions& options = {}) const;

private:
    struct Column {
        std::string name, unit;
    };
    struct Row {
        std::string number, name;
        std::vector<std::string> values;
        std::vector<std::optional<double>> results;
    };
    bool has_names() const;

    std::vector<std::string> parameters_;
    std::vector<Column> columns_;
    std::optional<Solved> first_;  ///< of the first variant: the symbols of its results
    std::vector<Row> rows_;
};

/// The variants of an exercise as questions for learning platforms. Each has the question's figure and data, a blank
/// for each result asked for, with the tolerance of a careful drawing, and the steps of the solution. An object may be
/// used by one thread at a time.
class QuestionBank {
public:
    /// Names of a variant's files, to be listed by csv().
    struct Files {
        std::string question;  ///< its question sheet
        std::string solution;  ///< its solution sheet
        std::string results;   ///< its results file
        std::string file;      ///< its mechanism file
    };
    /// `title`: of the exercise. `options`: of the question sheets, whose scales decide the tolerances. `dpi`: of the
    /// figures in moodle() and qti(), 20 to 1200; 0 if only csv() is wanted, which saves drawing them.
    QuestionBank(std::string title, std::uint64_t seed, DrawingOptions options = {}, double dpi = 150);
    /// Moves; a moved-from object may only be destroyed or assigned to.
    QuestionBank(QuestionBank&&) noexcept;
    /// Moves, as the constructor does.
    QuestionBank& operator=(QuestionBank&&) noexcept;
    ~QuestionBank();

    /// Adds a variant; `number` and `name` as in AnswerKey::add(). Returns the names of results that cannot be told
    /// from zero at the scales of the figures: a platform accepts zero and the wrong sign for them. Fails as draw() and
    /// Drawing::png() do.
    Expected<std::vector<std::string>> add(const std::string& number, const std::string& name,
                                           const ExerciseVariant& variant, const Files& files = {});
    /// Cloze questions as Moodle XML, in a category named after the title.
    std::string moodle() const;
    /// An IMS package (ZIP) of QTI 2.1 items with their figures. Fails with Kind::output if the ZIP library fails.
    Expected<std::string> qti() const;
    /// CSV with a row for each variant: number, name, seed, parameters, value, unit and tolerance of each result, and
    /// the names of the files. Empty if there is no variant.
    std::string csv() const;

private:
    struct State;
    State* state_;  ///< owned; null after a move
};

}  // namespace kinegraph
