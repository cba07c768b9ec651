// Gears and racks after ISO 2203: pitch curves dash-dot, teeth where wheels mesh.
#include <algorithm>
#include <cmath>

#include "render/mechanism/symbols.hpp"

namespace kinegraph::render::drawing {

namespace {

// A tooth of the basic rack (ISO 53: 20°, addendum 1 module, dedendum 1.25 modules), in modules.
constexpr double dedendum = 1.25;
constexpr double half_space_at_tip = 0.25 * pi_number + 0.36397;              // tan 20°
constexpr double half_space_at_root = 0.25 * pi_number - dedendum * 0.36397;  //

/// A pitch curve: a circle, or a straight line from `origin` (radius 0). Positions on it are angles or lengths,
/// respectively.
struct PitchCurve {
    Spot origin;
    double radius = 0;
    bool hollow = false;
    bool round() const { return radius > 0; }
};
/// Where teeth are drawn: position on the pitch curve, extent, and whether a tooth or a space is centred there.
struct Mesh {
    double at, reach;
    bool tooth;
};

/// Extends over the teeth of both that could touch, plus one.
Mesh mesh_of(const Layout& layout, const PitchCurve& curve, const Touch& touch, BodyIndex body) {
    const Joint& joint = layout.mechanism.joint(touch.joint);
    const Spot at = layout.spot(joint), off = at - curve.origin;
    double curvature = curve.round() ? (curve.hollow ? -1 : 1) / curve.radius : 0;
    if (const auto* wheel = profile_of<CircleProfile>(joint, touch.other)) {
        const Spot centre = layout.spot(wheel->centre);
        const bool about = curve.hollow || !(curve.round() && dot(centre - at, curve.origin - at) > 0);
        curvature += (about ? 1 : -1) / length(at - centre);
    }
    const double half =
        std::sqrt(4 * layout.module() / std::max(std::abs(curvature), 1e-3)) + pi_number * layout.module();
    return {curve.round() ? angle_of(off) : dot(off, layout.subject.tangent(joint)),
            curve.round() ? half / curve.radius : half, joint.bodies[0] == body};
}

/// Positions of the tooth spaces near each mesh. The joint's first body has a tooth at the pitch point, its second a
/// space.
std::vector<double> tooth_spaces(const Layout& layout, const PitchCurve& curve, const std::vector<Touch>& touches,
                                 BodyIndex body) {
    std::vector<Mesh> meshes;
    for (const Touch& touch : touches) meshes.push_back(mesh_of(layout, curve, touch, body));
    const double pitch = curve.round() ? pi_number * layout.module() / curve.radius : pi_number * layout.module();
    std::vector<double> spaces;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const Mesh& mesh = meshes[i];
        // The next mesh has its own teeth; they need not be in phase.
        double reach = curve.round() ? std::min(mesh.reach, pi_number - pitch) : mesh.reach;
        for (std::size_t k = 0; k < meshes.size(); ++k) {
            double apart = std::abs(meshes[k].at - mesh.at);
            if (curve.round()) apart = std::min(apart, 2 * pi_number - apart);
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

/// The tip circle, interrupted by the tooth spaces.
Path contour_of(const Layout& layout, const Rim& rim, BodyIndex body, double tip, double root) {
    const double module = layout.module();
    const std::vector<double> spaces = tooth_spaces(layout, {rim.centre, rim.radius, rim.hollow}, rim.touches, body);
    const double start = spaces.empty() ? 0 : spaces.front() - half_space_at_tip * module / tip;
    const auto at = [&](double radius, double angle) { return rim.centre + radius * polar_spot(angle); };
    Path contour;
    contour.segments.emplace_back(MoveTo{at(tip, start)});
    double on_tip = start;
    for (const double space : spaces) {
        const double a = half_space_at_tip * module / rim.radius, b = half_space_at_root * module / rim.radius;
        if (space - a > on_tip) contour.segments.emplace_back(ArcTo{rim.centre, tip, on_tip, space - a});
        contour.segments.emplace_back(LineTo{at(root, space - b)});
        contour.segments.emplace_back(ArcTo{rim.centre, root, space - b, space + b});
        contour.segments.emplace_back(LineTo{at(tip, space + a)});
        on_tip = space + a;
    }
    if (start + 2 * pi_number > on_tip)
        contour.segments.emplace_back(ArcTo{rim.centre, tip, on_tip, start + 2 * pi_number});
    contour.segments.emplace_back(Close{});
    return contour;
}

/// The pitch line and the teeth above it, from end to end.
std::vector<Spot> teeth_of_rack(const Layout& layout, const Flat& flat, BodyIndex body) {
    const double module = layout.module(), whole = length(flat.bar);
    const Spot along = direction(flat.bar);
    const auto at = [&](double t, double height) { return flat.bar.from + t * along - height * module * flat.inward; };
    std::vector<Spot> contour{at(0, 1)};
    for (const double space : tooth_spaces(layout, {flat.bar.from}, flat.touches, body)) {
        // Lengths run along the joint's tangent, which may have either sense.
        const Spot tangent = layout.subject.tangent(layout.mechanism.joint(flat.touches.front().joint));
        const double middle = space * (dot(tangent, along) < 0 ? -1 : 1);
        const double a = half_space_at_tip * module, b = half_space_at_root * module;
        if (middle - a < 0 || middle + a > whole) continue;
        for (const Spot corner :
             {at(middle - a, 1), at(middle - b, -dedendum), at(middle + b, -dedendum), at(middle + a, 1)})
            contour.push_back(corner);
    }
    contour.push_back(at(whole, 1));
    return contour;
}

}  // namespace

void draw_gear(Sketch& sketch, const Rim& rim, BodyIndex body, std::vector<Mark>& marks) {
    const Theme& theme = sketch.theme;
    const BodyColour colour = theme.colour_of(body);
    const double module = sketch.module(), outwards = rim.hollow ? -1 : 1;
    const double tip = rim.radius + outwards * module, root = rim.radius - outwards * dedendum * module;
    const double back = rim.radius + dedendum * module + 2.2;  // outer edge of an internal gear
    const bool fixed = body == frame;
    Path contour = contour_of(sketch, rim, body, tip, root);
    if (!fixed && !rim.hollow) {
        Path tint = tinted(contour);
        tint.filled = true;
        tint.fill = colour.tint;
        sketch.tints.emplace_back(std::move(tint));
    } else if (!fixed) {
        sketch.tints.emplace_back(annulus(rim.centre, rim.radius, back, colour.tint));
        marks.emplace_back(circle(rim.centre, back, {theme.vector, colour.line, {}, false}));
    }
    contour.stroked = true;
    contour.pen = {fixed ? theme.outline : 0.5 * (theme.outline + theme.vector), colour.line, {}, false};
    (fixed ? sketch.ground : marks).emplace_back(std::move(contour));
    sketch.construction.emplace_back(circle(rim.centre, rim.radius, sketch.axis()));
    hang(sketch.construction, sketch.construction.size() - 1, on_body(body));
    if (fixed)
        draw_fixed_rim(sketch, rim, rim.hollow ? back : root - 1.2, rim.hollow);
    else if (!rim.hollow)
        draw_hub(sketch, rim, rim.radius - dedendum * module, body, marks);
}

void draw_rack(Sketch& sketch, const Flat& flat, BodyIndex body, std::vector<Mark>& marks) {
    const Theme& theme = sketch.theme;
    const Spot along = direction(flat.bar), start = flat.bar.from, end = flat.bar.to;
    const double module = sketch.module(), depth = (dedendum + 2.4 / module) * module;
    sketch.construction.emplace_back(line(start - 3.0 * along, end + 3.0 * along, sketch.axis()));
    hang(sketch.construction, sketch.construction.size() - 1, on_body(body));
    std::vector<Spot> contour = teeth_of_rack(sketch, flat, body);
    const Bar behind{start + depth * flat.inward, end + depth * flat.inward};
    if (body == frame) {
        sketch.ground.emplace_back(polyline(contour, sketch.outline()));
        draw_wall(sketch, behind, flat.inward);
        sketch.ground.emplace_back(line(contour.front(), behind.from, sketch.outline()));
        sketch.ground.emplace_back(line(contour.back(), behind.to, sketch.outline()));
        return;
    }
    contour.push_back(behind.to);
    contour.push_back(behind.from);
    const BodyColour colour = theme.colour_of(body);
    sketch.tints.emplace_back(tinted(filled(contour, colour.tint)));
    marks.emplace_back(polyline(contour, {0.5 * (theme.outline + theme.vector), colour.line, {}, false}, true));
}

}  // namespace kinegraph::render::drawing
