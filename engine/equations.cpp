// Loops are chosen from the graph of the pairs, each pair giving the vectors by which its bodies stand apart: none at a hinge, a
// slide along a guide and its offset across, the link that stands for a curved slot or for two round profiles. Then letters are
// given out, rows derived, and everything evaluated in Exact on the letters' values, which are good to 2^-bits of the pose.
#include "engine/equations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "engine/closure.hpp"
#include "engine/equations_values.hpp"
#include "engine/loops.hpp"
#include "engine/problem.hpp"

namespace kinegraph {
namespace {

using Letter = Equations::Letter;
using LetterIndex = Equations::LetterIndex;
using Angle = Equations::Angle;
using Side = Equations::Side;
using Law = Equations::Law;

/// Lengths and angles go in pairs, so that a e^{iα} is one vector; e and i are numbers, λ, π, ω and θ mean other things.
constexpr auto letter_pairs = std::to_array<std::pair<const char*, const char*>>({{"a", "alpha"},
                                                                                  {"b", "beta"},
                                                                                  {"c", "gamma"},
                                                                                  {"d", "delta"},
                                                                                  {"f", "phi"},
                                                                                  {"g", "epsilon"},
                                                                                  {"h", "eta"},
                                                                                  {"k", "kappa"},
                                                                                  {"m", "mu"},
                                                                                  {"n", "nu"},
                                                                                  {"q", "chi"},
                                                                                  {"r", "rho"},
                                                                                  {"t", "tau"},
                                                                                  {"u", "zeta"},
                                                                                  {"w", "xi"}});

Vector product(const Vector& a, const Vector& b) { return faced(a, b); }
Vector conjugate(const Vector& a) { return {a.x, -a.y}; }

/// What holds two bodies to each other, as vectors from its carrier to its rider.
struct Edge {
    enum class Kind {
        pin,    ///< no vector
        guide,  ///< a slide along `along` of the carrier, and an offset across it
        link    ///< a length in a direction of its own
    } kind = Kind::pin;
    JointIndex joint = none;
    std::string name;
    BodyIndex carrier = frame, rider = frame;
    Vector along;                      ///< unit, as drawn
    std::optional<Vector> base, head;  ///< its ends on carrier and rider, once they are chosen
    Vector place;                      ///< of the joint
    bool is_loose = false;             ///< the offset, or the link's length, varies too
    int driver = -1;                   ///< drives its slide …
    int sense = 1;                     ///< … in this sense of `along` as it is now
    std::vector<Side> sides{};         ///< once it has letters: carrier → rider
    LetterIndex slide = -1, across = -1, direction = -1, length = -1;

    std::optional<Vector>& end_on(BodyIndex body) { return body == carrier ? base : head; }
};

/// Bodies that turn together, and from which direction their turn is counted.
struct TurningClass {
    std::vector<BodyIndex> bodies;
    int driver = -1;
    int against = -1;             ///< class that the driver counts its turn from; −1: the frame
    std::optional<Vector> datum;  ///< unit: the direction that its letters name
    std::vector<LetterIndex> letters{};
    std::vector<std::pair<Vector, LetterIndex>> others{};  ///< directions of the same bodies, by the given angle that tells them
};

class Writer {
public:
    Writer(const Mechanism& mechanism, const Pose& pose) : mechanism_(mechanism), pose_(pose), size_(pose.size) {
        near_ = std::max(std::ldexp(1.0, -70), 4 * pose.rounding());
    }

    Equations write() {
        if (stands_for_joints(mechanism_))
            return refused({"a problem in place of joints has no loops", "un problema al posto delle coppie non ha maglie"});
        if (mechanism_.joints.empty() || mechanism_.motion)
            return refused({"there are no joints, and so no loops", "non ci sono coppie, quindi nessuna maglia"});
        collect_classes();
        collect_edges();
        if (!found_.why_not.empty()) return std::move(found_);
        hold_what_is_loose();
        take_drivers();
        choose_loops();
        for (Edge& edge : edges_) give_letters(edge);
        write_reaches();
        name_what_is_left();
        write_laws();
        settle_names();
        complete(found_, mechanism_, pose_, rates());
        find_motions();
        return std::move(found_);
    }

private:
    Equations refused(Words why) {
        found_.why_not = std::move(why);
        return std::move(found_);
    }
    bool is_nothing(const Exact& length) const { return std::abs(length.to_double()) <= near_ * size_.to_double(); }
    bool is_small(const Exact& share) const { return std::abs(share.to_double()) <= near_; }
    Vector unit(const Vector& v) const { return unit_along(v, pose_.bits); }
    std::string name_of(BodyIndex body) const { return mechanism_.body(body).name; }

    // --- what turns together --------------------------------------------------------------------------------------------------

    void collect_classes() {
        class_of_.resize(mechanism_.bodies.size());
        for (std::size_t i = 0; i < class_of_.size(); ++i) class_of_[i] = static_cast<int>(i);
        for (const Joint& joint : mechanism_.joints)
            if (joint.pair().holds_rotation)
                for (const BodyIndex body : joint.bodies) unite(class_of(joint.bodies.front()), class_of(body));
        classes_.resize(class_of_.size());
        for (std::size_t i = 0; i < class_of_.size(); ++i) classes_[at_index(class_of_[i])].bodies.emplace_back(i);
        classes_.front().datum = Vector{1, 0};
    }
    int class_of(BodyIndex body) const { return class_of_[at_index(body)]; }
    void unite(int a, int b) {
        for (int& each : class_of_)
            if (each == std::max(a, b)) each = std::min(a, b);
    }

    // --- pairs as edges -------------------------------------------------------------------------------------------------------

