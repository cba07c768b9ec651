// Draws the pose: places the points in the order they need each other, with square roots where a compass is needed, then reads
// off the directions of guides and contacts. Every choice between two intersections is made here; motion and forces are unknown.
#include "engine/pose.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>

#include "engine/assert.hpp"
#include "engine/rounding.hpp"

namespace kinegraph {
namespace {

/// What may be lost to earlier roots before a small value is taken for what it looks like: 24 of the compass's bits.
constexpr int bits_in_doubt = 24;

/// Numbers longer than this, numerator and denominator together (some 150 digits), make every number behind them as long and show
/// nothing on any drawing.
constexpr std::size_t most_bits = 1024;

/// z = x·y as complex numbers: y turned by x's angle, |x| times as long.
Vector turned(const Vector& x, const Vector& y) { return {x.x * y.x - x.y * y.y, x.x * y.y + x.y * y.x}; }

/// floor(log2 |value|) or one more; for choosing grids only.
int magnitude(const Exact& value) {
    if (value.is_zero()) return 0;
    return static_cast<int>(mpz_sizeinbase(value.rational().get_num_mpz_t(), 2)) -
           static_cast<int>(mpz_sizeinbase(value.rational().get_den_mpz_t(), 2));
}
/// The same of a vector's length.
int magnitude_of_length(const Vector& a) { return static_cast<int>(std::floor(magnitude(squared_length(a)) / 2.0)); }

/// tan of a whole number of degrees or of radians is rational at the multiples of 45° only (of 0 in radians).
bool is_rational(const Angle& angle) {
    if (!angle.in_degrees) return angle.value.is_zero();
    return (angle.value / 45).rational().get_den() == 1;
}

std::string number_text(double value) {
    constexpr int digits = 6;
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
    return {text.data(), end.ptr};
}

Words length_text(double metres, const Unit& unit) {
    const std::string number = number_text(metres / unit.si.to_double());
    std::string with_comma = number;
    std::replace(with_comma.begin(), with_comma.end(), '.', ',');
    return {number + " " + unit.symbol, with_comma + " " + unit.symbol};
}

struct Ray {
    Vector through;
    Vector along;
    bool rational_angle = true;
    bool touched = false;  ///< lies where it does through an earlier root
    Words name;            ///< "through O2"
};
struct Disc {
    Vector centre;
    Exact radius;
    PointIndex point = none;
    bool touched = false;
    Words name;  ///< "A (radius 50 mm)"
};
using Stroke = std::variant<Ray, Disc>;

struct Candidates {
    std::vector<Vector> places;  ///< of circles: left, right of first → second; of line and circle: back, further along the line
    Exact leftover;
    bool touched = false;
};

class Drawing {
public:
    /// `slack` (m): what misses by no more fits, because the data are rounded; 0 where they are exact.
    Drawing(const Mechanism& mechanism, int bits, int size_exponent, std::size_t longest_given, Exact slack)
        : mechanism_(mechanism), grid_(bits - size_exponent), rounds_(longest_given > most_bits), slack_(std::move(slack)) {
        pose_.bits = bits;
        constexpr double digits_of_bit = 0.30103;  // log10 2
        const auto digits = [](std::size_t of) { return Count{static_cast<int>(digits_of_bit * static_cast<double>(of))}; };
        if (rounds_)
            pose_.remarks.push_back(
                {Sentence::rounded_givens, {digits(longest_given / 2), digits(static_cast<std::size_t>(bits))}});
        pose_.points.resize(mechanism.points.size());
        pose_.leftover.resize(mechanism.points.size());
        touched_.resize(mechanism.points.size(), false);
        state_.resize(mechanism.points.size(), State::waiting);
        rough_x_.resize(mechanism.points.size());
        estimated_size_ = Exact::power_of_two(size_exponent);
    }

    Result<Pose> draw() {
        for (const PointIndex point : indices_of(mechanism_.points)) drawn(point);
        if (!errors_.empty()) return tl::unexpected(in_order_of_file());
        measure();
        read_joints();
        if (!errors_.empty()) return tl::unexpected(std::move(errors_));
        for (const Exact& leftover : pose_.leftover) pose_.exact = pose_.exact && leftover.is_zero();
        return std::move(pose_);
    }

private:
    enum class State { waiting, under_way, done, failed };

    // --- words ---------------------------------------------------------------------------------------------------------------
    Words in_file_units(double metres) const { return length_text(metres, mechanism_.units.length); }
    Amount amount(double metres) const {
        return {metres / mechanism_.units.length.si.to_double(), mechanism_.units.length.symbol};
    }
    std::string name_of(const Place& place) const {
        if (const auto* point = std::get_if<PointIndex>(&place)) return mechanism_.point(*point).name;
        const auto& at = std::get<Vector>(place);
        const double unit = mechanism_.units.length.si.to_double();
        return "[" + number_text(at.x.to_double() / unit) + ", " + number_text(at.y.to_double() / unit) + "]";
    }
    const std::string& name_of(PointIndex point) const { return mechanism_.point(point).name; }

    bool fail(std::string where, Words message, ErrorCode code = ErrorCode::bad_input) {
        errors_.push_back({code, std::move(where), std::move(message)});
        return false;
    }
    /// Points are drawn in the order they need each other; their faults are told in the order of the file.
    Errors in_order_of_file() {
        const auto rank = [&](const Error& error) {
            std::size_t i = 0;
            while (i < mechanism_.points.size() && error.where != mechanism_.points[i].where) ++i;
            return i;
        };
        std::stable_sort(errors_.begin(), errors_.end(), [&](const Error& a, const Error& b) { return rank(a) < rank(b); });
        return std::move(errors_);
    }

