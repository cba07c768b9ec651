// SVG 1.1 backend, one item per line. Each outline is defined once in <defs>, under an id of face, glyph and size, so
// that sheets combined into one HTML page do not conflict. Live text uses <text>, with the fonts it needs in a style
// sheet. No layout is decided here.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "engine/file/json_text.hpp"
#include "engine/number/assert.hpp"
#include "engine/number/functions.hpp"
#include "render/backends/backends.hpp"
#include "render/backends/live_text.hpp"
#include "render/backends/markup.hpp"
#include "render/text/utf8.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {
namespace {

constexpr int drawn_digits = 8;    // decimals of measured coordinates
constexpr int outline_digits = 4;  // decimals of outlines: 0.1 µm
constexpr double outline_units = 1e4;
constexpr int font_digits = 6;  // decimals of font sizes

/// To the nearest integer, halves away from zero, as std::round but without a function call.
std::int64_t whole_units(double units) {
    const auto towards_zero = static_cast<std::int64_t>(units);
    const double rest = units - static_cast<double>(towards_zero);
    return towards_zero + (rest >= 0.5 ? 1 : rest <= -0.5 ? -1 : 0);
}

/// The path data of a glyph's outline at a size, y downwards. Relative commands are a third shorter; the pen stays on
/// integer units, so errors do not accumulate.
class GlyphPath {
public:
    /// Writes to `text`, whose memory is reused.
    GlyphPath(const Outline& outline, double size, Bytes& text) : size_(size), text_(text) {
        text_.clear();
        for (const Segment& segment : outline.segments) {
            if (const auto* m = std::get_if<MoveTo>(&segment)) {
                pen_ = at(m->to);
                text_.put('M');
                put(pen_.x);
                text_.put(' ');
                put(pen_.y);
            } else if (const auto* l = std::get_if<LineTo>(&segment)) {
                line_to(at(l->to));
            } else if (const auto* c = std::get_if<CurveTo>(&segment)) {
                text_.put('c');
                step(at(c->control_1), true);
                step(at(c->control_2), false);
                const Units to = at(c->to);
                step(to, false);
                pen_ = to;
            } else {
                text_.put('Z');
            }
        }
    }

private:
    struct Units {
        std::int64_t x = 0, y = 0;
    };
    Units at(Spot em) const {
        return {whole_units(em.x * size_ * outline_units), whole_units(-em.y * size_ * outline_units)};
    }
    void put(std::int64_t units) { text_.put_decimal<outline_digits>(units); }
    void line_to(Units to) {
        if (to.y == pen_.y) {
            text_.put('h');
            put(to.x - pen_.x);
        } else if (to.x == pen_.x) {
            text_.put('v');
            put(to.y - pen_.y);
        } else {
            text_.put('l');
            step(to, true);
        }
        pen_ = to;
    }
    /// A minus sign separates numbers as a space does; so does the command before the first.
    void step(Units to, bool first) {
        if (!first && to.x >= pen_.x) text_.put(' ');
        put(to.x - pen_.x);
        if (to.y >= pen_.y) text_.put(' ');
        put(to.y - pen_.y);
    }

