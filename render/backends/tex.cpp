// TikZ backend, for pdflatex: colours and line kinds as styles at the top, the named points of each picture before its
// strokes. TeX sets the words in its own fonts, and each line has the width that it has on our page. No layout is
// decided here.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/number/functions.hpp"
#include "render/backends/backends.hpp"
#include "render/backends/live_text.hpp"
#include "render/backends/overlays.hpp"
#include "render/backends/tex_words.hpp"
#include "render/text/utf8.hpp"

namespace kinegraph::render {
namespace {

constexpr int digits = 4;                     // decimals of mm and degrees: 0.1 µm
constexpr double blank = 0.25;                // word space, em
constexpr double farthest_coordinate = 4000;  // mm; TeX's longest length is 5.7 m
constexpr double longest_text = 1500;  // mm, of a text, and beyond either side of the page: TikZ adds such lengths
constexpr double largest_arc = 500;    // mm; TikZ's sines are accurate to five digits

std::string number(double value, int decimals = digits) {
    double power = 1;
    for (int i = 0; i < decimals; ++i) power *= 10;
    double rounded = std::round(value * power) / power;
    if (rounded == 0) rounded = 0;  // no −0
    char text[64];
    std::string written(text, std::to_chars(text, text + sizeof text, rounded, std::chars_format::fixed, decimals).ptr);
    if (written.find('.') != std::string::npos) {
        written.erase(written.find_last_not_of('0') + 1);
        if (written.ends_with('.')) written.pop_back();
    }
    return written;
}

double within_reach(double value) { return std::clamp(value, -farthest_coordinate, farthest_coordinate); }

/// Any text as a comment of one line.
std::string comment(std::string_view words) {
    std::string text = well_formed(words);
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }, ' ');
    return text;
}

/// "A", "B", … "Z", "AA" …
std::string letters_for(std::size_t index) {
    std::string name;
    for (++index; index > 0; index = (index - 1) / 26)
        name.insert(name.begin(), static_cast<char>('A' + (index - 1) % 26));
    return name;
}

/// Named colours and line kinds of a document, in order of first use.
class Styles {
public:
    std::string colour(Colour c) {
        const std::uint32_t key = (std::uint32_t{c.red} << 16) | (std::uint32_t{c.green} << 8) | c.blue;
        const auto [entry, is_new] = colours_.try_emplace(key);
        if (is_new) {
            entry->second = "kg" + letters_for(colours_.size() - 1);
            definitions_ += "\\definecolor{" + entry->second + "}{RGB}{" + std::to_string(c.red) + "," +
                            std::to_string(c.green) + "," + std::to_string(c.blue) + "}\n";
        }
        return entry->second;
    }

    /// A kind of line: its width, dashes and ends.
    std::string line(const Path& path) {
        std::string options = "line width=" + number(path.pen.width) + "mm";
        for (std::size_t i = 0; i + 1 < path.pen.dashes.size(); i += 2)
            options += (i == 0 ? ", dash pattern=on " : " on ") + number(path.pen.dashes[i]) + "mm off " +
                       number(path.pen.dashes[i + 1]) + "mm";
        if (path.pen.round_ends) options += ", line cap=round";
        if (has_round_corners(path)) options += ", line join=round";
        const auto [entry, is_new] = lines_.try_emplace(options);
        if (is_new) {
            const std::size_t parts = path.pen.dashes.size();
            entry->second = std::string("kg ") +
                            (parts == 0   ? "full"
                             : parts == 2 ? "dashed"
                                          : "chain") +
                            " " + letters_for(lines_.size() - 1);
            definitions_ += "\\tikzset{" + entry->second + "/.style={" + options + "}}\n";
        }
        return entry->second;
    }

    const std::string& definitions() const { return definitions_; }

private:
    std::map<std::uint32_t, std::string> colours_;
    std::map<std::string, std::string> lines_;
    std::string definitions_;
};

