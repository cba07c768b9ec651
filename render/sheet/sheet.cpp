// The sheet: figures, equations, tables and steps on pages, without overlaps. Owns the sequence of planning and
// drawing. Computes no mechanics; figures are moved, never scaled.
//
// Method: a solution is a sequence of bands, each a question with its figures and text (bands). A band gets the
// arrangement with the highest score for its space (band_layout). Bands in their order make rows, and rows make the
// fewest pages (page_plan, sheet_plan). Then each figure is drawn once into its room (drawn_figures). The space that
// its labels took is known then (figure_needs) and used in the next plan. When plan and drawings agree, the pages are
// made (sheet_pages).
#include "render/sheet/sheet.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "engine/solution/problem_solution.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/sheet.hpp"
#include "render/layout/drawn_sheet.hpp"
#include "render/layout/sheet_choice.hpp"
#include "render/layout/sheet_pages.hpp"
#include "render/problems/contact_pages.hpp"
#include "render/problems/problem_sheet.hpp"
#include "render/sheet/handout.hpp"

namespace kinegraph::render {
namespace {

class Layout {
public:
    /// `lettering`: factor of the space estimated for labels before a figure is drawn.
    Layout(const Solution& solution, const SheetOptions& options, const Fonts& fonts, double lettering)
        : context_{solution, options.theme, fonts, options.language, options.dimensions},
          format_(format_of(options.paper, options.orientation)),
          signature_{options.author, options.date},
          after_(options.pages_after),
          wanted_(context_, options.joukowsky, options.detail),
          bands_(context_, wanted_, options.detail),
          plan_(wanted_, bands_, format_),
          needs_(wanted_),
          figures_(context_, wanted_, bands_, needs_) {
        for (Wanted& wanted : wanted_.list) wanted.rim_x *= lettering, wanted.rim_y *= lettering;
    }

    bool is_crowded() const { return wanted_.are_crowded(); }

