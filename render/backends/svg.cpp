// A Page as SVG 1.1, a tree built with pugixml, one item a line. Each outline stands once, in <defs>, under an id that names
// face, glyph and size, so that sheets put into one HTML page do not mix theirs up; live text stands in <text>, with the faces it
// needs in a style sheet. Decides nothing about the drawing.
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <pugixml.hpp>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/assert.hpp"
#include "engine/json_text.hpp"
#include "render/backends/backends.hpp"
#include "render/backends/live_text.hpp"
#include "render/text/utf8.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {
namespace {

/// Two digits before `first`: half as many divisions.
void put_pair(char*& first, std::uint64_t below_hundred) {
    static constexpr auto pairs = [] {
        std::array<char, 200> text{};
        for (std::size_t i = 0; i < 100; ++i) {
            text.at(2 * i) = static_cast<char>('0' + i / 10);
            text.at(2 * i + 1) = static_cast<char>('0' + i % 10);
        }
        return text;
    }();
    *--first = pairs[2 * below_hundred + 1];
    *--first = pairs[2 * below_hundred];
}

/// A coordinate with at most `digits` decimals, without trailing zeros: the shortest decimal of the snapped number.
void append_number(std::string& out, double value, int digits) {
    static constexpr double scales[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};
    const double scaled = value * scales[digits];
    KG_ASSERT(std::abs(scaled) < 9e15, "a coordinate of a page is finite and of a size that paper has");
    const auto rest = static_cast<std::int64_t>(scaled + (scaled < 0 ? -0.5 : 0.5));
    if (rest == 0) {
        out += '0';
        return;
    }
    // Built from its end, and added as one.
    char text[32];
    char* first = text + sizeof text;
    const bool negative = rest < 0;
    auto left = static_cast<std::uint64_t>(negative ? -rest : rest);
    if (digits >= 4 && left % 10000 == 0) {
        left /= 10000;
        digits -= 4;
    }
    while (digits > 0 && left % 10 == 0) {
        left /= 10;
        --digits;
    }
    for (; digits > 1; digits -= 2, left /= 100) put_pair(first, left % 100);
    if (digits > 0) {
        *--first = static_cast<char>('0' + left % 10);
        left /= 10;
    }
    if (first != text + sizeof text) *--first = '.';
    for (; left >= 100; left /= 100) put_pair(first, left % 100);
    if (left >= 10)
        put_pair(first, left);
    else
        *--first = static_cast<char>('0' + left);
    if (negative) *--first = '-';
    out.append(first, text + sizeof text);
}

constexpr int drawn_digits = 8;    // of what is measured
constexpr int outline_digits = 4;  // of type: 0.1 µm
constexpr double outline_units = 1e4;
constexpr int font_digits = 6;  // of sizes

class Writer {
public:
    /// `type`: that of live text; null: words are outlines.
    Writer(const Page& page, const Glyphs& fonts, GlyphPaths& outlines, const EmbeddedType* type = nullptr)
        : page_(page), fonts_(fonts), outlines_(outlines), type_(type) {}

    std::string write() {
        pugi::xml_node declaration = document_.append_child(pugi::node_declaration);
        set(declaration, "version", "1.0");
        set(declaration, "encoding", "UTF-8");
        at_ = document_.append_child("svg");
        set(at_, "xmlns", "http://www.w3.org/2000/svg");
        set(at_, "xmlns:xlink", "http://www.w3.org/1999/xlink");
        set(at_, "version", "1.1");
        length(at_, "width", page_.width, "mm");
        length(at_, "height", page_.height, "mm");
        text_ = "0 0 ";
        put(page_.width);
        text_ += ' ';
        put(page_.height);
        set(at_, "viewBox", text_.c_str());
        const std::string language = well_formed(page_.language);
        set(at_, "lang", language.c_str());
        set(at_, "xml:lang", language.c_str());
        if (type_ != nullptr) {
            set(at_, "font-family", (type_->family + ", STIXGeneral, serif").c_str());
            set(at_, "text-rendering", "geometricPrecision");
        }
        title(at_, page_.title);
        defs_ = at_.append_child("defs");
        if (type_ != nullptr && !type_->rules.empty())
            defs_.append_child("style").append_child(pugi::node_pcdata).set_value(type_->rules.c_str());
        pugi::xml_node paper = at_.append_child("rect");
        set(paper, "class", "paper");
        length(paper, "width", page_.width);
        length(paper, "height", page_.height);
        colour(paper, "fill", page_.paper);
        for (std::size_t i = 0; i < page_.marks.size();) i += write_from(i);
        KG_ASSERT(statements_.empty(), "groups of a page are closed");
        if (!defs_.first_child()) defs_.parent().remove_child(defs_);
        Sink sink;
        document_.save(sink, " ", pugi::format_indent, pugi::encoding_utf8);
        return std::move(sink.out);
    }

private:
    struct Sink : pugi::xml_writer {
        std::string out;
        void write(const void* data, std::size_t size) override { out.append(static_cast<const char*>(data), size); }
    };

