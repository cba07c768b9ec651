#include "app/editor/suggestions.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace kinegraph::app {
namespace {

using Json = FileSchema::Json;
using Form = FileSchema::Form;
using Forms = FileSchema::Forms;
using Kind = Outline::Kind;

/// Where in the file's structure a byte stands.
struct Spot {
    std::uint32_t container = 0;           ///< the innermost object or array; 0: outside of all
    std::uint32_t member = Outline::none;  ///< whose key or value is here; none: one that is not there yet
    bool is_key = false;
    /// What is typed here, or nothing: begin = end.
    std::size_t begin = 0, end = 0;
    bool is_quoted = false;
};

class SpotFinder {
public:
    SpotFinder(const Outline& outline, std::size_t offset) : outline_(outline), offset_(offset) {}

    /// Empty between a value and its comma.
    std::optional<Spot> find() {
        Spot spot;
        for (std::uint32_t each = 0; each != Outline::none; each = inner(each)) spot.container = each;
        const bool in_object = outline_[spot.container].kind == Kind::object;
        std::uint32_t before = Outline::none;
        for (std::uint32_t each = outline_[spot.container].first_child; each != Outline::none;
             each = outline_[each].next) {
            const Outline::Node& node = outline_[each];
            spot.member = each;
            if (node.has_key() && stands(node.key_begin, node.key_end)) {
                spot.is_key = true;
                return typed(spot, node.key_begin, node.key_end);
            }
            if (node.kind != Kind::missing && stands(node.begin, node.end)) {
                spot.is_key = in_object && !node.has_key();
                return typed(spot, node.begin, node.end);
            }
            if ((node.has_key() ? node.key_begin : node.begin) < offset_) before = each;
        }
        spot.begin = spot.end = offset_;
        const std::size_t last = outline_.text().substr(0, offset_).find_last_not_of(" \t\r\n");
        const char sign = last == std::string_view::npos ? '\0' : outline_.text()[last];
        spot.member = sign == ':' ? before : Outline::none;
        spot.is_key = in_object && sign != ':';
        if (sign == ',' || sign == '{' || sign == '[' || (sign == ':' && before != Outline::none)) return spot;
        return std::nullopt;
    }

private:
    /// The child that is open around the byte.
    std::uint32_t inner(std::uint32_t container) const {
        for (std::uint32_t each = outline_[container].first_child; each != Outline::none; each = outline_[each].next) {
            const Outline::Node& node = outline_[each];
            const std::size_t last = node.is_closed ? node.end - 1 : node.end;
            if (node.is_container() && node.begin < offset_ && offset_ <= last) return each;
        }
        return Outline::none;
    }
    /// Whether the byte is within a word, or between the quotes of a text.
    bool stands(std::size_t begin, std::size_t end) const {
        const std::string_view text = outline_.text();
        if (text[begin] == '{' || text[begin] == '[') return false;
        if (text[begin] != '"') return begin <= offset_ && offset_ <= end;
        return begin < offset_ && offset_ < end + (is_closed(begin, end) ? 0 : 1);
    }
    bool is_closed(std::size_t begin, std::size_t end) const {
        return end - begin > 1 && outline_.text()[end - 1] == '"';
    }
    /// A text is replaced with its closing quote; one that has none only as far as it is typed, for what follows may
    /// be more than that.
    Spot typed(Spot spot, std::size_t begin, std::size_t end) const {
        spot.is_quoted = outline_.text()[begin] == '"';
        spot.begin = spot.is_quoted ? begin + 1 : begin;
        spot.end = !spot.is_quoted || is_closed(begin, end) ? end : offset_;
        return spot;
    }

    const Outline& outline_;
    std::size_t offset_;
};

void add_line(std::string& text, const std::string& line) {
    if (line.empty() || text.find(line) != std::string::npos) return;
    text += (text.empty() ? "" : "\n\n") + line;
}

/// What the key means, in objects of these forms.
std::string said_of(const FileSchema& schema, const Forms& objects, const std::string& key) {
    std::string text;
    for (const Form& each : objects) {
        const Forms forms = schema.forms_under({each}, key);
        if (forms.empty()) continue;
        if (each.leading_key() == key) add_line(text, each.description());
        for (const Form& form : forms) add_line(text, form.says);
        for (const Form& form : forms) add_line(text, form.description());
    }
    return text;
}

bool is_key_of(const Form& object, const std::string& key) {
    return object.has("properties") && (*object.schema)["properties"].contains(key);
}

/// A name that is written as an integer may stand without quotes.
bool is_whole_number(const std::string& name) {
    return !name.empty() && name.size() < 10 && name.find_first_not_of("0123456789") == std::string::npos &&
           (name == "0" || name.front() != '0');
}

class Suggesting {
public:
    Suggesting(const Outline& outline, std::size_t offset, const FileSchema& schema, const Spot& spot)
        : outline_(outline), offset_(offset), schema_(schema), spot_(spot) {}