    // --- points --------------------------------------------------------------------------------------------------------------
    /// True when the point has its place. False: it, or one it needs, could not be placed, which has been said.
    bool drawn(PointIndex point) {
        State& state = state_[at_index(point)];
        if (state == State::done) return true;
        if (state == State::failed) return false;
        KG_ASSERT(state == State::waiting, "the reader refuses points that need each other in a circle");
        state = State::under_way;
        const NamedPoint& named = mechanism_.point(point);
        PositionStep step{point, PositionStep::How::given, {}};
        const bool placed = std::visit([&](const auto& placement) { return place(named, placement, step); }, named.placement);
        state_[at_index(point)] = placed ? State::done : State::failed;
        if (placed) pose_.steps.push_back(std::move(step));
        return placed;
    }
    bool drawn(const Place& place) {
        const auto* point = std::get_if<PointIndex>(&place);
        return point == nullptr || drawn(*point);
    }
    bool drawn(const Bearing& bearing) {
        const auto* between = std::get_if<Bearing::Between>(&bearing.form);
        return between == nullptr || drawn(*between);
    }
    bool drawn(const Bearing::Between& between) {
        const bool from = drawn(between.from);
        return drawn(between.to) && from;
    }
    Vector at(const Place& place) const {
        if (const auto* point = std::get_if<PointIndex>(&place)) return pose_.at(*point);
        return std::get<Vector>(place);
    }
    bool touched(const Place& place) const {
        const auto* point = std::get_if<PointIndex>(&place);
        return point != nullptr && touched_[at_index(*point)];
    }
    bool touched(const Bearing::Between& between) const {
        return touched_[at_index(between.from)] || touched_[at_index(between.to)];
    }

    /// from → to; nothing, and said, where they coincide.
    std::optional<Vector> direction_between(const Bearing::Between& between, const std::string& where) {
        const Vector direction = pose_.at(between.to) - pose_.at(between.from);
        const bool nothing = touched(between) ? is_small(direction) : squared_length(direction) <= square(slack_);
        if (!nothing) return direction;
        fail(where, {"{0} and {1} coincide, so they give no direction; name two other points",
                     "{0} e {1} coincidono, quindi non danno una direzione; indicare altri due punti", name_of(between.from),
                     name_of(between.to)});
        return std::nullopt;
    }
    bool is_small(const Vector& a) const {
        return squared_length(a) < square(Exact::power_of_two(bits_in_doubt - pose_.bits) * estimated_size_);
    }
    Vector on_grid(const Vector& a) const { return {rounded(a.x, grid_), rounded(a.y, grid_)}; }
    Exact grid_step() const { return Exact::power_of_two(-grid_); }

    void set(const NamedPoint& named, const Vector& exact_place, const Exact& own_leftover, bool is_touched) {
        const auto index = static_cast<std::size_t>(&named - mechanism_.points.data());
        const bool rounds = rounds_ && std::max(exact_place.x.bits(), exact_place.y.bits()) > most_bits;
        const Vector place = rounds ? on_grid(exact_place) : exact_place;
        const Exact leftover = rounds ? own_leftover + grid_step() : own_leftover;
        pose_.points[index] = place;
        pose_.leftover[index] = leftover;
        rough_x_[index] = place.x.to_double();
        touched_[index] = is_touched || !leftover.is_zero();
    }

    bool place(const NamedPoint& named, const Coordinates& placement, PositionStep&) {
        set(named, placement.at, 0, false);
        return true;
    }

    bool place(const NamedPoint& named, const Polar& placement, PositionStep& step) {
        step.how = PositionStep::How::polar;
        bool ready = drawn(placement.from);
        if (placement.relative_to) ready = drawn(*placement.relative_to) && ready;
        if (!ready) return false;
        const Vector& from = pose_.at(placement.from);
        step.arcs.push_back({from, placement.from, abs(placement.distance)});
        const Vector angle = direction_of(placement.angle, pose_.bits);
        Vector direction = angle;
        bool is_touched = touched_[at_index(placement.from)];
        if (placement.relative_to) {
            const auto base = direction_between(*placement.relative_to, named.where);
            if (!base) return false;
            direction = turned(angle, *base);
            is_touched = is_touched || touched(*placement.relative_to);
        }
        const auto [reach, miss] = along(direction, placement.distance);
        Vector place = from + reach;
        Exact leftover = miss;
        if (!is_rational(placement.angle)) leftover += abs(placement.distance) * Exact::power_of_two(-pose_.bits);
        // The point stays on its ray where something else may lie there too: on a ray of the file's own angle, or along or
        // square to P→Q. Off these it goes to the nearest point of the grid, so that chains keep short numbers.
        const bool square_to_base = angle.x.is_zero() || angle.y.is_zero();
        if (placement.relative_to && !square_to_base && !leftover.is_zero()) {
            place = on_grid(place);
            leftover += grid_step();
        }
        set(named, place, leftover, is_touched);
        return true;
    }

