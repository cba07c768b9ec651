#include "tests/support/chains.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>

#include "engine/number/index.hpp"
#include "tests/support/random_drawing.hpp"

namespace kinegraph {

std::vector<int> Chain::neighbours(int link) const {
    std::vector<int> found;
    for (const auto& [a, b] : joints) {
        if (a == link) found.push_back(b);
        if (b == link) found.push_back(a);
    }
    return found;
}

// --- enumeration ---

namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// For each link: the links it is hinged to, as a bit set.
using Adjacency = std::vector<unsigned>;

int degree(const Adjacency& links, int link) { return std::popcount(links[at(link)]); }

/// True if some set of links has no freedom within itself.
bool holds_a_rigid_part(const Adjacency& links) {
    for (unsigned part = 1; part < 1U << links.size(); ++part) {
        const int size = std::popcount(part);
        int ends = 0;
        for (std::size_t link = 0; link < links.size(); ++link) {
            if ((part >> link & 1U) != 0) ends += std::popcount(links[link] & part);
        }
        if (size > 1 && 3 * (size - 1) - ends < 1) return true;  // ends: two for each joint
    }
    return false;
}

/// Calls `found` for every graph with this number of joints whose links have non-increasing degrees of two or more.
void each_graph(Adjacency& links, int link, int joints, const std::function<void(const Adjacency&)>& found) {
    const int count = static_cast<int>(links.size());
    if (link == count) {
        if (joints == 0) found(links);
        return;
    }
    const int later = count - link - 1;
    for (unsigned row = 0; row < 1U << later; ++row) {
        const int added = std::popcount(row);
        const int own = degree(links, link) + added;
        if (added > joints || own < 2 || (link > 0 && own > degree(links, link - 1))) continue;
        links[at(link)] |= row << (link + 1);
        for (int other = link + 1; other < count; ++other)
            if ((row >> (other - link - 1) & 1U) != 0) links[at(other)] |= 1U << link;
        each_graph(links, link + 1, joints - added, found);
        links[at(link)] &= (1U << (link + 1)) - 1;
        for (int other = link + 1; other < count; ++other) links[at(other)] &= ~(1U << link);
    }
}

/// Adds all relabellings of a graph that keep the degree of each link.
void add_namings(const Adjacency& links, std::vector<int>& names, std::set<Adjacency>& all) {
    const std::size_t link = names.size();
    if (link == links.size()) {
        Adjacency named(links.size());
        for (std::size_t a = 0; a < links.size(); ++a)
            for (std::size_t b = 0; b < links.size(); ++b)
                if ((links[a] >> b & 1U) != 0) named[at(names[a])] |= 1U << names[b];
        all.insert(std::move(named));
        return;
    }
    for (int name = 0; at(name) < links.size(); ++name) {
        if (degree(links, name) != degree(links, static_cast<int>(link)) ||
            std::find(names.begin(), names.end(), name) != names.end())
            continue;
        names.push_back(name);
        add_namings(links, names, all);
        names.pop_back();
    }
}

}  // namespace

std::vector<Chain> chains_of(int links) {
    std::vector<Chain> chains;
    std::set<Adjacency> seen;
    Adjacency graph(at(links));
    each_graph(graph, 0, (3 * links - 4) / 2, [&](const Adjacency& found) {
        if (seen.count(found) > 0 || holds_a_rigid_part(found)) return;
        std::vector<int> names;
        add_namings(found, names, seen);
        Chain chain{links, {}};
        for (int a = 0; a < links; ++a)
            for (int b = a + 1; b < links; ++b)
                if ((found[at(a)] >> b & 1U) != 0) chain.joints.emplace_back(a, b);
        chains.push_back(std::move(chain));
    });
    return chains;
}

const std::vector<Chain>& all_chains() {
    static const std::vector<Chain> chains = [] {
        std::vector<Chain> all;
        for (const int links : {4, 6, 8}) {
            for (Chain& chain : chains_of(links)) all.push_back(std::move(chain));
        }
        return all;
    }();
    return chains;
}

