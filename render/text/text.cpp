// Typesetting of lines: words are shaped one by one in em units, cached, then scaled and moved. Owns the fonts' faces
// and all measures (scripts, dots, code boxes). Independent of the meaning of the words.
#include "render/text/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>
#include <span>
#include <string_view>
#include <unordered_map>

#include "engine/number/assert.hpp"
#include "render/text/bound_blank.hpp"
#include "render/text/typeface.hpp"
#include "render/text/utf8.hpp"

namespace kinegraph::render {
namespace {

// Measures of typesetting, in em of the base size.
constexpr double script_scale = 0.70;
constexpr double subscript_drop = 0.22;
constexpr double superscript_rise = 0.40;
constexpr double tall_superscript_rise = 0.46;  // for a sign that extends below its line, above a subscript
constexpr double space_after_scripts = 0.03;
constexpr double least_italic_correction = 0.03;  // or an upright superscript would touch a slanted letter
constexpr double most_italic_correction = 0.15;
constexpr double dot_radius = 0.055;
constexpr double dot_rise = 0.12;  // centre of the dot above the ink of the letter
constexpr double dot_pitch = 0.19;
constexpr double slant = 0.27;  // of the italic faces (15.5 degrees)
constexpr double code_scale = 0.45;
constexpr double code_padding = 0.06;
constexpr double code_line = 0.03;
constexpr double code_side = 0.05;

constexpr std::uint8_t regular = static_cast<std::uint8_t>(Face::regular);
constexpr std::uint8_t bold = static_cast<std::uint8_t>(Face::bold);

bool italic(Face face) { return face == Face::italic || face == Face::bold_italic; }

/// Heights of the em boxes of letters above and below the baseline.
struct Reach {
    double over = -std::numeric_limits<double>::infinity(), under = -std::numeric_limits<double>::infinity();
    void include(const Reach& other) {
        over = std::max(over, other.over);
        under = std::max(under, other.under);
    }
};

/// A word shaped in one face at 1 em, origin at 0.
struct Word {
    struct Placed {
        std::uint8_t face;
        std::uint32_t index;
        double scale;
        double x, y;
        std::uint32_t at;  // byte offset of its character in the word
        bool coded;
    };
    std::vector<Placed> glyphs;
    std::vector<Ink> boxes;  // boxes round the codes of missing characters
    double advance = 0;
    Ink last;  // ink of the last letter
    double top = 0, bottom = 0;
    Reach reach;  // em boxes of its letters
};

/// Bytes shown as a space at which a line may break: the space and ASCII control characters.
bool breaks(char c) { return static_cast<unsigned char>(c) <= 0x20 || c == 0x7F; }

/// Advance of a white space in em; 0 for characters without ink and width; negative if `c` is not blank.
double blank_advance(char32_t c, double space) {
    switch (c) {
        case 0x00A0:
        case 0x2028:
        case 0x2029: return space;
        case 0x2000:
        case 0x2002:
        case 0x2007: return 0.5;
        case 0x2001:
        case 0x2003:
        case 0x3000: return 1;
        case 0x2004: return 1 / 3.0;
        case 0x2005:
        case 0x2008: return 0.25;
        case 0x2006: return 1 / 6.0;
        case 0x2009:
        case 0x202F: return 0.2;
        case 0x200A: return 0.1;
        case 0x205F: return 4 / 18.0;
        case 0x00AD:
        case 0x034F:
        case 0x061C:
        case 0xFEFF: return 0;
        default: break;
    }
    if (c < 0x20 || (c >= 0x7F && c < 0xA0)) return space;
    const bool unseen = (c >= 0x200B && c <= 0x200F) || (c >= 0x202A && c <= 0x202E) || (c >= 0x2060 && c <= 0x206F) ||
                        (c >= 0xFE00 && c <= 0xFE0F) || (c >= 0xE0000 && c <= 0xE0FFF);
    return unseen ? 0 : -1;
}

std::string code_name(char32_t c) {
    static constexpr std::string_view digits = "0123456789ABCDEF";
    std::string name = "U+";
    for (int shift = c > 0xFFFFF ? 20 : c > 0xFFFF ? 16 : 12; shift >= 0; shift -= 4)
        name += digits[(c >> shift) & 0xF];
    return name;
}

struct Hash : std::hash<std::string_view> {
    using is_transparent = void;
};

}  // namespace

struct Fonts::State {
    struct FaceOfFont {
        std::unique_ptr<Typeface> typeface;
        double space = 0;                           // em
        std::vector<std::unique_ptr<Drawn>> drawn;  // by glyph index; the addresses are stable
        std::unordered_map<std::string, Word, Hash, std::equal_to<>> words;
    };
    std::array<FaceOfFont, std::tuple_size_v<Typefaces>> faces;
    std::set<char32_t> missing;
    std::vector<char32_t> characters;
    std::vector<std::uint32_t> begins;  // byte offset of each character in the word
    std::vector<std::uint8_t> faces_of;
    std::vector<Typeface::Placed> placed;

