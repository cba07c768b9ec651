// Draws polygon parts, selects the details and places them.
#include "render/figures/polygon_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>

#include "lang/keys/sheet.hpp"
#include "render/figures/caption.hpp"
#include "render/page/free_room.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

std::string heading_of_detail(const std::string& letter, Language language) {
    return word(lang::sheet::detail, language) + " " + letter;
}

constexpr double corner_side = 1.8;  // of the mark of a right angle

// mm; a vector shorter than its arrowhead is hard to see, and its reading has an error of 2 % or more.
constexpr double too_short = 4.6;
constexpr double beside_long = 8;   // … if the polygon is at least this many times longer
constexpr double most_across = 22;  // extent of the vectors in a detail, at its scale …
constexpr double least_across = 12;
constexpr double share_across = 0.28;    // … and relative to the longest vector: smaller than the polygon
constexpr double rim = 7;                // space for letters in the detail
constexpr double least_magnified = 2.5;  // with less a detail shows nothing new
constexpr double most_magnified = 1e4;   // relative to the polygon; smaller vectors are not comparable with the rest
constexpr double least_circle = 2.2;     // of the circle round the place
constexpr std::size_t most_details = 3;  // of one figure
constexpr double between_circles = 1.5;
constexpr double apart_from_figure = 3.5;  // distance of the detail from the figure

double distance_to_pole(const PolygonParts& parts, Spot spot) {
    double least = 1e300;
    for (const PolygonImage& image : parts.images)
        if (image.kind == PolygonImage::Kind::pole) least = std::min(least, length(image.at - spot));
    return least;
}

/// The part of a segment within a circle about the origin, as parameters in [0, 1].
std::optional<std::pair<double, double>> within_circle(Spot from, Spot to, double radius) {
    const Spot d = to - from;
    const double a = dot(d, d), b = dot(from, d), c = dot(from, from) - radius * radius;
    if (!(a > 0) || b * b - a * c <= 0) return std::nullopt;
    const double root = std::sqrt(b * b - a * c);
    const double enter = std::max(0.0, (-b - root) / a), leave = std::min(1.0, (-b + root) / a);
    if (enter >= leave) return std::nullopt;
    return std::pair{enter, leave};
}

/// Whether a detail shows the point with some space round it.
bool is_in(const Detail& detail, Spot spot) {
    return length(spot - detail.centre) <= detail.radius - 2 / detail.magnification;
}
bool is_in(const Detail& detail, const PolygonVector& vector) {
    return is_in(detail, vector.tail) && is_in(detail, vector.tip);
}
template <class Part>
bool is_in_any(const std::vector<Detail>& details, const Part& part) {
    return std::any_of(details.begin(), details.end(), [&](const Detail& detail) { return is_in(detail, part); });
}

/// Vectors that are too short to be compared on paper do not count as equal.
bool have_one_size(const PolygonVector& a, const PolygonVector& b) {
    constexpr double equal = 1e-3;
    return std::abs(a.value - b.value) <= equal * std::max(a.value, b.value);
}
bool fall_together(const PolygonVector& a, const PolygonVector& b) {
    return have_one_size(a, b) && length(a.tail - b.tail) < coincident && length(a.tip - b.tip) < coincident;
}
bool are_opposite(const PolygonVector& a, const PolygonVector& b) {
    return have_one_size(a, b) && length(a.tail - b.tip) < coincident && length(a.tip - b.tail) < coincident;
}
/// A side that cancels is one with its reaction, and with the force that it is passed on as.
bool are_one_side(const PolygonVector& a, const PolygonVector& b) {
    return fall_together(a, b) || ((a.internal || b.internal) && are_opposite(a, b));
}
/// Whether one vector would cover the other on the same line.
bool hide_each_other(const PolygonVector& a, const PolygonVector& b) {
    constexpr double beside = 0.4, shared = 1;  // mm
    if (length(a.tip - a.tail) < shared || length(b.tip - b.tail) < shared) return false;
    const Spot along = unit(a.tip - a.tail);
    if (std::abs(cross(along, b.tail - a.tail)) > beside || std::abs(cross(along, b.tip - a.tail)) > beside)
        return false;
    const double from = dot(b.tail - a.tail, along), to = dot(b.tip - a.tail, along);
    return std::min(length(a.tip - a.tail), std::max(from, to)) - std::max(0.0, std::min(from, to)) > shared;
}

/// The part of the stretch `from` to `to` in which a value that begins `at` and grows `by` stays between two bounds.
void keep_within(double low, double high, double at, double by, double& from, double& to) {
    if (std::abs(by) < 1e-12) {
        if (at < low || at > high) to = from;
        return;
    }
    from = std::max(from, std::min((low - at) / by, (high - at) / by));
    to = std::min(to, std::max((low - at) / by, (high - at) / by));
}
/// Whether a vector lies on a longer one, as drawn, over more than a third of its length.
bool lies_on(const PolygonVector& shorter, const PolygonVector& longer) {
    constexpr double least = 5, half_a_shaft = 0.35;  // mm; a head alone is not hidden by a shaft
    const Spot way = shorter.tip - shorter.tail, line = longer.tip - longer.tail;
    if (shorter.internal || longer.internal || length(way) < least || length(way) > length(line)) return false;
    const Spot along = unit(line), start = shorter.tail + shorter.aside - longer.tail - longer.aside;
    double from = 0, to = 1;
    keep_within(0, length(line), dot(start, along), dot(way, along), from, to);
    keep_within(-half_a_shaft, half_a_shaft, cross(along, start), cross(along, way), from, to);
    return to - from > 1.0 / 3;
}

/// The offset of a vector beside a line: a lane, counted along the normal.
struct Lane {
    int number = 0;
    Spot normal;
};
/// 0, 1, −1, 2, −2, …
int nth_lane(int n) { return n % 2 == 1 ? (n + 1) / 2 : -n / 2; }