/// Named points: joints, centres and ends of vectors.
class NamedPoints {
public:
    explicit NamedPoints(const std::vector<Mark>& marks) {
        std::vector<const GroupBegin*> groups;
        for (const Mark& mark : marks) {
            if (const auto* group = std::get_if<GroupBegin>(&mark)) {
                groups.push_back(group);
            } else if (std::holds_alternative<GroupEnd>(mark)) {
                groups.pop_back();
            } else if (groups.empty() || groups.back()->id.empty()) {
                continue;
            } else if (const auto* axis = std::get_if<Axis>(&mark)) {
                add(axis->tail, groups.back()->id.text() + "-tail");
                add(axis->tip, groups.back()->id.text() + "-tip");
            } else if (const auto* path = std::get_if<Path>(&mark)) {
                const bool marked = groups.back()->cls == "joint" || groups.back()->cls == "centre";
                if (const ArcTo* circle = marked ? whole_circle(*path) : nullptr)
                    add(circle->centre, groups.back()->id.text());
            }
        }
    }

    /// The arc of a path that is a full circle; else null.
    static const ArcTo* whole_circle(const Path& path) {
        const ArcTo* found = nullptr;
        for (const Segment& segment : path.segments) {
            const auto* arc = std::get_if<ArcTo>(&segment);
            if (arc == nullptr && !std::holds_alternative<MoveTo>(segment) && !std::holds_alternative<Close>(segment))
                return nullptr;
            if (arc != nullptr && std::exchange(found, arc) != nullptr) return nullptr;
        }
        const bool whole = found != nullptr && std::abs(found->to - found->from) > 2 * std::numbers::pi - 1e-9;
        return whole ? found : nullptr;
    }

    /// A point in TikZ notation: its name if it has one.
    std::string at(Spot spot) {
        const auto found = names_.find(key(spot));
        if (found == names_.end()) return "(" + number(within_reach(spot.x)) + "," + number(within_reach(spot.y)) + ")";
        found->second.is_used = true;
        return "(" + found->second.name + ")";
    }

    /// The names in use, in drawing order.
    std::string definitions() const {
        std::string text;
        for (const auto& [where, spot] : order_) {
            const Named& named = names_.at(where);
            if (named.is_used)
                text += "\\coordinate (" + named.name + ") at (" + number(spot.x) + "," + number(spot.y) + ");\n";
        }
        return text;
    }

private:
    using Key = std::pair<std::int64_t, std::int64_t>;
    struct Named {
        std::string name;
        bool is_used = false;
    };

    static Key key(Spot spot) {
        constexpr double grid = 1e6;  // per mm
        return {std::llround(within_reach(spot.x) * grid), std::llround(within_reach(spot.y) * grid)};
    }

    /// The first name of a point wins.
    void add(Spot spot, std::string name) {
        if (std::abs(spot.x) > farthest_coordinate || std::abs(spot.y) > farthest_coordinate) return;
        // An id consists of letters, digits, "-", "." and "_"; TikZ reads a full stop as an anchor.
        std::replace(name.begin(), name.end(), '.', '-');
        if (names_.try_emplace(key(spot), Named{std::move(name)}).second) order_.emplace_back(key(spot), spot);
    }

    std::map<Key, Named> names_;
    std::vector<std::pair<Key, Spot>> order_;
};

/// Widths of the letters in a document, by face. Kerning almost only moves letters together, so the largest observed
/// advance to a next letter is the width.
class LetterWidths {
public:
    void take(const LiveRun& run, const Glyphs& glyphs) {
        for (std::size_t i = 0; i < run.letters.size(); ++i) {
            const auto& [glyph, text] = run.letters[i];
            if (text.size() != 1 || !is_set_as_text(text.front()) || glyph.size <= 0) continue;
            Width& width = widths_[glyph.face][text.front()];
            if (i + 1 < run.letters.size()) {
                const double step = run.letters[i + 1].glyph.origin.x - glyph.origin.x;
                width.step = std::max(width.step, std::lround(1000 * step / glyph.size));
            } else if (width.step == 0) {
                width.guess = std::lround(1000 * width_of(glyphs.outline(glyph.face, glyph.index)));
            }
        }
    }

    std::string definitions() const {
        return "% How wide the letters are, thousandths of their size.\n" + definition("\\kgroman", Face::regular) +
               definition("\\kgitalics", Face::italic) + definition("\\kgbolds", Face::bold);
    }

private:
    struct Width {
        long step = 0;   // advance to a next letter, thousandths of an em; 0: not observed
        long guess = 0;  // estimated from its ink
    };

