#include "render/problems/problem_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/mechanism/exercise.hpp"
#include "engine/solution/problem_solution.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/problems.hpp"
#include "lang/keys/sheet.hpp"
#include "render/content/title_block.hpp"
#include "render/equations/equation_block.hpp"
#include "render/equations/prose.hpp"
#include "render/figures/caption.hpp"
#include "render/page/block.hpp"
#include "render/page/set_formula.hpp"
#include "render/page/shapes.hpp"
#include "render/problems/problem_sections.hpp"
#include "render/text/formula.hpp"
#include "render/text/utf8.hpp"

namespace kinegraph::render {
namespace {

constexpr double between_sections = 3.5, below_figure = 2.5, equation_indent = 6;  // mm

/// A result in words, "1.3537 GPa", its value from the check in the same unit, and their relative difference.
struct ResultCells {
    std::string found, numeric, difference;
};
/// The largest value of the same kind, or of all kinds if that is zero; used as the scale for rounding errors.
double largest_like(const ProblemValue& value, const std::vector<ProblemValue>& values) {
    double largest = 0, of_all = 0;
    for (const ProblemValue& each : values) {
        of_all = std::max(of_all, std::abs(each.value));
        if (each.kind == value.kind && each.unit == value.unit) largest = std::max(largest, std::abs(each.value));
    }
    return largest > 0 ? largest : of_all;
}
ResultCells cells_of(const ProblemValue& value, const std::vector<ProblemValue>& all, const Units& units,
                     Language language) {
    const double larger = std::max(std::abs(value.value), std::abs(value.numeric.value_or(0)));
    const Unit unit = value.shown_in       ? *value.shown_in
                      : value.unit.empty() ? suitable_unit(larger, value.kind, units)
                                           : Unit{value.unit, 1};
    const double si = unit.si.to_double();
    ResultCells cells;
    const std::string symbol = unit.symbol.empty() ? "" : unit.symbol == "°" ? "°" : " " + unit.symbol;
    cells.found = number(value.value / si, 5, language) + symbol;
    if (!value.numeric) return cells;
    const double noise = 1e-12 * std::max(larger, largest_like(value, all));
    cells.numeric = number(std::abs(*value.numeric) <= noise ? 0 : *value.numeric / si, 5, language);
    const double apart = value.value - *value.numeric;
    // A difference below the rounding error is shown as 0.
    cells.difference = std::abs(apart) <= noise ? "0" : number(apart / si, 1, language);
    return cells;
}

const Words& head_of(std::size_t column) {
    static const std::array<Words, 4> heads{Words(lang::common::quantity), Words(lang::problems::found),
                                            Words(lang::problems::check), Words(lang::problems::difference)};
    return heads.at(column);
}

/// A block that is not divided.
struct Item {
    Block block;
    std::size_t section = 0;
    double above = 0;         ///< mm of space above, unless it begins a column
    bool holds_next = false;  ///< a heading stays with what follows
    bool spreads = false;     ///< begins a column if there is one to spare
};

/// The parts of a problem's sheets: its sections, the table of results, answers and remarks.
class ProblemItems {
protected:
    ProblemItems(const Solution& solution, const SheetOptions& options, const Fonts& fonts)
        : context_{solution, options.theme, fonts, options.language, Dimensions::off},
          format_(format_of(options.paper, options.orientation)),
          figures_before_{options.figures_before},
          sections_(sections_of_problem(context_)) {}

    std::string say(const Words& words) const { return in(words, context_.language); }
    /// Scales type for the size of the paper.
    Block fitted(Block block) const { return scaled(std::move(block), format_.text_size); }
    double measure() const { return format_.measure / format_.text_size; }
    /// Whether the value is asked for. True for all values if the file names none.
    bool is_sought(const ProblemValue& value) const {
        const auto& asked = asked_of(context_.solution.mechanism);
        const auto is_it = [&](const AskedResult& other) { return other.name == value.key; };
        return asked.empty() || std::any_of(asked.begin(), asked.end(), is_it);
    }
    static void add(std::vector<Item>& to, std::vector<Item> more) {
        for (Item& each : more) to.push_back(std::move(each));
    }

    std::vector<Item> items(double figure_height) {
        figures_ = figures_before_;
        std::vector<Item> all;
        for (std::size_t s = 0; s < sections_.size(); ++s) {
            if (sections_[s].is_after_results) add(all, results(s));
            add(all, this->section(s, figure_height));
        }
        add(all, remarks(sections_.size()));
        return all;
    }