    const Drawn& drawing(std::uint8_t face, std::uint32_t index);
    bool has(std::uint8_t face, char32_t c) const { return faces[face].typeface->has(c); }
    const Word& word(std::string_view text, Face face);
    Word set_word(std::string_view text, std::uint8_t face);
    struct Form {
        double scale = 1, y = 0;
        bool coded = false;
    };
    void shape_run(std::span<const char32_t> run, std::span<const std::uint32_t> from, std::uint8_t face,
                   const Form& form, Word& into);
    void draw_code(char32_t c, std::uint32_t from, Word& into);
};

const Drawn& Fonts::State::drawing(std::uint8_t face, std::uint32_t index) {
    KG_ASSERT(face < faces.size(), "a glyph belongs to one of the four faces");
    FaceOfFont& f = faces[face];
    KG_ASSERT(index < f.drawn.size(), "a glyph's index lies within its face");
    std::unique_ptr<Drawn>& drawn = f.drawn[index];
    if (drawn) return *drawn;
    drawn = std::make_unique<Drawn>(f.typeface->draw(index));
    return *drawn;
}

/// Shapes characters of a single face and appends them to the word. `from`: their byte offsets in the word.
void Fonts::State::shape_run(std::span<const char32_t> run, std::span<const std::uint32_t> from, std::uint8_t face,
                             const Form& form, Word& into) {
    const double scale = form.scale, y = form.y;
    const Typeface& typeface = *faces[face].typeface;
    typeface.shape(run, placed);
    const double unit = typeface.unit() * scale;
    int pen = 0;
    const double start = into.advance;
    for (const Typeface::Placed& glyph : placed) {
        const double x = start + (pen + glyph.x) * unit;
        const double lift = y + glyph.y * unit;
        const Ink ink = drawing(face, glyph.glyph).ink;
        pen += glyph.advance;
        if (ink.blank()) continue;
        into.glyphs.push_back({face, glyph.glyph, scale, x, lift, from[glyph.from], form.coded});
        into.reach.include({lift + letter_over * scale, letter_under * scale - lift});
        into.last = {x + ink.left * scale, lift + ink.bottom * scale, x + ink.right * scale, lift + ink.top * scale};
        into.top = std::max(into.top, into.last.top);
        into.bottom = std::min(into.bottom, into.last.bottom);
    }
    into.advance = start + pen * unit;
}

/// Draws the boxed code of a character missing from all faces.
void Fonts::State::draw_code(char32_t c, std::uint32_t from, Word& into) {
    const std::string name = code_name(c);
    missing.insert(c);
    const std::u32string code(name.begin(), name.end());
    Ink box;
    box.left = into.advance + code_side;
    box.bottom = 0;
    into.advance = box.left + code_padding;
    shape_run(code, std::vector(code.size(), from), regular, {code_scale, code_padding + code_line, true}, into);
    box.right = into.advance + code_padding;
    box.top = into.last.top + code_padding + code_line;
    into.advance = box.right + code_side;
    into.boxes.push_back(box);
    into.last = {box.left - code_line / 2, box.bottom - code_line / 2, box.right + code_line / 2,
                 box.top + code_line / 2};
    into.top = std::max(into.top, into.last.top);
    into.bottom = std::min(into.bottom, into.last.bottom);
}

Word Fonts::State::set_word(std::string_view text, std::uint8_t face) {
    characters.clear();
    begins.clear();
    faces_of.clear();
    for (std::size_t at = 0; at < text.size();) {
        const auto begin = static_cast<std::uint32_t>(at);
        const char32_t c = next_code_point(text, at);
        // A combining accent is composed with its letter if Unicode has the composed character (file names of some
        // systems use combining accents).
        if (c >= 0x300 && c < 0x370 && !characters.empty()) {
            if (const char32_t whole = faces[face].typeface->composed(characters.back(), c)) {
                characters.back() = whole;
                continue;
            }
        }
        characters.push_back(c);
        begins.push_back(begin);
    }
    constexpr std::uint8_t blank = 254, nowhere = 255;
    const double space = faces[face].space;
    for (const char32_t c : characters) {
        faces_of.push_back(blank_advance(c, space) >= 0 ? blank
                           : has(face, c)               ? face
                           : has(regular, c)            ? regular
                           : has(bold, c)               ? bold
                                                        : nowhere);
    }
    Word word;
    for (std::size_t begin = 0, end = 0; begin < characters.size(); begin = end) {
        const std::uint8_t of = faces_of[begin];
        end = begin + 1;
        if (of == blank) {
            word.advance += blank_advance(characters[begin], space);
        } else if (of == nowhere) {
            draw_code(characters[begin], begins[begin], word);
        } else {
            while (end < characters.size() && faces_of[end] == of) ++end;
            const std::size_t count = end - begin;
            shape_run(std::span(characters).subspan(begin, count), std::span(begins).subspan(begin, count), of, {},
                      word);
        }
    }
    return word;
}

const Word& Fonts::State::word(std::string_view text, Face face) {
    auto& words = faces[static_cast<std::size_t>(face)].words;
    const auto known = words.find(text);
    if (known != words.end()) return known->second;
    return words.emplace(std::string(text), set_word(text, static_cast<std::uint8_t>(face))).first->second;
}

namespace {

/// The dots of a derivative as combining characters.
std::string dots_said(const Piece& piece) {
    std::string dots;
    if (piece.dots == 2) {
        append_utf8(dots, 0x308);
    } else {
        for (int i = 0; i < piece.dots; ++i) append_utf8(dots, 0x307);
    }
    return dots;
}

/// Estimated number of letters.
std::size_t bytes_of(const RichText& text) {
    std::size_t bytes = 0;
    for (const Piece& piece : text) bytes += piece.text.size() + piece.sub.size() + piece.sup.size() + 4;
    return bytes;
}

/// An unbreakable unit of a line: a word, the spaces between words, or a piece that stays together.
struct Stretch {
    std::size_t piece, begin, end;
    bool blank;
    double width;
    bool symbol = false;         // with a subscript or an exponent
    const Word* word = nullptr;  // null unless the stretch is a word
    Reach reach{};               // em boxes of its letters, mm
    bool bound = false;          // blanks between a number and its unit

