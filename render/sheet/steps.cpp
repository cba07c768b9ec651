// Steps: assigns statements to pages and figures, and selects the marks shown on each page.
#include "render/sheet/steps.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "engine/solution/problem_solution.hpp"
#include "lang/keys/sentences.hpp"
#include "lang/keys/sheet.hpp"
#include "render/content/title_block.hpp"
#include "render/content/wanted_figures.hpp"
#include "render/figures/caption.hpp"
#include "render/figures/figure.hpp"
#include "render/mechanism/sketch.hpp"
#include "render/page/scale.hpp"
#include "render/page/shapes.hpp"
#include "render/problems/contact_pages.hpp"
#include "render/problems/problem_sheet.hpp"
#include "render/scene/load_case.hpp"
#include "render/scene/sentences.hpp"
#include "render/sheet/growth.hpp"
#include "render/sheet/statement_figures.hpp"
#include "render/sheet/statement_of_marks.hpp"
#include "render/sheet/step_prose.hpp"

namespace kinegraph::render {
namespace {

bool inks(const Path& path) { return path.stroked || (path.filled && !path.tinted); }

/// Changes the colour of strokes and letters. Fillings with paper or with a body's tint stay.
struct Recolour {
    Colour colour;
    void operator()(Path& path) const {
        if (path.stroked) path.pen.colour = colour;
        if (path.filled && !path.tinted) path.fill = colour;
    }
    void operator()(TextMark& text) const {
        text.colour = colour;
        for (Path& extra : text.extras) (*this)(extra);
    }
    template <class Other>
    void operator()(const Other& /*unseen*/) const {}
};

/// The statements that draw a figure's strokes and letters, and the names in its labels.
struct Contents {
    std::set<StatementIndex> statements;
    std::vector<std::vector<std::string>> names;  // by label

    explicit Contents(const std::vector<Mark>& marks) {
        Nesting nesting;
        for (const Mark& mark : marks) {
            const StatementIndex statement = nesting.enter(mark);
            const auto* text = std::get_if<TextMark>(&mark);
            const auto* path = std::get_if<Path>(&mark);
            if (statement != none && (text || (path && inks(*path)))) statements.insert(statement);
            if (text && !text->names.empty()) names.push_back(text->names);
        }
    }
    /// Names in `sought` that labels carry, with the other names of the same labels: for a_A = a_A^n a single arrow is
    /// drawn.
    std::set<std::string> found(const std::set<std::string>& sought) const {
        std::set<std::string> found;
        for (const std::vector<std::string>& label : names)
            if (std::any_of(label.begin(), label.end(), [&](const std::string& name) { return sought.contains(name); }))
                found.insert(label.begin(), label.end());
        return found;
    }
};

/// Marks for the lengths that statements measure on the mechanism.
std::vector<Mark> segments_read(const DrawingContext& context, const std::vector<StatementIndex>& statements,
                                const Figure& mechanism) {
    std::vector<Mark> marks;
    const Solution& solution = context.solution;
    if (mechanism.traits.measured != QuantityKind::length || !(mechanism.scale > 0)) return marks;
    const auto spot = [&](PointIndex point) {
        const Vector& at = solution.pose.at(point);
        return mechanism.origin + (1 / mechanism.scale) * Spot{at.x.to_double(), -at.y.to_double()};
    };
    for (const StatementIndex index : statements)
        for (const Argument& argument : solution.protocol.statements[at_index(index)].message.arguments) {
            const auto* segment = std::get_if<kinegraph::Segment>(&argument);
            const auto from = segment ? solution.mechanism.point_named(segment->from) : std::nullopt;
            const auto to = segment ? solution.mechanism.point_named(segment->to) : std::nullopt;
            if (!from || !to) continue;
            const Spot a = spot(*from), b = spot(*to);
            constexpr double pin = 1.8;
            if (length(b - a) < 3 * pin) continue;
            const Spot along = unit(b - a);
            marks.emplace_back(
                line(a + pin * along, b - pin * along, {context.theme.link, context.theme.accent, {}, false}));
        }
    return marks;
}

constexpr double below_caption = 12;  // mm, from the beginning of a caption of one line

/// The rooms of a page: for the figure, for a small one beside or below it, and for what is said.
struct StepRooms {
    Box large, small, prose;
    Box tall_prose;  ///< on a slide without a small figure