    std::vector<Item> section(std::size_t s, double figure_height) {
        const ProblemSection& section = sections_[s];
        std::vector<Item> all{
            {fitted(heading_block(context_, measure(), say(section.heading))), s, between_sections, true}};
        constexpr double most_upright = 1.1;  // of its width: a plot in a higher room would be all height
        for (const ProblemFigure& figure : section.figures) {
            const double height = std::min(figure_height * figure.height, most_upright * format_.measure);
            all.push_back({figure_block(figure, format_.measure, height), s, 0, false});
        }
        const auto add_pieces = [&](std::size_t after) {
            for (const PieceAfter& piece : section.pieces) {
                // The sentence before a formula stays with it.
                if (piece.after != after) continue;
                if (!all.empty() && after > 0) all.back().holds_next = true;
                all.push_back({fitted(piece_block(piece.item, measure())), s, 0, false});
            }
        };
        add_pieces(0);
        for (std::size_t k = 0; k < section.sentences.size(); ++k) {
            all.push_back({sentence(section.sentences[k], measure()), s, 0, false});
            add_pieces(k + 1);
        }
        return all;
    }

    using CheckedRow = std::array<RichText, 4>;
    std::vector<CheckedRow> result_table() const {
        std::vector<CheckedRow> rows{{one_piece(say(head_of(0))), one_piece(say(head_of(1))),
                                      one_piece(say(head_of(2))), one_piece(say(head_of(3)))}};
        const std::vector<ProblemValue>& all = context_.solution.problem->values;
        for (const ProblemValue& each : all) {
            const ResultCells cells = cells_of(each, all, context_.solution.mechanism.units, context_.language);
            RichText name = symbol_of(each.symbol);
            append(name, one_piece("  " + say(each.name)));
            rows.push_back({name, with_powers(cells.found), with_powers(cells.numeric), with_powers(cells.difference)});
        }
        return rows;
    }
    /// Right edges of the columns: at their usual places, or further left where the next one needs the room.
    std::array<double, 4> edges_of(const std::vector<CheckedRow>& rows, double width) const {
        constexpr double gap = 2;
        std::array<double, 4> rights{0, 0.62 * width, 0.81 * width, width};
        for (std::size_t i = 2; i > 0; --i) {
            double next = 0;
            for (const CheckedRow& row : rows)
                next = std::max(next, context_.fonts.width(row.at(i + 1), context_.theme.small));
            rights.at(i) = std::min(rights.at(i), rights.at(i + 1) - next - gap);
        }
        return rights;
    }

    std::vector<Item> results(std::size_t section) const {
        std::vector<Item> all;
        Block table;
        // On a slide the table stands alone, as wide as on a sheet before it is made larger.
        constexpr double of_sheet = 80;
        const double width = format_.is_slide ? of_sheet : measure();
        double y = 0;
        const auto rule = [&](double weight) {
            table.marks.emplace_back(line({0, y}, {width, y}, {weight, context_.theme.text, {}, false}));
            y += 1;
        };
        const std::vector<CheckedRow> rows = result_table();
        const std::array<double, 4> rights = edges_of(rows, width);
        const auto row = [&](const CheckedRow& cells, Colour colour) {
            for (std::size_t i = 1; i < cells.size(); ++i) {
                const ShapedLine shaped = context_.fonts.shape(cells.at(i), context_.theme.small);
                set_text(table.marks, shaped, {rights.at(i) - shaped.width, y + 3.2}, colour, "text");
            }
            // A long name continues on the next line.
            constexpr double first_line = 4.6, further_line = 3.5;
            const std::vector<ShapedLine> name = context_.fonts.wrap(cells[0], context_.theme.small, 0.42 * width);
            for (std::size_t i = 0; i < name.size(); ++i)
                set_text(table.marks, name[i], {0, y + 3.2 + static_cast<double>(i) * further_line}, colour, "text");
            y += first_line + further_line * static_cast<double>(std::max<std::size_t>(name.size(), 1) - 1);
        };
        rule(context_.theme.outline);
        row(rows.front(), context_.theme.secondary);
        rule(context_.theme.thin);
        for (std::size_t i = 1; i < rows.size(); ++i) row(rows[i], context_.theme.text);
        rule(context_.theme.outline);
        table.width = width;
        table.height = y;
        const Words heading(lang::problems::results_and_numeric_check);
        all.push_back({fitted(heading_block(context_, width, say(heading))), section, between_sections, true, true});
        all.push_back({fitted(std::move(table)), section, 0, false});
        return all;
    }