    /// A line may end here.
    bool parts_words() const { return blank && !bound; }
};

/// A copy of a piece without scripts, with other words.
Piece like(const Piece& piece, std::string words) {
    Piece own;
    own.text = std::move(words);
    own.face = piece.face;
    own.sub_face = piece.sub_face;
    own.sup_face = piece.sup_face;
    own.coloured = piece.coloured;
    own.colour = piece.colour;
    return own;
}

/// Sets one piece after the other on a line; lengths in mm, y downwards.
template <class State>
class Setter {
public:
    /// `letters`: expected number of letters of the line.
    Setter(State& state, std::size_t letters) : state_(state), letters_(letters) {}
    /// A setter that only measures: pieces advance, but produce no line.
    static Setter measuring(State& state) {
        Setter setter(state, 0);
        setter.measures_ = true;
        return setter;
    }
    double advance() const { return x_; }
    const Reach& reach() const { return reach_; }

    struct Run {
        double advance = 0;
        Ink last;  // ink of the last letter, mm, y upwards
    };

    /// `said`: byte offset of the text in what the line says.
    Run set(std::string_view text, std::size_t said, Face face, double size, Spot from, std::size_t part) {
        Run run;
        for (std::size_t at = 0; at < text.size();) {
            if (breaks(text[at])) {
                run.advance += state_.faces[static_cast<std::size_t>(face)].space * size;
                ++at;
                continue;
            }
            std::size_t end = at + 1;
            while (end < text.size() && !breaks(text[end])) ++end;
            place(state_.word(text.substr(at, end - at), face), said + at, size, from, part, run);
            at = end;
        }
        return run;
    }
    /// Sets a piece without scripts from known stretches.
    void set(const Piece& piece, std::span<const Stretch> stretches, double size) {
        const std::size_t part = part_of(piece), begin = stretches.front().begin;
        const double space = state_.faces[static_cast<std::size_t>(piece.face)].space * size;
        Run run;
        for (const Stretch& each : stretches)
            if (each.word != nullptr)
                place(*each.word, said_ + (each.begin - begin), size, {x_, 0}, part, run);
            else
                for (std::size_t at = each.begin; at < each.end; ++at) run.advance += space;
        said_ += piece.text.size();
        x_ += run.advance;
    }

