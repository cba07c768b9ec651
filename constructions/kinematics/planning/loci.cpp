#include "constructions/kinematics/planning/loci.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>

namespace kinegraph::planning {

void Loci::own_loci(NodeIndex node, BodyIndex except, std::vector<Locus>& loci) {
    const PointIndex point = structure_.node(node).point;
    const std::vector<BodyIndex> bodies = structure_.node(node).bodies;
    for (const BodyIndex body : bodies) {
        if (body == except) continue;
        if (!known_.spin_known(body)) {
            const NodeIndex base = known_.base_of(body, node);
            if (base != none && known_.apart(base, node)) loci.push_back(rotation(body, base, node));
        }
        const std::vector<Slide>& sleeves = structure_.sleeves_of(body);
        for (const Slide& slide : sleeves) add_sleeve(slide, node, point, body, loci);
        for (const Passage& passage : structure_.passages_of(body)) {
            if (passage.own == point) add_passage(passage, node, body, loci);
        }
        for (std::size_t d = 0; d < mechanism_.drivers.size(); ++d) {
            const auto* driven = std::get_if<PointDriver>(&mechanism_.drivers[d]);
            if (driven == nullptr || !use_driver_[d] || driven->body != body || driven->at != point) continue;
            Locus locus;
            locus.kind = Locus::Kind::component;
            locus.body = body;
            locus.node = node;
            locus.driver = static_cast<int>(d);
            loci.push_back(locus);
        }
    }
}

std::vector<Locus> Loci::loci_of(NodeIndex node, BodyIndex except) {
    std::vector<Locus> loci;
    for (const Reached& reached : reached_from(node)) {
        std::vector<Locus> there;
        own_loci(reached.node, reached.node == node ? except : none, there);
        for (Locus& locus : there) {
            // A sleeve of a body with known ω constrains all its points alike, so a carried locus is redundant.
            const bool repeats = std::any_of(reached.carries.begin(), reached.carries.end(), [&](const Carry& carry) {
                return carry.kind == Carry::Kind::image && carry.body == locus.body;
            });
            if (repeats && locus.kind == Locus::Kind::sleeve && !loci.empty()) continue;
            locus.carries = reached.carries;
            loci.push_back(std::move(locus));
        }
    }
    return loci;
}

Locus Loci::rotation(BodyIndex body, NodeIndex base, NodeIndex node) {
    Locus locus;
    locus.kind = Locus::Kind::rotation;
    locus.body = body;
    locus.node = node;
    locus.base = base;
    return locus;
}

NodeIndex Loci::base_on(PointIndex point, BodyIndex other) {
    if (point == none || (thrifty_ && other != frame && structure_.find(point, other) == none)) return none;
    return known_.known_on(point, other);
}

void Loci::add_sleeve(const Slide& slide, NodeIndex node, PointIndex point, BodyIndex body, std::vector<Locus>& loci) {
    const NodeIndex base = base_on(point, slide.other);
    if (base == none || base == node) return;
    Locus locus = past(slide, body, node, base);
    locus.kind = Locus::Kind::sleeve;
    loci.push_back(locus);
}

void Loci::add_passage(const Passage& passage, NodeIndex node, BodyIndex body, std::vector<Locus>& loci) {
    const NodeIndex base = base_on(passage.others, passage.other);
    if (base == none || base == node) return;
    Locus locus = past(passage, body, node, base);
    switch (passage.kind) {
        case Passage::Kind::slot: locus.kind = Locus::Kind::slot; break;
        case Passage::Kind::link:
            locus.kind = Locus::Kind::link;
            locus.inverse = false;  // a link looks the same from both ends
            break;
        case Passage::Kind::tangent: locus.kind = Locus::Kind::tangent; break;
        case Passage::Kind::mesh: locus.kind = Locus::Kind::mesh; break;
    }
    loci.push_back(locus);
}

std::vector<Loci::Reached> Loci::reached_from(NodeIndex node) {
    std::vector<Reached> reached{{node, {}}};
    const auto reach = [&](std::size_t from, Carry::Kind kind, BodyIndex body, JointIndex joint, NodeIndex other) {
        const bool seen =
            std::any_of(reached.begin(), reached.end(), [&](const Reached& r) { return r.node == other; });
        if (seen || known_.known(other)) return;
        Reached next{other, {{kind, body, joint, other, reached[from].node}}};
        next.carries.insert(next.carries.end(), reached[from].carries.begin(), reached[from].carries.end());
        reached.push_back(std::move(next));
    };
    for (std::size_t i = 0; i < reached.size(); ++i) {
        const NodeIndex here = reached[i].node;
        const std::vector<BodyIndex> bodies = structure_.node(here).bodies;
        for (const BodyIndex body : bodies) {
            for (const Rolling& rolling : structure_.rollings_of(body)) {
                if (rolling.point != structure_.node(here).point) continue;
                const NodeIndex other = structure_.find(rolling.point, rolling.other);
                if (other != none) reach(i, Carry::Kind::roll, body, rolling.joint, other);
            }
            if (!known_.spin_known(body) || known_.body_known(body)) continue;
            for (const NodeIndex other : structure_.nodes_of(body)) reach(i, Carry::Kind::image, body, none, other);
        }
    }
    return reached;
}

}  // namespace kinegraph::planning
