// Typeface by HarfBuzz: shaping and unhinted outlines.
#include "render/text/typeface.hpp"

#include <hb-ot.h>
#include <hb.h>

#include <algorithm>
#include <cmath>

namespace kinegraph::render {
namespace {

struct Release {
    void operator()(hb_blob_t* blob) const { hb_blob_destroy(blob); }
    void operator()(hb_font_t* font) const { hb_font_destroy(font); }
    void operator()(hb_buffer_t* buffer) const { hb_buffer_destroy(buffer); }
    void operator()(hb_face_t* face) const { hb_face_destroy(face); }
    void operator()(hb_draw_funcs_t* pen) const { hb_draw_funcs_destroy(pen); }
};
template <class T>
using Owned = std::unique_ptr<T, Release>;

/// Range of a Bézier curve with these ends and controls along one axis beyond its ends, in whole font units.
void reach(double p, double control_1, double control_2, double q, double& least, double& most) {
    least = std::min({least, p, q});
    most = std::max({most, p, q});
    if (std::min(control_1, control_2) >= least && std::max(control_1, control_2) <= most) return;
    // Zeros of a t² + b t + c, a third of the derivative, in the form that is stable for a = 0.
    const double a = q - p + 3 * (control_1 - control_2), b = 2 * (p - 2 * control_1 + control_2), c = control_1 - p;
    const double under_root = b * b - 4 * a * c;
    if (under_root < 0) return;
    const double sum = -0.5 * (b + std::copysign(std::sqrt(under_root), b));
    for (const double t : {sum / a, c / sum}) {
        if (!(t > 0 && t < 1)) continue;
        const double u = 1 - t,
                     at = std::round(u * u * (u * p + 3 * t * control_1) + t * t * (3 * u * control_2 + t * q));
        least = std::min(least, at);
        most = std::max(most, at);
    }
}

/// Collects an outline as segments in em, with its bounding box.
class Collector {
public:
    Collector(Drawn& drawn, double unit) : segments_(drawn.outline.segments), ink_(drawn.ink), unit_(unit) {}

    void finish() {
        if (segments_.empty()) return;
        segments_.emplace_back(Close{});
        ink_ = {box_.min.x * unit_, box_.min.y * unit_, box_.max.x * unit_, box_.max.y * unit_};
    }

    static void move(hb_draw_funcs_t* /*pen*/, void* self, hb_draw_state_t* /*state*/, float x, float y,
                     void* /*data*/) {
        auto& c = *static_cast<Collector*>(self);
        if (c.segments_.empty())
            c.box_ = {{x, y}, {x, y}};
        else
            c.segments_.emplace_back(Close{});
        c.segments_.emplace_back(MoveTo{c.em({x, y})});
        c.go_to({x, y});
    }
    static void line(hb_draw_funcs_t* /*pen*/, void* self, hb_draw_state_t* /*state*/, float x, float y,
                     void* /*data*/) {
        auto& c = *static_cast<Collector*>(self);
        c.segments_.emplace_back(LineTo{c.em({x, y})});
        c.go_to({x, y});
    }
    static void cubic(hb_draw_funcs_t* /*pen*/, void* self, hb_draw_state_t* /*state*/, float x_1, float y_1, float x_2,
                      float y_2, float x, float y, void* /*data*/) {
        auto& c = *static_cast<Collector*>(self);
        c.segments_.emplace_back(CurveTo{c.em({x_1, y_1}), c.em({x_2, y_2}), c.em({x, y})});
        reach(c.at_.x, x_1, x_2, x, c.box_.min.x, c.box_.max.x);
        reach(c.at_.y, y_1, y_2, y, c.box_.min.y, c.box_.max.y);
        c.at_ = {x, y};
    }
    /// Callbacks for HarfBuzz. It delivers quadratic curves as cubic ones, and the closing line of a contour if there
    /// is one.
    static Owned<hb_draw_funcs_t> pen() {
        Owned<hb_draw_funcs_t> calls(hb_draw_funcs_create());
        hb_draw_funcs_set_move_to_func(calls.get(), move, nullptr, nullptr);
        hb_draw_funcs_set_line_to_func(calls.get(), line, nullptr, nullptr);
        hb_draw_funcs_set_cubic_to_func(calls.get(), cubic, nullptr, nullptr);
        return calls;
    }

private:
    Spot em(Spot units) const { return {units.x * unit_, units.y * unit_}; }
    void go_to(Spot to) {
        at_ = to;
        box_ = {{std::min(box_.min.x, to.x), std::min(box_.min.y, to.y)},
                {std::max(box_.max.x, to.x), std::max(box_.max.y, to.y)}};
    }