    /// Symbol, name and value of the results asked for.
    std::vector<Item> answer_table(std::size_t section) const {
        std::vector<std::vector<Formula>> rows{{Formula(), Formula::upright(say(head_of(0))),
                                                Formula::upright(word(lang::common::value, context_.language))}};
        const Units& units = context_.solution.mechanism.units;
        for (const ProblemValue& each : context_.solution.problem->values) {
            if (!is_sought(each)) continue;
            const ResultCells cells = cells_of(each, context_.solution.problem->values, units, context_.language);
            Formula symbol;
            symbol.kind = Formula::Kind::text;
            symbol.text = symbol_of(each.symbol);
            rows.push_back({std::move(symbol), Formula::upright(say(each.name)), Formula::upright(cells.found)});
        }
        const EquationItem table{EquationItem::Kind::table, {}, {}, std::move(rows)};
        NaturalBlocks natural;
        std::vector<Item> all{
            {fitted(heading_block(context_, measure(), word(lang::sheet::answers, context_.language))), section,
             between_sections, true}};
        for (Block& line : equation_blocks(context_, {&table, 1}, measure(), natural))
            all.push_back({fitted(std::move(line)), section, 0, false});
        if (all.size() > 1) all[1].holds_next = true;
        return all;
    }

    std::vector<Item> remarks(std::size_t section) const {
        std::vector<Item> all;
        if (context_.solution.problem->remarks.empty()) return all;
        all.push_back({fitted(heading_block(context_, measure(), word(lang::sheet::remarks, context_.language))),
                       section, between_sections, true});
        for (const Words& each : context_.solution.problem->remarks)
            all.push_back({sentence(each, measure()), section, 0, false});
        return all;
    }

    Block figure_block(const ProblemFigure& wanted, double width, double height) {
        Figure figure = wanted.draw(width, height - 9);
        Block block;
        const double caption = set_caption(block.marks, context_, figure, ++figures_, {0, 0}, width);
        figure.move(0.5 * (width - figure.box.width()) - figure.box.min.x, caption - figure.box.min.y);
        block.marks.insert(block.marks.end(), figure.marks.begin(), figure.marks.end());
        block.width = width;
        block.height = caption + figure.box.height() + below_figure;
        return block;
    }

    /// A formula below its sentence, or a table that is not divided.
    Block piece_block(const EquationItem& item, double width) const {
        constexpr double indent = 5, air = 1.3;
        if (item.kind == EquationItem::Kind::formula) {
            Block alone = formula_block(item.formula, context_.fonts, context_.theme.derived, width - indent,
                                        context_.theme.text);
            Block block{{}, width, alone.height + air};
            set(block.marks, std::move(alone), {indent, 0});
            return block;
        }
        Block whole{{}, width, 0};
        NaturalBlocks once;
        for (Block& line : equation_blocks(context_, {&item, 1}, width, once)) {
            const double height = line.height;
            set(whole.marks, std::move(line), {0, whole.height});
            whole.height += height;
        }
        return whole;
    }

    /// A sentence, with its equations on separate lines.
    Block sentence(const Words& words, double width) const {
        const std::string text = say(words);
        Block block;
        for (std::size_t from = 0; from <= text.size();) {
            const std::size_t to = std::min(text.find('\n', from), text.size());
            const bool is_equation = from > 0;
            const Block line = paragraph_block(context_, width, formula(text.substr(from, to - from)),
                                               is_equation ? equation_indent : 0, "");
            set(block.marks, line, {0, block.height + (is_equation ? 0.6 : 0)});
            block.height += line.height + (is_equation ? 0.6 : 0);
            from = to + 1;
        }
        block.width = width;
        block.height += 0.9;
        return fitted(std::move(block));
    }

    DrawingContext context_;
    SheetFormat format_;
    int figures_before_;
    std::vector<ProblemSection> sections_;
    int figures_ = 0;
};

class ProblemSheet : ProblemItems {
public:
    ProblemSheet(const Solution& solution, const SheetOptions& options, const Fonts& fonts)
        : ProblemItems(solution, options, fonts),
          signature_{options.author, options.date},
          before_{options.pages_before},
          after_{options.pages_after},
          with_sentences_(options.with_sentences) {}

