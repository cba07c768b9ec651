// Instant centres on the mechanism: the lines (Kennedy, normals) that determine them, dots, and arrows towards distant
// centres and centres at infinity. Owns which of them are shown and where lines end; computes no centre.
#include <algorithm>
#include <cmath>

#include "engine/sentences/centre_symbol.hpp"
#include "render/mechanism/centre_choice.hpp"
#include "render/mechanism/free_arc.hpp"
#include "render/mechanism/near_places.hpp"
#include "render/mechanism/sketch.hpp"

namespace kinegraph::render::drawing {

namespace {

class CentresDrawing {
public:
    explicit CentresDrawing(Sketch& sketch)
        : sketch_(sketch),
          all_(sketch.subject.solution.centres),
          where_(all_.size(), Where::nowhere),
          place_(all_.size()),
          drawn_(all_.size(), true),
          arrows_(all_.size()),
          counted_from_(all_.size()) {
        locate();
        choose();
    }

    void draw() {
        for (const std::size_t c : order_)
            if (where_[c] != Where::nowhere && drawn_[c] && !is_primary(c)) construct(c);
        for (const Ray& ray : rays_) {
            const Interval seen = within(grown(view_, 12), ray.at, ray.along);
            const double from = std::max(ray.from, seen.from), to = std::min(ray.to, seen.to);
            if (to <= from) continue;
            sketch_.construction.emplace_back(line(ray.at + from * ray.along, ray.at + to * ray.along, sketch_.thin()));
            belong(sketch_.construction, sketch_.construction.size() - 1, ray.statement);
        }
        // Coincident centres share one dot and one label. Bodies without relative motion have no centre.
        std::vector<bool> done(all_.size(), false);
        for (const std::size_t c : order_) {
            if (where_[c] == Where::nowhere || done[c] || !drawn_[c]) continue;
            std::vector<std::size_t> cluster{c};
            for (const std::size_t d : order_)
                if (d != c && !done[d] && drawn_[d] && together(c, d)) cluster.push_back(d);
            for (const std::size_t d : cluster) done[d] = true;
            LabelRequest label = where_[c] == Where::here ? draw_dots(cluster) : draw_arrows(cluster);
            if (!label.text.empty()) sketch_.labels.push_back(std::move(label));
        }
        keep_room_for_names_from_afar();
    }

    /// Names of centres that could be drawn but are not.
    std::vector<RichText> left_out() const {
        std::vector<RichText> names;
        for (const std::size_t c : order_)
            if (where_[c] != Where::nowhere && !drawn_[c]) names.push_back(name_of_centre(c));
        return names;
    }

private:
    enum class Where { nowhere, here, far, infinity };
    /// A construction line, drawn once even if it contains several centres.
    struct Ray {
        Spot at, along;
        double from, to;
        StatementIndex statement;  // the first statement that draws it
    };
    struct Arrow {
        Spot base, along;
    };
    struct Named {
        RichText name;
        Spot at;
    };

    static constexpr double rim = 9;          // margin round everything that is near, mm
    static constexpr double broken_end = 10;  // end of a line to a distant centre, mm

    bool is_primary(std::size_t c) const { return all_[c].how == InstantCentre::How::primary; }
    Symbol symbol(std::size_t c) const { return symbol_of(sketch_.mechanism, all_[c]); }
    RichText name_of_centre(std::size_t c) const { return typeset(symbol(c), sketch_.context.language); }
    GroupBegin group(std::size_t c) const {
        const std::string& i = sketch_.mechanism.body(all_[c].first).name;
        const std::string& j = sketch_.mechanism.body(all_[c].second).name;
        GroupBegin group{"centre", sketch_.id("centre", i + "." + j), plain(name_of_centre(c)), {}, all_[c].statement};
        group.cited_as = name_of(symbol(c));
        return group;
    }

    /// Classifies each centre: near the mechanism, distant, or at infinity.
    void locate() {
        std::vector<Spot> places;
        for (const InstantCentre& centre : all_)
            if (centre.at && !centre.at->at_infinity()) places.push_back(sketch_.spot(centre.at->place()));
        view_ = with_near_places(sketch_.mechanism_box(), std::move(places), growth_for_places * sketch_.size());
        for (std::size_t c = 0; c < all_.size(); ++c) {
            if (!all_[c].at) continue;
            if (all_[c].at->at_infinity()) {
                where_[c] = Where::infinity;
                place_[c] = paper_direction(all_[c].at->place());
                continue;
            }
            place_[c] = sketch_.spot(all_[c].at->place());
            if (!std::isfinite(place_[c].x) || !std::isfinite(place_[c].y)) continue;  // beyond the range of doubles
            where_[c] = contains(view_, place_[c]) ? Where::here : Where::far;
        }
        take_in_what_is_beside();
        view_ = grown(view_, rim);
    }
    /// A distant centre that lies within the space of its own arrow is shown itself.
    void take_in_what_is_beside() {
        const auto beside = [&] {
            std::size_t c = 0;
            while (c < all_.size() && (where_[c] != Where::far || !contains(grown(view_, rim), place_[c]))) ++c;
            return c;
        };
        for (std::size_t c = beside(); c < all_.size(); c = beside()) {
            where_[c] = Where::here;
            view_.include(place_[c]);
        }
    }

