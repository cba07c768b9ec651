// Words: sets the sentences of lang/*.txt with their arguments, symbols and numbers. How a sentence is written there is
// said at the top of lang/en.txt. Independent of pages.
#include "render/text/words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>

#include "engine/number/assert.hpp"
#include "lang/keys/cases.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/sheet.hpp"
#include "lang/pattern.hpp"
#include "render/text/formula.hpp"
#include "render/text/rich_text.hpp"

namespace kinegraph::render {
namespace {

bool digits_only(std::string_view text) {
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](char c) { return (c >= '0' && c <= '9') || c == ',' || c == '.'; });
}

/// A word, such as "cut" or "Gas2", describes and is upright; the letters of points and bodies are italic, as AB or b.
bool is_word(std::string_view text) {
    std::size_t small = 0;  // letters in a row that are no capitals
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte & 0xC0U) == 0x80U) continue;  // within a character
        small = (c >= 'a' && c <= 'z') || byte >= 0x80U ? small + 1 : 0;
        if (small == 2) return true;
    }
    return false;
}

Piece piece(std::string_view text, Face face = Face::regular) {
    Piece result;
    result.text = text;
    result.face = face;
    return result;
}

/// A point's name as in textbooks: italic, with the number of O2 as a subscript.
RichText point_name(std::string_view name) {
    std::size_t digits = name.size();
    std::string_view tail;
    while (digits > 0 && (name[digits - 1] == '*' || name[digits - 1] == '\'')) --digits;
    tail = name.substr(digits);
    std::size_t letters = digits;
    while (letters > 0 && name[letters - 1] >= '0' && name[letters - 1] <= '9') --letters;
    std::string primes, raised_stars;
    for (const char c : tail) (c == '*' ? raised_stars : primes) += c == '*' ? "∗" : "′";
    const bool lowers = letters > 0 && letters < digits && name[letters - 1] != '.' && name[letters - 1] != '-';
    Piece result = piece(name.substr(0, lowers ? letters : digits), digits_only(name) ? Face::regular : Face::italic);
    result.text += primes;
    if (lowers) result.sub = name.substr(letters, digits - letters);
    result.sub_face = Face::regular;
    if (lowers)
        result.sup = raised_stars;
    else
        result.text += std::string(static_cast<std::size_t>(std::count(tail.begin(), tail.end(), '*')), '*');
    return {result};
}

std::string lower_case(std::string_view name) {
    std::string out;
    for (const char c : name) out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return out;
}

/// A no-break space.
constexpr const char* unbroken_blank = "\u00A0";

/// "lbf in", without a line break.
std::string unbroken(std::string unit) {
    for (std::size_t at = unit.find(' '); at != std::string::npos; at = unit.find(' ', at))
        unit.replace(at, 1, unbroken_blank);
    return unit;
}

/// Symbols as in the figures, or names as spelt in files and commands.
enum class Setting { typeset, spelt };

/// Typesets an argument of a sentence, by an overload per type.
class ArgumentSetter {
public:
    ArgumentSetter(Language language, Setting setting) : language_(language), setting_(setting) {}

