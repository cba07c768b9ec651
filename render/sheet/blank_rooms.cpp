#include "render/sheet/handout.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lang/keys/sheet.hpp"
#include "render/content/bands.hpp"
#include "render/content/exercise_text.hpp"
#include "render/figures/caption.hpp"
#include "render/layout/page_plan.hpp"
#include "render/page/shapes.hpp"
#include "render/scene/load_case.hpp"

namespace kinegraph::render {
namespace {

constexpr double square = 5;  // of the grid, mm

class BlankRooms {
public:
    BlankRooms(const DrawingContext& context, const SheetFormat& format, std::vector<std::vector<Mark>>& sheets)
        : context_(context), format_(format), sheets_(sheets) {}

    void add(const std::vector<Figure>& figures) {
        constexpr double caption = 7;
        const Box content = content_of(format_, false);
        double x = 0, y = 0, row = 0;
        bool open = false;
        for (const Figure& figure : figures) {
            if (&figure == &figures.front() || !figure.has_scale) continue;
            if (!figure.traits.measured || figure.traits.measured == QuantityKind::length) continue;
            if (!is_drawn_for_sought(context_.solution.mechanism, figure)) continue;
            Room room = room_of(figure);
            const auto down_to = [](double length, double most) {
                return square * std::floor(std::min(length, most) / square);
            };
            room.size = {down_to(room.size.x, content.width()), down_to(room.size.y, content.height() - caption)};
            if (!open || x + room.size.x > content.max.x) x = content.min.x, y += row, row = 0;
            if (!open || y + caption + room.size.y > content.max.y) {
                sheets_.emplace_back();
                x = content.min.x, y = content.min.y, row = 0;
                open = true;
            }
            draw_room(room, {x, y}, caption);
            x += room.size.x + gap;
            row = std::max(row, caption + room.size.y + gap);
        }
    }

private:
    struct Room {
        RichText name;
        Spot size, pole;
        bool has_pole = false;
        bool has_letter = false;  ///< for the pole
    };

    /// The heading of a blank area: "Force triangle, body 3", "Closed polygon of the external forces".
    RichText name_of_room(const Figure& figure) const {
        const Solution& solution = context_.solution;
        RichText name = figure.caption;
        const auto shows = [&](int polygon) {
            return std::find(figure.polygons.begin(), figure.polygons.end(), polygon) != figure.polygons.end();
        };
        const auto add = [&](Key what, const std::string& whom) {
            append(name, one_piece(", " + word(what, context_.language) + " " + whom));
        };
        for (const FreeBody& body : solution.free_bodies)
            if (shows(body.polygon) && body.body != none)
                add(lang::sheet::body, solution.mechanism.body(body.body).name);
            else if (shows(body.polygon))
                add(lang::sheet::pin, solution.mechanism.point(body.pin).name);
        for (const TakenTogether& together : solution.taken_together)
            if (shows(together.polygon)) add(lang::sheet::bodies_together, names_of(solution.mechanism, together));
        return name;
    }

    /// The size of the polygon at its scale with its labels, in whole squares.
    Room room_of(const Figure& figure) const {
        constexpr double air = 8;
        const auto squares = [](double length) { return square * std::ceil(length / square); };
        Room room;
        room.name = name_of_room(figure);
        append(room.name, one_piece("   "));
        append(room.name, scale_words(context_, figure));
        const bool is_of_motion = figure.traits.measured != QuantityKind::force;
        // A force polygon begins at the tail of its first side.
        const bool has_start = !is_of_motion && !figure.axes.empty() && figure.axes.front().detail.empty();
        room.has_pole = is_of_motion || has_start;
        room.has_letter = is_of_motion;
        const Spot pole = (has_start ? figure.axes.front().tail : figure.origin) - figure.box.min;
        room.pole = {squares(pole.x + air), squares(pole.y + air)};
        const double words = context_.fonts.shape(room.name, context_.theme.body_text).width;
        room.size = {std::max({squares(figure.box.width() + 2 * air), room.pole.x + square, squares(words)}),
                     std::max(squares(figure.box.height() + 2 * air), room.pole.y + square)};
        return room;
    }

    void draw_room(const Room& room, Spot at, double caption) {
        std::vector<Mark>& marks = sheets_.back();
        const Theme& theme = context_.theme;
        marks.emplace_back(GroupBegin{"room", {}, plain(room.name), {}});
        render::set_text(marks, shaped_within(room.name, theme.body_text, context_.fonts, room.size.x),
                         {at.x, at.y + 3.8}, theme.text, "text");
        const Spot corner = at + Spot{0, caption};
        const Pen thin{0.1, theme.secondary, {}, false};
        for (double x = 0; x <= room.size.x + 0.1; x += square)
            marks.emplace_back(line(corner + Spot{x, 0}, corner + Spot{x, room.size.y}, thin));
        for (double y = 0; y <= room.size.y + 0.1; y += square)
            marks.emplace_back(line(corner + Spot{0, y}, corner + Spot{room.size.x, y}, thin));
        const Spot pole = corner + room.pole;
        if (room.has_pole && room.pole.x < room.size.x && room.pole.y < room.size.y) {
            marks.emplace_back(ring(pole, 1.0, theme.paper, {theme.outline, theme.text, {}, false}));
            if (!room.has_letter) return marks.emplace_back(GroupEnd{}), void();
            const ShapedLine name =
                context_.fonts.shape(typeset(Symbol{Symbol::Letter::pole, "", ""}, context_.language), theme.body_text);
            // In the middle of a square.
            const Spot middle = pole + Spot{square / 2, square / 2};
            render::set_text(marks, name, {middle.x - name.width / 2, middle.y + (name.ascent - name.descent) / 2},
                             theme.text, "text");
        }
        marks.emplace_back(GroupEnd{});
    }

    const DrawingContext& context_;
    const SheetFormat& format_;
    std::vector<std::vector<Mark>>& sheets_;
};

}  // namespace

void add_blank_rooms(const DrawingContext& context, const SheetFormat& format, const std::vector<Figure>& figures,
                     std::vector<std::vector<Mark>>& sheets) {
    BlankRooms(context, format, sheets).add(figures);
}

}  // namespace kinegraph::render