    std::vector<Suggestion> all() {
        if (spot_.is_key)
            add_keys();
        else
            add_values();
        return std::move(found_);
    }

private:
    void add(Suggestion::Kind kind, const std::string& label, std::string says = {}, bool is_needed = false) {
        if (is_there(label)) return;
        std::string written = spot_.is_quoted ? label + '"' : '"' + label + '"';
        if (spot_.is_key && !has_colon()) written += ": ";
        found_.push_back({kind, label, std::move(written), spot_.begin, spot_.end, std::move(says), is_needed});
    }
    bool is_there(const std::string& label) const {
        return std::any_of(found_.begin(), found_.end(), [&](const Suggestion& each) { return each.label == label; });
    }
    /// What stands without quotes.
    void add_bare(Suggestion::Kind kind, const std::string& label) {
        if (spot_.is_quoted) return add(kind, label);
        if (is_there(label)) return;
        found_.push_back({kind, label, label, spot_.begin, spot_.end});
    }
    bool has_colon() const { return spot_.member != Outline::none && outline_[spot_.member].has_colon; }
    bool is_taken(const std::string& key) const {
        const std::uint32_t there = outline_.member(spot_.container, key);
        return there != Outline::none && there != spot_.member;
    }

    void add_keys() {
        const Forms objects = schema_.forms_of(outline_, spot_.container, spot_.member);
        for (const Form& each : objects) {
            if (!each.has("properties")) continue;
            const Json needed = each.schema->value("required", Json::array());
            for (const auto& [key, value] : (*each.schema)["properties"].items())
                if (!is_taken(key))
                    add(Suggestion::Kind::key, key, said_of(schema_, objects, key),
                        std::find(needed.begin(), needed.end(), key) != needed.end());
        }
        for (const Form& each : schema_.forms_of_keys(objects))
            for (const std::string& name : names_of(each.definition))
                if (!is_taken(name)) add(Suggestion::Kind::name, name);
    }

    void add_values() {
        if (spot_.is_quoted && outline_.text().substr(spot_.begin, offset_ - spot_.begin).starts_with('='))
            return add_parameters();
        const bool is_member = spot_.member != Outline::none && outline_[spot_.member].has_key();
        const Forms around = schema_.forms_of(outline_, spot_.container);
        const Forms forms =
            is_member ? schema_.forms_under(around, outline_.key_of(spot_.member)) : schema_.forms_of_elements(around);
        for (const Form& each : forms) {
            add_words(*each.schema);
            add_examples(*each.schema);
            for (const std::string& name : names_of(each.definition)) add_name(name, each);
        }
    }
    void add_words(const Json& schema) {
        if (schema.contains("enum"))
            for (const Json& word : schema["enum"])
                if (word.is_string()) add(Suggestion::Kind::word, word.get<std::string>());
        const bool is_flag = schema.contains("type") && schema["type"] == "boolean";
        if (is_flag || (schema.contains("const") && schema["const"] == true)) add_bare(Suggestion::Kind::word, "true");
        if (is_flag) add_bare(Suggestion::Kind::word, "false");
    }
    /// Of a quantity, "1 mm": its unit, behind a number that is typed. Of anything else the example as it is.
    void add_examples(const Json& schema) {
        if (!schema.contains("examples")) return;
        for (const Json& each : schema["examples"]) {
            if (!each.is_string()) continue;
            const std::string example = each.get<std::string>();
            if (example.starts_with("1 "))
                add_unit(example.substr(2));
            else
                add(Suggestion::Kind::word, example);
        }
    }
    void add_unit(const std::string& unit) {
        if (!spot_.is_quoted || is_there(unit)) return;
        const std::string_view typed = outline_.text().substr(spot_.begin, spot_.end - spot_.begin);
        const std::size_t number = typed.find_first_not_of("+-0123456789.eE");
        std::size_t begin = std::min(number, typed.size() - (typed.ends_with('"') ? 1 : 0));
        if (begin == 0) return;
        const std::string blank = typed.substr(begin).starts_with(' ') ? "" : " ";
        begin = std::min(typed.find_first_not_of(' ', begin), typed.size());
        found_.push_back({Suggestion::Kind::unit, unit, blank + unit + '"', spot_.begin + begin, spot_.end});
    }
    void add_name(const std::string& name, const Form& form) {
        // A body is named once in a joint, a point once in a body.
        const bool is_element = outline_[spot_.container].kind == Kind::array;
        for (std::uint32_t each = outline_[spot_.container].first_child; is_element && each != Outline::none;
             each = outline_[each].next)
            if (each != spot_.member && outline_.text_of(each) == name) return;
        const bool takes_numbers = form.has("type") && (*form.schema)["type"].is_array();
        if (takes_numbers && is_whole_number(name))
            add_bare(Suggestion::Kind::name, name);
        else
            add(Suggestion::Kind::name, name);
    }
    /// In a formula, the names in it that can stand where one is typed.
    void add_parameters() {
        constexpr std::string_view ends_a_name = "=+-*/^(), \"";
        const std::string_view typed = outline_.text().substr(spot_.begin, offset_ - spot_.begin);
        const std::size_t begin = spot_.begin + typed.find_last_of(ends_a_name) + 1;
        std::size_t end = outline_.text().find_first_of(ends_a_name, offset_);
        end = std::min(end, spot_.end);
        for (const std::string& name : keys_of("parameters"))
            found_.push_back({Suggestion::Kind::name, name, name, begin, end});
    }