    void collect_edges() {
        for (const Joint& joint : mechanism_.joints) {
            if (joint.pair().has_common_point())
                add_pins(joint);
            else if (joint.pair().has_guide())
                add_guide(joint);
            else
                add_contact(joint);
            if (!found_.why_not.empty()) return;
        }
    }
    Edge edge_of(const Joint& joint, Edge::Kind kind, BodyIndex carrier, BodyIndex rider) const {
        Edge edge;
        edge.kind = kind;
        edge.joint = mechanism_.index_of(joint);
        edge.name = joint.name;
        edge.carrier = carrier;
        edge.rider = rider;
        edge.place = pose_.at(joint.point);
        return edge;
    }
    void add_pins(const Joint& joint) {
        const BodyIndex base = joint.connects(frame) ? frame : joint.bodies.front();
        for (const BodyIndex body : joint.bodies) {
            if (body == base) continue;
            Edge edge = edge_of(joint, Edge::Kind::pin, base, body);
            edge.base = edge.head = edge.place;
            edges_.push_back(std::move(edge));
        }
    }
    void add_guide(const Joint& joint) {
        Edge edge = edge_of(joint, joint.arc == none ? Edge::Kind::guide : Edge::Kind::link, joint.bodies[1], joint.bodies[0]);
        if (!joint.pair().holds_rotation) edge.head = edge.place;
        if (joint.arc != none)
            edge.base = pose_.at(joint.arc);
        else
            edge.along = pose_.guide_units[at_index(edge.joint)];
        edges_.push_back(std::move(edge));
    }
    void add_contact(const Joint& joint) {
        const auto sides = sides_of(mechanism_, pose_, joint);
        if (!sides && !joint.pair().holds_tangent && !joint.pair().meshes()) return add_tangent(joint);
        if (!sides) {
            found_.why_not =
                Words("joint {0}: without the \"profiles\" of both bodies its vectors are not known",
                      "coppia {0}: senza i \"profiles\" di entrambi i corpi i suoi vettori non sono noti", joint.name);
            return;
        }
        const auto centre = [&](std::size_t side) {
            return (*sides)[side].centre == none ? pose_.at(joint.point) : pose_.at((*sides)[side].centre);
        };
        const bool straight = (*sides)[0].straight || (*sides)[1].straight;
        const std::size_t round = (*sides)[0].straight ? 1 : 0;
        Edge edge = edge_of(joint, straight ? Edge::Kind::guide : Edge::Kind::link, joint.bodies[1 - round], joint.bodies[round]);
        edge.head = centre(round);
        if (straight)
            edge.along = unit(pose_.tangents[at_index(edge.joint)]);
        else
            edge.base = centre(1 - round);
        if (!straight && is_nothing((*edge.head - *edge.base).x) && is_nothing((*edge.head - *edge.base).y)) {
            found_.why_not =
                Words("joint {0}: the centres of curvature coincide", "coppia {0}: i centri di curvatura coincidono", joint.name);
            return;
        }
        Rolling rolling{edge.joint, -1, joint.bodies[round], joint.bodies[1 - round], (*sides)[round].reach, {}, straight, none};
        if (!straight) rolling.reach_of_carrier = (*sides)[1 - round].reach;
        edge.is_loose = !joint.pair().holds_normal;
        if (edge.is_loose && find_arm(rolling, joint, *edge.head, straight ? std::nullopt : edge.base)) {
            rollings_.push_back(std::move(rolling));
            return;
        }
        if (joint.pair().holds_tangent) {
            rolling.edge = static_cast<int>(edges_.size());
            rollings_.push_back(std::move(rolling));
        }
        edges_.push_back(std::move(edge));
    }

    /// A contact of unknown curvatures: the place on the one body slides along the common tangent on the other, to the first
    /// order.
    void add_tangent(const Joint& joint) {
        Edge edge = edge_of(joint, Edge::Kind::guide, joint.bodies[1], joint.bodies[0]);
        edge.head = edge.place;
        edge.along = unit(pose_.tangents[at_index(edge.joint)]);
        found_.by_tangent.push_back(edge.joint);
        edges_.push_back(std::move(edge));
    }

    /// What rolls, or meshes: the rider's centre at `reach` along the normal from the contact.
    struct Rolling {
        JointIndex joint;
        int edge = -1;  ///< whose slide or direction it drives along
        BodyIndex rider, carrier;
        Exact reach, reach_of_carrier;
        bool straight = false;
        BodyIndex arm;           ///< of gears: it holds both centres, or the centre and the rack's guide
        JointIndex rack = none;  ///< joint between arm and rack
    };
    bool are_pinned_at(BodyIndex a, BodyIndex b, const Vector& place) const {
        return std::any_of(mechanism_.joints.begin(), mechanism_.joints.end(), [&](const Joint& joint) {
            return joint.pair().has_common_point() && joint.connects(a) && joint.connects(b) && pose_.at(joint.point) == place;
        });
    }
    /// A body that holds both centres of a pair of gears, so that it turns with their line; or a pinion's centre and its rack.
    bool find_arm(Rolling& rolling, const Joint& joint, const Vector& centre, const std::optional<Vector>& other) const {
        std::vector<BodyIndex> candidates{joint.arm};
        for (const BodyIndex body : indices_of(mechanism_.bodies)) candidates.push_back(body);
        for (const BodyIndex arm : candidates) {
            const bool holds_rider = arm == rolling.rider || are_pinned_at(arm, rolling.rider, centre);
            if (!holds_rider) continue;
            if (other && (arm == rolling.carrier ? arm != rolling.rider : are_pinned_at(arm, rolling.carrier, *other))) {
                rolling.arm = arm;
                return true;
            }
            if (other) continue;
            for (const Joint& guide : mechanism_.joints) {
                const JointIndex index = mechanism_.index_of(guide);
                if (!guide.pair().is_sleeve() || !guide.connects(arm) || !guide.connects(rolling.carrier)) continue;
                if (!is_small(cross(pose_.guide_units[at_index(index)], unit(pose_.tangents[at_index(rolling.joint)])))) continue;
                rolling.arm = arm;
                rolling.rack = index;
                return true;
            }
        }
        return false;
    }