    RichText operator()(const PointName& value) const { return name(value.name); }
    RichText operator()(const BodyName& value) const {
        return value.as == BodyName::As::pin ? name(value.name) : RichText{piece(value.name)};
    }
    RichText operator()(const JointName& value) const {
        return value.own ? RichText{piece(value.name)} : name(value.name);
    }
    RichText operator()(const Count& value) const {
        return {piece((value.value < 0 ? "−" : "") + std::to_string(std::abs(value.value)))};
    }
    RichText operator()(const Symbol& value) const {
        return setting_ == Setting::spelt ? RichText{piece(name_of(value))} : typeset(value, language_);
    }
    RichText operator()(const Names& value) const {
        return in_a_row(value, [&](const std::string& each) { return name(each); });
    }
    RichText operator()(const Symbols& value) const { return in_a_row(value, *this); }
    RichText operator()(const Ratios& value) const { return in_a_row(value, *this); }
    RichText operator()(const Ratio& value) const {
        constexpr int digits = 5;
        RichText text = (*this)(value.above);
        text.push_back(piece("/"));
        append(text, (*this)(value.below));
        text.push_back(piece(" = " + number(value.value, digits, language_)));
        return text;
    }
    RichText operator()(const kinegraph::Segment& value) const {
        RichText text = name(value.from);
        append_point(text, name(value.to));
        return text;
    }
    RichText operator()(const std::string& value) const { return {piece(value)}; }
    RichText operator()(const Amount& value) const {
        return {piece(number(value.value, 3, language_) + blank() +
                      (setting_ == Setting::typeset ? unbroken(value.unit) : value.unit))};
    }
    RichText operator()(const RollingLever& value) const {
        if (value == RollingLever::on_straight) return {piece("r", Face::italic)};
        return {piece("R" + blank() + "r", Face::italic),
                piece("/("),
                piece("R", Face::italic),
                piece(blank() + (value == RollingLever::outside ? "+" : "−") + blank()),
                piece("r", Face::italic),
                piece(")")};
    }
    RichText operator()(const LineReason& value) const {
        RichText text = typeset(value, language_);
        if (!text.empty() && text.front().text.ends_with(' '))
            text.front().text.replace(text.front().text.size() - 1, 1, blank());
        return text;
    }

private:
    std::string blank() const { return setting_ == Setting::typeset ? unbroken_blank : " "; }
    RichText name(const std::string& of) const {
        return setting_ == Setting::spelt ? RichText{piece(of)} : point_name(of);
    }
    template <class Members, class Set>
    static RichText in_a_row(const Members& members, const Set& set) {
        RichText text;
        for (const auto& member : members) {
            if (!text.empty()) text.push_back(piece(", "));
            append(text, set(member));
        }
        return text;
    }

    Language language_;
    Setting setting_;
};

RichText argument(const Argument& arg, Language language, Setting setting) {
    return std::visit(ArgumentSetter(language, setting), arg);
}

/// What a sentence names: its case has a form for each.
enum class Named { body, several_bodies, truss, pin };
Named named_by(const Argument& arg) {
    const auto* body = std::get_if<BodyName>(&arg);
    switch (body == nullptr ? BodyName::As::body : body->as) {
        case BodyName::As::bodies: return Named::several_bodies;
        case BodyName::As::truss: return Named::truss;
        case BodyName::As::pin: return Named::pin;
        case BodyName::As::body:
        case BodyName::As::with_pin: break;
    }
    return Named::body;
}
/// The form of a case of the language (section cases); with a capital where the pattern writes one.
std::string form_of_case(const Argument& arg, std::string_view grammatical_case, Language language) {
    std::string name(grammatical_case);
    const bool has_capital = std::isupper(static_cast<unsigned char>(name.front())) != 0;
    if (has_capital) name.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
    const std::string* forms = lang::cases_section.find(name, language);
    KG_ASSERT(forms != nullptr, "the language has the case " + name);
    std::string_view form = *forms;
    for (auto before = static_cast<int>(named_by(arg)); before > 0; --before) form.remove_prefix(form.find('|') + 1);
    form = form.substr(0, form.find('|'));
    while (form.starts_with(' ')) form.remove_prefix(1);
    while (form.ends_with(' ')) form.remove_suffix(1);
    std::string text(form);
    if (has_capital) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
}

bool is_empty(const Argument& arg) {
    if (const auto* text = std::get_if<std::string>(&arg)) return text->empty();
    if (const auto* point = std::get_if<PointName>(&arg)) return point->name.empty();
    if (const auto* body = std::get_if<BodyName>(&arg)) return body->name.empty();
    if (const auto* joint = std::get_if<JointName>(&arg)) return joint->name.empty();
    if (const auto* names = std::get_if<Names>(&arg)) return names->empty();
    if (const auto* symbols = std::get_if<Symbols>(&arg)) return symbols->empty();
    return false;
}