    static void set(pugi::xml_node node, const char* name, const char* value) { node.append_attribute(name).set_value(value); }

    void put(double value, int digits = drawn_digits) { append_number(text_, value, digits); }
    void put(char command, Spot a, int digits = drawn_digits) {
        text_ += command;
        put(a.x, digits);
        text_ += ' ';
        put(a.y, digits);
    }
    void length(pugi::xml_node node, const char* name, double value, const char* unit = "", int digits = drawn_digits) {
        text_.clear();
        put(value, digits);
        text_ += unit;
        set(node, name, text_.c_str());
    }
    static void colour(pugi::xml_node node, const char* name, Colour c) {
        static constexpr char hex[] = "0123456789abcdef";
        const char text[] = {
            '#', hex[c.red >> 4], hex[c.red & 15], hex[c.green >> 4], hex[c.green & 15], hex[c.blue >> 4], hex[c.blue & 15],
            '\0'};
        set(node, name, text);
    }
    static void title(pugi::xml_node node, const std::string& words) {
        if (!words.empty()) node.append_child("title").append_child(pugi::node_pcdata).set_value(well_formed(words).c_str());
    }

    /// One or two 'A's, so that no arc is longer than half a turn and none is in doubt.
    void arc(const ArcTo& a, bool& begun, Spot& pen) {
        const auto on = [&a](double angle) {
            return Spot{a.centre.x + a.radius * std::cos(angle), a.centre.y + a.radius * std::sin(angle)};
        };
        const double turn = 2 * std::numbers::pi;
        double sweep = a.to - a.from;
        if (std::abs(sweep) > turn) sweep = std::copysign(turn, sweep);
        const Spot start = on(a.from);
        constexpr double joined = 1.5e-8;  // mm: the page is snapped to 1e-8
        if (!begun) {
            put('M', start);
        } else if (std::abs(pen.x - start.x) > joined || std::abs(pen.y - start.y) > joined) {
            put('L', start);
        }
        begun = true;
        const int halves = std::abs(sweep) > 3 ? 2 : 1;
        for (int i = 1; i <= halves; ++i) {
            pen = on(a.from + sweep * i / halves);
            text_ += 'A';
            put(a.radius);
            text_ += ' ';
            put(a.radius);
            text_ += sweep < 0 ? " 0 0 0 " : " 0 0 1 ";
            put(pen.x);
            text_ += ' ';
            put(pen.y);
        }
    }

    /// Of the solution, that draws it; left out where it is that of the group round it.
    void statement(pugi::xml_node node, StatementIndex index, bool repeated) {
        if (index == none || (!repeated && !statements_.empty() && statements_.back() == index)) return;
        set(node, "data-statement", std::to_string(index.number()).c_str());
    }

    /// `["with","F3.0...1","F3.0...1"]`; what the page goes by that moves it.
    void holds(pugi::xml_node node, const Holds& holds) {
        if (!page_.tells_holds || holds.form == Holds::Form::nothing) return;
        std::string on = "[" + json_text(name_of(holds.form));
        for (const std::string& name : holds.on) on += "," + json_text(name);
        set(node, "data-on", well_formed(on + "]").c_str());
        if (holds.beyond != 0) set(node, "data-beyond", shortest(holds.beyond).c_str());
        if (holds.unit != 0) set(node, "data-number", shortest(holds.unit).c_str());
    }

    void write(const Path& path) {
        text_.clear();
        Spot pen, first;
        bool begun = false;
        for (const Segment& segment : path.segments) {
            if (const auto* m = std::get_if<MoveTo>(&segment)) {
                put('M', pen = first = m->to);
                begun = true;
            } else if (const auto* l = std::get_if<LineTo>(&segment)) {
                KG_ASSERT(begun, "a path begins with a move or an arc");
                put('L', pen = l->to);
            } else if (const auto* c = std::get_if<CurveTo>(&segment)) {
                KG_ASSERT(begun, "a path begins with a move or an arc");
                put('C', c->control_1);
                put(' ', c->control_2);
                put(' ', pen = c->to);
            } else if (const auto* a = std::get_if<ArcTo>(&segment)) {
                if (!begun) {
                    first = {a->centre.x + a->radius * std::cos(a->from), a->centre.y + a->radius * std::sin(a->from)};
                }
                arc(*a, begun, pen);
            } else if (begun) {
                text_ += 'Z';
                pen = first;
            }
        }
        pugi::xml_node node = at_.append_child("path");
        set(node, "d", text_.c_str());
        if (path.filled) {
            colour(node, "fill", path.fill);
        } else {
            set(node, "fill", "none");
        }
        statement(node, path.statement, false);
        holds(node, path.holds);
        if (!path.stroked) return;
        colour(node, "stroke", path.pen.colour);
        length(node, "stroke-width", path.pen.width);
        if (!path.pen.dashes.empty()) {
            text_.clear();
            for (const double dash : path.pen.dashes) {
                if (!text_.empty()) text_ += ' ';
                put(dash);
            }
            set(node, "stroke-dasharray", text_.c_str());
        }
        if (path.pen.round_ends) {
            set(node, "stroke-linecap", "round");
        }
        if (has_round_corners(path)) set(node, "stroke-linejoin", "round");
    }

