#include "engine/equations/letters.hpp"

#include <algorithm>
#include <array>
#include <variant>

#include "engine/motion/closure.hpp"

namespace kinegraph::vector_loops {
namespace {

/// Lengths and angles are assigned in pairs, so that a e^{iα} is one vector. e and i are numbers; λ, π, ω and θ have
/// other meanings.
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

}  // namespace

Letters::Pair Letters::next_pair() {
    const std::size_t round = pairs_ / letter_pairs.size();
    const auto& [length, angle] = letter_pairs[pairs_++ % letter_pairs.size()];
    return {length, angle, round == 0 ? "" : std::to_string(round)};
}

LetterIndex Letters::add(Letter letter) {
    found_.letters.push_back(std::move(letter));
    return static_cast<LetterIndex>(found_.letters.size()) - 1;
}

std::optional<Side> Letters::side_of(BodyIndex body, const Vector& from, const Vector& to) {
    const Vector reach = to - from;
    if (drawn_.is_nothing(reach.x) && drawn_.is_nothing(reach.y)) return std::nullopt;
    for (const Side& known : body_sides_)
        if (known.body == body && known.from == from && known.to == to) return known;
    const Pair pair = next_pair();
    Side side;
    side.from = from;
    side.to = to;
    side.body = body;
    side.angle = angle_of(graph_.class_of(body), drawn_.unit(reach), pair);
    side.length = add_length(pair, square_root(squared_length(reach), 2 * drawn_.pose.bits).value);
    body_sides_.push_back(side);
    return side;
}

void Letters::give_letters(Edge& edge) {
    if (edge.kind == Edge::Kind::pin || !edge.sides.empty() || edge.slide >= 0 || edge.direction >= 0) return;
    if (!edge.base) edge.base = edge.is_unsupported && edge.joint == none ? Vector{} : edge.place;
    if (!edge.head) edge.head = edge.place;
    if (edge.kind == Edge::Kind::link)
        give_link_letters(edge);
    else
        give_guide_letters(edge);
}

void Letters::name_what_is_left() {
    for (std::size_t c = 1; c < graph_.classes.size(); ++c)
        if (!graph_.classes[c].bodies.empty() && !graph_.classes[c].datum)
            set_datum(static_cast<int>(c), some_direction(static_cast<int>(c)), next_pair());
    found_.turns.resize(drawn_.mechanism.bodies.size());
    for (const BodyIndex body : indices_of(drawn_.mechanism.bodies))
        found_.turns[at_index(body)] = graph_.classes[at_index(graph_.class_of(body))].letters;
}

LetterIndex Letters::radius(const Exact& reach, BodyIndex body) {
    for (const auto& [of, known, letter] : radii_)
        if (of == body && drawn_.is_nothing(known - abs(reach))) return letter;
    Letter letter;
    letter.symbol = "R";
    letter.is_radius = true;
    letter.sub = drawn_.name_of(body);
    letter.body = body;
    for (const auto& each : radii_)
        if (std::get<0>(each) == body) letter.sub += "'";
    letter.exact = abs(reach);
    letter.value = letter.exact.to_double();
    radii_.emplace_back(body, abs(reach), add(std::move(letter)));
    return std::get<2>(radii_.back());
}

void Letters::settle_names() {
    const std::vector<Letter> before = found_.letters;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i].name.empty()) continue;
        const auto same = std::count_if(before.begin(), before.end(),
                                        [&](const Letter& each) { return each.name == before[i].name; });
        if (same < 2) continue;
        Letter& letter = found_.letters[i];
        if (letter.body != none && letter.against != none && letter.joint != none)
            letter.name += " " + drawn_.name_of(letter.body) + " on " + drawn_.name_of(letter.against);
        const auto still =
            std::count_if(found_.letters.begin(), found_.letters.begin() + static_cast<std::ptrdiff_t>(i),
                          [&](const Letter& each) { return each.name == letter.name; });
        if (still > 0) letter.name += " (" + std::to_string(still + 1) + ")";
    }
}

LetterIndex Letters::add_length(const Pair& pair, const Exact& length, Letter::Role role) {
    Letter letter;
    letter.symbol = pair.length;
    letter.sub = pair.sub;
    letter.role = role;
    letter.exact = length;
    letter.value = length.to_double();
    return add(std::move(letter));
}

LetterIndex Letters::add_angle(const Pair& pair, const Vector& direction, Letter::Role role) {
    Letter letter;
    letter.symbol = pair.angle;
    letter.sub = pair.sub;
    letter.is_angle = true;
    letter.role = role;
    letter.unit = direction;
    letter.value = (degrees_of(direction.y, direction.x, drawn_.pose.bits) * pi() / 180).to_double();
    return add(std::move(letter));
}

std::optional<int> Letters::quarters_of(const Vector& direction) const {
    if (drawn_.is_small(direction.y)) return direction.x.sign() > 0 ? 0 : 2;
    if (drawn_.is_small(direction.x)) return direction.y.sign() > 0 ? 1 : 3;
    return std::nullopt;
}