bool is_one(const Argument& arg) {
    if (std::holds_alternative<BodyName>(arg)) return named_by(arg) != Named::several_bodies;
    if (const auto* count = std::get_if<Count>(&arg)) return count->value == 1;
    if (const auto* names = std::get_if<Names>(&arg)) return names->size() == 1;
    if (const auto* symbols = std::get_if<Symbols>(&arg)) return symbols->size() == 1;
    return false;
}

/// Typesets a pattern with its arguments, part by part.
class PatternSetter {
public:
    PatternSetter(const std::vector<Argument>& arguments, Language language, Setting setting,
                  const BeforeLine& before_line)
        : arguments_(arguments), language_(language), setting_(setting), before_line_(before_line) {}

    /// Text between [ and ] is omitted if one of its arguments is missing.
    RichText set(std::string_view pattern) {
        for (std::size_t i = 0; i < pattern.size();) {
            const char first = pattern[i];
            const auto place = lang::place_at(pattern, i);
            if (!place) behind_point_ = false;
            if (place) {
                put_place(*place);
                i = place->end;
            } else if (first == '{')
                i = put_letter(pattern, i);
            else if (first == '[')
                i = put_optional_part(pattern, i);
            else
                i += put_text(pattern.substr(i));
        }
        flush();
        return std::move(to_);
    }
    bool all_given() const { return all_given_; }

private:
    void flush() {
        if (!plain_text_.empty()) to_.push_back(piece(plain_text_));
        plain_text_.clear();
    }

    /// "{m}", a letter of a formula, at `begin`; returns the index after it.
    std::size_t put_letter(std::string_view pattern, std::size_t begin) {
        const std::size_t behind = pattern.find('}', begin) + 1;
        flush();
        append(to_, formula(pattern.substr(begin, behind - begin)));
        return behind;
    }
    void put_place(const lang::Place& place) {
        const bool given = place.argument < arguments_.size() && !is_empty(arguments_[place.argument]);
        if (place.chooses)
            plain_text_ += given && is_one(arguments_[place.argument]) ? place.one : place.several;
        else if (given && !place.grammatical_case.empty())
            put_in_case(arguments_[place.argument], place.grammatical_case);
        else if (given)
            put_argument(arguments_[place.argument]);
        else
            all_given_ = false;
    }
    /// "on body 2", "on bodies 2 + 3", "on the truss", "on pin C": by what carries the name.
    void put_in_case(const Argument& value, std::string_view grammatical_case) {
        const std::string form = form_of_case(value, grammatical_case, language_);
        lang::for_each_part(
            form, [&](std::string_view part) { plain_text_ += part; },
            [&](const lang::Place&, std::string_view) { put_argument(value); });
    }
    void put_argument(const Argument& value) {
        flush();
        const auto* line = std::get_if<LineReason>(&value);
        if (line && before_line_) to_.push_back(piece(before_line_(*line)));
        const bool is_point = std::holds_alternative<PointName>(value);
        const RichText text = argument(value, language_, setting_);
        if (is_point && behind_point_)
            append_point(to_, text);
        else
            append(to_, text);
        behind_point_ = is_point;
    }

    std::size_t put_optional_part(std::string_view pattern, std::size_t begin) {
        const std::size_t end = pattern.find(']', begin);
        flush();
        PatternSetter inner(arguments_, language_, setting_, before_line_);
        const RichText part = inner.set(pattern.substr(begin + 1, end - begin - 1));
        if (inner.all_given()) append(to_, part);
        return end + 1;
    }

