#include "app/library/row_text.hpp"

#include <utility>

#include "render/text/words.hpp"

namespace kinegraph::app {
namespace {

/// A name that contains quotes or a comma is quoted in CSV, with the quotes doubled.
std::string csv_name(const std::string& name) {
    if (name.find_first_of("\",") == std::string::npos) return name;
    std::string text = "\"";
    for (const char c : name) text += c == '"' ? "\"\"" : std::string(1, c);
    return text + '"';
}

}  // namespace

void RowText::head(const std::vector<Column>& columns, const std::function<void(JsonWriter&)>& before) {
    if (is_json()) {
        before(json_.open('{', JsonWriter::Entries::on_lines));
        json_.key("columns").open('[');
        for (const Column& each : columns) json_.value(each.name);
        json_.close().key("rows").open('[', JsonWriter::Entries::on_lines);
        return;
    }
    for (std::size_t i = 0; i < columns.size(); ++i) csv_ += (i > 0 ? "," : "") + csv_name(columns[i].name);
    csv_ += '\n';
}

bool RowText::row(std::span<const double> values, const std::vector<bool>& empty) {
    if (is_json()) json_.open('[');
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (is_json())
            json_.value(empty[i] ? std::nullopt : std::optional(values[i]));
        else
            csv_ += (i > 0 ? "," : "") + (empty[i] ? "" : render::shortest(values[i]));
    }
    if (is_json())
        json_.close();
    else
        csv_ += '\n';
    constexpr std::size_t at_a_time = 1 << 16;
    return json_.size() + csv_.size() <= at_a_time || pass_on();
}

bool RowText::tail(const std::function<void(JsonWriter&)>& after) {
    if (!is_json()) return pass_on();
    after(json_.close());
    json_.close();
    return to_.write(json_.take() + '\n');
}

bool RowText::pass_on() { return to_.write(is_json() ? json_.take() : std::exchange(csv_, {})); }

}  // namespace kinegraph::app