    /// What no pair joins to the frame has its place as coordinates.
    void hold_what_is_loose() {
        std::vector<int> part(mechanism_.bodies.size());
        for (std::size_t i = 0; i < part.size(); ++i) part[i] = static_cast<int>(i);
        const auto join = [&](const Edge& edge) {
            const int a = part[at_index(edge.carrier)], b = part[at_index(edge.rider)];
            for (int& each : part)
                if (each == std::max(a, b)) each = std::min(a, b);
        };
        for (const Edge& edge : edges_) join(edge);
        for (const BodyIndex body : mechanism_.moving_bodies()) {
            if (part[at_index(body)] == 0) continue;
            Edge edge;
            edge.kind = Edge::Kind::guide;
            edge.name = name_of(body);
            edge.rider = body;
            edge.along = {1, 0};
            edge.is_loose = true;
            const auto& points = mechanism_.body(body).points;
            edge.place = points.empty() ? Vector{} : pose_.at(points.front());
            edge.base = Vector{};
            edge.head = edge.place;
            join(edge);
            edges_.push_back(std::move(edge));
        }
    }

    // --- what is driven -------------------------------------------------------------------------------------------------------

    void take_drivers() {
        for (std::size_t i = 0; i < mechanism_.drivers.size(); ++i)
            std::visit([&](const auto& given) { take(given, static_cast<int>(i)); }, mechanism_.drivers[i]);
    }
    void take(const SpinDriver& driver, int index) {
        const int own = class_of(driver.body), other = class_of(driver.relative_to);
        bool is_chained = false;  // the other's turn is counted from this one
        for (int each = other; each > 0; each = classes_[at_index(each)].against) is_chained = is_chained || each == own;
        TurningClass& turning = classes_[at_index(own)];
        if (own != 0 && own != other && turning.driver < 0 && !is_chained) {
            turning.driver = index;
            turning.against = other == 0 ? -1 : other;
        } else {
            driven_apart_.push_back(index);
        }
    }
    void take(const SlideDriver& driver, int index) {
        for (Edge& edge : edges_)
            if (edge.joint == driver.joint && edge.kind == Edge::Kind::guide && edge.driver < 0) {
                edge.driver = index;
                return;
            }
        driven_apart_.push_back(index);
    }
    /// A point that a slide along the same direction carries is driven by that slide.
    void take(const PointDriver& driver, int index) {
        const Vector along = pose_.driver_units[at_index(index)];
        for (Edge& edge : edges_) {
            if (edge.kind != Edge::Kind::guide || edge.is_loose || edge.driver >= 0 || edge.joint == none) continue;
            if (class_of(edge.carrier) != 0 || class_of(edge.rider) != 0 || edge.carrier != frame) continue;
            const bool carries = edge.rider == driver.body || are_pinned_at(edge.rider, driver.body, pose_.at(driver.at));
            if (!carries || !is_small(cross(edge.along, along))) continue;
            edge.driver = index;
            edge.sense = dot(edge.along, along).sign();
            return;
        }
        Edge edge;
        edge.kind = Edge::Kind::guide;
        edge.name = mechanism_.point(driver.at).name;
        edge.rider = driver.body;
        edge.along = along;
        edge.is_loose = true;
        edge.place = pose_.at(driver.at);
        edge.head = edge.place;
        edge.driver = index;
        edges_.push_back(std::move(edge));
    }
    /// Rates of the drivers by letter.
    std::vector<std::pair<Exact, Exact>> rates() const {
        std::vector<std::pair<Exact, Exact>> all(found_.letters.size());
        const auto set = [&](LetterIndex letter, int driver, int sense) {
            if (letter < 0 || driver < 0) return;
            std::visit(
                [&](const auto& given) {
                    if constexpr (requires { given.omega; })
                        all[at_index(letter)] = {given.omega, given.alpha};
                    else
                        all[at_index(letter)] = {Exact(sense) * given.speed, Exact(sense) * given.acceleration};
                },
                mechanism_.drivers[at_index(driver)]);
        };
        for (const TurningClass& each : classes_)
            if (each.driver >= 0 && !each.letters.empty()) set(each.letters.back(), each.driver, 1);
        for (const Edge& edge : edges_) set(edge.slide, edge.driver, edge.sense);
        for (const auto& [letter, driver] : apart_) set(letter, driver, 1);
        return all;
    }

    // --- loops ----------------------------------------------------------------------------------------------------------------

