#include "constructions/kinematics/instant_centres.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "engine/number/assert.hpp"
#include "engine/sentences/centre_symbol.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph {
namespace {

using Drawing = PointOn<Plane::drawing>;

template <Plane plane>
const Track<plane>& track_of(const Motion& motion) {
    if constexpr (plane == Plane::velocity)
        return motion.velocity;
    else
        return motion.acceleration;
}

/// The sentence for the centre of a pair; none if the pair alone does not determine it.
std::optional<Key> primary_sentence(const PlanePair& pair) {
    if (pair.is_hinge()) return lang::sentences::primary_revolute;
    if (pair.is_clamp()) return lang::sentences::primary_weld;
    if (pair.is_sleeve()) return lang::sentences::primary_prismatic;
    if (pair.meshes()) return lang::sentences::primary_gear;
    if (pair.rolls()) return lang::sentences::primary_rolling;
    return std::nullopt;
}

}  // namespace

InstantCentres::InstantCentres(Structure& structure, Board& board, RelativeRest rest)
    : structure_(structure),
      board_(board),
      rest_(std::move(rest)),
      diagram_(structure, board),
      count_(static_cast<int>(structure.mechanism().bodies.size())) {
    for (const BodyIndex i : indices_of(structure_.mechanism().bodies)) {
        for (const BodyIndex j : structure_.mechanism().bodies_after(i)) {
            Pair entry;
            entry.centre.first = i;
            entry.centre.second = j;
            pairs_.push_back(std::move(entry));
        }
    }
}

std::size_t InstantCentres::index(BodyIndex i, BodyIndex j) const {
    if (i > j) std::swap(i, j);
    // Index in the upper triangle, row by row.
    return at_index(i.number() * (2 * count_ - i.number() - 1) / 2 + (j.number() - i.number() - 1));
}

Symbol InstantCentres::symbol(BodyIndex i, BodyIndex j) {
    if (i > j) std::swap(i, j);
    const Pair& entry = pairs_[index(i, j)];
    return centre_symbol(structure_.mechanism(), i, j, entry.point && board_.is_at_infinity(*entry.point));
}

StatementIndex InstantCentres::say(Key sentence, std::vector<Argument> arguments) {
    Statement statement;
    statement.message = {sentence, std::move(arguments)};
    statement.section = Topic::centres;
    statement.source = "Aronhold–Kennedy";
    return board_.state(std::move(statement));
}

void InstantCentres::settle(Pair& entry, Drawing point, InstantCentre::How how) {
    entry.point = point;
    entry.centre.how = how;
    entry.centre.at = Recorded<ProjectivePoint>::at(point.element);
    entry.centre.order = order_++;
}

void InstantCentres::primary(JointIndex j) {
    const Joint& joint = structure_.mechanism().joints[at_index(j)];
    for (std::size_t a = 0; a < joint.bodies.size(); ++a) {
        for (std::size_t b = a + 1; b < joint.bodies.size(); ++b) primary(j, joint.bodies[a], joint.bodies[b]);
    }
}

void InstantCentres::primary(JointIndex index_of_joint, BodyIndex i, BodyIndex j) {
    const Joint& joint = structure_.mechanism().joints[at_index(index_of_joint)];
    Pair& entry = pair(i, j);
    const PlanePair& known = joint.pair();
    const PlanePair::Centre lies = known.centre();
    if (lies == PlanePair::Centre::on_normal) {
        entry.normals.emplace_back(board_.through(board_.place(joint.point), board_.normal(index_of_joint)),
                                   joint.point);
        return;
    }
    const std::optional<Key> says = primary_sentence(known);
    if (entry.centre.as_one || !says) return;
    const auto names = [&] {
        return std::vector<Argument>{symbol(i, j),
                                     PointName{structure_.mechanism().points[at_index(joint.point)].name}};
    };
    if (lies == PlanePair::Centre::everywhere) {
        entry.centre.everywhere = entry.centre.as_one = true;
        entry.centre.how = InstantCentre::How::primary;
        entry.centre.order = order_++;
        entry.centre.statement = say(*says, names());
        return;
    }
    const auto place = [&] {
        return lies == PlanePair::Centre::at_infinity
                   ? board_.at_infinity(board_.perpendicular(board_.guide(index_of_joint)))
                   : board_.place(joint.point);
    };
    if (entry.point) return;  // two pairs between the same bodies: if their centres differ, the bodies are at rest
    entry.centre.statement = say(*says, {});
    settle(entry, place(), InstantCentre::How::primary);
    board_.statement(entry.centre.statement).message.arguments = names();
}

