// DXF backend: the marks of a page as entities. Strokes are lines, arcs, circles and polylines with bulges; fillings
// are solid hatches; words are texts fitted into the widths that they have on our page. A layer is a role of the
// drawing; what belongs to a named group says so in its extended data. No layout is decided here.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/number/functions.hpp"
#include "render/backends/backends.hpp"
#include "render/backends/dxf_document.hpp"
#include "render/backends/live_text.hpp"
#include "render/text/utf8.hpp"

namespace kinegraph::render {
namespace {

constexpr double whole_turn = 2 * std::numbers::pi;

/// The layers by the class of the group, innermost first. A group without a row is on the layer of the one round it.
constexpr auto layers_by_class = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"link", "links"},
    {"links", "links"},
    {"crossing", "links"},
    {"bar", "links"},
    {"side", "links"},
    {"position", "poses"},
    {"joint", "joints"},
    {"joints", "joints"},
    {"spring", "springs"},
    {"torsion-spring", "springs"},
    {"gas-spring", "springs"},
    {"ground", "ground"},
    {"tint", "tint"},
    {"construction", "construction"},
    {"ray", "construction"},
    {"detail", "construction"},
    {"arrows", "arrows"},
    {"vector", "vectors"},
    {"velocity", "vectors"},
    {"force", "vectors"},
    {"sense", "vectors"},
    {"equivalent", "vectors"},
    {"distributed", "vectors"},
    {"displacement", "vectors"},
    {"centre", "centres"},
    {"centres", "centres"},
    {"centrode", "centres"},
    {"inflection", "centres"},
    {"tangential", "centres"},
    {"osculating", "centres"},
    {"dimension", "dimensions"},
    {"dimensions", "dimensions"},
    {"curve", "curves"},
    {"path", "curves"},
    {"axis", "plot"},
    {"axis-x", "plot"},
    {"axis-y", "plot"},
    {"dead-point", "plot"},
    {"change-point", "plot"},
    {"asymptote", "plot"},
    {"drawn-position", "plot"},
    {"separation", "plot"},
    {"figure", "figures"},
});
constexpr std::string_view sheet_layer = "sheet";  // frame, title block, rules of tables

/// Whether the fonts of drafting programs have all letters: those of WGL4, which Times New Roman has, and letters of
/// other scripts, for which programs have fonts of their own. ⟂, ✓ and ① are drawn.
bool is_in_usual_fonts(std::string_view text) {
    constexpr std::u32string_view signs = U"–—‘’“”†‡•…‰′″‹›⁄€∂∆∏∑−√∞∫≈≠≡≤≥←↑→↓↔↕";
    for (std::size_t at = 0; at < text.size();) {
        const char32_t c = next_code_point(text, at);
        const bool is_letter = c < 0x590 || (c >= 0x3040 && c < 0xFB00);
        if (!is_letter && signs.find(c) == std::u32string_view::npos) return false;
    }
    return true;
}

/// A vertex of a polyline. The bulge is that of the way to the next one: the tangent of a quarter of its turn.
struct Vertex {
    Spot at;
    double bulge = 0;
};
/// A part of a path without a gap. The last vertex of a closed one is not its first again.
struct Run {
    std::vector<Vertex> vertices;
    bool is_closed = false;
    std::optional<ArcTo> arc{};  ///< it is nothing but this arc
};

