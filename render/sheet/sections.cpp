// The text of the sheet, section by section.
#include "render/sheet/sections.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "render/page/shapes.hpp"
#include "render/scene/sentences.hpp"
#include "render/tables/force_tables.hpp"
#include "render/tables/prose.hpp"
#include "render/tables/tables.hpp"

namespace kinegraph::render {
namespace {

class SectionWriter {
public:
    SectionWriter(const DrawingContext& context, const SheetFormat& format, const WantedFigures& figures,
                  const FigurePages& pages)
        : context_(context), solution_(context.solution), format_(format), wanted_(figures), pages_(pages) {}

    std::vector<Section> write() {
        write_sections();
        return std::move(sections_);
    }

private:
    std::string continued(const std::string& title) const { return title + ", " + word("continued", context_.language); }
    /// Above the rows that there are, and again above those that go on elsewhere.
    void set_heading(Section& section, const std::string& title, const RichText& note = {}) const {
        section.rows.insert(section.rows.begin(), heading_block(context_, format_.measure, title, note));
        section.heading_again = heading_block(context_, format_.measure, continued(title), note);
    }
    Block paragraph(const RichText& text, double indent = 0, const std::string& number_text = {}) const {
        return paragraph_block(context_, format_.measure, text, indent, number_text);
    }

    bool lever_has_table() const { return wanted_.lever && pages_.drawn[*wanted_.lever].has_table; }

    void write_sections() {
        write_results();
        write_unsolved();
        write_steps();
        write_bodies();
        write_forces();
        write_centres();
        write_conventions();
        write_remarks();
    }

    void add(Section section) {
        if (!section.rows.empty()) sections_.push_back(std::move(section));
    }

    void write_results() {
        std::vector<ResultRow> rows = result_rows(context_, pages_.drawn);
        for (ResultRow& row : force_rows(context_, pages_.drawn)) rows.push_back(std::move(row));
        if (rows.empty()) return;
        const double longest = format_.content.height() - format_.block.height() - 8;
        const auto fit = static_cast<std::size_t>(std::max(8.0, (longest - 14) / 4.5));
        const std::string title = word("results", context_.language);
        for (std::size_t from = 0; from < rows.size();) {
            std::size_t to = std::min(rows.size(), from + fit);
            // A table is divided between groups where it can.
            if (to < rows.size())
                for (std::size_t k = to; k > from + 4; --k)
                    if (rows[k].group != rows[k - 1].group) {
                        to = k;
                        break;
                    }
            const std::vector<ResultRow> part(rows.begin() + static_cast<std::ptrdiff_t>(from),
                                              rows.begin() + static_cast<std::ptrdiff_t>(to));
            Section table;
            table.rows.push_back(results_block(context_, part, format_.measure, from == 0 ? title : continued(title)));
            add(std::move(table));
            from = to;
        }
    }

    void write_unsolved() {
        if (solution_.unsolved.empty()) return;
        Section section;
        set_heading(section, word("unsolved", context_.language));
        for (const Unsolved& each : solution_.unsolved) {
            RichText text = say(each.what, context_.language);
            append(text, one_piece(": "));
            append(text, say(each.why, context_.language));
            section.rows.push_back(paragraph(text));
        }
        add(std::move(section));
    }

    void write_steps() {
        const Solution& s = solution_;
        int step = 0;
        for (const auto part : {Topic::velocity, Topic::acceleration, Topic::relative_motion, Topic::centres, Topic::forces}) {
            Section section;
            const bool of_forces = part == Topic::forces;
            section.in_order = part != Topic::centres;  // these explain the first figure and are read with it
            if (part == Topic::centres) section.home = 0;
            if (of_forces) {
                section.home = static_cast<int>(wanted_.first_of_forces);
                section.of_forces = true;
            }
            for (std::size_t p = 0; p < s.protocol.polygons.size() && section.home < 0; ++p) {
                const Polygon& polygon = s.protocol.polygons[p];
                if (polygon.plane == Plane::force) continue;
                const auto explained_by = polygon.kind == Polygon::Kind::relative_motion ? Topic::relative_motion
                                          : polygon.plane == Plane::acceleration         ? Topic::acceleration
                                                                                         : Topic::velocity;
                if (part == explained_by) section.home = static_cast<int>(p) + 1;
            }
            for (const StatementIndex i : indices_of(s.protocol.statements)) {
                const Statement& statement = s.protocol.statements[at_index(i)];
                if (statement.section != part || told_by_list(statement.message.sentence)) continue;
                if (section.rows.empty())
                    set_heading(section, word(!of_forces || is_mixed(solution_) ? "steps " + std::string(name_of(part)) : "steps",
                                              context_.language));
                section.rows.push_back(paragraph(say(statement.message, context_.language), 6, std::to_string(++step)));
                belong(section.rows.back().marks, 0, i);
                if (of_forces) add_force_equations(section, i);
                const auto placed = wanted_.equation_polygon.find(i);
                if (statement.equation &&
                    (placed == wanted_.equation_polygon.end() || pages_.unplaced.contains(placed->second))) {
                    Block block = equation_block(context_, *statement.equation, format_.measure - 6);
                    belong(block.marks, 0, i);
                    move(block.marks, 6, 0.5);
                    block.height += 2.5;
                    section.rows.push_back(std::move(block));
                }
            }
            add(std::move(section));
        }
    }