/// Third bodies over which the pair has a line, since both centres are known points. Finite ones come first, because
/// their line can be drawn.
std::vector<BodyIndex> InstantCentres::intermediates(BodyIndex i, BodyIndex j) {
    std::vector<BodyIndex> finite, infinite;
    for (const BodyIndex k : indices_of(structure_.mechanism().bodies)) {
        if (k == i || k == j) continue;
        const Pair& first = pair(i, k);
        const Pair& second = pair(k, j);
        // Of two bodies that rest in passing, the centre of their pair is that of the neighbouring positions, and the
        // line holds there too. Bodies that move as one have none.
        if (!first.point || !second.point || first.centre.as_one || second.centre.as_one) continue;
        const bool both_finite = !board_.is_at_infinity(*first.point) && !board_.is_at_infinity(*second.point);
        (both_finite ? finite : infinite).push_back(k);
    }
    finite.insert(finite.end(), infinite.begin(), infinite.end());
    return finite;
}

LineOn<Plane::drawing> InstantCentres::line_over(BodyIndex i, BodyIndex k, BodyIndex j) {
    return board_.join(*pair(i, k).point, *pair(k, j).point);
}

LineOn<Plane::drawing> InstantCentres::line_of(BodyIndex i, BodyIndex j, const Line& line) {
    return line.by == none ? pair(i, j).normals[at_index(line.normal)].first : line_over(i, line.by, j);
}

/// The first two lines that meet in one point: normals first, then Kennedy's lines.
std::optional<std::pair<InstantCentres::Line, InstantCentres::Line>> InstantCentres::lines_that_meet(BodyIndex i,
                                                                                                     BodyIndex j) {
    std::vector<Line> lines;
    std::optional<std::pair<Line, Line>> found;
    const auto meets_one = [&](const Line& candidate) {
        for (const Line& earlier : lines) {
            if (!board_.meet(line_of(i, j, earlier), line_of(i, j, candidate))) continue;  // the same line again
            found.emplace(earlier, candidate);
            return true;
        }
        lines.push_back(candidate);
        return false;
    };
    for (std::size_t n = 0; n < pair(i, j).normals.size(); ++n)
        if (meets_one({none, static_cast<int>(n)})) return found;
    for (const BodyIndex k : intermediates(i, j)) {
        if (board_.coincide(*pair(i, k).point, *pair(k, j).point)) continue;
        if (meets_one({k, -1})) return found;
    }
    return std::nullopt;
}

bool InstantCentres::kennedy(BodyIndex i, BodyIndex j) {
    const Board::Mark before = board_.mark();
    const auto lines = lines_that_meet(i, j);
    board_.rewind(before);  // Removes the trials of lines that do not help.
    if (!lines) return false;
    const auto& [first, second] = *lines;
    Pair& entry = pair(i, j);
    entry.centre.statement = say(lang::sentences::kennedy, {});
    settle(entry, *board_.meet(line_of(i, j, first), line_of(i, j, second)), InstantCentre::How::kennedy);
    std::vector<Argument> names{symbol(i, j)}, normals;
    for (const Line& used : {first, second}) {
        if (used.by == none) {
            const PointIndex point = entry.normals[at_index(used.normal)].second;
            entry.centre.normals.push_back(point);
            normals.emplace_back(PointName{structure_.mechanism().points[at_index(point)].name});
        } else {
            entry.centre.through.emplace_back(static_cast<int>(index(i, used.by)), static_cast<int>(index(used.by, j)));
            names.insert(names.end(), {symbol(i, used.by), symbol(used.by, j)});
        }
    }
    const Key sentence = normals.empty()       ? lang::sentences::kennedy
                         : normals.size() == 1 ? lang::sentences::kennedy_line
                                               : lang::sentences::kennedy_two_normals;
    names.insert(names.end(), normals.begin(), normals.end());
    board_.statement(entry.centre.statement).message = {sentence, std::move(names)};
    return true;
}

