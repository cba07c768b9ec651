// The built-in themes, and the reader of user themes with its error messages.
#include "render/page/theme.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <string>
#include <utility>

#include "engine/file/json_source.hpp"
#include "engine/file/spelling.hpp"
#include "engine/file/units.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/themes.hpp"
#include "render/page/body_colours.hpp"

namespace kinegraph::render {
namespace {

/// Black, one grey and the paper colour, for copiers and books in one ink: the tint of a body is the paper colour.
Theme print() {
    constexpr Colour black{0x00, 0x00, 0x00}, grey{0x6E, 0x6E, 0x6E}, white{0xFF, 0xFF, 0xFF};
    Theme theme;
    theme.in_one_ink = true;
    theme.bodies.clear();
    theme.paper = white;
    theme.text = black;
    theme.secondary = theme.skeleton = theme.faint = grey;
    theme.accent = theme.text;
    for (const std::vector<double>& dashes :
         {std::vector<double>{}, {3.2, 1.1}, {0.8, 0.8}, {3.2, 0.8, 0.8, 0.8}, {3.2, 0.8, 0.8, 0.8, 0.8, 0.8}})
        for (const Colour ink : {black, grey}) theme.bodies.push_back({ink, white, ink, dashes});
    return theme;
}

/// Light on a dark ground, for slides. The lines are as distinct as in the colour theme, for colour-blind readers and
/// in grey.
Theme dark() {
    Theme theme;
    theme.paper = {0x15, 0x17, 0x1C};
    theme.text = {0xEC, 0xEC, 0xEF};
    theme.secondary = {0xA6, 0xAA, 0xB4};
    theme.accent = {0xFF, 0x7F, 0xD0};
    theme.skeleton = {0x7C, 0x81, 0x8E};
    theme.faint = {0x4A, 0x4F, 0x5A};
    theme.bodies = with_line_kinds({{{0xD1, 0x89, 0x3E}, {0x33, 0x29, 0x21}, {0xE2, 0x9B, 0x52}},
                                    {{0xF7, 0xD0, 0x35}, {0x39, 0x35, 0x20}, {0xF7, 0xD0, 0x35}},
                                    {{0x72, 0x66, 0xF6}, {0x24, 0x24, 0x3F}, {0x9C, 0x93, 0xFF}},
                                    {{0x4D, 0xC9, 0x97}, {0x1E, 0x33, 0x30}, {0x4D, 0xC9, 0x97}},
                                    {{0xE2, 0xF4, 0xFF}, {0x36, 0x3A, 0x40}, {0xE2, 0xF4, 0xFF}}},
                                   {{{0x90, 0x2A, 0x7E}, {0x29, 0x1A, 0x2C}, {0xD0, 0x78, 0xC0}},
                                    {{0x96, 0xBA, 0xE4}, {0x2A, 0x31, 0x3C}, {0x96, 0xBA, 0xE4}},
                                    {{0x0C, 0x7E, 0x4E}, {0x14, 0x27, 0x24}, {0x3C, 0xA8, 0x76}},
                                    {{0xA8, 0x72, 0xD8}, {0x2D, 0x26, 0x3A}, {0xB4, 0x86, 0xE0}},
                                    {{0xA2, 0xFC, 0xA8}, {0x2C, 0x3C, 0x32}, {0xA2, 0xFC, 0xA8}}});
    return theme;
}

using Names = std::vector<std::string_view>;

std::string listed(const Names& names) {
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) list += i + 1 == names.size() ? " and " : ", ";
        list += quoted(names[i]);
    }
    return list;
}

/// Suggests a correction of a misspelt word, or lists all possibilities.
Words remedy(std::string_view word, const Names& names, const Words& all) {
    constexpr std::size_t near = 2;
    std::size_t least = near + 1;
    std::string_view best;
    for (const std::string_view name : names)
        if (const std::size_t distance = edit_distance(word, name, near); distance < least && distance < name.size()) {
            least = distance;
            best = name;
        }
    return best.empty() ? Words(lang::themes::are_the_others, all, listed(names))
                        : Words(lang::common::did_you_mean, quoted(best));
}

class ThemeReader {
public:
    explicit ThemeReader(const JsonSource& source) : source_(source) {}

    Result<Theme> read() {
        for (const JsonValue& twice : source_.duplicates())
            fault(twice, {lang::themes::stands_twice_in_this_object_take, quoted(twice.key())});
        const JsonValue root = source_.root();
        if (is_object(root, {lang::themes::a_theme})) read_theme(root);
        if (errors_.empty()) return std::move(theme_);
        return tl::make_unexpected(std::move(errors_));
    }

private:
    void fault(JsonValue at, Words message) {
        errors_.push_back({ErrorCode::bad_input, at.pointer(), std::move(message)});
    }

    bool is_object(JsonValue value, const Words& what) {
        if (!value.is_object()) fault(value, {lang::themes::is_a_json_object, what});
        return value.is_object();
    }

