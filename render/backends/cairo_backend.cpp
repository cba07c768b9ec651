// PNG and PDF backends by cairo: the only file that depends on cairo and libpng. The PNG fills outlines; the PDF embeds
// subsets of the fonts, each once for all sizes. No layout is decided here.
#include <cairo-ft.h>
#include <cairo-pdf.h>
#include <cairo.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <new>
#include <numbers>
#include <span>
#include <utility>

#include "engine/number/assert.hpp"
#include "render/backends/backends.hpp"
#include "render/backends/live_text.hpp"
#include "render/backends/picture_difference.hpp"
#include "render/text/utf8.hpp"

namespace kinegraph::render {
namespace {

constexpr double points_of_mm = 72 / 25.4;
constexpr double miter_limit = 4;  // the default of SVG, so that all backends cut the same corners

constexpr double drawn_tolerance = 0.1;  // between a curve and its chords, in pixels
constexpr double type_tolerance = 0.2;

struct Release {
    void operator()(cairo_t* cr) const { cairo_destroy(cr); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_font_options_t* options) const { cairo_font_options_destroy(options); }
    void operator()(cairo_font_face_t* face) const { cairo_font_face_destroy(face); }
};
template <class T>
using Owned = std::unique_ptr<T, Release>;

void use(cairo_t* cr, Colour c) { cairo_set_source_rgb(cr, c.red / 255.0, c.green / 255.0, c.blue / 255.0); }

/// Adds an outline (em units, y upwards) at `origin`.
void add_outline(cairo_t* cr, const Outline& outline, double size, Spot origin) {
    const auto x = [&](Spot p) { return origin.x + p.x * size; };
    const auto y = [&](Spot p) { return origin.y - p.y * size; };
    for (const Segment& segment : outline.segments) {
        if (const auto* m = std::get_if<MoveTo>(&segment)) {
            cairo_move_to(cr, x(m->to), y(m->to));
        } else if (const auto* l = std::get_if<LineTo>(&segment)) {
            cairo_line_to(cr, x(l->to), y(l->to));
        } else if (const auto* c = std::get_if<CurveTo>(&segment)) {
            cairo_curve_to(cr, x(c->control_1), y(c->control_1), x(c->control_2), y(c->control_2), x(c->to), y(c->to));
        } else {
            cairo_close_path(cr);
        }
    }
}

void draw(cairo_t* cr, const Path& path) {
    cairo_new_path(cr);
    for (const Segment& segment : path.segments) {
        if (const auto* m = std::get_if<MoveTo>(&segment)) {
            cairo_move_to(cr, m->to.x, m->to.y);
        } else if (const auto* l = std::get_if<LineTo>(&segment)) {
            cairo_line_to(cr, l->to.x, l->to.y);
        } else if (const auto* c = std::get_if<CurveTo>(&segment)) {
            cairo_curve_to(cr, c->control_1.x, c->control_1.y, c->control_2.x, c->control_2.y, c->to.x, c->to.y);
        } else if (const auto* a = std::get_if<ArcTo>(&segment)) {
            const double turn = 2 * std::numbers::pi;
            const double to = a->from + std::clamp(a->to - a->from, -turn, turn);
            (to < a->from ? cairo_arc_negative : cairo_arc)(cr, a->centre.x, a->centre.y, a->radius, a->from, to);
        } else {
            cairo_close_path(cr);
        }
    }
    if (path.filled) {
        use(cr, path.fill);
        path.stroked ? cairo_fill_preserve(cr) : cairo_fill(cr);
    }
    if (!path.stroked) return;
    use(cr, path.pen.colour);
    cairo_set_line_width(cr, path.pen.width);
    cairo_set_line_cap(cr, path.pen.round_ends ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(cr, has_round_corners(path) ? CAIRO_LINE_JOIN_ROUND : CAIRO_LINE_JOIN_MITER);
    cairo_set_dash(cr, path.pen.dashes.data(), static_cast<int>(path.pen.dashes.size()), 0);
    cairo_stroke(cr);
}

/// Applies the rotation of the text.
void turn(cairo_t* cr, const TextMark& text) {
    if (text.angle == 0) return;
    cairo_translate(cr, text.pivot.x, text.pivot.y);
    cairo_rotate(cr, text.angle);
    cairo_translate(cr, -text.pivot.x, -text.pivot.y);
}

void lay_paper(cairo_t* cr, const Page& page) {
    use(cr, page.paper);
    cairo_paint(cr);
    cairo_set_miter_limit(cr, miter_limit);
}

/// Draws all marks; user space in mm. `type` fills the glyphs of a text in the current colour.
template <class Type>
void draw(cairo_t* cr, const Page& page, Type&& type) {
    lay_paper(cr, page);
    for (const Mark& mark : page.marks) {
        if (const auto* path = std::get_if<Path>(&mark)) {
            draw(cr, *path);
        } else if (const auto* text = std::get_if<TextMark>(&mark)) {
            cairo_save(cr);
            turn(cr, *text);
            use(cr, text->colour);
            type(*text);
            for (const Path& extra : text->extras) draw(cr, extra);
            cairo_restore(cr);
        }
    }
    KG_ASSERT(cairo_status(cr) == CAIRO_STATUS_SUCCESS, cairo_status_to_string(cairo_status(cr)));
}

bool grey(Colour c) { return c.red == c.green && c.green == c.blue; }
bool grey(const Path& path) { return (!path.filled || grey(path.fill)) && (!path.stroked || grey(path.pen.colour)); }
bool grey(const Page& page) {
    return grey(page.paper) && std::all_of(page.marks.begin(), page.marks.end(), [](const Mark& mark) {
               if (const auto* path = std::get_if<Path>(&mark)) return grey(*path);
               const auto* text = std::get_if<TextMark>(&mark);
               return text == nullptr ||
                      (grey(text->colour) && std::all_of(text->extras.begin(), text->extras.end(),
                                                         [](const Path& extra) { return grey(extra); }));
           });
}

cairo_status_t append(void* out, const unsigned char* data, unsigned length) {
    static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

struct PictureSize {
    int width, height;
    double scale;  // pixels per mm
};

PictureSize size_at(const Page& page, double dpi) {
    KG_ASSERT(std::isfinite(dpi) && dpi > 0, "a picture has a resolution");
    const double scale = dpi / 25.4;
    const auto pixels = [scale](double mm) { return static_cast<int>(std::ceil(mm * scale - 1e-6)); };
    const PictureSize size{pixels(page.width), pixels(page.height), scale};
    KG_ASSERT(size.width > 0 && size.height > 0 && size.width <= 32767 && size.height <= 32767,
              "the picture is one that cairo draws");
    return size;
}

/// Renders a page into a cairo RGB24 surface.
Owned<cairo_surface_t> drawn(const Page& page, const Glyphs& glyphs, const PictureSize& size) {
    Owned<cairo_surface_t> surface{cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.width, size.height)};
    const Owned<cairo_t> cr{cairo_create(surface.get())};
    if (cairo_status(cr.get()) == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
    KG_ASSERT(cairo_status(cr.get()) == CAIRO_STATUS_SUCCESS, "cairo draws on it");
    cairo_scale(cr.get(), size.scale, size.scale);
    draw(cr.get(), page, [&](const TextMark& text) {
        cairo_set_tolerance(cr.get(), type_tolerance);
        cairo_new_path(cr.get());
        for (const Glyph& g : text.glyphs) {
            add_outline(cr.get(), glyphs.outline(g.face, g.index), g.size, g.origin);
            cairo_fill(cr.get());  // faster glyph by glyph than a line at once
        }
        cairo_set_tolerance(cr.get(), drawn_tolerance);
    });
    cairo_surface_flush(surface.get());
    return surface;
}

/// Calls take() with each row of a surface, from the top.
template <class Take>
void for_each_row(cairo_surface_t* surface, const PictureSize& size, Take take) {
    const unsigned char* const pixels = cairo_image_surface_get_data(surface);
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
    for (std::size_t y = 0; y < static_cast<std::size_t>(size.height); ++y)
        take(std::span(reinterpret_cast<const std::uint32_t*>(pixels + y * stride),
                       static_cast<std::size_t>(size.width)));
}

/// Sheets are mostly blank: filters enlarge the file, and higher levels of zlib take twice the time for 3 %.
std::string png_of(cairo_surface_t* surface, const PictureSize& size, bool in_grey, double dpi) {
    std::string out;
    const auto fail = [](png_structp, png_const_charp message) { throw Fault(std::string("libpng: ") + message); };
    png_structp png =
        png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, [](png_structp, png_const_charp) {});
    KG_ASSERT(png != nullptr, "libpng starts");
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &out,
        [](png_structp p, png_bytep data, std::size_t length) {
            static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<const char*>(data), length);
        },
        [](png_structp) {});
    png_set_IHDR(png, info, static_cast<png_uint_32>(size.width), static_cast<png_uint_32>(size.height), 8,
                 in_grey ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    const auto each_metre = static_cast<png_uint_32>(std::lround(dpi / 0.0254));
    png_set_pHYs(png, info, each_metre, each_metre, PNG_RESOLUTION_METER);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
    png_set_compression_level(png, 1);
    png_write_info(png, info);
    std::vector<png_byte> row;
    for_each_row(surface, size, [&](std::span<const std::uint32_t> pixels) {
        row.clear();
        for (const std::uint32_t pixel : pixels) {
            if (!in_grey) {
                row.push_back(static_cast<png_byte>(pixel >> 16));
                row.push_back(static_cast<png_byte>(pixel >> 8));
            }
            row.push_back(static_cast<png_byte>(pixel));
        }
        png_write_row(png, row.data());
    });
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return out;
}

/// FreeType objects behind a cairo font. cairo caches fonts, so cairo frees these.
struct OpenFace {
    FT_Library library = nullptr;
    FT_Face face = nullptr;
    ~OpenFace() {
        FT_Done_Face(face);
        FT_Done_FreeType(library);
    }
};
const cairo_user_data_key_t open_face{};

struct EmbeddedFace {
    Owned<cairo_font_face_t> font;
    unsigned long blank = 0;  // glyph index of the space
};

/// A face as a cairo font that can be embedded; unhinted, like the layout of the sheet.
EmbeddedFace embedded_face(const Glyphs& glyphs, std::uint8_t face) {
    auto own = std::make_unique<OpenFace>();
    const std::string_view file = glyphs.file(face);
    KG_ASSERT(FT_Init_FreeType(&own->library) == 0, "FreeType starts");
    KG_ASSERT(FT_New_Memory_Face(own->library, reinterpret_cast<const FT_Byte*>(file.data()),
                                 static_cast<FT_Long>(file.size()), 0, &own->face) == 0,
              "a face that HarfBuzz reads is read by FreeType");
    Owned<cairo_font_face_t> font{
        cairo_ft_font_face_create_for_ft_face(own->face, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP)};
    const unsigned long blank = FT_Get_Char_Index(own->face, U' ');
    cairo_font_face_set_user_data(font.get(), &open_face, own.release(),
                                  [](void* p) { delete static_cast<OpenFace*>(p); });
    return {std::move(font), blank};
}

}  // namespace

std::string to_png(const Page& page, const Glyphs& glyphs, double dpi) {
    const PictureSize size = size_at(page, dpi);
    return png_of(drawn(page, glyphs, size).get(), size, grey(page), dpi);
}

Picture to_picture(const Page& page, const Glyphs& glyphs, double dpi) {
    const PictureSize size = size_at(page, dpi);
    Picture picture{size.width, size.height, {}, dpi};
    picture.pixels.reserve(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    for_each_row(drawn(page, glyphs, size).get(), size, [&](std::span<const std::uint32_t> pixels) {
        for (const std::uint32_t pixel : pixels)
            picture.pixels.push_back({static_cast<std::uint8_t>(pixel >> 16), static_cast<std::uint8_t>(pixel >> 8),
                                      static_cast<std::uint8_t>(pixel)});
    });
    return picture;
}

namespace {

/// cairo refuses Unicode's noncharacters (U+FDD0 to U+FDEF, and the last two of each plane) as if they were no UTF-8,
/// and with them the whole page. They become U+FFFD.
std::string without_noncharacters(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const char32_t c = next_code_point(text, at);
        const bool none = (c >= 0xFDD0 && c <= 0xFDEF) || (c & 0xFFFE) == 0xFFFE;
        append_utf8(out, none ? replacement_character : c);
    }
    return out;
}

/// A PDF under construction: fixed creation date, unhinted fonts.
class PdfDocument {
public:
    PdfDocument(const std::vector<Page>& pages, const Glyphs& glyphs)
        : surface_{cairo_pdf_surface_create_for_stream(append, &bytes_, pages.front().width * points_of_mm,
                                                       pages.front().height * points_of_mm)},
          faces_{embedded_face(glyphs, 0), embedded_face(glyphs, 1), embedded_face(glyphs, 2),
                 embedded_face(glyphs, 3)} {
        cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
        cairo_pdf_surface_set_metadata(surface_.get(), CAIRO_PDF_METADATA_TITLE,
                                       without_noncharacters(well_formed(pages.front().title)).c_str());
        cr_.reset(cairo_create(surface_.get()));
        const Owned<cairo_font_options_t> unhinted{cairo_font_options_create()};
        cairo_font_options_set_hint_style(unhinted.get(), CAIRO_HINT_STYLE_NONE);
        cairo_font_options_set_hint_metrics(unhinted.get(), CAIRO_HINT_METRICS_OFF);
        cairo_set_font_options(cr_.get(), unhinted.get());
    }

    cairo_t* pen() const { return cr_.get(); }

    /// Adds a page drawn by `draw_marks` in mm.
    template <class Draw>
    void add(const Page& page, Draw&& draw_marks) {
        cairo_pdf_surface_set_size(surface_.get(), page.width * points_of_mm, page.height * points_of_mm);
        cairo_save(pen());
        cairo_scale(pen(), points_of_mm, points_of_mm);
        draw_marks();
        cairo_restore(pen());
        cairo_show_page(pen());
    }

    /// cairo treats every size as a separate font, so sizes that differ only in their last bits are merged.
    static double snapped(double size) { return std::round(size * 1e6) * 1e-6; }

    unsigned long blank(std::uint8_t face) const { return faces_.at(face).blank; }

    void choose(const Glyph& glyph) {
        cairo_set_font_face(pen(), faces_.at(glyph.face).font.get());
        cairo_set_font_size(pen(), snapped(glyph.size));
    }

    std::string finish() {
        cr_.reset();
        cairo_surface_finish(surface_.get());
        KG_ASSERT(cairo_surface_status(surface_.get()) == CAIRO_STATUS_SUCCESS, "the PDF is written");
        return std::move(bytes_);
    }

private:
    std::string bytes_;
    Owned<cairo_surface_t> surface_;
    std::array<EmbeddedFace, 4> faces_;
    Owned<cairo_t> cr_;
};

/// Fonts of a readable document: passes the text of the glyphs to cairo.
class LiveType {
public:
    explicit LiveType(PdfDocument& pdf) : pdf_(pdf) {}

    void write(const LiveLine& line) {
        cairo_save(pdf_.pen());
        turn(pdf_.pen(), *line.first);
        for (std::size_t i = 0; i < line.runs.size(); ++i) {
            const LiveRun& run = line.runs[i];
            if (run.letters.empty()) {
                (run.kind == LiveRun::Kind::blank ? blanks_ : unseen_) += run.text;
                continue;
            }
            // The dots over a letter are read together with it.
            const bool dotted = i + 1 < line.runs.size() && line.runs[i + 1].kind == LiveRun::Kind::dots;
            write(run, dotted ? line.runs[++i].text : std::string());
        }
        unseen_.clear();
        blanks_.clear();
        for (const TextMark* mark : line.marks)
            for (const Path& extra : mark->extras) draw(pdf_.pen(), extra);
        cairo_restore(pdf_.pen());
    }

private:
    void write(const LiveRun& run, const std::string& dots) {
        text_.clear();
        glyphs_.clear();
        clusters_.clear();
        const Glyph& first = run.letters.front().glyph;
        pdf_.choose(first);
        if (!blanks_.empty()) {
            // One glyph for all of them, at the position of the last.
            constexpr double width = 0.25;  // em
            glyphs_.push_back({pdf_.blank(first.face), first.origin.x - width * first.size, first.origin.y});
            clusters_.push_back({static_cast<int>(blanks_.size()), 1});
            text_ += std::exchange(blanks_, std::string());
        }
        for (const Letter& letter : run.letters) {
            const Glyph& glyph = letter.glyph;
            glyphs_.push_back({glyph.index, glyph.origin.x, glyph.origin.y});
            const std::string said = without_noncharacters(std::exchange(unseen_, std::string()) + letter.text);
            text_ += said;
            if (said.empty() && !clusters_.empty())
                ++clusters_.back().num_glyphs;
            else
                clusters_.push_back({static_cast<int>(said.size()), 1});
        }
        text_ += dots;
        clusters_.back().num_bytes += static_cast<int>(dots.size());
        use(pdf_.pen(), run.colour);
        cairo_show_text_glyphs(pdf_.pen(), text_.data(), static_cast<int>(text_.size()), glyphs_.data(),
                               static_cast<int>(glyphs_.size()), clusters_.data(), static_cast<int>(clusters_.size()),
                               cairo_text_cluster_flags_t{});
    }

    PdfDocument& pdf_;
    std::string blanks_, unseen_;  // read before the next letter
    std::string text_;
    std::vector<cairo_glyph_t> glyphs_;
    std::vector<cairo_text_cluster_t> clusters_;
};

/// Tags of a page: figures, and paragraphs outside of them.
class Tags {
public:
    explicit Tags(cairo_t* cr) : cr_(cr) {}

    void begin(const GroupBegin& group) {
        const bool figure = figures_ == 0 && group.cls == "figure";
        if (figure) {
            end_paragraph();
            cairo_tag_begin(cr_, "Figure", nullptr);
        }
        figures_ += figure || figures_ > 0 ? 1 : 0;
    }
    void end() {
        if (figures_ == 0 || --figures_ > 0) return;
        cairo_tag_end(cr_, "Figure");
    }
    void text() {
        if (figures_ > 0 || in_paragraph_) return;
        cairo_tag_begin(cr_, "P", nullptr);
        in_paragraph_ = true;
    }
    void end_paragraph() {
        if (in_paragraph_) cairo_tag_end(cr_, "P");
        in_paragraph_ = false;
    }

private:
    cairo_t* cr_;
    int figures_ = 0;  // open groups, counted from the figure's own
    bool in_paragraph_ = false;
};

void draw_live(PdfDocument& pdf, const Page& page) {
    lay_paper(pdf.pen(), page);
    LiveType type(pdf);
    Tags tags(pdf.pen());
    const std::span<const Mark> marks(page.marks);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (const auto* path = std::get_if<Path>(&marks[i])) {
            tags.end_paragraph();
            draw(pdf.pen(), *path);
        } else if (const auto* group = std::get_if<GroupBegin>(&marks[i])) {
            tags.begin(*group);
        } else if (std::holds_alternative<GroupEnd>(marks[i])) {
            tags.end();
        } else if (std::holds_alternative<TextMark>(marks[i])) {
            const LiveLine line = live_line(marks.subspan(i));
            tags.text();
            type.write(line);
            i += line.marks.size() - 1;
        }
    }
    tags.end_paragraph();
    KG_ASSERT(cairo_status(pdf.pen()) == CAIRO_STATUS_SUCCESS, cairo_status_to_string(cairo_status(pdf.pen())));
}

}  // namespace