/// Bodies at rest against each other; the centre of a pair between them is kept. One sentence says it of each group,
/// unless every two of its bodies are a pair, which has its own.
void InstantCentres::mark_rest() {
    std::map<BodyIndex, StatementIndex> said;
    for (Pair& entry : pairs_) {
        InstantCentre& centre = entry.centre;
        const auto same = [&](const std::vector<BodyIndex>& groups) {
            return groups[at_index(centre.first)] == groups[at_index(centre.second)];
        };
        if (!same(rest_.here)) continue;
        centre.everywhere = true;
        centre.as_one = centre.as_one || same(rest_.always);
        if (centre.how != InstantCentre::How::unknown) continue;
        centre.how = InstantCentre::How::rest;
        centre.order = order_++;
        const BodyIndex group = rest_.here[at_index(centre.first)];
        const auto [known, is_new] = said.try_emplace(group, StatementIndex());
        if (is_new) known->second = say(lang::sentences::no_relative_motion, {names_of_group(group)});
        centre.statement = known->second;
    }
}

Names InstantCentres::names_of_group(BodyIndex first) const {
    Names names;
    for (const BodyIndex body : indices_of(structure_.mechanism().bodies))
        if (rest_.here[at_index(body)] == first) names.push_back(structure_.body_name(body));
    return names;
}

bool InstantCentres::by_rigidity(BodyIndex i, BodyIndex j) { return by_relative_rest(i, j, &InstantCentre::as_one); }
bool InstantCentres::by_rest(BodyIndex i, BodyIndex j) { return by_relative_rest(i, j, &InstantCentre::everywhere); }

/// The centre of a body is that of another one which does not move against it.
bool InstantCentres::by_relative_rest(BodyIndex i, BodyIndex j, bool InstantCentre::*rests) {
    Pair& entry = pair(i, j);
    for (const BodyIndex k : indices_of(structure_.mechanism().bodies)) {
        if (k == i || k == j) continue;
        for (const auto& [rigid, other] : {std::pair(index(i, k), index(k, j)), std::pair(index(k, j), index(i, k))}) {
            const Pair& source = pairs_[other];
            if (!(pairs_[rigid].centre.*rests) || !source.point) continue;
            settle(entry, *source.point, InstantCentre::How::kennedy);
            entry.centre.statement = say(lang::sentences::centre_by_rigidity,
                                         {symbol(i, j), symbol(source.centre.first, source.centre.second)});
            return true;
        }
    }
    return false;
}

bool InstantCentres::by_coincidence(BodyIndex i, BodyIndex j) {
    const Board::Mark before = board_.mark();
    for (const BodyIndex k : intermediates(i, j)) {
        if (!board_.coincide(*pair(i, k).point, *pair(k, j).point)) continue;
        Pair& entry = pair(i, j);
        settle(entry, *pair(i, k).point, InstantCentre::How::kennedy);
        entry.centre.statement = say(lang::sentences::kennedy_same, {symbol(i, j), symbol(i, k), symbol(k, j)});
        return true;
    }
    board_.rewind(before);
    return false;
}

