// QuestionBank: variants as quiz items. Words and numbers come from the items.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "app/library/csv_text.hpp"
#include "app/library/requested_results.hpp"
#include "app/library/state.hpp"
#include "kinegraph/variants.hpp"
#include "render/backends/archive.hpp"
#include "render/backends/quiz_files.hpp"
#include "render/sheet/handout.hpp"

namespace kinegraph {

struct QuestionBank::State {
    std::string title, seed;
    DrawingOptions options;
    double dpi;
    struct Row {
        render::QuizItem item;   ///< without its figure
        std::string figure_png;  ///< empty if only answers are wanted
        std::vector<ParameterValue> values;
        Files files;
    };
    std::vector<Row> rows;
};

namespace {

double value_of_decimal(const std::string& decimal) {
    double value = 0;
    std::from_chars(decimal.data(), decimal.data() + decimal.size(), value);
    return value;
}

/// The names of answers whose possible error is as large as their value.
std::vector<std::string> unreadable(const std::vector<render::QuizBlank>& asked) {
    std::vector<std::string> names;
    for (const render::QuizBlank& each : asked)
        if (each.value != "0" && value_of_decimal(each.tolerance) >= std::abs(value_of_decimal(each.value)))
            names.push_back(each.name);
    return names;
}

}  // namespace

QuestionBank::QuestionBank(std::string title, std::uint64_t seed, DrawingOptions options, double dpi)
    : state_(new State{std::move(title), std::to_string(seed), std::move(options), dpi, {}}) {
    state_->options.sheet = DrawingOptions::Sheet::question;
}
QuestionBank::QuestionBank(QuestionBank&& other) noexcept : state_(std::exchange(other.state_, nullptr)) {}
QuestionBank& QuestionBank::operator=(QuestionBank&& other) noexcept {
    std::swap(state_, other.state_);
    return *this;
}
QuestionBank::~QuestionBank() { delete state_; }

Expected<std::vector<std::string>> QuestionBank::add(const std::string& number, const std::string& name,
                                                     const ExerciseVariant& variant, const Files& files) {
    const Solved::State& solved = variant.solved.state();
    const auto asked = app::requested_results(solved.asked, solved.solution.mechanism.units);
    State::Row row{{}, {}, variant.values, files};
    const auto figure =
        drawing_of(state_->options, [&](const render::SheetOptions& sheet, const render::Fonts& fonts, auto&) {
            const render::SheetOptions coloured = with_colours_of(sheet, solved.solution.mechanism);
            row.item = render::quiz_item_of(solved.solution, asked, coloured, fonts);
            return std::vector{row.item.figure};
        });
    if (!figure) return tl::unexpected(figure.error());
    row.item.figure.marks.clear();
    row.item.number = number;
    row.item.owner = name;
    if (state_->dpi != 0) {
        auto png = figure->png(0, state_->dpi);
        if (!png) return tl::unexpected(png.error());
        row.figure_png = *std::move(png);
    }
    std::vector<std::string> names = unreadable(row.item.blanks);
    state_->rows.push_back(std::move(row));
    return names;
}

std::string QuestionBank::moodle() const {
    std::string text = render::moodle_head(state_->title);
    for (const State::Row& row : state_->rows) text += render::moodle_question(row.item, row.figure_png);
    return text + render::moodle_tail();
}

Expected<std::string> QuestionBank::qti() const {
    std::vector<render::QuizItem> items;
    std::vector<render::Packed> files(1);
    for (const State::Row& row : state_->rows) {
        items.push_back(row.item);
        files.push_back({qti_file(row.item), render::qti_item(row.item)});
        files.push_back({figure_file(row.item), row.figure_png});
    }
    files.front() = {"imsmanifest.xml", render::qti_manifest(items)};
    auto bytes = render::packed(files);
    if (!bytes) return refused(Diagnostic::Kind::output, bytes.error());
    return *std::move(bytes);
}

std::string QuestionBank::csv() const {
    const std::vector<State::Row>& rows = state_->rows;
    if (rows.empty()) return {};
    // The same columns as in the answer key: those of the first variant; a later variant may lack one.
    const std::vector<render::QuizBlank>& first_row = rows.front().item.blanks;
    const bool has_owners =
        std::any_of(rows.begin(), rows.end(), [](const State::Row& row) { return !row.item.owner.empty(); });
    CsvLine head;
    head << "variant";
    if (has_owners) head << "name";
    head << "seed";
    for (const ParameterValue& each : rows.front().values) head << each.name;
    for (const render::QuizBlank& each : first_row)
        head << each.name << each.name + " unit" << each.name + " tolerance";
    for (const char* each : {"question", "solution", "results", "file"}) head << each;
    std::string text = std::move(head).text();
    for (const State::Row& row : rows) {
        CsvLine line;
        line << row.item.number;
        if (has_owners) line.text_of_others(row.item.owner);
        line << state_->seed;
        for (const ParameterValue& each : row.values) line << each.value;
        for (const render::QuizBlank& each : first_row) {
            const auto own = std::find_if(row.item.blanks.begin(), row.item.blanks.end(),
                                          [&](const render::QuizBlank& other) { return other.name == each.name; });
            const bool has = own != row.item.blanks.end();
            line << (has ? own->value : "") << (has ? own->unit : "") << (has ? own->tolerance : "");
        }
        line << row.files.question << row.files.solution << row.files.results << row.files.file;
        text += std::move(line).text();
    }
    return text;
}

}  // namespace kinegraph
