// The sheet: figures, equations, tables and steps on pages, nothing overlapping, nothing cut. Owns what is drawn where; knows no
// mechanics, and takes every figure as it comes: it is moved, never scaled.
//
// Method: a solution is a sequence of bands, each a question with its figures and its text (bands). A band stands in a room as it
// is worth most (band_layout); bands in their order make rows, rows make the fewest pages (page_plan). Only then are the figures
// drawn, each once, into the rooms that are theirs; what they leave is shared out between the rows.
#include "render/sheet/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "engine/assert.hpp"
#include "engine/problem.hpp"
#include "render/figures/caption.hpp"
#include "render/figures/polygon_parts.hpp"
#include "render/page/shapes.hpp"
#include "render/sheet/beside.hpp"
#include "render/sheet/contact_pages.hpp"
#include "render/sheet/drawn_sheet.hpp"
#include "render/sheet/handout.hpp"
#include "render/sheet/page_plan.hpp"
#include "render/sheet/problem_sheet.hpp"
#include "render/sheet/title_block.hpp"

namespace kinegraph::render {
namespace {

constexpr double text_gap = 4;  // between figures and the text under them
constexpr double grace = 0.05;

class Layout {
public:
    Layout(const Solution& solution, const SheetOptions& options, const Fonts& fonts)
        : context_{solution, options.theme, fonts, options.language, options.dimensions},
          format_(format_of(options.paper, options.orientation)),
          signature_{options.author, options.date},
          after_(options.pages_after),
          wanted_(context_, options.joukowsky, options.detail),
          bands_(context_, wanted_, options.detail),
          texts_(bands_, bands_.results(), format_) {}

    DrawnSheet drawn() && {
        DrawnSheet sheet{pages(), {}, first_caption_, first_caption_width_};
        std::map<int, Figure*> by_number;
        for (auto& [band, figures] : drawn_)
            for (Drawn& each : figures) by_number[each.number] = &each.figure;
        for (const auto& [number, figure] : by_number) sheet.figures.push_back(std::move(*figure));
        return sheet;
    }

private:
    std::vector<Page> pages() {
        // From then on no figure refuses its room; one that its whole page cannot hold stays as it is.
        constexpr int most_rounds = 12;
        for (int round = 1;; ++round) {
            const std::size_t pages_before = plan_.size();
            takes_what_comes_ = round >= most_rounds;
            plan();
            if (pages_before > 0 && plan_.size() > pages_before) take_back(pages_before);
            refused_.clear();
            draw();
            const bool lacks_equations = corner_missing_;  // they found no corner, and stand in the text from now on
            const bool may_go_on = round < 2 * most_rounds || lacks_equations;
            if (!takes_what_comes_ && drawn_otherwise()) continue;
            draw_what_fills_its_room();
            if (may_go_on && drawn_otherwise()) continue;
            if (may_go_on && !takes_what_comes_ && takes_less_than_thought()) continue;
            if (!may_go_on || !has_wider_tables()) break;
        }
        enrich_figures();
        std::vector<Page> pages;
        for (std::size_t p = 0; p < plan_.size(); ++p) pages.push_back(page(p));
        return pages;
    }

    /// A figure as drawn, and the room it was drawn for (from the band's upper left corner).
    struct Drawn {
        std::size_t wanted = 0;
        Box room;
        int number = 0;
        double promised = 0;  // the scale that the room was planned for
        double caption = 0;   // mm that it takes
        bool waits = false;   // for all others: it fills its room, whatever that is
        Figure figure;
        Spot size{};                 // of the figure alone
        std::vector<Mark> beside{};  // equations in its corner
        double height() const { return caption + figure.box.height(); }
        bool is_refused() const { return figure.scale == any_scale; }  ///< the room, by the figure
    };

    // --- the plan
    // ----------------------------------------------------------------------------------------------------------------