    static bool is_set_as_text(char c) {
        constexpr std::string_view signs = "()[]+,-./:;=!?*@";
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               signs.find(c) != std::string_view::npos;
    }

    std::string definition(const std::string& name, Face face) const {
        std::string text = "\\def" + name + "{";
        if (const auto found = widths_.find(static_cast<std::uint8_t>(face)); found != widths_.end())
            for (const auto& [letter, width] : found->second)
                text += letter + std::to_string(width.step > 0 ? width.step : width.guess) + " ";
        return text + "}\n";
    }

    std::map<std::uint8_t, std::map<char, Width>> widths_;
};

Spot on_arc(const ArcTo& arc, double angle) {
    return arc.centre + arc.radius * Spot{nearest::cos(angle), nearest::sin(angle)};
}

class TikzPicture {
public:
    TikzPicture(const Page& page, const Glyphs& glyphs, Styles& styles, LetterWidths& widths)
        : page_(page), glyphs_(glyphs), styles_(styles), widths_(widths), points_(page.marks) {}

    std::string write() {
        const std::string width = number(page_.width), height = number(page_.height);
        std::string head = "\\kgbegin{" + width + "}{" + height + "}%\n\\begin{tikzpicture}[kg]\n";
        if (!page_.title.empty()) head = "% " + comment(page_.title) + "\n" + head;
        return head + lines(page_.marks) + "\\end{tikzpicture}%\n\\kgend\n";
    }

    /// What stands in the picture, a command or a comment on each line.
    std::string lines(std::span<const Mark> marks) {
        const std::string paper = "(0,0) rectangle (" + number(page_.width) + "," + number(page_.height) + ");\n";
        std::string head = "\\useasboundingbox " + paper;
        if (!(page_.paper == Colour{255, 255, 255})) head += "\\fill[" + styles_.colour(page_.paper) + "] " + paper;
        for (std::size_t i = 0; i < marks.size(); ++i) {
            if (const auto* path = std::get_if<Path>(&marks[i])) {
                write(*path);
            } else if (const auto* group = std::get_if<GroupBegin>(&marks[i])) {
                const std::string name = group->title.empty() ? group->id.text() : group->title;
                if (!name.empty()) text_ += "% " + group->cls + (group->cls.empty() ? "" : ": ") + comment(name) + "\n";
            } else if (std::holds_alternative<TextMark>(marks[i])) {
                const LiveLine line = live_line(marks.subspan(i));
                write(line);
                i += line.marks.size() - 1;
            }
        }
        return head + points_.definitions() + text_;
    }

private:
    void write(const Path& path) {
        const std::string course = course_of(path);
        if (course.empty() || (!path.filled && !path.stroked)) return;
        std::string options;
        if (path.filled) options = "fill=" + styles_.colour(path.fill);
        if (path.stroked)
            options +=
                (path.filled ? ", draw=" : "draw=") + styles_.colour(path.pen.colour) + ", " + styles_.line(path);
        text_ += "\\path[" + options + "] " + course + ";\n";
    }

    /// The path as TikZ operations.
    std::string course_of(const Path& path) {
        if (const ArcTo* circle = NamedPoints::whole_circle(path); circle != nullptr && circle->radius < largest_arc)
            return points_.at(circle->centre) + " circle[radius=" + number(circle->radius) + "]";
        std::string course;
        bool begun = false;
        Spot pen;
        const auto go = [&](Spot to, const char* how) {
            course += begun ? how : "";
            course += points_.at(to);
            begun = true;
            pen = to;
        };
        for (const Segment& segment : path.segments) {
            if (const auto* m = std::get_if<MoveTo>(&segment)) {
                if (begun) course += ' ';
                begun = false;
                go(m->to, "");
            } else if (const auto* l = std::get_if<LineTo>(&segment)) {
                go(l->to, " -- ");
            } else if (const auto* c = std::get_if<CurveTo>(&segment)) {
                course += " .. controls " + points_.at(c->control_1) + " and " + points_.at(c->control_2);
                go(c->to, " .. ");
            } else if (const auto* a = std::get_if<ArcTo>(&segment)) {
                const Spot start = on_arc(*a, a->from);
                constexpr double joined = 1e-6;
                if (!begun || length(pen - start) > joined) go(start, " -- ");
                arc(*a, course);
                pen = on_arc(*a, a->to);
            } else if (begun) {
                course += " -- cycle";
            }
        }
        return course;
    }

