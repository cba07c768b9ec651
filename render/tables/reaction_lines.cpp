// Active forces and reactions, body by body: see force_tables.hpp. Owns the columns of that table and its note on
// action and reaction.
#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "engine/number/index.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/sheet.hpp"
#include "render/page/shapes.hpp"
#include "render/scene/polygon_scene.hpp"
#include "render/tables/force_tables.hpp"
#include "render/tables/long_names.hpp"

namespace kinegraph::render {
namespace {

/// Texts joined by commas; a dash if there are none.
RichText with_commas(const std::vector<RichText>& parts) {
    RichText all;
    for (const RichText& part : parts) {
        if (!all.empty()) append(all, ", ");
        append(all, part);
    }
    return parts.empty() ? one_piece("–") : all;
}

/// The forces on a body, as shown in its row.
struct ActingForces {
    std::vector<RichText> active, reactions;
};

/// The table of the forces on each body: head, rows, the frame's row, and a note on action and reaction.
class ReactionTable {
public:
    ReactionTable(const DrawingContext& context, double width)
        : context_(context), mechanism_(context.solution.mechanism), theme_(context.theme), width_(width) {
        measure_columns();
    }

    std::vector<Block> lines() {
        add_head();
        for (const FreeBody* body : in_order_of_bodies()) {
            const ActingForces forces = forces_on(*body);
            add_row(name_of(*body), theme_.colour_of(body->body).letter, with_commas(forces.active),
                    with_commas(forces.reactions), false);
        }
        if (!on_frame_.empty())
            add_row(name_of_frame(), theme_.secondary, one_piece("–"), with_commas(on_frame_), true);
        close_table();
        add_note();
        return std::move(lines_);
    }

private:
    /// A reaction between two bodies, which the note uses to explain action and reaction.
    struct Example {
        RichText symbol;
        BodyIndex from, on;
    };

    std::string word_for(Key key) const { return word(key, context_.language); }
    const std::string& name_of(BodyIndex body) const { return mechanism_.bodies[at_index(body)].name; }
    std::string name_of(const FreeBody& body) const {
        if (body.body != none) return name_of(body.body);
        return word_for(lang::sheet::pin) + " " + mechanism_.points[at_index(body.pin)].name;
    }
    /// "1 frame"; only its name if that contains the number or the word.
    std::string name_of_frame() const {
        const std::string& name = name_of(frame);
        const bool says_so = std::any_of(languages.begin(), languages.end(),
                                         [&](Language each) { return name == word(lang::common::frame, each); });
        return says_so ? name : name + " " + word_for(lang::common::frame);
    }
    RichText symbol_of(const AppliedForce& applied) const {
        return typeset(applied.force.is_zero() ? couple_symbol(applied) : applied.symbol, context_.language);
    }
    double width_of(const RichText& text, double size) const { return context_.fonts.shape(text, size).width; }

    /// Column widths follow the words, but names may not take the room of the forces.
    void measure_columns() {
        constexpr double most_of_name = 0.3, most_of_active = 0.4, gap = 4;
        double active_width = width_of(one_piece(word_for(lang::sheet::active_forces)), theme_.small);
        name_width_ = width_of(one_piece(word_for(lang::sheet::body)), theme_.small);
        for (const FreeBody& body : context_.solution.free_bodies) {
            name_width_ = std::max(name_width_, width_of(one_piece(name_of(body)), theme_.body_text));
            active_width = std::max(active_width, width_of(with_commas(measured_forces(body)), theme_.body_text));
        }
        name_width_ = std::max(name_width_, width_of(one_piece(name_of_frame()), theme_.body_text));
        name_width_ = std::min(name_width_, most_of_name * width_);
        active_left_ = name_width_ + gap;
        active_room_ = std::min(active_width + 0.5, most_of_active * width_);
        reactions_left_ = active_left_ + active_room_ + gap;
    }
    /// The active forces with a placeholder letter for each joint, of about average width.
    std::vector<RichText> measured_forces(const FreeBody& body) const {
        std::vector<RichText> active;
        for (const AppliedForce& applied : body.forces)
            if (!applied.is_reaction() && !applied.is_resultant()) {
                active.push_back(symbol_of(applied));
                if (applied.joint != none) append(active.back(), " (M)");
            }
        return active;
    }

