// Profiles: wheels, gears, racks, cams and their followers, flat faces. Owns which form a profile has on paper and how it is
// drawn; that bodies touch there, and how they move, it takes from the mechanism.
#include <algorithm>
#include <cmath>

#include "render/mechanism/sketch.hpp"

namespace kinegraph::render::drawing {

namespace {

const CircleProfile* circle_profile(const Joint& joint, BodyIndex body) {
    const auto profile = joint.profiles.find(body);
    return profile == joint.profiles.end() ? nullptr : std::get_if<CircleProfile>(&profile->second);
}

// A tooth of the basic rack (ISO 53: 20°, addendum 1 module, dedendum 1.25 modules), in modules.
constexpr double dedendum = 1.25;
constexpr double half_space_at_tip = 0.25 * pi_number + 0.36397;              // tan 20°
constexpr double half_space_at_root = 0.25 * pi_number - dedendum * 0.36397;  //

constexpr double least_with_hub = 6;  // radius of a wheel with room for one, mm

/// A ring-shaped area between two circles.
Path annulus(Spot centre, double inner, double outer, Colour tint) {
    Path path = tinted(disc(centre, outer, tint));
    path.segments.emplace_back(MoveTo{centre + Spot{inner, 0}});
    path.segments.emplace_back(ArcTo{centre, inner, 2 * pi_number, 0});
    path.segments.emplace_back(Close{});
    return path;
}

}  // namespace

/// Somewhere within a body, to tell on which side of a contact it lies.
Spot Sketch::bulk_of(BodyIndex body, const Joint& joint) const {
    const Spot at = spot(joint.point);
    if (const CircleProfile* round = circle_profile(joint, body)) return spot(round->centre);
    if (const auto& wheel = m_.bodies[at_index(body)].circle) return spot(wheel->centre);
    Spot sum;
    int count = 0;
    for (const int corner : s_.corners[at_index(body)])
        if (length(spot(corner) - at) > same_place) {
            sum = sum + spot(corner);
            ++count;
        }
    return count > 0 ? (1.0 / count) * sum : at;
}

std::vector<Rim> Sketch::rims_of(BodyIndex body) const {
    std::vector<Rim> rims;
    const Body& data = m_.bodies[at_index(body)];
    const auto rim_of = [&](Spot centre, double radius) -> Rim& {
        for (Rim& rim : rims)
            if (length(rim.centre - centre) < same_place && std::abs(rim.radius - radius) < same_place) return rim;
        rims.push_back({Rim::Form::arc, centre, radius, false, {}});
        return rims.back();
    };
    if (data.circle) rim_of(spot(data.circle->centre), data.circle->radius.to_double() / scale_).form = Rim::Form::wheel;
    for (std::size_t j = 0; j < m_.joints.size(); ++j) {
        const Joint& joint = m_.joints[j];
        const CircleProfile* round = joint.pair().touches() && joint.bodies.size() == 2 ? circle_profile(joint, body) : nullptr;
        if (!round) continue;
        const Spot at = spot(joint.point), centre = spot(round->centre);
        const double radius = length(at - centre);
        if (radius < same_place) continue;
        Rim& rim = rim_of(centre, radius);
        const BodyIndex other = joint.bodies[joint.bodies[0] == body ? 1 : 0];
        rim.touches.push_back({j, other});
        const std::vector<int>& corners = s_.corners[at_index(body)];
        const bool about_own_point = std::find(corners.begin(), corners.end(), round->centre) != corners.end();
        if (joint.pair().meshes())
            rim.form = Rim::Form::gear;
        else if (joint.pair().slides() && rim.form == Rim::Form::wheel)
            rim.form = Rim::Form::cam;
        else if (rim.form == Rim::Form::arc && (about_own_point || joint.pair().rolls()))
            rim.form = joint.pair().rolls() ? Rim::Form::wheel : Rim::Form::roller;
        // The larger of two circles on one side of the contact lies about the smaller.
        if (const CircleProfile* within = circle_profile(joint, other))
            if (const Spot inner = spot(within->centre) - at; dot(inner, centre - at) > 0 && length(inner) < radius)
                rim.hollow = true;
    }
    return rims;
}

/// The straight profiles of a body; those on one line are one.
std::vector<Flat> Sketch::flats_of(BodyIndex body) const {
    std::vector<Flat> flats;
    for (std::size_t j = 0; j < m_.joints.size(); ++j) {
        const Joint& joint = m_.joints[j];
        if (!joint.pair().touches() || joint.bodies.size() != 2) continue;
        const auto profile = joint.profiles.find(body);
        if (profile == joint.profiles.end() || !std::holds_alternative<LineProfile>(profile->second)) continue;
        const Spot at = spot(joint.point);
        const Spot along = paper_direction(s_.solution.pose.tangents[j]);
        const BodyIndex other = joint.bodies[joint.bodies[0] == body ? 1 : 0];
        Spot inward = turned(along);
        double side = dot(bulk_of(other, joint) - at, inward);
        if (std::abs(side) < same_place && joint.pushes)
            side = (joint.bodies[0] == body ? -1.0 : 1.0) * dot(paper_direction(*joint.pushes), inward);
        if (std::abs(side) < same_place) side = -dot(bulk_of(body, joint) - at, inward);
        if (side > 0) inward = -1.0 * inward;
        const bool rack = joint.pair().meshes();
        double half = 16;
        if (const CircleProfile* round = circle_profile(joint, other); round && rack)
            half = std::max(16.0, 1.1 * std::sqrt(4 * module_ * length(at - spot(round->centre))) + 2 * pi_number * module_);
        Flat flat{{at - half * along, at + half * along}, inward, 0.5 * theme_.link, rack, {{j, other}}};
        const auto same = std::find_if(flats.begin(), flats.end(), [&](const Flat& known) {
            const Spot direction = unit(known.bar.to - known.bar.from);
            return known.rack == rack && std::abs(cross(direction, along)) < 1e-6 &&
                   std::abs(cross(direction, at - known.bar.from)) < same_place && dot(known.inward, inward) > 0;
        });
        if (same == flats.end()) {
            flats.push_back(std::move(flat));
            continue;
        }
        const Spot direction = unit(same->bar.to - same->bar.from);
        double from = 0, to = length(same->bar.to - same->bar.from);
        for (const Spot end : {flat.bar.from, flat.bar.to}) {
            from = std::min(from, dot(end - same->bar.from, direction));
            to = std::max(to, dot(end - same->bar.from, direction));
        }
        same->bar = {same->bar.from + from * direction, same->bar.from + to * direction};
        same->touches.push_back({j, other});
    }
    return flats;
}

/// Where the spaces between teeth are, near each mesh: lengths along the pitch curve from `origin` (radius 0: a straight rack),
/// or angles on it. A tooth of the joint's first body stands at the pitch point, a space of its second.
std::vector<double> Sketch::tooth_spaces(const std::vector<Touch>& all, Spot origin, double radius, bool hollow,
                                         BodyIndex body) const {
    struct Mesh {
        double at, reach;
        bool tooth;
    };
    std::vector<Mesh> meshes;
    const double pitch = radius > 0 ? pi_number * module_ / radius : pi_number * module_;
    for (const Touch& touch : all) {
        const Joint& joint = m_.joints[touch.joint];
        const Spot at = spot(joint.point);
        const Spot along = paper_direction(s_.solution.pose.tangents[touch.joint]);
        // As far as the teeth of both would meet, and one more.
        double curvature = radius > 0 ? (hollow ? -1 : 1) / radius : 0;
        if (const CircleProfile* round = circle_profile(joint, touch.other)) {
            const double r = length(at - spot(round->centre));
            const bool about = hollow || !(radius > 0 && dot(spot(round->centre) - at, origin - at) > 0);
            curvature += (about ? 1 : -1) / r;
        }
        const double half = std::sqrt(4 * module_ / std::max(std::abs(curvature), 1e-3)) + pi_number * module_;
        const double place = radius > 0 ? std::atan2(at.y - origin.y, at.x - origin.x) : dot(at - origin, along);
        meshes.push_back({place, radius > 0 ? half / radius : half, joint.bodies[0] == body});
    }
    std::vector<double> spaces;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const Mesh& mesh = meshes[i];
        // The next mesh has teeth of its own; they need not be in step.
        double reach = radius > 0 ? std::min(mesh.reach, pi_number - pitch) : mesh.reach;
        for (std::size_t k = 0; k < meshes.size(); ++k) {
            double apart = std::abs(meshes[k].at - mesh.at);
            if (radius > 0) apart = std::min(apart, 2 * pi_number - apart);
            if (k != i && apart > 1e-6) reach = std::min(reach, apart / 2 - 0.6 * pitch);
            if (k < i && apart <= 1e-6) reach = -1;
        }
        const double first = mesh.tooth ? 0.5 : 0.0;
        for (int k = static_cast<int>(-reach / pitch) - 1; k <= static_cast<int>(reach / pitch) + 1; ++k)
            if (const double place = (k + first) * pitch; std::abs(place) <= reach) spaces.push_back(mesh.at + place);
    }
    std::sort(spaces.begin(), spaces.end());
    return spaces;
}

