// Builds the HTML of the live page. The moving parts are data (live_data.hpp) and the interpreter.
#include "render/live/live_page.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <vector>

#include "engine/equations/equations.hpp"
#include "engine/file/json_writer.hpp"
#include "engine/solution/problem_solution.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/library.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/sheet.hpp"
#include "render/backends/backends.hpp"
#include "render/content/title_block.hpp"
#include "render/equations/equation_text.hpp"
#include "render/figures/plot_figure.hpp"
#include "render/figures/truss_figures.hpp"
#include "render/live/html/html.hpp"
#include "render/live/live_data.hpp"
#include "render/scene/sentences.hpp"
#include "render/sheet/figure_alone.hpp"
#include "render/sheet/sheet_limits.hpp"
#include "render/text/bound_blank.hpp"

namespace kinegraph::render {
namespace {

// --- figures

/// The figures for HTML. Outlines used by several figures are sent once, and ids become data attributes, so that no id
/// appears twice. A drawing of the second language that equals one of the first is not sent again: it is replaced by
/// `data-as`, the number of the first one among the elements of all figures, and the page copies that.
class Drawings {
public:
    /// Adds the `svg` of a page; `label`: its accessible name.
    std::string add(const std::string& svg, const std::string& label, bool is_second) {
        pugi::xml_document document;
        document.load_buffer(svg.data(), svg.size(), pugi::parse_default | pugi::parse_ws_pcdata_single);
        pugi::xml_node root = document.child("svg");
        for (const pugi::xml_node outline : root.child("defs").children())
            if (known_.insert(outline.attribute("id").value()).second) outlines_ += printed(outline);
        root.remove_child("defs");
        root.remove_child("title");
        for (const char* name : {"xmlns", "xmlns:xlink", "version", "xml:lang"}) root.remove_attribute(name);
        const std::string width = root.attribute("width").value();
        root.remove_attribute("width");
        root.remove_attribute("height");
        root.append_attribute("data-width").set_value(width.c_str());
        root.append_attribute("class").set_value("drawing");
        root.append_attribute("role").set_value("img");
        root.append_attribute("aria-label").set_value(label.c_str());
        tidy(root);
        if (is_second)
            refer(root);
        else
            remember(root);
        return printed(root);
    }
    std::string outlines() const {
        return "<svg class=\"outlines\" width=\"0\" height=\"0\" aria-hidden=\"true\"><defs>" + outlines_ +
               "</defs></svg>\n";
    }

private:
    static std::string printed(const pugi::xml_node& node) {
        struct Sink : pugi::xml_writer {
            std::string out;
            void write(const void* data, std::size_t size) override {
                out.append(static_cast<const char*>(data), size);
            }
        } sink;
        // In HTML only SVG elements may be self-closing.
        node.print(sink, "", pugi::format_raw, pugi::encoding_utf8);
        return std::move(sink.out);
    }
    /// A path rounded to a tenth of a micrometre. Values are read from axes and data, not from strokes.
    static std::string rounded(std::string_view path) {
        constexpr std::size_t decimals = 4;
        std::string out;
        for (std::size_t at = 0; at < path.size();) {
            const std::size_t end = std::min(path.find_first_not_of("-0123456789.", at), path.size());
            const std::size_t point = path.substr(at, end - at).find('.');
            if (point == std::string_view::npos || end - at - point - 1 <= decimals) {
                out += path.substr(at, std::max(end, at + 1) - at);
            } else {
                double value = 0;
                std::from_chars(path.data() + at, path.data() + end, value);
                out += shortest(std::round(value * 1e4) / 1e4);
            }
            at = std::max(end, at + 1);
        }
        return out;
    }
    static void tidy(pugi::xml_node node) {
        for (pugi::xml_node child : node.children()) {
            if (pugi::xml_attribute id = child.attribute("id")) id.set_name("data-id");
            if (std::string_view(child.name()) == "g" && child.attribute("role")) child.remove_attribute("role");
            // Screen readers skip the content of a picture; scripts find labels by their text.
            if (pugi::xml_attribute said = child.attribute("aria-label")) said.set_name("data-label");
            if (std::string_view(child.attribute("class").value()) == "text") child.remove_attribute("data-label");
            if (pugi::xml_attribute link = child.attribute("xlink:href")) link.set_name("href");
            if (pugi::xml_attribute path = child.attribute("d")) path.set_value(rounded(path.value()).c_str());
            tidy(child);
        }
    }

    /// In document order, the order of selectors.
    void remember(const pugi::xml_node& parent) {
        for (const pugi::xml_node child : parent.children()) {
            if (child.type() != pugi::node_element) continue;
            numbers_.try_emplace(printed(child), count_++);
            remember(child);
        }
    }
    void refer(pugi::xml_node parent) {
        constexpr std::size_t shortest_reference = 24;
        for (pugi::xml_node child = parent.first_child(), next; child; child = next) {
            next = child.next_sibling();
            if (child.type() != pugi::node_element) continue;
            const std::string text = printed(child);
            const auto same = numbers_.find(text);
            if (same == numbers_.end() || text.size() <= shortest_reference) {
                refer(child);
                continue;
            }
            pugi::xml_node stands = parent.insert_child_before("g", child);
            stands.append_attribute("data-as").set_value(same->second);
            parent.remove_child(child);
        }
    }