const std::vector<Inversion>& all_inversions() {
    static const std::vector<Inversion> inversions = [] {
        std::vector<Inversion> all;
        for (int chain = 0; at(chain) < all_chains().size(); ++chain) {
            const int links = all_chains()[at(chain)].links;
            for (int fixed = 0; fixed < links; ++fixed)
                for (int driven = 0; driven < links; ++driven)
                    if (driven != fixed) all.push_back({chain, fixed, driven});
        }
        return all;
    }();
    return inversions;
}

// --- mechanisms ---

namespace {

/// Draws one inversion. Each step returns false if it finds no place.
class ChainBuilder {
public:
    ChainBuilder(std::uint64_t seed, const Inversion& inversion)
        : random_(seed), gears_(seed + gears_apart), inversion_(inversion), chain_(all_chains()[at(inversion.chain)]) {}

    ChainMechanism run() {
        for (int attempt = 0; attempt < 100; ++attempt) {
            RandomDrawing drawing(random_, random_.chance(15));
            drawing_ = &drawing;
            recipe_ = "chain " + std::to_string(inversion_.chain) + ", frame " + std::to_string(inversion_.frame) +
                      ", driven " + std::to_string(inversion_.driven);
            bodies_.assign(at(chain_.links), -1);
            slides_.clear();
            choose_dissolved();
            choose_meshes();
            if (!draw_joints()) continue;
            drive();
            return {drawing.text(), recipe_, inversion_};
        }
        throw std::runtime_error("a hundred draws, and no place left in any");
    }

private:
    /// Links whose joints are replaced by gears.
    struct Mesh {
        int dissolved = -1;  ///< the link that the gears replace
        int arm = -1, wheel = -1, mate = -1;
    };

    RandomDrawing& draw() { return *drawing_; }
    void note(const std::string& what) { recipe_ += ", " + what; }
    static std::string between(int a, int b) { return std::to_string(a) + "-" + std::to_string(b); }
    bool dissolved(int link) const { return std::find(dissolved_.begin(), dissolved_.end(), link) != dissolved_.end(); }

    /// A link with two joints may be replaced by one pair of two freedoms between its neighbours: that removes a body
    /// and two pairs of one freedom, so the mobility stays the same.
    void choose_dissolved() {
        dissolved_.clear();
        for (int link = 0; link < chain_.links; ++link) {
            if (link == inversion_.frame || link == inversion_.driven || chain_.degree(link) != 2 ||
                !random_.chance(12))
                continue;
            const std::vector<int> ends = chain_.neighbours(link);
            if (std::none_of(ends.begin(), ends.end(), [&](int end) { return dissolved(end); }))
                dissolved_.push_back(link);
        }
    }

    /// If the neighbours of a replaced link have another common neighbour, it may be the arm of two gears.
    void choose_meshes() {
        meshes_.clear();
        for (const int link : dissolved_) {
            const std::vector<int> ends = chain_.neighbours(link);
            for (const int arm : chain_.neighbours(ends[0])) {
                const std::vector<int> held = chain_.neighbours(arm);
                if (arm == link || dissolved(arm) || std::find(held.begin(), held.end(), ends[1]) == held.end())
                    continue;
                if (joins(arm, ends[0]) || joins(arm, ends[1]) || !gears_.chance(60)) continue;
                meshes_.push_back({link, arm, ends[0], ends[1]});
                break;
            }
        }
    }
    bool is_geared(int link) const {
        return std::any_of(meshes_.begin(), meshes_.end(), [&](const Mesh& mesh) { return mesh.dissolved == link; });
    }
    /// True if the joint of two links is part of a gear pair.
    bool joins(int a, int b) const {
        return std::any_of(meshes_.begin(), meshes_.end(), [&](const Mesh& mesh) {
            const int other = a == mesh.arm ? b : b == mesh.arm ? a : -1;
            return other >= 0 && (other == mesh.wheel || other == mesh.mate);
        });
    }

    /// The body of a link, created on first use; the frame exists already.
    int body(int link) {
        int& made = bodies_[at(link)];
        if (made < 0) made = link == inversion_.frame ? 0 : draw().add_body({});
        return made;
    }
    /// Adds a point to a link.
    void carry(int link, int point) {
        std::vector<int>& points = draw().points_of(body(link));
        if (std::find(points.begin(), points.end(), point) == points.end()) points.push_back(point);
    }

