#include "engine/equations/open_chains.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "engine/equations/equations_values.hpp"

namespace kinegraph::vector_loops {

void OpenChains::write_reaches() {
    const std::vector<int> by = reached_by();
    std::vector<int> touching(drawn_.mechanism.bodies.size(), 0);
    for (const Edge& edge : graph_.edges) ++touching[at_index(edge.carrier)], ++touching[at_index(edge.rider)];
    for (const BodyIndex body : drawn_.mechanism.moving_bodies()) {
        if (touching[at_index(body)] != 1 || by[at_index(body)] < 0) continue;
        const Vector anchor = *graph_.edges[at_index(by[at_index(body)])].end_on(body);
        PointIndex tip = none;
        Exact farthest;
        for (const PointIndex point : drawn_.mechanism.body(body).points) {
            const Exact reach = squared_length(drawn_.pose.at(point) - anchor);
            if (reach > farthest) tip = point, farthest = reach;
        }
        if (tip == none || drawn_.is_nothing(square_root(farthest, 64).value)) continue;
        write_reach(body, tip, by);
    }
}

void OpenChains::find_motions() {
    const std::vector<int> by = reached_by();
    found_.bodies.resize(drawn_.mechanism.bodies.size());
    for (const BodyIndex body : indices_of(drawn_.mechanism.bodies)) turn_of_body(body);
    Equations::BodyState& ground = found_.bodies.front();
    ground.velocity = ground.acceleration = std::array<double, 2>{0, 0};
    std::vector<bool> done(by.size(), false);
    done.front() = true;
    for (bool more = true; more;) {
        more = false;
        for (const BodyIndex body : drawn_.mechanism.moving_bodies()) {
            if (done[at_index(body)] || by[at_index(body)] < 0) continue;
            Edge& edge = graph_.edges[at_index(by[at_index(body)])];
            const BodyIndex other = edge.carrier == body ? edge.rider : edge.carrier;
            if (!done[at_index(other)]) continue;
            carry_over(edge, other, body);
            done[at_index(body)] = more = true;
        }
    }
}

std::vector<int> OpenChains::reached_by() const {
    std::vector<int> by(drawn_.mechanism.bodies.size(), -1);
    std::vector<bool> reached(by.size(), false);
    reached.front() = true;
    for (bool more = true; more;) {
        more = false;
        for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
            const BodyIndex a = graph_.edges[e].carrier, b = graph_.edges[e].rider;
            if (reached[at_index(a)] == reached[at_index(b)]) continue;
            const BodyIndex fresh = reached[at_index(a)] ? b : a;
            by[at_index(fresh)] = static_cast<int>(e);
            reached[at_index(fresh)] = true;
            more = true;
        }
    }
    return by;
}

void OpenChains::write_reach(BodyIndex body, PointIndex tip, const std::vector<int>& by) {
    std::vector<BodyIndex> chain{body};
    while (chain.back() != frame) {
        const Edge& edge = graph_.edges[at_index(by[at_index(chain.back())])];
        chain.push_back(edge.carrier == chain.back() ? edge.rider : edge.carrier);
    }
    std::reverse(chain.begin(), chain.end());
    Equations::Reach reach;
    reach.point = tip;
    reach.body = body;
    for (std::size_t k = 1; k < chain.size(); ++k) {
        Edge& edge = graph_.edges[at_index(by[at_index(chain[k])])];
        const bool forth = edge.carrier == chain[k - 1];
        for (Side side : edge.sides) {
            side.on_the_right = !forth;
            reach.sides.push_back(std::move(side));
        }
        const Vector from = *edge.end_on(chain[k]);
        const Vector to = k + 1 < chain.size() ? *graph_.edges[at_index(by[at_index(chain[k + 1])])].end_on(chain[k])
                                               : drawn_.pose.at(tip);
        if (auto side = letters_.side_of(chain[k], from, to)) reach.sides.push_back(*std::move(side));
    }
    found_.reaches.push_back(std::move(reach));
}

void OpenChains::turn_of_body(BodyIndex body) {
    Equations::BodyState& state = found_.bodies[at_index(body)];
    state.omega = state.alpha = 0.0;
    for (const LetterIndex index : found_.turns[at_index(body)]) {
        const Letter& letter = found_.letter(index);
        state.omega = state.omega && letter.rate ? std::optional(*state.omega + *letter.rate) : std::nullopt;
        state.alpha =
            state.alpha && letter.acceleration ? std::optional(*state.alpha + *letter.acceleration) : std::nullopt;
    }
}

void OpenChains::carry_over(Edge& edge, BodyIndex from, BodyIndex to) {
    const Equations::BodyState& known = found_.bodies[at_index(from)];
    Equations::BodyState& state = found_.bodies[at_index(to)];
    state.reference = *edge.end_on(to);
    auto velocity = known.velocity_of(*edge.end_on(from)), acceleration = known.acceleration_of(*edge.end_on(from));
    const double sign = from == edge.carrier ? 1 : -1;
    for (const Side& side : edge.sides) {
        const auto change = change_of(found_, side);
        for (const std::size_t k : {0U, 1U}) {
            if (velocity && change.first) (*velocity).at(k) += sign * (*change.first).at(k);
            if (acceleration && change.second) (*acceleration).at(k) += sign * (*change.second).at(k);
        }
        if (!change.first) velocity.reset();
        if (!change.second) acceleration.reset();
    }
    state.velocity = velocity;
    state.acceleration = acceleration;
}

}  // namespace kinegraph::vector_loops
