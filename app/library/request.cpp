// Reads requests: "file" or "mechanism", "set", "want", "to", and the options of solve under their own names.
#include "kinegraph/request.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "app/library/state.hpp"
#include "engine/file/json_source.hpp"
#include "engine/file/json_text.hpp"
#include "engine/file/spelling.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/library.hpp"

namespace kinegraph {
namespace {

/// Appends a value as JSON, unchanged: digits of numbers, order of keys, duplicate keys.
void append_copy(JsonValue value, std::string& json) {
    if (value.is_string()) return append_json_text(json, value.text(), "\\n");
    if (!value.is_array() && !value.is_object()) {
        json += value.text();
        return;
    }
    json += value.is_array() ? '[' : '{';
    bool first = true;
    for (const JsonValue each : value) {
        if (!first) json += ", ";
        first = false;
        if (value.is_object()) {
            append_json_text(json, each.key(), "\\n");
            json += ": ";
        }
        append_copy(each, json);
    }
    json += value.is_array() ? ']' : '}';
}
std::string copied(JsonValue value) {
    std::string json;
    append_copy(value, json);
    return json;
}

class RequestReader {
public:
    RequestReader(const JsonSource& source, Request& request) : source_(source), request_(request) {}

    Errors faults() {
        read();
        return std::move(faults_);
    }

private:
    using Format = Request::Format;
    template <class Value>
    using Choices = std::vector<std::pair<std::string_view, Value>>;

    void read() {
        const JsonValue root = source_.root();
        if (!root.is_object()) return wrong(root, {lang::common::an_object});
        for (const JsonValue twice : source_.duplicates())
            if (!twice.pointer().starts_with("/mechanism/"))
                fault(twice, {lang::library::is_given_twice, std::string(twice.key())});
        for (const JsonValue member : root) read_member(member);
        read_input(root);
        const bool is_file = std::any_of(request_.want.begin(), request_.want.end(), [](Format format) {
            return format == Format::png || format == Format::pdf || format == Format::tex || format == Format::dxf;
        });
        if (is_file && request_.to.empty())
            faults_.push_back({ErrorCode::bad_input, "/want", {lang::library::png_pdf_and_tex_are_files}});
    }

    static Choices<Language> languages_by_code() {
        Choices<Language> all;
        for (const Language language : languages) all.emplace_back(render::notation(language).code, language);
        return all;
    }
    void fault(JsonValue at, Words message) {
        faults_.push_back({ErrorCode::bad_input, at.pointer(), std::move(message)});
    }
    void wrong(JsonValue at, const Words& wanted) {
        fault(at, {lang::library::is_wanted_here_not, wanted, described(at)});
    }
    bool text(JsonValue value, std::string& into) {
        if (value.is_string()) into = value.text();
        if (!value.is_string()) wrong(value, {lang::common::a_text});
        return value.is_string();
    }
    void flag(JsonValue value, bool& into) {
        if (value.kind() != JsonValue::Kind::boolean) return wrong(value, {lang::common::true_or_false});
        into = is_true(value);
    }
    /// A text, or an array of them.
    void texts(JsonValue value, std::vector<std::string>& into) {
        into.clear();
        if (!value.is_array()) {
            text(value, into.emplace_back());
            return;
        }
        for (const JsonValue each : value) text(each, into.emplace_back());
    }
    template <class Value>
    void choice(JsonValue value, const Choices<Value>& choices, Value& into) {
        std::vector<std::string_view> names;
        for (const auto& [name, meant] : choices) {
            names.push_back(name);
            if (!value.is_string() || value.text() != name) continue;
            into = meant;
            return;
        }
        wrong(value, {lang::library::one_of, listed(names)});
    }
    void number(JsonValue value, double least, double most, double& into) {
        double read = 0;
        const std::string_view digits = value.is_number() ? value.text() : std::string_view();
        const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), read);
        if (digits.empty() || end.ec != std::errc{} || !(read >= least && read <= most))
            return wrong(value, {lang::library::a_number, std::to_string(static_cast<int>(least)),
                                 std::to_string(static_cast<int>(most))});
        into = read;
    }

