// Steps: which statements share a page, which figure they belong to, and what of it is shown there.
#include "render/steps.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "render/caption.hpp"
#include "render/force_tables.hpp"
#include "render/prose.hpp"
#include "render/shapes.hpp"
#include "render/tables.hpp"
#include "render/title_block.hpp"
#include "render/wanted_figures.hpp"

namespace kinegraph::render {
namespace {

/// Statements that only name the pair a centre lies at.
bool names_a_pair(Sentence sentence) {
    switch (sentence) {
        case Sentence::primary_revolute:
        case Sentence::primary_prismatic:
        case Sentence::primary_rolling:
        case Sentence::primary_gear:
        case Sentence::primary_weld:
            return true;
        default:
            return false;
    }
}

/// Statements after which a body's polygon of forces is drawn.
bool closes_a_polygon(Sentence sentence) {
    switch (sentence) {
        case Sentence::triangle:
        case Sentence::triangle_at:
        case Sentence::parallel_forces:
        case Sentence::culmann:
        case Sentence::culmann_line:
        case Sentence::force_and_couple:
        case Sentence::single_reaction:
            return true;
        default:
            return false;
    }
}

std::optional<BodyIndex> body_of(const Mechanism& mechanism, const Message& message) {
    const auto* name = message.arguments.empty() ? nullptr : std::get_if<BodyName>(&message.arguments.front());
    return name ? mechanism.body_named(name->name) : std::nullopt;
}

/// A stroke or a letter in another colour; what is filled with paper or with a body's tint stays.
struct Recolour {
    const Theme& theme;
    Colour colour;
    bool is_ground(Colour fill) const {
        return fill == theme.paper ||
               std::any_of(theme.bodies.begin(), theme.bodies.end(), [&](const BodyColour& body) { return body.tint == fill; });
    }
    void operator()(Path& path) const {
        if (path.stroked) path.pen.colour = colour;
        if (path.filled && !is_ground(path.fill)) path.fill = colour;
    }
    void operator()(TextMark& text) const {
        text.colour = colour;
        for (Path& extra : text.extras) (*this)(extra);
    }
    template <class Other>
    void operator()(const Other& /*unseen*/) const {}
};

class StepPages {
public:
    StepPages(const Solution& solution, const SheetOptions& options, const Fonts& fonts)
        : context_{solution, options.theme, fonts, options.language},
          solution_(solution),
          format_(format_of(options.paper, options.orientation)),
          signature_{options.author, options.date},
          wanted_(context_, format_.measure, false) {
        const Box& content = format_.content;
        const double bottom = format_.block.min.y - 4;
        if (options.orientation == Orientation::portrait) {
            const double middle = content.min.y + 0.6 * (bottom - content.min.y);
            large_ = rectangle(content.min.x, content.min.y, content.max.x, middle);
            small_ = rectangle(content.min.x, middle + gap, content.min.x + format_.measure, bottom);
            prose_ = rectangle(content.max.x - format_.measure, middle + gap, content.max.x, bottom);
        } else {
            const double left = content.max.x - format_.measure;
            const double below = content.min.y + 0.42 * (bottom - content.min.y);
            large_ = rectangle(content.min.x, content.min.y, left - gap, bottom);
            small_ = rectangle(left, content.min.y, content.max.x, below);
            prose_ = rectangle(left, below + gap, content.max.x, bottom);
        }
    }

    std::vector<Page> pages() {
        collect();
        std::vector<Page> pages;
        for (std::size_t i = 0; i < steps_.size(); ++i) pages.push_back(page(i));
        return pages;
    }

private:
    /// What one page adds.
    struct Step {
        std::string figure;  ///< name in wanted_, or "mechanism"
        std::string section;
        std::vector<Block> rows;
        double height = 0;
    };
    /// A figure as it ends up, in its place on the pages.
    struct Placed {
        Figure figure;
        std::vector<Mark> caption;
    };

    const std::vector<Statement>& statements() const { return solution_.protocol.statements; }
    bool is_wanted(const std::string& name) const {
        return std::any_of(wanted_.list.begin(), wanted_.list.end(), [&](const Wanted& each) { return each.name == name; });
    }

    // --- what belongs to which page ------------------------------------------------------------------------------------------

