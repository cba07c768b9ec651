// Dimensions of given data on the mechanism (ISO 129): lengths, radii and angles as the file states them, where they
// collide with nothing. Owns their number and order; all values are those of the file.
#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "render/mechanism/dimension_trials.hpp"
#include "render/page/ink_map.hpp"

namespace kinegraph::render::drawing {

namespace {

/// Index at which the labels of a closed figure begin.
std::size_t end_of_layers(std::span<const Mark> marks) {
    constexpr std::array<std::string_view, 8> layers{"tint",   "construction", "ground",  "links",
                                                     "joints", "arrows",       "centres", "dimensions"};
    const auto is_layer = [&](const Mark& mark) {
        const auto* group = std::get_if<GroupBegin>(&mark);
        return group != nullptr && std::find(layers.begin(), layers.end(), group->cls) != layers.end();
    };
    std::size_t end = 1;
    while (end < marks.size() && is_layer(marks[end])) end = end_of_mark(marks, end);
    return end;
}

/// Draws each datum by its cheapest candidate.
class DimensionsDrawing {
public:
    DimensionsDrawing(Sketch& sketch, DimensionRoom room, const DimensionWish& wish)
        : sketch_(sketch),
          wish_(wish),
          data_(dimension_data(sketch)),
          trials_(sketch, wish.sought_far),
          room_(std::move(room)) {}

    void draw() {
        const auto [all, most] = std::pair(wish_.all, wish_.most);
        if (!all && data_.lengths.size() + data_.angles.size() + data_.radii.size() > 2 * most) return;
        std::size_t count = 0;
        // Angles and radii first: they have fewer places than lengths. Shorter lengths stand inside longer ones.
        if (wish_.sought_far) {
            std::stable_sort(data_.lengths.begin(), data_.lengths.end(),
                             [](const DimensionedLength& a, const DimensionedLength& b) { return a.value < b.value; });
            std::vector<const DimensionedAngle*> crowded;
            for (const DimensionedAngle& angle : data_.angles) {
                const bool stands = count < most && draw(angle, all);
                count += stands ? 1 : 0;
                if (!stands) crowded.push_back(&angle);
            }
            for (const DimensionedRadius& radius : data_.radii) count += count < most ? draw(radius, all) : 0;
            for (const DimensionedLength& length : data_.lengths) count += count < most ? draw(length, all) : 0;
            for (const DimensionedAngle* angle : crowded) count += count < most ? draw_led_out(*angle, all) : 0;
            return;
        }
        for (const DimensionedLength& length : data_.lengths) count += all || count < most ? draw(length, all) : 0;
        for (const DimensionedRadius& radius : data_.radii) count += all || count < most ? draw(radius, all) : 0;
        for (const DimensionedAngle& angle : data_.angles) count += all || count < most ? draw(angle, all) : 0;
    }

private:
    /// How a dimension is drawn, and the accepted price.
    struct Drawn {
        std::string name;
        GroupId id;  // empty: derived from the name by the sketch
        double free_enough;
    };

    bool draw(const DimensionedLength& datum, bool all) {
        const std::string words = with_unit(datum.value);
        const ShapedLine text = text_of(words);
        const std::vector<DimensionTrial> trials = trials_.of(datum, text.width);
        if (trials.empty()) return false;  // before an id is taken
        const std::array<Spot, 2> ends{datum.from, datum.to};
        const Drawn as = drawn_as(datum.name);
        return draw_best(trials, text, ends, as, words, all) ||
               draw_best(trials_.beside(datum, text.width), text, ends, as, words, false);
    }
    bool draw(const DimensionedRadius& datum, bool all) {
        const std::string words = "R " + with_unit(datum.value);
        const ShapedLine text = text_of(words);
        const std::vector<DimensionTrial> trials = trials_.of(datum, text.width);
        if (trials.empty()) return false;  // before an id is taken
        return draw_best(trials, text, {datum.centre, datum.centre}, drawn_as(datum.name), words, all);
    }
    bool draw(const DimensionedAngle& datum, bool all) {
        const ShapedLine text = text_of(datum.text);
        return draw_best(trials_.of(datum, text.width), text, {datum.vertex, datum.vertex}, drawn_as(datum), datum.text,
                         all);
    }
    bool draw_led_out(const DimensionedAngle& datum, bool all) {
        const ShapedLine text = text_of(datum.text);
        Drawn as = drawn_as(datum);
        // A leader may cross things that letters may not, and a crossed link counts once per stroke.
        as.free_enough = 18;
        return draw_best(trials_.led_out_of(datum, text.width), text, {datum.vertex, datum.vertex}, std::move(as),
                         datum.text, all);
    }

