#include "render/backends/tex_words.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "render/text/utf8.hpp"

namespace kinegraph::render {
namespace {

struct Sign {
    char32_t character;
    std::string_view tex;
};

/// Characters of formulas, Greek first.
constexpr auto signs_of_mathematics = std::to_array<Sign>({
    {U'α', "\\alpha "},
    {U'β', "\\beta "},
    {U'γ', "\\gamma "},
    {U'δ', "\\delta "},
    {U'ε', "\\varepsilon "},
    {U'ζ', "\\zeta "},
    {U'η', "\\eta "},
    {U'θ', "\\theta "},
    {U'ι', "\\iota "},
    {U'κ', "\\kappa "},
    {U'λ', "\\lambda "},
    {U'μ', "\\mu "},
    {U'ν', "\\nu "},
    {U'ξ', "\\xi "},
    {U'ο', "o"},
    {U'π', "\\pi "},
    {U'ρ', "\\rho "},
    {U'ς', "\\varsigma "},
    {U'σ', "\\sigma "},
    {U'τ', "\\tau "},
    {U'υ', "\\upsilon "},
    {U'φ', "\\varphi "},
    {U'χ', "\\chi "},
    {U'ψ', "\\psi "},
    {U'ω', "\\omega "},
    {U'ϑ', "\\vartheta "},
    {U'ϕ', "\\phi "},
    {U'ϵ', "\\epsilon "},
    {U'ϱ', "\\varrho "},
    {U'Α', "A"},
    {U'Β', "B"},
    {U'Γ', "\\Gamma "},
    {U'Δ', "\\Delta "},
    {U'Ε', "E"},
    {U'Ζ', "Z"},
    {U'Η', "H"},
    {U'Θ', "\\Theta "},
    {U'Ι', "I"},
    {U'Κ', "K"},
    {U'Λ', "\\Lambda "},
    {U'Μ', "M"},
    {U'Ν', "N"},
    {U'Ξ', "\\Xi "},
    {U'Ο', "O"},
    {U'Π', "\\Pi "},
    {U'Ρ', "P"},
    {U'Σ', "\\Sigma "},
    {U'Τ', "T"},
    {U'Υ', "\\Upsilon "},
    {U'Φ', "\\Phi "},
    {U'Χ', "X"},
    {U'Ψ', "\\Psi "},
    {U'Ω', "\\Omega "},
    {U'Ω', "\\Omega "},
    {U'µ', "\\mu "},
    {U'∆', "\\Delta "},
    {U'−', "-"},
    {U'±', "\\pm "},
    {U'∓', "\\mp "},
    {U'×', "\\times "},
    {U'÷', "\\div "},
    {U'·', "\\cdot "},
    {U'⋅', "\\cdot "},
    {U'∗', "\\ast "},
    {U'∘', "\\circ "},
    {U'•', "\\bullet "},
    {U'√', "\\surd "},
    {U'∛', "\\sqrt[3]{}"},
    {U'∝', "\\propto "},
    {U'∞', "\\infty "},
    {U'∠', "\\angle "},
    {U'∥', "\\parallel "},
    {U'⟂', "\\perp "},
    {U'⊥', "\\perp "},
    {U'∧', "\\wedge "},
    {U'∨', "\\vee "},
    {U'∫', "\\int "},
    {U'∑', "\\sum "},
    {U'∏', "\\prod "},
    {U'∂', "\\partial "},
    {U'∇', "\\nabla "},
    {U'≈', "\\approx "},
    {U'≅', "\\cong "},
    {U'≃', "\\simeq "},
    {U'∼', "\\sim "},
    {U'≙', "\\widehat{=}"},
    {U'≠', "\\neq "},
    {U'≡', "\\equiv "},
    {U'≤', "\\leq "},
    {U'≥', "\\geq "},
    {U'≪', "\\ll "},
    {U'≫', "\\gg "},
    {U'∈', "\\in "},
    {U'∩', "\\cap "},
    {U'∪', "\\cup "},
    {U'⊂', "\\subset "},
    {U'⊙', "\\odot "},
    {U'⊕', "\\oplus "},
    {U'⊗', "\\otimes "},
    {U'←', "\\leftarrow "},
    {U'↑', "\\uparrow "},
    {U'→', "\\rightarrow "},
    {U'↓', "\\downarrow "},
    {U'↔', "\\leftrightarrow "},
    {U'⇒', "\\Rightarrow "},
    {U'⇔', "\\Leftrightarrow "},
    {U'⌊', "\\lfloor "},
    {U'⌋', "\\rfloor "},
    {U'°', "{}^{\\circ}"},
    {U'′', "{}'"},
    {U'″', "{}''"},
    {U'½', "\\frac{1}{2}"},
    {U'⅓', "\\frac{1}{3}"},
    {U'⅔', "\\frac{2}{3}"},
    {U'¼', "\\frac{1}{4}"},
    {U'¾', "\\frac{3}{4}"},
    {U'⁰', "{}^{0}"},
    {U'¹', "{}^{1}"},
    {U'²', "{}^{2}"},
    {U'³', "{}^{3}"},
    {U'⁴', "{}^{4}"},
    {U'⁵', "{}^{5}"},
    {U'⁶', "{}^{6}"},
    {U'⁷', "{}^{7}"},
    {U'⁸', "{}^{8}"},
    {U'⁹', "{}^{9}"},
    {U'⁻', "{}^{-}"},
    {U'⁺', "{}^{+}"},
    {U'ⁿ', "{}^{n}"},
    {U'₀', "{}_{0}"},
    {U'₁', "{}_{1}"},
    {U'₂', "{}_{2}"},
    {U'₃', "{}_{3}"},
    {U'₄', "{}_{4}"},
    {U'₅', "{}_{5}"},
    {U'₆', "{}_{6}"},
    {U'₇', "{}_{7}"},
    {U'₈', "{}_{8}"},
    {U'₉', "{}_{9}"},
    {U'<', "<"},
    {U'>', ">"},
    {U'|', "|"},
    {U'¬', "\\neg "},
    {U'ℓ', "\\ell "},
});

/// Characters of prose. An empty group prevents an unintended ligature.
constexpr auto signs_of_prose = std::to_array<Sign>({
    {U'\\', "\\textbackslash{}"},
    {U'{', "\\{"},
    {U'}', "\\}"},
    {U'$', "\\$"},
    {U'&', "\\&"},
    {U'#', "\\#"},
    {U'_', "\\_"},
    {U'%', "\\%"},
    {U'^', "\\textasciicircum{}"},
    {U'~', "\\textasciitilde{}"},
    {U'"', "''{}"},
    {U'`', "`{}"},
    {U'\'', "'{}"},
    {U'-', "-{}"},
    {U'‐', "-{}"},
    {U'‑', "-{}"},
    {U'–', "\\textendash{}"},
    {U'—', "\\textemdash{}"},
    {U'‘', "`{}"},
    {U'’', "'{}"},
    {U'“', "\\textquotedblleft{}"},
    {U'”', "\\textquotedblright{}"},
    {U'„', ",,"},
    {U'‚', ","},
    {U'…', "\\ldots{}"},
    {U'①', "\\kgcircled{1}"},
    {U'②', "\\kgcircled{2}"},
    {U'③', "\\kgcircled{3}"},
    {U'④', "\\kgcircled{4}"},
    {U'⑤', "\\kgcircled{5}"},
    {U'⑥', "\\kgcircled{6}"},
    {U'⑦', "\\kgcircled{7}"},
    {U'⑧', "\\kgcircled{8}"},
    {U'⑨', "\\kgcircled{9}"},
    {U'†', "\\dag{}"},
    {U'§', "\\S{}"},
    {U'¶', "\\P{}"},
    {U'£', "\\pounds{}"},
    {U'©', "\\copyright{}"},
    {U'ß', "\\ss{}"},
    {U'æ', "\\ae{}"},
    {U'Æ', "\\AE{}"},
    {U'œ', "\\oe{}"},
    {U'Œ', "\\OE{}"},
    {U'ø', "\\o{}"},
    {U'Ø', "\\O{}"},
    {U'ł', "\\l{}"},
    {U'Ł', "\\L{}"},
    {U'ı', "\\i{}"},
    {U'¿', "\\textquestiondown{}"},
    {U'¡', "\\textexclamdown{}"},
    {U'\u202F', "\\,"},
    {U'\u2009', "\\,"},
    {U'\u200A', "\\,"},
    {U'\u2002', "\\enspace{}"},
    {U'\u2003', "\\quad{}"},
});

/// Letters with an accent, in TeX: the accent command on the letter.
struct Accented {
    char32_t whole;
    char letter;
    char accent;
};
constexpr auto accented_letters = std::to_array<Accented>({
    {U'À', 'A', '`'},  {U'Á', 'A', '\''}, {U'Â', 'A', '^'},  {U'Ã', 'A', '~'},  {U'Ä', 'A', '"'},  {U'Å', 'A', 'r'},
    {U'Ç', 'C', 'c'},  {U'È', 'E', '`'},  {U'É', 'E', '\''}, {U'Ê', 'E', '^'},  {U'Ë', 'E', '"'},  {U'Ì', 'I', '`'},
    {U'Í', 'I', '\''}, {U'Î', 'I', '^'},  {U'Ï', 'I', '"'},  {U'Ñ', 'N', '~'},  {U'Ò', 'O', '`'},  {U'Ó', 'O', '\''},
    {U'Ô', 'O', '^'},  {U'Õ', 'O', '~'},  {U'Ö', 'O', '"'},  {U'Ù', 'U', '`'},  {U'Ú', 'U', '\''}, {U'Û', 'U', '^'},
    {U'Ü', 'U', '"'},  {U'Ý', 'Y', '\''}, {U'à', 'a', '`'},  {U'á', 'a', '\''}, {U'â', 'a', '^'},  {U'ã', 'a', '~'},
    {U'ä', 'a', '"'},  {U'å', 'a', 'r'},  {U'ç', 'c', 'c'},  {U'è', 'e', '`'},  {U'é', 'e', '\''}, {U'ê', 'e', '^'},
    {U'ë', 'e', '"'},  {U'ì', 'i', '`'},  {U'í', 'i', '\''}, {U'î', 'i', '^'},  {U'ï', 'i', '"'},  {U'ñ', 'n', '~'},
    {U'ò', 'o', '`'},  {U'ó', 'o', '\''}, {U'ô', 'o', '^'},  {U'õ', 'o', '~'},  {U'ö', 'o', '"'},  {U'ù', 'u', '`'},
    {U'ú', 'u', '\''}, {U'û', 'u', '^'},  {U'ü', 'u', '"'},  {U'ý', 'y', '\''}, {U'ÿ', 'y', '"'},  {U'Ć', 'C', '\''},
    {U'ć', 'c', '\''}, {U'Č', 'C', 'v'},  {U'č', 'c', 'v'},  {U'Ě', 'E', 'v'},  {U'ě', 'e', 'v'},  {U'ğ', 'g', 'u'},
    {U'Ń', 'N', '\''}, {U'ń', 'n', '\''}, {U'Ň', 'N', 'v'},  {U'ň', 'n', 'v'},  {U'Ő', 'O', 'H'},  {U'ő', 'o', 'H'},
    {U'Ř', 'R', 'v'},  {U'ř', 'r', 'v'},  {U'Ś', 'S', '\''}, {U'ś', 's', '\''}, {U'Ş', 'S', 'c'},  {U'ş', 's', 'c'},
    {U'Š', 'S', 'v'},  {U'š', 's', 'v'},  {U'Ů', 'U', 'r'},  {U'ů', 'u', 'r'},  {U'Ű', 'U', 'H'},  {U'ű', 'u', 'H'},
    {U'Ź', 'Z', '\''}, {U'ź', 'z', '\''}, {U'Ż', 'Z', '.'},  {U'ż', 'z', '.'},  {U'Ž', 'Z', 'v'},  {U'ž', 'z', 'v'},
    {U'ḃ', 'b', '.'},  {U'ṡ', 's', '.'},  {U'ȧ', 'a', '.'},  {U'ċ', 'c', '.'},  {U'ẋ', 'x', '.'},  {U'ẏ', 'y', '.'},
});
/// Combining accents, which follow their letter.
constexpr auto accents_apart = std::to_array<std::pair<char32_t, char>>({{0x300, '`'},
                                                                         {0x301, '\''},
                                                                         {0x302, '^'},
                                                                         {0x303, '~'},
                                                                         {0x304, '='},
                                                                         {0x306, 'u'},
                                                                         {0x307, '.'},
                                                                         {0x308, '"'},
                                                                         {0x30A, 'r'},
                                                                         {0x30B, 'H'},
                                                                         {0x30C, 'v'},
                                                                         {0x327, 'c'}});

bool is_letter(char32_t c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char32_t c) { return c >= '0' && c <= '9'; }
bool is_white(char32_t c) { return c <= 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x2028 || c == 0x2029; }
/// Lines are already set, so a no-break space is an ordinary space here.
bool parts_words(char32_t c) { return is_white(c) || c == U'\u00A0'; }
bool is_unseen(char32_t c) {
    return c == 0xAD || (c >= 0x200B && c <= 0x200F) || (c >= 0x202A && c <= 0x202E) || (c >= 0x2060 && c <= 0x206F) ||
           (c >= 0xFE00 && c <= 0xFE0F) || c == 0xFEFF;
}

template <class Table>
const Sign* sign_in(const Table& table, char32_t c) {
    const auto found = std::find_if(table.begin(), table.end(), [c](const Sign& sign) { return sign.character == c; });
    return found == table.end() ? nullptr : &*found;
}

std::u32string characters_of(std::string_view text) {
    std::u32string characters;
    for (std::size_t at = 0; at < text.size();) characters += next_code_point(text, at);
    return characters;
}

std::string accent(char sign, const std::string& letter) {
    const bool dotted = letter == "i" || letter == "j";
    return std::string("\\") + sign + "{" + (dotted ? "\\" + letter : letter) + "}";
}

/// One character of prose with its following accent; advances `at` past both.
std::optional<std::string> prose_at(const std::u32string& text, std::size_t& at) {
    const char32_t c = text[at++];
    if (parts_words(c)) return " ";
    if (is_unseen(c)) return "";
    if (is_letter(c) && at < text.size()) {
        const auto apart = std::find_if(accents_apart.begin(), accents_apart.end(),
                                        [&](const auto& each) { return each.first == text[at]; });
        if (apart != accents_apart.end()) {
            ++at;
            return accent(apart->second, std::string(1, static_cast<char>(c)));
        }
    }
    if (const Sign* sign = sign_in(signs_of_prose, c)) return std::string(sign->tex);
    if (const Sign* sign = sign_in(signs_of_mathematics, c)) return "$" + std::string(sign->tex) + "$";
    const auto whole = std::find_if(accented_letters.begin(), accented_letters.end(),
                                    [c](const Accented& each) { return each.whole == c; });
    if (whole != accented_letters.end()) return accent(whole->accent, std::string(1, whole->letter));
    if (c < 0x7F) return std::string(1, static_cast<char>(c));
    return std::nullopt;
}

std::optional<std::string> prose(std::string_view words) {
    const std::u32string text = characters_of(words);
    std::string tex;
    for (std::size_t at = 0; at < text.size();) {
        const auto set = prose_at(text, at);
        if (!set) return std::nullopt;
        // TeX would drop the second of two spaces.
        tex += *set == " " && tex.ends_with(' ') ? "\\ " : *set;
    }
    return tex;
}

/// Text in its face, for horizontal mode.
std::optional<std::string> prose(std::string_view words, Face face) {
    auto set = prose(words);
    if (!set || set->empty()) return set;
    switch (face) {
        case Face::regular: return set;
        case Face::italic: return "\\textit{" + *set + "}";
        case Face::bold: return "\\textbf{" + *set + "}";
        case Face::bold_italic: return "\\textbf{\\textit{" + *set + "}}";
    }
    return set;
}

/// A word of a formula in its face: letters, digits, signs. Empty if it must be set as prose.
std::optional<std::string> mathematics(std::string_view words, Face face) {
    constexpr std::u32string_view plain = U"+*/=()[]!:;.";
    const std::u32string text = characters_of(words);
    const bool upright = face == Face::regular || face == Face::bold;
    std::string tex;
    std::size_t letters = 0;
    for (const char32_t c : text) {
        letters += is_letter(c) ? 1 : 0;
        if (is_letter(c) || is_digit(c) || plain.find(c) != std::u32string_view::npos)
            tex += static_cast<char>(c);
        else if (c == U',')
            tex += "{,}";
        else if (c == U'-' || c == U'–')
            tex += c == U'-' ? "-" : "\\mbox{\\textendash}";
        else if (const Sign* sign = sign_in(signs_of_mathematics, c))
            tex += sign->tex;
        else
            return std::nullopt;
    }
    if (upright && letters > 0) return (face == Face::bold ? "\\mathbf{" : "\\mathrm{") + tex + "}";
    return letters > 1 ? "\\mathit{" + tex + "}" : tex;
}

/// A subscript or superscript.
std::optional<std::string> script(char sign, const std::string& words, Face face) {
    if (words.empty()) return "";
    const std::string opening = std::string(1, sign) + "{";
    if (const auto formula = mathematics(words, face)) return opening + *formula + "}";
    const auto text = prose(words, face);
    if (!text) return std::nullopt;
    return opening + "\\mbox{\\kgscript " + *text + "}}";
}

/// The letter under the dots of a derivative.
std::string dotted(std::string letter, int dots) {
    for (; dots > 1; dots -= 2) letter = "\\ddot{" + letter + "}";
    return dots == 1 ? "\\dot{" + letter + "}" : letter;
}

/// One piece without text in another colour.
std::optional<std::string> whole(const Piece& piece) {
    const auto sub = script('_', piece.sub, piece.sub_face), sup = script('^', piece.sup, piece.sup_face);
    if (!sub || !sup) return std::nullopt;
    const std::string scripts = *sub + *sup;
    const bool slanted = piece.face == Face::italic || piece.face == Face::bold_italic;
    const bool heavy = piece.face == Face::bold || piece.face == Face::bold_italic;
    const auto formula = [&](const std::string& tex, const std::string& behind) {
        // TeX would set a subscript below the prime, not after it.
        const char* apart = tex.ends_with('\'') && !behind.empty() ? "{}" : "";
        return "$" + (heavy && !tex.empty() ? "\\kgbold{" + tex + "}" : tex) + apart + behind + "$";
    };
    if (piece.dots > 0) {
        // The dots stand over the last letter.
        const std::u32string text = characters_of(piece.text);
        std::string before, last;
        for (std::size_t i = 0; i < text.size(); ++i) append_utf8(i + 1 < text.size() ? before : last, text[i]);
        const auto first = prose(before, piece.face);
        const auto letter = mathematics(last, piece.face);
        if (!first || !letter) return std::nullopt;
        return *first + formula(dotted(*letter, piece.dots), scripts);
    }
    if (slanted)
        if (const auto letters = mathematics(piece.text, piece.face); letters && !letters->empty())
            return formula(*letters, scripts);
    const auto words = prose(piece.text, piece.face);
    if (!words) return std::nullopt;
    return scripts.empty() ? *words : *words + formula("", "{}" + scripts);
}

/// A run of a piece with the spaces before it.
struct Stretch {
    std::size_t blanks = 0;
    std::size_t begin = 0, end = 0;  // byte range in the piece's text
};

/// A piece divided at its spaces: at least one run, and the spaces after the last one.
struct Stretches {
    std::vector<Stretch> all;
    std::size_t blanks_behind = 0;
};

/// The words of a text, or everything from its first word to its last as one run.
Stretches stretches_of(std::string_view text, bool word_by_word) {
    Stretches found;
    Stretch now;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t from = at;
        if (parts_words(next_code_point(text, at))) {
            ++found.blanks_behind;
            continue;
        }
        const bool is_next = now.end > now.begin && found.blanks_behind > 0 && word_by_word;
        if (is_next) found.all.push_back(now);
        if (is_next || now.end == now.begin) now = {found.blanks_behind, from, at};
        now.end = at;
        found.blanks_behind = 0;
    }
    found.all.push_back(now);
    return found;
}

/// Builds a line word by word.
class WordByWord {
public:
    explicit WordByWord(const NameOfColour& name_of) : name_of_(name_of) {}