    /// The text of what no page holds goes on over pages; where that alone does not help the figures are shown smaller.
    void plan() {
        const bool looks_again = std::exchange(looks_again_, false);
        if (wanted_.keeps_force_scale && !looks_again && plans_at_same_force_scale()) return;
        wanted_.force_scale = least_force_scale_;
        wanted_.keeps_force_scale = false;
        plan_all();
        if (plan_.empty()) {
            give_each_a_page();
            return plan();
        }
        share_force_scale();
    }
    /// Whether force polygons have room at their common scale on as few pages as before.
    bool plans_at_same_force_scale() {
        const std::size_t pages = plan_.size();
        plan_all();
        return !plan_.empty() && plan_.size() <= pages;
    }
    void plan_all() {
        std::vector<BandLayouts> before = std::move(layouts_);
        layouts_.clear();
        for (std::size_t b = 0; b < bands_.list.size(); ++b) {
            BandLayouts layouts = layouts_of(bands_.list[b]);
            const bool same = b < before.size() && before[b].is_like(layouts);
            layouts_.push_back(std::move(same ? before[b] : layouts));
        }
        plan_ = plan_pages(layouts_, bands_.list, format_);
    }
    void give_each_a_page() {
        layouts_.clear();
        rejoin();
        for (std::size_t b = 0; b < bands_.list.size(); ++b)
            while (worth_of(b, bands_.list[b].end_row) < BandLayout::possible)
                if (const std::size_t rows = rows_for_a_page(b); rows > 0)
                    divide(b, rows);
                else if (!crowded_.insert(bands_.list[b].question).second)
                    part_figures(b);
    }
    /// Of a band with a page to itself, its text only up to a row.
    double worth_of(std::size_t index, std::size_t end_row) {
        Band band = bands_.list[index];
        band.end_row = end_row;
        return worth_of_a_page(layouts_of(band), format_, index == 0);
    }
    /// How many of its rows a page holds with its figures about as large as without; 0: not even the fewest.
    std::size_t rows_for_a_page(std::size_t index) {
        constexpr std::size_t fewest = 2;
        constexpr double one_step = 0.7;  // of the scale
        const Band& band = bands_.list[index];
        const std::size_t all = texts_.rows(band);
        const auto worth = [&](std::size_t rows) { return worth_of(index, band.first_row + rows); };
        const double best = all < fewest ? BandLayout::impossible : worth(fewest);
        if (best < BandLayout::possible) return 0;
        const auto is_good = [&](std::size_t rows) {
            return worth(rows) > (band.figures.empty() ? BandLayout::possible : best - one_step);
        };
        std::size_t good = fewest, bad = 2 * fewest;
        for (; bad < all && is_good(bad); bad *= 2) good = bad;
        for (bad = std::min(bad, all); bad - good > 1;) {
            const std::size_t middle = (good + bad) / 2;
            (is_good(middle) ? good : bad) = middle;
        }
        return std::min(good, all - 1);
    }
    BandLayouts layouts_of(const Band& band) {
        return {texts_,
                band,
                wanted_,
                format_,
                crowded_.contains(band.question),
                !cornerless_.contains(band.question),
                !wide_.contains(band.question)};
    }
    /// What a figure or the common scale of forces would want a page more for, they do without.
    void take_back(std::size_t pages_before) {
        looks_again_ = true;
        if (std::exchange(seeks_finest_force_scale_, false)) plan();
        if (!refused_.empty() && plan_.size() > pages_before) take_back_refusals();
    }
    /// A figure that would want a page more for its letters takes the room that it had, as it comes.
    void take_back_refusals() {
        for (const Refusal& refusal : refused_) {
            Wanted& wanted = wanted_.list[refusal.wanted];
            // A coarser scale of one force polygon would be that of all.
            if (wanted.to_force_scale) continue;
            wanted.rim_x = refusal.rim_x;
            wanted.rim_y = refusal.rim_y;
            refusals_[wanted.name] = most_refusals;
        }
        plan();
    }
    /// So many rows stay with the figures of a band; the rest goes on.
    void divide(std::size_t index, std::size_t rows) {
        Band& band = bands_.list[index];
        Band rest = band;
        rest.figures.clear();
        rest.draws_mechanism = false;
        band.end_row = rest.first_row = band.first_row + rows;
        bands_.list.insert(bands_.list.begin() + static_cast<std::ptrdiff_t>(index) + 1, std::move(rest));
    }
    /// What was divided for figures of other sizes is one band again.
    void rejoin() {
        std::vector<Band> whole;
        for (Band& band : bands_.list)
            if (!whole.empty() && band.figures.empty() && band.question == whole.back().question &&
                band.first_row == whole.back().end_row)
                whole.back().end_row = band.end_row;
            else
                whole.push_back(std::move(band));
        bands_.list = std::move(whole);
    }
    /// Half of its figures go on without text.
    void part_figures(std::size_t index) {
        Band& band = bands_.list[index];
        KG_ASSERT(band.figures.size() > 1, "a page holds a figure with a row of its text");
        Band rest = band;
        const auto half = static_cast<std::ptrdiff_t>((band.figures.size() + 1) / 2);
        rest.figures.assign(band.figures.begin() + half, band.figures.end());
        rest.parts.clear();
        rest.first_row = rest.end_row = 0;
        rest.draws_mechanism = false;
        band.figures.resize(static_cast<std::size_t>(half));
        bands_.list.insert(bands_.list.begin() + static_cast<std::ptrdiff_t>(index) + 1, std::move(rest));
    }