    std::set<std::string> known_;
    std::string outlines_;
    std::map<std::string, int> numbers_;  // by printed text
    int count_ = 0;
};

// --- text

class PageWriter {
public:
    PageWriter(const Solution& solution, const std::optional<Moving>& moving, const SheetOptions& options,
               const Fonts& fonts)
        : solution_(solution), moving_(moving), options_(options), fonts_(fonts) {}

    tl::expected<std::string, Words> write(const std::optional<Theme>& dark, int served) {
        std::string sheets;
        const Language first = options_.language;
        write_words(first, data_.open('{'));
        data_.key("figures").open('{');
        for (const Language language : languages_of_page(first)) {
            data_.key(code_of(language)).open('[');
            sheets += sheet(language);
            data_.close();
        }
        if (beyond_) return refused(*beyond_);
        data_.close();
        if (dark) data_.member("dark", true);
        if (served > 0) data_.member("served", served);
        if (moving_) {
            write_names(solution_, data_);
            write_moving(*moving_, solution_, data_);
        }
        // Stroke and width of bars in compression, without force, in tension.
        if (solution_.truss)
            data_.list("pens", pens_of_bars(options_.theme),
                       [&](const Pen& pen) { data_.open('[').values(hex(pen.colour), pen.width).close(); });
        const std::string data = data_.close().take();
        const std::string script =
            without_comments(live_script, true) + (served > 0 ? without_comments(live_watch_script, true) : "");
        return document(title_of(solution_, first), first, style_of(options_.theme, dark), script, data, served > 0,
                        drawings_.outlines() + body(sheets));
    }

private:
    /// The sheets within the controls, to which the script adds the words.
    std::string body(const std::string& sheets) const {
        std::string titles, languages;
        for (const Language each : languages_of_page(options_.language)) {
            titles += element("h1", in_language(each), escaped(title_of(solution_, each)));
            languages += element("option", "value=\"" + code_of(each) + "\"", lang::notation::name.in(each));
        }
        std::string out = without_layout(live_controls);
        const auto put = [&](std::string_view place, const std::string& text) {
            out.replace(out.find(place), place.size(), text);
        };
        put("{titles}", titles);
        put("{languages}", languages);
        put("{sheets}", sheets);
        return out;
    }
    /// Attributes of what stands in each language of the page, of which one is shown.
    std::string in_language(Language language) const {
        return "lang=\"" + code_of(language) + "\"" + (language == options_.language ? "" : " hidden");
    }

    std::string sheet(Language language) {
        std::string note;
        if (const std::string& cam = solution_.mechanism.cam_file; !cam.empty()) {
            note = Words(lang::library::this_is_one_position, cam).in(language);
            note.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(note.front())));
            note = element("p", "class=\"note\"", escaped(note + "."));
        }
        const std::string stage =
            element("div", "class=\"stage\"", note + element("div", "class=\"figures\"", figures(language)));
        return element(
            "main", in_language(language),
            stage + element("div", "class=\"text\"", steps(language) + values(language) + results(language)));
    }

    std::string figures(Language language) {
        SheetOptions options = options_;
        options.language = language;
        std::vector<AloneFigure> drawn = lay_out_each_alone(solution_, options, fonts_);
        std::string out;
        for (AloneFigure& figure : drawn) {
            if (beyond_ = beyond_paper(figure.page); beyond_) return {};
            figure.page.tells_holds = true;
            write_figure(figure, solution_, data_);
            const std::string svg =
                drawings_.add(to_svg(figure.page, fonts_), plain(figure.caption), language != options_.language);
            std::string caption = html(figure.caption);
            if (!figure.scale_in_words.empty())
                caption += " <span class=\"scale\">" + html(figure.scale_in_words) + "</span>";
            out += element(
                "figure", "data-figure-name=\"" + escaped(figure.name) + "\"",
                svg + element("figcaption", "", caption) + "<p class=\"note\" data-word=\"not_followed\" hidden></p>");
        }
        return out;
    }