/// The normal away from the rest of the polygon.
Spot outward(const PolygonParts& parts, const PolygonVector& vector) {
    const Spot along = unit(vector.tip - vector.tail), normal{-along.y, along.x};
    double sum = 0;
    for (const PolygonVector& other : parts.vectors)
        sum += dot(other.tail - vector.tail, normal) + dot(other.tip - vector.tail, normal);
    constexpr double noise = 1e-6;
    if (std::abs(sum) > noise) return sum > 0 ? -1.0 * normal : normal;
    return normal.y < -noise || (normal.y < noise && normal.x > 0) ? normal : -1.0 * normal;
}

bool is_knot(const PolygonParts& parts) {
    const double apart = apart_of_knot(parts.vectors.size());
    if (!(apart > 0)) return false;
    Box box{parts.vectors.front().tail, parts.vectors.front().tail};
    for (const PolygonVector& vector : parts.vectors) box.include(vector.tail), box.include(vector.tip);
    return std::max(box.width(), box.height()) < apart;
}

/// Between two of its places.
PolygonPiece piece_of(const PolygonVector& vector, Spot from, Spot to) {
    return {from, to, true, true, vector.is_resultant, vector.colour, vector.internal, vector.statement, vector.aside};
}

// --- figures

class PartsDrawing {
public:
    PartsDrawing(Figure& figure, const DrawingContext& context, const PolygonParts& parts,
                 const std::vector<Detail>& details)
        : figure_(figure),
          context_(context),
          theme_(context.theme),
          parts_(parts),
          details_(details),
          name_size_(is_knot(parts) ? context.theme.body_text : context.theme.equation) {}

    void draw() {
        constexpr std::size_t of_a_vector = 6, most_of_another = 3;
        figure_.marks.reserve(figure_.marks.size() + of_a_vector * parts_.vectors.size() + parts_.lines.size() +
                              most_of_another * (parts_.pieces.size() + parts_.images.size() + details_.size()));
        draw_trial_images();
        draw_lines();
        draw_corners();
        draw_vectors();
        draw_pole();
        draw_images();
        draw_circles();
    }

private:
    LabelRequest& ask_label(RichText text, double size, Colour colour, Spot anchor, double clearance,
                            StatementIndex statement) {
        LabelRequest& label = figure_.labels.emplace_back();
        label.text = std::move(text);
        label.size = size;
        label.colour = colour;
        label.anchor = anchor;
        label.clearance = clearance;
        label.statement = statement;
        return label;
    }

    void draw_lines() {
        for (const PolygonLine& each : parts_.lines) {
            const std::size_t first = figure_.marks.size();
            figure_.marks.emplace_back(line(each.from, each.to, each.pen));
            belong(figure_.marks, first, each.statement);
            if (each.mark.empty()) continue;
            LabelRequest& mark =
                ask_label(each.mark, theme_.small, theme_.secondary, each.mark_at, 1.2, each.statement);
            mark.toward = each.mark_toward;
            mark.along = each.mark_along;
        }
    }

    void draw_trial_images() {
        for (const PolygonImage& image : parts_.images) {
            if (image.kind != PolygonImage::Kind::trial || image.text.empty()) continue;
            figure_.marks.emplace_back(disc(image.at, 0.4, theme_.secondary));
            belong(figure_.marks, figure_.marks.size() - 1, image.statement);
            if (!is_in_any(details_, image.at))
                ask_label(image.text, theme_.small, theme_.secondary, image.at, 1.4, image.statement);
        }
    }

    /// A small square if the legs are long enough and nothing crosses it.
    void draw_corners() {
        for (const PolygonCorner& corner : parts_.corners) {
            if (corner.shorter_leg < 3 * corner_side || distance_to_pole(parts_, corner.at) < 2 * corner_side) continue;
            const bool crossed =
                std::any_of(parts_.vectors.begin(), parts_.vectors.end(),
                            [&](const PolygonVector& v) { return runs_through(corner, v.tail, v.tip); }) ||
                std::any_of(parts_.pieces.begin(), parts_.pieces.end(),
                            [&](const PolygonPiece& p) { return runs_through(corner, p.from, p.to); }) ||
                std::any_of(parts_.lines.begin(), parts_.lines.end(),
                            [&](const PolygonLine& l) { return runs_through(corner, l.from, l.to); });
            if (crossed) continue;
            const Spot u = corner_side * corner.first, v = corner_side * corner.second;
            figure_.marks.emplace_back(polyline({corner.at + u, corner.at + u + v, corner.at + v},
                                                {theme_.thin, theme_.secondary, {}, false}));
            belong(figure_.marks, figure_.marks.size() - 1, corner.statement);
        }
    }
    static bool runs_through(const PolygonCorner& corner, Spot from, Spot to) {
        const auto local = [&](Spot spot) {
            return Spot{dot(spot - corner.at, corner.first), dot(spot - corner.at, corner.second)};
        };
        const Spot start = local(from), step = local(to) - start;
        constexpr double low = 0.1 * corner_side, high = 1.2 * corner_side;
        double enter = 0, leave = 1;
        keep_within(low, high, start.x, step.x, enter, leave);
        keep_within(low, high, start.y, step.y, enter, leave);
        return enter < leave;
    }

    void draw_shaft(std::vector<Mark>& marks, const PolygonPiece& piece, double width) const {
        const std::size_t first = marks.size();
        const Spot from = piece.from + piece.aside, to = piece.to + piece.aside;
        const Colour colour = piece.colour.line;
        if (piece.internal)
            marks.emplace_back(line(from, to, {theme_.outline, colour, dashes(), false}));
        else if (!piece.has_tip)
            marks.emplace_back(line(from, to, {width, colour, {}, false}));
        else if (piece.is_resultant)
            draw_double_arrow(marks, from, to, width, colour);
        else
            draw_arrow(marks, from, to, width, colour);
        belong(marks, first, piece.statement);
    }