    /// Centres in the order found; if there are many or space is short, only those that are needed.
    void choose() {
        for (std::size_t c = 0; c < all_.size(); ++c) order_.push_back(c);
        std::stable_sort(order_.begin(), order_.end(),
                         [&](std::size_t a, std::size_t b) { return all_[a].order < all_[b].order; });
        double secondary = 0;
        for (std::size_t c = 0; c < all_.size(); ++c) secondary += all_[c].at && !is_primary(c) ? 1 : 0;
        constexpr double room_for_one = 700;  // mm² per centre
        if (secondary > 14 || view_.width() * view_.height() < room_for_one * secondary)
            drawn_ = needed_centres(sketch_.subject.solution);
    }

    /// Draws the lines that determine centre c: those that found it, or, where the velocities did, lines of centres.
    void construct(std::size_t c) {
        std::vector<Ray> own;
        for (const auto& [a, b] : all_[c].through) construct(c, {at_index(a), at_index(b)}, own);
        for (const PointIndex point : all_[c].normals) construct(c, {sketch_.spot(point)}, std::nullopt, own);
        for (const Join& join : further_joins(c)) {
            if (own.size() >= 2) break;
            construct(c, join, own);
        }
    }

    /// Two centres, by their indices, whose join contains a third.
    using Join = std::pair<std::size_t, std::size_t>;
    /// By Kennedy's theorem the centres P_ik and P_kj of any third body k are in line with P_ij. Those that are most
    /// easily found first: hinges, then what is seen.
    std::vector<Join> further_joins(std::size_t c) const {
        using enum InstantCentre::How;
        if (all_[c].how != velocities && all_[c].how != accelerations) return {};
        std::vector<Join> joins;
        for (const BodyIndex k : indices_of(sketch_.mechanism.bodies)) {
            if (k == all_[c].first || k == all_[c].second) continue;
            const Join join{index_of_centre(sketch_.mechanism, all_[c].first, k),
                            index_of_centre(sketch_.mechanism, k, all_[c].second)};
            const auto serves = [&](std::size_t one) {
                return where_[one] != Where::nowhere && drawn_[one] && !all_[one].everywhere;
            };
            if (serves(join.first) && serves(join.second) && !together(join.first, join.second)) joins.push_back(join);
        }
        const auto effort = [&](const Join& join) {
            int sum = 0;
            for (const std::size_t one : {join.first, join.second})
                sum += is_primary(one) ? 0 : where_[one] == Where::here ? 1 : 2;
            return sum;
        };
        std::stable_sort(joins.begin(), joins.end(),
                         [&](const Join& a, const Join& b) { return effort(a) < effort(b); });
        return joins;
    }

    void construct(std::size_t c, const Join& join, std::vector<Ray>& own) {
        std::vector<Spot> known;
        std::optional<Spot> direction;
        for (const std::size_t k : {join.first, join.second}) {
            if (where_[k] == Where::infinity) direction = place_[k];
            if (where_[k] == Where::here || where_[k] == Where::far) known.push_back(place_[k]);
        }
        // Start from visible centres.
        std::stable_sort(known.begin(), known.end(),
                         [&](Spot p, Spot q) { return contains(view_, p) && !contains(view_, q); });
        construct(c, known, direction, own);
    }

