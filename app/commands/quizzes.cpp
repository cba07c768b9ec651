// Quizzes: see quizzes.hpp.
#include "app/commands/quizzes.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "app/files/csv_text.hpp"
#include "app/late/archive.hpp"
#include "app/library/requested_results.hpp"
#include "render/backends/quiz_files.hpp"
#include "render/sheet/quiz_item.hpp"

namespace kinegraph::app {
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

Quizzes::Quizzes(const std::vector<std::string>& platforms, const Mechanism& original, std::string title,
                 unsigned long long seed)
    : title_(std::move(title)), seed_(std::to_string(seed)), units_(original.units) {
    const auto has = [&](const char* name) {
        return std::find(platforms.begin(), platforms.end(), name) != platforms.end();
    };
    moodle_ = has("moodle");
    qti_ = has("qti");
    csv_ = has("csv");
    for (const Variation& each : original.exercise->vary) parameters_.push_back(each.parameter);
}

std::vector<std::string> Quizzes::add(const std::string& number, const std::string& owner, const Variant& variant,
                                      const Files& files, const render::SheetOptions& options, double dpi,
                                      const OutputWriter& press) {
    render::QuizItem item =
        render::quiz_item_of(variant.solution, requested_results(variant.results, units_), options, press.fonts());
    item.number = number;
    item.owner = owner;
    has_owners_ = has_owners_ || !owner.empty();
    if (csv_) add_row(item, variant, files);
    std::vector<std::string> none_reads = unreadable(item.blanks);
    if (!moodle_ && !qti_) return none_reads;
    std::vector<Output> drawn;
    std::vector<std::string> remarks;
    press.print({item.figure}, {figure_file(item), Format::png}, dpi, drawn, remarks);
    figures_.push_back(std::move(drawn.front().bytes));
    item.figure.marks.clear();
    items_.push_back(std::move(item));
    return none_reads;
}

void Quizzes::add_row(const render::QuizItem& item, const Variant& variant, const Files& files) {
    Row row{item.owner, {}, item.blanks, item.number, files};
    for (const Setting& each : variant.values) row.parameters.push_back(each.value);
    rows_.push_back(std::move(row));
}

namespace {

std::string moodle_file(const std::vector<render::QuizItem>& items, const std::vector<std::string>& figures,
                        const std::string& title) {
    std::string text = render::moodle_head(title);
    for (std::size_t i = 0; i < items.size(); ++i) text += render::moodle_question(items[i], figures[i]);
    return text + render::moodle_tail();
}

std::vector<Packed> package_of(const std::vector<render::QuizItem>& items, const std::vector<std::string>& figures) {
    std::vector<Packed> files{{"imsmanifest.xml", render::qti_manifest(items)}};
    for (std::size_t i = 0; i < items.size(); ++i) {
        files.push_back({qti_file(items[i]), render::qti_item(items[i])});
        files.push_back({figure_file(items[i]), figures[i]});
    }
    return files;
}

/// A line of CSV.
class Line {
public:
    Line& operator<<(const std::string& cell) { return add(csv_cell(cell)); }
    Line& text_of_others(const std::string& cell) { return add(csv_cell_of_text(cell)); }
    std::string text() && { return std::move(text_) + "\n"; }

private:
    Line& add(const std::string& cell) {
        text_ += (is_first_ ? "" : ",") + cell;
        is_first_ = false;
        return *this;
    }
    std::string text_;
    bool is_first_ = true;
};

}  // namespace

std::string Quizzes::csv() const {
    // The same columns as in the answer key: those of the first variant; a later variant may lack one.
    const std::vector<render::QuizBlank>& first_row = rows_.front().blanks;
    Line head;
    head << "variant";
    if (has_owners_) head << "name";
    head << "seed";
    for (const std::string& each : parameters_) head << each;
    for (const render::QuizBlank& each : first_row)
        head << each.name << each.name + " unit" << each.name + " tolerance";
    for (const char* each : {"question", "solution", "results", "file"}) head << each;
    std::string text = std::move(head).text();
    for (const Row& row : rows_) {
        Line line;
        line << row.number;
        if (has_owners_) line.text_of_others(row.owner);
        line << seed_;
        for (const std::string& each : row.parameters) line << each;
        for (const render::QuizBlank& each : first_row) {
            const auto own = std::find_if(row.blanks.begin(), row.blanks.end(),
                                          [&](const render::QuizBlank& other) { return other.name == each.name; });
            const bool has = own != row.blanks.end();
            line << (has ? own->value : "") << (has ? own->unit : "") << (has ? own->tolerance : "");
        }
        line << row.files.question << row.files.solution << row.files.results << row.files.file;
        text += std::move(line).text();
    }
    return text;
}

tl::expected<std::vector<Output>, Status> Quizzes::outputs(const std::string& folder, Language language) const {
    std::vector<Output> all;
    if (moodle_) all.push_back({folder + "moodle.xml", moodle_file(items_, figures_, title_)});
    if (qti_) {
        auto bytes = packed(package_of(items_, figures_));
        if (!bytes) return tl::unexpected(fail_to_write({Words(folder + "qti.zip"), bytes.error()}, language));
        all.push_back({folder + "qti.zip", *std::move(bytes)});
    }
    if (csv_ && !rows_.empty()) all.push_back({folder + "answers.csv", csv()});
    return all;
}

}  // namespace kinegraph::app