Angle Letters::angle_of(int index, const Vector& direction, const Pair& pair) {
    if (index > 0 && !graph_.classes[at_index(index)].datum) set_datum(index, direction, pair);
    TurningClass& turning = graph_.classes[at_index(index)];
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

void Letters::set_datum(int index, const Vector& direction, const Pair& pair) {
    const int against = graph_.classes[at_index(index)].against;
    Vector base{1, 0};
    std::vector<LetterIndex> letters;
    if (against > 0) {
        if (!graph_.classes[at_index(against)].datum) set_datum(against, some_direction(against), next_pair());
        base = *graph_.classes[at_index(against)].datum;
        letters = graph_.classes[at_index(against)].letters;
    }
    TurningClass& turning = graph_.classes[at_index(index)];
    turning.datum = direction;
    const LetterIndex own = add_angle(pair, product(direction, conjugate(base)),
                                      turning.driver >= 0 ? Letter::Role::free : Letter::Role::dependent);
    Letter& letter = found_.letters[at_index(own)];
    letter.body = turning.bodies.front();
    letter.name = "theta " + drawn_.name_of(letter.body);
    if (against > 0) {
        letter.against = graph_.classes[at_index(against)].bodies.front();
        letter.name += " on " + drawn_.name_of(letter.against);
    }
    letters.push_back(own);
    turning.letters = std::move(letters);
}

Vector Letters::some_direction(int index) const {
    Vector best{1, 0};
    Exact farthest;
    for (const BodyIndex body : graph_.classes[at_index(index)].bodies) {
        const auto& points = drawn_.mechanism.body(body).points;
        const auto joint = std::find_if(drawn_.mechanism.joints.begin(), drawn_.mechanism.joints.end(),
                                        [&](const Joint& each) { return each.connects(body); });
        if (joint == drawn_.mechanism.joints.end()) continue;
        for (const PointIndex point : points) {
            const Vector reach = drawn_.pose.at(point) - drawn_.pose.at(joint->point);
            if (squared_length(reach) <= farthest || drawn_.is_nothing(square_root(squared_length(reach), 64).value))
                continue;
            farthest = squared_length(reach);
            best = drawn_.unit(reach);
        }
    }
    return best;
}

void Letters::give_link_letters(Edge& edge) {
    const Vector reach = *edge.head - *edge.base;
    const Pair pair = next_pair();
    Side side;
    side.from = *edge.base;
    side.to = *edge.head;
    edge.direction = add_angle(pair, drawn_.unit(reach), Letter::Role::dependent);
    edge.length = add_length(pair, square_root(squared_length(reach), 2 * drawn_.pose.bits).value,
                             edge.is_unsupported ? Letter::Role::dependent : Letter::Role::given);
    name(edge.direction, "phi ", edge);
    if (edge.is_unsupported) name(edge.length, "d ", edge);
    side.angle.letters = {edge.direction};
    side.length = edge.length;
    edge.sides = {side};
}

void Letters::give_guide_letters(Edge& edge) {
    const Vector reach = *edge.head - *edge.base;
    if (!drawn_.is_nothing(dot(reach, edge.along)) && dot(reach, edge.along).sign() < 0) {
        edge.along = -edge.along;
        edge.sense = -edge.sense;
    }
    const Pair pair = next_pair();
    Side slide;
    slide.body = edge.carrier;
    slide.angle = angle_of(graph_.class_of(edge.carrier), edge.along, pair);
    const bool free_standing = edge.joint == none && edge.driver < 0;
    edge.slide = slide.length =
        add_length(pair, dot(reach, edge.along), edge.driver >= 0 ? Letter::Role::free : Letter::Role::dependent);
    name(edge.slide, free_standing ? "x " : "s ", edge);
    Exact across = dot(reach, quarter_turn(edge.along));
    slide.from = *edge.base;
    if (edge.is_unsupported || !drawn_.is_nothing(across)) {
        Side offset = slide;
        offset.angle.quarters = (slide.angle.quarters + (across.sign() < 0 ? 3 : 1)) % 4;
        const Vector up = across.sign() < 0 ? -quarter_turn(edge.along) : quarter_turn(edge.along);
        across = abs(across);
        edge.across = offset.length =
            add_length(next_pair(), across, edge.is_unsupported ? Letter::Role::dependent : Letter::Role::given);
        if (edge.is_unsupported) name(edge.across, free_standing ? "y " : "n ", edge);
        offset.to = slide.from = offset.from + across * up;
        edge.sides.push_back(std::move(offset));
    }
    slide.to = *edge.head;
    edge.sides.push_back(std::move(slide));
}

void Letters::name(LetterIndex index, const char* kind, const Edge& edge) {
    Letter& letter = found_.letters[at_index(index)];
    letter.name = kind + edge.name;
    letter.joint = edge.joint;
    letter.body = edge.rider;
    letter.against = edge.carrier;
}

}  // namespace kinegraph::vector_loops