    /// The arc after its start point. Large arcs become curves computed here.
    void arc(const ArcTo& a, std::string& course) {
        const double whole = 2 * std::numbers::pi;
        const double sweep = std::clamp(a.to - a.from, -whole, whole);
        if (a.radius < largest_arc) {
            const double degrees = 180 / std::numbers::pi;
            course += " arc[start angle=" + number(a.from * degrees) +
                      ", end angle=" + number((a.from + sweep) * degrees) + ", radius=" + number(a.radius) + "]";
            return;
        }
        const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / 0.5)));
        const double step = sweep / parts, reach = 4.0 / 3 * nearest::tan(step / 4);
        for (int i = 0; i < parts; ++i) {
            const double from = a.from + i * step, to = from + step;
            const auto along = [&](double angle) {
                return a.radius * reach * Spot{-nearest::sin(angle), nearest::cos(angle)};
            };
            course += " .. controls " + points_.at(on_arc(a, from) + along(from)) + " and " +
                      points_.at(on_arc(a, to) - along(to)) + " .. " + points_.at(on_arc(a, to));
        }
    }

    void write(const LiveLine& line) {
        const bool coded = std::any_of(line.runs.begin(), line.runs.end(),
                                       [](const LiveRun& run) { return run.kind == LiveRun::Kind::coded; });
        const auto words = tex_words_of(text_of(*line.first), [this](Colour c) { return styles_.colour(c); });
        if (coded || !words) {
            outline(line);
            return;
        }
        std::vector<const Glyph*> glyphs;
        for (const LiveRun& run : line.runs) {
            widths_.take(run, glyphs_);
            for (const Letter& letter : run.letters) glyphs.push_back(&letter.glyph);
        }
        if (glyphs.empty() || words->empty()) return;
        const Glyph& base = **std::max_element(glyphs.begin(), glyphs.end(),
                                               [](const Glyph* a, const Glyph* b) { return a->size < b->size - 1e-9; });
        const std::vector<Span> spans = spans_of(*words, glyphs, base.size);
        if (is_too_long(line, spans, base.origin.y)) {
            outline(line);
            return;
        }
        std::string widths;
        for (const Span& span : spans) widths += (widths.empty() ? "" : " ") + number(span.end - span.begin, 3);
        const Spot at = turned(*line.first, {spans.front().begin, base.origin.y});
        std::string options = "kg text, text=" + styles_.colour(line.first->colour);
        if (line.first->angle != 0) options += ", rotate=" + number(-line.first->angle * 180 / std::numbers::pi);
        text_ += "\\node[" + options + "] at (" + number(within_reach(at.x)) + "," + number(within_reach(at.y)) +
                 ") {\\kgline{" + number(base.size * 72 / 25.4, 2) + "}{" + widths + "}{" + line_of(*words) + "}};\n";
    }

    /// The extent of a word along its line, mm.
    struct Span {
        double begin = 0, end = 0;
    };

    /// Exceeds the largest length of TeX, as a joint's name of a thousand letters may.
    static bool is_too_long(const LiveLine& line, const std::vector<Span>& spans, double y) {
        const Spot from = turned(*line.first, {spans.front().begin, y}),
                   to = turned(*line.first, {spans.back().end, y});
        return std::max({std::abs(from.x), std::abs(from.y), std::abs(to.x), std::abs(to.y), length(to - from)}) >
               longest_text;
    }
    /// Whether ink at this distance from a spot is visible on the page.
    bool is_on_the_page(Spot spot, double near) const {
        return spot.x > -near && spot.y > -near && spot.x < page_.width + near && spot.y < page_.height + near;
    }

    /// Extent of each word; one space lies between two words.
    std::vector<Span> spans_of(const std::vector<TexWord>& words, const std::vector<const Glyph*>& glyphs,
                               double size) const {
        const double space = blank * size;
        std::vector<Span> spans(words.size());
        double last = glyphs.front()->origin.x;
        auto glyph = glyphs.begin();
        for (std::size_t i = 0; i < words.size(); ++i) {
            while (glyph != glyphs.end() && (*glyph)->at < words[i].at) ++glyph;
            double begin = last, end = last;
            bool is_first = true;
            for (; glyph != glyphs.end() && (i + 1 == words.size() || (*glyph)->at < words[i + 1].at); ++glyph) {
                const double x = (*glyph)->origin.x;
                begin = is_first ? x : std::min(begin, x);
                end = std::max(end, x + (*glyph)->size * width_of(glyphs_.outline((*glyph)->face, (*glyph)->index)));
                is_first = false;
            }
            spans[i] = {begin - static_cast<double>(words[i].blanks) * space, end};
            if (i > 0) spans[i - 1].end = spans[i].begin - space;
            last = end + space;
        }
        return spans;
    }

    /// Draws the outlines of text for which TeX has no letters.
    void outline(const LiveLine& line) {
        text_ += "% " + comment(reading_of(line)) + "\n";
        for (const LiveRun& run : line.runs) {
            for (const Letter& letter : run.letters) {
                const Glyph& glyph = letter.glyph;
                if (!is_on_the_page(turned(*line.first, glyph.origin), 2 * glyph.size)) continue;
                write(filled_glyph(*line.first, glyph, glyphs_.outline(glyph.face, glyph.index), run.colour));
            }
        }
        for (const TextMark* mark : line.marks) {
            for (Path extra : mark->extras) {
                for (Segment& segment : extra.segments) {
                    if (auto* m = std::get_if<MoveTo>(&segment)) m->to = turned(*mark, m->to);
                    if (auto* l = std::get_if<LineTo>(&segment)) l->to = turned(*mark, l->to);
                    if (auto* a = std::get_if<ArcTo>(&segment)) a->centre = turned(*mark, a->centre);
                }
                write(extra);
            }
        }
    }

    const Page& page_;
    const Glyphs& glyphs_;
    Styles& styles_;
    LetterWidths& widths_;
    NamedPoints points_;
    std::string text_;
};