    /// distance·direction/|direction|, with the bound on its miss.
    std::pair<Vector, Exact> along(const Vector& direction, const Exact& distance) const {
        const int scale = magnitude_of_length(direction) + 1;
        const Root factor = square_root(square(distance) / squared_length(direction), std::max(grid_ + scale, 1));
        const Vector reach = factor.value * direction;
        return {distance.sign() < 0 ? -reach : reach, factor.leftover * Exact::power_of_two(scale)};
    }

    bool place(const NamedPoint& named, const Along& placement, PositionStep& step) {
        step.how = PositionStep::How::along;
        if (!drawn(Bearing::Between{placement.from, placement.to})) return false;
        const Vector& from = pose_.at(placement.from);
        const Bearing::Between between{placement.from, placement.to};
        if (placement.is_ratio) {
            set(named, from + placement.amount * (pose_.at(placement.to) - from), 0, touched(between));
            return true;
        }
        const auto direction = direction_between(between, named.where);
        if (!direction) return false;
        step.arcs.push_back({from, placement.from, abs(placement.amount)});
        const auto [reach, miss] = along(*direction, placement.amount);
        set(named, from + reach, miss, touched(between));
        return true;
    }

    // --- meets ---------------------------------------------------------------------------------------------------------------
    std::optional<Stroke> stroke(const CircleCurve& circle, const std::string&) {
        if (!drawn(circle.centre)) return std::nullopt;
        const auto* point = std::get_if<PointIndex>(&circle.centre);
        return Disc{at(circle.centre),
                    circle.radius,
                    point == nullptr ? PointIndex() : *point,
                    touched(circle.centre),
                    {"{0} (radius {1})", "{0} (raggio {1})", name_of(circle.centre), in_file_units(circle.radius.to_double())}};
    }
    std::optional<Stroke> stroke(const LineCurve& line, const std::string& where) {
        bool ready = drawn(line.through);
        if (line.by == LineCurve::By::to) ready = drawn(line.to) && ready;
        const bool by_bearing = line.by == LineCurve::By::parallel || line.by == LineCurve::By::perpendicular;
        if (by_bearing) ready = drawn(line.bearing) && ready;
        if (!ready) return std::nullopt;
        Ray ray{at(line.through), {}, true, touched(line.through), {"through {0}", "per {0}", name_of(line.through)}};
        if (line.by == LineCurve::By::angle) {
            ray.along = direction_of(line.angle, pose_.bits);
            ray.rational_angle = is_rational(line.angle);
        } else if (line.by == LineCurve::By::to) {
            ray.along = pose_.at(line.to) - ray.through;
            ray.touched = ray.touched || touched_[at_index(line.to)];
            ray.name += Words(" and {0}", " e {0}", name_of(line.to));
            if (ray.touched ? is_small(ray.along) : ray.along.is_zero()) {
                fail(where, {"{0} and {1} coincide, so they give no line; name two other points",
                             "{0} e {1} coincidono, quindi non danno una retta; indicare altri due punti", name_of(line.through),
                             name_of(line.to)});
                return std::nullopt;
            }
        } else {
            if (const auto* angle = std::get_if<Angle>(&line.bearing.form)) ray.rational_angle = is_rational(*angle);
            if (const auto* between = std::get_if<Bearing::Between>(&line.bearing.form)) {
                if (!direction_between(*between, where)) return std::nullopt;
                ray.touched = ray.touched || touched(*between);
            }
            ray.along = direction_of(line.bearing, pose_);
            if (ray.along.is_zero()) {
                fail(where, {"the vector [0, 0] gives no direction", "il vettore [0, 0] non dà una direzione"});
                return std::nullopt;
            }
            if (line.by == LineCurve::By::perpendicular) ray.along = quarter_turn(ray.along);
        }
        return ray;
    }

    bool place(const NamedPoint& named, const Meet& placement, PositionStep& step) {
        const auto draw_stroke = [&](const Curve& curve) {
            return std::visit([&](const auto& form) { return stroke(form, named.where); }, curve);
        };
        const auto first = draw_stroke(placement.first);
        const auto second = draw_stroke(placement.second);
        if (!first || !second) return false;
        std::optional<Candidates> found;
        const auto* first_line = std::get_if<Ray>(&*first);
        const auto* second_line = std::get_if<Ray>(&*second);
        for (const auto& each : {&*first, &*second}) {
            if (const auto* disc = std::get_if<Disc>(each)) step.arcs.push_back({disc->centre, disc->point, disc->radius});
        }
        if (first_line != nullptr && second_line != nullptr) {
            step.how = PositionStep::How::lines;
            found = meet(*first_line, *second_line, named.where);
        } else if (first_line != nullptr || second_line != nullptr) {
            step.how = PositionStep::How::line_and_circle;
            found = first_line != nullptr ? meet(*first_line, std::get<Disc>(*second), named.where)
                                          : meet(*second_line, std::get<Disc>(*first), named.where);
        } else {
            step.how = PositionStep::How::circles;
            found = meet(std::get<Disc>(*first), std::get<Disc>(*second), named.where);
        }
        if (!found) return false;
        const auto chosen = choose(*found, placement, step.how, named);
        if (!chosen) return false;
        set(named, *chosen, found->leftover, found->touched);
        return true;
    }