    /// A chapter for each run of sentences on one topic.
    std::string steps(Language language) const {
        std::string out;
        std::optional<Topic> topic;
        const std::vector<Statement>& statements = solution_.protocol.statements;
        for (std::size_t i = 0; i < statements.size(); ++i) {
            const Statement& statement = statements[i];
            if (options_.detail == SolutionDetail::brief && is_incidental(statements, i)) continue;
            if (topic != statement.section) {
                if (topic) out += "</ol></section>\n";
                topic = statement.section;
                out += "<section class=\"chapter\">";
                if (*topic != Topic::unnamed) out += element("h2", "", word(steps_heading(*topic), language));
                out += "<ol class=\"steps\">\n";
            }
            std::string said = html(say(statement.message, language));
            if (statement.equation) said += equation(*statement.equation, language);
            std::string attributes = "data-says=\"" + std::to_string(i) + "\"", bodies;
            for (const BodyIndex body : statement.bodies)
                bodies += (bodies.empty() ? "" : " ") + legal_id(solution_.mechanism.body(body).name);
            if (!bodies.empty()) attributes += " data-bodies=\"" + bodies + "\"";
            out += element("li", attributes, said);
        }
        if (topic) out += "</ol></section>\n";
        if (!out.empty() && moving_) out += "<p class=\"note\" data-word=\"of_drawn_position\" hidden></p>\n";
        return out;
    }
    /// A row for each term: its sign, its symbol, whether its magnitude and its direction are known. The page shows the
    /// rows beside each other, as on the sheet, and breaks the line where it is full.
    static std::string equation(const Equation& equation, Language language) {
        const auto row = [](const std::string& sign, const std::string& head, const std::string& magnitude,
                            const std::string& direction) {
            const std::string cell = "role=\"cell\"";
            return element("tr", "role=\"row\"",
                           element("td", cell, sign) +
                               (head.empty() ? "<td></td>" : element("th", "role=\"rowheader\"", head)) +
                               element("td", cell, magnitude) + element("td", cell, direction));
        };
        std::string rows = row("", "", word(lang::common::magnitude, language), word(lang::sheet::direction, language));
        for (std::size_t side = 0; side < equation.sides.size(); ++side) {
            for (std::size_t k = 0; k < equation.sides[side].size(); ++k) {
                const Term& term = equation.sides[side][k];
                rows += row(side + k == 0 ? ""
                            : k > 0       ? "+"
                                          : "=",
                            html(typeset(term.symbol, language)), term.magnitude_known ? "✓" : "?",
                            term.direction_known ? "✓ " + html(typeset(term.line, language)) : "?");
            }
        }
        return element("table", "class=\"equation\" role=\"table\"", rows);
    }

    std::string equations(Language language) const {
        if (!solution_.equations || !solution_.equations->why_not.empty()) return {};
        return printed(as_text(equation_items(solution_, language)));
    }
    /// The columns that follow the mechanism; the script fills in the values.
    std::string values(Language language) const {
        if (!moving_) return {};
        std::string rows;
        for (std::size_t i = 0; i < moving_->columns.size(); ++i) {
            const Column& column = moving_->columns[i];
            const Unit unit = unit_of_column(column, solution_.mechanism.units);
            rows += element("tr", "",
                            element("th", "scope=\"row\"", html(typeset(column, solution_.mechanism, language))) +
                                element("td", "data-column=\"" + std::to_string(i) + "\"", "") +
                                element("td", "", escaped(unit.symbol)));
        }
        const std::string head = element("tr", "",
                                         element("th", "scope=\"col\"", word(lang::sheet::page_column, language)) +
                                             element("th", "scope=\"col\"", word(lang::sheet::page_value, language)) +
                                             element("th", "scope=\"col\"", word(lang::sheet::unit, language)));
        return element(
            "section", "class=\"columns\"",
            element("h2", "", word(lang::sheet::page_values, language)) +
                element("table", "class=\"values\"", element("thead", "", head) + element("tbody", "", rows)));
    }
    std::string results(Language language) const {
        return element("section", "class=\"results\"",
                       element("h2", "",
                               word(lang::sheet::results, language) +
                                   (moving_ ? " (" + word(lang::sheet::page_drawn, language) + ")" : "")) +
                           equations(language) + printed(results_table(solution_, language)));
    }
    static std::string printed(const std::string& text) { return element("pre", "tabindex=\"0\"", escaped(text)); }

    const Solution& solution_;
    const std::optional<Moving>& moving_;
    const SheetOptions& options_;
    const Fonts& fonts_;
    Drawings drawings_;
    std::optional<Words> beyond_{};  ///< why a figure cannot be written
    JsonWriter data_{JsonWriter::Style::script};
};

}  // namespace

tl::expected<std::string, Words> live_page(const Solution& solution, const std::optional<Moving>& moving,
                                           const SheetOptions& options, const std::optional<Theme>& dark,
                                           const Fonts& fonts, int served) {
    return PageWriter(solution, moving, options, fonts).write(dark, served);
}

std::string waiting_page(const std::string& name, const SheetOptions& options, const std::optional<Theme>& dark) {
    JsonWriter data(JsonWriter::Style::script);
    write_words(options.language, data.open('{'));
    return document(name, options.language, style_of(options.theme, dark), without_comments(live_watch_script, true),
                    data.member("served", 0).close().take(), true,
                    element("main", "lang=\"" + code_of(options.language) + "\"", element("h1", "", escaped(name))));
}

}  // namespace kinegraph::render
