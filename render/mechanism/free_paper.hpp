// Free paper: the ink of a sketch drawn so far, to find out where an arrow of motion and its name collide with nothing.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "render/mechanism/sketch.hpp"
#include "render/page/ink_map.hpp"

namespace kinegraph::render::drawing {

/// The ends of the pieces of an arc, from end to end, by which it is measured.
constexpr std::size_t pieces_of_arc = 6;
std::array<Spot, pieces_of_arc + 1> spots_along(const Arc& arc);

class FreePaper {
public:
    FreePaper(const Box& area, std::vector<BodyStroke> strokes)
        : solid_(area), thin_(area), strokes_(std::move(strokes)) {}

    static constexpr std::size_t layers = 8;
    /// Takes the ink of marks added since the last time. Names may extend as far beyond what is drawn as the sketch's
    /// room allows.
    void take_what_is_new(const Sketch& sketch);

    /// Price of an arrow there: of the pieces of it that lie near ink. Thin lines may be crossed. From `enough` on the
    /// result is only a lower bound.
    double price_of(const Arc& arc, double enough) const { return price_of(spots_along(arc), enough); }
    double price_of(const std::array<Spot, pieces_of_arc + 1>& along, double enough) const;
    double price_of(const Bar& bar, double enough) const;
    /// Whether a name there covers nothing and stays in the room.
    bool has_room_for(const InkBox& name) const;

    /// Whether an arrow there may belong to a body other than its own: that is as near, even if its own were nearer by
    /// this factor.
    bool seems_of_another(const std::array<Spot, 3>& along, const std::vector<BodyIndex>& own, double factor = 1) const;
    /// Whether a body other than these lies between a place and an arrow that belongs to it.
    bool is_cut_off(Spot place, Spot arrow, const std::vector<BodyIndex>& own) const;

    /// How far a name extends beyond what is drawn, horizontally and vertically, mm.
    double beyond_all(const InkBox& name) const;
    /// Where a name covers nothing, on some side of a spot.
    std::optional<InkBox> room_about(Spot spot, const InkBox& name) const;

    void take(const Arc& arc);
    void take(const Bar& bar);
    /// Reserves the place of a name.
    void take(const InkBox& name);

private:
    double price_of_pieces(const auto& along, double enough) const;

    InkMap solid_, thin_;
    std::vector<BodyStroke> strokes_;
    std::array<std::size_t, layers> taken_{};  // marks of each layer
    Box drawn_, room_;
    std::optional<Box> reserved_{};  // by names
};

/// That of a sketch, with all that has been drawn.
FreePaper& paper_of(Sketch& sketch);

}  // namespace kinegraph::render::drawing