    std::optional<Vector> choose(const Candidates& found, const Meet& meet, PositionStep::How how, const NamedPoint& named) {
        if (found.places.size() == 1) return found.places.front();
        if (meet.near) {
            const Exact first = squared_length(found.places[0] - *meet.near);
            const Exact second = squared_length(found.places[1] - *meet.near);
            const Exact apart = abs(first - second);
            const bool tie = found.touched ? apart < Exact::power_of_two(bits_in_doubt - pose_.bits) * square(estimated_size_)
                                           : apart.is_zero();
            if (!tie) return found.places[first < second ? 0 : 1];
            fail(
                named.where,
                {"both intersections for {0} are equally far from \"near\"; give \"side\": \"left\" or \"right\" instead, or move \"near\"",
                 "le due intersezioni per {0} sono ugualmente lontane da \"near\"; assegnare invece \"side\": \"left\" o \"right\", o spostare \"near\"",
                 named.name});
            return std::nullopt;
        }
        if (meet.side != Meet::Side::either) {
            // Circles: left and right of first centre → second. On a line both intersections lie on the line itself: they are
            // taken as they look when the line's direction points to the right, so that "right" is the one further along it.
            // (Seen from the centre they would change places whenever the centre crosses the line, as a crank pin does.)
            const bool first = meet.side == Meet::Side::left || meet.side == Meet::Side::behind;
            return found.places[first ? 0 : 1];
        }
        fail(
            named.where,
            {"{0} meet twice; choose the intersection for {1} by \"near\": [x, y] or by \"side\": \"left\" or \"right\"",
             "{0} si incontrano due volte; scegliere l’intersezione per {1} con \"near\": [x, y] o con \"side\": \"left\" o \"right\"",
             how == PositionStep::How::circles ? Words("the circles", "le circonferenze")
                                               : Words("the line and the circle", "la retta e la circonferenza"),
             named.name});
        return std::nullopt;
    }

    std::optional<Candidates> meet(const Ray& a, const Ray& b, const std::string& where) {
        const Exact slant = cross(a.along, b.along);
        const Vector across = b.through - a.through;
        const bool inexact = a.touched || b.touched || !a.rational_angle || !b.rational_angle;
        const Exact doubt = inexact ? Exact::power_of_two(2 * (bits_in_doubt - pose_.bits)) : Exact();
        if (square(slant) <= doubt * squared_length(a.along) * squared_length(b.along)) {
            const bool same = square(cross(across, a.along)) <= doubt * squared_length(a.along) * square(estimated_size_);
            const Words apart = same ? Words("they are one and the same", "e sono la stessa")
                                     : Words("{0} apart", "a distanza {0}",
                                             in_file_units(std::abs(cross(across, a.along).to_double()) / length(a.along)));
            fail(where,
                 {"the lines {0} and {1} do not meet: they are parallel, {2}",
                  "le rette {0} e {1} non si incontrano: sono parallele, {2}", a.name, b.name, apart},
                 ErrorCode::cannot_meet);
            return std::nullopt;
        }
        const Exact factor = cross(across, b.along) / slant;
        Candidates found{{a.through + factor * a.along}, 0, inexact};
        if (!a.rational_angle || !b.rational_angle) {
            // A tangent off by 2^-bits turns a line by no more; the meet is off by the lever, over the sine between the lines.
            const double lever = length(found.places[0] - a.through) + length(found.places[0] - b.through);
            const double sine = std::abs(slant.to_double()) / (length(a.along) * length(b.along));
            found.leftover =
                Exact::power_of_two(-pose_.bits + static_cast<int>(std::ceil(std::log2(std::max(lever, 1e-300) / sine))));
        }
        return found;
    }

    /// through + factor·direction; the factor goes to the grid where the place is inexact anyway, so the point keeps to the line.
    Vector on_line(const Vector& through, const Vector& direction, const Exact& factor, bool inexact) const {
        if (!inexact) return through + factor * direction;
        return through + rounded(factor, std::max(grid_ + magnitude_of_length(direction) + 1, 1)) * direction;
    }

    std::optional<Candidates> meet(const Ray& line, const Disc& circle, const std::string& where) {
        const Exact squared = squared_length(line.along);
        const Exact foot = dot(circle.centre - line.through, line.along) / squared;
        const Vector to_line = line.through + foot * line.along - circle.centre;
        const Exact room = square(circle.radius) - squared_length(to_line);  // square of half the chord
        const bool inexact = line.touched || circle.touched || !line.rational_angle;
        const Exact angle_miss = line.rational_angle ? Exact() : Exact::power_of_two(1 - pose_.bits) * reach_of(line, circle);
        if (touches(room, circle.radius, 1) || (inexact && is_doubtful(room, circle.radius))) {
            return Candidates{
                {on_line(line.through, line.along, foot, inexact)}, inexact ? grid_step() + angle_miss : Exact(), inexact};
        }
        if (room.sign() < 0) {
            const double distance = length(to_line);
            fail(
                where,
                {"the circle about {0} and the line {1} do not meet: the line passes {2} from the centre, {3} too far",
                 "la circonferenza di centro {0} e la retta {1} non si incontrano: la retta passa a {2} dal centro, {3} di troppo",
                 circle.name, line.name, in_file_units(distance), in_file_units(distance - circle.radius.to_double())},
                ErrorCode::cannot_meet);
            return std::nullopt;
        }
        const int scale = magnitude_of_length(line.along) + 1;
        const Root half = square_root(room / squared, std::max(grid_ + scale, 1));
        const bool rounds = !half.leftover.is_zero();
        return Candidates{{on_line(line.through, line.along, foot - half.value, rounds),
                           on_line(line.through, line.along, foot + half.value, rounds)},
                          (rounds ? half.leftover * Exact::power_of_two(scale) + grid_step() : Exact()) + angle_miss,
                          inexact};
    }
    Exact reach_of(const Ray& line, const Disc& circle) const {
        const Vector apart = circle.centre - line.through;
        return abs(apart.x) + abs(apart.y) + circle.radius;
    }
    /// A squared half chord that earlier roots may have moved across zero.
    bool is_doubtful(const Exact& room, const Exact& radius) const {
        return abs(room) < Exact::power_of_two(bits_in_doubt - pose_.bits) * radius * estimated_size_;
    }