    /// False if TeX lacks letters of the piece. `said`: byte offset of the piece in the line's text.
    bool take(const Piece& piece, std::size_t said) {
        // Inside braces TeX finds no space between words.
        const auto [stretches, blanks_behind] =
            stretches_of(piece.text, piece.face == Face::regular && !piece.coloured);
        for (const Stretch& stretch : stretches) {
            Piece part = piece;
            part.text = piece.text.substr(stretch.begin, stretch.end - stretch.begin);
            if (&stretch != &stretches.back()) {  // the scripts follow the last run
                part.dots = 0;
                part.sub.clear();
                part.sup.clear();
            }
            const auto set = whole(part);
            if (!set) return false;
            blanks_ += stretch.blanks;
            if (!set->empty())
                put(piece.coloured ? "{\\color{" + name_of_(piece.colour) + "}" + *set + "}" : *set,
                    said + stretch.begin);
        }
        blanks_ += blanks_behind;
        return true;
    }

    std::vector<TexWord> words() && { return std::move(words_); }

private:
    void put(const std::string& tex, std::size_t at) {
        if (words_.empty()) {
            words_.push_back({tex, at, 0});
        } else if (blanks_ == 0) {
            words_.back().tex += tex;
        } else {
            std::string kept;
            for (std::size_t i = 1; i < blanks_; ++i) kept += "\\ ";
            words_.push_back({kept + tex, at, blanks_ - 1});
        }
        blanks_ = 0;
    }

    const NameOfColour& name_of_;
    std::vector<TexWord> words_;
    std::size_t blanks_ = 0;  // after the last word
};

}  // namespace

std::optional<std::vector<TexWord>> tex_words_of(const RichText& text, const NameOfColour& name_of) {
    WordByWord line(name_of);
    std::size_t said = 0;
    for (const Piece& piece : text) {
        if (!line.take(piece, said)) return std::nullopt;
        said += plain({piece}).size();
    }
    return std::move(line).words();
}

std::string line_of(const std::vector<TexWord>& words) {
    std::string line;
    for (const TexWord& word : words) line += (line.empty() ? "" : " ") + word.tex;
    return line;
}

std::optional<std::string> tex_of(const RichText& text, const NameOfColour& name_of) {
    const auto words = tex_words_of(text, name_of);
    return words ? std::optional(line_of(*words)) : std::nullopt;
}

}  // namespace kinegraph::render