void InstantCentres::draw() {
    for (const JointIndex joint : indices_of(structure_.mechanism().joints)) primary(joint);
    mark_rest();
    const auto sweep = [&](auto rule) {
        bool found = false;
        for (const BodyIndex i : indices_of(structure_.mechanism().bodies)) {
            for (const BodyIndex j : structure_.mechanism().bodies_after(i))
                found = (!solved(pair(i, j)) && rule(i, j)) || found;
        }
        return found;
    };
    while (sweep([&](BodyIndex i, BodyIndex j) { return by_rigidity(i, j) || kennedy(i, j); }) ||
           sweep([&](BodyIndex i, BodyIndex j) { return by_coincidence(i, j); }) ||
           sweep([&](BodyIndex i, BodyIndex j) { return by_rest(i, j); })) {
    }
}

namespace {

/// The velocity, or the acceleration, of a node's place on a body whose motion is known.
template <Plane plane>
std::optional<PointOn<plane>> tip_on(const Structure& structure, Board& board, const Motion& motion, BodyIndex body,
                                     Drawing place) {
    if (body == frame) return board.pole<plane>();
    const Track<plane>& track = track_of<plane>(motion);
    for (const NodeIndex base : structure.nodes_of(body)) {
        if (!track.has(base)) continue;
        const auto join = board.vector(SpaceDiagram(structure, board).place(base), place);
        const auto tip = board.carry(track.tip(base), board.scale<plane>(track.spin(body), board.turn(join)));
        if constexpr (plane == Plane::velocity) return tip;
        const ScalarHandle omega = motion.velocity.spin(body);
        if (board.is_zero(omega)) return tip;
        return board.carry(tip, board.scale<plane>(board.opposite(board.product(omega, omega)), join));
    }
    return std::nullopt;
}

}  // namespace

void InstantCentres::complete(const Motion& motion, int freedoms) {
    const Track<Plane::velocity>& track = motion.velocity;
    for (Pair& entry : pairs_) {
        if (!track.turns(entry.centre.first) || !track.turns(entry.centre.second)) continue;
        if (!solved(entry)) {
            from_motion(entry, motion);
            entry.centre.depends_on_drivers = freedoms > 1;
        } else if (!entry.centre.as_one) {
            // The verdict is known from the rank. The question becomes a guard: where the bodies begin or cease to rest
            // against each other, the centres are found anew.
            static_cast<void>(at_relative_rest(entry, motion));
        }
    }
}

bool InstantCentres::at_relative_rest(const Pair& entry, const Motion& motion) {
    const auto& track = motion.velocity;
    const BodyIndex i = entry.centre.first, j = entry.centre.second;
    if (!board_.is_zero(board_.difference(track.spin(i), track.spin(j)))) return false;
    if (structure_.nodes_of(j).empty()) return false;
    const Drawing place = diagram_.place(structure_.nodes_of(j).front());
    const auto on_i = tip_on<Plane::velocity>(structure_, board_, motion, i, place),
               on_j = tip_on<Plane::velocity>(structure_, board_, motion, j, place);
    return on_i && on_j && board_.is_zero(board_.vector(*on_i, *on_j));
}

Symbol InstantCentres::omega_of(BodyIndex body) const {
    return {Symbol::Letter::omega, structure_.body_name(body), {}};
}

/// A point of a body that moves, with the symbol of its velocity; none: all rest.
std::pair<NodeIndex, Symbol> InstantCentres::velocity_of_node(BodyIndex body, const Track<Plane::velocity>& track) {
    for (const NodeIndex node : structure_.nodes_of(body))
        if (track.has(node) && !board_.coincide(track.tip(node), board_.pole<Plane::velocity>()))
            return {node, {Symbol::Letter::v, structure_.node(node).label, {}}};
    return {none, {}};
}

/// Places at which the relative velocity of two bodies may be drawn: their nodes, and one place beside these in case
/// all nodes are in line with the centre sought.
std::vector<InstantCentres::Place> InstantCentres::places_of(BodyIndex first, BodyIndex second) {
    std::vector<Place> places;
    for (const BodyIndex body : {first, second}) {
        for (const NodeIndex node : structure_.nodes_of(body))
            places.push_back({diagram_.place(node), structure_.node(node).label, structure_.node(node).point});
    }
    for (const NodeIndex node : indices_of(structure_.nodes())) {
        const Drawing there = diagram_.place(node);
        if (places.empty() || board_.coincide(places.front().at, there)) continue;
        places.push_back({there, structure_.node(node).label, structure_.node(node).point});
        const auto aside = board_.turn(board_.vector(places.front().at, there));
        places.push_back({board_.carry(places.front().at, aside), places.front().name, none});
        break;
    }
    return places;
}