    void write_bodies() {
        Section section;
        section.home = 0;
        section.rows = body_lines(context_, format_.measure);
        if (!section.rows.empty()) set_heading(section, word("bodies", context_.language));
        add(std::move(section));
    }

    void write_forces() {
        if (has_forces(solution_)) {
            Section section;
            section.of_forces = true;
            section.rows = reaction_lines(context_, format_.measure);
            set_heading(section, word("forces", context_.language));
            add(std::move(section));
        }
        if (wanted_.lever && !lever_has_table()) {
            Section section;
            section.home = static_cast<int>(*wanted_.lever);
            section.of_forces = true;
            section.rows = {wanted_.lever_table};
            set_heading(section, word("lever", context_.language));
            add(std::move(section));
        }
    }

    void write_centres() {
        if (solution_.centres.empty()) return;
        Section section;
        section.home = 0;
        section.rows = centre_lines(context_, format_.measure);
        set_heading(section, word("instant centres", context_.language), one_piece(solution_.mechanism.units.length.symbol));
        add(std::move(section));
    }

    void write_conventions() {
        const Solution& s = solution_;
        Section section;
        // Of a body alone there is nothing to count.
        set_heading(section, word(s.act_of_motion ? "conventions" : "mobility", context_.language));
        if (!s.act_of_motion) section.rows.push_back(paragraph(mobility_words()));
        section.rows.push_back(paragraph(axes_words()));
        if (s.protocol.polygons.empty() && s.mechanism.drivers.empty() && !s.mechanism.motion)
            section.rows.push_back(paragraph(one_piece(word("nothing driven", context_.language))));
        add(std::move(section));
    }

    void write_remarks() {
        std::vector<RichText> refused;
        for (std::size_t i = 0; i < wanted_.list.size() && i < pages_.drawn.size(); ++i)
            if (misses(wanted_.list[i], pages_.drawn[i])) {
                RichText text = pages_.drawn[i].caption;
                append(text, one_piece(": " + word("scale refused", context_.language)));
                refused.push_back(std::move(text));
            }
        for (const Figure& figure : pages_.drawn) {
            if (figure.unnamed.empty()) continue;
            RichText text = figure.caption;
            append(text, one_piece(": " + word("names left out", context_.language) + " "));
            constexpr std::size_t most_listed = 12;
            for (std::size_t i = 0; i < std::min(figure.unnamed.size(), most_listed); ++i) {
                if (i > 0) append(text, one_piece(", "));
                append(text, figure.unnamed[i]);
            }
            if (figure.unnamed.size() > most_listed)
                append(text, one_piece(" … (" + std::to_string(figure.unnamed.size()) + ")"));
            refused.push_back(std::move(text));
        }
        if (solution_.remarks.empty() && refused.empty()) return;
        Section section;
        set_heading(section, word("remarks", context_.language));
        for (const RichText& each : refused) section.rows.push_back(paragraph(each));
        for (const Message& each : solution_.remarks) section.rows.push_back(paragraph(say(each, context_.language)));
        add(std::move(section));
    }