    std::vector<Page> pages() {
        // The greatest height of figures, in steps, that needs no more pages than the least. The results get a column
        // of their own if that adds no page.
        constexpr double least = 54, step = 4;  // mm
        constexpr int steps = 30;               // up to the height of a page
        const auto items_at = [&](int at) { return items(least + at * step); };
        const std::size_t fewest = flow(items_at(0), false).size();
        int good = 0;
        for (int bad = steps + 1; bad - good > 1;) {
            const int middle = (good + bad) / 2;
            (flow(items_at(middle), false).size() > fewest ? bad : good) = middle;
        }
        const std::vector<Item> all = items_at(good);
        std::vector<std::vector<Mark>> best = flow(all, false);
        if (auto spread = flow(all, true); spread.size() == best.size()) best = std::move(spread);
        return framed(best);
    }

    /// The given data with their figure, and the results to find.
    std::vector<Page> question() {
        signature_.subtitle = word(lang::sheet::subtitle_question, context_.language);
        ProblemSection given = sections_.front();
        given.sentences.resize(given.sentences.size() - given.found);
        for (ProblemFigure& figure : given.figures)
            if (figure.as_question) figure.draw = figure.as_question;
        ProblemSection sought{"sought", lang::sheet::sought, {}, {}};
        for (const ProblemValue& each : context_.solution.problem->values) {
            if (!is_sought(each)) continue;
            const std::string symbol = "{" + each.symbol + "}";
            sought.sentences.push_back(formula_words("– " + symbol + "  {0}", {each.name}));
        }
        sections_ = {std::move(given), std::move(sought)};
        constexpr double height = 86;
        std::vector<Item> all;
        for (std::size_t s = 0; s < sections_.size(); ++s) add(all, section(s, height));
        return framed(flow(all, false));
    }

    /// The question's figure and the results asked for, with their values.
    std::vector<Page> answers() {
        signature_.subtitle = word(lang::sheet::subtitle_answers, context_.language);
        ProblemSection given = sections_.front();
        given.sentences.clear();
        given.pieces.clear();
        for (ProblemFigure& figure : given.figures)
            if (figure.as_question) figure.draw = figure.as_question;
        sections_ = {std::move(given)};
        constexpr double height = 86;
        std::vector<Item> all = section(0, height);
        add(all, answer_table(1));
        add(all, remarks(1));
        return framed(flow(all, false));
    }

    std::vector<Page> steps() {
        std::vector<std::vector<Mark>> sheets;
        std::vector<StepText> said;
        for (std::size_t s = 0; s < sections_.size(); ++s)
            for (std::size_t k = 0; k < sections_[s].sentences.size(); ++k) {
                sheets.push_back(step(s, k));
                said.push_back(text_of_step(s, k));
            }
        sheets.push_back(results_alone());
        std::vector<Page> pages = framed(sheets);
        for (std::size_t i = 0; i < said.size(); ++i) pages[i].step = std::move(said[i]);
        return pages;
    }

private:
    std::vector<Page> framed(const std::vector<std::vector<Mark>>& sheets) {
        std::vector<Page> pages;
        for (std::size_t i = 0; i < sheets.size(); ++i)
            pages.push_back(framed_page(context_, format_, signature_, sheets[i], std::nullopt, before_ + i + 1,
                                        before_ + sheets.size() + after_, before_ + i == 0));
        return pages;
    }

    // --- positions
    double left_of(int column) const { return format_.content.min.x + column * (format_.measure + gap); }
    double bottom(int column, bool first_page) const {
        if (!first_page) return format_.content.max.y - strip_height;
        return left_of(column) + format_.measure > format_.block.min.x - 2 ? format_.block.min.y - 3
                                                                           : format_.content.max.y;
    }

