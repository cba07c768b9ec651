// The plan of a truss: its spaces in Bow's notation, and their corners in the force plane (Cremona, Le figure
// reciproche nella statica grafica, 1872; Maxwell 1864). Finds the regions between bars and lines of forces, and the
// corners. All forces are inputs.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "constructions/statics/force_model.hpp"
#include "engine/solution/truss.hpp"

namespace kinegraph::statics {

/// An external force on the truss, as stored on the board.
struct OuterForce {
    Truss::External told;
    Force force;
    Quantity quantity;
};

class TrussPlan {
public:
    /// `loaded`: pins with external forces.
    TrussPlan(Board& board, const TrussStructure& truss, const std::vector<int>& loaded);

    /// Whether there is a plan: the bars are connected and do not cross, and external forces act on the border.
    bool exists() const { return exists_; }
    /// Why there is none: the first bars that cross, or the first pin with an external force that is not on the border.
    /// Neither: the bars are not connected.
    const std::optional<std::pair<int, int>>& crossing() const { return crossing_; }
    std::optional<int> inside() const { return inside_; }
    /// Draws the spaces, and the polygon of the forces with each bar once. `pulls`: of each bar on the first of its
    /// pins. `opening`: the statement with the given external forces.
    void draw(Truss& truss, std::vector<OuterForce> outer, const std::vector<std::optional<Force>>& pulls,
              StatementIndex opening);

private:
    using Ray = VectorOn<Plane::drawing>;
    /// Bar b from its first pin: 2·b; from its second: 2·b + 1.
    using HalfBar = int;

    PlaceOnDrawing place(int pin) { return board_.place(truss_.pins[at(pin)].point); }
    int tail(HalfBar half) const { return truss_.bars[at(half / 2)].pins[at(half % 2)]; }
    int head(HalfBar half) const { return truss_.bars[at(half / 2)].pins[at(1 - half % 2)]; }
    Ray ray(HalfBar half) { return board_.vector(place(tail(half)), place(head(half))); }
    bool hangs_together() const;
    bool cross(int bar, int other);
    bool any_cross();
    bool are_on_border(const std::vector<int>& loaded);
    void order_round_pins();
    bool comes_first(Ray from, Ray a, Ray b, int sense);
    int extreme_pin();
    void walk_faces();
    std::vector<OuterForce> in_order(std::vector<OuterForce> outer);
    Ray ray_of(const OuterForce& force, std::size_t corner);
    void name_spaces(Truss& truss, const std::vector<OuterForce>& outer);
    void draw_sides(Truss& truss, const std::vector<OuterForce>& outer, const std::vector<std::optional<Force>>& pulls,
                    StatementIndex opening);

    Board& board_;
    const TrussStructure& truss_;
    std::optional<std::pair<int, int>> crossing_;
    std::optional<int> inside_;
    std::vector<std::vector<HalfBar>> round_;  ///< by pin: its bars counter-clockwise from −x
    std::vector<HalfBar> border_;              ///< clockwise around the truss
    std::vector<int> face_;                    ///< by half bar: face on its left; 0: outside
    int faces_ = 1;
    bool exists_ = false;
};

}  // namespace kinegraph::statics