    std::vector<Segment>& segments_;
    Ink& ink_;
    double unit_;
    Spot at_{};
    Box box_{};  // font units
};

class OpenTypeFace final : public Typeface {
public:
    OpenTypeFace(Owned<hb_blob_t> blob, hb_face_t* face, std::shared_ptr<const void> owner)
        : owner_(std::move(owner)),
          blob_(std::move(blob)),
          font_(hb_font_create(face)),  // its default scale is the face's units per em, so nothing is rounded
          unit_(1.0 / hb_face_get_upem(face)),
          glyphs_(hb_face_get_glyph_count(face)) {}

    double unit() const override { return unit_; }
    std::size_t glyphs() const override { return glyphs_; }
    bool has(char32_t character) const override {
        hb_codepoint_t glyph = 0;
        return hb_font_get_nominal_glyph(font_.get(), character, &glyph) != 0;
    }
    char32_t composed(char32_t letter, char32_t accent) const override {
        hb_codepoint_t whole = 0;
        return hb_unicode_compose(hb_unicode_funcs_get_default(), letter, accent, &whole) ? whole : 0;
    }
    void shape(std::span<const char32_t> run, std::vector<Placed>& placed) const override {
        hb_buffer_t* b = buffer_.get();
        hb_buffer_clear_contents(b);
        static_assert(sizeof(char32_t) == sizeof(hb_codepoint_t));
        hb_buffer_add_codepoints(b, reinterpret_cast<const hb_codepoint_t*>(run.data()), static_cast<int>(run.size()),
                                 0, static_cast<int>(run.size()));
        hb_buffer_set_direction(b, HB_DIRECTION_LTR);
        hb_buffer_set_script(b, HB_SCRIPT_LATIN);
        hb_buffer_set_language(b, language_);
        hb_shape(font_.get(), b, nullptr, 0);
        unsigned count = 0;
        const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(b, &count);
        const hb_glyph_position_t* places = hb_buffer_get_glyph_positions(b, &count);
        placed.clear();
        for (unsigned i = 0; i < count; ++i)
            placed.push_back(
                {infos[i].codepoint, places[i].x_offset, places[i].y_offset, places[i].x_advance, infos[i].cluster});
    }
    Drawn draw(std::uint32_t glyph) const override {
        Drawn drawn;
        Collector collector(drawn, unit_);
        hb_font_get_glyph_shape(font_.get(), glyph, pen_.get(), &collector);
        collector.finish();
        return drawn;
    }
    std::string_view file() const override {
        unsigned length = 0;
        const char* bytes = hb_blob_get_data(blob_.get(), &length);
        return {bytes, length};
    }

private:
    std::shared_ptr<const void> owner_;  // of the bytes
    Owned<hb_blob_t> blob_;
    Owned<hb_font_t> font_;
    double unit_;
    std::size_t glyphs_;
    Owned<hb_buffer_t> buffer_{hb_buffer_create()};
    hb_language_t language_ = hb_language_from_string("en", -1);  // independent of the machine's locale
    Owned<hb_draw_funcs_t> pen_{Collector::pen()};
};

}  // namespace

std::unique_ptr<Typeface> typeface_of(std::string_view file, std::shared_ptr<const void> owner) {
    Owned<hb_blob_t> blob(
        hb_blob_create(file.data(), static_cast<unsigned>(file.size()), HB_MEMORY_MODE_READONLY, nullptr, nullptr));
    const Owned<hb_face_t> face(hb_face_create(blob.get(), 0));
    if (hb_face_get_glyph_count(face.get()) == 0) return nullptr;
    return std::make_unique<OpenTypeFace>(std::move(blob), face.get(), std::move(owner));
}

}  // namespace kinegraph::render