    void set(const Piece& piece, double size) {
        const std::size_t part = part_of(piece);
        const Run base = set(piece.text, said_, piece.face, size, {x_, 0}, part);
        const std::size_t sub_said = said_ + piece.text.size() + dots_said(piece).size() + 1;  // after "_"
        const std::size_t sup_said = sub_said + (piece.sub.empty() ? 0 : piece.sub.size() + 1);
        said_ = piece.sup.empty() ? sup_said - 1 : sup_said + piece.sup.size();
        if (piece.dots > 0 && !base.last.blank()) dot(piece, base.last, size, part);
        x_ += base.advance;
        if (piece.sub.empty() && piece.sup.empty()) return;
        const Run sub =
            set(piece.sub, sub_said, piece.sub_face, size * script_scale, {x_, subscript_drop * size}, part);
        double lean = 0;
        if (italic(piece.face) && !base.last.blank()) {
            lean = size * std::clamp((base.last.right - x_) / size, least_italic_correction, most_italic_correction);
        }
        const double rise = piece.sup.starts_with("∥") && !piece.sub.empty() ? tall_superscript_rise : superscript_rise;
        const Run sup = set(piece.sup, sup_said, piece.sup_face, size * script_scale, {x_ + lean, -rise * size}, part);
        const double wide = piece.sup.empty() ? sub.advance : std::max(sub.advance, lean + sup.advance);
        x_ += wide + space_after_scripts * size;
    }

    ShapedLine finish(RichText text) {
        line_.width = x_;
        for (Piece& piece : text) piece.text = unbound(std::move(piece.text));
        line_.words = plain(text);
        line_.text = std::move(text);
        return std::move(line_);
    }

private:
    std::size_t part_of(const Piece& piece) {
        if (measures_) return 0;
        for (std::size_t i = 0; i < line_.parts.size(); ++i) {
            const auto& part = line_.parts[i];
            if (part.coloured == piece.coloured && (!piece.coloured || part.colour == piece.colour)) return i;
        }
        line_.parts.push_back({{}, {}, piece.coloured, piece.coloured ? piece.colour : Colour{}});
        // Most lines have only one colour.
        if (line_.parts.size() == 1) line_.parts.front().glyphs.reserve(letters_);
        return line_.parts.size() - 1;
    }

    void place(const Word& word, std::size_t said, double size, Spot from, std::size_t part, Run& run) {
        const double at = from.x + run.advance, y = from.y;
        if (!measures_) draw(word, said, size, {at, y}, line_.parts[part]);
        if (!word.last.blank()) {
            run.last = {at + word.last.left * size, word.last.bottom * size - y, at + word.last.right * size,
                        word.last.top * size - y};
            inked(y - word.top * size, y - word.bottom * size);
            reach_.include({word.reach.over * size - y, word.reach.under * size + y});
        }
        run.advance += word.advance * size;
    }

    static void draw(const Word& word, std::size_t said, double size, Spot at, ShapedLine::Part& to) {
        for (const auto& g : word.glyphs) {
            to.glyphs.push_back({g.face,
                                 g.index,
                                 g.scale * size,
                                 {at.x + g.x * size, at.y - g.y * size},
                                 static_cast<std::uint32_t>(said + g.at),
                                 g.coded});
        }
        for (const Ink& box : word.boxes) {
            Path path;
            const double left = at.x + box.left * size, right = at.x + box.right * size;
            const double top = at.y - box.top * size, bottom = at.y - box.bottom * size;
            path.segments = {MoveTo{{left, top}}, LineTo{{right, top}}, LineTo{{right, bottom}}, LineTo{{left, bottom}},
                             Close{}};
            path.stroked = true;
            path.pen.width = code_line * size;
            path.pen.colour = to.colour;
            to.extras.push_back(std::move(path));
        }
    }