class Runs {
public:
    explicit Runs(const Path& path) {
        for (const Segment& segment : path.segments) std::visit([&](const auto& each) { add(each); }, segment);
        end();
    }
    std::vector<Run> runs;

private:
    void add(const MoveTo& move) {
        end();
        run_.vertices.push_back({move.to});
        is_open_ = true;
    }
    void add(const LineTo& line) { go({line.to}); }
    void add(const CurveTo& curve) {
        constexpr double tolerance = 0.005;  // mm
        const Spot from = run_.vertices.back().at;
        const double bend = std::max(length(from - 2 * curve.control_1 + curve.control_2),
                                     length(curve.control_1 - 2 * curve.control_2 + curve.to));
        const int parts = std::clamp(static_cast<int>(std::ceil(std::sqrt(0.75 * bend / tolerance))), 1, 100);
        for (int i = 1; i <= parts; ++i) {
            const double t = static_cast<double>(i) / parts, u = 1 - t;
            go({u * u * u * from + 3 * u * u * t * curve.control_1 + 3 * u * t * t * curve.control_2 +
                t * t * t * curve.to});
        }
    }
    void add(const ArcTo& arc) {
        const auto on = [&](double angle) { return arc.centre + arc.radius * polar_spot(angle); };
        const double sweep = std::clamp(arc.to - arc.from, -whole_turn, whole_turn);
        constexpr double joined = 1.5e-8;  // mm; the page is snapped to 1e-8 mm
        const bool alone =
            !is_open_ || (run_.vertices.size() == 1 && length(run_.vertices.back().at - on(arc.from)) <= joined);
        if (!is_open_)
            add(MoveTo{on(arc.from)});
        else if (!alone && length(run_.vertices.back().at - on(arc.from)) > joined)
            go({on(arc.from)});
        const int parts = std::abs(sweep) > 3 ? 2 : 1;
        for (int i = 1; i <= parts; ++i) {
            // Positive angles turn clockwise on paper, positive bulges the other way.
            run_.vertices.back().bulge = -nearest::tan(sweep / parts / 4);
            run_.vertices.push_back({on(arc.from + sweep * i / parts)});
        }
        run_.arc.reset();
        if (alone) run_.arc = ArcTo{arc.centre, arc.radius, arc.from, arc.from + sweep};
    }
    void add(const Close&) {
        if (!is_open_) return;
        run_.is_closed = true;
        // A whole circle is closed already.
        if (run_.arc && std::abs(run_.arc->to - run_.arc->from) < whole_turn - 1e-9) run_.arc.reset();
        const Spot first = run_.vertices.front().at;
        end();
        run_.vertices.push_back({first});  // the pen, if the path goes on
    }
    void go(Vertex vertex) {
        is_open_ = true;
        run_.arc.reset();
        run_.vertices.push_back(vertex);
    }
    void end() {
        if (is_open_ && run_.vertices.size() > 1) {
            const bool meets = length(run_.vertices.back().at - run_.vertices.front().at) < 1e-7;
            if (meets && run_.vertices.size() > 2) {
                run_.vertices.pop_back();
                run_.is_closed = true;
            }
            runs.push_back(std::move(run_));
        }
        run_ = {};
        is_open_ = false;
    }

    Run run_;
    bool is_open_ = false;
};

class DxfSheet {
public:
    DxfSheet(const Page& page, const Glyphs& glyphs)
        : page_(page),
          glyphs_(glyphs),
          document_(page.width, page.height),
          out_(document_.entities()),
          on_dark_paper_(brightness(page.paper) < 128) {}

    std::string write() {
        const std::span<const Mark> marks(page_.marks);
        for (std::size_t i = 0; i < marks.size(); ++i) {
            if (const auto* path = std::get_if<Path>(&marks[i])) {
                write(*path, layer());
            } else if (const auto* axis = std::get_if<Axis>(&marks[i])) {
                line_entity(axis->tail, axis->tip, DxfDocument::unseen_layer, nullptr);
            } else if (const auto* group = std::get_if<GroupBegin>(&marks[i])) {
                open(*group);
            } else if (std::holds_alternative<GroupEnd>(marks[i])) {
                groups_.pop_back();
            } else {
                const LiveLine line = live_line(marks.subspan(i));
                write(line);
                i += line.marks.size() - 1;
            }
        }
        return document_.write("Kinegraph: " + dxf_text(page_.title));
    }

private:
    struct Group {
        std::string_view layer;
        std::string id;
    };

    static int brightness(Colour c) { return (299 * c.red + 587 * c.green + 114 * c.blue) / 1000; }

    void open(const GroupBegin& group) {
        Group inner = groups_.empty() ? Group{sheet_layer, ""} : groups_.back();
        for (const auto& [cls, layer] : layers_by_class)
            if (group.cls == cls) inner.layer = layer;
        if (!group.id.empty()) inner.id = group.id.text();
        groups_.push_back(inner);
    }
    std::string_view layer() const { return groups_.empty() ? sheet_layer : groups_.back().layer; }

    // --- entities