    double size_;
    Units pen_;
    Bytes& text_;
};

/// Path data and coordinates in attribute values.
struct PathData {
    static void put(Bytes& value, Spot a, char between = ' ') {
        value.put_number<drawn_digits>(a.x);
        value.put(between);
        value.put_number<drawn_digits>(a.y);
    }
    static void put(Bytes& value, char command, Spot a) {
        value.put(command);
        put(value, a);
    }
    /// One or two 'A' commands: each arc is at most half a turn, so that it is unambiguous.
    static void arc(Bytes& value, const ArcTo& a, bool& begun, Spot& pen) {
        const auto on = [&a](double angle) {
            return Spot{a.centre.x + a.radius * nearest::cos(angle), a.centre.y + a.radius * nearest::sin(angle)};
        };
        const double turn = 2 * std::numbers::pi;
        double sweep = a.to - a.from;
        if (std::abs(sweep) > turn) sweep = std::copysign(turn, sweep);
        const Spot start = on(a.from);
        constexpr double joined = 1.5e-8;  // mm; the page is snapped to 1e-8 mm
        if (!begun) {
            put(value, 'M', start);
        } else if (std::abs(pen.x - start.x) > joined || std::abs(pen.y - start.y) > joined) {
            put(value, 'L', start);
        }
        begun = true;
        const int halves = std::abs(sweep) > 3 ? 2 : 1;
        for (int i = 1; i <= halves; ++i) {
            pen = on(a.from + sweep * i / halves);
            put(value, 'A', {a.radius, a.radius});
            value.put(sweep < 0 ? " 0 0 0 " : " 0 0 1 ");
            put(value, pen);
        }
    }
    static void put(Bytes& value, const std::vector<Segment>& segments) {
        Spot pen, first;
        bool begun = false;
        for (const Segment& segment : segments) {
            if (const auto* m = std::get_if<MoveTo>(&segment)) {
                put(value, 'M', pen = first = m->to);
                begun = true;
            } else if (const auto* l = std::get_if<LineTo>(&segment)) {
                KG_ASSERT(begun, "a path begins with a move or an arc");
                put(value, 'L', pen = l->to);
            } else if (const auto* c = std::get_if<CurveTo>(&segment)) {
                KG_ASSERT(begun, "a path begins with a move or an arc");
                put(value, 'C', c->control_1);
                put(value, ' ', c->control_2);
                put(value, ' ', pen = c->to);
            } else if (const auto* a = std::get_if<ArcTo>(&segment)) {
                if (!begun) {
                    first = {a->centre.x + a->radius * nearest::cos(a->from),
                             a->centre.y + a->radius * nearest::sin(a->from)};
                }
                arc(value, *a, begun, pen);
            } else if (begun) {
                value.put('Z');
                pen = first;
            }
        }
    }
};

/// References to outlines of glyphs; each outline is defined once.
class GlyphReferences {
public:
    GlyphReferences(const Glyphs& fonts, GlyphPaths& outlines) : fonts_(fonts), outlines_(outlines) {}

    /// "#gi66-12": face, glyph index, size in points.
    const std::string& to(const Glyph& glyph) {
        const auto micropoints = static_cast<std::uint64_t>(std::llround(glyph.size * 72 / 25.4 * 1e6));
        KG_ASSERT(glyph.face < 4 && glyph.index < (1U << 20) && micropoints < (1ULL << 40),
                  "a glyph of our faces in a size for paper");
        const std::uint64_t key = (micropoints << 22) | (static_cast<std::uint64_t>(glyph.index) << 2) | glyph.face;
        const auto [entry, is_new] = references_.try_emplace(key);
        if (!is_new) return entry->second;
        scratch_.clear();
        scratch_.put("#g");
        scratch_.put("ribz"[glyph.face]);
        scratch_.put_decimal<0>(glyph.index);
        scratch_.put('-');
        scratch_.put_decimal<font_digits>(static_cast<std::int64_t>(micropoints));
        entry->second = scratch_.text();
        std::string& outline = outlines_.of(key);
        if (outline.empty()) {
            GlyphPath(fonts_.outline(glyph.face, glyph.index), glyph.size, scratch_);
            outline = scratch_.text();
        }
        defined_.emplace_back(&entry->second, &outline);
        return entry->second;
    }

    bool empty() const { return defined_.empty(); }
    void define(Markup& defined) const {
        for (const auto& [reference, outline] : defined_) {
            defined.begin("path");
            defined.open_value("id").put(std::string_view(*reference).substr(1));
            defined.close_value();
            defined.open_value("d").put(*outline);
            defined.close_value();
            defined.end();
        }
    }

private:
    const Glyphs& fonts_;
    GlyphPaths& outlines_;
    Bytes scratch_;
    std::unordered_map<std::uint64_t, std::string> references_;
    std::vector<std::pair<const std::string*, const std::string*>>
        defined_;  // references and their outlines, in order of first use
};

class Writer {
public:
    /// `type`: fonts of live text; null: words are drawn as outlines.
    Writer(const Page& page, const Glyphs& fonts, GlyphPaths& outlines, const EmbeddedType* type = nullptr)
        : page_(page), type_(type), glyphs_(fonts, outlines) {}