    std::vector<std::string> keys_of(const char* section) const {
        std::vector<std::string> keys;
        const std::uint32_t object = outline_.member(outline_.root(), section);
        if (object == Outline::none || outline_[object].kind != Kind::object) return keys;
        for (std::uint32_t each = outline_[object].first_child; each != Outline::none; each = outline_[each].next)
            if (outline_[each].has_key() && each != spot_.member) keys.push_back(outline_.key_of(each));
        return keys;
    }
    std::vector<std::string> bodies() const {
        std::vector<std::string> names = keys_of("bodies");
        const std::uint32_t frame = outline_.member(outline_.root(), "frame");
        const bool is_default = frame == Outline::none || frame == spot_.member;
        names.insert(names.begin(), is_default ? "0" : outline_.text_of(frame));
        return names;
    }
    /// A joint goes by its name or, if it has none, by its point's: what stands under the first of its keys.
    std::vector<std::string> joints() const {
        std::vector<std::string> names;
        const std::uint32_t list = outline_.member(outline_.root(), "joints");
        if (list == Outline::none) return names;
        for (std::uint32_t each = outline_[list].first_child; each != Outline::none; each = outline_[each].next) {
            std::uint32_t name = outline_.member(each, "name");
            if (name == Outline::none) name = outline_[each].first_child;
            if (name != Outline::none && outline_[name].kind == Kind::string) names.push_back(outline_.text_of(name));
        }
        return names;
    }
    std::vector<std::string> names_of(const std::string& definition) const {
        if (definition == "pointName" || definition == "pointInArray") return keys_of("points");
        if (definition == "bodyName") return bodies();
        if (definition == "jointName") return joints();
        return {};
    }

    const Outline& outline_;
    std::size_t offset_;
    const FileSchema& schema_;
    const Spot& spot_;
    std::vector<Suggestion> found_;
};

}  // namespace

std::vector<Suggestion> suggestions_at(const Outline& outline, std::size_t offset, const FileSchema& schema) {
    const auto spot = SpotFinder(outline, offset).find();
    return spot && spot->container != 0 ? Suggesting(outline, offset, schema, *spot).all() : std::vector<Suggestion>{};
}

std::optional<Meaning> meaning_at(const Outline& outline, std::size_t offset, const FileSchema& schema) {
    auto spot = SpotFinder(outline, offset).find();
    // On the opening quote.
    if (!spot || spot->member == Outline::none) spot = SpotFinder(outline, offset + 1).find();
    if (!spot || !spot->is_key || spot->member == Outline::none || !outline[spot->member].has_key())
        return std::nullopt;
    const Outline::Node& member = outline[spot->member];
    Forms objects = schema.forms_of(outline, spot->container);
    const std::string key = outline.key_of(spot->member);
    std::erase_if(objects, [&](const Form& each) { return !is_key_of(each, key); });
    std::string says = said_of(schema, objects, key);
    if (says.empty()) return std::nullopt;
    return Meaning{member.key_begin, member.key_end, key, std::move(says)};
}

}  // namespace kinegraph::app