    void add_head() {
        Block head;
        head.marks.emplace_back(line({0, 0}, {width_, 0}, {theme_.outline, theme_.text, {}, false}));
        const auto put = [&](Key key, double x) {
            set_text(head.marks, context_.fonts.shape(one_piece(word_for(key)), theme_.small), {x, 3.4},
                     theme_.secondary, "text");
        };
        put(lang::sheet::body, 0);
        put(lang::sheet::active_forces, active_left_);
        put(lang::sheet::reactions, reactions_left_);
        head.marks.emplace_back(line({0, 4.8}, {width_, 4.8}, {theme_.thin, theme_.text, {}, false}));
        head.width = width_;
        head.height = 5.0;
        lines_.push_back(std::move(head));
    }

    /// The bodies in the file's order, then the pins.
    std::vector<const FreeBody*> in_order_of_bodies() const {
        std::vector<const FreeBody*> order;
        for (const FreeBody& body : context_.solution.free_bodies) order.push_back(&body);
        std::stable_sort(order.begin(), order.end(), [](const FreeBody* a, const FreeBody* b) {
            return std::pair{a->body == none, a->body} < std::pair{b->body == none, b->body};
        });
        return order;
    }

    /// The forces on a body. Also collects, for the last row and the note, the actions on the frame and the first
    /// reaction between two bodies.
    ActingForces forces_on(const FreeBody& body) {
        ActingForces forces;
        for (const AppliedForce& applied : body.forces) {
            if (applied.is_resultant()) continue;  // not an acting force
            const bool is_reaction = applied.is_reaction();
            RichText text = symbol_of(applied);
            if (is_reaction && !example_ && applied.from != none && body.body != none)
                example_ = Example{text, applied.from, body.body};
            if (applied.joint != none) {
                const PointIndex at = mechanism_.joints[at_index(applied.joint)].point;
                append(text, "\u00a0(");
                append(text, typeset(Symbol{Symbol::Letter::point, mechanism_.points[at_index(at)].name, ""},
                                     context_.language));
                append(text, ")");
            }
            (is_reaction ? forces.reactions : forces.active).push_back(std::move(text));
            if (is_reaction && applied.from == frame && body.body != frame)
                on_frame_.push_back(action_on_frame(body, applied));
        }
        return forces;
    }
    /// F_21 = −F_12.
    RichText action_on_frame(const FreeBody& body, const AppliedForce& applied) const {
        const std::string& own = body.body != none ? name_of(body.body) : mechanism_.point(body.pin).name;
        const std::string& fixed = name_of(frame);
        const Symbol back{applied.force.is_zero() ? Symbol::Letter::M : Symbol::Letter::F,
                          own.size() == 1 && fixed.size() == 1 ? own + fixed : own + "," + fixed, applied.symbol.term};
        RichText action = typeset(back, context_.language);
        append(action, "\u00a0=\u00a0−");
        append(action, symbol_of(applied));
        return action;
    }