    void read_member(JsonValue member) {
        if (!read_own(member) && !read_option(member)) unknown(member);
    }
    /// Reads the keys that solve does not have or spells otherwise.
    bool read_own(JsonValue value) {
        const std::string_view key = value.key();
        if (key == "id")
            read_id(value);
        else if (key == "set")
            read_settings(value);
        else if (key == "want")
            read_wanted(value);
        else if (key == "to")
            read_target(value);
        else
            return key == "file" || key == "mechanism";
        return true;
    }
    /// Reads an option of solve. Texts are not checked here.
    bool read_option(JsonValue value) {
        using Options = DrawingOptions;
        const std::string_view key = value.key();
        Options& drawing = request_.drawing;
        if (key == "lang")
            choice<Language>(value, languages_by_code(), drawing.language);
        else if (key == "paper")
            choice<Options::Paper>(
                value, {{"A4", Options::Paper::a4}, {"A3", Options::Paper::a3}, {"letter", Options::Paper::letter}},
                drawing.paper);
        else if (key == "orientation")
            choice<Options::Orientation>(
                value, {{"landscape", Options::Orientation::landscape}, {"portrait", Options::Orientation::portrait}},
                drawing.orientation);
        else if (key == "dimensions")
            choice<Options::Dimensions>(value,
                                        {{"auto", Options::Dimensions::automatic},
                                         {"on", Options::Dimensions::on},
                                         {"off", Options::Dimensions::off}},
                                        drawing.dimensions);
        else if (key == "detail")
            choice<Options::Detail>(value, {{"full", Options::Detail::full}, {"brief", Options::Detail::brief}},
                                    drawing.detail);
        else if (key == "superposition")
            choice<Options::Superposition>(
                value, {{"joined", Options::Superposition::joined}, {"each", Options::Superposition::each}},
                drawing.superposition);
        else if (key == "sheet")
            choice<Options::Sheet>(value,
                                   {{"solution", Options::Sheet::solution},
                                    {"question", Options::Sheet::question},
                                    {"answers", Options::Sheet::answers}},
                                   drawing.sheet);
        else
            return read_plain_option(value);
        return true;
    }
    bool read_plain_option(JsonValue value) {
        const std::string_view key = value.key();
        if (key == "figure")
            text(value, request_.drawing.figure);
        else if (key == "theme")
            text(value, request_.theme);
        else if (key == "date")
            text(value, request_.drawing.date);
        else if (key == "author")
            text(value, request_.drawing.author);
        else if (key == "driver")
            text(value, request_.positions.driver);
        else if (key == "at")
            texts(value, request_.positions.at);
        else if (key == "with")
            read_with(value);
        else if (key == "grid")
            flag(value, request_.drawing.grid);
        else if (key == "steps")
            flag(value, request_.drawing.steps);
        else if (key == "slides")
            flag(value, request_.drawing.slides);
        else if (key == "exact")
            flag(value, request_.exact);
        else if (key == "dpi")
            number(value, 20, 1200, request_.dpi);
        else if (key == "branch")
            read_branch(value);
        else
            return false;
        return true;
    }
    void unknown(JsonValue member) {
        static constexpr auto known = std::to_array<std::string_view>(
            {"id",         "file",   "mechanism", "set",   "want",  "to",     "lang",   "paper",        "orientation",
             "dimensions", "detail", "sheet",     "grid",  "steps", "slides", "figure", "with",         "theme",
             "dpi",        "date",   "author",    "exact", "at",    "driver", "branch", "superposition"});
        Speller speller;
        fault(member, Words(lang::library::a_line_has_no_key, std::string(member.key())) +
                          did_you_mean(speller.nearest(member.key(), known)));
    }

    void read_id(JsonValue value) {
        if (value.is_array() || value.is_object()) return wrong(value, {lang::library::a_text_or_a_number});
        request_.id = copied(value);
    }
    void read_settings(JsonValue value) {
        if (!value.is_object()) return wrong(value, {lang::library::an_object_of_parameters_by_name});
        for (const JsonValue each : value) {
            if (each.is_string() || each.is_number())
                request_.set.push_back({std::string(each.key()), std::string(each.text())});
            else
                wrong(each, {lang::common::a_number_a_quantity_or_a_formula});
        }
    }
    void read_wanted(JsonValue value) {
        request_.want.clear();
        if (!value.is_array() || value.size() == 0) return wrong(value, {lang::library::an_array_of_json_svg_png});
        for (const JsonValue each : value) {
            Format format = Format::json;
            choice<Format>(each,
                           {{"json", Format::json},
                            {"svg", Format::svg},
                            {"png", Format::png},
                            {"pdf", Format::pdf},
                            {"tex", Format::tex},
                            {"dxf", Format::dxf}},
                           format);
            if (std::find(request_.want.begin(), request_.want.end(), format) == request_.want.end())
                request_.want.push_back(format);
        }
    }
    void read_target(JsonValue value) {
        if (!text(value, request_.to)) return;
        if (request_.to.empty() || request_.to.ends_with('/') || request_.to.find('\0') != std::string::npos)
            fault(value, {lang::library::names_no_file});
    }
    void read_with(JsonValue value) {
        request_.with.clear();
        if (!value.is_array()) return wrong(value, {lang::library::an_array_of_figures});
        for (const JsonValue each : value)
            choice<std::string>(
                each, {{"joukowsky", "joukowsky"}, {"equations", "equations"}, {"virtual work", "virtual work"}},
                request_.with.emplace_back());
    }
    void read_branch(JsonValue value) {
        double branch = 1;
        if (!is_whole_number(value)) return wrong(value, {lang::library::a_whole_number_from_1});
        number(value, 1, 1000, branch);
        request_.positions.branch = static_cast<int>(branch);
    }
    void read_input(JsonValue root) {
        const JsonValue file = root["file"], mechanism = root["mechanism"];
        if (static_cast<bool>(file) == static_cast<bool>(mechanism)) {
            fault(root, file ? Words(lang::library::file_and_mechanism_exclude_each_other)
                             : Words(lang::library::file_or_mechanism_is_missing));
        } else if (mechanism) {
            request_.file = "mechanism";
            request_.text = copied(mechanism);
        } else if (text(file, request_.file)) {
            const std::string& path = request_.file;
            if (path.empty() || path.find('\0') != std::string::npos) fault(file, {lang::library::names_no_file});
            if (path == "-") fault(file, {lang::library::standard_input_carries_the_lines_give});
        }
    }

    const JsonSource& source_;
    Request& request_;
    Errors faults_;
};

}  // namespace

Request Request::parse(std::string_view json, const Request& defaults) {
    Request read = defaults;
    const auto source = JsonSource::read(json);
    read.faults = diagnostics_of(source ? RequestReader(*source, read).faults() : source.error());
    return read;
}

Request Request::parse(std::string_view json) { return parse(json, Request()); }

std::string json_string(std::string_view text) {
    std::string json;
    json.reserve(text.size() + 2);
    append_json_text(json, text, "\\n");
    return json;
}

std::string Request::excerpt(std::string_view json) {
    constexpr std::size_t longest = 80;
    return shown(json, longest);
}

}  // namespace kinegraph