std::string to_pdf(const std::vector<Page>& pages, const Glyphs& glyphs) {
    KG_ASSERT(!pages.empty(), "a document has a page");
    PdfDocument pdf(pages, glyphs);
    std::vector<cairo_glyph_t> run;
    const auto type = [&](const TextMark& text) {
        for (auto g = text.glyphs.begin(); g != text.glyphs.end();) {
            const Glyph& first = *g;
            const double size = PdfDocument::snapped(first.size);
            run.clear();
            for (; g != text.glyphs.end() && g->face == first.face && PdfDocument::snapped(g->size) == size; ++g) {
                run.push_back({g->index, g->origin.x, g->origin.y});
            }
            pdf.choose(first);
            cairo_show_glyphs(pdf.pen(), run.data(), static_cast<int>(run.size()));
        }
    };
    for (const Page& page : pages) pdf.add(page, [&] { draw(pdf.pen(), page, type); });
    return pdf.finish();
}

std::string to_live_pdf(const std::vector<Page>& pages, const Glyphs& glyphs) {
    KG_ASSERT(!pages.empty(), "a document has a page");
    PdfDocument pdf(pages, glyphs);
    for (const Page& page : pages) pdf.add(page, [&] { draw_live(pdf, page); });
    return with_language(pdf.finish(), pages.front().language);
}

// (This build links cairo directly, so there is nothing to load.)
tl::expected<void, Words> open_painter() { return {}; }

}  // namespace kinegraph::render