    /// Draws the cheapest candidate, if it is free enough.
    bool draw_best(const std::vector<DimensionTrial>& trials, const ShapedLine& text, const std::array<Spot, 2>& ends,
                   Drawn as, const std::string& title, bool all) {
        GroupId& group = as.id;
        if (wish_.left_out.contains(group)) return false;
        const double free_enough = as.free_enough;
        const DimensionTrial* best = nullptr;
        // Anything dearer is not drawn.
        double least = all ? 1e300 : free_enough + 1;
        for (const DimensionTrial& trial : trials)
            if (const double price = room_.price_of(trial, text.width, ends, least); price < least - 1e-9) {
                least = price;
                best = &trial;
            }
        if (!best || (!all && least > free_enough)) return false;
        if (group.empty()) group = sketch_.id("dimension", as.name);
        std::vector<Mark>& marks = sketch_.dimensions;
        marks.emplace_back(GroupBegin{"dimension", std::move(group), title, {}});
        for (const Bar& extension : best->extensions)
            marks.emplace_back(line(extension.from, extension.to, {sketch_.theme.thin, sketch_.theme.text, {}, false}));
        best->draw(marks);
        const std::size_t before = marks.size();
        set_text(marks, text, best->text_at - Spot{text.width / 2, 0}, sketch_.theme.text, "label");
        for (std::size_t i = before; i < marks.size(); ++i)
            if (auto* set = std::get_if<TextMark>(&marks[i])) {
                set->angle = angle_of(polar_spot(best->text_angle));
                set->pivot = best->text_at;
            }
        marks.emplace_back(GroupEnd{});
        room_.take(*best, text.width);
        return true;
    }

    ShapedLine text_of(const std::string& words) const {
        return sketch_.context.fonts.shape(with_powers(words), sketch_.theme.small);
    }
    std::string with_unit(double metres) const {
        const Unit& unit_of_length = sketch_.mechanism.units.length;
        return given_number(metres / unit_of_length.si.to_double(), sketch_.context.language) + " " +
               unit_of_length.symbol;
    }
    /// Independent of whether it is drawn before the names or after them.
    GroupId id_of(const std::string& name) {
        std::string element = element_of("dimension", name);
        while (!elements_.insert(element).second) element += "_";
        return GroupId({}, std::move(element));
    }
    Drawn drawn_as(std::string name) {
        GroupId id = wish_.sought_far || !wish_.left_out.empty() ? id_of(name) : GroupId();
        return {std::move(name), std::move(id), wish_.sought_far ? 10 : 2.2};
    }
    /// An angle has a single id, however often it is tried.
    Drawn drawn_as(const DimensionedAngle& datum) {
        const auto [known, is_new] = drawn_angles_.try_emplace(&datum);
        if (is_new) known->second = drawn_as("angle." + datum.name);
        return known->second;
    }