    /// Places items one below the other, column by column, page by page.
    std::vector<std::vector<Mark>> flow(const std::vector<Item>& all, bool spread) const {
        std::vector<std::vector<Mark>> sheets(1);
        int column = 0;
        double y = format_.content.min.y;
        bool begins = true;
        std::optional<std::size_t> open;
        const auto close = [&] {
            if (open) sheets.back().emplace_back(GroupEnd{});
            open.reset();
        };
        for (std::size_t i = 0; i < all.size(); ++i) {
            const Item& item = all[i];
            double needed = item.block.height;
            for (std::size_t k = i; all[k].holds_next && k + 1 < all.size(); ++k) needed += all[k + 1].block.height;
            if (!begins && ((spread && item.spreads) ||
                            y + item.above + needed > bottom(column, before_ == 0 && sheets.size() == 1))) {
                if (++column == format_.columns) {
                    close();
                    sheets.emplace_back();
                    column = 0;
                }
                y = format_.content.min.y;
                begins = true;
            }
            if (open != item.section) {
                close();
                const std::string question =
                    item.section < sections_.size() ? sections_[item.section].question : "remarks";
                sheets.back().emplace_back(GroupBegin{"band", {}, "", {{"data-question", question}}, none});
                open = item.section;
            }
            y += begins ? 0 : item.above;
            set(sheets.back(), item.block, {left_of(column), y});
            y += item.block.height;
            begins = false;
        }
        close();
        return sheets;
    }

    StepText text_of_step(std::size_t s, std::size_t k) const {
        const ProblemSection& section = sections_[s];
        const std::string sentence = say(section.sentences[k]);
        const double size = said_smaller_ * format_.text_size * context_.theme.body_text;
        StepText text{section.question, say(section.heading), {}, said_at_, format_.measure, size};
        for (std::size_t from = 0; from <= sentence.size();) {
            const std::size_t to = std::min(sentence.find('\n', from), sentence.size());
            text.sentences.push_back(formula(sentence.substr(from, to - from)));
            from = to + 1;
        }
        return text;
    }

    /// The table of results on a page by itself; on a slide as large as it can be.
    std::vector<Mark> results_alone() const {
        std::vector<Item> items = results(sections_.size());
        double height = 0, width = 1;
        for (const Item& item : items) {
            height += item.above + item.block.height;
            width = std::max(width, item.block.width);
        }
        const double bottom = format_.block.min.y - above_block;
        const double larger =
            format_.is_slide ? std::min(format_.content.width() / width, (bottom - format_.content.min.y) / height) : 1;
        std::vector<Mark> marks;
        double y = format_.content.min.y;
        for (Item& item : items) {
            y += larger * item.above;
            const Block block = larger == 1 ? std::move(item.block) : scaled(std::move(item.block), larger);
            set(marks, block, {format_.content.min.x, y});
            y += block.height;
        }
        return marks;
    }

    /// The formulas of sentence k and then the sentence; smaller where they are too high for the slide.
    void say_on_slide(std::vector<Mark>& marks, const ProblemSection& section, std::size_t k, Spot at) {
        std::vector<Block> blocks;
        for (const PieceAfter& piece : section.pieces)
            if (piece.after == k + 1 || (k == 0 && piece.after == 0))
                blocks.push_back(fitted(piece_block(piece.item, measure())));
        blocks.push_back(sentence(section.sentences[k], measure()));
        double height = 0;
        for (const Block& block : blocks) height += block.height;
        said_smaller_ = std::min(1.0, (format_.block.min.y - above_block - at.y) / height);
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            const bool is_sentence = i + 1 == blocks.size();
            if (is_sentence) said_at_ = at;
            if (is_sentence) marks.emplace_back(GroupBegin{"sentence", {}, "", {}, none});
            const Block block = scaled(std::move(blocks[i]), said_smaller_);
            if (!is_sentence || with_sentences_) set(marks, block, at);
            if (is_sentence) marks.emplace_back(GroupEnd{});
            at.y += block.height;
        }
    }

