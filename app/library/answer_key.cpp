// AnswerKey: the results of many variants, as CSV and as a printed table.
#include <algorithm>
#include <utility>

#include "app/library/csv_text.hpp"
#include "app/library/state.hpp"
#include "kinegraph/variants.hpp"
#include "lang/keys/library.hpp"
#include "render/content/exercise_text.hpp"
#include "render/sheet/key_sheet.hpp"
#include "render/text/words.hpp"

namespace kinegraph {
namespace {

/// A value as the file writes it, for print: a true minus sign and the decimal mark of the language.
std::string printed_value(std::string value, Language language) {
    if (value.starts_with('-')) value.replace(0, 1, "−");
    std::replace(value.begin(), value.end(), '.', render::notation(language).decimal_mark);
    return value;
}

/// The symbols that the question uses for the results; empty for one that is another result's too.
std::vector<render::RichText> symbols_of(const Solved::State& variant, Language language, const render::Fonts& fonts) {
    const render::Theme theme;
    const render::DrawingContext context{variant.solution, theme, fonts, language, render::Dimensions::off};
    std::vector<render::RichText> symbols;
    std::vector<std::string> plain;
    for (const NamedResult& each : variant.asked) {
        symbols.push_back(render::asked_text(context, each.column).symbol);
        plain.push_back(render::plain(symbols.back()));
    }
    for (std::size_t i = 0; i < symbols.size(); ++i)
        if (std::count(plain.begin(), plain.end(), plain[i]) > 1) symbols[i] = {};
    return symbols;
}

}  // namespace

void AnswerKey::add(std::string number, std::string name, const ExerciseVariant& variant) {
    if (!first_) {
        first_ = variant.solved;
        for (const ParameterValue& each : variant.values) parameters_.push_back(each.name);
        for (const ResultValue& each : variant.asked) columns_.push_back({each.name, each.unit});
    }
    Row row{std::move(number), std::move(name), {}, {}};
    for (const ParameterValue& each : variant.values) row.values.push_back(each.value);
    for (const Column& column : columns_) {
        const auto found = std::find_if(variant.asked.begin(), variant.asked.end(),
                                        [&](const ResultValue& each) { return each.name == column.name; });
        row.results.push_back(found == variant.asked.end() ? std::nullopt : std::optional(found->in_file_unit));
    }
    rows_.push_back(std::move(row));
}

bool AnswerKey::has_names() const {
    return std::any_of(rows_.begin(), rows_.end(), [](const Row& row) { return !row.name.empty(); });
}

std::string AnswerKey::csv() const {
    const bool names = has_names();
    CsvLine head;
    head << "variant";
    if (names) head << "name";
    for (const std::string& each : parameters_) head << each;
    for (const Column& each : columns_) head << each.name + (each.unit.empty() ? "" : " [" + each.unit + "]");
    std::string csv = std::move(head).text();
    for (const Row& row : rows_) {
        CsvLine line;
        line << row.number;
        if (names) line.text_of_others(row.name);
        for (const std::string& each : row.values) line << each;
        for (const auto& each : row.results) line << (each ? render::shortest(*each) : "");
        csv += std::move(line).text();
    }
    return csv;
}

Expected<Drawing> AnswerKey::drawing(const std::string& title, const DrawingOptions& options) const {
    if (rows_.empty()) return refused(Diagnostic::Kind::bad_input, {lang::library::the_key_has_no_variant});
    return drawing_of(options, [&](const render::SheetOptions& sheet, const render::Fonts& fonts, auto&) {
        const Language language = sheet.language;
        const bool names = has_names();
        render::KeyTable table{title + " – " + in(Words(lang::library::key), language), {}, {}};
        table.columns.push_back({in(Words(lang::library::variant), language), "", true});
        if (names) table.columns.push_back({in(Words(lang::library::name), language), "", true});
        for (const std::string& each : parameters_) table.columns.push_back({each, "", false});
        std::vector<render::RichText> symbols = symbols_of(first_->state(), language, fonts);
        for (std::size_t i = 0; i < columns_.size(); ++i)
            table.columns.push_back({columns_[i].name, columns_[i].unit, false, std::move(symbols[i])});
        for (const Row& row : rows_) {
            std::vector<std::string>& cells = table.rows.emplace_back();
            cells.push_back(row.number);
            if (names) cells.push_back(row.name);
            for (const std::string& each : row.values) cells.push_back(printed_value(each, language));
            for (const auto& each : row.results) cells.push_back(each ? render::number(*each, 4, language) : "");
        }
        return render::lay_out_key(table, sheet, fonts);
    });
}

}  // namespace kinegraph