/// After ISO 2203: pitch circle dash-dot, tip circle in full; teeth where wheels mesh.
void Sketch::draw_gear(const Rim& rim, BodyIndex body, std::vector<Mark>& marks) {
    const bool fixed = body == 0;
    const double outwards = rim.hollow ? -1 : 1;
    const double tip = rim.radius + outwards * module_, root = rim.radius - outwards * dedendum * module_;
    Path contour;
    const std::vector<double> spaces = tooth_spaces(rim.touches, rim.centre, rim.radius, rim.hollow, body);
    const double start = spaces.empty() ? 0 : spaces.front() - half_space_at_tip * module_ / tip;
    contour.segments.emplace_back(MoveTo{rim.centre + tip * polar_spot(start)});
    double on_tip = start;
    for (const double space : spaces) {
        const double a = half_space_at_tip * module_ / rim.radius, b = half_space_at_root * module_ / rim.radius;
        if (space - a > on_tip) contour.segments.emplace_back(ArcTo{rim.centre, tip, on_tip, space - a});
        contour.segments.emplace_back(LineTo{rim.centre + root * polar_spot(space - b)});
        contour.segments.emplace_back(ArcTo{rim.centre, root, space - b, space + b});
        contour.segments.emplace_back(LineTo{rim.centre + tip * polar_spot(space + a)});
        on_tip = space + a;
    }
    if (start + 2 * pi_number > on_tip) contour.segments.emplace_back(ArcTo{rim.centre, tip, on_tip, start + 2 * pi_number});
    contour.segments.emplace_back(Close{});
    contour.stroked = true;
    contour.pen = {fixed ? theme_.outline : 0.5 * (theme_.outline + theme_.vector), line_colour(body), {}, false};
    const double back = rim.radius + dedendum * module_ + 2.2;  // outer edge of an internal gear
    if (!fixed && !rim.hollow) {
        Path tint = contour;
        tint.stroked = false;
        tint.filled = tint.tinted = true;
        tint.fill = tint_colour(body);
        tints.emplace_back(std::move(tint));
    } else if (!fixed) {
        tints.emplace_back(annulus(rim.centre, rim.radius, back, tint_colour(body)));
        marks.emplace_back(circle(rim.centre, back, {theme_.vector, line_colour(body), {}, false}));
    }
    (fixed ? ground : marks).emplace_back(std::move(contour));
    construction.emplace_back(circle(rim.centre, rim.radius, {theme_.thin, theme_.secondary, dash_dot(), false}));
    if (fixed)
        draw_fixed_rim(rim, rim.hollow ? back : root - 1.2, rim.hollow);
    else if (!rim.hollow && turns_about(rim.centre, body))
        draw_hub(rim, body, marks);
}

