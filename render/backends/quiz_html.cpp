// Quiz items as XHTML: see quiz_html.hpp.
#include "render/backends/quiz_html.hpp"

#include <cmath>

#include "lang/keys/notation.hpp"
#include "render/text/html.hpp"

namespace kinegraph::render {
namespace {

/// CSS has 96 px per inch.
std::string pixels(double millimetres) { return std::to_string(std::lround(millimetres * 96 / 25.4)); }

}  // namespace

std::string html_of(const std::vector<QuizSection>& sections, bool numbered) {
    std::string html;
    for (const QuizSection& section : sections) {
        const bool counts = numbered && &section != &sections.back();
        html += "<h3>" + xml_text(section.heading) + "</h3>\n" + (counts ? "<ol>\n" : "<ul>\n");
        for (const RichText& each : section.paragraphs) html += "<li>" + to_html(each) + "</li>\n";
        html += counts ? "</ol>\n" : "</ul>\n";
    }
    return html;
}

std::string figure_html(const QuizItem& item, const std::string& source) {
    return "<p><img src=\"" + source + "\" alt=\"" + xml_text(item.figure.title) + "\" width=\"" +
           pixels(item.figure.width) + "\" height=\"" + pixels(item.figure.height) + "\"/></p>\n";
}

std::string blank_html(const QuizItem& item, const QuizBlank& blank, const std::string& field) {
    std::string html = "<li>" + to_html(blank.words);
    if (!blank.symbol.empty()) html += lang::notation::colon.in(language_named(item.language)) + to_html(blank.symbol);
    html += " = " + field;
    if (!blank.unit.empty()) html += (blank.unit == "°" ? "" : " ") + to_html(with_powers(blank.unit));
    return html + "</li>\n";
}

std::string notes_html(const QuizItem& item) {
    std::string html;
    for (const RichText& each : item.notes) html += "<p>" + to_html(each) + "</p>\n";
    return html;
}

std::string name_html(const QuizItem& item) {
    return xml_text(item.title + " " + item.number + (item.owner.empty() ? "" : " · " + item.owner));
}

}  // namespace kinegraph::render