    /// What is known of a body's forces stands with the step that closes its polygon, unless the figure has it.
    void add_force_equations(Section& section, StatementIndex statement) const {
        const std::vector<const FreeBody*> closed = closed_by(solution_, statement);
        if (closed.empty() || figures_have_force_equations()) return;
        for (const FreeBody* body : closed) {
            Block block = force_equation_block(context_, *body, true);
            if (block.width == 0 || block.width > format_.measure - 6) continue;
            belong(block.marks, 0, statement);
            move(block.marks, 6, 0.5);
            block.height += 2.5;
            section.spare_rows.push_back(section.rows.size());
            section.rows.push_back(std::move(block));
        }
    }
    bool figures_have_force_equations() const {
        return std::any_of(pages_.drawn.begin(), pages_.drawn.end(),
                           [](const Figure& figure) { return figure.kind == "forces" && figure.has_table; });
    }

    RichText mobility_words() const {
        const Mobility& m = solution_.mobility;
        const auto n = [](int value) { return std::to_string(value); };
        RichText text;
        const auto italic = [&](const char* letter, const char* sub = "") {
            Piece piece = one_piece(letter, Face::italic).front();
            piece.sub = sub;
            piece.sub_face = Face::regular;
            text.push_back(piece);
        };
        italic("n");
        append(text, one_piece(" = 3("));
        italic("m");
        append(text, one_piece(" − 1) − 2"));
        italic("c", "1");
        append(text, one_piece(" − "));
        italic("c", "2");
        if (m.welds > 0) {
            append(text, one_piece(" − 3"));
            italic("w");
        }
        const auto signed_number = [&](int value) { return (value < 0 ? "−" : "") + n(std::abs(value)); };
        append(text, one_piece(" = 3·" + n(m.bodies - 1) + " − 2·" + n(m.class_1) + " − " + n(m.class_2) +
                               (m.welds > 0 ? " − 3·" + n(m.welds) : "") + " = " + signed_number(m.gruebler) + " " +
                               word("by Grübler", context_.language)));
        append(text, one_piece("; " +
                               (m.effective != m.gruebler ? n(m.effective) + " " + word("effective", context_.language)
                                                          : word("at this pose", context_.language)) +
                               ": " + verdict_words(m, context_.language) + "."));
        return text;
    }
    RichText axes_words() const {
        RichText text;
        const std::string words =
            word(has_forces(solution_) && !has_motion(solution_) ? "axes forces" : "axes", context_.language);
        std::string plain_part;
        for (std::size_t i = 0; i < words.size();) {
            const std::string_view rest = std::string_view(words).substr(i);
            const bool omega = rest.starts_with("ω"), alpha = rest.starts_with("α");
            if (omega || alpha) {
                append(text, one_piece(plain_part));
                plain_part.clear();
                append(text, typeset(Symbol{omega ? Symbol::Letter::omega : Symbol::Letter::alpha, "", ""}, context_.language));
                i += 2;
            } else {
                plain_part += words[i++];
            }
        }
        append(text, one_piece(plain_part));
        return text;
    }

    const DrawingContext& context_;
    const Solution& solution_;
    const SheetFormat& format_;
    const WantedFigures& wanted_;
    const FigurePages& pages_;
    std::vector<Section> sections_;
};

}  // namespace

double estimated_text(const Solution& s, const SheetFormat& format) {
    double rows = 8;
    for (const Polygon& polygon : s.protocol.polygons) rows += static_cast<double>(polygon.vectors.size());
    rows += 2.0 * static_cast<double>(s.bodies.size());
    double lines = 12;
    for (const Statement& statement : s.protocol.statements)
        if (!told_by_list(statement.message.sentence)) lines += 2.2;
    const double heights = rows * 4.4 + lines * 4.1 + static_cast<double>(s.centres.size() + s.bodies.size()) * 4.7 +
                           4.1 * static_cast<double>(s.remarks.size() + s.unsolved.size()) * 2 + 5 * section_gap;
    double figures = 0;
    if (has_circle(s)) figures += 0.85 * format.measure;
    if (has_velocities(s)) figures += 0.85 * format.measure;
    return (heights + figures) * (format.measure + gap);
}

std::vector<Section> write_sections(const DrawingContext& context, const SheetFormat& format, const WantedFigures& figures,
                                    const FigurePages& pages) {
    return SectionWriter(context, format, figures, pages).write();
}

std::vector<Section> without_spare_rows(std::vector<Section> sections) {
    for (Section& section : sections) {
        for (auto row = section.spare_rows.rbegin(); row != section.spare_rows.rend(); ++row)
            section.rows.erase(section.rows.begin() + static_cast<std::ptrdiff_t>(*row));
        section.spare_rows.clear();
    }
    return sections;
}

}  // namespace kinegraph::render