/// The ground behind a fixed rim: hatched on the side where nothing rolls.
void Sketch::draw_fixed_rim(const Rim& rim, double radius, bool outside) {
    if (radius < 2) return;
    ground.emplace_back(circle(rim.centre, radius, {theme_.outline, theme_.text, {}, false}));
    hatch_arc(rim.centre, radius, 0, 2 * pi_number, outside);
}

/// Whether a wheel may have its hub there: no, where its body is hinged elsewhere only (an eccentric).
bool Sketch::turns_about(Spot centre, BodyIndex body) const {
    bool elsewhere = false;
    for (const Joint& joint : m_.joints) {
        if (!joint.pair().is_hinge()) continue;
        if (std::find(joint.bodies.begin(), joint.bodies.end(), body) == joint.bodies.end()) continue;
        if (length(spot(joint.point) - centre) < same_place) return true;
        elsewhere = elsewhere || (std::find(joint.bodies.begin(), joint.bodies.end(), 0) != joint.bodies.end());
    }
    return !elsewhere;
}

/// Hub and one spoke, so that a turn is seen; the spoke stands where nothing else does. A body with points of its own shows it by
/// them, and a small roller has no room.
void Sketch::draw_hub(const Rim& rim, BodyIndex body, std::vector<Mark>& marks) {
    if (rim.radius < least_with_hub) return;
    const double hub = pin_radius_ + 1.1;
    marks.emplace_back(ring(rim.centre, hub, tint_colour(body), {theme_.outline, line_colour(body), {}, false}));
    const Shape& own = shapes_[at_index(body)];
    const bool marked =
        std::any_of(own.bars.begin(), own.bars.end(), [](const Bar& bar) { return length(bar.to - bar.from) > 1; });
    if (marked) return;
    std::vector<Spot> taken;
    for (const Touch& touch : rim.touches) taken.push_back(unit(spot(m_.joints[touch.joint].point) - rim.centre));
    for (const Joint& joint : m_.joints)
        if (length(spot(joint.point) - rim.centre) < same_place) {
            for (const Spot link : leaving(joint.point)) taken.push_back(link);
            if (Subject::is_fixed_pin(joint)) taken.push_back({0, 1});
        }
    Spot spoke{1, 0};
    double least = 1e300;
    for (int i = 0; i < 8; ++i) {
        const Spot direction = polar_spot(pi_number * (0.75 + 0.25 * i));
        double price = 0;
        for (const Spot other : taken) price = std::max(price, dot(direction, other));
        if (price < least - 1e-9) {
            least = price;
            spoke = direction;
        }
    }
    const double end = rim.radius - (rim.form == Rim::Form::gear ? dedendum * module_ : theme_.vector / 2);
    marks.emplace_back(line(rim.centre + hub * spoke, rim.centre + end * spoke, {theme_.vector, line_colour(body), {}, false}));
}