    /// A vector that is drawn already.
    struct Drawn {
        const PolygonVector* vector = nullptr;
        bool arrow = false;  // false: dashed line
        std::optional<std::size_t> label;
    };
    /// Dashed lines are below arrows; labels are in the order of the vectors.
    void draw_vectors() {
        for (const PolygonPiece& piece : parts_.pieces) {
            if (piece.has_tail) lead_back(piece.from, piece.aside, piece.statement);
            if (piece.has_tip) lead_back(piece.to, piece.aside, piece.statement);
            draw_shaft(figure_.marks, piece, theme_.vector);
        }
        std::vector<Drawn> drawn;
        std::vector<Mark> broken, arrows;
        constexpr std::size_t of_a_vector = 5;
        arrows.reserve(of_a_vector * parts_.vectors.size());
        for (const PolygonVector& vector : parts_.vectors)
            draw_vector(vector, drawn, vector.internal ? broken : arrows);
        for (std::vector<Mark>* const marks : {&broken, &arrows})
            figure_.marks.insert(figure_.marks.end(), std::make_move_iterator(marks->begin()),
                                 std::make_move_iterator(marks->end()));
    }
    void draw_vector(const PolygonVector& vector, std::vector<Drawn>& drawn, std::vector<Mark>& marks) {
        // Of coincident vectors, such as a_A = a_A^n, the first is drawn, and their common label has its colour. A
        // repeated inner side of forces (of a two-force body) is one stroke with both names; an external force is the
        // arrow. Two external forces stand side by side, because a stroke with two heads would be ambiguous.
        const auto with = std::find_if(drawn.begin(), drawn.end(), [&](const Drawn& other) {
            const bool one_stroke = parts_.opposites_share_label && (vector.internal || !other.arrow);
            return fall_together(*other.vector, vector) || (one_stroke && are_opposite(*other.vector, vector));
        });
        const bool alike = with != drawn.end() && fall_together(*with->vector, vector);
        const Spot tail = vector.tail + vector.aside, tip = vector.tip + vector.aside;
        if (with == drawn.end())
            for (const Spot end : {vector.tail, vector.tip}) lead_back(end, vector.aside, vector.statement);
        const std::size_t first = marks.size();
        begin_group(vector, marks);
        marks.emplace_back(Axis{tail, tip});
        if (with == drawn.end() || (!vector.internal && !(alike && with->arrow)))
            draw_shaft(marks, piece_of(vector, vector.tail, vector.tip),
                       vector.is_thin ? theme_.outline : theme_.vector);
        marks.emplace_back(GroupEnd{});
        belong(marks, first, vector.statement);
        if (with != drawn.end()) {
            if (!with->label) return;
            LabelRequest& label = figure_.labels[*with->label];
            append(label.text, one_piece(alike ? " = " : " = −"));
            append(label.text, vector.text);
            label.names.push_back(vector.name);
            if (!vector.internal && !with->arrow) {
                label.size = theme_.equation;
                label.colour = vector.colour.letter;
                with->arrow = true;
            }
            return;
        }
        drawn.push_back({&vector, !vector.internal, std::nullopt});
        if (is_in_any(details_, vector)) return;
        drawn.back().label = figure_.labels.size();
        LabelRequest& label = ask_label(vector.text, vector.internal || vector.is_thin ? theme_.label : name_size_,
                                        vector.colour.letter, 0.5 * (tail + tip), 1.5, vector.statement);
        label.toward = tip;
        label.is_of_vector = true;
        label.names = {vector.name};
    }

    void begin_group(const PolygonVector& vector, std::vector<Mark>& marks) {
        const std::string value = shortest(vector.value);
        marks.emplace_back(GroupBegin{"vector",
                                      id_in(figure_, legal_id(vector.name)),
                                      vector.name + " = " + value + " " + figure_.unit,
                                      {{"data-name", vector.name}, {"data-value", value}}});
        figure_.axes.push_back({vector.name, vector.tail + vector.aside, vector.tip + vector.aside, ""});
    }

    /// A thin line from the true position of an end to where it is drawn.
    void lead_back(Spot end, Spot aside, StatementIndex statement) {
        if (length(aside) == 0) return;
        figure_.marks.emplace_back(line(end, end + aside, {theme_.thin, theme_.secondary, {}, false}));
        belong(figure_.marks, figure_.marks.size() - 1, statement);
    }

    void draw_pole() {
        for (const PolygonImage& image : parts_.images)
            if (image.kind == PolygonImage::Kind::pole)
                figure_.marks.emplace_back(
                    ring(image.at, pole_radius, theme_.paper, {theme_.outline, theme_.text, {}, false}));
    }