    void collect() {
        std::map<std::size_t, int> polygon_of;  // by statement
        const auto note = [&](int statement, int polygon) {
            if (statement >= 0 && polygon >= 0) polygon_of.emplace(static_cast<std::size_t>(statement), polygon);
        };
        for (const DrawnVector& vector : solution_.protocol.vectors) note(vector.statement, vector.polygon);
        for (const DrawnLine& line : solution_.protocol.lines) note(line.statement, line.polygon);
        std::map<std::string, std::string> last_in;  // figure by section
        for (std::size_t i = 0; i < statements().size(); ++i) {
            const Statement& statement = statements()[i];
            std::string figure;
            const auto found = polygon_of.find(i);
            if (statement.section == "forces")
                figure = closes_a_polygon(statement.message.sentence) && is_wanted("forces") ? "forces" : "lines-of-action";
            else if (found != polygon_of.end() && is_plane_of_motion(found->second))
                figure = solution_.protocol.polygons[static_cast<std::size_t>(found->second)].id;
            else if (statement.section == "centres" || statement.message.sentence == Sentence::second_way)
                figure = "centres";
            else
                figure = last_in[statement.section];
            if (figure.empty()) figure = first_polygon_of(statement.section);
            if (!is_wanted(figure)) figure = "mechanism";
            if (statement.message.sentence != Sentence::second_way) last_in[statement.section] = figure;
            add(i, figure);
        }
        if (steps_.empty()) steps_.push_back({"mechanism", "", {}, 0});
    }
    bool is_plane_of_motion(int polygon) const {
        return solution_.protocol.polygons[static_cast<std::size_t>(polygon)].plane != Plane::force;
    }
    std::string first_polygon_of(const std::string& section) const {
        for (const Polygon& polygon : solution_.protocol.polygons)
            if (polygon.plane == (section == "acceleration" ? Plane::acceleration : Plane::velocity)) return polygon.id;
        return "";
    }

    void add(std::size_t index, const std::string& figure) {
        const Statement& statement = statements()[index];
        std::vector<Block> rows{paragraph_block(context_, format_.measure, say(statement.message, context_.language))};
        for (Block& equation : equations_of(statement)) rows.push_back(std::move(equation));
        double height = 0;
        for (const Block& row : rows) height += row.height;
        const bool pair = names_a_pair(statement.message.sentence);
        const bool joins = pair && only_pairs_ && !steps_.empty() && steps_.back().figure == figure &&
                           steps_.back().height + height <= prose_.height() - head_height;
        if (!joins) steps_.push_back({figure, statement.section, {}, 0});
        only_pairs_ = pair;
        Step& step = steps_.back();
        step.rows.insert(step.rows.end(), std::make_move_iterator(rows.begin()), std::make_move_iterator(rows.end()));
        step.height += height;
        page_of_.push_back(steps_.size() - 1);
    }

    std::vector<Block> equations_of(const Statement& statement) const {
        std::vector<Block> found;
        if (statement.equation) found.push_back(equation_block(context_, *statement.equation, format_.measure));
        if (const auto body = body_of(solution_.mechanism, statement.message);
            body && closes_a_polygon(statement.message.sentence))
            for (const FreeBody& free : solution_.free_bodies)
                if (free.body == *body) found.push_back(force_equation_block(context_, free, true));
        std::erase_if(found, [&](const Block& block) { return !(block.width > 0) || block.width > format_.measure; });
        for (Block& block : found) {
            render::move(block.marks, 0, 2.5);
            block.height += 5;
        }
        return found;
    }

    // --- figures -------------------------------------------------------------------------------------------------------------

    Figure draw(const std::string& name, double room_x, double room_y) {
        for (Wanted& wanted : wanted_.list)
            if (wanted.name == name) return wanted.draw(room_x, room_y);
        return mechanism_figure(context_, room_x, room_y, false);
    }

    const Placed& large(const std::string& name) {
        const auto [found, fresh] = large_figures_.try_emplace(name);
        Placed& placed = found->second;
        if (!fresh) return placed;
        Box room = large_;
        room.min.y += 12;
        placed.figure = draw(name, room.width(), room.height());
        if (name == "forces") claim_polygons(placed.figure);
        const int number = static_cast<int>(large_figures_.size());
        room.min.y = large_.min.y +
                     std::max(12.0, set_caption(placed.caption, context_, placed.figure, number, large_.min, large_.width()));
        const Box box = placed.figure.box;
        placed.figure.move(room.min.x - box.min.x + 0.5 * (room.width() - box.width()),
                           room.min.y - box.min.y + 0.3 * std::max(0.0, room.height() - box.height()));
        return placed;
    }
    /// A body's polygon comes with the last statement about that body.
    void claim_polygons(Figure& figure) const {
        std::map<std::string, int> last;  // by group
        for (std::size_t i = 0; i < statements().size(); ++i)
            if (const auto body = body_of(solution_.mechanism, statements()[i].message);
                body && closes_a_polygon(statements()[i].message.sentence))
                for (const FreeBody& free : solution_.free_bodies)
                    if (free.body == *body && free.polygon >= 0)
                        last[legal_id(solution_.protocol.polygons[static_cast<std::size_t>(free.polygon)].id)] =
                            static_cast<int>(i);
        for (Mark& mark : figure.marks)
            if (auto* group = std::get_if<GroupBegin>(&mark))
                for (const std::string& id : {group->id, group->id.substr(0, group->id.rfind("-detail-"))})
                    if (const auto found = last.find(id); found != last.end()) group->statement = found->second;
    }

