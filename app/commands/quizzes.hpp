// Quizzes: collects the variants of a run for learning platforms, one file for each: moodle.xml, qti.zip, answers.csv.
// Words and numbers come from the items.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/commands/outputs.hpp"
#include "constructions/positions/variants.hpp"
#include "render/page/quiz.hpp"
#include "render/sheet/sheet.hpp"

namespace kinegraph::app {

class Quizzes {
public:
    /// `platforms`: some of "moodle", "qti", "csv". `original`: the file without variation; `title`: the name of the
    /// question bank.
    Quizzes(const std::vector<std::string>& platforms, const Mechanism& original, std::string title,
            unsigned long long seed);

    bool are_wanted() const { return moodle_ || qti_ || csv_; }
    /// The files of a variant.
    struct Files {
        std::string question, solution, results, file;
    };
    /// Adds a variant. Returns the names of answers that cannot be distinguished from zero.
    std::vector<std::string> add(const std::string& number, const std::string& owner, const Variant& variant,
                                 const Files& files, const render::SheetOptions& options, double dpi,
                                 const OutputWriter& press);
    /// The output files; `folder` ends in a slash. A status after an error was reported.
    tl::expected<std::vector<Output>, Status> outputs(const std::string& folder, Language language) const;

private:
    void add_row(const render::QuizItem& item, const Variant& variant, const Files& files);
    std::string csv() const;

    bool moodle_ = false, qti_ = false, csv_ = false, has_owners_ = false;
    std::string title_, seed_;
    Units units_;
    std::vector<render::QuizItem> items_;  ///< without their figures
    std::vector<std::string> figures_;     ///< PNG; empty if only answers are requested
    struct Row {
        std::string owner;
        std::vector<std::string> parameters;
        std::vector<render::QuizBlank> blanks;
        std::string number;
        Files files;
    };
    std::vector<std::string> parameters_;  ///< that vary
    std::vector<Row> rows_;
};

}  // namespace kinegraph::app