    StepRooms(const SheetFormat& format, Orientation orientation) {
        const Box& content = format.content;
        const double bottom = format.block.min.y - above_block;
        if (orientation == Orientation::portrait) {
            const double middle = content.min.y + 0.6 * (bottom - content.min.y);
            large = rectangle(content.min.x, content.min.y, content.max.x, middle);
            small = rectangle(content.min.x, middle + gap, content.min.x + format.measure, bottom);
            prose = rectangle(content.max.x - format.measure, middle + gap, content.max.x, bottom);
        } else {
            const double left = content.max.x - format.measure;
            const double below = content.min.y + 0.42 * (bottom - content.min.y);
            large = rectangle(content.min.x, content.min.y, left - gap, bottom);
            small = rectangle(left, content.min.y, content.max.x, below);
            prose = rectangle(left, below + gap, content.max.x, bottom);
        }
        tall_prose = prose;
        if (format.is_slide) tall_prose.min.y = content.min.y + below_caption;
    }
};

/// The theme of figures and sentences on a slide, which is read from the end of a room: with larger letters and bolder
/// lines. Captions, and small figures, which have no room for larger letters, keep theirs.
Theme on_slide(Theme theme) {
    constexpr double larger = 1.2;
    for (double Theme::*const size : {&Theme::title, &Theme::equation, &Theme::label, &Theme::derived,
                                      &Theme::body_text, &Theme::small, &Theme::vector, &Theme::outline, &Theme::thin})
        theme.*size *= larger;
    return theme;
}

class StepPages {
public:
    StepPages(const Solution& solution, const SheetOptions& options, const Fonts& fonts)
        : format_(format_of(options.paper, options.orientation)),
          theme_(format_.is_slide ? on_slide(options.theme) : options.theme),
          context_{solution, theme_, fonts, options.language, options.dimensions},
          beside_context_{solution, options.theme, fonts, options.language, options.dimensions},
          solution_(solution),
          signature_{options.author, options.date},
          after_(options.pages_after),
          wanted_(context_, false, options.detail, options.superposed),
          shown_by_(solution, wanted_),
          with_sentences_(options.with_sentences),
          growing_(options.growing),
          rooms_(format_, options.orientation),
          prose_(context_, format_, rooms_.prose),
          tall_prose_(context_, format_, rooms_.tall_prose) {
        // A small figure beside another one has space for names only.
        if (options.dimensions == Dimensions::automatic) beside_context_.dimensions = Dimensions::off;
    }

    std::vector<Page> pages() {
        collect();
        growing_ = std::min(growing_, static_cast<int>(most_growing / steps_.size()));
        std::vector<Page> pages;
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            const int pictures = growing_ > 0 && grows(i) ? growing_ : 0;
            for (int k = 1; k <= pictures; ++k) pages.push_back(page(i, static_cast<double>(k) / (pictures + 1)));
            pages.push_back(page(i, 1));
        }
        return pages;
    }
    /// The number of numbered figures.
    int figures() const { return static_cast<int>(large_figures_.size()); }

private:
    /// The content of one page.
    struct Step {
        FigureId figure;  ///< of wanted_, or the mechanism
        Topic section = Topic::unnamed;
        std::vector<StatementIndex> statements;
        std::vector<StepRow> rows;
        double height = 0;
        bool only_pairs = false;  ///< it only names pairs
        bool draws = false;       ///< or marks what is drawn
    };
    /// A complete figure at its position on the pages.
    struct Placed {
        Figure figure;
        std::vector<Mark> caption;
    };

    const Statement& statement(StatementIndex index) const { return statements()[at_index(index)]; }
    const std::vector<Statement>& statements() const { return solution_.protocol.statements; }