    bool draw_joints() {
        for (int link = 0; link < chain_.links; ++link)
            if (!dissolved(link)) body(link);
        std::vector<std::optional<int>> shared(at(chain_.links));
        for (const auto& [a, b] : chain_.joints) {
            if (dissolved(a) || dissolved(b) || joins(a, b)) continue;
            const int kind = random_.whole(1, 100);
            if (kind <= 15) {
                if (!slide(a, b)) return false;
            } else if (kind <= 20) {
                if (!touch(a, b, true)) return false;
            } else if (!hinge(a, b, shared)) {
                return false;
            }
        }
        for (const Mesh& mesh : meshes_)
            if (!gear(mesh)) return false;
        for (const int link : dissolved_) {
            if (is_geared(link)) continue;
            const std::vector<int> ends = chain_.neighbours(link);
            const bool swap = random_.chance(50);
            const int a = ends[swap ? 1 : 0], b = ends[swap ? 0 : 1];
            if (random_.chance(35) ? !touch(a, b, false) : !slot(a, b)) return false;
        }
        for (int link = 0; link < chain_.links; ++link) {
            if (dissolved(link)) continue;
            if (draw().points_of(body(link)).empty() || random_.chance(15)) {
                const auto point = draw().place();
                if (!point) return false;
                carry(link, *point);
            }
        }
        return true;
    }

    /// Sometimes at the place of another hinge of a link with three or more joints: a hinge of three bodies.
    bool hinge(int a, int b, std::vector<std::optional<int>>& shared) {
        std::optional<int> point;
        int holder = a;
        for (const int link : {a, b}) {
            if (!point && shared[at(link)] && random_.chance(50)) {
                point = shared[at(link)];
                shared[at(link)].reset();  // at most three bodies
                holder = link;
                note("triple hinge of " + std::to_string(link));
            }
        }
        if (!point) {
            point = draw().place();
            if (!point) return false;
            const int link = random_.chance(50) ? a : b;
            if (chain_.degree(link) > 2 && random_.chance(20)) shared[at(link)] = point;
        } else {
            shared[at(holder == a ? b : a)].reset();
        }
        carry(a, *point);
        carry(b, *point);
        draw().revolute(*point, body(holder), body(holder == a ? b : a));
        return true;
    }

    bool slide(int a, int b) {
        const auto point = draw().place();
        if (!point) return false;
        const int slider = random_.chance(50) ? a : b, guide = slider == a ? b : a;
        carry(slider, *point);
        if (random_.chance(25)) carry(guide, *point);
        slides_.push_back({slider, guide, draw().prismatic(*point, body(slider), body(guide), draw().any_guide())});
        note(between(slider, guide) + " slides");
        return true;
    }

    bool slot(int pin, int guide) {
        const auto point = draw().place();
        if (!point) return false;
        carry(pin, *point);
        if (random_.chance(50)) {
            draw().pin_slot(*point, body(pin), body(guide), draw().any_guide());
            note("slot " + between(pin, guide));
            return true;
        }
        const auto centre = draw().place();
        if (!centre) return false;
        carry(guide, *centre);
        draw().pin_in_arc(*point, body(pin), body(guide), *centre);
        note("arc " + between(pin, guide));
        return true;
    }

    /// A circle of `a` on a circle or a straight side of `b`, rolling without slip or sliding.
    bool touch(int a, int b, bool rolls) {
        const auto point = draw().given_anywhere(), centre = draw().given_anywhere();
        if (!point || !centre) return false;
        carry(a, *centre);
        std::optional<int> other;
        if (random_.chance(60)) {
            // Beyond the point the circles touch externally, before it one lies inside the other.
            constexpr std::array ratios{-0.6, 0.4, 1.4, 1.7, 2.1};
            other = draw().on_line(*centre, *point, ratios[at(random_.whole(0, 4))]);
            if (!other) return false;
            carry(b, *other);
        }
        if (rolls) {
            draw().rolling(*point, body(a), body(b), *centre, other);
        } else {
            draw().contact(*point, body(a), body(b), *centre, other);
        }
        note(between(a, b) + (rolls ? " rolls" : " touches"));
        return true;
    }