    /// Returns how many bytes of `rest` were handled.
    std::size_t put_text(std::string_view rest) {
        constexpr std::string_view omega = "ω", alpha = "α", squared = "²";
        if (rest.starts_with('~')) {
            plain_text_ += setting_ == Setting::typeset ? unbroken_blank : " ";
            return 1;
        }
        if (rest.starts_with(omega)) {
            flush();
            to_.push_back(piece(omega, Face::italic));
            return omega.size();
        }
        if (rest.starts_with(alpha)) {
            flush();
            append(to_, typeset(Symbol{Symbol::Letter::alpha, "", ""}, language_));
            return alpha.size();
        }
        if (rest.starts_with(squared) && plain_text_.empty() && !to_.empty()) {
            to_.back().sup = "2";
            return squared.size();
        }
        plain_text_ += rest.front();
        return 1;
    }

    const std::vector<Argument>& arguments_;
    Language language_;
    Setting setting_;
    BeforeLine before_line_;
    bool all_given_ = true;
    bool behind_point_ = false;  ///< directly: two consecutive points name a line
    std::string plain_text_;
    RichText to_;
};

std::string superscript(int value) {
    static constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string out;
    for (const char c : std::to_string(value)) out += c == '-' ? "⁻" : digits[static_cast<std::size_t>(c - '0')];
    return out;
}

/// A decimal of to_chars in the notation of the language.
std::string dressed(std::string_view decimal, Language language) {
    std::string out;
    for (const char c : decimal) {
        if (c == '-')
            out += "−";
        else if (c == '.')
            out += notation(language).decimal_mark;
        else
            out += c;
    }
    return out;
}

/// "0.64", "1.309": `digits` significant digits, without trailing zeros.
std::string factor(double value, Language language) {
    constexpr int digits = 4;
    std::string text = number(value, digits, Language::en);
    const std::size_t power = std::min(text.find(' '), text.size());
    std::string digits_alone = text.substr(0, power);
    if (digits_alone.find('.') != std::string::npos) {
        digits_alone.erase(digits_alone.find_last_not_of('0') + 1);
        if (digits_alone.ends_with('.')) digits_alone.pop_back();
    }
    return dressed(digits_alone + text.substr(power), language);
}

/// With brackets where a power of ten would merge with its neighbours: (1.2 × 10⁵)², 3/(1.2 × 10⁵).
std::string bracketed(double value, Language language) {
    const std::string text = factor(value, language);
    return text.find(' ') == std::string::npos ? text : "(" + text + ")";
}

/// "−4 · 0.5²": one sign, followed by the moduli of the factors; "4 · (−0.5)" where the sign is a factor's own.
std::string product_of(const std::vector<Working::Factor>& factors, Language language) {
    double sense = 1;
    for (const Working::Factor& each : factors) sense *= each.value < 0 && !each.squared && !each.own_sign ? -1 : 1;
    std::string product = sense < 0 ? "−" : "";
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const double size = std::abs(factors[i].value);
        product += (i > 0 ? std::string(unbroken_blank) + "·" + unbroken_blank : "") +
                   (factors[i].squared                            ? bracketed(size, language) + "²"
                    : factors[i].own_sign && factors[i].value < 0 ? "(−" + factor(size, language) + ")"
                                                                  : factor(size, language));
    }
    return product;
}

/// "18.89 · 3 − 20 · 4" for forces and arms, "12 − 3.5" for plain summands; a long sum breaks before a sign.
std::string sum_of(const Working& working, Language language) {
    std::string sum;
    for (std::size_t i = 0; i < working.summands.size(); ++i) {
        const double one = i < working.factors.size() ? working.factors[i].value : working.summands[i];
        const char* sign = one < 0 ? "−" : i > 0 ? "+" : "";
        sum += i > 0 ? std::string(" ") + sign + unbroken_blank : std::string(sign);
        sum += factor(std::abs(one), language);
        if (i < working.factors.size())
            sum += std::string(unbroken_blank) + "·" + unbroken_blank + factor(working.summands[i], language);
    }
    return sum;
}

std::string result_of(const Working& working, Language language) {
    constexpr int digits = 3;
    std::string result = number(working.result.value, digits, language);
    if (working.result.value != 0) result += unbroken_blank + unbroken(working.result.unit);
    return result;
}

