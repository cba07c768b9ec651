// Figure 1 is drawn at its scale in the solution and at the position of the mechanism there. Text runs through the free
// parts of the columns; blank areas with pole and grid follow.
#include "render/sheet/handout.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "engine/mechanism/exercise.hpp"
#include "lang/keys/sheet.hpp"
#include "render/content/bands.hpp"
#include "render/content/exercise_text.hpp"
#include "render/content/title_block.hpp"
#include "render/content/wanted_figures.hpp"
#include "render/equations/equation_block.hpp"
#include "render/equations/prose.hpp"
#include "render/figures/caption.hpp"
#include "render/figures/figure.hpp"
#include "render/layout/drawn_sheet.hpp"
#include "render/layout/page_plan.hpp"
#include "render/page/shapes.hpp"
#include "render/tables/answers.hpp"

namespace kinegraph::render {
namespace {

constexpr double round_figure = 6;  // mm; kept free
constexpr double passage_gap = 4.5;

/// A free part of a column.
struct Stretch {
    std::size_t page = 0;
    double left = 0, top = 0, bottom = 0;
};

class Handout {
public:
    Handout(const Solution& solution, const std::vector<RequestedResult>& asked, const SheetOptions& options,
            const Fonts& fonts)
        : asked_(asked),
          options_(options),
          context_{solution, options.theme, fonts, options.language, options.dimensions},
          format_(format_of(options.paper, options.orientation)),
          drawn_(draw_solution(solution, as_solution(options), fonts)),
          is_question_(options.kind == SheetKind::question) {
        sheets_.resize(1);
    }

    std::vector<Page> pages() {
        place_figure();
        set_text(is_question_ ? question() : key());
        if (is_question_) add_loops();
        if (options_.grid) add_blank_rooms(context_, format_, drawn_.figures, sheets_);
        const Signature signature{
            options_.author, options_.date,
            word(is_question_ ? lang::sheet::subtitle_question : lang::sheet::subtitle_answers, context_.language)};
        std::vector<Page> pages;
        for (std::size_t i = 0; i < sheets_.size(); ++i)
            pages.push_back(framed_page(context_, format_, signature, sheets_[i], i == 0 ? scale_ : std::nullopt, i + 1,
                                        sheets_.size(), i == 0));
        return pages;
    }

    /// Of the key. Call it after pages().
    std::vector<RichText> remarks() && { return std::move(remarks_); }

private:
    static SheetOptions as_solution(const SheetOptions& options) {
        SheetOptions solution = options;
        solution.kind = SheetKind::solution;
        return solution;
    }

    // --- figure 1

    void place_figure() {
        Figure figure = drawn_.figures.front();
        Spot at = drawn_.caption;
        if (is_question_) {
            figure = question_in_place(figure, at);
            leave_room_for_caption(figure);
            drawn_.figures.front().scale = figure.scale;  // for the list of scales
        }
        marks().emplace_back(GroupBegin{"band", {}, "", {{"data-question", "given"}}});
        const double caption = set_caption(marks(), context_, figure, 1, at, drawn_.caption_width);
        marks().insert(marks().end(), figure.marks.begin(), figure.marks.end());
        marks().emplace_back(GroupEnd{});
        taken_ = figure.box;
        taken_.include(at);
        taken_.include(at + Spot{drawn_.caption_width, caption});
        if (figure.traits.measured == QuantityKind::length) scale_ = figure.scale;
    }
    /// The figure stands where the solution has it, whose caption may be lower: a remark beside the scale gives way.
    void leave_room_for_caption(Figure& figure) const {
        if (caption_width(context_, figure, 1) > drawn_.caption_width) figure.further_scale.clear();
    }
    /// The mechanism with its data at its position in the solution. If it needs the space of the caption, the caption
    /// moves down; only if it still leaves the paper, the mechanism moves.
    Figure question_in_place(const Figure& solved, Spot& caption) const {
        constexpr double air = 1.5;  // mm; white space below its letters, included in its height
        constexpr double rim = 2.5;  // within the frame; a letter may stand in the margin
        const Box content = content_of(format_, true);
        const Spot origin = solved.origin;
        Figure captioned = Figure::empty_at(solved.scale);
        captioned.unit = "m";
        captioned.caption = one_piece(word(lang::sheet::mechanism_and_its_data, context_.language));
        const double words = caption_height(captioned);
        const auto drawn_in = [&](const Box& free) {
            Figure figure = exercise_figure_within(context_, solved.scale, {free.min - origin, free.max - origin});
            figure.move(origin.x - figure.origin.x, origin.y - figure.origin.y);
            return figure;
        };
        Box free{{content.min.x, caption.y + words - air}, {content.max.x, format_.block.min.y - round_figure}};
        Figure figure = drawn_in(free);
        const bool above = figure.box.min.y >= free.min.y;
        if (!above) {
            free.min.y = content.min.y;
            free.max.y -= words;
            figure = drawn_in(free);
        }
        const auto into = [](double least, double most, double from, double to) {
            return least < from ? from - least : most > to ? std::max(to - most, from - least) : 0;
        };
        figure.move(into(figure.box.min.x, figure.box.max.x, format_.inner.min.x + rim, format_.inner.max.x - rim),
                    into(figure.box.min.y, figure.box.max.y, free.min.y, content.max.y));
        if (!above) caption.y = figure.box.max.y + air;
        return figure;
    }
    double caption_height(const Figure& figure) const {
        std::vector<Mark> unused;
        return set_caption(unused, context_, figure, 1, {}, drawn_.caption_width);
    }