    void begin(std::string_view type, std::string_view layer) {
        out_.put(0, type);
        out_.put_handle(5, document_.new_handle());
        out_.put_handle(330, DxfDocument::model_space);
        out_.put(100, "AcDbEntity");
        out_.put(8, document_.layer(std::string(layer)));
    }
    /// Ink that stands out against the paper as text does has the colour of the layer, which a program turns over on a
    /// dark screen.
    void colour(Colour colour) {
        constexpr int near_ink = 48;
        const int bright = brightness(colour);
        if (on_dark_paper_ ? bright > 255 - near_ink : bright < near_ink) return;
        out_.put(62, colour_index(colour));
        out_.put(420, (colour.red << 16) | (colour.green << 8) | colour.blue);
    }
    void stroke(const Pen* pen) {
        if (pen == nullptr) return;
        if (!pen->dashes.empty()) {
            const DxfLineKind kind = document_.line_kind(pen->dashes);
            out_.put(6, kind.name);
            if (kind.scale != 1) out_.put(48, kind.scale);
        }
        colour(pen->colour);
        out_.put(370, line_weight(pen->width));
    }
    /// What it belongs to: the id of the group, as in the SVG.
    void end() {
        if (groups_.empty() || groups_.back().id.empty()) return;
        out_.put(1001, "KINEGRAPH");
        out_.put(1000, groups_.back().id);
    }

    Spot upwards(Spot spot) const { return {spot.x, page_.height - spot.y}; }
    /// Of an angle on paper, clockwise, in radians: counter-clockwise, in degrees from 0 up to 360.
    static double degrees(double angle) {
        const double turned = std::fmod(-angle * 180 / std::numbers::pi, 360);
        return turned < 0 ? turned + 360 : turned;
    }

    void line_entity(Spot from, Spot to, std::string_view layer, const Pen* pen) {
        begin("LINE", layer);
        stroke(pen);
        out_.put(100, "AcDbLine");
        out_.put_point(10, upwards(from));
        out_.put_point(11, upwards(to));
        end();
    }
    void arc_entity(const ArcTo& arc, std::string_view layer, const Pen& pen) {
        const bool whole = std::abs(arc.to - arc.from) > whole_turn - 1e-9;
        begin(whole ? "CIRCLE" : "ARC", layer);
        stroke(&pen);
        out_.put(100, "AcDbCircle");
        out_.put_point(10, upwards(arc.centre));
        out_.put(40, arc.radius);
        if (!whole) {
            // An arc of DXF runs counter-clockwise.
            out_.put(100, "AcDbArc");
            out_.put(50, degrees(std::max(arc.from, arc.to)));
            out_.put(51, degrees(std::min(arc.from, arc.to)));
        }
        end();
    }
    void polyline_entity(const Run& run, std::string_view layer, const Pen& pen) {
        begin("LWPOLYLINE", layer);
        stroke(&pen);
        out_.put(100, "AcDbPolyline");
        out_.put_count(90, run.vertices.size());
        constexpr int closed = 1, dashes_go_round_corners = 128;
        out_.put(70, (run.is_closed ? closed : 0) | (pen.dashes.empty() ? 0 : dashes_go_round_corners));
        vertices(run);
        end();
    }
    void vertices(const Run& run) {
        for (const Vertex& vertex : run.vertices) {
            const Spot at = upwards(vertex.at);
            out_.put(10, at.x);
            out_.put(20, at.y);
            if (vertex.bulge != 0) out_.put(42, vertex.bulge);
        }
    }

    void hatch(const std::vector<Run>& runs, Colour fill, std::string_view layer) {
        begin("HATCH", layer);
        colour(fill);
        out_.put(100, "AcDbHatch");
        out_.put_point(10, {0, 0});
        out_.put(210, 0.0);
        out_.put(220, 0.0);
        out_.put(230, 1.0);
        out_.put(2, "SOLID");
        out_.put(70, 1);
        out_.put(71, 0);
        out_.put_count(91, runs.size());
        for (const Run& run : runs) {
            const bool bulges = std::any_of(run.vertices.begin(), run.vertices.end(),
                                            [](const Vertex& vertex) { return vertex.bulge != 0; });
            constexpr int external = 1, polyline = 2;
            out_.put(92, external | polyline);
            out_.put(72, bulges ? 1 : 0);
            out_.put(73, 1);
            out_.put_count(93, run.vertices.size());
            for (const Vertex& vertex : run.vertices) {
                const Spot at = upwards(vertex.at);
                out_.put(10, at.x);
                out_.put(20, at.y);
                if (bulges) out_.put(42, vertex.bulge);
            }
            out_.put(97, 0);
        }
        out_.put(75, 0);
        out_.put(76, 1);
        out_.put(98, 0);
        end();
    }