    /// In a film of very many steps fewer pictures, or none, show how lines grow.
    static constexpr std::size_t most_growing = 600;

    /// The joined polygons belong to no statement: all of that figure is new.
    static bool is_all_new(const Step& step) { return step.statements.empty(); }
    Grows growth_on(std::size_t page, bool all) const {
        return [this, page, all](StatementIndex statement) {
            return all || (statement != none && at_index(statement) < page_of_.size() &&
                           page_of_[at_index(statement)] == page);
        };
    }
    /// Whether enough is drawn on the page to be seen growing.
    bool grows(std::size_t index) {
        constexpr double least = 5;  // mm
        const Step& step = steps_[index];
        const Grows new_here = growth_on(index, false);
        return length_that_grows(large(step.figure).figure.marks, growth_on(index, is_all_new(step))) +
                   length_that_grows(small(step).marks, new_here) >
               least;
    }

    // --- statements and pages

    void collect() {
        page_of_.assign(statements().size(), 0);
        for (const auto& [statement, figure] : shown_by_.all()) add(statement, figure);
        for (std::size_t s = 0; s < steps_.size(); ++s)
            for (const StatementIndex statement : steps_[s].statements) page_of_[at_index(statement)] = s;
        for (const Wanted& wanted : wanted_.list) {
            if (wanted.id.kind != FigureKind::closed_polygon || is_of_resultant(wanted.id.of)) continue;
            Step joined{wanted.id, Topic::forces, {}, {}, 0, false, true};
            joined.rows.push_back(prose_.paragraph(one_piece(word(lang::sheet::polygons_joined, context_.language))));
            steps_.push_back(std::move(joined));
        }
        if (steps_.empty()) steps_.push_back({{FigureKind::mechanism}, Topic::unnamed, {}, {}, 0, false, true});
    }

    /// A polygon that a statement draws to find a resultant.
    bool is_of_resultant(int polygon) const {
        return std::any_of(solution_.resultants.begin(), solution_.resultants.end(),
                           [&](const Resultant& each) { return each.polygon == polygon; });
    }

    /// A statement that draws or marks something has its own page. Any other one joins the page before it in its
    /// section, or the page after it if it begins the section.
    void add(StatementIndex index, FigureId figure) {
        const Statement& statement = this->statement(index);
        Step step{figure, statement.section, {index}, {}, 0, names_a_pair(statement.message.sentence), false};
        StepProse& prose = prose_on(step);
        StepRows said = prose.rows_of(index);
        step.rows = std::move(said.rows);
        step.height = said.height;
        const double height = step.height;
        const Contents contents(large(figure).figure.marks), beside(small(step).marks);
        step.draws = contents.statements.contains(index) || beside.statements.contains(index) ||
                     !contents.found(names_cited(solution_, {index}, context_.language)).empty();
        // Loads acting alone begin a new sequence.
        const bool begins = statement.message.sentence == lang::sentences::superposition ||
                            statement.message.sentence == lang::sentences::superposition_next;
        if (steps_.empty() || begins || steps_.back().section != step.section ||
            steps_.back().height + height > prose_on(steps_.back()).room()) {
            steps_.push_back(std::move(step));
            return;
        }
        Step& before = steps_.back();
        const bool pairs = before.only_pairs && step.only_pairs && before.figure == figure;
        const bool opens = !before.draws && before.statements.size() < 4;
        if (!pairs && step.draws && !opens) {
            steps_.push_back(std::move(step));
            return;
        }
        if (!before.draws) before.figure = figure;
        before.draws = before.draws || step.draws;
        before.only_pairs = pairs;
        before.height += height;
        before.statements.push_back(index);
        before.rows.insert(before.rows.end(), std::make_move_iterator(step.rows.begin()),
                           std::make_move_iterator(step.rows.end()));
    }

    StepProse& prose_on(const Step& step) { return small(step).marks.empty() ? tall_prose_ : prose_; }

    // --- figures

    /// How much of the height that a figure leaves is above it.
    double share_above() const { return format_.is_slide ? 0.5 : 0.3; }