    /// The square of half the chord is 2rδ (for two circles times r_b over the distance of the centres, `lever` its square) where
    /// the curves overlap by δ: within the precision they touch.
    bool touches(const Exact& room, const Exact& radius, const Exact& lever) const {
        return room.is_zero() || square(room) <= lever * square(2 * radius * slack_);
    }

    std::optional<Candidates> meet(const Disc& a, const Disc& b, const std::string& where) {
        const Vector across = b.centre - a.centre;
        const bool inexact = a.touched || b.touched;
        if (inexact ? is_small(across) : across.is_zero()) {
            fail(where,
                 {"the circles about {0} and {1} do not meet in points: they have the same centre{2}",
                  "le circonferenze di centro {0} e {1} non si incontrano in punti: hanno lo stesso centro{2}", a.name, b.name,
                  a.radius == b.radius ? Words(" and radius", " e raggio")
                                       : Words(", and radii {0} apart", ", e raggi che differiscono di {0}",
                                               in_file_units(abs(a.radius - b.radius).to_double()))},
                 ErrorCode::cannot_meet);
            return std::nullopt;
        }
        const Exact squared = squared_length(across);
        const Exact foot = (square(a.radius) - square(b.radius) + squared) / (2 * squared);
        const Exact room = square(a.radius) - square(foot) * squared;
        const Exact lever = std::max(Exact(1), square(b.radius) / squared);
        if (touches(room, a.radius, lever) || (inexact && is_doubtful(room, a.radius))) {
            return Candidates{{on_line(a.centre, across, foot, inexact)}, inexact ? grid_step() : Exact(), inexact};
        }
        if (room.sign() < 0) {
            const double distance = length(across);
            const double sum = (a.radius + b.radius).to_double();
            const double difference = std::abs((a.radius - b.radius).to_double());
            const bool far = distance > sum;
            fail(where,
                 {"the circles about {0} and {1} do not meet: their centres are {2} apart, {3} {4}",
                  "le circonferenze di centro {0} e {1} non si incontrano: i centri distano {2}, {3} {4}", a.name, b.name,
                  in_file_units(distance), in_file_units(far ? distance - sum : difference - distance),
                  far ? Words("too far", "di troppo") : Words("too near", "troppo poco")},
                 ErrorCode::cannot_meet);
            return std::nullopt;
        }
        const int scale = magnitude_of_length(across) + 1;
        const Root half = square_root(room / squared, std::max(grid_ + scale, 1));
        const Vector middle = a.centre + foot * across;
        const Vector sideways = half.value * quarter_turn(across);
        Candidates found{{middle + sideways, middle - sideways}, 0, inexact};
        if (!half.leftover.is_zero()) {
            found.leftover = half.leftover * Exact::power_of_two(scale) + grid_step();
            for (Vector& place : found.places)
                place = inexact ? corner_of_parallelogram(a.centre, b.centre, on_grid(place)) : on_grid(place);
        }
        return found;
    }

    /// Where the circles close a parallelogram with a point already drawn, the fourth corner itself: it is as good as the root
    /// (within the same doubt), and sides meant to be parallel then are.
    Vector corner_of_parallelogram(const Vector& a, const Vector& b, const Vector& place) const {
        const Vector opposite = a + b - place;
        const double x = opposite.x.to_double();
        const double near = std::ldexp(estimated_size_.to_double(), -30);  // a first look in doubles
        for (std::size_t i = 0; i < pose_.points.size(); ++i) {
            if (state_[i] != State::done || std::abs(rough_x_[i] - x) > near + std::ldexp(std::abs(x), -50)) continue;
            if (is_small(opposite - pose_.points[i])) return a + b - pose_.points[i];
        }
        return place;
    }

    // --- joints --------------------------------------------------------------------------------------------------------------
    void measure() {
        pose_.size = 1;
        if (pose_.points.empty()) return;
        Vector low = pose_.points.front();
        Vector high = low;
        for (const Vector& point : pose_.points) {
            low = {std::min(low.x, point.x), std::min(low.y, point.y)};
            high = {std::max(high.x, point.x), std::max(high.y, point.y)};
        }
        const Exact largest = std::max(high.x - low.x, high.y - low.y);
        if (!largest.is_zero()) pose_.size = largest;
    }

    /// The direction of a joint's bearing; nothing, and said, where it is none. An irrational angle makes the pose inexact.
    std::optional<Vector> direction(const Bearing& bearing, const std::string& where) {
        if (const auto* between = std::get_if<Bearing::Between>(&bearing.form)) return direction_between(*between, where);
        if (const auto* angle = std::get_if<Angle>(&bearing.form)) pose_.exact = pose_.exact && is_rational(*angle);
        Vector result = direction_of(bearing, pose_);
        if (rounds_ && std::max(result.x.bits(), result.y.bits()) > most_bits) {
            const int grid = pose_.bits - magnitude_of_length(result);
            result = {rounded(result.x, grid), rounded(result.y, grid)};
            pose_.exact = false;
        }
        if (!result.is_zero()) return result;
        fail(where, {"the vector [0, 0] gives no direction", "il vettore [0, 0] non dà una direzione"});
        return std::nullopt;
    }