    /// Coordinates before they have letters: a class's turn, an edge's slide or direction, what is loose of it.
    int key_of_class(int index) const { return index; }
    int key_of_edge(int edge, int which) const { return static_cast<int>(classes_.size()) + 2 * edge + which; }
    void add_turn_keys(std::set<int>& keys, BodyIndex body) const {
        for (int each = class_of(body); each > 0; each = classes_[at_index(each)].against) keys.insert(key_of_class(each));
    }
    std::set<int> keys_of(const ClosedWalk& cycle) {
        std::set<int> keys;
        for (std::size_t k = 0; k < cycle.nodes.size(); ++k) {
            const BodyIndex body(cycle.nodes[k]);
            const int e = cycle.edges[k];
            Edge& out = edges_[at_index(e)];
            Edge& in = edges_[at_index(cycle.edges[(k + cycle.edges.size() - 1) % cycle.edges.size()])];
            if (out.kind != Edge::Kind::pin) {
                keys.insert(key_of_edge(e, 0));
                if (out.is_loose) keys.insert(key_of_edge(e, 1));
                if (out.kind == Edge::Kind::guide) add_turn_keys(keys, out.carrier);
            }
            const auto &from = in.end_on(body), &to = out.end_on(body);
            if (from && to && !(*from == *to)) add_turn_keys(keys, body);
        }
        return keys;
    }
    std::set<int> keys_of(const Rolling& rolling) const {
        std::set<int> keys;
        if (rolling.edge >= 0) keys.insert(key_of_edge(rolling.edge, 0));
        if (rolling.rack != none)
            for (std::size_t e = 0; e < edges_.size(); ++e)
                if (edges_[e].joint == rolling.rack) keys.insert(key_of_edge(static_cast<int>(e), 0));
        add_turn_keys(keys, rolling.rider);
        add_turn_keys(keys, rolling.carrier);
        if (rolling.arm != none) add_turn_keys(keys, rolling.arm);
        return keys;
    }
    /// What rolls on what is known is known.
    void roll_on(std::set<int>& known) const {
        for (bool more = true; more;) {
            more = false;
            for (const Rolling& rolling : rollings_) {
                std::vector<int> open;
                for (const int key : keys_of(rolling))
                    if (!known.contains(key)) open.push_back(key);
                if (open.size() != 1) continue;
                known.insert(open.front());
                more = true;
            }
        }
    }

    void choose_loops() {
        GraphEdges graph;
        for (const Edge& edge : edges_) graph.push_back({edge.carrier.number(), edge.rider.number()});
        std::set<int> known;
        for (std::size_t c = 0; c < classes_.size(); ++c)
            if (classes_[c].driver >= 0) known.insert(key_of_class(static_cast<int>(c)));
        for (std::size_t e = 0; e < edges_.size(); ++e)
            if (edges_[e].driver >= 0) known.insert(key_of_edge(static_cast<int>(e), 0));
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
        independent_cycles(static_cast<int>(mechanism_.bodies.size()), graph, cost, taken);
    }
    /// From the frame, or else a body that is known; the way out leads to what is known, or comes first in the file.
    ClosedWalk begun(const ClosedWalk& cycle, const std::set<int>& known) const {
        const auto is_known = [&](int node) { return node == 0 || known.contains(key_of_class(class_of_[at_index(node)])); };
        int start = cycle.nodes.front();
        for (const int node : cycle.nodes)
            if (node == 0 || (start != 0 && is_known(node) && !is_known(start))) start = node;
        ClosedWalk forth = cycle.from(start), back = forth.reversed();
        const auto rank = [&](const ClosedWalk& each) { return std::pair(!is_known(each.nodes[1]), each.nodes[1]); };
        return rank(back) < rank(forth) ? back : forth;
    }

    /// Where the slides of a loop end on their bodies: at the other joint there; between two slides where their lines cross.
    void set_ends(const ClosedWalk& cycle) {
        const std::size_t n = cycle.nodes.size();
        const auto ends = [&](std::size_t k) {
            const BodyIndex body(cycle.nodes[k]);
            Edge &in = edges_[at_index(cycle.edges[(k + n - 1) % n])], &out = edges_[at_index(cycle.edges[k])];
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
            const auto line_of = [](const Edge& edge) { return edge.base ? *edge.base : edge.head ? *edge.head : edge.place; };
            const Exact turned = cross(in.along, out.along);
            if (is_small(turned)) {
                from = to = in.place;
                continue;
            }
            const Vector p = line_of(in), q = line_of(out);
            from = to = p + (cross(q - p, out.along) / turned) * in.along;
        }
    }

    void write_loop(const ClosedWalk& cycle) {
        set_ends(cycle);
        Equations::Loop loop;
        std::vector<Side> left, right;
        const std::size_t n = cycle.nodes.size();
        for (std::size_t k = 0; k < n; ++k) {
            const BodyIndex body(cycle.nodes[k]);
            Edge& out = edges_[at_index(cycle.edges[k])];
            loop.through.push_back(out.name);
            if (k > 0) {
                const Vector from = *edges_[at_index(cycle.edges[k - 1])].end_on(body), to = *out.end_on(body);
                const bool ends_on_frame = out.kind == Edge::Kind::pin && cycle.nodes[(k + 1) % n] == 0;
                if (auto side = side_of(body, ends_on_frame ? to : from, ends_on_frame ? from : to)) {
                    side->on_the_right = ends_on_frame;
                    (ends_on_frame ? right : left).push_back(*std::move(side));
                }
            }
            pass(out, body == out.carrier, left, right);
        }
        const BodyIndex start(cycle.nodes.front());
        Edge &first = edges_[at_index(cycle.edges.front())], &last = edges_[at_index(cycle.edges.back())];
        if (auto side = side_of(start, *first.end_on(start), *last.end_on(start))) {
            side->on_the_right = true;
            right.push_back(*std::move(side));
        }
        std::reverse(right.begin(), right.end());
        loop.sides = std::move(left);
        loop.sides.insert(loop.sides.end(), std::make_move_iterator(right.begin()), std::make_move_iterator(right.end()));
        found_.loops.push_back(std::move(loop));
    }
    void pass(Edge& edge, bool forth, std::vector<Side>& left, std::vector<Side>& right) {
        give_letters(edge);
        if (forth) {
            left.insert(left.end(), edge.sides.begin(), edge.sides.end());
            return;
        }
        const auto first = right.insert(right.end(), edge.sides.rbegin(), edge.sides.rend());
        std::for_each(first, right.end(), [](Side& side) { side.on_the_right = true; });
    }

    // --- letters --------------------------------------------------------------------------------------------------------------