    /// A line through the finite places `known` (and in `direction`) to centre c and a little beyond; joins `own`, the
    /// lines of this centre, unless it is one of them.
    void construct(std::size_t c, const std::vector<Spot>& known, std::optional<Spot> direction,
                   std::vector<Ray>& own) {
        if (known.empty()) return;
        const Spot start = known[0];
        Spot along;
        if (where_[c] != Where::infinity && length(place_[c] - start) > same_place)
            along = unit(place_[c] - start);
        else if (direction)
            along = *direction;
        else if (where_[c] == Where::infinity)
            along = place_[c];
        else if (known.size() > 1 && length(known[1] - start) > same_place)
            along = unit(known[1] - start);
        else
            return;
        Ray ray{start, along, 0, 0, all_[c].statement};
        if (std::any_of(own.begin(), own.end(), [&](const Ray& other) { return is_one_line(ray, other); })) return;
        own.push_back(ray);
        const auto take = [&](Spot spot) {
            ray.from = std::min(ray.from, dot(spot - start, along));
            ray.to = std::max(ray.to, dot(spot - start, along));
        };
        for (const Spot spot : known)
            if (contains(view_, spot)) take(spot);
        if (where_[c] == Where::here) {
            const double t = dot(place_[c] - start, along);
            // Between places outside the drawing it is seen about its centre only.
            if (!contains(view_, start)) ray.from = ray.to = t;
            take(place_[c]);
            if (t >= ray.to - 1e-9) ray.to += overshoot;
            if (t <= ray.from + 1e-9) ray.from -= overshoot;
        } else {
            for (std::size_t k = 0; k < known.size() && !counted_from_[c]; ++k) counted_from_[c] = name_at(known[k]);
            leave_the_drawing(c, ray);
        }
        draw_once(ray);
    }

    /// Extends the line towards a distant centre (to the edge of the view) or one at infinity (a little), with an arrow
    /// that names it.
    void leave_the_drawing(std::size_t c, Ray& ray) {
        const Interval seen = within(view_, ray.at, ray.along);
        bool forward = dot(place_[c] - ray.at, ray.along) > 0;
        if (where_[c] == Where::infinity) {
            // Either end is possible, but all lines use the same one: that with fewer collisions.
            if (arrows_[c])
                forward = dot(arrows_[c]->along, ray.along) > 0;
            else
                forward = obstruction(ray, ray.to, 1) + 0.01 * (seen.to - ray.to) <=
                          obstruction(ray, ray.from, -1) + 0.01 * (ray.from - seen.from);
        }
        constexpr double beyond = 16;
        if (forward)
            ray.to = where_[c] == Where::far ? base_of_arrow(c, ray, 1, seen.to) : ray.to + beyond;
        else
            ray.from = where_[c] == Where::far ? base_of_arrow(c, ray, -1, -seen.from) : ray.from - beyond;
        if (!arrows_[c])
            arrows_[c] = Arrow{ray.at + (forward ? ray.to : ray.from) * ray.along, (forward ? 1.0 : -1.0) * ray.along};
    }
    /// Where on the ray the arrow to a distant centre begins: soon behind its last centre, or nearer to the edge of the
    /// view if there is less in its way and the name has room at its head.
    double base_of_arrow(std::size_t c, const Ray& ray, double sense, double edge) {
        constexpr double both_seen = 8, step = 4, per_millimetre = 0.05;
        // Worth sixty millimetres: a leader would cross what the arrow leaves behind.
        constexpr double without_name = 3;
        constexpr double among_lines = 1.5;  // within the mechanism lines to other centres will pass
        constexpr double at_another_centre = 6;
        const FreePaper& paper = paper_of(sketch_);
        const InkBox name = box_of_name(sketch_, name_from_afar(c));
        const double last = sense > 0 ? ray.to : ray.from;
        const double first = sense * last + both_seen, most = std::max(first, edge - 0.6 * broken_end);
        const double rest = std::fmod(most - first, step);  // so that the last one begins at the edge of the view
        Cheapest<double> best;
        for (double on = first; on < most + step / 2; on += on == first && rest > 0 ? rest : step) {
            double price = obstruction(ray, sense * on, sense) + per_millimetre * (on - first);
            if (price >= best.price) continue;
            const Spot tip = ray.at + sense * (on + broken_end) * ray.along;
            if (!paper.room_about(tip, name)) price += without_name;
            if (contains(sketch_.mechanism_box(), tip)) price += among_lines;
            if (points_at_another({ray.at + sense * on * ray.along, tip})) price += at_another_centre;
            best.offer(price, sense * on);
        }
        return best.choice;
    }
    /// Whether an arrow runs over or ends beside a centre that is seen, whose arrow it would seem to be.
    bool points_at_another(const Bar& arrow) const {
        constexpr double beside = 2.5;  // mm
        for (std::size_t c = 0; c < all_.size(); ++c)
            if (where_[c] == Where::here && drawn_[c] && distance(place_[c], arrow) < beside) return true;
        return false;
    }
    double obstruction(const Ray& ray, double end, double sense) const {
        double sum = 0;
        for (int step = 1; step <= 6; ++step) {
            const Spot at = ray.at + (end + sense * 3.0 * step) * ray.along;
            sum += 2 * sketch_.crowding(at, at);
            for (const Joint& joint : sketch_.mechanism.joints)
                if (is_fixed_pin(joint) && length(sketch_.spot(joint) + Spot{0, 5} - at) < 6) sum += 3;
        }
        return sum;
    }

