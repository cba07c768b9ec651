// The sheet: figures, equations, tables and steps on pages, without overlaps. Owns the sequence of planning and
// drawing. Computes no mechanics; figures are moved, never scaled.
//
// Method: a solution is a sequence of bands, each a question with its figures and text (bands). Each figure has sizes
// at the standard scales that a page could take, estimated by its strokes until a plan chooses one and it is drawn
// (measured_figures). A band gets the arrangement with the highest score for its space (band_layout). Bands in their
// order make rows, and rows make the fewest pages (page_plan). Where these leave white, figures and then the text grow,
// as far as that costs no page (sheet_plan). The drawings that were chosen are set on the pages (drawn_figures,
// sheet_pages).
#include "render/sheet/sheet.hpp"

#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "engine/solution/problem_solution.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/sheet.hpp"
#include "render/layout/drawn_sheet.hpp"
#include "render/layout/sheet_pages.hpp"
#include "render/problems/contact_pages.hpp"
#include "render/problems/problem_sheet.hpp"
#include "render/sheet/handout.hpp"
#include "render/sheet/sheet_limits.hpp"

namespace kinegraph::render {
namespace {

class Layout {
public:
    Layout(const Solution& solution, const SheetOptions& options, std::optional<KeptScales> kept, const Fonts& fonts)
        : context_{solution, options.theme, fonts, options.language, options.dimensions},
          format_(format_for(options)),
          signature_{options.author, options.date},
          after_(options.pages_after),
          wanted_(context_, options.joukowsky, options.detail, options.superposed),
          bands_(context_, wanted_, options.detail),
          kept_(std::move(kept)),
          measured_(context_, wanted_, format_, kept_),
          plan_(wanted_, measured_, bands_, format_),
          figures_(context_, wanted_, bands_, measured_) {}

    std::size_t pages() {
        settle();
        return plan_.pages().size();
    }
    KeptScales scales() {
        settle();
        return plan_.scales();
    }
    DrawnSheet drawn() {
        settle();
        figures_.enrich();
        tell_where_figures_stand();
        SheetPages pages(context_, format_, signature_, {plan_, bands_, figures_, *text_});
        DrawnSheet sheet{pages.set(after_), {}, pages.first_caption(), pages.first_caption_width()};
        std::map<int, Figure*> by_number;
        for (auto& [band, figures] : figures_.by_band())
            for (DrawnFigure& each : figures) by_number[each.number] = &each.figure;
        for (const auto& [number, figure] : by_number) sheet.figures.push_back(std::move(*figure));
        return sheet;
    }

private:
    /// A solution in brief is on few pages.
    static SheetFormat format_for(const SheetOptions& options) {
        constexpr double price_of_a_page_in_brief = 12;
        SheetFormat format = format_of(options.paper, options.orientation);
        if (options.detail == SolutionDetail::brief) format.price_of_a_page = price_of_a_page_in_brief;
        return format;
    }
    void settle() {
        if (text_) return;
        do {
            plan_.make();
            figures_.take(plan_);
        } while (changes_text());
    }
    /// Whether the drawings of the plan change the text, so that another plan is needed: a remark on a figure, or a
    /// table that became too wide for its narrow column with the letters of details.
    bool changes_text() {
        bool changed = false;
        for (const auto& [band, figures] : figures_.by_band())
            for (const DrawnFigure& drawn : figures) {
                if (misses_its_scale(drawn)) changed = remark(drawn, lang::sheet::scale_refused, {}) || changed;
                if (const std::vector<RichText>& left_out = drawn.figure.unnamed; !left_out.empty())
                    changed = remark(drawn, lang::sheet::names_left_out, left_out) || changed;
            }
        text_.emplace(bands_, figures_, plan_.texts());
        return changed || has_wider_tables();
    }
    bool misses_its_scale(const DrawnFigure& drawn) const {
        const std::optional<double>& asked = wanted_.list[drawn.wanted].asked;
        constexpr double rounding = 1e-9;
        return asked && std::abs(drawn.figure.scale - *asked) > rounding * drawn.figure.scale;
    }
    /// Adds "Fig. 1–3, sheet 1" where text continues on another page.
    void tell_where_figures_stand() {
        struct Standing {
            std::size_t page;
            int first, last;
        };
        std::map<std::string, Standing> standing;
        const auto look = [&](std::size_t page, const PlacedBand& placed) {
            const std::string& question = bands_.list[placed.band].question;
            const auto drawn = figures_.by_band().find(placed.band);
            if (drawn != figures_.by_band().end() && !drawn->second.empty())
                standing.try_emplace(question,
                                     Standing{page, drawn->second.front().number, drawn->second.back().number});
            else if (const auto found = standing.find(question); found != standing.end() && found->second.page != page)
                bands_.tell_figures(question, found->second.first, found->second.last, found->second.page);
        };
        for (std::size_t page = 0; page < plan_.pages().size(); ++page)
            for (const PlannedRow& row : plan_.pages()[page])
                for (const PlannedCell& cell : row)
                    for (const PlacedBand& placed : cell) look(page, placed);
    }
    /// Whether a table became too wide for its narrow column with the letters of details, which are known only after
    /// drawing.
    bool has_wider_tables() {
        bool found = false;
        plan_.for_each_band([&](const PlacedBand& placed, const BandLayout& layout) {
            const Band& band = bands_.list[placed.band];
            if (layout.divided > 0 && text_->of(band, layout).is_too_wide())
                found = plan_.has_wide_tables(band.question, layout.divided) || found;
        });
        return found;
    }
    /// Adds a remark to a figure: the words, then `followed_by`. False if it has the remark already.
    bool remark(const DrawnFigure& drawn, Key words, const std::vector<RichText>& followed_by) {
        constexpr std::size_t most_listed = 12;
        RichText text = drawn.figure.caption;
        append(text, one_piece(word(lang::notation::colon, context_.language) + word(words, context_.language)));
        for (std::size_t i = 0; i < std::min(followed_by.size(), most_listed); ++i) {
            append(text, one_piece(i > 0 ? ", " : " "));
            append(text, followed_by[i]);
        }
        if (followed_by.size() > most_listed)
            append(text, one_piece(" … (" + std::to_string(followed_by.size()) + ")"));
        if (!bands_.remark(wanted_.name(drawn.wanted) + words.name(), text)) return false;
        plan_.texts().forget("remarks");
        return true;
    }