    DrawnSheet drawn() && {
        settle();
        figures_.enrich();
        tell_where_figures_stand();
        SheetPages pages(context_, format_, signature_, {plan_, bands_, figures_, *text_});
        DrawnSheet sheet{
            pages.set(after_), {}, pages.first_caption(), pages.first_caption_width(), figures_.keep_to_rooms()};
        std::map<int, Figure*> by_number;
        for (auto& [band, figures] : figures_.by_band())
            for (DrawnFigure& each : figures) by_number[each.number] = &each.figure;
        for (const auto& [number, figure] : by_number) sheet.figures.push_back(std::move(*figure));
        return sheet;
    }

private:
    /// Plans and draws alternately until every figure fits into its room.
    void settle() {
        // After this many rounds no figure refuses its room, and a figure too large for a whole page stays as it is.
        constexpr int most_rounds = 12;
        for (int round = 1;; ++round) {
            const bool takes_what_comes = round >= most_rounds;
            make_plan();
            needs_.begin_round();
            const bool lacks_equations = !figures_.draw(plan_, !takes_what_comes);  // they are in the text from now on
            const bool may_go_on = round < 2 * most_rounds || lacks_equations;
            if (!takes_what_comes && (drawn_otherwise() || lacks_equations)) continue;
            figures_.draw_what_fills_its_room();
            if (may_go_on && (drawn_otherwise() || lacks_equations)) continue;
            if (may_go_on && !takes_what_comes && (needs_.take_less_than_thought() || takes_a_smaller_room()) &&
                plan_.makes_another())
                continue;
            text_.emplace(bands_, figures_, format_, plan_.texts());
            if (!may_go_on || !has_wider_tables()) return;
        }
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
    /// Makes a plan. If figures or the common scale of forces would add a page, their demands are dropped.
    void make_plan() {
        const std::size_t before = plan_.pages().size();
        plan_.make();
        if (before == 0 || plan_.pages().size() <= before) return;
        plan_.look_again();
        const bool gave_up = plan_.give_up_finest_force_scale();
        const auto has_room = [&] {
            plan_.make();
            return plan_.pages().size() <= before;
        };
        if (gave_up && has_room()) return;
        needs_.take_back_until(has_room);
        if (!gave_up || plan_.pages().size() <= before) return;
        // The additional page is needed in any case, so that a finer scale may be sought again.
        plan_.seek_finest_force_scale();
        plan_.look_again();
        plan_.make();
    }
    /// Whether a figure is planned for a smaller room from now on, because it cannot fill more. One figure at a time:
    /// another one may find the space it lacked.
    bool takes_a_smaller_room() {
        for (const auto& [band, figures] : figures_.by_band())
            for (const DrawnFigure& drawn : figures)
                if (needs_.is_planned_as_it_came(drawn)) return true;
        return false;
    }
    /// Whether a table became too wide for its narrow column with the letters of details, which are known only after
    /// drawing.
    bool has_wider_tables() {
        bool found = false;
        plan_.for_each_band([&](const PlacedBand& placed, const BandLayout& layout) {
            const Band& band = bands_.list[placed.band];
            if (layout.divided > format_.columns && text_->of(band, layout).is_too_wide())
                found = plan_.has_wide_tables(band.question) || found;
        });
        if (found) plan_.look_again();
        return found;
    }
    /// Whether a drawing differs from the plan, so that a new plan is needed: a force polygon is smaller than the
    /// others, a figure has no room at its scale in the file, or has none in its room.
    bool drawn_otherwise() {
        bool otherwise = false;
        std::optional<double> least, most;  // scales of the force polygons
        for (const auto& [band, figures] : figures_.by_band())
            for (const DrawnFigure& drawn : figures) {
                if (drawn.waits) continue;
                if (!drawn.is_refused()) {
                    const bool asks = needs_.misses_its_scale(drawn);
                    const bool tries_again = asks && needs_.gives_room_for_its_scale(drawn);
                    if (wanted_.list[drawn.wanted].to_force_scale && !drawn.has_own_scale && !tries_again &&
                        !needs_.asks_for_more_room(drawn)) {
                        least = std::min(least.value_or(drawn.figure.scale), drawn.figure.scale);
                        most = std::max(most.value_or(drawn.figure.scale), drawn.figure.scale);
                    }
                    otherwise = tries_again || otherwise;
                    if (asks && !tries_again) otherwise = remark(drawn, lang::sheet::scale_refused, {}) || otherwise;
                    if (const std::vector<RichText>& left_out = drawn.figure.unnamed; !left_out.empty())
                        otherwise = remark(drawn, lang::sheet::names_left_out, left_out) || otherwise;
                }
                otherwise = needs_.has_outgrown(drawn) || otherwise;
            }
        constexpr double rounding = 1e-9;
        if (!most || *most <= *least * (1 + rounding)) return otherwise;
        plan_.draw_forces_at(*most);
        return true;
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
        if (!bands_.remark(wanted_.list[drawn.wanted].name + words.name(), text)) return false;
        plan_.texts().forget("remarks");
        return true;
    }

    DrawingContext context_;
    SheetFormat format_;
    Signature signature_;
    std::size_t after_;  // pages bound behind these
    WantedFigures wanted_;
    Bands bands_;
    SheetPlan plan_;
    FigureNeeds needs_;
    DrawnFigures figures_;
    std::optional<DrawnText> text_;  // of the bands, after drawing
};

}  // namespace

DrawnSheet draw_solution(const Solution& solution, const SheetOptions& options, const Fonts& fonts) {
    // The iteration depends on its initial estimate. Try the default first; then larger estimates, which may give
    // larger figures, and smaller ones, which may give fewer or fuller pages.
    constexpr double lettering[] = {1, 1.3, 0.8, 0.6};
    SheetChoice choice(format_of(options.paper, options.orientation).inner);
    for (const double each : lettering) {
        Layout layout(solution, options, fonts, each);
        const bool is_crowded = layout.is_crowded();
        choice.offer(std::move(layout).drawn());
        if (is_crowded || choice.is_settled()) break;
    }
    return std::move(choice).best();
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