    void dot(const Piece& piece, const Ink& letter, double size, std::size_t part) {
        if (measures_) return;
        const double height = letter.top + dot_rise * size;
        double middle = (letter.left + letter.right) / 2;
        if (italic(piece.face)) middle += slant * (height - (letter.bottom + letter.top) / 2) / 2;
        auto& to = line_.parts[part];
        for (int i = 0; i < piece.dots; ++i) {
            Path path;
            const double x = middle + (i - (piece.dots - 1) / 2.0) * dot_pitch * size;
            path.segments = {ArcTo{{x, -height}, dot_radius * size, 0, 2 * std::numbers::pi}, Close{}};
            path.filled = true;
            path.fill = to.colour;
            to.extras.push_back(std::move(path));
        }
        inked(-height - dot_radius * size, -height);
    }

    void inked(double top, double bottom) {
        line_.ascent = std::max(line_.ascent, -top);
        line_.descent = std::max(line_.descent, bottom);
    }

    State& state_;
    std::size_t letters_;
    bool measures_ = false;
    ShapedLine line_;
    Reach reach_;
    double x_ = 0;
    std::size_t said_ = 0;  // byte length of what the line says so far
};

bool has_scripts(const Piece& piece) { return !piece.sub.empty() || !piece.sup.empty() || piece.dots > 0; }

/// Whether it contains superscript characters (the fonts have raised digits only for 1, 2 and 3).
bool has_raised_digits(std::string_view text) {
    // UTF-8 of ⁰, ⁴ to ⁹ and ⁻.
    static constexpr std::string_view block = "\xE2\x81", last = "\xB0\xB4\xB5\xB6\xB7\xB8\xB9\xBB";
    for (std::size_t at = text.find(block); at != std::string_view::npos; at = text.find(block, at + 1))
        if (at + 2 < text.size() && last.find(text[at + 2]) != std::string_view::npos) return true;
    return false;
}

constexpr std::array<char, 2> either_blank{' ', bound_blank};
constexpr std::string_view between_words(either_blank.data(), either_blank.size());

/// Keeps a number with a power of ten together: no break at its × sign.
std::string with_whole_powers_of_ten(std::string text) {
    constexpr std::string_view times = " × 10", unbroken = "\u00A0×\u00A010";
    for (std::size_t i = text.find(times); i != std::string::npos; i = text.find(times, i + times.size())) {
        const std::string_view rest = std::string_view(text).substr(i + times.size());
        const bool raised = std::any_of(raised_characters.begin(), raised_characters.end(),
                                        [&](const auto& each) { return rest.starts_with(each.first); });
        if (raised) text.replace(i, times.size(), unbroken);
    }
    return text;
}

/// The text with raised digits as superscripts; words that contain them become separate pieces. Returns `text` itself
/// if it has none.
const RichText& with_raised_digits(const RichText& text, RichText& changed) {
    const auto concerns = [](const Piece& piece) { return !has_scripts(piece) && has_raised_digits(piece.text); };
    if (std::none_of(text.begin(), text.end(), concerns)) return text;
    for (const Piece& piece : text) {
        if (!concerns(piece)) {
            changed.push_back(piece);
            continue;
        }
        const std::string words = with_whole_powers_of_ten(piece.text);
        for (std::size_t at = 0; at < words.size();) {
            const std::size_t blank = words.find_first_of(between_words, at),
                              end = blank == std::string::npos ? words.size() : blank + 1;
            for (Piece& part : with_powers(words.substr(at, end - at))) {
                Piece set = piece;
                set.text = std::move(part.text);
                set.sup = std::move(part.sup);
                changed.push_back(std::move(set));
            }
            at = end;
        }
    }
    return changed;
}

/// The text with long subscripts (of two names that are words) divided into pieces, between which a line may end.
const RichText& with_long_scripts_divided(const RichText& text, RichText& divided) {
    constexpr std::size_t longest = 36, least = 12;  // bytes
    const auto concerns = [](const Piece& piece) { return piece.sub.size() > longest; };
    if (std::none_of(text.begin(), text.end(), concerns)) return text;
    for (const Piece& piece : text) {
        divided.push_back(piece);
        const std::string sub = concerns(piece) ? std::exchange(divided.back().sub, {}) : std::string();
        for (std::size_t at = 0; at < sub.size();) {
            std::size_t end = std::min(sub.find_first_of(" ,", std::min(at + least, sub.size())), sub.size());
            const bool at_comma = end < sub.size() && sub[end] == ',';
            if (at > 0) {
                const Piece whole = divided.back();
                divided.push_back(Piece{});
                divided.back().text = " ";
                divided.push_back(whole);
                divided.back().text.clear();
                divided.back().sup.clear();
                divided.back().dots = 0;
            }
            divided.back().sub = sub.substr(at, end + (at_comma ? 1 : 0) - at);
            at = std::min(end + 1, sub.size());
        }
    }
    return divided;
}

}  // namespace

RichText with_powers(const std::string& given) {
    const std::string text = with_whole_powers_of_ten(given);
    constexpr auto& powers = raised_characters;
    RichText rich{Piece{}};
    for (std::size_t i = 0; i < text.size();) {
        // Most characters are not powers, and most of them are ASCII.
        const auto power = (static_cast<unsigned char>(text[i]) & 0x80U) == 0
                               ? powers.end()
                               : std::find_if(powers.begin(), powers.end(), [&](const auto& each) {
                                     return std::string_view(text).substr(i).starts_with(each.first);
                                 });
        if (power != powers.end()) {
            // A line may still break before the word that has the exponent.
            const std::size_t blank =
                rich.back().sup.empty() ? rich.back().text.find_last_of(between_words) : std::string::npos;
            if (blank != std::string::npos && blank + 1 < rich.back().text.size()) {
                std::string raised = rich.back().text.substr(blank + 1);
                rich.back().text.resize(blank + 1);
                rich.push_back(Piece{});
                rich.back().text = std::move(raised);
            }
            rich.back().sup += power->second;
            i += power->first.size();
        } else {
            if (!rich.back().sup.empty()) rich.push_back(Piece{});
            rich.back().text += text[i++];
        }
    }
    return rich;
}

RichText as_set(const RichText& text) {
    RichText changed;
    return with_raised_digits(text, changed);
}

std::string plain(const RichText& text) {
    std::string words;
    words.reserve(bytes_of(text));
    for (const Piece& piece : text) {
        words += piece.text;
        if (piece.dots > 0) words += dots_said(piece);
        if (!piece.sub.empty()) (words += '_') += piece.sub;
        if (!piece.sup.empty()) (words += '^') += piece.sup;
    }
    return unbound(std::move(words));
}

Fonts::Fonts(Typefaces faces) : state_(std::make_unique<State>()) {
    for (std::size_t i = 0; i < faces.size(); ++i) {
        State::FaceOfFont& f = state_->faces[i];
        f.typeface = std::move(faces[i]);
        f.drawn.resize(f.typeface->glyphs());
        constexpr char32_t blank = U' ';
        f.space = 0.25;
        if (!f.typeface->has(blank)) continue;
        f.typeface->shape({&blank, 1}, state_->placed);
        f.space = state_->placed.front().advance * f.typeface->unit();
    }
}
tl::expected<Fonts, Words> Fonts::open() {
    return open_typefaces().map([](Typefaces&& faces) { return Fonts(std::move(faces)); });
}
Fonts::Fonts(Fonts&&) noexcept = default;
Fonts& Fonts::operator=(Fonts&&) noexcept = default;
Fonts::~Fonts() = default;

ShapedLine Fonts::shape(RichText text, double size_points) const {
    KG_ASSERT(std::isfinite(size_points) && size_points > 0, "type has a size");
    Setter<State> setter(*state_, bytes_of(text));
    RichText changed;
    for (const Piece& piece : with_raised_digits(text, changed)) setter.set(piece, millimetres(size_points));
    return setter.finish(std::move(text));
}

namespace {

/// Builds the line of consecutive stretches.
template <class State>
ShapedLine line_of(State& state, const RichText& text, std::span<const Stretch> stretches, double size) {
    std::size_t letters = 0, pieces = 0;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        letters += stretches[i].end - stretches[i].begin;
        pieces += i == 0 || stretches[i].piece != stretches[i - 1].piece ? 1 : 0;
    }
    Setter<State> setter(state, letters + pieces);
    RichText line;
    line.reserve(pieces);
    for (std::size_t first = 0, end = 0; first < stretches.size(); first = end) {
        const std::size_t piece = stretches[first].piece;
        for (end = first + 1; end < stretches.size() && stretches[end].piece == piece;) ++end;
        if (stretches[first].symbol) {
            setter.set(line.emplace_back(text[piece]), size);
        } else {
            const std::size_t begin = stretches[first].begin;
            line.push_back(like(text[piece], text[piece].text.substr(begin, stretches[end - 1].end - begin)));
            setter.set(line.back(), stretches.subspan(first, end - first), size);
        }
    }
    return setter.finish(std::move(line));
}

/// Calls set(first, last) for every line. Lines end only at spaces.
template <class Set>
void break_lines(const std::vector<Stretch>& stretches, double measure, Set set) {
    constexpr double tolerance = 1e-9;  // mm; sums of widths differ in their last bits
    std::size_t first = 0;              // first stretch of this line
    std::size_t last = 0;               // end of the last word that fits on this line
    double width = 0;                   // width up to `i`
    for (std::size_t i = 0; i < stretches.size();) {
        std::size_t word = i;  // the next word begins here, after spaces
        double to_word = width;
        while (word < stretches.size() && stretches[word].parts_words()) to_word += stretches[word++].width;
        std::size_t end = word;
        double to_end = to_word;
        while (end < stretches.size() && !stretches[end].parts_words()) to_end += stretches[end++].width;
        if (word == end) break;  // only spaces are left
        if (to_end - to_word > measure + tolerance && end - word > 1) {
            // A word that is too long for a line is divided before its symbols, and after a symbol that fits on the
            // line: a formula of long names.
            const std::size_t whole = end;
            for (end = word, to_end = to_word; end < whole; ++end) {
                const bool fits = to_end - to_word + stretches[end].width <= measure + tolerance;
                const bool behind = end > word && stretches[end - 1].symbol && stretches[end - 1].width <= measure;
                if (end > word && !fits && (stretches[end].symbol || behind)) break;
                to_end += stretches[end].width;
            }
        }
        if (to_end > measure + tolerance && last > first) {
            set(first, last);
            first = word;
            to_end -= to_word;
        }
        last = end;
        width = to_end;
        i = end;
    }
    if (last > first || first == 0) set(first, last);
}

}  // namespace