    Sketch& sketch_;
    const DimensionWish& wish_;
    DimensionData data_;
    DimensionTrials trials_;
    DimensionRoom room_;
    std::set<std::string> elements_;
    std::map<const DimensionedAngle*, Drawn> drawn_angles_;
};

struct DimensionText {
    InkBox box;
    GroupId dimension;
};
struct DimensionPath {
    const Path* path;
    GroupId dimension;
};

}  // namespace

void draw_dimensions(Sketch& sketch, Spot room, const DimensionWish& wish) {
    DimensionsDrawing(sketch, DimensionRoom(sketch, room, wish), wish).draw();
}

void add_dimensions(Sketch& sketch, Figure& figure, Spot room, const DimensionWish& wish) {
    DimensionsDrawing(sketch, DimensionRoom(sketch, figure, room, wish), wish).draw();
    std::vector<Mark>& drawn = sketch.dimensions;
    if (drawn.empty()) return;
    move(drawn, figure.origin.x, figure.origin.y);
    figure.box.include(box_of(drawn));
    // The last of the layers, below all letters.
    drawn.insert(drawn.begin(), GroupBegin{"dimensions", {}, {}, {}});
    drawn.emplace_back(GroupEnd{});
    figure.marks.insert(figure.marks.begin() + static_cast<std::ptrdiff_t>(end_of_layers(figure.marks)),
                        std::make_move_iterator(drawn.begin()), std::make_move_iterator(drawn.end()));
    drawn.clear();
    figure.move(-figure.box.min.x, -figure.box.min.y);
}

std::set<GroupId> dimensions_of(const Figure& figure) {
    std::set<GroupId> ids;
    for (const Mark& mark : figure.marks)
        if (const auto* group = std::get_if<GroupBegin>(&mark); group != nullptr && group->cls == "dimension")
            ids.insert(group->id);
    return ids;
}

void keep_dimensions(Sketch& sketch, const Figure& figure) {
    std::vector<Mark>& kept = sketch.dimensions;
    for (std::size_t i = 0; i < figure.marks.size(); ++i) {
        const auto* group = std::get_if<GroupBegin>(&figure.marks[i]);
        if (group == nullptr || group->cls != "dimension") continue;
        const auto first = figure.marks.begin() + static_cast<std::ptrdiff_t>(i);
        kept.insert(kept.end(), first,
                    figure.marks.begin() + static_cast<std::ptrdiff_t>(end_of_mark(figure.marks, i)));
    }
    move(kept, -figure.origin.x, -figure.origin.y);
}

std::set<GroupId> covered_dimensions(const Figure& figure, const Fonts& fonts) {
    InkMap others(figure.box);
    std::vector<DimensionText> texts;
    std::vector<DimensionPath> paths;
    GroupId dimension;  // whose group is open
    int dimension_depth = 0, depth = 0;
    for (const Mark& mark : figure.marks) {
        if (const auto* group = std::get_if<GroupBegin>(&mark)) {
            ++depth;
            if (dimension_depth == 0 && group->cls == "dimension") {
                dimension_depth = depth;
                dimension = group->id;
            }
        }
        if (std::holds_alternative<GroupEnd>(mark)) {
            if (dimension_depth == depth) dimension_depth = 0;
            --depth;
        }
        if (const auto* text = std::get_if<TextMark>(&mark); text && dimension_depth > 0)
            if (const auto ink = ink_of(*text, fonts)) texts.push_back({ink->grown(0.3), dimension});
        if (const auto* path = std::get_if<Path>(&mark)) {
            if (dimension_depth > 0)
                paths.push_back({path, dimension});
            else
                others.ink(*path);
        }
    }
    std::set<GroupId> covered;
    for (const DimensionText& text : texts) {
        InkMap of_other_dimensions(figure.box);
        for (const DimensionPath& path : paths)
            if (path.dimension != text.dimension && !covered.contains(path.dimension))
                of_other_dimensions.ink(*path.path);
        if (others.touches(text.box) || of_other_dimensions.touches(text.box)) covered.insert(text.dimension);
    }
    return covered;
}

}  // namespace kinegraph::render::drawing
