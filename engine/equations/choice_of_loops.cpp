#include "engine/equations/choice_of_loops.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>

#include "engine/number/geometry.hpp"

namespace kinegraph::vector_loops {

void ChoiceOfLoops::choose_loops() {
    GraphEdges graph;
    for (const Edge& edge : graph_.edges) graph.push_back({edge.carrier.number(), edge.rider.number()});
    std::set<int> known;
    for (std::size_t c = 0; c < graph_.classes.size(); ++c)
        if (graph_.classes[c].driver >= 0) known.insert(key_of_class(static_cast<int>(c)));
    for (std::size_t e = 0; e < graph_.edges.size(); ++e)
        if (graph_.edges[e].driver >= 0) known.insert(key_of_edge(static_cast<int>(e), 0));
    roll_on(known);
    const auto cost = [&](const ClosedWalk& cycle) -> std::array<int, 4> {
        const std::set<int> keys = keys_of(cycle);
        int open = 0;
        for (const int key : keys) open += known.contains(key) ? 0 : 1;
        const bool driven = open < static_cast<int>(keys.size());
        return {open, cycle.has_node(0) ? 0 : 1, driven ? 0 : 1, static_cast<int>(cycle.edges.size())};
    };
    const auto taken = [&](const ClosedWalk& cycle) {
        write_loop(begun(cycle, known));
        known.merge(keys_of(cycle));
        roll_on(known);
    };
    independent_cycles(static_cast<int>(drawn_.mechanism.bodies.size()), graph, cost, taken);
}

void ChoiceOfLoops::add_turn_keys(std::set<int>& keys, BodyIndex body) const {
    for (int each = graph_.class_of(body); each > 0; each = graph_.classes[at_index(each)].against)
        keys.insert(key_of_class(each));
}

std::set<int> ChoiceOfLoops::keys_of(const ClosedWalk& cycle) {
    std::set<int> keys;
    for (std::size_t k = 0; k < cycle.nodes.size(); ++k) {
        const BodyIndex body(cycle.nodes[k]);
        const int e = cycle.edges[k];
        Edge& out = graph_.edges[at_index(e)];
        Edge& in = graph_.edges[at_index(cycle.edges[(k + cycle.edges.size() - 1) % cycle.edges.size()])];
        if (out.kind != Edge::Kind::pin) {
            keys.insert(key_of_edge(e, 0));
            if (out.is_unsupported) keys.insert(key_of_edge(e, 1));
            if (out.kind == Edge::Kind::guide) add_turn_keys(keys, out.carrier);
        }
        const auto &from = in.end_on(body), &to = out.end_on(body);
        if (from && to && !(*from == *to)) add_turn_keys(keys, body);
    }
    return keys;
}

std::set<int> ChoiceOfLoops::keys_of(const Rolling& rolling) const {
    std::set<int> keys;
    if (rolling.edge >= 0) keys.insert(key_of_edge(rolling.edge, 0));
    if (rolling.rack != none)
        for (std::size_t e = 0; e < graph_.edges.size(); ++e)
            if (graph_.edges[e].joint == rolling.rack) keys.insert(key_of_edge(static_cast<int>(e), 0));
    add_turn_keys(keys, rolling.rider);
    add_turn_keys(keys, rolling.carrier);
    if (rolling.arm != none) add_turn_keys(keys, rolling.arm);
    return keys;
}

void ChoiceOfLoops::roll_on(std::set<int>& known) const {
    for (bool more = true; more;) {
        more = false;
        for (const Rolling& rolling : graph_.rollings) {
            std::vector<int> open;
            for (const int key : keys_of(rolling))
                if (!known.contains(key)) open.push_back(key);
            if (open.size() != 1) continue;
            known.insert(open.front());
            more = true;
        }
    }
}

ClosedWalk ChoiceOfLoops::begun(const ClosedWalk& cycle, const std::set<int>& known) const {
    const auto is_known = [&](int node) {
        return node == 0 || known.contains(key_of_class(graph_.class_indices[at_index(node)]));
    };
    int start = cycle.nodes.front();
    for (const int node : cycle.nodes)
        if (node == 0 || (start != 0 && is_known(node) && !is_known(start))) start = node;
    ClosedWalk forth = cycle.from(start), back = forth.reversed();
    const auto rank = [&](const ClosedWalk& each) { return std::pair(!is_known(each.nodes[1]), each.nodes[1]); };
    return rank(back) < rank(forth) ? back : forth;
}

void ChoiceOfLoops::set_ends(const ClosedWalk& cycle) {
    const std::size_t n = cycle.nodes.size();
    const auto ends = [&](std::size_t k) {
        const BodyIndex body(cycle.nodes[k]);
        Edge &in = graph_.edges[at_index(cycle.edges[(k + n - 1) % n])], &out = graph_.edges[at_index(cycle.edges[k])];
        return std::tuple<Edge&, Edge&, std::optional<Vector>&, std::optional<Vector>&>(in, out, in.end_on(body),
                                                                                        out.end_on(body));
    };
    for (std::size_t k = 0; k < n; ++k) {
        auto [in, out, from, to] = ends(k);
        if (from && !to) to = from;
        if (to && !from) from = to;
    }
    for (std::size_t k = 0; k < n; ++k) {
        auto [in, out, from, to] = ends(k);
        if (from || to) continue;
        const auto line_of = [](const Edge& edge) {
            return edge.base ? *edge.base : edge.head ? *edge.head : edge.place;
        };
        const Exact turned = cross(in.along, out.along);
        if (drawn_.is_small(turned)) {
            from = to = in.place;
            continue;
        }
        from = to = finite_meet(finite_line_through(point_at(line_of(in)), in.along),
                                finite_line_through(point_at(line_of(out)), out.along))
                        .place();
    }
}

void ChoiceOfLoops::write_loop(const ClosedWalk& cycle) {
    set_ends(cycle);
    Equations::Loop loop;
    std::vector<Side> left, right;
    const std::size_t n = cycle.nodes.size();
    for (std::size_t k = 0; k < n; ++k) {
        const BodyIndex body(cycle.nodes[k]);
        Edge& out = graph_.edges[at_index(cycle.edges[k])];
        loop.through.push_back(out.name);
        if (k > 0) {
            const Vector from = *graph_.edges[at_index(cycle.edges[k - 1])].end_on(body), to = *out.end_on(body);
            const bool ends_on_frame = out.kind == Edge::Kind::pin && cycle.nodes[(k + 1) % n] == 0;
            if (auto side = letters_.side_of(body, ends_on_frame ? to : from, ends_on_frame ? from : to)) {
                side->on_the_right = ends_on_frame;
                (ends_on_frame ? right : left).push_back(*std::move(side));
            }
        }
        pass(out, body == out.carrier, left, right);
    }
    const BodyIndex start(cycle.nodes.front());
    Edge &first = graph_.edges[at_index(cycle.edges.front())], &last = graph_.edges[at_index(cycle.edges.back())];
    if (auto side = letters_.side_of(start, *first.end_on(start), *last.end_on(start))) {
        side->on_the_right = true;
        right.push_back(*std::move(side));
    }
    std::reverse(right.begin(), right.end());
    loop.sides = std::move(left);
    loop.sides.insert(loop.sides.end(), std::make_move_iterator(right.begin()), std::make_move_iterator(right.end()));
    found_.loops.push_back(std::move(loop));
}

void ChoiceOfLoops::pass(Edge& edge, bool forth, std::vector<Side>& left, std::vector<Side>& right) {
    letters_.give_letters(edge);
    if (forth) {
        left.insert(left.end(), edge.sides.begin(), edge.sides.end());
        return;
    }
    const auto first = right.insert(right.end(), edge.sides.rbegin(), edge.sides.rend());
    std::for_each(first, right.end(), [](Side& side) { side.on_the_right = true; });
}

}  // namespace kinegraph::vector_loops