    struct Pair {
        std::string length, angle, sub;
    };
    Pair next_pair() {
        const std::size_t round = pairs_ / letter_pairs.size();
        const auto& [length, angle] = letter_pairs[pairs_++ % letter_pairs.size()];
        return {length, angle, round == 0 ? "" : std::to_string(round)};
    }
    LetterIndex add(Letter letter) {
        found_.letters.push_back(std::move(letter));
        return static_cast<LetterIndex>(found_.letters.size()) - 1;
    }
    LetterIndex add_length(const Pair& pair, const Exact& length, Letter::Role role = Letter::Role::given) {
        Letter letter;
        letter.symbol = pair.length;
        letter.sub = pair.sub;
        letter.role = role;
        letter.exact = length;
        letter.value = length.to_double();
        return add(std::move(letter));
    }
    LetterIndex add_angle(const Pair& pair, const Vector& direction, Letter::Role role = Letter::Role::given) {
        Letter letter;
        letter.symbol = pair.angle;
        letter.sub = pair.sub;
        letter.is_angle = true;
        letter.role = role;
        letter.unit = direction;
        letter.value = (degrees_of(direction.y, direction.x, pose_.bits) * pi() / 180).to_double();
        return add(std::move(letter));
    }
    /// 0 … 3 where it is a quarter turn or several.
    std::optional<int> quarters_of(const Vector& direction) const {
        if (is_small(direction.y)) return direction.x.sign() > 0 ? 0 : 2;
        if (is_small(direction.x)) return direction.y.sign() > 0 ? 1 : 3;
        return std::nullopt;
    }
    /// A direction that turns with a class, by its letters; a class without a datum counts its turn from it.
    Angle angle_of(int index, const Vector& direction, const Pair& pair) {
        if (index > 0 && !classes_[at_index(index)].datum) set_datum(index, direction, pair);
        TurningClass& turning = classes_[at_index(index)];
        Angle angle{turning.letters, 0};
        const Vector from_datum = product(direction, conjugate(*turning.datum));
        if (const auto quarters = quarters_of(from_datum)) {
            angle.quarters = *quarters;
            return angle;
        }
        for (const auto& [known, letter] : turning.others) {
            const auto quarters = quarters_of(product(direction, conjugate(known)));
            if (!quarters || *quarters == 2) continue;
            angle.letters.push_back(letter);
            angle.quarters = *quarters;
            return angle;
        }
        const LetterIndex letter = add_angle(pair, from_datum);
        turning.others.emplace_back(direction, letter);
        angle.letters.push_back(letter);
        return angle;
    }
    void set_datum(int index, const Vector& direction, const Pair& pair) {
        const int against = classes_[at_index(index)].against;
        Vector base{1, 0};
        std::vector<LetterIndex> letters;
        if (against > 0) {
            if (!classes_[at_index(against)].datum) set_datum(against, some_direction(against), next_pair());
            base = *classes_[at_index(against)].datum;
            letters = classes_[at_index(against)].letters;
        }
        TurningClass& turning = classes_[at_index(index)];
        turning.datum = direction;
        const LetterIndex own = add_angle(pair, product(direction, conjugate(base)),
                                          turning.driver >= 0 ? Letter::Role::free : Letter::Role::dependent);
        Letter& letter = found_.letters[at_index(own)];
        letter.body = turning.bodies.front();
        letter.name = "theta " + name_of(letter.body);
        if (against > 0) {
            letter.against = classes_[at_index(against)].bodies.front();
            letter.name += " on " + name_of(letter.against);
        }
        letters.push_back(own);
        turning.letters = std::move(letters);
    }
    /// From a joint of the class to the farthest of its points.
    Vector some_direction(int index) const {
        Vector best{1, 0};
        Exact farthest;
        for (const BodyIndex body : classes_[at_index(index)].bodies) {
            const auto& points = mechanism_.body(body).points;
            const auto joint = std::find_if(mechanism_.joints.begin(), mechanism_.joints.end(),
                                            [&](const Joint& each) { return each.connects(body); });
            if (joint == mechanism_.joints.end()) continue;
            for (const PointIndex point : points) {
                const Vector reach = pose_.at(point) - pose_.at(joint->point);
                if (squared_length(reach) <= farthest || is_nothing(square_root(squared_length(reach), 64).value)) continue;
                farthest = squared_length(reach);
                best = unit(reach);
            }
        }
        return best;
    }
    std::optional<Side> side_of(BodyIndex body, const Vector& from, const Vector& to) {
        const Vector reach = to - from;
        if (is_nothing(reach.x) && is_nothing(reach.y)) return std::nullopt;
        for (const Side& known : body_sides_)
            if (known.body == body && known.from == from && known.to == to) return known;
        const Pair pair = next_pair();
        Side side;
        side.from = from;
        side.to = to;
        side.body = body;
        side.angle = angle_of(class_of(body), unit(reach), pair);
        side.length = add_length(pair, square_root(squared_length(reach), 2 * pose_.bits).value);
        body_sides_.push_back(side);
        return side;
    }

