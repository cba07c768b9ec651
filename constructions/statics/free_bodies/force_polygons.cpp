#include "constructions/statics/free_bodies/force_polygons.hpp"

#include <set>

#include "engine/number/assert.hpp"

namespace kinegraph::statics {

int ForcePolygons::add_force_polygon(Polygon::Kind kind, std::string id) {
    Polygon polygon;
    polygon.kind = kind;
    polygon.plane = Plane::force;
    polygon.id = std::move(id);
    return board_.add_polygon(std::move(polygon));
}

Corner ForcePolygons::set_off(int polygon, MemberIndex on, const std::vector<Side>& sides, Corner start, Face& face) {
    Corner here = start;
    for (const Side& side : sides) {
        const Corner next = board_.carry(here, side.force);
        draw_side(polygon, side, on, here, next);
        face.corners.push_back(here.element);
        here = next;
    }
    return here;
}

void ForcePolygons::draw_side(int polygon, const Side& side, MemberIndex member, Corner tail, Corner tip) {
    DrawnVector drawn;
    drawn.symbol = side.symbol;
    drawn.polygon = polygon;
    drawn.tail = tail.element;
    drawn.tip = tip.element;
    drawn.body = model_.body_of(member);
    drawn.quantity = side.quantity;
    drawn.role = side.external ? DrawnVector::Role::external : DrawnVector::Role::internal;
    board_.draw(std::move(drawn));
}

int ForcePolygons::draw_polygon(MemberIndex member, const std::vector<Side>& sides, const std::string& suffix) {
    const int polygon = add_force_polygon(Polygon::Kind::body_forces, "forces-" + model_.member_name(member) + suffix);
    place_sides(polygon, member, sides, 0, board_.pole<Plane::force>(), -1);
    return polygon;
}

void ForcePolygons::join_polygons() {
    std::set<MemberIndex> placed;
    int count = 0;
    for (std::size_t first = 0; first < sides_.size(); ++first) {
        if (placed.count(sides_[first].first) != 0 || sides_.size() < 2) continue;
        const int polygon = add_force_polygon(Polygon::Kind::joined_forces,
                                              count == 0 ? "closure" : "closure-" + std::to_string(count + 1));
        ++count;
        struct Open {
            std::size_t index, from;
            Corner start;
            int shared;
        };
        std::vector<Open> open{{first, 0, board_.pole<Plane::force>(), -1}};
        placed.insert(sides_[first].first);
        for (std::size_t next = 0; next < open.size(); ++next) {
            const Open here = open[next];
            const auto& [member, sides] = sides_[here.index];
            const std::vector<Corner> tails = place_sides(polygon, member, sides, here.from, here.start, here.shared);
            for (std::size_t i = 0; i < sides.size(); ++i) {
                if (sides[i].external) continue;
                const Bond& bond = model_.bonds()[at(sides[i].bond)];
                const MemberIndex other = bond.first == member ? bond.second : bond.first;
                if (placed.count(other) != 0) continue;
                for (std::size_t k = 0; k < sides_.size(); ++k) {
                    if (sides_[k].first != other) continue;
                    const auto& across = sides_[k].second;
                    for (std::size_t m = 0; m < across.size(); ++m) {
                        if (across[m].bond != sides[i].bond) continue;
                        placed.insert(other);
                        open.push_back({k, m, tails[(i + 1) % sides.size()], sides[i].bond});
                    }
                }
            }
        }
    }
}

std::vector<Corner> ForcePolygons::place_sides(int polygon, MemberIndex member, const std::vector<Side>& sides,
                                               std::size_t from, Corner start, int shared) {
    std::vector<Corner> tails(sides.size());
    Face face;
    face.body = model_.body_of(member);
    Corner here = start;
    for (std::size_t n = 0; n < sides.size(); ++n) {
        const std::size_t i = (from + n) % sides.size();
        const Corner next = n + 1 == sides.size() ? start : board_.carry(here, sides[i].force);
        if (n + 1 == sides.size()) {
            KG_ASSERT(board_.coincide(board_.carry(here, sides[i].force), start),
                      "the forces of a body in equilibrium close");
        }
        if (shared < 0 || sides[i].bond != shared) draw_side(polygon, sides[i], member, here, next);
        tails[i] = here;
        face.corners.push_back(here.element);
        here = next;
    }
    board_.add_face(polygon, std::move(face));
    return tails;
}

}  // namespace kinegraph::statics