    /// Triangles and closed polygon have one scale: the finest at which all of them have room on as few pages.
    void share_force_scale() {
        double coarsest = 0, finest = least_force_scale_.value_or(0);
        for_each_figure([&](const PlacedBand& placed, std::size_t f, const BandLayout& layout) {
            if (wanted_.list[bands_.list[placed.band].figures[f]].to_force_scale)
                coarsest = std::max(coarsest, layouts_[placed.band].scale_in(f, layout.rooms[f]));
        });
        for (const Wanted& each : wanted_.list) {
            if (!each.to_force_scale) continue;
            if (each.asked) return;
            finest = std::max(finest, choose_scale(each.extent_x, each.extent_y, each.enough, each.enough, std::nullopt));
        }
        if (!(coarsest > 0)) return;
        constexpr double rounding = 1e-9;
        const std::size_t pages = plan_.size();
        wanted_.keeps_force_scale = true;
        if (seeks_finest_force_scale_)
            for (double scale = finest; scale < coarsest * (1 + rounding); scale = next_scale(scale)) {
                wanted_.force_scale = scale;
                plan_all();
                if (!plan_.empty() && plan_.size() <= pages) return;
            }
        wanted_.force_scale = coarsest;
        wanted_.keeps_force_scale = false;
        plan_all();
    }
    template <class Look>
    void for_each_figure(Look look) {
        for (const PlannedPage& page : plan_)
            for (const PlannedRow& row : page)
                for (const PlannedCell& cell : row)
                    for (const PlacedBand& placed : cell) {
                        const BandLayout layout = layout_of(placed);
                        for (std::size_t f = 0; f < layout.rooms.size(); ++f)
                            if (layout.rooms[f].x > 0) look(placed, f, layout);
                    }
    }

    // --- the figures
    // -------------------------------------------------------------------------------------------------------------