/// A document, or a part to be \input: in the body of a document, \@nodocument equals \relax.
constexpr std::string_view alone_head =
    R"(% pdflatex makes a document of this file, a picture on each page; in another document that has
% \usepackage{tikz}, \input gives the pictures alone, in that document's fonts.
\expandafter\ifx\csname @nodocument\endcsname\relax
  \def\kgbegin#1#2{\par\noindent}
  \def\kgend{\par}
  \let\kgfinish\relax
  \def\kgletters#1{}
  \let\kgscripts\relax
\else
  \documentclass{article}
  \usepackage{tikz}
)";
constexpr std::string_view faces_head =
    R"(  % Of each face the one design whose strokes are nearest to those of our PNG, for indices too.
  \DeclareFontShape{OT1}{cmr}{m}{n}{<->cmr8}{}
  \DeclareFontShape{OT1}{cmr}{m}{it}{<->cmti10}{}
  \DeclareFontShape{OT1}{cmr}{bx}{n}{<->cmb10}{}
  \DeclareFontShape{OT1}{cmr}{bx}{it}{<->cmbxti10}{}
  \DeclareFontShape{OML}{cmm}{m}{it}{<->cmmi10}{}
  \DeclareFontShape{OML}{cmm}{b}{it}{<->cmmib10}{}
  \DeclareFontShape{OMS}{cmsy}{m}{n}{<->cmsy10}{}
  \DeclareFontShape{OMS}{cmsy}{b}{n}{<->cmbsy10}{}
)";
constexpr std::string_view alone_head_end =
    R"(  \pdfhorigin=0pt \pdfvorigin=0pt \hoffset=0pt \voffset=0pt
  \def\kgbegin#1#2{\pdfpagewidth=#1mm \pdfpageheight=#2mm \setbox0=\hbox\bgroup\ignorespaces}
  \def\kgend{\egroup\shipout\box0 }
  \def\kgfinish{\end{document}}
  % Letters as wide as \kgroman, \kgitalics and \kgbolds say: white is put to their sides, or taken away.
  \def\kgletters#1{\pdfprependkern=1 \pdfappendkern=1
    \expandafter\ifx\csname kg:\fontname\font\endcsname\relax
      \expandafter\gdef\csname kg:\fontname\font\endcsname{}\pdfnoligatures\font
      \dimen4=\csname f@size\endcsname pt \divide\dimen4 by 1000 \ifx#1\empty\else\expandafter\kgletter#1\kgstop\fi
    \fi}
  \def\kgletter#1#2 {\dimen2=#2\dimen4 \advance\dimen2 by -\fontcharwd\font`#1
    \multiply\dimen2 by 500 \divide\dimen2 by \fontdimen6\font
    \knbccode\font`#1=\dimen2 \knaccode\font`#1=\dimen2 \futurelet\kgtoken\kgnext}
  \def\kgnext{\ifx\kgtoken\kgstop\expandafter\kgdone\else\expandafter\kgletter\fi}
  % How far indices stand below and exponents above the line.
  \def\kgscripts{\scriptspace=.03\kgem \setbox1=\hbox{$ $}\fontdimen16\textfont2=.22\kgem )"
    R"(\fontdimen17\textfont2=.22\kgem
    \fontdimen13\textfont2=.4\kgem \fontdimen14\textfont2=.4\kgem \fontdimen15\textfont2=.4\kgem}
  \begin{document}