    void write(const Axis& axis) {
        pugi::xml_node node = at_.append_child("line");
        set(node, "class", "axis");
        length(node, "x1", axis.tail.x);
        length(node, "y1", axis.tail.y);
        length(node, "x2", axis.tip.x);
        length(node, "y2", axis.tip.y);
        set(node, "stroke", "none");
    }

    /// The next mark, or of live text the next line; how many marks it was.
    std::size_t write_from(std::size_t i) {
        if (type_ != nullptr && std::holds_alternative<TextMark>(page_.marks[i])) {
            const LiveLine line = live_line(std::span(page_.marks).subspan(i));
            write(line);
            return line.marks.size();
        }
        std::visit([this](const auto& m) { write(m); }, page_.marks[i]);
        return 1;
    }

    /// The group of a text: what it says, its colour and how it is turned.
    pugi::xml_node group_of(const TextMark& mark) {
        pugi::xml_node node = at_.append_child("g");
        if (!mark.cls.empty()) set(node, "class", well_formed(mark.cls).c_str());
        set(node, "aria-label", well_formed(mark.words).c_str());
        if (type_ == nullptr) set(node, "role", "img");
        colour(node, "fill", mark.colour);
        if (mark.angle != 0) {
            text_ = "rotate(";
            put(mark.angle * 180 / std::numbers::pi);
            text_ += ' ';
            put(mark.pivot.x);
            text_ += ' ';
            put(mark.pivot.y);
            text_ += ')';
            set(node, "transform", text_.c_str());
        }
        statement(node, mark.statement, true);
        holds(node, mark.holds);
        return node;
    }

    pugi::xml_node use(const Glyph& glyph) {
        pugi::xml_node node = at_.append_child("use");
        set(node, "xlink:href", reference(glyph).c_str());
        length(node, "x", glyph.origin.x, "", outline_digits);
        length(node, "y", glyph.origin.y, "", outline_digits);
        return node;
    }

    void write(const TextMark& mark) {
        const pugi::xml_node outside = at_;
        at_ = group_of(mark);
        for (const Glyph& glyph : mark.glyphs) use(glyph);
        for (const Path& path : mark.extras) write(path);
        at_ = outside;
    }

    void write(const LiveLine& line) {
        const pugi::xml_node outside = at_;
        at_ = group_of(*line.first);
        pugi::xml_node text = at_.append_child("text");
        set(text, "xml:space", "preserve");
        const Glyph* last = nullptr;
        for (const LiveRun& run : line.runs) {
            if (run.kind == LiveRun::Kind::set) {
                write(run, line.first->colour, text, last);
            } else {
                // Blanks stand where letters leave them room; what is read and not seen has no colour.
                const bool hidden = run.kind != LiveRun::Kind::blank;
                pugi::xml_node node = hidden ? child(text) : text;
                if (hidden) set(node, "fill", "none");
                node.append_child(pugi::node_pcdata).set_value(run.text.c_str());
                if (run.kind != LiveRun::Kind::coded) continue;
                for (const Letter& letter : run.letters) colour(use(letter.glyph), "fill", run.colour);
            }
        }
        text.append_child(pugi::node_pcdata);
        for (const TextMark* mark : line.marks)
            for (const Path& path : mark->extras) write(path);
        at_ = outside;
    }

    /// No white space between what is said: pugixml indents what follows an element, unless it is text.
    static pugi::xml_node child(pugi::xml_node text) {
        text.append_child(pugi::node_pcdata);
        return text.append_child("tspan");
    }

    /// One stretch of letters at its place; `last`: the first letter of the stretch before it.
    void write(const LiveRun& run, Colour ink, pugi::xml_node text, const Glyph*& last) {
        const Glyph& first = run.letters.front().glyph;
        pugi::xml_node node = child(text);
        length(node, "x", first.origin.x, "", outline_digits);
        if (last == nullptr || last->origin.y != first.origin.y) length(node, "y", first.origin.y, "", outline_digits);
        if (last == nullptr) {
            base_size_ = first.size;
            length(text, "font-size", first.size, "", font_digits);
        } else if (first.size != base_size_) {
            length(node, "font-size", first.size, "", font_digits);
        }
        if (first.face % 2 == 1) set(node, "font-style", "italic");
        if (first.face >= 2) set(node, "font-weight", "bold");
        if (!(run.colour == ink)) colour(node, "fill", run.colour);
        node.append_child(pugi::node_pcdata).set_value(run.text.c_str());
        last = &first;
    }