namespace {

/// Collects the unbreakable stretches of a text in order.
template <class State>
std::vector<Stretch> stretches_of(State& state, const RichText& text, double size) {
    std::vector<Stretch> stretches;
    stretches.reserve(bytes_of(text) / 3);
    for (std::size_t p = 0; p < text.size(); ++p) {
        const Piece& piece = text[p];
        const std::string_view words = piece.text;
        if (has_scripts(piece)) {
            auto symbol = Setter<State>::measuring(state);
            symbol.set(piece, size);
            stretches.push_back({p, 0, words.size(), false, symbol.advance(), true, nullptr, symbol.reach()});
            continue;
        }
        for (std::size_t at = 0; at < words.size();) {
            const bool blank = breaks(words[at]);
            std::size_t end = at + 1;
            while (end < words.size() && breaks(words[end]) == blank) ++end;
            const Word* word = blank ? nullptr : &state.word(words.substr(at, end - at), piece.face);
            const double em =
                blank ? state.faces[static_cast<std::size_t>(piece.face)].space * static_cast<double>(end - at)
                      : word->advance;
            const Reach reach = blank ? Reach{} : Reach{word->reach.over * size, word->reach.under * size};
            const bool bound = blank && words.substr(at, end - at).find(bound_blank) != std::string_view::npos;
            stretches.push_back({p, at, end, blank, em * size, false, word, reach, bound});
            at = end;
        }
    }
    return stretches;
}

}  // namespace