/// The arc on which another body slides, held by the body's nearest point: a sector, or a bow where the material lies outside.
void Sketch::draw_arc_profile(const Rim& rim, BodyIndex body, std::vector<Mark>& marks) {
    double middle = 0, half = 0;
    for (std::size_t t = 0; t < rim.touches.size(); ++t) {
        const Spot at = spot(m_.joints[rim.touches[t].joint].point) - rim.centre;
        const double angle = std::atan2(at.y, at.x);
        if (t == 0) middle = angle;
        half = std::max(half, std::abs(std::remainder(angle - middle, 2 * pi_number)));
    }
    half = std::min(half + std::min(14.0 / rim.radius, 1.0), 2.8);
    const Pen heavy{theme_.link, line_colour(body), {}, true};
    // The edge of the stroke, not its middle, is the profile.
    const double along = rim.radius + (rim.hollow ? 0.5 : -0.5) * theme_.link;
    Path arc;
    arc.segments = {MoveTo{rim.centre + along * polar_spot(middle - half)},
                    ArcTo{rim.centre, along, middle - half, middle + half}};
    arc.stroked = true;
    arc.pen = heavy;
    if (body == 0) {
        arc.segments = {MoveTo{rim.centre + rim.radius * polar_spot(middle - half)},
                        ArcTo{rim.centre, rim.radius, middle - half, middle + half}};
        arc.pen = {theme_.outline, theme_.text, {}, false};
        ground.emplace_back(std::move(arc));
        hatch_arc(rim.centre, rim.radius, middle - half, middle + half, rim.hollow);
        return;
    }
    const Spot crown = rim.centre + along * polar_spot(middle);
    std::optional<Spot> hold;
    for (const int corner : s_.corners[at_index(body)])
        if (const Spot at = spot(corner); length(at - crown) > 3 && (!hold || length(at - crown) < length(*hold - crown) - 1e-9))
            hold = at;
    // Within the sector it holds the whole arc, else one end.
    const Spot ends[] = {rim.centre + along * polar_spot(middle - half), rim.centre + along * polar_spot(middle + half)};
    if (hold && !rim.hollow && length(*hold - rim.centre) < along - 2) {
        Path sector = arc;
        sector.segments.emplace_back(LineTo{*hold});
        sector.segments.emplace_back(Close{});
        Path tint = sector;
        tint.stroked = false;
        tint.filled = tint.tinted = true;
        tint.fill = tint_colour(body);
        tints.emplace_back(std::move(tint));
        marks.emplace_back(std::move(sector));
        return;
    }
    if (hold) {
        const Spot end = length(ends[0] - *hold) < length(ends[1] - *hold) ? ends[0] : ends[1];
        marks.emplace_back(line(*hold, end, heavy));
    }
    marks.emplace_back(std::move(arc));
}