    /// Coincident images share a label: b ≡ c. Those at the pole are named with it.
    struct Cluster {
        Spot at;
        RichText text;
        std::set<std::string> names;
        StatementIndex statement = none;
        bool pole = false;
    };
    void draw_images() {
        std::vector<Cluster> clusters;
        for (const PolygonImage& image : parts_.images) {
            if (image.kind == PolygonImage::Kind::trial) continue;
            double near = coincident;
            for (const Detail& detail : details_)
                if (is_in(detail, image.at)) near = coincident / detail.magnification;
            const auto same = std::find_if(clusters.begin(), clusters.end(),
                                           [&](const Cluster& c) { return length(c.at - image.at) < near; });
            if (same == clusters.end()) {
                clusters.push_back(
                    {image.at, image.text, {image.name}, image.statement, image.kind == PolygonImage::Kind::pole});
            } else if (same->names.insert(image.name).second) {
                append(same->text, one_piece(" ≡ "));
                append(same->text, image.text);
            }
        }
        for (const Cluster& cluster : clusters) {
            if (!cluster.pole && !touched_by_vector(cluster.at)) {
                figure_.marks.emplace_back(disc(cluster.at, 0.5, theme_.text));
                belong(figure_.marks, figure_.marks.size() - 1, cluster.statement);
            }
            if (is_named_in_detail_only(clusters, cluster) || cluster.text.empty()) continue;
            ask_label(cluster.text, theme_.label, theme_.text, cluster.at, 2.0, cluster.statement)
                .names.assign(cluster.names.begin(), cluster.names.end());
        }
    }
    /// True if a detail separates the images. The pole and single images are always named here.
    bool is_named_in_detail_only(const std::vector<Cluster>& clusters, const Cluster& cluster) const {
        if (cluster.pole) return false;
        return std::any_of(details_.begin(), details_.end(), [&](const Detail& detail) {
            return is_in(detail, cluster.at) && std::count_if(clusters.begin(), clusters.end(), [&](const Cluster& c) {
                                                    return is_in(detail, c.at);
                                                }) > 1;
        });
    }
    bool touched_by_vector(Spot at) const {
        const auto near = [&](Spot end) { return length(end - at) < coincident; };
        return std::any_of(parts_.vectors.begin(), parts_.vectors.end(),
                           [&](const PolygonVector& v) { return near(v.tail + v.aside) || near(v.tip + v.aside); }) ||
               std::any_of(parts_.pieces.begin(), parts_.pieces.end(),
                           [&](const PolygonPiece& p) { return near(p.from + p.aside) || near(p.to + p.aside); });
    }

    /// The circle round the place of a detail, with its letter.
    void draw_circles() {
        for (const Detail& detail : details_) {
            const double radius = std::max(detail.radius, least_circle);
            StatementIndex statement = none;
            for (const PolygonVector& vector : parts_.vectors)
                if (is_in(detail, vector) && (statement == none || vector.statement < statement))
                    statement = vector.statement;
            const std::size_t first = figure_.marks.size();
            figure_.marks.emplace_back(GroupBegin{
                "detail", {}, heading_of_detail(detail.letter, context_.language), {}, statement, {}, detail.number});
            figure_.marks.emplace_back(circle(detail.centre, radius, {theme_.thin, theme_.text, {}, false}));
            figure_.marks.emplace_back(GroupEnd{});
            belong(figure_.marks, first, statement);
            ask_label(one_piece(detail.letter), theme_.label, theme_.text, detail.centre, radius + 0.8, statement);
            figure_.labels.back().detail = detail.number;
            figure_.details.push_back({detail.letter, detail.centre, radius, 0, detail.number});
        }
    }

    Figure& figure_;
    const DrawingContext& context_;
    const Theme& theme_;
    const PolygonParts& parts_;
    const std::vector<Detail>& details_;
    double name_size_;  // of vectors
};

// --- details

std::string roman(std::size_t number) {
    constexpr std::array<const char*, 10> numerals{"I", "II", "III", "IV", "V", "VI", "VII", "VIII", "IX", "X"};
    return number <= numerals.size() ? numerals[number - 1] : std::to_string(number);
}

/// Short vectors near each other.
struct Cluster {
    std::vector<Spot> ends;
    double shortest = 1e300;
};

/// `across`: at its own scale, mm.
Detail detail_round(const std::vector<Spot>& ends, double scale, double across) {
    Box box{ends.front(), ends.front()};
    for (const Spot end : ends) {
        box.min = {std::min(box.min.x, end.x), std::min(box.min.y, end.y)};
        box.max = {std::max(box.max.x, end.x), std::max(box.max.y, end.y)};
    }
    Detail detail;
    detail.centre = 0.5 * (box.min + box.max);
    double reach = 0;
    for (const Spot end : ends) reach = std::max(reach, length(end - detail.centre));
    detail.scale = choose_scale(2 * reach * scale, 0, across, across, std::nullopt);
    detail.magnification = scale / detail.scale;
    detail.radius = reach + rim / detail.magnification;
    return detail;
}

bool overlap(const Detail& a, const Detail& b) {
    return length(a.centre - b.centre) <
           std::max(a.radius, least_circle) + std::max(b.radius, least_circle) + between_circles;
}

/// Merges clusters whose details overlap, if a common detail still magnifies enough. Returns their details.
std::vector<Detail> merged(std::vector<Cluster>& clusters, double scale, double across) {
    std::vector<Detail> rounds;
    for (const Cluster& each : clusters) rounds.push_back(detail_round(each.ends, scale, across));
    const auto merges = [&](std::size_t i, std::size_t j) {
        if (!overlap(rounds[i], rounds[j])) return false;
        std::vector<Spot> ends = clusters[i].ends;
        ends.insert(ends.end(), clusters[j].ends.begin(), clusters[j].ends.end());
        const Detail round = detail_round(ends, scale, across);
        if (round.magnification < least_magnified) return false;
        clusters[i] = {std::move(ends), std::min(clusters[i].shortest, clusters[j].shortest)};
        rounds[i] = round;
        clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(j));
        rounds.erase(rounds.begin() + static_cast<std::ptrdiff_t>(j));
        return true;
    };
    for (std::size_t i = 0; i < clusters.size(); ++i)
        for (std::size_t j = i + 1; j < clusters.size();) {
            if (!merges(i, j)) {
                ++j;
                continue;
            }
            // A larger one may reach those before it; all other pairs are as they were.
            for (std::size_t k = 0; k < i;) {
                if (!merges(k, i)) {
                    ++k;
                    continue;
                }
                i = k;
                k = 0;
            }
            j = i + 1;
        }
    return rounds;
}