    void read_joints() {
        const std::size_t count = mechanism_.joints.size();
        pose_.guides.resize(count);
        pose_.guide_units.resize(count);
        pose_.normals.resize(count);
        pose_.tangents.resize(count);
        // A contact moves its point before any joint measures from it.
        for (std::size_t i = 0; i < count; ++i) {
            const Joint& joint = mechanism_.joints[i];
            if (joint.pair().touches()) read_contact(joint, i);
        }
        for (std::size_t i = 0; i < count; ++i) {
            const Joint& joint = mechanism_.joints[i];
            if (joint.along) {
                if (const auto guide = direction(*joint.along, joint.where + "/along")) {
                    pose_.guides[i] = *guide;
                    pose_.guide_units[i] = unit_along(*guide, pose_.bits);
                    pose_.normals[i] = quarter_turn(*guide);
                }
            } else if (joint.arc != none) {
                if (const auto normal = direction_between({joint.arc, joint.point}, joint.where + "/arc"))
                    pose_.normals[i] = *normal;
            }
        }
        // Drivers and loads speak of directions too; a root in them is a root in what follows.
        const auto note = [&](const Bearing& bearing, const std::string& where) { return direction(bearing, where + "/along"); };
        pose_.driver_directions.resize(mechanism_.drivers.size());
        pose_.driver_units.resize(mechanism_.drivers.size());
        for (std::size_t i = 0; i < mechanism_.drivers.size(); ++i) {
            const auto* point = std::get_if<PointDriver>(&mechanism_.drivers[i]);
            if (point == nullptr) continue;
            if (const auto along = note(point->along, point->where)) {
                pose_.driver_directions[i] = *along;
                pose_.driver_units[i] = unit_along(*along, pose_.bits);
            }
        }
        if (mechanism_.motion) {
            for (const auto* values : {&mechanism_.motion->velocities, &mechanism_.motion->accelerations}) {
                for (const GivenMotion& given : *values) {
                    if (const auto* along = std::get_if<Bearing>(&given.value)) direction(*along, mechanism_.motion->where);
                }
            }
        }
        for (const Load& load : mechanism_.loads) {
            const auto* force = std::get_if<ForceLoad>(&load);
            if (force != nullptr && force->magnitude) note(force->magnitude->second, force->where);
            if (const auto* distributed = std::get_if<DistributedLoad>(&load)) note(distributed->along, distributed->where);
        }
        for (const Effort& effort : mechanism_.efforts) {
            if (const auto* force = std::get_if<ForceEffort>(&effort)) note(force->along, force->where);
        }
    }

    bool claimed_twice(PointIndex point) const {
        return std::count_if(mechanism_.joints.begin(), mechanism_.joints.end(),
                             [&](const Joint& joint) { return joint.point == point && !joint.profiles.empty(); }) > 1;
    }

    /// Checks the profiles against each other, moves P onto them where it is off by less than 1e-9, and sets the directions.
    void read_contact(const Joint& joint, std::size_t index) {
        std::vector<PointIndex> centres;
        std::optional<Vector> tangent;
        for (const BodyIndex body : joint.bodies) {
            const auto profile = joint.profiles.find(body);
            if (profile == joint.profiles.end()) continue;
            if (const auto* line = std::get_if<LineProfile>(&profile->second)) {
                tangent = direction(line->along, joint.where + "/profiles/" + mechanism_.body(body).name + "/line");
                if (!tangent) return;
            } else if (const auto* circle = std::get_if<CircleProfile>(&profile->second)) {
                centres.push_back(circle->centre);
                if (!direction_between({circle->centre, joint.point}, joint.where)) return;
            }
        }
        if (!tangent && centres.empty()) {
            if (!joint.tangent) {
                fail(joint.where,
                     {"nothing says how the bodies touch at {0}; give \"profiles\" or \"tangent\"",
                      "nulla dice come i corpi si toccano in {0}; assegnare \"profiles\" o \"tangent\"", name_of(joint.point)});
                return;
            }
            tangent = direction(*joint.tangent, joint.where + "/tangent");
            if (!tangent) return;
        } else if (tangent && !centres.empty()) {
            // The foot of the centre's perpendicular on the line through P.
            const Vector& place = pose_.at(joint.point);
            const Exact factor = dot(pose_.at(centres[0]) - place, *tangent) / squared_length(*tangent);
            if (!move(joint, place + factor * *tangent, {centres[0]})) return;
        } else if (centres.size() == 2) {
            const Vector& base = pose_.at(centres[0]);
            const Vector across = pose_.at(centres[1]) - base;
            if (!across.is_zero()) {
                const Exact factor = dot(pose_.at(joint.point) - base, across) / squared_length(across);
                if (!move(joint, on_line(base, across, factor, touched_[at_index(joint.point)]), {centres[0], centres[1]})) {
                    return;
                }
            }
        }
        for (const auto& [body, profile] : joint.profiles) {
            const auto* circle = std::get_if<CircleProfile>(&profile);
            if (circle != nullptr && !fits_radius(joint, body, circle->centre)) return;
        }
        const Vector normal = tangent ? quarter_turn(*tangent) : pose_.at(centres[0]) - pose_.at(joint.point);
        if (!tangent) tangent = -quarter_turn(normal);
        pose_.tangents[index] = *tangent;
        pose_.normals[index] = normal;
        if (joint.pair().meshes()) {
            // The line of action leaves the common tangent by the pressure angle. Of the two such lines this is the one turned
            // counter-clockwise; which one the teeth push on is for the forces to say, and motion does not ask.
            const Angle pressure = joint.pressure_angle.value_or(Angle{});
            pose_.exact = pose_.exact && is_rational(pressure);
            pose_.normals[index] = turned(direction_of(pressure, pose_.bits), *tangent);
        }
    }

