// What dimensions keep off, and what a place for one costs. Owns the prices; draws nothing.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "render/mechanism/sketch.hpp"
#include "render/page/label_boxes.hpp"

namespace kinegraph::render::drawing {

/// The layers that dimensions keep off, those of a sketch or those of a figure made of it.
struct DrawnLayers {
    std::span<const Mark> construction, ground, bodies, pins, arrows, centres;
};

/// What a try would draw. Most are priced and never drawn.
struct DimensionTrial {
    std::function<void(std::vector<Mark>&)> draw;
    std::vector<Bar> strokes;
    std::vector<Bar> extensions;
    Spot text_at;
    double text_angle = 0;
    double price = 0;
};

/// Where a mark ends, or the group that it begins.
std::size_t end_of_mark(std::span<const Mark> marks, std::size_t first);

/// The room round the mechanism, with all that stands there.
class DimensionRoom {
public:
    static constexpr double cap_height = 2.1;  ///< of a text, mm

    /// Before there are names. `size`: of the room for all that is drawn.
    DimensionRoom(const Sketch& sketch, Spot size, const DimensionWish& wish);
    /// Beside all that a finished figure of the sketch has, its names and its scale bar among it.
    DimensionRoom(const Sketch& sketch, const Figure& figure, Spot size, const DimensionWish& wish);

    /// What a trial with a text so wide costs at such a place; `ends` are the measured points. Nothing is taken off a
    /// price: from `enough` on it is no longer added to.
    double price_of(const DimensionTrial& trial, double width, const std::array<Spot, 2>& ends, double enough) const;
    /// The others keep off what was drawn.
    void take(const DimensionTrial& drawn, double width);

private:
    /// What a dimension should keep off, with the box round it, which tells of most that they are far away.
    struct Obstacle {
        Bar bar;
        Box box = box_round(bar);
    };
    /// What each thing costs that is nearer than a distance.
    struct Rate {
        double price, distance;
    };

    /// A mark in the way: links, pins, ground and arrows always, construction lines for the figures.
    void keep_off(const DrawnLayers& layers);
    /// Its layers; names with their leaders, scale bar and all that stands in no layer are taken.
    void keep_off_all_of(const Figure& figure);
    static Box box_round(const Bar& bar);
    /// Leaders and bars; of the number of a link the whole circle.
    void keep_off_beside_layers(std::span<const Mark> marks);
    static std::span<const Mark>* layer_of(DrawnLayers& layers, std::string_view role);
    void add(std::span<const Mark> marks, std::vector<Obstacle>& to) const;
    /// Signed gap between a bar and obstacles: how many are nearer than `gap`.
    static int count_near(const Bar& bar, const std::vector<Obstacle>& obstacles, double gap,
                          const std::array<Spot, 2>& except);
    int count_letters_near(const Bar& bar) const;
    static bool crosses(const Bar& a, const Bar& b);
    /// The box grown by what a trial draws.
    static Box with(Box box, const DimensionTrial& trial, double width);
    double toll(const Bar& bar, Rate heavy, Rate light, Rate taken, const std::array<Spot, 2>& ends) const;
    double toll(const Bar& bar, const std::vector<Obstacle>& heavy_bars, Rate heavy, Rate light, Rate taken,
                const std::array<Spot, 2>& ends) const;
    bool stays_within(const DimensionTrial& trial, double width) const;
    static Box box_of_frame(const DimensionTrial& trial, double width);
    /// The text's outline as bars about its middle.
    static std::array<Bar, 3> frame_of(Spot baseline_middle, double angle, double width);
    double price_of_letters() const { return wish_.sought_far ? 12 : 4; }  ///< nothing may run over them

    static constexpr std::array<Spot, 2> nowhere{{{1e9, 1e9}, {1e9, 1e9}}};

    const Sketch& sketch_;
    Spot size_;
    const DimensionWish& wish_;
    Box box_;        ///< of all that is drawn
    Spot origin_{};  ///< where that of the sketch lies in the figure
    std::vector<Obstacle> heavy_, light_, taken_;
    std::vector<InkBox> letters_;
    std::vector<Obstacle> crossed_;  ///< what extension lines had better not cross
    std::vector<Obstacle> words_;    ///< texts of dimensions that are sought far
    std::vector<Obstacle> led_;      ///< their extension lines, which other lines may cross
};

}  // namespace kinegraph::render::drawing