void Sketch::draw_rim(const Rim& rim, BodyIndex body, std::vector<Mark>& marks) {
    if (rim.form == Rim::Form::gear) return draw_gear(rim, body, marks);
    if (rim.form == Rim::Form::arc) return draw_arc_profile(rim, body, marks);
    if (body == 0) return draw_fixed_rim(rim, rim.radius, rim.hollow);
    const Pen edge = pen_of(body, theme_.vector);
    if (rim.hollow) {
        const double outer = rim.radius + 3.2;
        tints.emplace_back(annulus(rim.centre, rim.radius, outer, tint_colour(body)));
        marks.emplace_back(circle(rim.centre, rim.radius, edge));
        marks.emplace_back(circle(rim.centre, outer, edge));
        return;
    }
    tints.emplace_back(tinted(disc(rim.centre, rim.radius, tint_colour(body))));
    marks.emplace_back(circle(rim.centre, rim.radius, edge));
    const bool hubbed = rim.form == Rim::Form::wheel && turns_about(rim.centre, body);
    if (hubbed) draw_hub(rim, body, marks);
    bool shown_there = false;
    for (std::size_t p = 0; p < spots_.size(); ++p)
        shown_there = shown_there || (s_.shown[p] && length(spots_[p] - rim.centre) < same_place);
    if (!shown_there && !(hubbed && rim.radius >= least_with_hub)) {
        // The centre of curvature, which the file names and nothing marks.
        const double arm = std::min(2.2, 0.5 * rim.radius);
        for (const Spot along : {Spot{arm, 0}, Spot{0, arm}})
            construction.emplace_back(line(rim.centre - along, rim.centre + along, {theme_.thin, theme_.secondary, {}, false}));
    }
}

/// Teeth along the pitch line (dash-dot), the bar behind them.
void Sketch::draw_rack(const Flat& flat, BodyIndex body, std::vector<Mark>& marks) {
    const Spot along = unit(flat.bar.to - flat.bar.from), out = -1.0 * flat.inward;
    const double whole = length(flat.bar.to - flat.bar.from);
    const auto at = [&](double t, double height) { return flat.bar.from + t * along + height * module_ * out; };
    std::vector<Spot> contour{at(0, 1)};
    for (const double space : tooth_spaces(flat.touches, flat.bar.from, 0, false, body)) {
        // Lengths are counted along the joint's tangent, which may run either way.
        const Spot tangent = paper_direction(s_.solution.pose.tangents[flat.touches.front().joint]);
        const double middle = space * (dot(tangent, along) < 0 ? -1 : 1);
        const double a = half_space_at_tip * module_, b = half_space_at_root * module_;
        if (middle - a < 0 || middle + a > whole) continue;
        contour.push_back(at(middle - a, 1));
        contour.push_back(at(middle - b, -dedendum));
        contour.push_back(at(middle + b, -dedendum));
        contour.push_back(at(middle + a, 1));
    }
    contour.push_back(at(whole, 1));
    construction.emplace_back(
        line(at(0, 0) - 3.0 * along, at(whole, 0) + 3.0 * along, {theme_.thin, theme_.secondary, dash_dot(), false}));
    const double behind = -dedendum - 2.4 / module_;
    if (body == 0) {
        ground.emplace_back(polyline(contour, {theme_.outline, theme_.text, {}, false}));
        draw_wall(at(0, behind), at(whole, behind), flat.inward);
        ground.emplace_back(line(at(0, 1), at(0, behind), {theme_.outline, theme_.text, {}, false}));
        ground.emplace_back(line(at(whole, 1), at(whole, behind), {theme_.outline, theme_.text, {}, false}));
        return;
    }
    contour.push_back(at(whole, behind));
    contour.push_back(at(0, behind));
    tints.emplace_back(tinted(filled(contour, tint_colour(body))));
    marks.emplace_back(polyline(contour, {0.5 * (theme_.outline + theme_.vector), line_colour(body), {}, false}, true));
}