    void draw() {
        drawn_.clear();
        spared_ = 0;
        int number = 0;
        Spot corner;
        for_each_figure([&](const PlacedBand& placed, std::size_t f, const BandLayout& layout) {
            if (f == 0) corner = {0, 0};
            const Spot size = layout.rooms[f];
            const double wider = layout.cornered ? layouts_[placed.band].wider_in(size) : 0;
            const std::size_t index = bands_.list[placed.band].figures[f];
            const Spot own{size.x - wider, size.y};
            Drawn& drawn = drawn_[placed.band].emplace_back();
            drawn.wanted = index;
            drawn.number = ++number;
            drawn.room = rectangle(corner.x, corner.y, corner.x + size.x, corner.y + size.y);
            drawn.promised = layouts_[placed.band].scale_in(f, own);
            drawn.waits = wanted_.list[index].fills;
            if (!drawn.waits) draw_into(drawn, own, coarsest_scale(placed.band, f, own));
            if (!drawn.waits && !drawn.is_refused()) learn_from(drawn);
            (layout.stacked ? corner.y : corner.x) += (layout.stacked ? size.y : size.x) + gap;
            if (layout.cornered && !drawn.is_refused()) set_in_corner(drawn, placed.band);
        });
        for (auto& [band, figures] : drawn_) share_room(figures);
    }
    /// Once the rooms are those that all others are content with; then the letters of details are known.
    void draw_what_fills_its_room() {
        std::map<int, Drawn*> in_order;
        for (auto& [band, figures] : drawn_)
            for (Drawn& drawn : figures) in_order[drawn.number] = &drawn;
        std::size_t details = 0;
        for (const auto& [number, drawn] : in_order) {
            if (std::exchange(drawn->waits, false)) draw_into(*drawn, {drawn->room.width(), drawn->room.height()}, any_scale);
            letter_details_on(drawn->figure, context_, details);
            details += drawn->figure.details.size();
        }
        for (auto& [band, figures] : drawn_) share_room(figures);
    }
    /// With what else has room in the rooms that they have.
    void enrich_figures() {
        for (auto& [band, figures] : drawn_)
            for (Drawn& drawn : figures) {
                const Wanted& wanted = wanted_.list[drawn.wanted];
                if (!wanted.enrich) continue;
                const Spot room{drawn.room.width(), drawn.room.height() - drawn.caption};
                if (Figure more = wanted.enrich(drawn.figure, room); more.scale != any_scale) drawn.figure = std::move(more);
            }
    }
    /// What one figure of a band leaves of its room is for another that takes more than its own.
    void share_room(std::vector<Drawn>& figures) {
        const auto is_open = [](const Drawn& drawn) { return drawn.waits || drawn.is_refused(); };
        if (figures.size() < 2 || std::any_of(figures.begin(), figures.end(), is_open)) return;
        const bool stacked = figures.back().room.min.y > figures.front().room.min.y;
        const auto across = [&](const Drawn& drawn) {
            return stacked ? drawn.size.x <= drawn.room.width() : drawn.height() <= drawn.room.height();
        };
        const auto along = [&](const Drawn& drawn) { return stacked ? drawn.height() : drawn.figure.box.width(); };
        const auto own = [&](const Drawn& drawn) { return stacked ? drawn.room.height() : drawn.room.width(); };
        double left = 0;
        bool outgrown = false;
        for (const Drawn& drawn : figures) {
            left += own(drawn) - along(drawn);
            outgrown = outgrown || along(drawn) > own(drawn);
        }
        if (!outgrown || left < 0 || !std::all_of(figures.begin(), figures.end(), across)) return;
        double at = stacked ? figures.front().room.min.y : figures.front().room.min.x;
        for (Drawn& drawn : figures) {
            const double end = at + along(drawn) + left / static_cast<double>(figures.size());
            (stacked ? drawn.room.min.y : drawn.room.min.x) = at;
            (stacked ? drawn.room.max.y : drawn.room.max.x) = end;
            drawn.caption = height_of_caption(drawn);
            at = end + gap;
        }
    }
    /// The equations into a corner of the room that the figure leaves free.
    void set_in_corner(Drawn& drawn, std::size_t band) {
        const Box room = rectangle(0, 0, drawn.room.width(), drawn.room.height() - drawn.caption);
        if (set_beside(drawn.beside, drawn.figure, layouts_[band].equations(), room)) {
            drawn.figure.box.include(box_of(drawn.beside));
        } else {
            cornerless_.insert(bands_.list[band].question);
            corner_missing_ = true;
        }
    }
    /// Whether a larger room than it was drawn for lets a figure be no larger, and it lacks nothing.
    static bool gains_nothing(const Wanted& wanted, const Figure& drawn, Spot room) {
        constexpr double rounding = 1e-9;
        if (wanted.empty || wanted.asked || drawn.lacks_details || drawn.has_key) return false;
        const double finest = choose_scale(wanted.extent_x, wanted.extent_y, room.x, room.y, std::nullopt);
        return finest >= drawn.scale * (1 - rounding);
    }
    /// For a figure that fills its room.
    static bool is_hardly_other(Spot known, Spot room) {
        constexpr double hardly = 1.2;
        const double x = room.x / known.x, y = room.y / known.y;
        return std::max(x, 1 / x) <= hardly && std::max(y, 1 / y) <= hardly;
    }
    /// Drawn once for all rooms between the one it was drawn for and what it takes: its scale is the finest that fits. A room
    /// that holds it only smaller than at `coarsest` is refused, which costs less than to letter it there: the figure is empty
    /// then and at any_scale.
    const Figure& figure_in(std::size_t index, Spot room, double coarsest) {
        constexpr double rounding = 1e-6;
        const Wanted& wanted = wanted_.list[index];
        const std::optional<double> force_scale = wanted.to_force_scale ? wanted_.force_scale : std::nullopt;
        std::vector<Known>& known = known_[index];
        for (const Known& each : known) {
            if (each.force_scale != force_scale) continue;
            const bool larger = room.x > each.room.x + rounding || room.y > each.room.y + rounding;
            if (each.refused_at) {
                if (!larger && coarsest <= *each.refused_at) return each.figure;
                continue;
            }
            const bool same = !larger && room.x > each.room.x - rounding && room.y > each.room.y - rounding;
            const Box& box = each.figure.box;
            const bool fits = box.width() <= room.x + rounding && box.height() <= room.y + rounding;
            const bool as_large =
                wanted.fills ? is_hardly_other(each.room, room) : !larger || gains_nothing(wanted, each.figure, room);
            if (same || (fits && as_large)) return each.figure;
        }
        Known drawn{room, force_scale, {}, {}};
        if (coarsest < any_scale) {
            drawn.figure = wanted.draw_or_refuse(room, coarsest);
            if (drawn.figure.scale == any_scale) drawn.refused_at = coarsest;
        } else {
            drawn.figure = wanted.draw(room.x, room.y);
        }
        return known.emplace_back(std::move(drawn)).figure;
    }
    /// The coarsest scale at which a figure takes its room: what this promises, a few times; any_scale: it is drawn as it comes.
    double coarsest_scale(std::size_t band, std::size_t f, Spot room) {
        const std::size_t index = bands_.list[band].figures[f];
        const Wanted& wanted = wanted_.list[index];
        if (takes_what_comes_ || !wanted.draw_or_refuse || refusals_[wanted.name] >= most_refusals) return any_scale;
        constexpr double rounding = 1e-9;
        return layouts_[band].scale_in(f, room) * (1 + rounding);
    }
    void draw_into(Drawn& drawn, Spot room, double coarsest) {
        constexpr double one_line = 7;
        constexpr double least_room = 10;
        const auto below = [&](double taken) { return Spot{std::max(room.x, least_room), std::max(room.y - taken, least_room)}; };
        drawn.figure = figure_in(drawn.wanted, below(one_line), coarsest);
        drawn.size = {drawn.figure.box.width(), drawn.figure.box.height()};
        if (drawn.is_refused()) return;
        drawn.caption = height_of_caption(drawn);
        if (drawn.caption > one_line && drawn.height() > room.y)
            drawn.figure = figure_in(drawn.wanted, below(drawn.caption), coarsest);
        drawn.size = {drawn.figure.box.width(), drawn.figure.box.height()};
    }