    void give_letters(Edge& edge) {
        if (edge.kind == Edge::Kind::pin || !edge.sides.empty() || edge.slide >= 0 || edge.direction >= 0) return;
        if (!edge.base) edge.base = edge.is_loose && edge.joint == none ? Vector{} : edge.place;
        if (!edge.head) edge.head = edge.place;
        if (edge.kind == Edge::Kind::link)
            give_link_letters(edge);
        else
            give_guide_letters(edge);
    }
    void give_link_letters(Edge& edge) {
        const Vector reach = *edge.head - *edge.base;
        const Pair pair = next_pair();
        Side side;
        side.from = *edge.base;
        side.to = *edge.head;
        edge.direction = add_angle(pair, unit(reach), Letter::Role::dependent);
        edge.length = add_length(pair, square_root(squared_length(reach), 2 * pose_.bits).value,
                                 edge.is_loose ? Letter::Role::dependent : Letter::Role::given);
        name(edge.direction, "phi ", edge);
        if (edge.is_loose) name(edge.length, "d ", edge);
        side.angle.letters = {edge.direction};
        side.length = edge.length;
        edge.sides = {side};
    }
    void name(LetterIndex index, const char* kind, const Edge& edge) {
        Letter& letter = found_.letters[at_index(index)];
        letter.name = kind + edge.name;
        letter.joint = edge.joint;
        letter.body = edge.rider;
        letter.against = edge.carrier;
    }
    /// So that the slide is positive as drawn: its length is what is written.
    void give_guide_letters(Edge& edge) {
        const Vector reach = *edge.head - *edge.base;
        if (!is_nothing(dot(reach, edge.along)) && dot(reach, edge.along).sign() < 0) {
            edge.along = -edge.along;
            edge.sense = -edge.sense;
        }
        const Pair pair = next_pair();
        Side slide;
        slide.body = edge.carrier;
        slide.angle = angle_of(class_of(edge.carrier), edge.along, pair);
        const bool free_standing = edge.joint == none && edge.driver < 0;
        edge.slide = slide.length =
            add_length(pair, dot(reach, edge.along), edge.driver >= 0 ? Letter::Role::free : Letter::Role::dependent);
        name(edge.slide, free_standing ? "x " : "s ", edge);
        Exact across = dot(reach, quarter_turn(edge.along));
        slide.from = *edge.base;
        if (edge.is_loose || !is_nothing(across)) {
            Side offset = slide;
            offset.angle.quarters = (slide.angle.quarters + (across.sign() < 0 ? 3 : 1)) % 4;
            const Vector up = across.sign() < 0 ? -quarter_turn(edge.along) : quarter_turn(edge.along);
            across = abs(across);
            edge.across = offset.length =
                add_length(next_pair(), across, edge.is_loose ? Letter::Role::dependent : Letter::Role::given);
            if (edge.is_loose) name(edge.across, free_standing ? "y " : "n ", edge);
            offset.to = slide.from = offset.from + across * up;
            edge.sides.push_back(std::move(offset));
        }
        slide.to = *edge.head;
        edge.sides.push_back(std::move(slide));
    }
    void name_what_is_left() {
        for (std::size_t c = 1; c < classes_.size(); ++c)
            if (!classes_[c].bodies.empty() && !classes_[c].datum)
                set_datum(static_cast<int>(c), some_direction(static_cast<int>(c)), next_pair());
        found_.turns.resize(mechanism_.bodies.size());
        for (const BodyIndex body : indices_of(mechanism_.bodies))
            found_.turns[at_index(body)] = classes_[at_index(class_of(body))].letters;
    }

    // --- laws -----------------------------------------------------------------------------------------------------------------

    LetterIndex radius(const Exact& reach, BodyIndex body) {
        for (const auto& [of, known, letter] : radii_)
            if (of == body && is_nothing(known - abs(reach))) return letter;
        Letter letter;
        letter.symbol = "R";
        letter.sub = name_of(body);
        letter.body = body;
        for (const auto& each : radii_)
            if (std::get<0>(each) == body) letter.sub += "'";
        letter.exact = abs(reach);
        letter.value = letter.exact.to_double();
        radii_.emplace_back(body, abs(reach), add(std::move(letter)));
        return std::get<2>(radii_.back());
    }
    /// ± the turn of a body: the letters that add up to it.
    void add_turn(Law::Part& part, int sign, BodyIndex body) const {
        for (const LetterIndex letter : classes_[at_index(class_of(body))].letters) {
            const auto same =
                std::find_if(part.sum.begin(), part.sum.end(), [&](const auto& each) { return each.second == letter; });
            if (same != part.sum.end() && same->first == -sign)
                part.sum.erase(same);
            else
                part.sum.emplace_back(sign, letter);
        }
    }
    void write_laws() {
        for (const Rolling& rolling : rollings_) {
            Law law;
            law.kind = mechanism_.joint(rolling.joint).pair().meshes() ? Law::Kind::gear : Law::Kind::rolling;
            law.joint = rolling.joint;
            if (rolling.straight)
                write_rolling_on_line(law, rolling);
            else
                write_rolling_round(law, rolling);
            std::erase_if(law.parts, [](const Law::Part& part) { return part.sum.empty(); });
            // −(−θ) is θ: what stands in brackets begins without a sign.
            for (Law::Part& part : law.parts) {
                if (std::any_of(part.sum.begin(), part.sum.end(), [](const auto& each) { return each.first > 0; })) continue;
                part.sign = -part.sign;
                for (auto& each : part.sum) each.first = 1;
            }
            if (!law.parts.empty() && law.parts.front().sign < 0)
                for (Law::Part& part : law.parts) part.sign = -part.sign;
            if (!law.parts.empty()) found_.laws.push_back(std::move(law));
        }
        for (const int driver : driven_apart_) write_driver(driver);
    }
    /// κ s + x (θ_i − θ_j) keeps its value, x along n = z×t, s the way of the centre along t (κ = ±1).
    void write_rolling_on_line(Law& law, const Rolling& rolling) {
        const Vector tangent = unit(pose_.tangents[at_index(rolling.joint)]);
        const auto edge = rolling.edge >= 0 ? edges_.begin() + rolling.edge
                                            : std::find_if(edges_.begin(), edges_.end(),
                                                           [&](const Edge& each) { return each.joint == rolling.rack; });
        int sign = dot(edge->along, tangent).sign();
        // A rack that the arm carries moves back as the pinion's centre goes ahead on it.
        if (rolling.edge < 0 && edge->rider == rolling.carrier) sign = -sign;
        law.parts.push_back({sign, -1, {{1, edge->slide}}});
        Law::Part turn{rolling.reach.sign() < 0 ? -1 : 1, radius(rolling.reach, rolling.rider), {}};
        add_turn(turn, 1, rolling.rider);
        add_turn(turn, -1, rolling.carrier);
        law.parts.push_back(std::move(turn));
    }
    /// x_i (θ_i − φ) − x_j (θ_j − φ) keeps its value, φ the direction of the line of centres, or of the arm that carries it.
    void write_rolling_round(Law& law, const Rolling& rolling) {
        const auto part = [&](const Exact& reach, BodyIndex body, int sign) {
            if (reach.is_zero()) return;
            Law::Part own{sign * reach.sign(), radius(reach, body), {}};
            add_turn(own, 1, body);
            if (rolling.edge >= 0)
                own.sum.emplace_back(-1, edges_[at_index(rolling.edge)].direction);
            else
                add_turn(own, -1, rolling.arm);
            law.parts.push_back(std::move(own));
        };
        part(rolling.reach, rolling.rider, 1);
        part(rolling.reach_of_carrier, rolling.carrier, -1);
    }
    /// A driver that finds its coordinate driven already, or held.
    void write_driver(int index) {
        const Driver& driver = mechanism_.drivers[at_index(index)];
        Law law;
        law.kind = Law::Kind::driver;
        Law::Part part;
        Letter letter;
        letter.role = Letter::Role::free;
        const Pair pair = next_pair();
        if (const auto* spin = std::get_if<SpinDriver>(&driver)) {
            add_turn(part, 1, spin->body);
            add_turn(part, -1, spin->relative_to);
            letter.is_angle = true;
            letter.body = spin->body;
            letter.against = spin->relative_to;
            letter.name =
                "theta " + name_of(spin->body) + (spin->relative_to == frame ? "" : " on " + name_of(spin->relative_to));
        } else if (const auto* slide = std::get_if<SlideDriver>(&driver)) {
            const auto edge =
                std::find_if(edges_.begin(), edges_.end(), [&](const Edge& each) { return each.joint == slide->joint; });
            if (edge == edges_.end() || edge->slide < 0) return;
            part.sum.emplace_back(1, edge->slide);
            letter.joint = slide->joint;
            letter.name = "s " + mechanism_.joint(slide->joint).name;
        } else {
            return;
        }
        letter.symbol = letter.is_angle ? pair.angle : pair.length;
        letter.sub = pair.sub;
        const LetterIndex own = add(std::move(letter));
        apart_.emplace_back(own, index);
        part.sum.emplace_back(-1, own);
        law.parts.push_back(std::move(part));
        found_.laws.push_back(std::move(law));
    }