struct MeasuredText::Parts {
    RichText text;
    double size;  // mm
    std::vector<Stretch> stretches;
};

std::vector<MeasuredText::Line> MeasuredText::lines(double measure) const {
    std::vector<Line> lines;
    break_lines(parts_->stretches, measure, [&](std::size_t first, std::size_t end) {
        Reach reach;
        for (std::size_t i = first; i < end; ++i) reach.include(parts_->stretches[i].reach);
        const bool has_letters = reach.over + reach.under > 0;
        lines.push_back({first, end, has_letters ? reach.over : 0, has_letters ? reach.under : 0});
    });
    return lines;
}

double Fonts::width(const RichText& text, double size_points) const {
    auto setter = Setter<State>::measuring(*state_);
    RichText changed;
    for (const Piece& piece : with_raised_digits(text, changed)) setter.set(piece, millimetres(size_points));
    return setter.advance();
}

MeasuredText Fonts::measured(RichText text, double size_points) const {
    KG_ASSERT(std::isfinite(size_points) && size_points > 0, "type has a size");
    RichText changed;
    const bool is_changed = &with_raised_digits(text, changed) == &changed;
    RichText whole = std::move(is_changed ? changed : text), divided;
    const bool is_divided = &with_long_scripts_divided(whole, divided) == &divided;
    RichText set = std::move(is_divided ? divided : whole);
    const double size = millimetres(size_points);
    std::vector<Stretch> stretches = stretches_of(*state_, set, size);
    return MeasuredText(
        std::make_shared<const MeasuredText::Parts>(MeasuredText::Parts{std::move(set), size, std::move(stretches)}));
}

