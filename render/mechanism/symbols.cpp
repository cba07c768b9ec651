// The symbols of a mechanism (ISO 3952): ground, guides, blocks, slots, wheels, links, pins, mass centres, drivers, compass
// strokes and names. Owns how each is drawn; where it stands the shapes say.
#include <algorithm>
#include <array>

#include "render/mechanism/sketch.hpp"

namespace kinegraph::render::drawing {

namespace {

std::string without_filling_zeros(double value, Language language, int digits) {
    std::string text = number(value, digits, language);
    const std::size_t mark = text.find_first_of(".,");
    if (mark == std::string::npos) return text;
    std::size_t end = mark + 1;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
    std::size_t keep = end;
    while (keep > mark + 1 && text[keep - 1] == '0') --keep;
    if (keep == mark + 1) keep = mark;
    text.erase(keep, end - keep);
    return text;
}

}  // namespace

std::string given_number(double value, Language language) {
    std::string six = without_filling_zeros(value, language, 6), four = without_filling_zeros(value, language, 4);
    // Six digits are for round values; of 120 rpm in rad/s four tell enough.
    return four.size() + 1 < six.size() ? four : six;
}

/// Ground: a line with hatching on the side `away`.
void Sketch::draw_wall(Spot from, Spot to, Spot away) {
    const Pen edge{theme_.outline, theme_.text, {}, false}, hatch{theme_.thin, theme_.text, {}, false};
    const Spot along = unit(to - from);
    const double whole = length(to - from);
    const double depth_along = hatch_depth_;
    Path strokes;
    strokes.stroked = true;
    strokes.pen = hatch;
    const int count = std::max(2, static_cast<int>(std::floor(whole / hatch_pitch_)));
    const double pitch = whole / count;
    for (int i = 1; i <= count; ++i) {
        const double t = i * pitch, back = std::min(depth_along, t);
        strokes.segments.emplace_back(MoveTo{from + t * along});
        strokes.segments.emplace_back(LineTo{from + (t - back) * along + back * away});
    }
    ground.emplace_back(std::move(strokes));
    ground.emplace_back(line(from, to, edge));
}

/// Hatching of the ground along an arc.
void Sketch::hatch_arc(Spot centre, double radius, double from, double to, bool outwards) {
    Path hatching;
    hatching.stroked = true;
    hatching.pen = {theme_.thin, theme_.text, {}, false};
    const double depth = (outwards ? 1 : -1) * std::min(hatch_depth_, 0.4 * radius);
    const int count = std::max(4, static_cast<int>((to - from) * radius / hatch_pitch_));
    for (int i = 0; i < count; ++i) {
        const double angle = from + (to - from) * i / count, lean = angle + std::abs(depth) / radius;
        hatching.segments.emplace_back(MoveTo{centre + radius * polar_spot(angle)});
        hatching.segments.emplace_back(LineTo{centre + (radius + depth) * polar_spot(lean)});
    }
    ground.emplace_back(std::move(hatching));
}

void Sketch::draw_fixed_pin(PointIndex point) {
    const Spot at = spot(point);
    std::vector<Spot> links = leaving(point);
    for (const Joint& joint : m_.joints)
        if (const Spot d = spot(joint.point) - at; length(d) > same_place && length(d) < triangle_height_ + hatch_depth_ + 2)
            links.push_back(unit(d));  // a pin where the triangle would stand
    // Down first, then the sides, then up; away from links and from the arrow of a crank.
    const std::array<std::pair<Spot, double>, 4> choices{
        {{Spot{0, 1}, 0.0}, {Spot{1, 0}, 0.35}, {Spot{-1, 0}, 0.35}, {Spot{0, -1}, 0.6}}};
    Spot down{0, 1};
    double least = 1e300;
    for (const auto& [direction, bias] : choices) {
        double price = bias;
        for (const Spot link : links) {
            const double angle = std::acos(std::clamp(dot(link, direction), -1.0, 1.0));
            if (angle < 1.2) price += 2.5 * (1.2 - angle);
        }
        for (const auto& [pivot, arrow] : arcs_of_drivers_)
            if (length(pivot - at) < same_place) {
                const double angle = std::acos(std::clamp(dot(unit(arrow - pivot), direction), -1.0, 1.0));
                if (angle < 1.2) price += 1.0 * (1.2 - angle);
            }
        if (price < least - 1e-9) {
            least = price;
            down = direction;
        }
    }
    const Spot across = turned(down), base = at + triangle_height_ * down;
    Path triangle = polyline({at, base + triangle_half_ * across, base - triangle_half_ * across},
                             {theme_.outline, theme_.text, {}, false}, true);
    triangle.filled = triangle.tinted = true;
    triangle.fill = theme_.paper;
    ground.emplace_back(std::move(triangle));
    draw_wall(base + base_half_ * across, base - base_half_ * across, down);
}

/// Guides of the frame: axis and walls on both sides, open where a link passes.
void Sketch::draw_guides() {
    for (std::size_t j = 0; j < m_.joints.size(); ++j) {
        const Joint& joint = m_.joints[j];
        if (joint.bodies.size() != 2 || length(s_.guides[j]) == 0) continue;
        const Spot at = spot(joint.point), along = s_.guides[j];
        const auto walls = [&](double side_distance, double half, bool heed_links) {
            for (const double side : {1.0, -1.0}) {
                const Spot away = side * turned(along);
                std::vector<Interval> pieces{{-half, half}};
                for (const Spot link : heed_links ? leaving(joint.point) : std::vector<Spot>{}) {
                    const double rise = dot(link, away), run = dot(link, along);
                    if (rise < 0.08) continue;
                    const double crossing = side_distance * run / rise, gap = 2.6 / rise + 1.2 * std::abs(run) / rise;
                    std::vector<Interval> rest;
                    // A link that passes beside the block would leave a stub: that side stays open.
                    const bool beside = std::abs(crossing) - gap < slider_half_;
                    for (const Interval piece : pieces) {
                        if (beside) break;
                        if (piece.from < crossing - gap) rest.push_back({piece.from, std::min(piece.to, crossing - gap)});
                        if (piece.to > crossing + gap) rest.push_back({std::max(piece.from, crossing + gap), piece.to});
                    }
                    pieces = rest;
                }
                for (const Interval piece : pieces)
                    if (piece.to - piece.from > 6)
                        draw_wall(at + piece.from * along + side_distance * away, at + piece.to * along + side_distance * away,
                                  away);
            }
        };
        if (joint.pair().is_sleeve() && joint.bodies[1] == 0) {
            const double half = slider_half_ + axis_beyond_;
            construction.emplace_back(
                line(at - half * along, at + half * along, {theme_.thin, theme_.secondary, dash_dot(), false}));
            // A wall ends before the next pin on its way.
            double reach = slider_half_ + wall_beyond_;
            for (const Joint& other : m_.joints) {
                const Spot d = spot(other.point) - at;
                const double ahead = std::abs(dot(d, along));
                if (ahead > slider_half_ && std::abs(cross(d, along)) < slider_side_ + 3)
                    reach = std::min(reach, std::max(ahead - 3.5, slider_half_ + 2));
            }
            walls(slider_side_ + theme_.vector / 2 + theme_.outline / 2, reach, true);
        } else if (joint.pair().is_sleeve() && joint.bodies[0] == 0) {
            walls(theme_.link / 2 + 0.5, sleeve_half_, false);
        } else if (joint.pair().is_slot() && joint.bodies[1] == 0) {
            const double half = slider_half_ + axis_beyond_;
            construction.emplace_back(
                line(at - half * along, at + half * along, {theme_.thin, theme_.secondary, dash_dot(), false}));
            walls(slot_side_, slot_half_ + 3, false);
        }
    }
}

void Sketch::draw_block(const Joint& joint, std::size_t index, std::vector<Mark>& marks) {
    const BodyIndex body = joint.bodies[0];
    if (body == 0) return;
    if (const Cylinder* cylinder = cylinder_of(index)) return draw_piston(*cylinder, body, marks);
    const bool on_frame = joint.bodies[1] == 0;
    const double half = on_frame ? slider_half_ : sleeve_half_, side = on_frame ? slider_side_ : sleeve_side_;
    const Spot at = spot(joint.point), u = half * s_.guides[index], w = side * turned(s_.guides[index]);
    Path block = polyline({at + u + w, at + u - w, at - u - w, at - u + w}, pen_of(body, theme_.vector), true);
    block.filled = block.tinted = true;
    block.fill = tint_colour(body);
    marks.emplace_back(std::move(block));
}

void Sketch::draw_slot(const Bar& slot, BodyIndex body, std::vector<Mark>& marks) {
    const Spot along = unit(slot.to - slot.from), across = slot_side_ * turned(along);
    const double a = std::atan2(along.y, along.x);
    Path path;
    path.segments = {MoveTo{slot.from + across}, ArcTo{slot.from, slot_side_, a + pi_number / 2, a + 3 * pi_number / 2},
                     LineTo{slot.to - across}, ArcTo{slot.to, slot_side_, a - pi_number / 2, a + pi_number / 2}, Close{}};
    path.filled = path.tinted = true;
    path.fill = theme_.paper;
    path.stroked = true;
    path.pen = pen_of(body, theme_.vector);
    marks.emplace_back(std::move(path));
}

void Sketch::draw_curved_slot(const Joint& joint, std::vector<Mark>& marks) {
    const auto [centre, radius, from, to] = curved_slot(joint);
    if (radius <= 0) return;
    const Spot start = centre + radius * polar_spot(from), end = centre + radius * polar_spot(to);
    Path path;
    path.segments = {MoveTo{centre + (radius + slot_side_) * polar_spot(from)},
                     ArcTo{centre, radius + slot_side_, from, to},
                     ArcTo{end, slot_side_, to, to + pi_number},
                     ArcTo{centre, radius - slot_side_, to, from},
                     ArcTo{start, slot_side_, from + pi_number, from + 2 * pi_number},
                     Close{}};
    path.filled = path.tinted = true;
    path.fill = theme_.paper;
    path.stroked = true;
    const BodyIndex body = joint.bodies[1];
    path.pen = pen_of(body, body == 0 ? theme_.outline : theme_.vector);
    if (body == 0) {
        hatch_arc(centre, radius + slot_side_, from, to, true);
        if (radius > 3 * slot_side_) hatch_arc(centre, radius - slot_side_, from, to, false);
    }
    (body == 0 ? ground : marks).emplace_back(std::move(path));
}

/// Plate, bars and knife edges in one pen.
void Sketch::draw_strokes(const Shape& shape, const Pen& stroke, std::vector<Mark>& marks) const {
    if (shape.solid) marks.emplace_back(filled(shape.plate, stroke.colour));
    if (!shape.plate.empty()) marks.emplace_back(polyline(shape.plate, stroke, true));
    for (const Bar& bar : shape.bars)
        if (length(bar.to - bar.from) > 1e-6) marks.emplace_back(line(bar.from, bar.to, stroke));
    for (const Bar& edge : shape.edges) {
        const Spot across = (stroke.width / 2) * turned(unit(edge.to - edge.from));
        marks.emplace_back(filled({edge.from + across, edge.to, edge.from - across}, stroke.colour));
    }
}

/// Where a link passes over others that it does not join: the lower one is interrupted on both sides of it.
void Sketch::draw_crossings(BodyIndex body, const std::vector<BodyIndex>& below, std::vector<Mark>& marks) {
    constexpr double gap = 0.7, least_sine = 0.25;
    const auto strokes_of = [&](BodyIndex of) {
        std::vector<Bar> strokes = shape(of).bars;
        const std::vector<Spot>& plate = shape(of).plate;
        for (std::size_t i = 0; i < plate.size(); ++i) strokes.push_back({plate[i], plate[(i + 1) % plate.size()]});
        return strokes;
    };
    // A pin or a block says by itself what is joined.
    const auto is_joined = [&](Spot at) {
        for (std::size_t j = 0; j < m_.joints.size(); ++j) {
            const Spot d = at - spot(m_.joints[j].point);
            if (length(d) < pin_radius_ + theme_.link) return true;
            if (m_.joints[j].pair().is_sleeve() && std::abs(dot(d, s_.guides[j])) < slider_half_ + theme_.link &&
                std::abs(cross(d, s_.guides[j])) < slider_side_ + theme_.link)
                return true;
        }
        return false;
    };
    const std::vector<Bar> own = strokes_of(body);
    for (const BodyIndex lower : below) {
        std::vector<Path> gaps;
        for (const Bar& under : strokes_of(lower))
            for (const Bar& over : own) {
                const Spot u = over.to - over.from, v = under.to - under.from, d = under.from - over.from;
                const double whole_u = length(u), whole_v = length(v), turn = cross(u, v);
                if (std::abs(turn) < least_sine * whole_u * whole_v) continue;
                const double t = cross(d, v) / turn * whole_u, w = cross(d, u) / turn * whole_v;
                const double margin = theme_.link;
                if (t < margin || t > whole_u - margin || w < margin || w > whole_v - margin) continue;
                const Spot at = over.from + (t / whole_u) * u;
                if (is_joined(at)) continue;
                const double sine = std::abs(turn) / (whole_u * whole_v), cosine = std::abs(dot(u, v)) / (whole_u * whole_v);
                const double half = (0.5 * theme_.link + (0.5 * theme_.link + gap) * cosine) / sine + 0.1;
                const Spot along = half * unit(u);
                gaps.push_back(line(at - along, at + along, {theme_.link + 2 * gap, theme_.paper, {}, false}));
            }
        if (gaps.empty()) continue;
        const std::string names = m_.bodies[at_index(lower)].name + "." + m_.bodies[at_index(body)].name;
        marks.emplace_back(GroupBegin{"crossing", id("crossing", names), {}, {}});
        for (Path& path : gaps) marks.emplace_back(std::move(path));
        marks.emplace_back(GroupEnd{});
    }
}

/// Barrel of the body that carries the guide, open at the rod's end but for its wall.
void Sketch::draw_barrel(const Cylinder& cylinder, BodyIndex body, std::vector<Mark>& marks) const {
    const Spot along = unit(cylinder.barrel.to - cylinder.barrel.from), w = sleeve_side_ * turned(along);
    const auto& [from, to] = cylinder.barrel;
    Path barrel = polyline({from + w, to + w, to - w, from - w}, pen_of(body, theme_.vector), true);
    barrel.filled = barrel.tinted = true;
    barrel.fill = tint_colour(body);
    marks.emplace_back(std::move(barrel));
}

void Sketch::draw_piston(const Cylinder& cylinder, BodyIndex body, std::vector<Mark>& marks) const {
    const Spot along = unit(cylinder.barrel.to - cylinder.barrel.from);
    const Spot u = 1.2 * along, w = (sleeve_side_ - theme_.vector / 2 - 0.25) * turned(along);
    const Spot at = cylinder.piston;
    marks.emplace_back(filled({at + u + w, at + u - w, at - u - w, at - u + w}, line_colour(body)));
}

/// A coil between two points; where they are too near for one, a line (a rope looks so, too).
void Sketch::draw_spring(const SpringLoad& spring) {
    const Spot from = spot(spring.between[0]), to = spot(spring.between[1]);
    const Pen pen{theme_.outline, theme_.text, {}, false};
    const Spot along = unit(to - from), across = turned(along);
    const double whole = length(to - from), straight = std::clamp(0.15 * whole, 2.5, 8.0);
    constexpr double pitch = 2.4, amplitude = 2.0;
    std::vector<Spot> spots{from};
    if (const double coiled = whole - 2 * straight; coiled > 2 * pitch) {
        const int turns = static_cast<int>(coiled / pitch);
        const double step = coiled / turns;
        spots.push_back(from + straight * along);
        for (int i = 0; i < turns; ++i) {
            spots.push_back(from + (straight + (i + 0.25) * step) * along + amplitude * across);
            spots.push_back(from + (straight + (i + 0.75) * step) * along - amplitude * across);
        }
        spots.push_back(to - straight * along);
    }
    spots.push_back(to);
    ground.emplace_back(GroupBegin{"spring", id("spring", spring.name), spring.name, {}});
    ground.emplace_back(polyline(spots, pen));
    ground.emplace_back(GroupEnd{});
    for (const std::size_t end : {0U, 1U}) {
        const Spot at = end == 0 ? from : to, away = end == 0 ? -1.0 * along : along;
        const bool pinned = std::any_of(m_.joints.begin(), m_.joints.end(), [&](const Joint& joint) {
            return Subject::is_fixed_pin(joint) && length(spot(joint.point) - at) < same_place;
        });
        if (spring.bodies[end] == 0 && !pinned) draw_wall(at + base_half_ * turned(away), at - base_half_ * turned(away), away);
    }
}

/// A pin of the body that a block slides on, not of the block itself: the block hides it.
bool Sketch::covered_by_block(const Joint& hinge) const {
    const auto holds = [&](BodyIndex body) {
        return std::find(hinge.bodies.begin(), hinge.bodies.end(), body) != hinge.bodies.end();
    };
    for (std::size_t j = 0; j < m_.joints.size(); ++j) {
        const Joint& joint = m_.joints[j];
        if (!joint.pair().is_sleeve() || joint.bodies.size() != 2 || joint.bodies[0] == 0 || cylinder_of(j)) continue;
        if (length(spot(joint.point) - spot(hinge.point)) < same_place && !holds(joint.bodies[0]) && holds(joint.bodies[1]))
            return true;
    }
    return false;
}

void Sketch::draw_body(BodyIndex body, const std::vector<BodyIndex>& below) {
    const Body& data = m_.bodies[at_index(body)];
    const Shape& shape = shapes_[at_index(body)];
    // Of two links in line (a dead point) the shorter one lies on top, narrower, so that both are seen.
    bool on_another = false;
    for (std::size_t other = 1; other < m_.bodies.size(); ++other)
        on_another = on_another || lies_on(body, static_cast<int>(other));
    const Pen stroke{on_another ? 0.5 * theme_.link : theme_.link, line_colour(body), {}, true};
    std::vector<Mark> marks;
    draw_profiles(body, marks);
    draw_crossings(body, below, marks);
    if (!shape.plate.empty() && !shape.solid) tints.emplace_back(tinted(filled(shape.plate, tint_colour(body))));
    draw_strokes(shape, stroke, marks);
    if (body != 0) draw_line_kind(marks, 0, 0.5 * theme_.link, theme_.body(body), theme_);
    for (const Cylinder& cylinder : cylinders_)
        if (m_.joints[cylinder.joint].bodies[1] == body) draw_barrel(cylinder, body, marks);
    // The block covers the end of its own rod: they are one piece.
    for (std::size_t j = 0; j < m_.joints.size(); ++j)
        if (m_.joints[j].pair().is_sleeve() && m_.joints[j].bodies.size() == 2 && m_.joints[j].bodies[0] == body)
            draw_block(m_.joints[j], j, marks);
    for (const Bar& slot : shape.slots) draw_slot(slot, body, marks);
    for (const Joint& joint : m_.joints)
        if (joint.pair().is_slot() && joint.arc >= 0 && joint.bodies.size() == 2 && joint.bodies[1] == body)
            draw_curved_slot(joint, marks);
    const std::string& words = in(data.label, context_.language);
    bodies.emplace_back(GroupBegin{"link", id("link", data.name), words.empty() ? data.name : data.name + ": " + words, {}});
    for (Mark& mark : marks) bodies.push_back(std::move(mark));
    bodies.emplace_back(GroupEnd{});
}

/// The body's number in a circle beside its longest stroke; names longer than two letters go without the circle.
void Sketch::balloon(BodyIndex body) {
    const Body& data = m_.bodies[at_index(body)];
    const Shape& shape = shapes_[at_index(body)];
    LabelRequest request;
    request.text = one_piece(data.name);
    request.size = data.name.size() > 1 ? theme_.small : theme_.derived;
    request.colour = letter_colour(body);
    request.dashes = theme_.body(body).dashes;
    if (context_.fonts.shape(request.text, request.size).width < 3.7)
        request.balloon = 2.3;
    else
        request.size = theme_.derived;
    std::vector<Bar> sides = shape.bars;
    for (std::size_t i = 0; i < shape.plate.size(); ++i)
        sides.push_back({shape.plate[i], shape.plate[(i + 1) % shape.plate.size()]});
    const auto longest = std::max_element(sides.begin(), sides.end(), [](const Bar& a, const Bar& b) {
        return length(a.to - a.from) < length(b.to - b.from) - 1e-9;
    });
    if (longest != sides.end() && length(longest->to - longest->from) > 6) {
        request.anchor = 0.5 * (longest->from + longest->to);
        request.toward = longest->to;
        request.clearance = 2.7;
    } else {
        // A block or a wheel: beside it.
        request.anchor = shape.middle;
        request.clearance = 6.4;
        for (std::size_t j = 0; j < m_.joints.size(); ++j)
            if (m_.joints[j].pair().is_sleeve() && m_.joints[j].bodies[0] == body) {
                request.anchor = spot(m_.joints[j].point);
                const double half = m_.joints[j].bodies[1] == 0 ? slider_half_ : sleeve_half_;
                const double side = m_.joints[j].bodies[1] == 0 ? slider_side_ : sleeve_side_;
                request.toward = request.anchor + (half + 2) * s_.guides[j];
                request.clearance = side + 2.2;
            }
        if (data.circle) {
            const double radius = data.circle->radius.to_double() / scale_;
            request.anchor = spot(data.circle->centre) + (radius * std::sqrt(0.5)) * Spot{1, -1};
            request.toward = request.anchor + 4.0 * Spot{1, 1};
            request.clearance = 1.8;
        }
    }
    labels.push_back(std::move(request));
}

void Sketch::draw_mass_centre(Spot centre) {
    constexpr double radius = 1.9;
    pins.emplace_back(ring(centre, radius, theme_.paper, {theme_.outline, theme_.text, {}, false}));
    for (const double from : {0.0, pi_number}) {
        Path quarter;
        quarter.segments = {MoveTo{centre}, LineTo{centre + radius * polar_spot(from)},
                            ArcTo{centre, radius, from, from + pi_number / 2}, Close{}};
        quarter.filled = true;
        quarter.fill = theme_.text;
        pins.emplace_back(std::move(quarter));
    }
}

/// A point, or a place of contact: black, on a stroke set off from it by the paper.
void Sketch::draw_dot(Spot at) {
    constexpr double radius = 0.65, halo = 0.35;
    const bool on_a_stroke = std::any_of(shapes_.begin(), shapes_.end(), [&](const Shape& shape) {
        const std::vector<Spot>& plate = shape.plate;
        const double near = theme_.link / 2;
        for (std::size_t i = 0; i < plate.size(); ++i)
            if (distance(at, {plate[i], plate[(i + 1) % plate.size()]}) < near) return true;
        return std::any_of(shape.bars.begin(), shape.bars.end(), [&](const Bar& bar) { return distance(at, bar) < near; });
    });
    if (on_a_stroke) pins.emplace_back(tinted(disc(at, radius + halo, theme_.paper)));
    pins.emplace_back(disc(at, radius, theme_.text));
}

/// Two bodies in one piece: a filled square across the joint; a clamp in the frame: a wall.
void Sketch::draw_clamp(const Joint& joint) {
    const Spot at = spot(joint.point);
    const std::vector<Spot> links = leaving(joint.point);
    const Spot along = links.empty() ? Spot{1, 0} : links.front();
    const bool fixed = std::find(joint.bodies.begin(), joint.bodies.end(), 0) != joint.bodies.end();
    if (fixed) draw_wall(at + base_half_ * turned(along), at - base_half_ * turned(along), -1.0 * along);
    if (fixed) return;
    // The corner between two links filled; in line, a patch over both.
    const BodyIndex body = joint.bodies[0];
    const auto other = std::find_if(links.begin(), links.end(), [&](Spot link) { return std::abs(cross(link, along)) > 0.2; });
    constexpr double leg = 5, half = 1.7;
    const Spot u = half * along, w = half * turned(along);
    if (other != links.end())
        pins.emplace_back(filled({at, at + leg * along, at + leg * *other}, line_colour(body)));
    else
        pins.emplace_back(filled({at + u + w, at + u - w, at - u - w, at - u + w}, line_colour(body)));
}

void Sketch::draw_in_colour() {
    for (const Joint& joint : m_.joints) {
        if (Subject::is_fixed_pin(joint)) draw_fixed_pin(joint.point);
        if (joint.pair().is_clamp()) draw_clamp(joint);
        if (joint.pair().is_slot() && joint.arc >= 0 && joint.bodies[1] == 0) draw_curved_slot(joint, ground);
    }
    draw_guides();
    std::vector<Mark> none;  // all that the frame has is ground
    draw_profiles(0, none);
    for (const Load& load : m_.loads)
        if (const auto* spring = std::get_if<SpringLoad>(&load)) draw_spring(*spring);
    std::vector<BodyIndex> below;
    for (const BodyIndex body : drawing_order()) {
        if (body == 0) continue;
        draw_body(body, below);
        below.push_back(body);
    }
    for (std::size_t b = 1; b < m_.bodies.size(); ++b) balloon(static_cast<int>(b));

    // Joints: one group each; a pin where bodies turn about each other, a dot where they touch.
    std::vector<Spot> pinned;
    for (const Joint& joint : m_.joints) {
        const Spot at = spot(joint.point);
        std::string title = joint.name + ":";
        for (const BodyIndex body : joint.bodies) title += " " + m_.bodies[at_index(body)].name;
        pins.emplace_back(GroupBegin{"joint", id("joint", joint.name), title, {}});
        const bool already = std::any_of(pinned.begin(), pinned.end(), [&](Spot p) { return length(p - at) < same_place; });
        const bool hinge = joint.pair().has_pin();
        if (hinge && !already && covered_by_block(joint)) {
            pins.emplace_back(circle(at, pin_radius_, {theme_.outline, theme_.text, {0.9, 0.5}, false}));
        } else if (hinge && !already) {
            pins.emplace_back(ring(at, pin_radius_, theme_.paper, {theme_.outline, theme_.text, {}, false}));
            pinned.push_back(at);
        } else if (joint.pair().touches()) {
            draw_dot(at);
        }
        pins.emplace_back(GroupEnd{});
    }
    for (std::size_t p = 0; p < spots_.size(); ++p) {
        if (!s_.shown[p]) continue;
        const bool taken = std::any_of(m_.joints.begin(), m_.joints.end(), [&](const Joint& joint) {
            return length(spot(joint.point) - spots_[p]) < same_place && !joint.pair().is_sleeve();
        });
        if (taken) continue;
        if (s_.mass_centre[p])
            draw_mass_centre(spots_[p]);
        else
            draw_dot(spots_[p]);
    }
}

/// The same mechanism as a thin grey skeleton, under vectors.
void Sketch::draw_in_grey() {
    const Pen thin{theme_.outline, theme_.skeleton, {}, true};
    std::vector<Mark> none;  // all that the frame has is ground
    draw_profiles(0, none);
    construction.clear();
    for (const BodyIndex body : drawing_order()) {
        if (body == 0) continue;
        const Shape& shape = shapes_[at_index(body)];
        bodies.emplace_back(GroupBegin{"link", id("link", m_.bodies[at_index(body)].name), m_.bodies[at_index(body)].name, {}});
        for (std::size_t j = 0; j < m_.joints.size(); ++j) {
            const Joint& joint = m_.joints[j];
            if (!joint.pair().is_sleeve() || joint.bodies[0] != body || cylinder_of(j)) continue;
            const bool on_frame = joint.bodies[1] == 0;
            const double half = on_frame ? slider_half_ : sleeve_half_, side = on_frame ? slider_side_ : sleeve_side_;
            const Spot at = spot(joint.point), u = half * s_.guides[j], w = side * turned(s_.guides[j]);
            Path block = polyline({at + u + w, at + u - w, at - u - w, at - u + w}, thin, true);
            block.filled = block.tinted = true;
            block.fill = theme_.paper;
            bodies.emplace_back(std::move(block));
        }
        for (const Rim& rim : shape.rims)
            if (rim.form != Rim::Form::arc) bodies.emplace_back(circle(rim.centre, rim.radius, thin));
        for (const Flat& flat : shape.flats) bodies.emplace_back(line(flat.bar.from, flat.bar.to, thin));
        for (const Bar& edge : shape.edges) bodies.emplace_back(line(edge.from, edge.to, thin));
        if (!shape.plate.empty()) bodies.emplace_back(polyline(shape.plate, thin, true));
        for (const Bar& bar : shape.bars)
            if (length(bar.to - bar.from) > 1e-6) bodies.emplace_back(line(bar.from, bar.to, thin));
        for (const Bar& slot : shape.slots) bodies.emplace_back(line(slot.from, slot.to, thin));
        bodies.emplace_back(GroupEnd{});
    }
    for (const Joint& joint : m_.joints) {
        if (joint.pair().is_sleeve()) continue;
        pins.emplace_back(ring(spot(joint.point), 0.9, theme_.paper, thin));
        if (joint.pair().is_hinge() && std::find(joint.bodies.begin(), joint.bodies.end(), 0) != joint.bodies.end())
            draw_fixed_pin(joint.point);
    }
}

/// Names of points; those at one place share a label.
void Sketch::draw_points(bool names) {
    if (!names) return;
    std::vector<bool> named(spots_.size(), false);
    for (std::size_t p = 0; p < spots_.size(); ++p) {
        if (!s_.shown[p] || named[p]) continue;
        const auto there = std::find_if(labels.begin(), labels.end(), [&](const LabelRequest& label) {
            return label.balloon == 0 && !label.toward && length(label.anchor - spots_[p]) < same_place;
        });
        LabelRequest request;
        request.size = theme_.label;
        request.colour = theme_.text;
        request.anchor = spots_[p];
        request.clearance = pin_radius_ + 0.8;
        for (std::size_t q = p; q < spots_.size(); ++q) {
            if (!s_.shown[q] || named[q] || length(spots_[q] - spots_[p]) > same_place) continue;
            named[q] = true;
            if (!request.text.empty()) append(request.text, one_piece(" ≡ "));
            append(request.text, typeset(Symbol{Symbol::Letter::point, m_.points[q].name, ""}, context_.language));
        }
        if (there != labels.end()) {
            // An instant centre falls on the point: "B ≡ P_13".
            append(request.text, one_piece(" ≡ "));
            append(request.text, there->text);
            there->text = std::move(request.text);
            there->clearance = std::max(there->clearance, request.clearance);
        } else {
            labels.push_back(std::move(request));
        }
    }
}

/// The compass strokes that found the points.
void Sketch::draw_compass() {
    for (const PositionStep& step : s_.solution.pose.steps) {
        if (step.point < 0 || !s_.shown[at_index(step.point)]) continue;
        const Spot at = spot(step.point);
        for (const PositionStep::Arc& arc : step.arcs) {
            const Spot centre = spot(arc.centre);
            const double radius = arc.radius.to_double() / scale_;
            if (radius < 2 || std::abs(length(at - centre) - radius) > 0.1) continue;
            const double middle = std::atan2(at.y - centre.y, at.x - centre.x);
            const double half = std::clamp(6 * pi_number / 180, 4.0 / radius, 9.0 / radius);
            Path stroke;
            stroke.segments = {MoveTo{centre + radius * polar_spot(middle - half)},
                               ArcTo{centre, radius, middle - half, middle + half}};
            stroke.stroked = true;
            stroke.pen = {theme_.thin, theme_.secondary, {}, false};
            construction.emplace_back(std::move(stroke));
        }
    }
}

}  // namespace kinegraph::render::drawing