    std::string write() {
        out_.reserve(about_as_long());
        out_.begin("svg");
        out_.attribute("xmlns", "http://www.w3.org/2000/svg");
        out_.attribute("xmlns:xlink", "http://www.w3.org/1999/xlink");
        out_.attribute("version", "1.1");
        length("width", page_.width, "mm");
        length("height", page_.height, "mm");
        Bytes& box = out_.open_value("viewBox");
        box.put("0 0 ");
        box.put_number<drawn_digits>(page_.width);
        box.put(' ');
        box.put_number<drawn_digits>(page_.height);
        out_.close_value();
        const std::string language = well_formed(page_.language);
        out_.attribute("lang", language);
        out_.attribute("xml:lang", language);
        if (type_ != nullptr) {
            out_.attribute("font-family", type_->family + ", STIXGeneral, serif");
            out_.attribute("text-rendering", "geometricPrecision");
        }
        title(page_.title);
        const std::size_t head = out_.place();
        paper();
        for (std::size_t i = 0; i < page_.marks.size();) i += write_from(i);
        KG_ASSERT(statements_.empty(), "groups of a page are closed");
        out_.end();
        // The definitions precede the page in the file, but are complete only at the end.
        const Markup defined = definitions();
        const std::string_view all = out_.text();
        std::string svg;
        svg.reserve(all.size() + defined.text().size() + 1);
        svg += all.substr(0, head);
        svg += defined.text();
        svg += all.substr(head);
        svg += '\n';
        return svg;
    }

private:
    /// Estimated size in bytes, slightly high.
    std::size_t about_as_long() const {
        constexpr std::size_t of_a_letter = 64, of_a_mark = 200;
        std::size_t letters = 0;
        for (const Mark& mark : page_.marks)
            if (const auto* text = std::get_if<TextMark>(&mark)) letters += text->glyphs.size();
        return of_a_letter * letters + of_a_mark * page_.marks.size();
    }

    Markup definitions() const {
        Markup defined(1);
        const bool has_rules = type_ != nullptr && !type_->rules.empty();
        if (!has_rules && glyphs_.empty()) return defined;
        defined.begin("defs");
        if (has_rules) {
            defined.begin("style");
            defined.words(type_->rules);
            defined.end();
        }
        glyphs_.define(defined);
        defined.end();
        return defined;
    }

    void paper() {
        out_.begin("rect");
        out_.attribute("class", "paper");
        length("width", page_.width);
        length("height", page_.height);
        colour("fill", page_.paper);
        out_.end();
    }

    template <int digits = drawn_digits>
    void length(std::string_view name, double value, std::string_view unit = "") {
        Bytes& text = out_.open_value(name);
        text.put_number<digits>(value);
        text.put(unit);
        out_.close_value();
    }
    void colour(std::string_view name, Colour c) {
        static constexpr char hex[] = "0123456789abcdef";
        const char text[] = {'#',
                             hex[c.red >> 4],
                             hex[c.red & 15],
                             hex[c.green >> 4],
                             hex[c.green & 15],
                             hex[c.blue >> 4],
                             hex[c.blue & 15]};
        out_.open_value(name).put(std::string_view(text, sizeof text));
        out_.close_value();
    }
    void title(const std::string& words) {
        if (words.empty()) return;
        out_.begin("title");
        out_.words(well_formed(words));
        out_.end();
    }

    /// The statement that draws it; omitted if equal to that of the enclosing group.
    void statement(StatementIndex index, bool repeated) {
        if (index == none || (!repeated && !statements_.empty() && statements_.back() == index)) return;
        out_.attribute("data-statement", std::to_string(index.number()));
    }

    /// `["with","F3.0...1","F3.0...1"]`: the binding that the live page uses to move the mark.
    void holds(const Holds& holds) {
        if (!page_.tells_holds || holds.form == Holds::Form::nothing) return;
        std::string on = "[" + json_text(name_of(holds.form));
        for (const std::string& name : holds.on) on += "," + json_text(name);
        out_.attribute("data-on", well_formed(on + "]"));
        if (holds.beyond != 0) out_.attribute("data-beyond", shortest(holds.beyond));
        if (holds.unit != 0) out_.attribute("data-number", shortest(holds.unit));
    }