    DrawingContext context_;
    SheetFormat format_;
    Signature signature_;
    std::size_t after_;  // pages bound behind these
    WantedFigures wanted_;
    Bands bands_;
    std::optional<KeptScales> kept_;
    MeasuredFigures measured_;
    SheetPlan plan_;
    DrawnFigures figures_;
    std::optional<DrawnText> text_;  // of the bands, after drawing
};

}  // namespace

namespace {

/// A problem has the same scales in every language, and no coarser ones in brief, where that costs no page.
std::optional<KeptScales> scales_to_keep(const Solution& solution, const SheetOptions& options, const Fonts& fonts) {
    if (options.kept) return options.kept;
    SheetOptions other = options;
    if (options.language != Language::en) {
        other.language = Language::en;
        return scales_of_solution(solution, other, fonts);
    }
    if (options.detail == SolutionDetail::full || !is_planned_twice(solution)) return std::nullopt;
    other.detail = SolutionDetail::full;
    KeptScales kept = scales_of_solution(solution, other, fonts);
    kept.hold = KeptScales::Hold::not_coarser;
    return kept;
}

template <class Make>
auto from_layout(const Solution& solution, const SheetOptions& options, const Fonts& fonts, Make make) {
    const std::optional<KeptScales> kept = scales_to_keep(solution, options, fonts);
    Layout layout(solution, options, kept, fonts);
    if (options.detail == SolutionDetail::brief && kept && !options.kept) {
        Layout free(solution, options, std::nullopt, fonts);
        if (free.pages() < layout.pages()) return make(free);
    }
    return make(layout);
}

}  // namespace

KeptScales scales_of_solution(const Solution& solution, const SheetOptions& options, const Fonts& fonts) {
    return from_layout(solution, options, fonts, [](Layout& layout) { return layout.scales(); });
}

DrawnSheet draw_solution(const Solution& solution, const SheetOptions& options, const Fonts& fonts) {
    return from_layout(solution, options, fonts, [](Layout& layout) { return layout.drawn(); });
}

std::vector<Page> lay_out(const Solution& solution, const SheetOptions& options, const Fonts& fonts) {
    if (stands_for_joints(solution.mechanism)) return lay_out_problem(solution, options, fonts);
    if (options.kind != SheetKind::solution) return lay_out_handout(solution, options, fonts);
    return with_contacts(solution, options, fonts, lay_out_problem, [&](const SheetOptions& numbered) {
        DrawnSheet sheet = draw_solution(solution, numbered, fonts);
        return BoundPages{std::move(sheet.pages), static_cast<int>(sheet.figures.size())};
    });
}

}  // namespace kinegraph::render