/// A vector that leaves the detail: what is seen of it there. Of sides that fall together one is seen as in the figure,
/// the external force.
void add_piece(std::vector<PolygonPiece>& pieces, const PolygonPiece& piece) {
    const auto are_near = [](Spot a, Spot b) { return length(a - b) < coincident; };
    for (PolygonPiece& other : pieces) {
        if (!are_near(other.aside, piece.aside)) continue;
        const bool alike = are_near(other.from, piece.from) && are_near(other.to, piece.to);
        if (!alike && !(are_near(other.from, piece.to) && are_near(other.to, piece.from))) continue;
        if (piece.internal || (alike && !other.internal)) return;
        if (other.internal) {
            other = piece;
            return;
        }
    }
    pieces.push_back(piece);
}

/// The vectors within a detail, and the pieces of those that leave it; side by side as all of them are at its scale.
void add_magnified_vectors(const PolygonParts& parts, const Detail& detail, PolygonParts& all) {
    PolygonParts whole;
    whole.vectors = parts.vectors;
    for (PolygonVector& each : whole.vectors)
        for (Spot* const end : {&each.tail, &each.tip}) *end = detail.magnification * (*end - detail.centre);
    set_side_by_side(whole);
    const double radius = detail.magnification * detail.radius;
    for (std::size_t i = 0; i < whole.vectors.size(); ++i) {
        const PolygonVector& each = whole.vectors[i];
        if (is_in(detail, parts.vectors[i])) {
            all.vectors.push_back(each);
        } else if (const auto chord = within_circle(each.tail, each.tip, radius)) {
            const Spot off = each.tip - each.tail;
            PolygonPiece piece = piece_of(each, each.tail + chord->first * off, each.tail + chord->second * off);
            piece.has_tail = chord->first == 0.0, piece.has_tip = chord->second == 1.0;
            add_piece(all.pieces, piece);
        }
    }
}

/// The parts within a detail, relative to its centre, in mm at its scale, cut at its circle.
PolygonParts magnified(const PolygonParts& parts, const Detail& detail) {
    const double radius = detail.magnification * detail.radius;
    const auto larger = [&](Spot spot) { return detail.magnification * (spot - detail.centre); };
    PolygonParts all;
    all.opposites_share_label = parts.opposites_share_label;
    for (const PolygonLine& each : parts.lines) {
        const Spot from = larger(each.from), to = larger(each.to);
        if (const auto chord = within_circle(from, to, radius))
            all.lines.push_back({.from = from + chord->first * (to - from),
                                 .to = from + chord->second * (to - from),
                                 .pen = each.pen,
                                 .mark = {},
                                 .mark_at = {},
                                 .mark_toward = {},
                                 .statement = each.statement});
    }
    add_magnified_vectors(parts, detail, all);
    for (const PolygonImage& each : parts.images)
        if (each.kind == PolygonImage::Kind::pole ? length(larger(each.at)) < radius - pole_radius
                                                  : is_in(detail, each.at)) {
            all.images.push_back(each);
            all.images.back().at = larger(each.at);
            // The pole is named in the polygon; here its ring is enough.
            if (each.kind == PolygonImage::Kind::pole) all.images.back().text.clear();
        }
    // Images at the pole are named with it.
    std::erase_if(all.images, [&](const PolygonImage& image) {
        return image.kind == PolygonImage::Kind::image && distance_to_pole(all, image.at) < coincident;
    });
    for (const PolygonCorner& each : parts.corners)
        if (is_in(detail, each.at)) {
            all.corners.push_back(each);
            all.corners.back().at = larger(each.at);
            all.corners.back().shorter_leg *= detail.magnification;
        }
    return all;
}

/// A detail with circle and caption and with its labels placed; it is positioned later.
struct Inset {
    Figure figure;
    Spot of;  ///< position of the place it shows, in the enclosing figure
};

double radius_of(const Detail& detail) { return detail.magnification * detail.radius; }

Figure blank_inset(const Figure& figure, const DrawingContext& context, const Detail& detail) {
    Figure inset;
    inset.data_figure = "detail";
    inset.id = figure.id;
    inset.detail = detail.letter;
    inset.caption = one_piece(heading_of_detail(detail.letter, context.language));
    inset.scale = detail.scale;
    inset.unit = figure.unit;
    return inset;
}
Path circle_of(const Detail& detail, const Theme& theme) {
    return circle({0, 0}, radius_of(detail), {theme.thin, theme.text, {}, false});
}
/// Name and scale above an inset, its scale bar below.
void add_legend(Figure& inset, const DrawingContext& context, const Detail& detail) {
    const Theme& theme = context.theme;
    const Box drawn = box_of(inset.marks);
    const ShapedLine name = context.fonts.shape(inset.caption, theme.label);
    const ShapedLine scale = context.fonts.shape(scale_words(context, inset), theme.body_text);
    const std::size_t heading = inset.marks.size();
    set_text(inset.marks, name, {-name.width / 2, drawn.min.y - 6.2}, theme.text, "text");
    std::get<TextMark>(inset.marks[heading]).detail = detail.number;
    set_text(inset.marks, scale, {-scale.width / 2, drawn.min.y - 2}, theme.secondary, "text");
    std::vector<Mark> bar;
    draw_scale_bar(bar, context.fonts, theme, {0, 0}, 1.4 * radius_of(detail), inset.scale, 1, inset.unit,
                   context.language);
    const Box size = box_of(bar);
    render::move(bar, -0.5 * (size.min.x + size.max.x), drawn.max.y + 2 - size.min.y);
    inset.marks.insert(inset.marks.end(), std::make_move_iterator(bar.begin()), std::make_move_iterator(bar.end()));
}

class Insets {
public:
    Insets(Figure& figure, const DrawingContext& context, Spot room, std::size_t& letters)
        : figure_(figure), context_(context), room_(room), letters_(letters) {}