    void write(const Path& path) {
        out_.begin("path");
        PathData::put(out_.open_value("d"), path.segments);
        out_.close_value();
        if (path.filled)
            colour("fill", path.fill);
        else
            out_.attribute("fill", "none");
        statement(path.statement, false);
        holds(path.holds);
        if (path.stroked) stroke_of(path);
        out_.end();
    }
    void stroke_of(const Path& path) {
        colour("stroke", path.pen.colour);
        length("stroke-width", path.pen.width);
        if (!path.pen.dashes.empty()) {
            Bytes& value = out_.open_value("stroke-dasharray");
            bool first = true;
            for (const double dash : path.pen.dashes) {
                if (!std::exchange(first, false)) value.put(' ');
                value.put_number<drawn_digits>(dash);
            }
            out_.close_value();
        }
        if (path.pen.round_ends) out_.attribute("stroke-linecap", "round");
        if (has_round_corners(path)) out_.attribute("stroke-linejoin", "round");
    }

    void write(const Axis& axis) {
        out_.begin("line");
        out_.attribute("class", "axis");
        length("x1", axis.tail.x);
        length("y1", axis.tail.y);
        length("x2", axis.tip.x);
        length("y2", axis.tip.y);
        out_.attribute("stroke", "none");
        out_.end();
    }

    /// Writes the next mark, or with live text the next line. Returns the number of marks.
    std::size_t write_from(std::size_t i) {
        if (type_ != nullptr && std::holds_alternative<TextMark>(page_.marks[i])) {
            const LiveLine line = live_line(std::span(page_.marks).subspan(i));
            write(line);
            return line.marks.size();
        }
        std::visit([this](const auto& m) { write(m); }, page_.marks[i]);
        return 1;
    }

    /// Begins the group of a text: its words, colour and rotation.
    void begin_group_of(const TextMark& mark) {
        out_.begin("g");
        if (!mark.cls.empty()) out_.attribute("class", well_formed(mark.cls));
        out_.attribute("aria-label", well_formed(mark.words));
        if (type_ == nullptr) out_.attribute("role", "img");
        colour("fill", mark.colour);
        if (mark.angle != 0) {
            Bytes& value = out_.open_value("transform");
            value.put("rotate(");
            value.put_number<drawn_digits>(mark.angle * 180 / std::numbers::pi);
            value.put(' ');
            PathData::put(value, mark.pivot);
            value.put(')');
            out_.close_value();
        }
        statement(mark.statement, true);
        holds(mark.holds);
    }

    void begin_use(const Glyph& glyph) {
        out_.begin("use");
        out_.open_value("xlink:href").put(glyphs_.to(glyph));
        out_.close_value();
        length<outline_digits>("x", glyph.origin.x);
        length<outline_digits>("y", glyph.origin.y);
    }

    void write(const TextMark& mark) {
        begin_group_of(mark);
        for (const Glyph& glyph : mark.glyphs) {
            begin_use(glyph);
            out_.end();
        }
        for (const Path& path : mark.extras) write(path);
        out_.end();
    }

    void write(const LiveLine& line) {
        begin_group_of(*line.first);
        out_.begin("text");
        out_.attribute("xml:space", "preserve");
        const auto first = std::find_if(line.runs.begin(), line.runs.end(),
                                        [](const LiveRun& run) { return run.kind == LiveRun::Kind::set; });
        if (first != line.runs.end()) {
            base_size_ = first->letters.front().glyph.size;
            length<font_digits>("font-size", base_size_);
        }
        const Glyph* last = nullptr;
        for (const LiveRun& run : line.runs) {
            if (run.kind == LiveRun::Kind::set) {
                write(run, line.first->colour, last);
            } else {
                // Spaces go where letters leave room for them; invisible text has no colour.
                const bool hidden = run.kind != LiveRun::Kind::blank;
                if (hidden) {
                    begin_span();
                    out_.attribute("fill", "none");
                }
                out_.words(run.text);
                if (hidden) out_.end();
            }
        }
        out_.words("");
        out_.end();
        for (const LiveRun& run : line.runs)
            for (const Letter& letter : run.kind == LiveRun::Kind::coded ? run.letters : std::vector<Letter>{}) {
                begin_use(letter.glyph);
                colour("fill", run.colour);
                out_.end();
            }
        for (const TextMark* mark : line.marks)
            for (const Path& path : mark->extras) write(path);
        out_.end();
    }