    /// Compass noise or the data's own rounding, no fault of the file. A move that no double shows is none either.
    bool is_noise(double misfit) const {
        constexpr double roundings = 1e-15;
        return misfit <= std::max(slack_.to_double(), roundings * pose_.size.to_double());
    }
    bool is_refused(double misfit) const {
        constexpr double fit = 1e-9;
        return misfit > std::max(fit * pose_.size.to_double(), slack_.to_double());
    }

    bool fits_radius(const Joint& joint, BodyIndex body, PointIndex centre) {
        const auto& circle = mechanism_.body(body).circle;
        if (!circle || circle->centre != centre) return true;
        // | |PC| − r | = | |PC|² − r² | / (|PC| + r), without taking a root of what may be exact
        const Vector arm = pose_.at(joint.point) - pose_.at(centre);
        const Exact excess = squared_length(arm) - square(circle->radius);
        const double misfit = std::abs(excess.to_double()) / (length(arm) + circle->radius.to_double());
        if (is_refused(misfit)) {
            return fail(joint.where,
                        {"{0} lies {1} from {2}, but the circle of body {3} has radius {4}: {5} off",
                         "{0} dista {1} da {2}, ma la circonferenza del corpo {3} ha raggio {4}: scarto {5}",
                         name_of(joint.point), in_file_units(length(arm)), name_of(centre), mechanism_.body(body).name,
                         in_file_units(circle->radius.to_double()), in_file_units(misfit)});
        }
        if (!is_noise(misfit)) {
            pose_.remarks.push_back({Sentence::off_its_circle,
                                     {PointName{name_of(joint.point)}, amount(misfit), BodyName{mechanism_.body(body).name}}});
        }
        return true;
    }

    /// `centres`: one, whose foot on the contact's line `place` is, or two, on whose line it lies.
    bool move(const Joint& joint, const Vector& place, const std::vector<PointIndex>& centres) {
        const std::size_t point = at_index(joint.point);
        const Vector shift = place - pose_.points[point];
        if (shift.is_zero()) return true;
        const double misfit = length(shift);
        const std::string& name = name_of(joint.point);
        const auto remark = [&](Sentence sentence) {
            Message message{sentence, {PointName{name}, amount(misfit)}};
            for (const PointIndex centre : centres) message.arguments.emplace_back(PointName{name_of(centre)});
            pose_.remarks.push_back(std::move(message));
        };
        if (is_refused(misfit)) {
            const Words onto = centres.size() == 1
                                   ? Words("the foot of {0} on the line", "dal piede di {0} sulla retta", name_of(centres[0]))
                                   : Words("the line of the centres {0} and {1}", "dalla retta dei centri {0} e {1}",
                                           name_of(centres[0]), name_of(centres[1]));
            return fail(joint.where, {"{0} is {1} off {2}, where the bodies touch; move {0} there or correct the profile",
                                      "{0} dista {1} {2}, dove i corpi si toccano; spostarvi {0} o correggere il profilo", name,
                                      in_file_units(misfit), onto});
        }
        if (claimed_twice(joint.point)) {
            if (!is_noise(misfit)) remark(centres.size() == 1 ? Sentence::off_its_foot : Sentence::off_its_centres);
            return true;
        }
        pose_.points[point] = place;
        pose_.steps.push_back({joint.point, PositionStep::How::moved_onto_curve, {}});
        if (!is_noise(misfit)) remark(centres.size() == 1 ? Sentence::moved_to_foot : Sentence::moved_to_centres);
        return true;
    }