/// Two normals meet where both are of points whose relative velocities stand in the polygon: those of one body against
/// the frame. All else follows from the angular velocities: r = v/ω.
Message InstantCentres::told_from_velocities(Pair& entry, Drawing found, const TwoPlaces& places,
                                             const Track<Plane::velocity>& track) {
    const BodyIndex i = entry.centre.first, j = entry.centre.second;
    const Symbol centre = symbol(i, j);
    if (board_.is_at_infinity(found)) return told_by_normals(entry, lang::sentences::centre_from_velocities, places);
    if (i == frame) {
        const auto stands = [&](const Place& place) {
            return place.point != none && structure_.find(place.point, j) != none;
        };
        const auto [point, velocity] = velocity_of_node(j, track);
        if ((stands(places.first) && stands(places.second)) || point == none)
            return told_by_normals(entry, lang::sentences::centre_from_velocities, places);
        if (structure_.node(point).point != none) entry.centre.normals = {structure_.node(point).point};
        return {lang::sentences::centre_from_omega,
                {centre, PointName{structure_.node(point).label}, velocity, omega_of(j)}};
    }
    Message by_normals{lang::sentences::centre_from_velocities, {centre, PointName{}, PointName{}}};
    const auto &own_i = pair(frame, i).point, &own_j = pair(frame, j).point;
    if (!own_i || !own_j) return by_normals;
    for (const auto& [still, turning] : {std::pair(i, j), std::pair(j, i)}) {
        if (!board_.is_at_infinity(*pair(frame, still).point)) continue;
        const auto [point, velocity] = velocity_of_node(still, track);
        if (point == none) return by_normals;
        return {lang::sentences::centre_beside_translation,
                {centre, BodyName{structure_.body_name(still)}, velocity, symbol(frame, turning), omega_of(turning)}};
    }
    if (board_.coincide(*own_i, *own_j)) return by_normals;
    return {lang::sentences::centre_by_ratio, {centre, symbol(frame, i), symbol(frame, j), omega_of(i), omega_of(j)}};
}

Message InstantCentres::told_by_normals(Pair& entry, Key sentence, const TwoPlaces& places) {
    const auto& [first, second] = places;
    const bool two = first.name != second.name;
    if (first.point != none && second.point != none) {
        entry.centre.normals = {first.point};
        if (two) entry.centre.normals.push_back(second.point);
    }
    return {sentence,
            {symbol(entry.centre.first, entry.centre.second), PointName{two ? first.name : std::string()},
             PointName{two ? second.name : std::string()}}};
}

void InstantCentres::from_motion(Pair& entry, const Motion& motion) {
    const auto found_by = [&](auto rule) {
        const Board::Mark before = board_.mark();
        const bool found = rule();
        if (!found) board_.rewind(before);
        return found;
    };
    if (found_by([&] { return by_relative_motion<Plane::velocity>(entry, motion); })) return;
    if (!at_relative_rest(entry, motion)) return;
    const BodyIndex i = entry.centre.first, j = entry.centre.second;
    const auto& track = motion.acceleration;
    if (track.polygon >= 0 && track.turns(i) && track.turns(j) &&
        found_by([&] { return by_relative_motion<Plane::acceleration>(entry, motion); }))
        return;
    entry.centre.everywhere = true;
    entry.centre.how = InstantCentre::How::velocities;
    entry.centre.statement = say(lang::sentences::centre_by_rigidity, {symbol(i, j), symbol(i, j)});
}