    double height_of_caption(const Drawn& drawn) const {
        std::vector<Mark> words;
        return set_caption(words, context_, drawn.figure, drawn.number, {0, 0}, drawn.room.width());
    }

    bool is_coarser_than_promised(const Drawn& drawn) const {
        const Wanted& wanted = wanted_.list[drawn.wanted];
        constexpr double rounding = 1e-6;
        return !wanted.empty && !wanted.fills && !wanted.spare && !wanted.asked &&
               drawn.figure.scale > drawn.promised * (1 + rounding);
    }
    /// … and is given more room for it: a few times, then it is taken as it comes.
    bool asks_for_more_room(const Drawn& drawn) {
        return is_coarser_than_promised(drawn) && refusals_[wanted_.list[drawn.wanted].name] < most_refusals;
    }
    /// Whether letters take so much less than was set aside for them that another plan may do with less paper; a few times.
    bool takes_less_than_thought() {
        constexpr int most_times = 2;
        constexpr double worth_another_plan = 3;
        return looks_again_ = ++times_less_ <= most_times && spared_ > worth_another_plan;
    }
    /// Whether a table has outgrown its narrow column with the letters of details, which only the drawn figures have.
    bool has_wider_tables() {
        measured_texts_.reset();
        std::size_t found = 0;
        for (const PlannedPage& page : plan_)
            for (const PlannedRow& row : page)
                for (const PlannedCell& cell : row)
                    for (const PlacedBand& placed : cell) {
                        const Band& band = bands_.list[placed.band];
                        const BandLayout layout = layout_of(placed);
                        if (layout.divided > format_.columns && text_of(band, layout).is_too_wide())
                            found += wide_.insert(band.question).second ? 1 : 0;
                    }
        return looks_again_ = found > 0;
    }
    /// What a figure takes at the scale that it was drawn at is known from then on.
    void learn_from(const Drawn& drawn) {
        Wanted& wanted = wanted_.list[drawn.wanted];
        if (wanted.empty || wanted.fills || wanted.spare || wanted.asked) return;
        constexpr double air = 0.5, one_line = 7;
        const Spot taken{drawn.size.x + air, drawn.size.y + drawn.caption - one_line + air};
        const Spot guess = wanted.strokes_at(drawn.figure.scale) + Spot{wanted.rim_x, wanted.rim_y};
        const auto [known, fresh] = wanted.taken.try_emplace(drawn.figure.scale, taken);
        if (fresh) spared_ = std::max({spared_, guess.x - taken.x, guess.y - taken.y});
        // In a room of another shape it may take more; were it to take less again, plans would not settle.
        known->second = {std::max(known->second.x, taken.x), std::max(known->second.y, taken.y)};
    }

