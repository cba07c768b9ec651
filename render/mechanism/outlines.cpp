// Outlines of bodies in thin lines: their strokes, and the same bodies in another position of the mechanism.
#include "render/mechanism/symbols.hpp"

namespace kinegraph::render::drawing {

namespace {

/// A rigid motion on paper, mm, y downwards.
class PaperMotion {
public:
    PaperMotion(const RigidMotion& motion, double scale)
        : x_{motion.facing.x, -motion.facing.y},
          shift_{motion.shift.x / scale, -motion.shift.y / scale},
          turn_(angle_of(x_)) {}

    Spot operator()(Spot spot) const { return spot.x * x_ + spot.y * turned(x_) + shift_; }
    void move(Path& path) const {
        for (Segment& segment : path.segments) std::visit([this](auto& each) { move(each); }, segment);
    }

private:
    void move(MoveTo& segment) const { segment.to = (*this)(segment.to); }
    void move(LineTo& segment) const { segment.to = (*this)(segment.to); }
    void move(CurveTo& segment) const {
        for (Spot* spot : {&segment.control_1, &segment.control_2, &segment.to}) *spot = (*this)(*spot);
    }
    void move(ArcTo& segment) const {
        segment.centre = (*this)(segment.centre);
        segment.from += turn_;
        segment.to += turn_;
    }
    void move(Close& /*segment*/) const {}

    Spot x_, shift_;
    double turn_;
};

/// Blocks, pistons, barrels and slots, as the body has them in the figure.
std::vector<Path> outlines_of_slides(Sketch& sketch, BodyIndex body, const Pen& pen) {
    std::vector<Mark> marks;
    for (const Cylinder& cylinder : sketch.cylinders())
        if (sketch.mechanism.joint(cylinder.joint).bodies[1] == body) draw_barrel(sketch, cylinder, marks);
    draw_sliding_parts(sketch, body, marks);
    std::vector<Path> outlines;
    for (const Mark& mark : marks)
        if (const auto* path = std::get_if<Path>(&mark)) {
            Path& outline = outlines.emplace_back(*path);
            outline.filled = outline.tinted = false;
            outline.stroked = true;
            outline.pen = pen;
        }
    return outlines;
}

}  // namespace

std::vector<Path> rims_in(const Shape& shape, const Pen& pen) {
    std::vector<Path> rims;
    for (const Rim& rim : shape.rims)
        if (rim.form != Rim::Form::arc) rims.push_back(circle(rim.centre, rim.radius, pen));
    return rims;
}

std::vector<Path> strokes_in(const Shape& shape, const Pen& pen) {
    std::vector<Path> strokes;
    for (const Flat& flat : shape.flats) strokes.push_back(line(flat.bar.from, flat.bar.to, pen));
    for (const Bar& edge : shape.edges) strokes.push_back(line(edge.from, edge.to, pen));
    if (!shape.plate.empty()) strokes.push_back(polyline(shape.plate, pen, true));
    for (const Bar& bar : shape.bars)
        if (length(bar) > 1e-6) strokes.push_back(line(bar.from, bar.to, pen));
    return strokes;
}

std::vector<Path> moved_outlines(Sketch& sketch, BodyIndex body, const RigidMotion& motion, const Pen& pen) {
    const PaperMotion moved(motion, sketch.scale());
    const Shape& shape = sketch.shape(body);
    std::vector<Path> outlines = strokes_in(shape, pen);
    for (Path& path : outlines_of_slides(sketch, body, pen)) outlines.push_back(std::move(path));
    for (const Rim& rim : shape.rims)
        // A wheel that turns about its own centre covers itself.
        if (rim.form != Rim::Form::arc && !coincide(moved(rim.centre), rim.centre))
            outlines.push_back(circle(rim.centre, rim.radius, pen));
    for (Path& path : outlines) moved.move(path);
    return outlines;
}

}  // namespace kinegraph::render::drawing