    static bool is_one_line(const Ray& a, const Ray& b) {
        return std::abs(cross(a.along, b.along)) < 1e-6 && std::abs(cross(a.along, b.at - a.at)) < 1e-3;
    }
    void draw_once(const Ray& added) {
        for (Ray& ray : rays_)
            if (is_one_line(ray, added)) {
                const double a = dot(added.at + added.from * added.along - ray.at, ray.along);
                const double b = dot(added.at + added.to * added.along - ray.at, ray.along);
                ray.from = std::min({ray.from, a, b});
                ray.to = std::max({ray.to, a, b});
                return;
            }
        rays_.push_back(added);
    }

    std::optional<Named> name_at(Spot at) const {
        if (const auto name = name_of_point_at(sketch_, at)) return Named{*name, at};
        for (std::size_t c = 0; c < all_.size(); ++c)
            if (where_[c] == Where::here && coincide(place_[c], at)) return Named{name_of_centre(c), at};
        return std::nullopt;
    }

    bool together(std::size_t c, std::size_t d) const {
        if (where_[c] != where_[d]) return false;
        if (where_[c] == Where::here) return coincide(place_[d], place_[c]);
        if (where_[c] == Where::far) return length(place_[d] - place_[c]) < 1e-6 * length(place_[c]) + same_place;
        return !is_primary(d) && arrows_[c] && arrows_[d] && length(arrows_[c]->base - arrows_[d]->base) < 2;
    }

    LabelRequest label_of(const std::vector<std::size_t>& cluster, bool at_pin) const {
        LabelRequest label{
            .size = sketch_.theme.label, .colour = sketch_.theme.text, .statement = all_[cluster.front()].statement};
        for (const std::size_t d : cluster) {
            // A pin has its own name; the centre there is shown only on hovering.
            if (at_pin && is_primary(d)) continue;
            if (!label.text.empty()) append(label.text, one_piece(" ≡ "));
            append(label.text, name_of_centre(d));
            label.names.push_back(name_of(symbol(d)));
        }
        return label;
    }

    LabelRequest draw_dots(const std::vector<std::size_t>& cluster) {
        const Spot at = place_[cluster.front()];
        const std::vector<Joint>& joints = sketch_.mechanism.joints;
        const bool pin_there = std::any_of(joints.begin(), joints.end(), [&](const Joint& joint) {
            return (joint.pair().has_pin() || joint.pair().is_clamp()) && coincide(sketch_.spot(joint), at);
        });
        const double pin = sketch_.measures.pin_radius;
        // A full dot or its ring would hide part of a pin that it overlaps.
        const bool beside_pin = !pin_there && std::any_of(joints.begin(), joints.end(), [&](const Joint& joint) {
            return joint.pair().has_pin() && length(sketch_.spot(joint) - at) < pin + 0.8;
        });
        const bool at_pin =
            pin_there && std::any_of(cluster.begin(), cluster.end(), [&](std::size_t d) { return is_primary(d); });
        const Theme& theme = sketch_.theme;
        for (const std::size_t d : cluster) {
            std::vector<Mark>& marks = sketch_.centres;
            marks.emplace_back(group(d));
            // A dot on a stroke gets a white ring, or a dark link would hide it.
            if (!pin_there && !beside_pin && sketch_.crowding(at, at) > 0)
                marks.emplace_back(tinted(disc(at, 1.15, theme.paper)));
            if (at_pin && is_primary(d))
                marks.emplace_back(tinted(disc(at, 0.6 * pin, theme.paper)));
            else
                marks.emplace_back(disc(at, at_pin || beside_pin ? 0.55 : 0.8, theme.text));
            marks.emplace_back(GroupEnd{});
        }
        LabelRequest label = label_of(cluster, at_pin);
        label.anchor = at;
        label.clearance = at_pin ? pin + 0.8 : 1.7;
        return label;
    }