    /// The scale that the file gives, in units of the figure's per mm.
    std::optional<double> scale_in_file(FigureId id) const {
        const bool is_of_forces = id == FigureId{FigureKind::forces};
        const auto index = wanted_.named(id);
        if (index && !is_of_forces) return wanted_.list[*index].asked;
        auto asked = asked_scale(solution_.mechanism, is_of_forces ? id.kind : FigureKind::mechanism);
        if (asked && is_of_forces) *asked /= solution_.mechanism.units.force.si.to_double();
        return asked;
    }
    Figure draw(FigureId id, const DrawingContext& context, double room_x, double room_y) {
        return draw(id, context, room_x, room_y, scale_in_file(id));
    }
    Figure draw(FigureId id, const DrawingContext& context, double room_x, double room_y, std::optional<double> asked) {
        const ScaleWish wish{0, asked};
        if (id == FigureId{FigureKind::forces}) return force_polygons_figure(context, room_x, room_y, wish, false);
        if (id.kind == FigureKind::omega || id.kind == FigureKind::alpha)
            return mechanism_with_turnings(
                context, id.kind == FigureKind::omega ? Symbol::Letter::omega : Symbol::Letter::alpha, room_x, room_y);
        if (const auto index = wanted_.named(id)) return wanted_.draw(*index, {room_x, room_y}, wish);
        if (solution_.instantaneous_motion) return instantaneous_motion_figure(context, room_x, room_y, wish);
        return mechanism_figure(context, room_x, room_y, false, wish);
    }

    /// On a slide no ruler is laid: there the scale is that of a finer series, at which the figure fills its room best.
    Figure draw_large(FigureId id, double room_x, double room_y) {
        Figure figure = draw(id, context_, room_x, room_y);
        if (!format_.is_slide || !figure.has_scale || !(figure.scale > 0) || scale_in_file(id)) return figure;
        const double larger = std::min(room_x / figure.box.width(), room_y / figure.box.height());
        for (const double scale : scales_between(figure.scale / larger, figure.scale)) {
            Figure filling = draw(id, context_, room_x, room_y, scale);
            const bool shows_as_much =
                plain(filling.caption) == plain(figure.caption) && filling.unnamed.size() <= figure.unnamed.size();
            if (filling.scale == scale && shows_as_much) return filling;
        }
        return figure;
    }

    const Placed& large(FigureId id) {
        const auto [found, fresh] = large_figures_.try_emplace(id);
        Placed& placed = found->second;
        if (!fresh) return placed;
        Box room = rooms_.large;
        room.min.y += below_caption;
        placed.figure = draw_large(id, room.width(), room.height());
        const int number = static_cast<int>(large_figures_.size());
        room.min.y =
            rooms_.large.min.y + std::max(below_caption, set_caption(placed.caption, beside_context_, placed.figure,
                                                                     number, rooms_.large.min, rooms_.large.width()));
        const Box box = placed.figure.box;
        placed.figure.move(room.min.x - box.min.x + 0.5 * (room.width() - box.width()),
                           room.min.y - box.min.y + share_above() * std::max(0.0, room.height() - box.height()));
        return placed;
    }