/// Wheels, gears, cams and flat faces of one body; those of the frame go to the ground.
void Sketch::draw_profiles(BodyIndex body, std::vector<Mark>& marks) {
    const Shape& shape = shapes_[at_index(body)];
    for (const Rim& rim : shape.rims) draw_rim(rim, body, marks);
    for (const Flat& flat : shape.flats) {
        if (flat.rack)
            draw_rack(flat, body, marks);
        else if (body == 0)
            draw_wall(flat.bar.from, flat.bar.to, flat.inward);
        else
            // The edge of the stroke, not its middle, is the profile.
            marks.emplace_back(line(flat.bar.from + flat.depth * flat.inward, flat.bar.to + flat.depth * flat.inward,
                                    {theme_.link, line_colour(body), {}, true}));
    }
    draw_bare_contacts(body);
}

/// Contacts of which the file tells no profile: a support on rollers where the frame bears, else the common tangent.
void Sketch::draw_bare_contacts(BodyIndex body) {
    for (std::size_t j = 0; j < m_.joints.size(); ++j) {
        const Joint& joint = m_.joints[j];
        const Spot tangent = paper_direction(s_.solution.pose.tangents[j]);
        if (!joint.pair().touches() || joint.bodies.size() != 2 || s_.solution.pose.tangents[j].is_zero()) continue;
        const auto in = std::find(joint.bodies.begin(), joint.bodies.end(), body);
        if (in == joint.bodies.end() || joint.profiles.count(body) != 0 || m_.bodies[at_index(body)].circle) continue;
        const Spot at = spot(joint.point);
        if (joint.pair().meshes()) {
            if (in == joint.bodies.begin())
                construction.emplace_back(
                    line(at - 10.0 * tangent, at + 10.0 * tangent, {theme_.thin, theme_.secondary, dash_dot(), false}));
        } else if (body == 0) {
            const BodyIndex other = joint.bodies[joint.bodies[0] == 0 ? 1 : 0];
            Spot away = turned(tangent);
            if (joint.pushes)
                away = (joint.bodies[0] == 0 ? 1.0 : -1.0) * paper_direction(*joint.pushes);
            else if (dot(bulk_of(other, joint) - at, away) > 0)
                away = -1.0 * away;
            const bool rounded = joint.profiles.count(other) != 0 && !Subject::is_tip(joint, other);
            if (rounded || joint.pair().rolls()) {
                draw_wall(at - 16.0 * tangent, at + 16.0 * tangent, away);
                continue;
            }
            const double radius = 1.6 * shrink_;
            ground.emplace_back(
                ring(at + (radius + theme_.link / 2) * away, radius, theme_.paper, {theme_.outline, theme_.text, {}, false}));
            const Spot foot = at + (2 * radius + theme_.link / 2) * away;
            draw_wall(foot + base_half_ * tangent, foot - base_half_ * tangent, away);
        } else if (in == joint.bodies.begin() && joint.bodies[1] != 0) {
            construction.emplace_back(
                line(at - 10.0 * tangent, at + 10.0 * tangent, {theme_.thin, theme_.secondary, dash_dot(), false}));
        }
    }
}

}  // namespace kinegraph::render::drawing