    // --- text

    double measure() const { return format_.measure / format_.text_size; }
    Passage passage(Key title, const std::vector<RichText>& paragraphs, const std::string& bullet) const {
        return passage_under(word(title, context_.language), paragraphs, bullet);
    }
    Passage passage_under(const std::string& words, const std::vector<RichText>& paragraphs,
                          const std::string& bullet) const {
        Passage passage{
            heading_block(context_, measure(), words),
            heading_block(context_, measure(), words + ", " + word(lang::sheet::continued, context_.language)),
            {},
            {}};
        for (const RichText& each : paragraphs)
            passage.rows.emplace_back(paragraph_block(context_, measure(), each, bullet.empty() ? 0 : 4, bullet));
        return passage;
    }
    std::vector<Passage> question() const {
        const std::vector<Answer> sought =
            answers_sought(context_.solution.mechanism, answers_of(context_, drawn_.figures));
        Passage asked = passage(lang::sheet::sought, sought_of(context_, asked_), "–");
        if (has_turning_sense(context_.solution.mechanism))
            asked.rows.emplace_back(paragraph_block(
                context_, measure(), one_piece(word(turning_senses(context_.solution), context_.language)), 0, ""));
        return {passage(lang::sheet::data, data_of(context_), ""), std::move(asked),
                passage(lang::sheet::scales, scales_of(context_, drawn_.figures, sought), "–")};
    }
    std::vector<Passage> key() {
        std::vector<Passage> passages;
        Topic section = Topic::unnamed;
        std::vector<Answer> group;
        std::vector<RequestedResult> asked = asked_;
        for (RequestedResult& each : asked) each.symbol = asked_text(context_, each.column).symbol;
        const std::vector<Answer> answers = key_of(context_, drawn_.figures, asked);
        const auto close = [&] {
            if (group.empty()) return;
            const std::string heading = section == Topic::unnamed ? word(lang::sheet::answers, context_.language)
                                                                  : heading_of(section, context_.language);
            Passage passage = passage_under(heading, {}, "");
            passage.take_table(answer_lines(context_, group, measure()));
            passages.push_back(std::move(passage));
            group.clear();
        };
        for (const Answer& each : answers) {
            if (each.section != section) close();
            section = each.section;
            group.push_back(each);
        }
        close();
        add_equations(passages);
        std::vector<RichText> remarks = signs_of(context_);
        remarks.push_back(one_piece(word(lang::sheet::tolerances, context_.language)));
        if (auto remark = remark_on_unreadable(context_, answers)) {
            remarks_.push_back(*remark);
            remarks.push_back(*std::move(remark));
        }
        for (const Message& each : context_.solution.remarks) remarks.push_back(say(each, context_.language));
        passages.push_back(passage(lang::sheet::remarks, remarks, ""));
        return passages;
    }
    bool seeks_equations() const {
        const Mechanism& mechanism = context_.solution.mechanism;
        return mechanism.find.equations && asked_of(mechanism).empty();
    }
    /// If the equations are asked for: the resulting equations, one passage for each heading.
    void add_equations(std::vector<Passage>& passages) const {
        if (!seeks_equations()) return;
        const std::vector<EquationItem> items = equation_answers(context_.solution, context_.language);
        NaturalBlocks natural;
        for (std::size_t first = 0; first < items.size();) {
            std::size_t end = first + 1;
            while (end < items.size() && items[end].kind != EquationItem::Kind::heading) ++end;
            passages.push_back(passage_under(items[first].words, {}, ""));
            passages.back().take_rows(
                equation_blocks(context_, std::span(items).subspan(first + 1, end - first - 1), measure(), natural));
            first = end;
        }
    }
    /// On the first page beside and below the figure; on further pages whole columns.
    std::vector<Stretch> stretches(std::size_t page) const {
        std::vector<Stretch> beside, under;
        const Box content = content_of(format_, page == 0);
        for (int c = 0; c < format_.columns; ++c) {
            const double left = content.min.x + c * (format_.measure + gap), right = left + format_.measure;
            Stretch stretch{page, left, content.min.y, content.max.y};
            if (page > 0) {
                beside.push_back(stretch);
                continue;
            }
            if (right > format_.block.min.x - round_figure) stretch.bottom = format_.block.min.y - round_figure;
            const bool meets = right > taken_.min.x - round_figure && left < taken_.max.x + round_figure;
            if (meets) stretch.top = taken_.max.y + round_figure;
            constexpr double least = 25;
            if (stretch.bottom - stretch.top > least) (meets ? under : beside).push_back(stretch);
        }
        beside.insert(beside.end(), under.begin(), under.end());
        return beside;
    }
    void set_text(std::vector<Passage> passages) {
        std::vector<Stretch> free = stretches(0);
        std::size_t now = 0;
        double y = 0;
        const auto next = [&] {
            if (++now < free.size()) return y = free[now].top, void();
            sheets_.emplace_back();
            free = stretches(sheets_.size() - 1);
            now = 0;
            y = free.front().top;
        };
        if (free.empty())
            next();
        else
            y = free.front().top;
        const auto put = [&](const SharedBlock& block) {
            render::set(sheets_[free[now].page], block.set(), {free[now].left, y});
            y += block.height();
        };
        for (Passage& passage : passages) {
            for (SharedBlock* block : {&passage.heading, &passage.heading_again, &passage.head})
                *block = reduced(*block);
            double whole = passage.heading.height() + passage.head.height() + passage_gap;
            for (const SharedBlock& row : passage.rows) whole += reduced(row).height();
            // A block that fits into a column is not divided.
            if (const Stretch& here = free[now]; y > here.top && y + whole > here.bottom) {
                const bool fits_next = now + 1 < free.size() && whole <= free[now + 1].bottom - free[now + 1].top;
                if (fits_next) next();
            }
            for (std::size_t i = 0; i < passage.rows.size(); ++i) {
                const SharedBlock row = reduced(passage.rows[i]);
                const double above = i == 0 ? passage.heading.height() + passage.head.height() : 0;
                const bool at_top = y <= free[now].top;
                if (i == 0 && !at_top) y += passage_gap;
                const bool turns = !at_top && y + above + row.height() > free[now].bottom;
                if (turns) next();
                if (i == 0)
                    put(passage.heading), put(passage.head);
                else if (turns)
                    put(free[now].page > 0 && now == 0 ? passage.heading_again : SharedBlock{}), put(passage.head);
                put(row);
            }
        }
    }
    SharedBlock reduced(const SharedBlock& block) const { return scaled(block, format_.text_size); }