    /// The small figure beside a figure: the mechanism with angular velocities or lines of action; beside the mechanism
    /// the circle diagram, or nothing.
    std::optional<FigureId> beside(const Step& step) const {
        const FigureId id = step.figure;
        if (id.kind == FigureKind::lines_of_action || id.kind == FigureKind::mechanism || id.kind == FigureKind::truss)
            return std::nullopt;
        if (id.kind == FigureKind::centres) return FigureId{FigureKind::circle_diagram};
        const bool is_of_forces = step.section == Topic::forces;
        if (id.kind == FigureKind::force_plan || (shown_by_.is_truss() && is_of_forces))
            return FigureId{FigureKind::truss};
        if (id.kind == FigureKind::forces && id.part != all_loads)
            return FigureId{FigureKind::lines_of_action, -1, id.part};
        if (is_of_forces) return FigureId{FigureKind::lines_of_action};
        if (solution_.instantaneous_motion) return FigureId{FigureKind::mechanism};
        return FigureId{step.section == Topic::acceleration ? FigureKind::alpha : FigureKind::omega};
    }
    const Figure& small(const Step& step) {
        const std::optional<FigureId> id = beside(step);
        const auto [found, fresh] = small_figures_.try_emplace(id);
        if (!fresh || !id) return found->second;
        Figure& figure = found->second;
        if (id->kind != FigureKind::circle_diagram)
            figure = draw(*id, beside_context_, rooms_.small.width(), rooms_.small.height());
        else if (solution_.mechanism.bodies.size() >= 3)
            figure = circle_diagram(beside_context_, rooms_.small.width(), rooms_.small.height());
        // Beside the figure of a slide there is room for less: what is larger is left out.
        constexpr double nearly = 1;  // mm
        if (format_.is_slide && (figure.box.width() > rooms_.small.width() + nearly ||
                                 figure.box.height() > rooms_.small.height() + nearly))
            figure = Figure();
        figure.move(rooms_.small.min.x - figure.box.min.x + 0.5 * (rooms_.small.width() - figure.box.width()),
                    rooms_.small.min.y - figure.box.min.y);
        return figure;
    }

    /// `share`: of the lines that are new on the page, how much is drawn.
    Page page(std::size_t index, double share) {
        const Step& step = steps_[index];
        const Theme& theme = context_.theme;
        const Placed& placed = large(step.figure);
        const Figure& beside = small(step);
        const Contents contents(placed.figure.marks);
        const bool adds = std::any_of(step.statements.begin(), step.statements.end(), [&](StatementIndex statement) {
            return contents.statements.contains(statement);
        });
        // A page without new lines emphasises what is read off, or at least what the statement names.
        Cited cited;
        std::vector<Mark> segments;
        if (!adds) {
            cited.names = names_cited(solution_, step.statements, context_.language);
            const std::set<std::string> found =
                Contents(revealed(placed.figure.marks, page_of_, index, theme)).found(cited.names);
            segments = segments_read(context_, step.statements,
                                     beside.traits.measured == QuantityKind::length ? beside : placed.figure);
            if (found.empty() && segments.empty()) cited.groups = groups_shown(step);
            cited.names.insert(found.begin(), found.end());
        }
        std::vector<Mark> marks = placed.caption;
        std::optional<double> scale_of_mechanism;
        for (const Figure* figure : {&placed.figure, &beside}) {
            const bool all_new = figure == &placed.figure && is_all_new(step);
            const std::vector<Mark> drawn =
                share < 1 ? grown(figure->marks, growth_on(index, all_new), share) : figure->marks;
            std::vector<Mark> shown =
                revealed(drawn, all_new ? std::vector<std::size_t>{} : page_of_, index, theme, cited);
            marks.insert(marks.end(), std::make_move_iterator(shown.begin()), std::make_move_iterator(shown.end()));
            if (figure->traits.measured == QuantityKind::length && !scale_of_mechanism)
                scale_of_mechanism = figure->scale;
        }
        marks.insert(marks.end(), segments.begin(), segments.end());
        Page said;
        if (!step.rows.empty())
            prose_on(step).set(said, heading_of(step), step.rows, placed.figure.id + " " + beside.id, with_sentences_);
        marks.insert(marks.end(), std::make_move_iterator(said.marks.begin()),
                     std::make_move_iterator(said.marks.end()));
        Page page = framed_page(context_, format_, signature_, std::move(marks), scale_of_mechanism, index + 1,
                                steps_.size() + after_);
        page.step = std::move(said.step);
        if (share < 1 && !page.step) page.step.emplace();
        if (share < 1) page.step->grows = true;
        return page;
    }
    /// The same, with the names used in figures for the loads of one body alone.
    std::set<GroupId> groups_shown(const Step& step) const {
        std::set<GroupId> groups = groups_spoken_of(solution_, step.statements);
        if (step.statements.empty()) return groups;
        const LoadCase loads(solution_, part_of(solution_, step.statements.front()));
        if (!loads.is_alone()) return groups;
        std::set<GroupId> alone;
        for (const GroupId& group : groups) alone.insert(GroupId(element_of("load", loads.load()), group.element));
        return alone;
    }
    std::string heading_of(const Step& step) const {
        if (step.section == Topic::unnamed) return word(lang::sheet::steps, context_.language);
        return word(steps_heading(step.section), context_.language);
    }