/// "ω_3 = −0.1963/0.15 = −1.31 rad/s": one sign, followed by the moduli of the factors.
RichText worked_out(const Working& working, Language language) {
    RichText text = typeset(working.of, language);
    for (Piece& each : text)
        if (each.face == Face::bold_italic) each.face = Face::italic;  // the modulus of a vector
    const std::string equals = std::string(unbroken_blank) + "=" + unbroken_blank;
    std::string product = working.summands.empty() ? product_of(working.factors, language) : sum_of(working, language);
    if (working.divisor) product += "/" + bracketed(*working.divisor, language);
    const std::string result = result_of(working, language);
    append(text, with_powers(equals + (product.empty() ? "" : product + " =" + unbroken_blank) + result));
    if (working.turned) {
        append(text, {piece(", ")});
        append(text, typeset(working.turned->velocity, language));
        append(text, {piece(word(lang::sheet::turned_with, language))});
        append(text, typeset(working.turned->with, language));
    }
    return text;
}

/// In sequence; the same quantity in another unit is appended, "… = −19.8 rad/s = −189 rpm".
std::vector<RichText> worked_out(const std::vector<Working>& worked_arithmetic, Language language) {
    std::vector<RichText> all;
    for (std::size_t i = 0; i < worked_arithmetic.size(); ++i)
        if (i > 0 && worked_arithmetic[i].of == worked_arithmetic[i - 1].of)
            append(all.back(),
                   with_powers(" =" + std::string(unbroken_blank) + result_of(worked_arithmetic[i], language)));
        else
            all.push_back(worked_out(worked_arithmetic[i], language));
    return all;
}

bool is_all_zero(std::string_view decimal) {
    return std::none_of(decimal.begin(), decimal.end(), [](char c) { return c >= '1' && c <= '9'; });
}

}  // namespace

RichText say(const Message& message, Language language) { return say(message, language, {}); }
RichText say(const Message& message, Language language, const BeforeLine& before_line) {
    RichText text =
        PatternSetter(message.arguments, language, Setting::typeset, before_line).set(message.sentence.in(language));
    const std::vector<RichText> worked_arithmetic = worked_out(message.worked_arithmetic, language);
    for (std::size_t i = 0; i < worked_arithmetic.size(); ++i) {
        text.push_back(piece(i == 0 ? " " : word(lang::notation::semicolon, language)));
        append(text, worked_arithmetic[i]);
    }
    if (!message.worked_arithmetic.empty()) text.push_back(piece("."));
    return text;
}

RichText say_likewise(const std::vector<const Message*>& messages, Language language) {
    RichText text = {piece(word(lang::sheet::likewise, language) + " ")};
    bool first = true;
    for (const Message* message : messages) {
        const auto part = [&](const RichText& said) {
            if (!std::exchange(first, false)) text.push_back(piece(word(lang::notation::semicolon, language)));
            append(text, said);
        };
        for (const RichText& working : worked_out(message->worked_arithmetic, language)) part(working);
        if (!message->worked_arithmetic.empty()) continue;
        // The body, and what it is connected to.
        RichText said = {piece(word(lang::sheet::body, language) + unbroken_blank)};
        for (std::size_t i = 0; i < message->arguments.size(); ++i) {
            if (i > 0) said.push_back(piece(i == 1 ? " (" : ", "));
            append(said, argument(message->arguments[i], language, Setting::typeset));
        }
        if (message->arguments.size() > 1) said.push_back(piece(")"));
        part(said);
    }
    text.push_back(piece("."));
    return text;
}

std::string tell(const Message& message, Language language) {
    return plain(PatternSetter(message.arguments, language, Setting::spelt, {}).set(message.sentence.in(language)));
}

/// A load that the file calls P_1 keeps its letter, instead of F with a subscript P_1.
bool has_letter(const Symbol& symbol) {
    const std::string& name = symbol.about;
    return (symbol.letter == Symbol::Letter::F || symbol.letter == Symbol::Letter::M) && name.size() > 2 &&
           name[1] == '_' && std::isupper(static_cast<unsigned char>(name[0])) != 0;
}