    void write(const GroupBegin& group) {
        at_ = at_.append_child("g");
        if (!group.cls.empty()) set(at_, "class", well_formed(group.cls).c_str());
        if (!group.id.empty()) set(at_, "id", well_formed(group.id).c_str());
        for (const auto& [name, value] : group.attributes) set(at_, name.c_str(), well_formed(value).c_str());
        statement(at_, group.statement, true);
        holds(at_, group.holds);
        statements_.push_back(group.statement != none || statements_.empty() ? group.statement : statements_.back());
        title(at_, group.title);
    }

    void write(const GroupEnd&) {
        KG_ASSERT(!statements_.empty(), "a group that ends has begun");
        statements_.pop_back();
        at_ = at_.parent();
    }

    /// "#gi66-12": face, glyph, size in points.
    const std::string& reference(const Glyph& glyph) {
        const auto micropoints = static_cast<std::uint64_t>(std::llround(glyph.size * 72 / 25.4 * 1e6));
        KG_ASSERT(glyph.face < 4 && glyph.index < (1U << 20) && micropoints < (1ULL << 40),
                  "a glyph of our faces in a size for paper");
        const std::uint64_t key = (micropoints << 22) | (static_cast<std::uint64_t>(glyph.index) << 2) | glyph.face;
        const auto [entry, is_new] = references_.try_emplace(key);
        if (!is_new) return entry->second;
        text_ = "#g";
        text_ += "ribz"[glyph.face];
        text_ += std::to_string(glyph.index);
        text_ += '-';
        append_number(text_, static_cast<double>(micropoints) * 1e-6, 6);
        entry->second = text_;
        pugi::xml_node node = defs_.append_child("path");
        set(node, "id", text_.c_str() + 1);
        std::string& outline = outlines_.of(key);
        if (outline.empty()) outline = path_data(glyph);
        set(node, "d", outline.c_str());
        return entry->second;
    }

    const std::string& path_data(const Glyph& glyph) {
        text_.clear();
        // Relative commands, a third shorter. The pen stands on snapped places, so nothing adds up.
        const auto snapped = [&glyph](double em) { return std::round(em * glyph.size * outline_units) / outline_units; };
        const auto at = [&snapped](Spot em) { return Spot{snapped(em.x), snapped(-em.y)}; };
        Spot pen;
        const auto step = [this, &pen](Spot to) {
            if (text_.back() < 'A' && to.x >= pen.x) text_ += ' ';
            put(to.x - pen.x, outline_digits);
            if (to.y >= pen.y) text_ += ' ';
            put(to.y - pen.y, outline_digits);
        };
        for (const Segment& segment : fonts_.outline(glyph.face, glyph.index).segments) {
            if (const auto* m = std::get_if<MoveTo>(&segment)) {
                put('M', pen = at(m->to), outline_digits);
            } else if (const auto* l = std::get_if<LineTo>(&segment)) {
                const Spot to = at(l->to);
                if (to.y == pen.y) {
                    text_ += 'h';
                    put(to.x - pen.x, outline_digits);
                } else if (to.x == pen.x) {
                    text_ += 'v';
                    put(to.y - pen.y, outline_digits);
                } else {
                    text_ += 'l';
                    step(to);
                }
                pen = to;
            } else if (const auto* c = std::get_if<CurveTo>(&segment)) {
                text_ += 'c';
                step(at(c->control_1));
                step(at(c->control_2));
                step(at(c->to));
                pen = at(c->to);
            } else {
                text_ += 'Z';
            }
        }
        return text_;
    }

    const Page& page_;
    const Glyphs& fonts_;
    GlyphPaths& outlines_;
    const EmbeddedType* type_;
    double base_size_ = 0;  // of the live line at hand
    pugi::xml_document document_;
    pugi::xml_node at_, defs_;
    std::vector<StatementIndex> statements_;  // of the open groups, their own or that round them
    std::string text_;                        // of the attribute at hand, one memory for all
    std::unordered_map<std::uint64_t, std::string> references_;
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

std::vector<std::string> to_live_svg(std::span<const Page> pages, const Glyphs& glyphs, const Subsetter& subset) {
    GlyphPaths outlines;
    std::vector<std::string> texts;
    for (const Page& page : pages) {
        const EmbeddedType type = embedded_type(page.marks, glyphs, subset);
        texts.push_back(Writer(page, glyphs, outlines, &type).write());
    }
    return texts;
}

}  // namespace kinegraph::render