ShapedLine Fonts::set(const MeasuredText& text, const MeasuredText::Line& line) const {
    const MeasuredText::Parts& parts = *text.parts_;
    return line_of(*state_, parts.text, std::span(parts.stretches).subspan(line.first, line.end - line.first),
                   parts.size);
}

std::vector<ShapedLine> Fonts::wrap(const RichText& given, double size_points, double measure) const {
    KG_ASSERT(std::isfinite(size_points) && size_points > 0, "type has a size");
    RichText changed, divided;
    const RichText& text = with_long_scripts_divided(with_raised_digits(given, changed), divided);
    const double size = millimetres(size_points);
    const std::vector<Stretch> stretches = stretches_of(*state_, text, size);
    std::vector<ShapedLine> lines;
    break_lines(stretches, measure, [&](std::size_t first, std::size_t last) {
        lines.push_back(line_of(*state_, text, std::span(stretches).subspan(first, last - first), size));
    });
    return lines;
}

const Outline& Fonts::outline(std::uint8_t face, std::uint32_t index) const {
    return state_->drawing(face, index).outline;
}

std::string_view Fonts::file(std::uint8_t face) const {
    KG_ASSERT(face < state_->faces.size(), "the font has four faces");
    return state_->faces[face].typeface->file();
}

std::vector<std::string> Fonts::missing() const {
    std::vector<std::string> names;
    for (const char32_t c : state_->missing) names.push_back(code_name(c));
    return names;
}

void Fonts::start_anew() {
    constexpr std::size_t most_words = 6'000;
    std::size_t words = 0;
    for (const State::FaceOfFont& face : state_->faces) words += face.words.size();
    // A cached word would not report its missing characters again.
    if (words > most_words || !state_->missing.empty())
        for (State::FaceOfFont& face : state_->faces) face.words.clear();
    state_->missing.clear();
}

ShapedLine shaped_within(const RichText& line, double size, const Fonts& fonts, double measure) {
    ShapedLine shaped = fonts.shape(line, size);
    if (shaped.width <= measure || line.empty()) return shaped;
    const std::string words = shaped.words;
    const auto fits = [&](RichText text) {
        text.push_back({"…",
                        line.front().face == Face::bold ? Face::bold : Face::regular,
                        "",
                        Face::italic,
                        "",
                        Face::regular,
                        0,
                        false,
                        {}});
        shaped = fonts.shape(text, size);
        shaped.words = words;
        return shaped.width <= measure;
    };
    RichText text = line;
    // Binary search for the longest text that fits: names may be as long as a file allows.
    const auto longest = [&](std::size_t low, std::size_t high, const auto& kept) {
        while (low < high) {
            const std::size_t middle = (low + high + 1) / 2;
            if (fits(kept(middle)))
                low = middle;
            else
                high = middle - 1;
        }
        return low;
    };
    const std::size_t pieces = longest(0, text.size() - 1, [&](std::size_t n) {
        return RichText(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(n));
    });
    text.resize(std::max<std::size_t>(pieces, 1));
    if (pieces == 0) {
        Piece& first = text.front();
        std::string& long_one = first.sub.size() > first.text.size() ? first.sub : first.text;
        const std::string all = long_one;
        const auto cut = [&](std::size_t n) {
            long_one = first_characters(all, n);
            return text;
        };
        cut(longest(1, all.size(), cut));
    }
    fits(text);
    return shaped;
}

}  // namespace kinegraph::render