RichText typeset(const Symbol& symbol, Language language) {
    using Letter = Symbol::Letter;
    if (symbol.letter == Letter::point || symbol.letter == Letter::length) return point_name(symbol.about);
    if (symbol.letter == Letter::image) return point_name(lower_case(symbol.about) + (symbol.term == "'" ? "'" : ""));
    if (symbol.letter == Letter::body) return {piece(symbol.about)};

    Piece result;
    result.face = Face::italic;
    switch (symbol.letter) {
        case Letter::pole: result.text = "o"; break;
        case Letter::v:
            result.text = "v";
            result.face = Face::bold_italic;
            break;
        case Letter::a:
            result.text = "a";
            result.face = Face::bold_italic;
            break;
        case Letter::omega: result.text = "ω"; break;
        case Letter::alpha:
            result.text = notation(language).alpha;
            result.dots = notation(language).alpha_dots;
            break;
        case Letter::centre: result.text = notation(language).centre; break;
        case Letter::radius: result.text = "ρ"; break;
        case Letter::diameter: result.text = "δ"; break;
        case Letter::error: result.text = "ε"; break;
        case Letter::F:
            result.text = "F";
            result.face = Face::bold_italic;
            break;
        case Letter::M: result.text = "M"; break;
        case Letter::speed:
            result.text = "s";
            result.dots = 1;
            break;
        default: KG_ASSERT(false, "a symbol has a letter");
    }
    result.sub = symbol.about;
    // A force that the file calls F_gas or M keeps its name, instead of F with a subscript F_gas.
    if (has_own_name(symbol)) {
        result.text = result.sub[0];
        result.sub.erase(0, result.sub.find('_') == 1 ? 2 : 1);
    } else if (has_letter(symbol)) {
        result.text = result.sub[0];
        result.sub.erase(0, 2);
    }
    // g (weight) and i (inertia) are abbreviations, not quantities, hence upright.
    const bool of_body = symbol.letter == Letter::F && !result.sub.empty() &&
                         (result.sub[0] == 'g' || result.sub[0] == 'i') &&
                         (result.sub.size() == 1 || digits_only(result.sub.substr(1)));
    result.sub_face = of_body || digits_only(result.sub) || is_word(result.sub) ? Face::regular : Face::italic;
    if (is_moved_aside(symbol))
        result.text += symbol.term;  // a prime belongs to the letter
    else
        result.sup = notation(language).term(symbol.term);
    return {result};
}

RichText typeset(const LineReason& reason, Language language) {
    const bool perpendicular = reason.kind == LineReason::Kind::perpendicular_to_segment ||
                               reason.kind == LineReason::Kind::perpendicular_to_guide;
    if (reason.kind == LineReason::Kind::known) return {piece(word(lang::sheet::known, language))};
    RichText text{piece(perpendicular ? "⟂ " : "∥ ")};
    switch (reason.kind) {
        case LineReason::Kind::perpendicular_to_segment:
        case LineReason::Kind::parallel_to_segment:
            append(text, point_name(reason.from));
            append_point(text, point_name(reason.to));
            return text;
        case LineReason::Kind::parallel_to_guide:
        case LineReason::Kind::perpendicular_to_guide: text.back().text += word(lang::sheet::guide, language); break;
        case LineReason::Kind::driver_component: text = {piece("⟂ " + word(lang::sheet::drive, language))}; break;
        case LineReason::Kind::parallel_to_locus: text.back().text += word(lang::sheet::locus, language); break;
        case LineReason::Kind::given_direction: text.back().text += word(lang::sheet::given_line, language); break;
        case LineReason::Kind::parallel_to_tangent: text.back().text += word(lang::sheet::tangent, language); break;
        case LineReason::Kind::parallel_to_normal: text.back().text += word(lang::sheet::normal, language); break;
        case LineReason::Kind::known: break;
    }
    if (reason.from.empty()) return text;
    // A name that states its kind needs no word before it: "∥ guide 2".
    if (reason.own_name && reason.from.starts_with(word(lang::sheet::guide, language)))
        return {piece((perpendicular ? "⟂ " : "∥ ") + reason.from)};
    text.back().text += " ";
    append(text, reason.own_name ? RichText{piece(reason.from)} : point_name(reason.from));
    if (!reason.to.empty()) append(text, " (" + reason.to + ")");
    return text;
}

