// Polygons of forces tip to tail: of one body, of bodies taken together, and of all bodies joined at their common
// forces (Cremona). The callers choose the forces and their order.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "constructions/statics/force_model.hpp"

namespace kinegraph::statics {

/// One force of a body's polygon.
struct Side {
    Symbol symbol;
    Force force;
    int bond = -1;         ///< −1: a load
    bool external = true;  ///< a load, or an input force or reaction of the frame
    Quantity quantity;
};

using Corner = PointOn<Plane::force>;

class ForcePolygons {
public:
    ForcePolygons(const ForceModel& model, Board& board) : model_(model), board_(board) {}

    /// Keeps the sides for join_polygons().
    void keep(MemberIndex member, std::vector<Side> sides) { sides_.emplace_back(member, std::move(sides)); }
    /// Draws the sides tip to tail from `start`, with the corners between them. Returns the last tip.
    Corner set_off(int polygon, MemberIndex on, const std::vector<Side>& sides, Corner start, Face& face);
    int add_force_polygon(Polygon::Kind kind, std::string id);
    void draw_side(int polygon, const Side& side, MemberIndex member, Corner tail, Corner tip);
    /// Tip to tail; closes for a body in equilibrium.
    int draw_polygon(MemberIndex member, const std::vector<Side>& sides, const std::string& suffix);
    /// Joins the polygons at their common forces, so that the external forces close.
    void join_polygons();

private:
    /// Draws the sides from `start`, beginning with the one at `from`; the side of the bond `shared` already exists.
    /// Returns the tails of the sides, in their order.
    std::vector<Corner> place_sides(int polygon, MemberIndex member, const std::vector<Side>& sides, std::size_t from,
                                    Corner start, int shared);

    const ForceModel& model_;
    Board& board_;
    std::vector<std::pair<MemberIndex, std::vector<Side>>> sides_;  ///< by member, in the order of solution
};

}  // namespace kinegraph::statics