\fi
)";
constexpr std::string_view common_head =
    R"(% Lengths are mm, y downwards. \kgline{SIZE}{WIDTHS}{WORDS} sets each word as wide as the list says, what is )"
    R"(short by more than a
% quarter in the middle of its width; where the list ends, as wide as it is. A blank is a quarter of the size.
\tikzset{kg/.style={x=1mm,y=-1mm,line cap=butt,line join=miter,miter limit=4},
  kg text/.style={anchor=base west,inner sep=0pt,outer sep=0pt}}
\ifx\kgem\undefined\newdimen\kgem\fi
\def\kgsize#1{\kgem=#1bp \fontsize{\kgem}{\kgem}\selectfont\kgletters\kgroman\kgscripts\spaceskip=.25\kgem)"
    R"(\relax \mathcode`\*=42
  \def\textbf{\kgface\bfseries\kgbolds}\def\textit{\kgface\itshape\kgitalics}}
\def\kgface#1#2#3{{#1\kgletters#2#3}}
\def\kgline#1#2#3{\hbox{\kgsize{#1}\def\kgwidths{#2 }\kgword\relax#3 \kgstop}}
\def\kgword#1 {\setbox1=\hbox{#1}\ifx\kgwidths\empty\else\expandafter\kgfit\kgwidths\kgstop\fi\box1 )"
    R"(\futurelet\kgtoken\kgmore}
\def\kgmore{\ifx\kgtoken\kgstop\expandafter\kgdone\else\kern.25\kgem\expandafter\kgagain\fi}
\def\kgagain{\kgword\relax}
\def\kgdone\kgstop{}
\def\kgstop{\kgstop}
\def\kgfit#1 #2\kgstop{\def\kgwidths{#2}\dimen0=#1mm
  \ifdim\dimen0>1.33\wd1 \else\ifdim\dimen0>0pt \setbox1=\hbox{\resizebox{\dimen0}{\height}{\box1}}\fi\fi
  \setbox1=\hbox to\dimen0{\hss\box1\hss}}
\def\kgbold#1{\mbox{\boldmath$#1$}}
\def\kgcircled#1{{\dimen0=\csname f@size\endcsname )"
    R"(pt\ooalign{\hfil\raise.14\dimen0\hbox{\fontsize{.62\dimen0}{0pt}\selectfont#1}\hfil
  \crcr\raise.09\dimen0\hbox{\fontsize{.8\dimen0}{0pt}\selectfont$\bigcirc$}}}}
\def\kgscript{\dimen0=\csname f@size\endcsname pt\fontsize{.7\dimen0}{.7\dimen0}\selectfont}
)";

/// Slides: words in a picture have the widths of their lines, letters those of their font.
constexpr std::string_view slides_head =
    R"(% pdflatex or lualatex, run twice, makes slides of this file: a frame for each figure, an overlay for each step.