std::string number(double value, int digits, Language language) {
    KG_ASSERT(digits >= 1 && digits <= 17, "a number has 1 to 17 digits");
    if (!std::isfinite(value)) return "–";
    if (value == 0) return "0";
    char buffer[64];
    const auto scientific =
        std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific, digits - 1);
    std::string_view text(buffer, static_cast<std::size_t>(scientific.ptr - buffer));
    const std::size_t e = text.find('e');
    const int exponent = std::atoi(std::string(text.substr(e + 1)).c_str());
    if (exponent < -3 || exponent >= std::max(digits, 5))
        return dressed(text.substr(0, e), language) + " × 10" + superscript(exponent);
    char fixed_buffer[64];
    const auto end = std::to_chars(fixed_buffer, fixed_buffer + sizeof fixed_buffer, value, std::chars_format::fixed,
                                   std::max(0, digits - 1 - exponent));
    return dressed({fixed_buffer, static_cast<std::size_t>(end.ptr - fixed_buffer)}, language);
}

std::string fixed(double value, int decimals, Language language) {
    if (!std::isfinite(value)) return "–";
    char buffer[400];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals);
    std::string_view text(buffer, static_cast<std::size_t>(end.ptr - buffer));
    if (text.starts_with('-') && is_all_zero(text)) text.remove_prefix(1);  // no −0.00
    return dressed(text, language);
}

std::string pair_of(const std::string& x, const std::string& y, Language language) {
    return "(" + x + notation(language).between_numbers + y + ")";
}

std::string shortest(double value) {
    char buffer[64];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value == 0 ? 0.0 : value);
    return {buffer, end.ptr};
}

std::string shortest(double value, Language language) {
    for (int digits = 1; digits < 17; ++digits) {
        const std::string text = number(value, digits, Language::en);
        char buffer[64];
        const auto end =
            std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific, digits - 1);
        double back = 0;
        std::from_chars(buffer, end.ptr, back);
        if (back == value) return number(value, digits, language);
    }
    return number(value, 17, language);
}

std::string verdict_words(const Mobility& mobility, Language language) {
    const auto times = [&](Key key) {
        const int count = mobility.repeated();
        return word(key, language) + ", " + std::to_string(count) + " " +
               word(count == 1 ? lang::sheet::time : lang::sheet::times, language);
    };
    switch (mobility.verdict()) {
        case Mobility::Verdict::mechanism: return word(lang::sheet::verdict_mechanism, language);
        case Mobility::Verdict::isostatic: return word(lang::sheet::verdict_isostatic, language);
        case Mobility::Verdict::hyperstatic: return times(lang::sheet::verdict_hyperstatic);
        case Mobility::Verdict::labile: return word(lang::sheet::verdict_labile, language);
    }
    KG_ASSERT(false, "a mobility has a verdict");
}

std::string word(Key key, Language language) { return key.in(language); }

RichText word(Key key, const std::vector<RichText>& parts, Language language) {
    RichText text;
    lang::for_each_part(
        key.in(language), [&](std::string_view part) { append(text, one_piece(std::string(part))); },
        [&](const lang::Place& place, std::string_view) {
            KG_ASSERT(place.argument < parts.size(), "the text " + key.name() + " has a part for each of its places");
            append(text, parts[place.argument]);
        });
    return text;
}

}  // namespace kinegraph::render