    /// Figures on the left; on the right the sentences of the question up to number k, earlier ones in grey. A slide
    /// has the last sentence alone, with its formulas.
    std::vector<Mark> step(std::size_t s, std::size_t k) {
        std::vector<Mark> marks;
        const ProblemSection& section = sections_[s];
        // A section without figures shows those of the last section before it that has some.
        std::size_t shown = s;
        while (shown > 0 && sections_[shown].figures.empty()) --shown;
        figures_ = figures_before_;
        for (std::size_t before = 0; before < shown; ++before)
            figures_ += static_cast<int>(sections_[before].figures.size());
        const double width = format_.columns > 1 ? format_.span(format_.columns - 1, format_.columns) : format_.measure;
        const Spot corner = format_.content.min;
        const auto& figures = sections_[shown].figures;
        const double room = std::min(
            (format_.block.min.y - corner.y - 6) / static_cast<double>(std::max<std::size_t>(figures.size(), 1)),
            0.8 * width);
        double y = corner.y;
        for (const ProblemFigure& each : figures) {
            const Block block = figure_block(each, width, room);
            set(marks, block, {corner.x, y});
            y += block.height + gap;
        }
        const double left = format_.content.max.x - format_.measure;
        y = corner.y;
        Block heading = fitted(heading_block(context_, measure(), say(section.heading)));
        if (const double ink = box_of(heading.marks).max.x; format_.is_slide && ink > format_.measure)
            heading = scaled(std::move(heading), format_.measure / ink);
        set(marks, heading, {left, y});
        y += heading.height;
        const auto put = [&](Block block, bool is_new) {
            if (!is_new)
                for (Mark& mark : block.marks)
                    if (auto* text = std::get_if<TextMark>(&mark)) text->colour = context_.theme.secondary;
            set(marks, block, {left, y});
            y += block.height;
        };
        const auto put_pieces = [&](std::size_t after, bool is_new) {
            for (const PieceAfter& piece : section.pieces)
                if (piece.after == after) put(fitted(piece_block(piece.item, measure())), is_new);
        };
        if (format_.is_slide) {
            say_on_slide(marks, section, k, {left, y});
            return marks;
        }
        put_pieces(0, k == 0);
        for (std::size_t i = 0; i <= k; ++i) {
            put(sentence(section.sentences[i], measure()), i == k);
            put_pieces(i + 1, i == k);
        }
        return marks;
    }

    Signature signature_;
    std::size_t before_, after_;  // pages of the same document
    bool with_sentences_;
    // Of the last slide: where its sentence stands, and how much smaller than usual.
    Spot said_at_;
    double said_smaller_ = 1;
};

}  // namespace

std::vector<Page> lay_out_problem(const Solution& solution, const SheetOptions& options, const Fonts& fonts) {
    ProblemSheet sheet(solution, options, fonts);
    switch (options.kind) {
        case SheetKind::question: return sheet.question();
        case SheetKind::answers: return sheet.answers();
        case SheetKind::solution: break;
    }
    return sheet.pages();
}
std::vector<Page> lay_out_problem_steps(const Solution& solution, const SheetOptions& options, const Fonts& fonts) {
    return ProblemSheet(solution, options, fonts).steps();
}

std::vector<std::string> problem_figure_names(const DrawingContext& context) {
    std::vector<std::string> names;
    for (const ProblemSection& section : sections_of_problem(context))
        for (const ProblemFigure& figure : section.figures) names.push_back(figure.id);
    return names;
}
std::optional<Figure> problem_figure(const DrawingContext& context, const std::string& name, double room_x,
                                     double room_y) {
    for (const ProblemSection& section : sections_of_problem(context))
        for (const ProblemFigure& figure : section.figures)
            if (figure.id == name) return figure.draw(room_x, room_y);
    return std::nullopt;
}

std::string problem_table(const Solution& solution, Language language) {
    const std::string& title = in(solution.mechanism.title, language);
    std::string text = title.empty() ? "" : title + "\n";
    text += in(solution.problem->subject, language) + "\n\n";
    std::vector<std::array<std::string, 4>> rows{
        {in(head_of(0), language), in(head_of(1), language), in(head_of(2), language), in(head_of(3), language)}};
    for (const ProblemValue& each : solution.problem->values) {
        const ResultCells cells = cells_of(each, solution.problem->values, solution.mechanism.units, language);
        rows.push_back({each.symbol + "  " + in(each.name, language), cells.found, cells.numeric, cells.difference});
    }
    std::array<std::size_t, 4> widths{};
    for (const auto& row : rows)
        for (std::size_t c = 0; c < row.size(); ++c) widths.at(c) = std::max(widths.at(c), character_count(row.at(c)));
    for (const auto& row : rows) {
        std::string each = " ";
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string space(widths.at(c) - character_count(row.at(c)), ' ');
            each += c == 0 ? " " + row.at(c) + space : "  " + space + row.at(c);
        }
        while (each.ends_with(' ')) each.pop_back();
        text += each + "\n";
    }
    if (!solution.problem->remarks.empty()) {
        text += "\n" + word(lang::sheet::remarks, language) + "\n";
        for (const Words& each : solution.problem->remarks) text += "  " + in(each, language) + "\n";
    }
    return text;
}

}  // namespace kinegraph::render
