#include "engine/equations/laws.hpp"

#include <algorithm>
#include <variant>

namespace kinegraph::vector_loops {

void Laws::write_laws() {
    for (const Rolling& rolling : graph_.rollings) {
        Law law;
        law.kind = drawn_.mechanism.joint(rolling.joint).pair().meshes() ? Law::Kind::gear : Law::Kind::rolling;
        law.joint = rolling.joint;
        if (rolling.straight)
            write_rolling_on_line(law, rolling);
        else
            write_rolling_round(law, rolling);
        std::erase_if(law.parts, [](const Law::Part& part) { return part.sum.empty(); });
        // −(−θ) is θ: a bracket begins without a sign.
        for (Law::Part& part : law.parts) {
            if (std::any_of(part.sum.begin(), part.sum.end(), [](const auto& each) { return each.first > 0; }))
                continue;
            part.sign = -part.sign;
            for (auto& each : part.sum) each.first = 1;
        }
        if (!law.parts.empty() && law.parts.front().sign < 0)
            for (Law::Part& part : law.parts) part.sign = -part.sign;
        if (!law.parts.empty()) found_.laws.push_back(std::move(law));
    }
    for (const int driver : graph_.driven_apart) write_driver(driver);
}

void Laws::add_turn(Law::Part& part, int sign, BodyIndex body) const {
    for (const LetterIndex letter : graph_.classes[at_index(graph_.class_of(body))].letters) {
        const auto same =
            std::find_if(part.sum.begin(), part.sum.end(), [&](const auto& each) { return each.second == letter; });
        if (same != part.sum.end() && same->first == -sign)
            part.sum.erase(same);
        else
            part.sum.emplace_back(sign, letter);
    }
}

void Laws::write_rolling_on_line(Law& law, const Rolling& rolling) {
    const Vector tangent = drawn_.unit(drawn_.pose.tangents[at_index(rolling.joint)]);
    const auto edge = rolling.edge >= 0 ? graph_.edges.begin() + rolling.edge
                                        : std::find_if(graph_.edges.begin(), graph_.edges.end(),
                                                       [&](const Edge& each) { return each.joint == rolling.rack; });
    int sign = dot(edge->along, tangent).sign();
    // A rack carried by the arm moves backwards as the pinion's centre advances along it.
    if (rolling.edge < 0 && edge->rider == rolling.carrier) sign = -sign;
    law.parts.push_back({sign, -1, {{1, edge->slide}}});
    Law::Part turn{rolling.reach.sign() < 0 ? -1 : 1, letters_.radius(rolling.reach, rolling.rider), {}};
    add_turn(turn, 1, rolling.rider);
    add_turn(turn, -1, rolling.carrier);
    law.parts.push_back(std::move(turn));
}

void Laws::write_rolling_round(Law& law, const Rolling& rolling) {
    const auto part = [&](const Exact& reach, BodyIndex body, int sign) {
        if (reach.is_zero()) return;
        Law::Part own{sign * reach.sign(), letters_.radius(reach, body), {}};
        add_turn(own, 1, body);
        if (rolling.edge >= 0)
            own.sum.emplace_back(-1, graph_.edges[at_index(rolling.edge)].direction);
        else
            add_turn(own, -1, rolling.arm);
        law.parts.push_back(std::move(own));
    };
    part(rolling.reach, rolling.rider, 1);
    part(rolling.reach_of_carrier, rolling.carrier, -1);
}

void Laws::write_driver(int index) {
    const Driver& driver = drawn_.mechanism.drivers[at_index(index)];
    Law law;
    law.kind = Law::Kind::driver;
    Law::Part part;
    Letter letter;
    letter.role = Letter::Role::free;
    const Letters::Pair pair = letters_.next_pair();
    if (const auto* spin = std::get_if<SpinDriver>(&driver)) {
        add_turn(part, 1, spin->body);
        add_turn(part, -1, spin->relative_to);
        letter.is_angle = true;
        letter.body = spin->body;
        letter.against = spin->relative_to;
        letter.name = "theta " + drawn_.name_of(spin->body) +
                      (spin->relative_to == frame ? "" : " on " + drawn_.name_of(spin->relative_to));
    } else if (const auto* slide = std::get_if<SlideDriver>(&driver)) {
        const auto edge = std::find_if(graph_.edges.begin(), graph_.edges.end(),
                                       [&](const Edge& each) { return each.joint == slide->joint; });
        if (edge == graph_.edges.end() || edge->slide < 0) return;
        part.sum.emplace_back(1, edge->slide);
        letter.joint = slide->joint;
        letter.name = "s " + drawn_.mechanism.joint(slide->joint).name;
    } else {
        return;
    }
    letter.symbol = letter.is_angle ? pair.angle : pair.length;
    letter.sub = pair.sub;
    const LetterIndex own = letters_.add(std::move(letter));
    apart_.emplace_back(own, index);
    part.sum.emplace_back(-1, own);
    law.parts.push_back(std::move(part));
    found_.laws.push_back(std::move(law));
}

}  // namespace kinegraph::vector_loops