    void check_keys(JsonValue object, const Names& known, const Words& all) {
        for (const JsonValue member : object)
            if (std::find(known.begin(), known.end(), member.key()) == known.end())
                fault(member, {lang::themes::unknown_key, quoted(member.key()), remedy(member.key(), known, all)});
    }

    void read_theme(JsonValue root) {
        if (const JsonValue base = root["based on"]) {
            auto named = base.is_string() ? built_in_theme(base.text()) : std::nullopt;
            if (named)
                theme_ = *std::move(named);
            else if (base.is_string())
                fault(base, {lang::themes::no_theme_is_named, quoted(base.text()),
                             remedy(base.text(), theme_names(), {lang::themes::the_built_in_themes})});
            else
                fault(base, {lang::themes::the_name_of_a_built, listed(theme_names())});
        }
        check_keys(root, {"based on", "paper", "text", "secondary", "skeleton", "faint", "accent", "bodies", "lines"},
                   {lang::themes::the_keys_of_a_theme});
        read(root["paper"], theme_.paper);
        read(root["text"], theme_.text);
        read(root["secondary"], theme_.secondary);
        read(root["accent"], theme_.accent);
        read(root["skeleton"], theme_.skeleton);
        read(root["faint"], theme_.faint);
        if (const JsonValue bodies = root["bodies"]) read_bodies(bodies);
        if (const JsonValue lines = root["lines"]; lines && is_object(lines, std::string_view("\"lines\""))) {
            check_keys(lines, {"link", "vector", "outline", "thin"}, {lang::themes::the_weights_of_line});
            read(lines["link"], theme_.link, 0.3, 4);
            read(lines["vector"], theme_.vector, 0.1, 2);
            read(lines["outline"], theme_.outline, 0.05, 1);
            read(lines["thin"], theme_.thin, 0.05, 0.7);
        }
    }

    void read_bodies(JsonValue list) {
        constexpr std::size_t most = 24;
        if (!list.is_array() || list.size() == 0 || list.size() > most) {
            fault(list, {lang::themes::n_1_to_24_bodies_are_wanted});
            return;
        }
        // Properties missing from a body come from the base theme.
        std::vector<BodyColour> bodies;
        for (const JsonValue each : list) {
            bodies.push_back(theme_.body(BodyIndex(bodies.size() + 1)));
            if (!is_object(each, {lang::themes::a_body_look})) continue;
            check_keys(each, {"line", "tint", "letter", "dashes"}, {lang::themes::the_keys_of_a_body_look});
            read(each["line"], bodies.back().line);
            read(each["tint"], bodies.back().tint);
            read(each["letter"], bodies.back().letter);
            if (const JsonValue dashes = each["dashes"]) read_dashes(dashes, bodies.back().dashes);
        }
        theme_.bodies = std::move(bodies);
    }

    void read_dashes(JsonValue list, std::vector<double>& dashes) {
        constexpr std::size_t most = 8;
        if (!list.is_array() || list.size() % 2 != 0 || list.size() > most) {
            fault(list, {lang::themes::an_even_number_of_lengths});
            return;
        }
        dashes.clear();
        for (const JsonValue each : list) {
            double measure = 0;
            read(each, measure, 0.2, 20);
            dashes.push_back(measure);
        }
    }

    void read(JsonValue value, Colour& colour) {
        if (!value) return;
        if (const auto written = value.is_string() ? colour_of_text(value.text()) : std::nullopt)
            colour = colour_of_number(*written);
        else
            fault(value, {lang::themes::a_colour_is_wanted_here});
    }

    void read(JsonValue value, double& measure, double least, double most) {
        if (!value) return;
        const std::string_view text = value.text();
        double number = 0;
        const bool written =
            value.is_number() && std::from_chars(text.data(), text.data() + text.size(), number).ec == std::errc{};
        if (written && number >= least && number <= most) {
            measure = number;
            return;
        }
        const auto plain = [](double bound) {
            char digits[16];
            return std::string(digits, std::to_chars(digits, digits + sizeof digits, bound).ptr);
        };
        fault(value, {lang::themes::a_length_from_to_mm, plain(least), plain(most)});
    }

    const JsonSource& source_;
    Theme theme_;
    Errors errors_;
};

}  // namespace

std::vector<BodyColour> with_line_kinds(std::vector<BodyColour> full, const std::vector<BodyColour>& dashed) {
    for (const BodyColour& each : dashed) {
        full.push_back(each);
        full.back().dashes = {3.6, 0.9};
    }
    return full;
}

const std::vector<std::string_view>& theme_names() {
    static const Names names{"colour", "print", "dark"};
    return names;
}

std::optional<Theme> built_in_theme(std::string_view name) {
    if (name == "colour") return Theme{};
    if (name == "print") return print();
    if (name == "dark") return dark();
    return std::nullopt;
}

Result<Theme> read_theme(std::string_view text) {
    const auto source = JsonSource::read(text);
    if (!source) return tl::make_unexpected(source.error());
    return ThemeReader(*source).read();
}

}  // namespace kinegraph::render