    /// If the equations are asked for: the symbols to be used, so that answers can be compared.
    void add_loops() {
        for (const Figure& drawn : drawn_.figures) {
            if (!drawn.traits.names_unknowns || !seeks_equations()) continue;
            const Box content = content_of(format_, false);
            Figure figure = drawn;
            sheets_.emplace_back();
            sheets_.back().emplace_back(GroupBegin{"band", {}, "", {{"data-question", "equations"}}});
            const double caption = set_caption(sheets_.back(), context_, figure, 2, content.min, content.width());
            figure.move(content.min.x - figure.box.min.x, content.min.y + caption - figure.box.min.y);
            sheets_.back().insert(sheets_.back().end(), figure.marks.begin(), figure.marks.end());
            sheets_.back().emplace_back(GroupEnd{});
        }
    }

    std::vector<Mark>& marks() { return sheets_.front(); }

    const std::vector<RequestedResult>& asked_;
    const SheetOptions& options_;
    DrawingContext context_;
    SheetFormat format_;
    DrawnSheet drawn_;
    bool is_question_;
    Box taken_;  // by figure 1 with its caption
    std::optional<double> scale_;
    std::vector<std::vector<Mark>> sheets_;
    std::vector<RichText> remarks_;
};

}  // namespace

std::vector<Page> lay_out_handout(const Solution& solution, const SheetOptions& options, const Fonts& fonts,
                                  const std::vector<RequestedResult>& asked) {
    return Handout(solution, asked, options, fonts).pages();
}

LaidOutKey lay_out_key_of(const Solution& solution, const std::vector<RequestedResult>& asked,
                          const SheetOptions& options, const Fonts& fonts) {
    Handout handout(solution, asked, options, fonts);
    std::vector<Page> pages = handout.pages();
    return {std::move(pages), std::move(handout).remarks()};
}

}  // namespace kinegraph::render