    bool set(const PolygonParts& parts, const std::vector<Detail>& details) {
        for (const Detail& detail : details) {
            const PolygonParts larger = magnified(parts, detail);
            // One level of nesting, for vectors that are too short in the detail, too.
            const std::vector<Detail> inner = details_of(larger, detail.scale, detail.magnification, letters_);
            const Spot at = place(inset(larger, detail, inner), detail, detail.centre);
            for (const Detail& each : inner) place(inset(magnified(larger, each), each, {}), each, at + each.centre);
        }
        return all_free_;
    }

private:
    Figure inset(const PolygonParts& parts, const Detail& detail, const std::vector<Detail>& inner) {
        const double radius = radius_of(detail);
        Figure inset = blank_inset(figure_, context_, detail);
        StatementIndex statement = none;
        for (const PolygonVector& vector : parts.vectors)
            if (statement == none || vector.statement < statement) statement = vector.statement;
        open_group(inset, statement);
        std::get<GroupBegin>(inset.marks.back()).detail = detail.number;
        inset.marks.emplace_back(circle_of(detail, context_.theme));
        draw_parts(inset, context_, parts, inner);
        for (DrawnAxis& each : inset.axes) each.detail = detail.letter;
        inset.box = {{-radius, -radius}, {radius, radius}};
        all_free_ = place_labels(inset, context_.fonts, Spot{2 * radius + 8, 2 * radius + 2}, Labelling::if_all_free,
                                 context_.theme.secondary) &&
                    all_free_;
        add_legend(inset, context_, detail);
        inset.marks.emplace_back(GroupEnd{});
        inset.box = box_of(inset.marks);
        return inset;
    }

    /// Finds a free position that enlarges the figure least and is near the place shown. Returns the centre.
    Spot place(Figure inset, const Detail& shown, Spot of) {
        const Box box = figure_.box;
        const Spot best = free_corner(inset.box, of);
        inset.move(best.x - inset.box.min.x, best.y - inset.box.min.y);
        const Spot centre = 0.5 * (inset.box.min + inset.box.max);
        for (DetailOn& each : figure_.details)
            if (each.letter == shown.letter) each.scale = inset.scale;
        figure_.marks.insert(figure_.marks.end(), inset.marks.begin(), inset.marks.end());
        figure_.axes.insert(figure_.axes.end(), inset.axes.begin(), inset.axes.end());
        figure_.details.insert(figure_.details.end(), inset.details.begin(), inset.details.end());
        figure_.box = {{std::min(box.min.x, inset.box.min.x), std::min(box.min.y, inset.box.min.y)},
                       {std::max(box.max.x, inset.box.max.x), std::max(box.max.y, inset.box.max.y)}};
        return centre;
    }

    /// The upper left corner at which a box of the size of the inset is free and costs least. `of`: as in place().
    Spot free_corner(const Box& inset, Spot of) const {
        const Box& box = figure_.box;
        // The area that may be occupied, wherever the inset goes.
        const Spot reach{std::max(room_.x - box.width(), inset.width() + apart_from_figure),
                         std::max(room_.y - box.height(), inset.height() + apart_from_figure)};
        const Spot origin = box.min - reach;
        const Occupancy occupancy(origin, {box.width() + 2 * reach.x, box.height() + 2 * reach.y},
                                  covered(figure_.marks));
        const auto price_at = [&](double x, double y) {
            const Spot far{x + inset.width(), y + inset.height()};
            const double width = std::max(box.max.x, far.x) - std::min(box.min.x, x);
            const double height = std::max(box.max.y, far.y) - std::min(box.min.y, y);
            const double outside = std::max(0.0, width - room_.x) + std::max(0.0, height - room_.y);
            const Spot middle{0.5 * (x + far.x), 0.5 * (y + far.y)};
            return 1000 * outside + (width - box.width()) + (height - box.height()) + 0.15 * length(middle - of);
        };
        Spot best;
        double least = 1e300;
        constexpr double step = 2, rounding = 1e-6;
        const auto look = [&](int every) {
            int column = 0;
            for (double x = origin.x; x + inset.width() <= box.max.x + reach.x; x += step) {
                if (column++ % every != 0) continue;
                const double far = x + inset.width();
                const double width = std::max(box.max.x, far) - std::min(box.min.x, x);
                const double across = 1000 * std::max(0.0, width - room_.x) + (width - box.width());
                // Most columns are dearer than what was found, wherever the inset stands in them.
                const double spare = least + rounding - across;
                if (0.15 * std::abs(0.5 * (x + far) - of.x) >= spare) continue;
                int row = 0;
                for (double y = origin.y; y + inset.height() <= box.max.y + reach.y; y += step) {
                    // … and so are most places far above or below the figure.
                    if (row++ % every != 0 || box.min.y - y >= spare) continue;
                    if (y + inset.height() - box.max.y >= spare) break;
                    const double price = price_at(x, y);
                    if (price >= least) continue;
                    const Box wanted{{x - apart_from_figure, y - apart_from_figure},
                                     {x + inset.width() + apart_from_figure, y + inset.height() + apart_from_figure}};
                    if (!occupancy.is_free(wanted)) continue;
                    least = price;
                    best = {x, y};
                }
            }
        };
        // A few places tell what is too dear; of all that are equal the first one counts.
        look(8);
        least += rounding;
        look(1);
        return best;
    }

    Figure& figure_;
    const DrawingContext& context_;
    Spot room_;
    std::size_t& letters_;
    bool all_free_ = true;
};

}  // namespace