    /// For what its letters took at a coarser scale; what is not known, is tried.
    static void give_more_room(Wanted& wanted, const Drawn& drawn) {
        constexpr double more = 6, one_line = 7;
        if (drawn.is_refused()) {
            (drawn.room.width() > drawn.room.height() ? wanted.rim_y : wanted.rim_x) += more;
            return;
        }
        const Spot strokes = wanted.strokes_at(drawn.figure.scale);
        const double rim_x = drawn.size.x - strokes.x;
        const double rim_y = drawn.size.y - strokes.y + drawn.caption - one_line;
        const bool is_known = rim_x > wanted.rim_x || rim_y > wanted.rim_y;
        wanted.rim_x = is_known ? std::max(wanted.rim_x, rim_x + 1) : wanted.rim_x + more;
        wanted.rim_y = is_known ? std::max(wanted.rim_y, rim_y + 1) : wanted.rim_y + more;
    }

    /// What it took at the promised scale in another room is not enough in one of this shape.
    void wants_more_than_its_room(const Drawn& drawn) {
        auto& taken = wanted_.list[drawn.wanted].taken;
        const auto known = taken.find(drawn.promised);
        if (known == taken.end()) return;
        constexpr double more = 3, one_line = 7;
        known->second = {std::max(known->second.x, drawn.room.width() + more),
                         std::max(known->second.y, drawn.room.height() - one_line + more)};
    }
    /// Whether a figure takes more than its room. It is known now what its letters take; where it refused, that they take more.
    bool has_outgrown(const Drawn& drawn) {
        if (drawn.is_refused() || is_coarser_than_promised(drawn)) wants_more_than_its_room(drawn);
        if (drawn.is_refused() || asks_for_more_room(drawn)) {
            Wanted& wanted = wanted_.list[drawn.wanted];
            refused_.push_back({drawn.wanted, wanted.rim_x, wanted.rim_y});
            ++refusals_[wanted.name];
            give_more_room(wanted, drawn);
            return true;
        }
        const Box& box = drawn.figure.box;
        const double over_x = box.width() - drawn.room.width(), over_y = drawn.height() - drawn.room.height();
        constexpr double ink = 0.25;  // of rules at the rim
        if (over_x < ink && over_y < ink) return false;
        Wanted& wanted = wanted_.list[drawn.wanted];
        if (wanted.fills) {
            constexpr double one_line = 7;
            wanted.least_room = {std::max(wanted.least_room.x, box.width()),
                                 std::max(wanted.least_room.y, drawn.height() - one_line)};
        } else {
            wanted.rim_x += std::max(over_x, 0.0);
            wanted.rim_y += std::max(over_y, 0.0);
            learn_from(drawn);  // its caption may have more lines by now
        }
        return true;
    }
    /// The words with what they are followed by, as a remark on a figure; false where it is made already.
    bool remark(const Drawn& drawn, const char* words, const std::vector<RichText>& followed_by) {
        constexpr std::size_t most_listed = 12;
        RichText text = drawn.figure.caption;
        append(text, one_piece(": " + word(words, context_.language)));
        for (std::size_t i = 0; i < std::min(followed_by.size(), most_listed); ++i) {
            append(text, one_piece(i > 0 ? ", " : " "));
            append(text, followed_by[i]);
        }
        if (followed_by.size() > most_listed) append(text, one_piece(" … (" + std::to_string(followed_by.size()) + ")"));
        if (!bands_.remark(wanted_.list[drawn.wanted].name + words, text)) return false;
        texts_.forget("remarks");
        return true;
    }
    /// Whether something came otherwise than planned, so that it is planned anew: a force polygon smaller than the others, a
    /// figure that has no room at the scale which the file asks for, or none in its room.
    bool drawn_otherwise() {
        bool otherwise = std::exchange(corner_missing_, false);
        double least = 1e300, most = 0;
        for (const auto& [band, figures] : drawn_)
            for (const Drawn& drawn : figures) {
                if (drawn.waits) continue;
                if (drawn.is_refused()) {
                    otherwise = has_outgrown(drawn);
                    continue;
                }
                Wanted& wanted = wanted_.list[drawn.wanted];
                const bool misses = wanted.asked && !wanted.empty && !wanted.fills && !wanted.spare &&
                                    std::abs(drawn.figure.scale - *wanted.asked) > 1e-9 * drawn.figure.scale;
                const bool tries_again = misses && roomier_.insert(wanted.name).second;
                if (wanted.to_force_scale && !tries_again && !asks_for_more_room(drawn)) {
                    least = std::min(least, drawn.figure.scale);
                    most = std::max(most, drawn.figure.scale);
                }
                constexpr double more = 16;
                if (tries_again) {
                    wanted.rim_x += more;
                    wanted.rim_y += more;
                    otherwise = true;
                } else if (misses)
                    otherwise = remark(drawn, "scale refused", {}) || otherwise;
                if (const std::vector<RichText>& left_out = drawn.figure.unnamed; !left_out.empty())
                    otherwise = remark(drawn, "names left out", left_out) || otherwise;
                otherwise = has_outgrown(drawn) || otherwise;
            }
        if (most > least * (1 + 1e-9)) {
            least_force_scale_ = most;
            looks_again_ = true;
            otherwise = true;
        }
        return otherwise;
    }