    const Mechanism& mechanism_;
    int grid_;     ///< coordinates are multiples of 2^-grid where they are inexact
    bool rounds_;  ///< some number of the file is too long to be kept
    Exact slack_;
    Exact estimated_size_;
    Pose pose_;
    std::vector<bool> touched_;  ///< by PointIndex: the place depends on a leftover, its own or an earlier one
    std::vector<State> state_;
    std::vector<double> rough_x_;  ///< by PointIndex, for a first look only
    Errors errors_;
};

/// Of the lengths that a file gives.
struct Lengths {
    int size = 0;             ///< power of two near the largest
    std::size_t longest = 0;  ///< bits of the longest number
};
Lengths lengths_of(const Mechanism& mechanism) {
    Exact largest;
    std::size_t longest = 0;
    std::optional<Vector> first;
    const auto number_given = [&](const Exact& value) { longest = std::max(longest, value.bits()); };
    const auto size_given = [&](const Exact& value) { largest = std::max(largest, abs(value)); };
    const auto length_given = [&](const Exact& value) {
        size_given(value);
        number_given(value);
    };
    const auto place_given = [&](const Vector& at) {
        number_given(at.x);
        number_given(at.y);
        if (!first) first = at;
        size_given(at.x - first->x);
        size_given(at.y - first->y);
    };
    const auto curve_given = [&](const Curve& curve) {
        if (const auto* circle = std::get_if<CircleCurve>(&curve)) length_given(circle->radius);
    };
    for (const NamedPoint& point : mechanism.points) {
        if (const auto* given = std::get_if<Coordinates>(&point.placement)) place_given(given->at);
        if (const auto* polar = std::get_if<Polar>(&point.placement)) length_given(polar->distance);
        if (const auto* along = std::get_if<Along>(&point.placement))
            along->is_ratio ? number_given(along->amount) : length_given(along->amount);
        if (const auto* meet = std::get_if<Meet>(&point.placement)) {
            curve_given(meet->first);
            curve_given(meet->second);
        }
    }
    return {largest.is_zero() ? 0 : magnitude(largest), longest};
}

Result<Pose> draw_within(const Mechanism& mechanism, int bits, const Exact& slack) {
    // The grid must suit the drawing's size, which is known only once it is drawn: two bits to spare, and a second drawing where
    // the lengths given are much larger than what they make (a long radius about a far centre).
    constexpr int spare = 2;
    const Lengths given = lengths_of(mechanism);
    const int estimate = given.size - spare;
    auto pose = Drawing(mechanism, bits, estimate, given.longest, slack).draw();
    if (!pose || pose->exact) return pose;
    const int true_size = magnitude(pose->size);
    if (true_size >= estimate) return pose;
    return Drawing(mechanism, bits, true_size, given.longest, slack).draw();
}

/// What fits in the drawing as it is given fits in the shifted ones, which are off by as much again.
constexpr int slack_as_given = 4, slack_when_shifted = 2 * slack_as_given;

/// A drawing that cannot be closed with its numbers shifted has nothing to say.
std::shared_ptr<const std::vector<ShiftedDrawing>> shifted_drawings_of(const Mechanism& mechanism, const Pose& pose) {
    auto drawings = std::make_shared<std::vector<ShiftedDrawing>>();
    for (int sample = 0; sample < shifted_drawings; ++sample) {
        Mechanism moved = shifted(mechanism, pose.precision, pose.precision / pose.size, sample);
        if (auto drawn = draw_within(moved, pose.bits, slack_when_shifted * pose.precision))
            drawings->push_back({std::move(moved), std::move(*drawn)});
    }
    return drawings;
}

}  // namespace

Result<Pose> draw_pose(const Mechanism& mechanism, int bits) {
    const bool inferred = looks_rounded(mechanism);
    const Exact expected =
        inferred ? inferred_share() * Exact::power_of_two(lengths_of(mechanism).size) : mechanism.precision.value_or(Exact());
    auto pose = draw_within(mechanism, bits, slack_as_given * expected);
    if (!pose || expected.is_zero()) return pose;
    pose->precision = inferred ? inferred_share() * pose->size : expected;
    const Unit& unit = mechanism.units.length;
    if (constexpr int coarsest = 100; coarsest * pose->precision > pose->size)
        return tl::unexpected(
            Errors{{ErrorCode::bad_input,
                    "/precision",
                    {"{0} is too coarse for a drawing of {1}; it must be at most a hundredth of it",
                     "{0} è troppo per un disegno di {1}; dev’essere al più un centesimo di esso",
                     length_text(pose->precision.to_double(), unit), length_text(pose->size.to_double(), unit)}}});
    if (inferred)
        pose->remarks.insert(pose->remarks.begin(),
                             {Sentence::taken_as_rounded, {Amount{(pose->precision / unit.si).to_double(), unit.symbol}}});
    pose->shifted = shifted_drawings_of(mechanism, *pose);
    return pose;
}

Vector direction_of(const Angle& angle, int bits) {
    const Exact half_turns = angle.in_degrees ? angle.value / 180 : angle.value / pi();
    // Quarter turns first, then the octant: the tangent is taken once, and all its images differ by swaps and signs only.
    const Exact quarters = 2 * half_turns;
    mpz_class whole;
    mpz_fdiv_q(whole.get_mpz_t(), quarters.rational().get_num_mpz_t(), quarters.rational().get_den_mpz_t());
    const Exact rest = half_turns - Exact(mpq_class(whole)) / 2;
    const bool lower_octant = rest <= Exact::ratio(1, 4);
    const Exact tangent = tangent_in_first_octant(lower_octant ? rest : Exact::ratio(1, 2) - rest, bits);
    Vector direction = lower_octant ? Vector{1, tangent} : Vector{tangent, 1};
    const auto turns = mpz_fdiv_ui(whole.get_mpz_t(), 4);
    for (unsigned long i = 0; i < turns; ++i) direction = quarter_turn(direction);
    return direction;
}

Vector direction_of(const Bearing& bearing, const Pose& pose) {
    if (const auto* angle = std::get_if<Angle>(&bearing.form)) return direction_of(*angle, pose.bits);
    if (const auto* between = std::get_if<Bearing::Between>(&bearing.form)) return pose.at(between->to) - pose.at(between->from);
    return std::get<Vector>(bearing.form);
}

Vector unit_along(const Vector& direction, int bits) {
    KG_ASSERT(!direction.is_zero(), "a zero vector has no direction");
    const Root factor = square_root(1 / squared_length(direction), std::max(bits + magnitude_of_length(direction) + 2, 1));
    return factor.value * direction;
}

}  // namespace kinegraph