    SheetFormat format_;
    Theme theme_;
    DrawingContext context_, beside_context_;
    const Solution& solution_;
    Signature signature_;
    std::size_t after_;  // pages bound behind these
    WantedFigures wanted_;
    StatementFigures shown_by_;
    bool with_sentences_;
    int growing_;  // pictures before a page, in which its lines grow
    StepRooms rooms_;
    StepProse prose_, tall_prose_;
    std::vector<Step> steps_;
    std::vector<std::size_t> page_of_;  // by statement
    std::map<FigureId, Placed> large_figures_;
    std::map<std::optional<FigureId>, Figure> small_figures_;
};

bool is_cited(const Mark& mark, const Cited& cited) {
    const auto among = [&](const std::string& name) { return cited.names.contains(name); };
    if (const auto* text = std::get_if<TextMark>(&mark))
        return std::any_of(text->names.begin(), text->names.end(), among);
    const auto* group = std::get_if<GroupBegin>(&mark);
    if (!group) return false;
    if (cited.groups.contains(group->id) || (!group->cited_as.empty() && among(group->cited_as))) return true;
    const std::string* name = group->attribute("data-name");
    return name && among(*name);
}

}  // namespace

std::vector<Mark> revealed(const std::vector<Mark>& marks, const std::vector<std::size_t>& page_of, std::size_t page,
                           const Theme& theme, const Cited& cited) {
    const auto page_of_statement = [&](StatementIndex statement) -> std::optional<std::size_t> {
        if (statement == none || at_index(statement) >= page_of.size()) return std::nullopt;
        return page_of[at_index(statement)];
    };
    // If the accent colour equals the text colour, given marks must be grey, too.
    const bool one_ink = theme.accent == theme.text;
    std::vector<Mark> shown;
    Nesting nesting;
    std::vector<bool> cited_groups;  // by open group: whether it or a group round it is cited
    std::size_t hidden = 0;          // number of open groups within one that is not shown yet
    for (const Mark& mark : marks) {
        const StatementIndex statement = nesting.enter(mark);
        if (std::holds_alternative<GroupEnd>(mark)) {
            if (hidden == 0) shown.push_back(mark);
            if (hidden > 0) --hidden;
            cited_groups.pop_back();
            continue;
        }
        const bool named = is_cited(mark, cited) || (!cited_groups.empty() && cited_groups.back());
        const auto at = page_of_statement(statement);
        const bool later = at && *at > page;
        if (std::holds_alternative<GroupBegin>(mark)) {
            cited_groups.push_back(named);
            if (hidden > 0 || later) ++hidden;
        }
        if (hidden > 0 || later) continue;
        shown.push_back(mark);
        if (at || named)
            std::visit(Recolour{named || *at == page ? theme.accent : theme.secondary}, shown.back());
        else if (one_ink && std::holds_alternative<Path>(mark))
            std::visit(Recolour{theme.secondary}, shown.back());
    }
    return shown;
}

std::vector<Page> lay_out_steps(const Solution& solution, const SheetOptions& options, const Fonts& fonts) {
    if (stands_for_joints(solution.mechanism)) return lay_out_problem_steps(solution, options, fonts);
    return with_contacts(solution, options, fonts, lay_out_problem_steps, [&](const SheetOptions& numbered) {
        StepPages steps(solution, numbered, fonts);
        std::vector<Page> pages = steps.pages();
        return BoundPages{std::move(pages), steps.figures()};
    });
}

}  // namespace kinegraph::render