namespace {

constexpr double lane_pitch = 2.2;  // of lanes, mm: an arrowhead with a small distance

/// Whether a vector that is set aside would begin where another one begins, which begins elsewhere.
bool seems_to_begin_with(const PolygonVector& aside, const PolygonVector& other) {
    constexpr double apart = 1.2;  // mm, half of a head
    return length(aside.tail - other.tail) > coincident &&
           length(aside.tail + aside.aside - other.tail - other.aside) < apart;
}

/// Whether a vector of a polygon of motion would begin where another one begins, in this lane.
bool begins_elsewhere(const PolygonParts& parts, const PolygonVector& vector, const Lane& lane) {
    if (parts.opposites_share_label || lane.number == 0) return false;
    PolygonVector tried = vector;
    tried.aside = (lane_pitch * lane.number) * lane.normal;
    return std::any_of(parts.vectors.begin(), parts.vectors.end(),
                       [&](const PolygonVector& other) { return seems_to_begin_with(tried, other); });
}

/// Moves a vector off a longer one that it meets at a very small angle, to the side on which it lies and where nothing
/// lies yet.
void set_aside(PolygonParts& parts, PolygonVector& vector, const PolygonVector& longer) {
    const Spot along = unit(longer.tip - longer.tail), across{-along.y, along.x};
    const double off = dot(0.5 * (vector.tail + vector.tip) - longer.tail, across);
    const Spot normal = off < 0 ? -1.0 * across : across;
    PolygonVector tried = vector;
    const auto is_free = [&](const PolygonVector& other) {
        return fall_together(other, vector) ||
               (!lies_on(tried, other) && !lies_on(other, tried) && !seems_to_begin_with(tried, other));
    };
    constexpr int lanes = 6;
    for (int n = 1; n <= lanes; ++n) {
        tried.aside = (lane_pitch * nth_lane(n)) * normal;
        if (std::all_of(parts.vectors.begin(), parts.vectors.end(), is_free)) break;
        if (n == lanes) tried.aside = lane_pitch * normal;
    }
    const PolygonVector before = vector;
    for (PolygonVector& each : parts.vectors)
        if (fall_together(each, before)) each.aside = tried.aside;
}

}  // namespace

double apart_of_knot(std::size_t vectors) {
    constexpr double many = 16, in = 70;  // names, mm
    const auto names = static_cast<double>(vectors);
    return names > many ? in * names / many : 0;
}

void set_side_by_side(PolygonParts& parts) {
    // What acts from outside keeps its place before what cancels.
    std::vector<PolygonVector*> order;
    for (const bool internal : {false, true})
        for (PolygonVector& vector : parts.vectors)
            if (vector.internal == internal) order.push_back(&vector);
    std::vector<Lane> lanes;
    for (PolygonVector* const vector : order) {
        std::optional<Lane> own;
        std::optional<Spot> normal;
        std::set<int> taken;
        for (std::size_t i = 0; i < lanes.size(); ++i) {
            if (!hide_each_other(*order[i], *vector)) continue;
            if (!own && are_one_side(*order[i], *vector)) own = lanes[i];
            taken.insert(lanes[i].number);
            if (!normal) normal = lanes[i].normal;
        }
        if (!own) {
            own = Lane{0, normal ? *normal : outward(parts, *vector)};
            for (int n = 0; taken.contains(own->number) || begins_elsewhere(parts, *vector, *own);)
                own->number = nth_lane(++n);
        }
        vector->aside = (lane_pitch * own->number) * own->normal;
        lanes.push_back(*own);
    }
    if (parts.opposites_share_label) return;  // forces: their chain stays closed
    for (PolygonVector& vector : parts.vectors) {
        const auto longer = std::find_if(parts.vectors.begin(), parts.vectors.end(), [&](const PolygonVector& other) {
            return !fall_together(vector, other) && lies_on(vector, other);
        });
        if (longer != parts.vectors.end() && length(vector.aside) == 0) set_aside(parts, vector, *longer);
    }
}

std::vector<Detail> details_of(const PolygonParts& parts, double scale, double magnified, std::size_t& letters) {
    double longest = 0;
    for (const PolygonVector& vector : parts.vectors) longest = std::max(longest, length(vector.tip - vector.tail));
    for (const PolygonPiece& piece : parts.pieces) longest = std::max(longest, length(piece.to - piece.from));
    const double across = std::clamp(share_across * longest, least_across, most_across);
    std::vector<Cluster> clusters;
    for (const PolygonVector& vector : parts.vectors) {
        const double whole = length(vector.tip - vector.tail);
        if (whole < too_short && whole * beside_long < longest && whole * most_magnified > across * magnified)
            clusters.push_back({{vector.tail, vector.tip}, whole});
    }
    const std::vector<Detail> rounds = merged(clusters, scale, across);
    // Of overlapping details the one with the shortest vector is kept.
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < clusters.size(); ++i) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return clusters[a].shortest < clusters[b].shortest; });
    std::set<std::size_t> kept;
    for (const std::size_t i : order) {
        if (kept.size() == most_details || rounds[i].magnification < least_magnified) continue;
        if (std::none_of(kept.begin(), kept.end(), [&](std::size_t k) { return overlap(rounds[i], rounds[k]); }))
            kept.insert(i);
    }
    std::vector<Detail> details;
    for (const std::size_t i : kept) {
        details.push_back(rounds[i]);
        details.back().number = ++letters;
        details.back().letter = roman(letters);
    }
    return details;
}

void draw_parts(Figure& figure, const DrawingContext& context, const PolygonParts& parts,
                const std::vector<Detail>& details) {
    PartsDrawing(figure, context, parts, details).draw();
}