    void add_row(const std::string& name, Colour colour, const RichText& active, const RichText& reactions,
                 bool rule_above) {
        // A list of more lines goes on in further blocks, so that it may be continued in the next column.
        constexpr std::size_t most_lines = 20;
        std::vector<Block> blocks(1);
        std::vector<double> deepest(1, 0);
        if (rule_above)
            blocks[0].marks.emplace_back(line({0, 0}, {width_, 0}, {theme_.thin, theme_.secondary, {}, false}));
        blocks[0].width = width_;
        const auto fill = [&](std::vector<ShapedLine> set, double left, Colour letters) {
            double baseline = 3.6;
            for (std::size_t i = 0; i < set.size(); ++i) {
                if (i % most_lines == 0) baseline = 3.6;
                const std::size_t part = i / most_lines;
                if (part == blocks.size()) {
                    blocks.emplace_back().width = width_;
                    deepest.push_back(0);
                }
                Block& block = blocks[part];
                block.width = std::max(block.width, left + set[i].width);
                set_text(block.marks, std::move(set[i]), {left, baseline}, letters, "text");
                baseline += 4.3;
                deepest[part] = std::max(deepest[part], baseline);
            }
        };
        const auto broken = [&](const RichText& text, double room) {
            return lines_in_cell(text, theme_.body_text, context_.fonts, room);
        };
        fill(broken(one_piece(name), name_width_), 0, colour);
        fill(broken(active, active_room_), active_left_, theme_.text);
        // In a narrow column the reactions would have to shrink. They overflow instead, and the caller sees that the
        // column is too narrow for the table.
        constexpr double narrow = 60;
        const double room = width_ - reactions_left_;
        fill(width_ < narrow ? context_.fonts.wrap(reactions, theme_.body_text, room) : broken(reactions, room),
             reactions_left_, theme_.text);
        for (std::size_t part = 0; part < blocks.size(); ++part) {
            blocks[part].height = deepest[part] - 3.6 + 0.5;
            lines_.push_back(std::move(blocks[part]));
        }
    }
    void close_table() {
        Block& last = lines_.back();
        last.marks.emplace_back(
            line({0, last.height + 0.3}, {width_, last.height + 0.3}, {theme_.outline, theme_.text, {}, false}));
        last.height += 0.6;
    }

    void add_note() {
        RichText text;
        const auto add = [&](const RichText& said) {
            if (!text.empty()) append(text, " ");
            append(text, said);
        };
        if (example_) {
            append(text, example_->symbol);
            append(text, " " + Words(lang::sheet::action_and_reaction, name_of(example_->from), name_of(example_->on))
                                   .in(context_.language));
            if (!closed_polygons(context_.solution).empty()) add(one_piece(word_for(lang::sheet::internal_sides)));
        }
        if (has_resultants(context_.solution)) add(one_piece(word_for(lang::sheet::double_heads)));
        if (!text.empty()) lines_.push_back(note_block(context_, text, width_));
    }

    const DrawingContext& context_;
    const Mechanism& mechanism_;
    const Theme& theme_;
    double width_;
    double name_width_ = 0, active_left_ = 0, active_room_ = 0, reactions_left_ = 0;
    std::vector<RichText> on_frame_;
    std::optional<Example> example_;
    std::vector<Block> lines_;
};

}  // namespace

bool has_resultants(const Solution& solution) {
    const auto has_sums = [](const auto& bodies) { return !bodies.sums.empty(); };
    const auto any_has = [&](const auto& all) { return std::any_of(all.begin(), all.end(), has_sums); };
    return any_has(solution.free_bodies) || any_has(solution.taken_together) ||
           std::any_of(solution.resultants.begin(), solution.resultants.end(),
                       [](const Resultant& each) { return !each.force->is_zero(); }) ||
           (solution.superposition &&
            std::any_of(solution.superposition->parts.begin(), solution.superposition->parts.end(),
                        [&](const auto& part) { return any_has(part.bodies) || any_has(part.together); }));
}

Block note_block(const DrawingContext& context, const RichText& text, double width) {
    Block note;
    double baseline = 4.2;
    for (ShapedLine& each : context.fonts.wrap(text, context.theme.small, width)) {
        set_text(note.marks, std::move(each), {0, baseline}, context.theme.secondary, "text");
        baseline += 3.9;
    }
    note.width = width;
    note.height = baseline - 3.4;
    return note;
}

std::vector<Block> reaction_lines(const DrawingContext& context, double width) {
    if (context.solution.free_bodies.empty()) return {};
    return ReactionTable(context, width).lines();
}

}  // namespace kinegraph::render