% For slides of your own take the frames, and what stands before \begin{document} without the class.
\documentclass[aspectratio=169]{beamer}
\usepackage{tikz}
\usefonttheme{serif}
\setbeamertemplate{navigation symbols}{}
\def\kgletters#1{}
\let\kgscripts\relax
)";
constexpr std::string_view slides_head_end =
    R"(% \kgsays{WIDTH}{SIZE}(X,Y){SENTENCES} sets what a step says, \kgslide{PICTURE} a picture as wide as the paper.
\long\def\kgsays#1#2(#3,#4)#5{\node[kg text,anchor=north west,text width=#1mm,align=left] at (#3,#4)
  {\fontsize{#2bp}{1.25\dimexpr#2bp\relax}\selectfont #5};}
\newsavebox\kgpicture
\long\def\kgslide#1{\sbox\kgpicture{#1}\begin{tikzpicture}[remember picture,overlay]
  \node[inner sep=0pt] at (current page.center) {\resizebox{\paperwidth}{!}{\usebox\kgpicture}};
  \end{tikzpicture}}
)";

/// The marks without those of sentences.
std::vector<Mark> without_sentences(const std::vector<Mark>& marks) {
    std::vector<Mark> kept;
    std::size_t depth = 0;  // of open groups within a sentence
    for (const Mark& mark : marks) {
        const auto* group = std::get_if<GroupBegin>(&mark);
        if (group != nullptr && (depth > 0 || group->cls == "sentence")) ++depth;
        if (depth == 0) kept.push_back(mark);
        if (depth > 0 && std::holds_alternative<GroupEnd>(mark)) --depth;
    }
    return kept;
}

/// What a step says, set by TeX; empty if TeX has no letter for a character in it.
std::string said_by_tex(const Page& page, Styles& styles) {
    if (!page.step) return {};
    const StepText& step = *page.step;
    std::string paragraphs;
    for (const RichText& each : step.sentences) {
        const auto words = tex_words_of(each, [&](Colour c) { return styles.colour(c); });
        if (!words) return {};
        paragraphs += (paragraphs.empty() ? "" : "\\par\\smallskip ") + line_of(*words);
    }
    if (paragraphs.empty()) return {};
    return "\\kgsays{" + number(step.width) + "}{" + number(step.size, 2) + "}(" + number(step.corner.x) + "," +
           number(step.corner.y) + "){" + paragraphs + "}\n";
}

}  // namespace

std::string to_tex(const std::vector<Page>& pages, const Glyphs& glyphs) {
    Styles styles;
    LetterWidths widths;
    std::string pictures;
    for (const Page& page : pages) pictures += TikzPicture(page, glyphs, styles, widths).write();
    return std::string(alone_head).append(faces_head).append(alone_head_end).append(common_head) +
           widths.definitions() + styles.definitions() + pictures + "\\kgfinish\n";
}

std::string to_beamer(const std::vector<Page>& pages, const Glyphs& glyphs) {
    Styles styles;
    LetterWidths widths;
    std::string frames;
    const auto are_of_one_figure = [](const Page& a, const Page& b) {
        return a.step && b.step && a.step->figure == b.step->figure;
    };
    for (std::size_t i = 0; i < pages.size();) {
        const std::size_t first = i;
        Overlays overlays;
        do {
            const std::string said = said_by_tex(pages[i], styles);
            const std::vector<Mark> drawn = said.empty() ? pages[i].marks : without_sentences(pages[i].marks);
            overlays.add(TikzPicture(pages[i], glyphs, styles, widths).lines(drawn) + said);
        } while (++i < pages.size() && are_of_one_figure(pages[first], pages[i]));
        const std::string heading = pages[first].step ? pages[first].step->heading : pages[first].title;
        frames += "% " + comment(heading) + "\n\\begin{frame}[plain]\n\\kgslide{\\begin{tikzpicture}[kg]\n" +
                  overlays.text() + "\\end{tikzpicture}}\n\\end{frame}\n";
    }
    return std::string(slides_head).append(faces_head).append(common_head).append(slides_head_end) +
           widths.definitions() + styles.definitions() + "\\begin{document}\n" + frames + "\\end{document}\n";
}

}  // namespace kinegraph::render