    /// Start and length of the arrow to a centre outside the drawing.
    struct Shaft {
        Spot base, along;
        double length = 3;
    };
    Shaft shaft_of(std::size_t c) const {
        if (where_[c] == Where::infinity && is_primary(c))
            for (const Joint& joint : sketch_.mechanism.joints)
                if (joint.pair().is_sleeve() && joint.connects(all_[c].first) && joint.connects(all_[c].second))
                    return shaft_from_slide(joint.point, place_[c]);
        if (arrows_[c]) {
            const auto& [base, along] = *arrows_[c];
            return where_[c] == Where::far ? Shaft{base, along, broken_end} : Shaft{base, along};
        }
        const Spot start = sketch_.shape(all_[c].second).middle;
        return {start, where_[c] == Where::infinity ? place_[c] : unit(place_[c] - start), 18};
    }
    /// Perpendicular to the guide, from the slider, on the side without links.
    Shaft shaft_from_slide(PointIndex slider, Spot across) const {
        const Spot at = sketch_.spot(slider);
        double up = 0, down = 0;
        for (const Spot link : sketch_.leaving(slider)) {
            up = std::max(up, dot(link, across));
            down = std::max(down, -dot(link, across));
        }
        const bool inward = dot(across, at - sketch_.mechanism_box().middle()) < 0;
        const bool flip = up > down + 0.05 || (std::abs(up - down) <= 0.05 && inward);
        return {at, (flip ? -1.0 : 1.0) * across, sketch_.measures.slider_side + 15};
    }

    LabelRequest draw_arrows(const std::vector<std::size_t>& cluster) {
        const std::size_t c = cluster.front();
        const Shaft shaft = shaft_of(c);
        const Spot tip = shaft.base + shaft.length * shaft.along;
        const Theme& theme = sketch_.theme;
        // The arrow is drawn below the blocks, with its head beyond them.
        std::vector<Mark>& marks = sketch_.construction;
        for (const std::size_t d : cluster) {
            marks.emplace_back(group(d));
            // An arrow has a name: a centre's further lines end without a head.
            draw_arrow(marks, shaft.base, tip, theme.thin, theme.secondary);
            marks.emplace_back(GroupEnd{});
        }
        LabelRequest label = label_of(cluster, false);
        if (where_[c] == Where::far) append(label.text, how_far_is(c));
        label.anchor = tip;
        label.clearance = 1.2;
        return label;
    }

    /// They are wide, so that arrows of motion must not take their places.
    void keep_room_for_names_from_afar() {
        for (std::size_t c = 0; c < all_.size(); ++c) {
            if (where_[c] != Where::far || !drawn_[c] || !arrows_[c]) continue;
            FreePaper& paper = paper_of(sketch_);
            const Spot tip = arrows_[c]->base + broken_end * arrows_[c]->along;
            if (const auto place = paper.room_about(tip, box_of_name(sketch_, name_from_afar(c)))) paper.take(*place);
        }
    }
    /// "  (O4 P_13 = 1.84 m)": the segment that does not fit into the drawing.
    RichText how_far_is(std::size_t c) const {
        const std::optional<Named>& from = counted_from_[c];
        return from ? how_far(sketch_, from->name, name_of_centre(c), length(place_[c] - from->at)) : RichText{};
    }
    RichText name_from_afar(std::size_t c) const {
        RichText text = name_of_centre(c);
        append(text, how_far_is(c));
        return text;
    }

    Sketch& sketch_;
    const std::vector<InstantCentre>& all_;
    std::vector<Where> where_;
    std::vector<Spot> place_;  // on paper, or the unit direction for a centre at infinity
    std::vector<bool> drawn_;
    std::vector<std::size_t> order_;
    Box view_;
    std::vector<Ray> rays_;
    std::vector<std::optional<Arrow>> arrows_;  // to each centre that the drawing does not reach, on its first line
    std::vector<std::optional<Named>> counted_from_;  // reference of the distance of a distant centre
};

}  // namespace

Symbol symbol_of(const Mechanism& mechanism, const InstantCentre& centre) {
    return centre_symbol(mechanism, centre.first, centre.second, centre.at && centre.at->at_infinity());
}

void draw_pole(Sketch& sketch, const InstantCentre& centre) {
    const Spot at = sketch.spot(centre.at->place());
    for (const Joint& joint : sketch.mechanism.joints)
        if (coincide(sketch.spot(joint), at)) return;
    if (!sketch.poles.emplace(centre.first, centre.second).second) return;
    const RichText name = typeset(symbol_of(sketch.mechanism, centre), sketch.context.language);
    for (LabelRequest& label : sketch.labels)
        if (!label.toward && coincide(label.anchor, at)) return label.add_name(name);
    sketch.centres.emplace_back(disc(at, 0.8, sketch.theme.text));
    belong(sketch.centres, sketch.centres.size() - 1, centre.statement);
    sketch.add_label(name, sketch.theme.text, at, 1.7, centre.statement);
}

std::vector<RichText> draw_centres(Sketch& sketch) {
    CentresDrawing drawing(sketch);
    drawing.draw();
    return drawing.left_out();
}

}  // namespace kinegraph::render::drawing