    // --- open chains ----------------------------------------------------------------------------------------------------------

    /// The edge by which each body is reached from the frame.
    std::vector<int> reached_by() const {
        std::vector<int> by(mechanism_.bodies.size(), -1);
        std::vector<bool> reached(by.size(), false);
        reached.front() = true;
        for (bool more = true; more;) {
            more = false;
            for (std::size_t e = 0; e < edges_.size(); ++e) {
                const BodyIndex a = edges_[e].carrier, b = edges_[e].rider;
                if (reached[at_index(a)] == reached[at_index(b)]) continue;
                const BodyIndex fresh = reached[at_index(a)] ? b : a;
                by[at_index(fresh)] = static_cast<int>(e);
                reached[at_index(fresh)] = true;
                more = true;
            }
        }
        return by;
    }
    /// Ends of open chains: bodies that no loop passes and that nothing further hangs on, with their farthest point.
    void write_reaches() {
        const std::vector<int> by = reached_by();
        std::vector<int> touching(mechanism_.bodies.size(), 0);
        for (const Edge& edge : edges_) ++touching[at_index(edge.carrier)], ++touching[at_index(edge.rider)];
        for (const BodyIndex body : mechanism_.moving_bodies()) {
            if (touching[at_index(body)] != 1 || by[at_index(body)] < 0) continue;
            const Vector anchor = *edges_[at_index(by[at_index(body)])].end_on(body);
            PointIndex tip = none;
            Exact farthest;
            for (const PointIndex point : mechanism_.body(body).points) {
                const Exact reach = squared_length(pose_.at(point) - anchor);
                if (reach > farthest) tip = point, farthest = reach;
            }
            if (tip == none || is_nothing(square_root(farthest, 64).value)) continue;
            write_reach(body, tip, by);
        }
    }
    void write_reach(BodyIndex body, PointIndex tip, const std::vector<int>& by) {
        std::vector<BodyIndex> chain{body};
        while (chain.back() != frame) {
            const Edge& edge = edges_[at_index(by[at_index(chain.back())])];
            chain.push_back(edge.carrier == chain.back() ? edge.rider : edge.carrier);
        }
        std::reverse(chain.begin(), chain.end());
        Equations::Reach reach;
        reach.point = tip;
        reach.body = body;
        for (std::size_t k = 1; k < chain.size(); ++k) {
            Edge& edge = edges_[at_index(by[at_index(chain[k])])];
            const bool forth = edge.carrier == chain[k - 1];
            for (Side side : edge.sides) {
                side.on_the_right = !forth;
                reach.sides.push_back(std::move(side));
            }
            const Vector from = *edge.end_on(chain[k]);
            const Vector to =
                k + 1 < chain.size() ? *edges_[at_index(by[at_index(chain[k + 1])])].end_on(chain[k]) : pose_.at(tip);
            if (auto side = side_of(chain[k], from, to)) reach.sides.push_back(*std::move(side));
        }
        found_.reaches.push_back(std::move(reach));
    }

