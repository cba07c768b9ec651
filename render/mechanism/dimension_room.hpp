// Obstacles for dimensions, and the price of a place for one. Owns the prices; draws nothing.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "render/mechanism/sketch.hpp"
#include "render/page/label_boxes.hpp"

namespace kinegraph::render::drawing {

/// The layers that dimensions keep clear of: those of a sketch, or of a figure made from it.
struct DrawnLayers {
    std::span<const Mark> construction, ground, bodies, pins, arrows, centres;
};

/// A candidate for a dimension. Most candidates are priced and never drawn.
struct DimensionTrial {
    std::function<void(std::vector<Mark>&)> draw;
    std::vector<Bar> strokes;
    std::vector<Bar> extensions;
    Spot text_at;
    double text_angle = 0;
    double price = 0;
};

/// Index past a mark, or past the group that begins there.
std::size_t end_of_mark(std::span<const Mark> marks, std::size_t first);

/// The space round the mechanism, with all obstacles in it.
class DimensionRoom {
public:
    static constexpr double cap_height = 2.1;  ///< height of capital letters, mm

    /// Before labels are placed. `size`: available width and height for the whole drawing, mm.
    DimensionRoom(const Sketch& sketch, Spot size, const DimensionWish& wish);
    /// For a finished figure of the sketch, including its labels and its scale bar.
    DimensionRoom(const Sketch& sketch, const Figure& figure, Spot size, const DimensionWish& wish);

    /// Price of a candidate with a text `width` mm wide; `ends` are the measured points. Prices only increase, so the
    /// sum stops at `enough`.
    double price_of(const DimensionTrial& trial, double width, const std::array<Spot, 2>& ends, double enough) const;
    /// Makes a drawn dimension an obstacle for the following ones.
    void take(const DimensionTrial& drawn, double width);

private:
    /// An obstacle with its bounding box, which excludes most obstacles quickly.
    struct Obstacle {
        Bar bar;
        Box box = box_round(bar);
    };
    /// The price of each obstacle nearer than a distance (mm).
    struct Rate {
        double price, distance;
    };

    /// Adds layers as obstacles: links, pins, ground and arrows always, construction lines for the figures only.
    void keep_off(const DrawnLayers& layers);
    /// Adds all marks of a figure: its layers, and as `taken_` its labels with their leaders, the scale bar and
    /// everything outside the layers.
    void keep_off_all_of(const Figure& figure);
    static Box box_round(const Bar& bar);
    /// Adds leaders and bars; for the number of a link, the whole circle.
    void keep_off_beside_layers(std::span<const Mark> marks);
    static std::span<const Mark>* layer_of(DrawnLayers& layers, std::string_view role);
    void add(std::span<const Mark> marks, std::vector<Obstacle>& to) const;
    /// The number of obstacles whose gap to the bar is less than `gap` mm.
    static int count_near(const Bar& bar, const std::vector<Obstacle>& obstacles, double gap,
                          const std::array<Spot, 2>& except);
    int count_letters_near(const Bar& bar) const;
    static bool crosses(const Bar& a, const Bar& b);
    /// The box enlarged by what a candidate draws.
    static Box with(Box box, const DimensionTrial& trial, double width);
    double toll(const Bar& bar, Rate heavy, Rate light, Rate taken, const std::array<Spot, 2>& ends) const;
    double toll(const Bar& bar, const std::vector<Obstacle>& heavy_bars, Rate heavy, Rate light, Rate taken,
                const std::array<Spot, 2>& ends) const;
    bool stays_within(const DimensionTrial& trial, double width) const;
    static Box box_of_frame(const DimensionTrial& trial, double width);
    /// The outline of the text as bars, about its middle.
    static std::array<Bar, 3> frame_of(Spot baseline_middle, double angle, double width);
    double price_of_letters() const { return wish_.sought_far ? 12 : 4; }  ///< letters must stay uncovered

    static constexpr std::array<Spot, 2> nowhere{{{1e9, 1e9}, {1e9, 1e9}}};

    const Sketch& sketch_;
    Spot size_;
    const DimensionWish& wish_;
    Box box_;        ///< bounding box of the drawing
    Spot origin_{};  ///< position of the sketch's origin in the figure
    std::vector<Obstacle> heavy_, light_, taken_;
    std::vector<InkBox> letters_;
    std::vector<Obstacle> crossed_;  ///< obstacles that extension lines should not cross
    std::vector<Obstacle> words_;    ///< texts of dimensions placed by the extended search (DimensionWish::sought_far)
    std::vector<Obstacle> led_;      ///< extension lines of these, which other lines may cross
};

}  // namespace kinegraph::render::drawing