    /// What stands small beside a figure: the mechanism; beside itself the circle of the centres, or nothing.
    const Figure& small(const std::string& beside) {
        const bool itself = beside == "lines-of-action" || beside == "mechanism";
        const std::string name = beside == "centres" ? "circle-diagram" : itself ? "" : "mechanism";
        const auto [found, fresh] = small_figures_.try_emplace(name);
        if (!fresh || name.empty()) return found->second;
        Figure& figure = found->second;
        if (name != "circle-diagram")
            figure = draw(name, small_.width(), small_.height());
        else if (solution_.mechanism.bodies.size() >= 3)
            figure = circle_diagram(context_, small_.width(), small_.height());
        figure.move(small_.min.x - figure.box.min.x + 0.5 * (small_.width() - figure.box.width()),
                    small_.min.y - figure.box.min.y);
        return figure;
    }

    Page page(std::size_t index) {
        const Step& step = steps_[index];
        const auto& theme = context_.theme;
        const Placed& placed = large(step.figure);
        std::vector<Mark> marks = placed.caption;
        std::optional<double> scale_of_mechanism;
        for (const Figure* figure : {&placed.figure, &small(step.figure)}) {
            std::vector<Mark> shown = revealed(figure->marks, page_of_, index, theme);
            marks.insert(marks.end(), std::make_move_iterator(shown.begin()), std::make_move_iterator(shown.end()));
            if (figure->kind == "mechanism" && !scale_of_mechanism) scale_of_mechanism = figure->scale;
        }
        if (!step.rows.empty()) {
            double y = prose_.min.y;
            const Block head = heading_block(context_, format_.measure, heading_of(step), {});
            set(marks, head, {prose_.min.x, y});
            y += head.height;
            for (const Block& row : step.rows) {
                set(marks, row, {prose_.min.x, y});
                y += row.height;
            }
        }
        return framed_page(context_, format_, signature_, marks, scale_of_mechanism, index + 1, steps_.size());
    }
    std::string heading_of(const Step& step) const {
        for (const char* known : {"velocity", "acceleration", "relative motion", "centres", "forces"})
            if (step.section == known) return word("steps " + step.section, context_.language);
        return word("steps", context_.language);
    }

    static constexpr double head_height = 7;

    DrawingContext context_;
    const Solution& solution_;
    SheetFormat format_;
    Signature signature_;
    WantedFigures wanted_;
    Box large_, small_, prose_;
    std::vector<Step> steps_;
    std::vector<std::size_t> page_of_;  // by statement
    bool only_pairs_ = false;
    std::map<std::string, Placed> large_figures_;
    std::map<std::string, Figure> small_figures_;
};

}  // namespace

std::vector<Mark> revealed(const std::vector<Mark>& marks, const std::vector<std::size_t>& page_of, std::size_t page,
                           const Theme& theme) {
    const auto page_of_statement = [&](int statement) -> std::optional<std::size_t> {
        if (statement < 0 || static_cast<std::size_t>(statement) >= page_of.size()) return std::nullopt;
        return page_of[static_cast<std::size_t>(statement)];
    };
    std::vector<Mark> shown;
    std::vector<int> groups;  // the statement that holds within each open group
    std::size_t hidden = 0;   // groups open since one that is not shown yet
    for (const Mark& mark : marks) {
        if (std::holds_alternative<GroupEnd>(mark)) {
            if (hidden == 0) shown.push_back(mark);
            if (hidden > 0) --hidden;
            groups.pop_back();
            continue;
        }
        const int own = std::visit(
            [](const auto& each) {
                if constexpr (requires { each.statement; })
                    return each.statement;
                else
                    return -1;
            },
            mark);
        const int statement = own >= 0 || groups.empty() ? own : groups.back();
        const auto at = page_of_statement(statement);
        const bool later = at && *at > page;
        if (std::holds_alternative<GroupBegin>(mark)) {
            groups.push_back(statement);
            if (hidden > 0 || later) ++hidden;
        }
        if (hidden > 0 || later) continue;
        shown.push_back(mark);
        if (at) std::visit(Recolour{theme, *at == page ? theme.accent : theme.secondary}, shown.back());
    }
    return shown;
}

std::vector<Page> lay_out_steps(const Solution& solution, const SheetOptions& options, const Fonts& fonts) {
    return StepPages(solution, options, fonts).pages();
}

}  // namespace kinegraph::render