    // --- the page
    // ----------------------------------------------------------------------------------------------------------------

    double height_of(const PlannedCell& cell) const {
        double height = -row_gap;
        for (const PlacedBand& placed : cell) height += row_gap + height_of(placed, true);
        return height;
    }
    /// What a band takes of its room once it is drawn; `whole`: with what the title block takes.
    double height_of(const PlacedBand& placed, bool whole) const {
        const BandLayout layout = layout_of(placed);
        double figures = 0, right = 0;
        if (const auto drawn = drawn_.find(placed.band); drawn != drawn_.end())
            for (const Drawn& each : drawn->second) {
                figures = layout.stacked ? figures + (figures > 0 ? gap : 0) + each.height() : std::max(figures, each.height());
                right = std::max(right, each.room.max.x);
            }
        if (layout.under > 0) return height_round(placed, layout, figures, right, whole);
        const double text =
            layout.divided == 0 ? 0 : layouts_[placed.band].text(layout.divided, layout.cornered).height(layout.columns);
        const double notch = whole ? placed.notch.high : 0;
        if (!layout.beside) return figures + (figures > 0 && text > 0 ? text_gap : 0) + text + notch;
        return std::max(figures + (right > placed.notch.left + grace ? notch : 0), text + notch);
    }

    /// … of one whose text stands under and beside its figures.
    double height_round(const PlacedBand& placed, const BandLayout& layout, double figures, double right, bool whole) const {
        const ColumnText& text = layouts_[placed.band].text(layout.divided, layout.cornered);
        const Notch notch = whole ? placed.notch : Notch{};
        const double words = text.height(layout.text_columns(placed.room.width(), text.measure(), figures, notch));
        return std::max(figures + (notch.high > 0 && right > notch.left + grace ? notch.high : 0), words);
    }

    Page page(std::size_t index) {
        std::vector<Mark> marks;
        std::optional<double> scale_of_mechanism;
        const PlannedPage& rows = plan_[index];
        const Box content = content_of(format_, index == 0);
        std::vector<double> heights;
        double spare = content.height();
        for (const PlannedRow& row : rows) {
            double height = 0;
            for (const PlannedCell& cell : row) height = std::max(height, height_of(cell));
            heights.push_back(height);
            spare -= height + (heights.size() > 1 ? row_gap : 0);
        }
        // A little of what is left loosens the rows.
        constexpr double most_air = 6;
        const double air = std::clamp(spare / static_cast<double>(rows.size()), 0.0, most_air);
        double y = content.min.y;
        for (std::size_t r = 0; r < rows.size(); ++r) {
            for (const PlannedCell& cell : rows[r]) {
                double down = y;
                for (const PlacedBand& placed : cell) {
                    set_band(marks, scale_of_mechanism, placed, {placed.room.min.x, down});
                    down += height_of(placed, false) + row_gap + std::min(air, (heights[r] - height_of(cell)) / 2);
                }
            }
            y += heights[r] + row_gap + air;
        }
        return framed_page(context_, format_, signature_, std::move(marks), scale_of_mechanism, index + 1, plan_.size() + after_,
                           index == 0);
    }
    BandLayout layout_of(const PlacedBand& placed) const {
        return layouts_[placed.band].in(placed.width, placed.room.height(), placed.notch);
    }