bool may_hold_details(const Figure& strokes, const DrawingContext& context, const std::vector<Detail>& details,
                      Spot room) {
    const Box& box = strokes.box;
    if (!(box.width() > 0 && box.height() > 0)) return true;
    // The possible positions of an inset with its margin. The figure and its occupied area only grow.
    const Spot apart{apart_from_figure, apart_from_figure};
    const Box within{box.max - room - apart, box.min + room + apart};
    if (!(within.width() > 0 && within.height() > 0)) return true;
    const Occupancy occupancy(within.min, {within.width(), within.height()}, covered(strokes.marks));
    return std::all_of(details.begin(), details.end(), [&](const Detail& detail) {
        // A lower bound of the size: circle and legend, rounded down to whole millimetres.
        Figure inset = blank_inset(strokes, context, detail);
        inset.marks.emplace_back(circle_of(detail, context.theme));
        add_legend(inset, context, detail);
        const Box least = box_of(inset.marks);
        return occupancy.has_free(static_cast<int>(least.width() + 2 * apart.x) - 1,
                                  static_cast<int>(least.height() + 2 * apart.y) - 1);
    });
}

bool set_details(Figure& figure, const DrawingContext& context, const PolygonParts& parts,
                 const std::vector<Detail>& details, Spot room, std::size_t& letters) {
    return Insets(figure, context, room, letters).set(parts, details);
}

namespace {

/// The details of a figure with new letters; `before`: number of letters in use. Nested details are last.
std::vector<DetailOn> lettered_anew(const std::vector<DetailOn>& details, std::size_t before) {
    std::vector<DetailOn> anew = details;
    for (DetailOn& each : anew) each.letter = roman(before + each.number);
    return anew;
}

/// Old and new letters of the details of a figure.
class Lettering {
public:
    Lettering(Figure& figure, const DrawingContext& context, std::size_t before)
        : figure_(figure), context_(context), was_(figure.details), is_(lettered_anew(figure.details, before)) {}

    void change() {
        for (DrawnAxis& each : figure_.axes) rename(each.detail);
        figure_.details = is_;
        for (Mark& mark : figure_.marks)
            if (auto* group = std::get_if<GroupBegin>(&mark)) {
                rename(group->id.detail);
                if (const DetailOn* detail = numbered(group->detail))
                    group->title = heading_of_detail(detail->letter, context_.language);
            }
        set_letters_anew();
    }

private:
    /// The detail with this number; null: none has it.
    const DetailOn* numbered(std::size_t number) const {
        const auto found =
            std::find_if(is_.begin(), is_.end(), [&](const DetailOn& each) { return each.number == number; });
        return found == is_.end() ? nullptr : &*found;
    }

    /// The new letter instead of the old one.
    void rename(std::string& letter) const {
        const auto old =
            std::find_if(was_.begin(), was_.end(), [&](const DetailOn& each) { return each.letter == letter; });
        if (old != was_.end()) letter = is_[static_cast<std::size_t>(old - was_.begin())].letter;
    }

    /// A longer letter may need another position beside its circle, with or without a leader; if none is free, it stays
    /// where the shorter one was. A heading stays centred.
    void set_letters_anew() {
        std::vector<Mark> before = figure_.marks;
        set_letters(true);
        // Outside all groups, so that it belongs to no detail. At the end of the marks no group is open.
        const auto end = static_cast<std::ptrdiff_t>(figure_.marks.size());
        figure_.marks.emplace_back(Path{});
        figure_.labels = std::move(letters_);
        if (place_labels(figure_, context_.fonts, Spot{figure_.box.width(), figure_.box.height()},
                         Labelling::if_all_free, context_.theme.secondary)) {
            figure_.marks.erase(figure_.marks.begin() + end);
        } else {
            figure_.labels.clear();
            figure_.marks = std::move(before);
            set_letters(false);
        }
        const Box drawn = box_of(figure_.marks);
        figure_.box = {{std::min(figure_.box.min.x, drawn.min.x), std::min(figure_.box.min.y, drawn.min.y)},
                       {std::max(figure_.box.max.x, drawn.max.x), std::max(figure_.box.max.y, drawn.max.y)}};
    }
    /// `anew`: the letters beside circles are taken away and asked for once more.
    void set_letters(bool anew) {
        std::vector<Mark> kept;
        for (Mark& mark : figure_.marks) {
            const auto* text = std::get_if<TextMark>(&mark);
            const DetailOn* const detail = text != nullptr ? numbered(text->detail) : nullptr;
            if (detail == nullptr) {
                kept.push_back(std::move(mark));
            } else if (anew && text->cls == "label") {
                drop_leader(kept, context_.theme.secondary);
                ask_letter(*detail, text->statement);
            } else {
                set_centred(kept, *text, *detail);
            }
        }
        figure_.marks = std::move(kept);
    }
    void set_centred(std::vector<Mark>& marks, const TextMark& text, const DetailOn& detail) const {
        const auto shaped = [&](const std::string& letter) {
            const bool is_heading = text.cls != "label";
            return context_.fonts.shape(one_piece(is_heading ? heading_of_detail(letter, context_.language) : letter),
                                        context_.theme.label);
        };
        const ShapedLine old = shaped(roman(detail.number)), now = shaped(detail.letter);
        const Spot at = text.glyphs.front().origin + Spot{0.5 * (old.width - now.width), 0};
        set_text(marks, now, at, text.colour, text.cls);
        belong(marks, marks.size() - 1, text.statement);
    }
    void ask_letter(const DetailOn& detail, StatementIndex statement) {
        LabelRequest& letter = letters_.emplace_back();
        letter.text = one_piece(detail.letter);
        letter.size = context_.theme.label;
        letter.colour = context_.theme.text;
        letter.anchor = detail.circle;
        letter.clearance = detail.radius + 0.8;
        letter.statement = statement;
    }

    Figure& figure_;
    const DrawingContext& context_;
    std::vector<DetailOn> was_, is_;
    std::vector<LabelRequest> letters_;
};

}  // namespace

void open_group(Figure& figure, StatementIndex statement) {
    figure.marks.emplace_back(group_of(figure, true, statement));
}

void letter_details_on(Figure& figure, const DrawingContext& context, std::size_t before) {
    if (!figure.details.empty() && before > 0) Lettering(figure, context, before).change();
}

}  // namespace kinegraph::render