    /// Two coordinates of one name are told by their bodies.
    void settle_names() {
        const std::vector<Letter> before = found_.letters;
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (before[i].name.empty()) continue;
            const auto same =
                std::count_if(before.begin(), before.end(), [&](const Letter& each) { return each.name == before[i].name; });
            if (same < 2) continue;
            Letter& letter = found_.letters[i];
            if (letter.body != none && letter.against != none && letter.joint != none)
                letter.name += " " + name_of(letter.body) + " on " + name_of(letter.against);
            const auto still = std::count_if(found_.letters.begin(), found_.letters.begin() + static_cast<std::ptrdiff_t>(i),
                                             [&](const Letter& each) { return each.name == letter.name; });
            if (still > 0) letter.name += " (" + std::to_string(still + 1) + ")";
        }
    }

    // --- motions of the bodies ------------------------------------------------------------------------------------------------

    void find_motions() {
        const std::vector<int> by = reached_by();
        found_.bodies.resize(mechanism_.bodies.size());
        for (const BodyIndex body : indices_of(mechanism_.bodies)) turn_of_body(body);
        Equations::BodyState& ground = found_.bodies.front();
        ground.velocity = ground.acceleration = std::array<double, 2>{0, 0};
        std::vector<bool> done(by.size(), false);
        done.front() = true;
        for (bool more = true; more;) {
            more = false;
            for (const BodyIndex body : mechanism_.moving_bodies()) {
                if (done[at_index(body)] || by[at_index(body)] < 0) continue;
                Edge& edge = edges_[at_index(by[at_index(body)])];
                const BodyIndex other = edge.carrier == body ? edge.rider : edge.carrier;
                if (!done[at_index(other)]) continue;
                carry_over(edge, other, body);
                done[at_index(body)] = more = true;
            }
        }
    }
    void turn_of_body(BodyIndex body) {
        Equations::BodyState& state = found_.bodies[at_index(body)];
        state.omega = state.alpha = 0.0;
        for (const LetterIndex index : found_.turns[at_index(body)]) {
            const Letter& letter = found_.letter(index);
            state.omega = state.omega && letter.rate ? std::optional(*state.omega + *letter.rate) : std::nullopt;
            state.alpha = state.alpha && letter.acceleration ? std::optional(*state.alpha + *letter.acceleration) : std::nullopt;
        }
    }
    void carry_over(Edge& edge, BodyIndex from, BodyIndex to) {
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

    const Mechanism& mechanism_;
    const Pose& pose_;
    Exact size_;
    double near_ = 0;  ///< what is smaller, of the drawing's size, is nothing
    Equations found_;
    std::vector<int> class_of_;  ///< by body
    std::vector<TurningClass> classes_;
    std::vector<Edge> edges_;
    std::vector<Rolling> rollings_;
    std::vector<int> driven_apart_;                   ///< drivers without a coordinate of their own
    std::vector<std::pair<LetterIndex, int>> apart_;  ///< their letters
    std::vector<Side> body_sides_;
    std::vector<std::tuple<BodyIndex, Exact, LetterIndex>> radii_;
    std::size_t pairs_ = 0;
};

}  // namespace

Equations equations_of(const Mechanism& mechanism, const Pose& pose) { return Writer(mechanism, pose).write(); }

std::optional<std::array<double, 2>> Equations::BodyState::velocity_of(const Vector& place) const {
    if (!velocity || !omega) return std::nullopt;
    const double x = (place.x - reference.x).to_double(), y = (place.y - reference.y).to_double();
    return std::array<double, 2>{(*velocity)[0] - *omega * y, (*velocity)[1] + *omega * x};
}
std::optional<std::array<double, 2>> Equations::BodyState::acceleration_of(const Vector& place) const {
    if (!acceleration || !omega || !alpha) return std::nullopt;
    const double x = (place.x - reference.x).to_double(), y = (place.y - reference.y).to_double(), w2 = *omega * *omega;
    return std::array<double, 2>{(*acceleration)[0] - *alpha * y - w2 * x, (*acceleration)[1] + *alpha * x - w2 * y};
}

std::string spelt(const Equations::Letter& letter) {
    return letter.sub.empty() ? letter.symbol : letter.symbol + "_" + letter.sub;
}

namespace {

std::string spelt(const Equations& equations, const Side& side) {
    constexpr std::array<const char*, 4> turned{"", "i ", "- ", "-i "};
    std::string text = turned.at(static_cast<std::size_t>(side.angle.quarters)) + spelt(equations.letter(side.length));
    std::string angle;
    for (const LetterIndex letter : side.angle.letters) angle += (angle.empty() ? "" : " + ") + spelt(equations.letter(letter));
    if (angle.empty()) return text;
    return text + " e^{i " + (side.angle.letters.size() > 1 ? "(" + angle + ")" : angle) + "}";
}

}  // namespace

std::string spelt(const Equations& equations, const Equations::Loop& loop) {
    std::array<std::string, 2> text;
    for (const Side& side : loop.sides) {
        std::string& own = text.at(side.on_the_right ? 1 : 0);
        const std::string term = spelt(equations, side);
        if (own.empty())
            own = term.starts_with("- ") ? "-" + term.substr(2) : term;
        else if (term.starts_with('-'))
            own += " - " + term.substr(term[1] == ' ' ? 2 : 1);
        else
            own += " + " + term;
    }
    for (std::string& own : text)
        if (own.empty()) own = "0";
    return text[0] + " = " + text[1];
}

std::string spelt(const Equations& equations, const Equations::Law& law) {
    std::string text;
    for (const Equations::Law::Part& part : law.parts) {
        std::string sum;
        for (const auto& [sign, letter] : part.sum)
            sum += (sum.empty() ? (sign < 0 ? "-" : "") : sign < 0 ? " - " : " + ") + spelt(equations.letter(letter));
        text += text.empty() ? (part.sign < 0 ? "-" : "") : part.sign < 0 ? " - " : " + ";
        if (part.radius >= 0) text += spelt(equations.letter(part.radius)) + " ";
        text += part.sum.size() > 1 ? "(" + sum + ")" : sum;
    }
    return text + " = const";
}

}  // namespace kinegraph