    /// A gear pair of two links on the arm: two wheels, possibly one internal, or a wheel and a rack.
    bool gear(const Mesh& mesh) {
        const auto centre = draw().given_anywhere(), other = draw().given_anywhere();
        if (!centre || !other) return false;
        const int wheel = body(mesh.wheel), mate = body(mesh.mate), arm = body(mesh.arm);
        hold(mesh.arm, mesh.wheel, *centre);
        if (gears_.chance(25)) {
            const auto pitch = draw().given_anywhere();
            if (!pitch) return false;
            carry(mesh.mate, *other);
            slides_.push_back(
                {mesh.mate, mesh.arm, draw().prismatic(*other, mate, arm, draw().tangent(*pitch, *centre))});
            draw().gear(*pitch, wheel, mate, *centre, std::nullopt, arm);
            note(between(mesh.wheel, mesh.mate) + " rack and pinion");
            return true;
        }
        // Between the centres the wheels touch externally, beyond them one is internal.
        constexpr std::array ratios{-0.8, 0.3, 0.4, 0.5, 0.7, 1.6};
        const auto pitch = draw().on_line(*centre, *other, ratios[at(gears_.whole(0, 5))]);
        if (!pitch) return false;
        hold(mesh.arm, mesh.mate, *other);
        draw().gear(*pitch, wheel, mate, *centre, *other, arm);
        note(between(mesh.wheel, mesh.mate) + " geared on " + std::to_string(mesh.arm));
        return true;
    }
    void hold(int arm, int link, int point) {
        carry(arm, point);
        carry(link, point);
        draw().revolute(point, body(arm), body(link));
    }

    /// One driver and one input force or couple, mostly at the same joint: equilibrium is then determined if the motion
    /// is.
    void drive() {
        const int driven = body(inversion_.driven);
        const bool elsewhere = random_.chance(15);
        for (const auto& [slider, guide, joint] : slides_) {
            if ((slider != inversion_.driven && guide != inversion_.driven) || !random_.chance(40)) continue;
            draw().drive_slide(joint);
            if (!elsewhere) draw().balance_in_slide(joint);
            note("driven slide");
            return balance_elsewhere(elsewhere);
        }
        const std::vector<int>& points = draw().points_of(driven);
        if (random_.chance(10)) {
            const int point = points[at(random_.whole(0, static_cast<int>(points.size()) - 1))];
            const Guide along = draw().any_guide();
            draw().drive_point(driven, point, along);
            if (!elsewhere) draw().balance_by_force(driven, point, along);
            note("driven point");
            return balance_elsewhere(elsewhere);
        }
        int seen_from = 0;
        if (random_.chance(25)) seen_from = random_.whole(0, draw().body_count() - 1);
        if (seen_from == driven) seen_from = 0;
        draw().spin(driven, seen_from);
        if (!elsewhere) draw().balance_by_couple(driven, seen_from);
        if (seen_from != 0) note("relative to body " + draw().body_name(seen_from));
        balance_elsewhere(elsewhere);
    }
    void balance_elsewhere(bool wanted) {
        if (wanted) draw().balance_by_couple(random_.whole(1, draw().body_count() - 1), 0);
    }

    struct Slide {
        int slider = -1, guide = -1;  ///< links
        std::string joint;
    };
    static constexpr std::uint64_t gears_apart = 1'000'003;
    Random random_;
    Random gears_;  ///< a separate generator, so that mechanisms without gears are drawn as before
    Inversion inversion_;
    const Chain& chain_;
    RandomDrawing* drawing_ = nullptr;
    std::vector<int> dissolved_;  ///< links
    std::vector<Mesh> meshes_;
    std::vector<int> bodies_;  ///< by link: its body in the drawing
    std::vector<Slide> slides_;
    std::string recipe_;
};

}  // namespace

ChainMechanism random_chain_mechanism(std::uint64_t seed) {
    const std::vector<Inversion>& inversions = all_inversions();
    return ChainBuilder(seed, inversions[seed % inversions.size()]).run();
}

}  // namespace kinegraph
