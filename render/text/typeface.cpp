// HarfBuzz shapes, FreeType gives the outlines, unhinted; no fontconfig, so that every machine sets the same line.
#include "render/text/typeface.hpp"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_BBOX_H
#include FT_OUTLINE_H
#include <hb-ot.h>
#include <hb.h>

#include <cstdlib>

#include "render/text/text.hpp"

namespace kinegraph::render {
namespace {

constexpr std::array<const char*, 4> file_names = {"STIXGeneral-Regular.otf", "STIXGeneral-Italic.otf", "STIXGeneral-Bold.otf",
                                                   "STIXGeneral-BoldItalic.otf"};
constexpr const char* debian_directory = "/usr/share/fonts/opentype/stix";

struct Release {
    void operator()(hb_blob_t* blob) const { hb_blob_destroy(blob); }
    void operator()(hb_font_t* font) const { hb_font_destroy(font); }
    void operator()(hb_buffer_t* buffer) const { hb_buffer_destroy(buffer); }
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
    void operator()(hb_face_t* face) const { hb_face_destroy(face); }
    void operator()(FT_Face face) const { FT_Done_Face(face); }
};
template <class T>
using Owned = std::unique_ptr<T, Release>;

/// Collects a FreeType outline as segments in em.
struct Collector {
    Outline& outline;
    double unit;
    Spot at{};
    Spot spot(const FT_Vector* v) const { return {static_cast<double>(v->x) * unit, static_cast<double>(v->y) * unit}; }

    static int move(const FT_Vector* to, void* self) {
        auto& c = *static_cast<Collector*>(self);
        if (!c.outline.segments.empty()) c.outline.segments.emplace_back(Close{});
        c.outline.segments.emplace_back(MoveTo{c.at = c.spot(to)});
        return 0;
    }
    static int line(const FT_Vector* to, void* self) {
        auto& c = *static_cast<Collector*>(self);
        c.outline.segments.emplace_back(LineTo{c.at = c.spot(to)});
        return 0;
    }
    static int conic(const FT_Vector* control, const FT_Vector* to, void* self) {
        auto& c = *static_cast<Collector*>(self);
        const Spot q = c.spot(control), end = c.spot(to);
        const auto towards = [&q](Spot p) { return Spot{(p.x + 2 * q.x) / 3, (p.y + 2 * q.y) / 3}; };
        c.outline.segments.emplace_back(CurveTo{towards(c.at), towards(end), end});
        c.at = end;
        return 0;
    }
    static int cubic(const FT_Vector* control_1, const FT_Vector* control_2, const FT_Vector* to, void* self) {
        auto& c = *static_cast<Collector*>(self);
        c.outline.segments.emplace_back(CurveTo{c.spot(control_1), c.spot(control_2), c.spot(to)});
        c.at = c.spot(to);
        return 0;
    }
};

class OpenTypeFace final : public Typeface {
public:
    OpenTypeFace(Owned<hb_blob_t> blob, hb_face_t* face)
        : blob_(std::move(blob)),
          font_(hb_font_create(face)),  // its scale is the face's units for each em, so nothing is rounded
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
        hb_buffer_add_codepoints(b, reinterpret_cast<const hb_codepoint_t*>(run.data()), static_cast<int>(run.size()), 0,
                                 static_cast<int>(run.size()));
        hb_buffer_set_direction(b, HB_DIRECTION_LTR);
        hb_buffer_set_script(b, HB_SCRIPT_LATIN);
        hb_buffer_set_language(b, language_);
        hb_shape(font_.get(), b, nullptr, 0);
        unsigned count = 0;
        const hb_glyph_info_t* infos = hb_buffer_get_glyph_infos(b, &count);
        const hb_glyph_position_t* places = hb_buffer_get_glyph_positions(b, &count);
        placed.clear();
        for (unsigned i = 0; i < count; ++i)
            placed.push_back({infos[i].codepoint, places[i].x_offset, places[i].y_offset, places[i].x_advance, infos[i].cluster});
    }
    std::optional<Drawn> draw(std::uint32_t glyph) const override {
        if (!outlines_ && !open_outlines()) return std::nullopt;
        std::optional<Drawn> drawn{std::in_place};
        if (FT_Load_Glyph(outlines_.get(), glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_SCALE) != 0) return drawn;
        FT_Outline& outline = outlines_->glyph->outline;
        if (outline.n_points == 0) return drawn;
        static constexpr FT_Outline_Funcs collect = {Collector::move, Collector::line, Collector::conic, Collector::cubic, 0, 0};
        Collector collector{drawn->outline, unit_};
        FT_Outline_Decompose(&outline, &collect, &collector);
        drawn->outline.segments.emplace_back(Close{});
        FT_BBox box{};
        FT_Outline_Get_BBox(&outline, &box);
        const auto em = [this](FT_Pos units) { return static_cast<double>(units) * unit_; };
        drawn->ink = {em(box.xMin), em(box.yMin), em(box.xMax), em(box.yMax)};
        return drawn;
    }
    std::string_view file() const override {
        unsigned length = 0;
        const char* bytes = hb_blob_get_data(blob_.get(), &length);
        return {bytes, length};
    }

private:
    /// FreeType starts with the first glyph that is drawn: shaping does without.
    bool open_outlines() const {
        FT_Library library = nullptr;
        if (FT_Init_FreeType(&library) != 0) return false;
        library_.reset(library);
        const std::string_view bytes = file();
        FT_Face face = nullptr;
        if (FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(bytes.data()), static_cast<FT_Long>(bytes.size()), 0,
                               &face) != 0)
            return false;
        outlines_.reset(face);
        return true;
    }

    Owned<hb_blob_t> blob_;
    Owned<hb_font_t> font_;
    double unit_;
    std::size_t glyphs_;
    Owned<hb_buffer_t> buffer_{hb_buffer_create()};
    hb_language_t language_ = hb_language_from_string("en", -1);  // never the machine's
    mutable Owned<FT_LibraryRec_> library_;                       // outlives the outlines
    mutable Owned<FT_FaceRec_> outlines_;
};

}  // namespace

tl::expected<Typefaces, Words> open_typefaces() {
    const char* chosen = std::getenv("KINEGRAPH_FONT_DIR");
    const std::string directory = chosen != nullptr && *chosen != '\0' ? chosen : debian_directory;
    Typefaces opened;
    for (std::size_t i = 0; i < opened.size(); ++i) {
        const std::string path = directory + "/" + file_names[i];
        Owned<hb_blob_t> blob(hb_blob_create_from_file_or_fail(path.c_str()));
        const bool read = blob != nullptr;
        const Owned<hb_face_t> face(read ? hb_face_create(blob.get(), 0) : nullptr);
        if (!face || hb_face_get_glyph_count(face.get()) == 0)
            return tl::unexpected(Words(
                "{0} {1}: install the Debian package fonts-stix, or name the directory of its files in KINEGRAPH_FONT_DIR",
                "{0} {1}: installare il pacchetto Debian fonts-stix, o indicare la cartella dei suoi file in KINEGRAPH_FONT_DIR",
                path, read ? Words("is no font", "non è un font") : Words("cannot be read", "non si può leggere")));
        opened[i] = std::make_unique<OpenTypeFace>(std::move(blob), face.get());
    }
    return opened;
}

// Here and not in text.cpp, so that a program that brings its typefaces from elsewhere links neither library.
tl::expected<Fonts, Words> Fonts::open() {
    return open_typefaces().map([](Typefaces&& faces) { return Fonts(std::move(faces)); });
}

}  // namespace kinegraph::render