    void write(const Path& path, std::string_view layer) {
        const std::vector<Run> runs = Runs(path).runs;
        if (runs.empty()) return;
        if (path.filled) {
            // What only covers the lines below it, or is a body's tint, may be turned off.
            const std::string_view of_fill = !path.tinted ? layer : path.fill == page_.paper ? "covers" : "tint";
            hatch(runs, path.fill, of_fill);
        }
        if (!path.stroked) return;
        for (const Run& run : runs) {
            if (run.arc)
                arc_entity(*run.arc, layer, path.pen);
            else if (run.vertices.size() == 2 && run.vertices.front().bulge == 0)
                line_entity(run.vertices[0].at, run.vertices[1].at, layer, &path.pen);
            else
                polyline_entity(run, layer, path.pen);
        }
    }

    // --- words

    /// Letters of one face, size, baseline and colour, with the blanks between them.
    struct Words {
        std::string text;
        Glyph first, last;
        Colour colour;
    };

    void write(const LiveLine& line) {
        const std::string_view layer = line.first->cls == "label" ? "labels" : "text";
        std::optional<Words> words;
        std::string blanks;
        const auto flush = [&] {
            if (words) text_entity(*line.first, *words, layer);
            words.reset();
            blanks.clear();
        };
        for (const LiveRun& run : line.runs) {
            if (run.kind == LiveRun::Kind::blank) blanks += ' ';
            if (run.kind != LiveRun::Kind::set && run.kind != LiveRun::Kind::coded) continue;
            for (const Letter& letter : run.letters) {
                const Glyph& glyph = letter.glyph;
                if (run.kind == LiveRun::Kind::set && !is_in_usual_fonts(letter.text)) {
                    flush();
                    outline(*line.first, letter.glyph, run.colour, layer);
                    continue;
                }
                const bool joins = words && glyph.face == words->first.face && glyph.size == words->first.size &&
                                   glyph.origin.y == words->first.origin.y && run.colour == words->colour;
                if (!joins) flush();
                if (!joins) words = Words{"", glyph, glyph, run.colour};
                words->text += blanks + letter.text;
                blanks.clear();
                words->last = glyph;
            }
            if (run.kind == LiveRun::Kind::coded) flush();
        }
        flush();
        for (const TextMark* mark : line.marks)
            for (Path extra : mark->extras) {
                for (Segment& segment : extra.segments) {
                    if (auto* m = std::get_if<MoveTo>(&segment)) m->to = turned(*mark, m->to);
                    if (auto* l = std::get_if<LineTo>(&segment)) l->to = turned(*mark, l->to);
                    if (auto* a = std::get_if<ArcTo>(&segment)) a->centre = turned(*mark, a->centre);
                }
                write(extra, layer);
            }
    }

    /// Fills the outline of a letter.
    void outline(const TextMark& mark, const Glyph& glyph, Colour colour, std::string_view layer) {
        write(filled_glyph(mark, glyph, glyphs_.outline(glyph.face, glyph.index), colour), layer);
    }

    void text_entity(const TextMark& mark, const Words& words, std::string_view layer) {
        constexpr double capitals =
            0.662;  // height of a capital letter of STIX, em: what DXF calls the height of a text
        const Glyph &first = words.first, &last = words.last;
        const double end_x = last.origin.x + last.size * width_of(glyphs_.outline(last.face, last.index));
        const Spot from = upwards(turned(mark, first.origin)), to = upwards(turned(mark, {end_x, first.origin.y}));
        const bool fits = first.origin.x < last.origin.x;  // a single letter keeps its own shape
        begin("TEXT", layer);
        colour(words.colour);
        out_.put(100, "AcDbText");
        out_.put_point(10, from);
        out_.put(40, capitals * first.size);
        out_.put(1, dxf_text(words.text));
        if (mark.angle != 0) out_.put(50, degrees(mark.angle));
        out_.put(7, DxfDocument::text_style(first.coded ? std::uint8_t{0} : first.face));
        if (fits) {
            constexpr int fitted = 5;
            out_.put(72, fitted);
            out_.put_point(11, to);
        }
        out_.put(100, "AcDbText");
        end();
    }

    const Page& page_;
    const Glyphs& glyphs_;
    DxfDocument document_;
    DxfPairs& out_;
    bool on_dark_paper_;
    std::vector<Group> groups_;  // open
};

}  // namespace

std::vector<std::string> to_dxf(std::span<const Page> pages, const Glyphs& glyphs) {
    std::vector<std::string> texts;
    for (const Page& page : pages) texts.push_back(DxfSheet(page, glyphs).write());
    return texts;
}

}  // namespace kinegraph::render