/// Where the normals to the relative velocities meet. Bodies at rest against each other have none; where they begin to
/// move, their accelerations are as their velocities will be. False if both are at rest here.
template <Plane plane>
bool InstantCentres::by_relative_motion(Pair& entry, const Motion& motion) {
    constexpr bool moving = plane == Plane::velocity;
    const BodyIndex i = entry.centre.first, j = entry.centre.second;
    const Track<plane>& track = track_of<plane>(motion);
    std::vector<std::pair<LineOn<Plane::drawing>, Place>> lines;
    const Key sentence = moving ? lang::sentences::centre_from_velocities : lang::sentences::centre_from_accelerations;
    const StatementIndex statement = say(sentence, {});
    const auto settle_here = [&](Drawing point, const Place& first, const Place& second) {
        settle(entry, point, moving ? InstantCentre::How::velocities : InstantCentre::How::accelerations);
        entry.centre.statement = statement;
        board_.statement(statement).message = moving
                                                  ? told_from_velocities(entry, point, {first, second}, motion.velocity)
                                                  : told_by_normals(entry, sentence, {first, second});
        return true;
    };
    const bool equal_spins = board_.is_zero(board_.difference(track.spin(i), track.spin(j)));
    for (const Place& place : places_of(j, i)) {
        const auto on_i = tip_on<plane>(structure_, board_, motion, i, place.at),
                   on_j = tip_on<plane>(structure_, board_, motion, j, place.at);
        if (!on_i || !on_j) return false;
        const auto relative = board_.vector(*on_i, *on_j);
        const bool still = board_.is_zero(relative);
        if (equal_spins && still) return false;
        if (equal_spins)
            return settle_here(board_.at_infinity(board_.perpendicular(board_.direction(relative))), place, place);
        if (still) return settle_here(place.at, place, place);
        const auto line = board_.through(place.at, board_.perpendicular(board_.direction(relative)));
        for (const auto& [earlier, other] : lines) {
            if (const auto met = board_.meet(earlier, line)) return settle_here(*met, other, place);
        }
        lines.emplace_back(line, place);
    }
    return false;
}

void InstantCentres::second_way(const Motion& motion, BodyIndex driver, std::vector<SecondWay>& results) {
    const auto& track = motion.velocity;
    if (!track.turns(driver) || !pair(frame, driver).point || board_.is_at_infinity(*pair(frame, driver).point)) return;
    for (const BodyIndex body : structure_.mechanism().moving_bodies()) {
        if (body == driver || !track.turns(body)) continue;
        const Pair& absolute = pair(frame, body);
        const Pair& relative = pair(driver, body);
        if (!absolute.point || !relative.point || absolute.centre.everywhere || relative.centre.everywhere) continue;
        if (board_.is_at_infinity(*absolute.point) || board_.is_at_infinity(*relative.point)) continue;
        if (board_.coincide(*absolute.point, *relative.point)) continue;
        Symbol omega{Symbol::Letter::omega, structure_.body_name(body), {}};
        Symbol omega_driver{Symbol::Letter::omega, structure_.body_name(driver), {}};
        const StatementIndex statement =
            say(lang::sentences::second_way,
                {omega, symbol(frame, driver), symbol(frame, body), symbol(driver, body), omega_driver});
        board_.statement(statement).section = Topic::velocity;
        const auto from_driver = board_.vector(*pair(frame, driver).point, *relative.point);
        const auto from_body = board_.vector(*absolute.point, *relative.point);
        const ScalarHandle found = board_.product(track.spin(driver), board_.ratio(from_driver, from_body));
        results.push_back(
            {body, Recorded<Exact>::at(found.element), board_.is_zero(board_.difference(found, track.spin(body)))});
    }
}

bool InstantCentres::are_found() const {
    return std::all_of(pairs_.begin(), pairs_.end(), [&](const Pair& entry) { return solved(entry); });
}

std::vector<InstantCentre> InstantCentres::results() const {
    std::vector<InstantCentre> centres;
    for (const Pair& entry : pairs_) centres.push_back(entry.centre);
    return centres;
}

}  // namespace kinegraph