    /// No white space inside the text.
    void begin_span() {
        out_.words("");
        out_.begin("tspan");
    }

    /// One run of letters at its position. `last`: the first letter of the previous run.
    void write(const LiveRun& run, Colour ink, const Glyph*& last) {
        const Glyph& first = run.letters.front().glyph;
        begin_span();
        length<outline_digits>("x", first.origin.x);
        if (last == nullptr || last->origin.y != first.origin.y) length<outline_digits>("y", first.origin.y);
        if (first.size != base_size_) length<font_digits>("font-size", first.size);
        if (first.face % 2 == 1) out_.attribute("font-style", "italic");
        if (first.face >= 2) out_.attribute("font-weight", "bold");
        if (!(run.colour == ink)) colour("fill", run.colour);
        out_.words(run.text);
        out_.end();
        last = &first;
    }

    void write(const GroupBegin& group) {
        out_.begin("g");
        if (!group.cls.empty()) out_.attribute("class", well_formed(group.cls));
        if (!group.id.empty()) out_.attribute("id", well_formed(group.id.text()));
        for (const auto& [name, value] : group.attributes) out_.attribute(name, well_formed(value));
        statement(group.statement, true);
        holds(group.holds);
        statements_.push_back(group.statement != none || statements_.empty() ? group.statement : statements_.back());
        title(group.title);
    }

    void write(const GroupEnd&) {
        KG_ASSERT(!statements_.empty(), "a group that ends has begun");
        statements_.pop_back();
        out_.end();
    }

    const Page& page_;
    const EmbeddedType* type_;
    double base_size_ = 0;  // of the current live line
    Markup out_;
    std::vector<StatementIndex> statements_;  // of the open groups, their own or inherited
    GlyphReferences glyphs_;
};

}  // namespace

void GlyphPaths::keep_few() {
    constexpr std::size_t many = 4096;
    if (paths_.size() > many) paths_.clear();
}

std::string to_svg(const Page& page, const Fonts& fonts) {
    GlyphPaths outlines;
    return Writer(page, fonts, outlines).write();
}

std::vector<std::string> to_svg(std::span<const Page> pages, const Fonts& fonts, GlyphPaths& known) {
    std::vector<std::string> texts;
    for (const Page& page : pages) {
        known.keep_few();
        texts.push_back(Writer(page, fonts, known).write());
    }
    return texts;
}

std::vector<std::string> to_svg(std::span<const Page> pages, const Fonts& fonts) {
    GlyphPaths outlines;
    return to_svg(pages, fonts, outlines);
}

namespace {

/// `type_of`: of a page.
template <class TypeOf>
std::vector<std::string> to_svg_with_type(std::span<const Page> pages, const Glyphs& glyphs, TypeOf type_of) {
    GlyphPaths outlines;
    std::vector<std::string> texts;
    for (const Page& page : pages) {
        const EmbeddedType type = type_of(page);
        texts.push_back(Writer(page, glyphs, outlines, &type).write());
    }
    return texts;
}

}  // namespace

std::vector<std::string> to_live_svg(std::span<const Page> pages, const Glyphs& glyphs) {
    return to_svg_with_type(pages, glyphs, [&](const Page& page) { return embedded_type(page.marks, glyphs); });
}
std::vector<std::string> to_office_svg(std::span<const Page> pages, const Glyphs& glyphs) {
    return to_svg_with_type(pages, glyphs, [](const Page&) { return EmbeddedType{"Times New Roman", {}}; });
}

}  // namespace kinegraph::render