    void set_band(std::vector<Mark>& marks, std::optional<double>& scale_of_mechanism, const PlacedBand& placed, Spot at) {
        const BandLayout layout = layout_of(placed);
        const Band& band = bands_.list[placed.band];
        marks.emplace_back(GroupBegin{"band", "", "", {{"data-question", band.question}}});
        std::vector<Drawn>& figures = drawn_[placed.band];
        double down = 0, below = 0;
        for (Drawn& drawn : figures) {
            const Spot corner{at.x + drawn.room.min.x, at.y + (layout.stacked ? down : 0)};
            set_caption(marks, context_, drawn.figure, drawn.number, corner, drawn.room.width());
            if (drawn.number == 1) first_caption_ = corner, first_caption_width_ = drawn.room.width();
            const Box& box = drawn.figure.box;
            const Spot by{corner.x - box.min.x + 0.5 * (drawn.room.width() - box.width()), corner.y + drawn.caption - box.min.y};
            drawn.figure.move(by.x, by.y);
            marks.insert(marks.end(), drawn.figure.marks.begin(), drawn.figure.marks.end());
            render::move(drawn.beside, by.x, by.y);
            marks.insert(marks.end(), drawn.beside.begin(), drawn.beside.end());
            if (drawn.figure.kind == "mechanism" && !scale_of_mechanism) scale_of_mechanism = drawn.figure.scale;
            down += drawn.height() + gap;
            below = layout.stacked ? down - gap : std::max(below, drawn.height());
        }
        if (layout.under > 0) {
            const ColumnText& planned = layouts_[placed.band].text(layout.divided, layout.cornered);
            text_of(band, layout)
                .set(marks, at, layout.text_columns(placed.room.width(), planned.measure(), below, placed.notch));
        } else if (layout.divided > 0) {
            const ColumnText& planned = layouts_[placed.band].text(layout.divided, layout.cornered);
            const double width = layout.columns * (planned.measure() + gap) - gap;
            const Spot corner = layout.beside ? Spot{placed.room.max.x - width, at.y}
                                              : Spot{at.x, at.y + below + (figures.empty() ? 0 : text_gap)};
            text_of(band, layout).set(marks, corner, layout.columns, gap);
        }
        marks.emplace_back(GroupEnd{});
    }
    /// With the lengths that are measured on the figures as drawn.
    const ColumnText& text_of(const Band& band, const BandLayout& layout) {
        if (!measured_texts_) {
            std::vector<Figure> all;
            for (const auto& [index, figures] : drawn_)
                for (const Drawn& drawn : figures) all.push_back(drawn.figure);
            results_ = bands_.results_on(all);
            measured_texts_.emplace(bands_, results_, format_, &texts_);
        }
        return measured_texts_->of(band, layout.divided, layout.cornered);
    }

    DrawingContext context_;
    SheetFormat format_;
    Signature signature_;
    std::size_t after_;  // pages bound with these
    WantedFigures wanted_;
    Bands bands_;
    BandTexts texts_;
    static constexpr int most_refusals = 3;
    /// Of a room in the last round, by a figure, and its rim there.
    struct Refusal {
        std::size_t wanted = 0;
        double rim_x = 0, rim_y = 0;
    };
    std::vector<Refusal> refused_;
    /// A drawing that was tried, and for which room.
    struct Known {
        Spot room;
        std::optional<double> force_scale;
        Figure figure;
        std::optional<double> refused_at;  // the scale that it had no room for
    };
    std::map<std::size_t, std::vector<Known>> known_;  // by figure
    std::map<std::string, int> refusals_;              // … by its name
    std::set<std::string> crowded_;                    // bands whose figures may be smaller than is well readable
    std::set<std::string> cornerless_;                 // … whose figure leaves their equations no corner
    std::set<std::string> wide_;                       // … whose tables are too wide for narrow columns
    std::set<std::string> roomier_;                    // figures that got more room for the scale asked for
    std::vector<BandLayouts> layouts_;
    std::vector<PlannedPage> plan_;
    std::map<std::size_t, std::vector<Drawn>> drawn_;  // by band
    std::vector<ResultRow> results_;                   // measured on them
    std::optional<BandTexts> measured_texts_;          // with these
    Spot first_caption_;                               // of figure 1: its corner, and the room it has
    double first_caption_width_ = 0;
    bool corner_missing_ = false;  // one was promised to equations
    bool seeks_finest_force_scale_ = true;
    bool looks_again_ = false;                 // for another force scale
    std::optional<double> least_force_scale_;  // at which all force polygons that were drawn had room
    bool takes_what_comes_ = false;            // the last round: no figure refuses its room
    double spared_ = 0;                        // mm, of a room as it was planned in the last round
    int times_less_ = 0;                       // plans anew because letters took less than was thought
};

}  // namespace

DrawnSheet draw_solution(const Solution& solution, const SheetOptions& options, const Fonts& fonts) {
    return Layout(solution, options, fonts).drawn();
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
