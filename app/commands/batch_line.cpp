// The keys of a line: "file" or "mechanism", "set", "want", "to", and the options of solve under their own names.
#include "app/commands/batch_line.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>
#include <utility>

#include "app/files/json_text.hpp"
#include "engine/file/json_source.hpp"
#include "engine/file/spelling.hpp"

namespace kinegraph::app {
namespace {

constexpr std::array<std::string_view, 6> endings{".svg", ".png",  ".pdf",
                                                  ".tex", ".json", ".csv"};  // in the order of Format

std::string_view ending_of(Format format) { return endings.at(static_cast<std::size_t>(format)); }

class BatchLineReader {
public:
    BatchLineReader(const JsonSource& source, BatchLine& line) : source_(source), line_(line) {}

    void read() {
        const JsonValue root = source_.root();
        if (!root.is_object()) return wrong(root, {"an object", "un oggetto"});
        for (const JsonValue twice : source_.duplicates())
            if (!twice.pointer().starts_with("/mechanism/"))
                fault(twice, {"\"{0}\" is given twice", "\"{0}\" è dato due volte", std::string(twice.key())});
        for (const JsonValue member : root) read_member(member);
        read_input(root);
        const bool is_file = std::any_of(line_.want.begin(), line_.want.end(), [](Format format) {
            return format == Format::png || format == Format::pdf || format == Format::tex;
        });
        if (is_file && line_.to.empty())
            line_.errors.push_back({ErrorCode::bad_input,
                                    "/want",
                                    {"png, pdf and tex are files: say with \"to\" where they go",
                                     "png, pdf e tex sono file: dire con \"to\" dove vanno"}});
    }

private:
    template <class Value>
    using Choices = std::vector<std::pair<std::string_view, Value>>;

    static Choices<render::Language> languages_by_code() {
        Choices<render::Language> all;
        for (const render::Language language : render::languages)
            all.emplace_back(render::notation(language).code, language);
        return all;
    }
    void fault(JsonValue at, Words message) {
        line_.errors.push_back({ErrorCode::bad_input, at.pointer(), std::move(message)});
    }
    void wrong(JsonValue at, const Words& wanted) {
        fault(at, {"{0} is wanted here, not {1}", "qui ci vuole {0}, non {1}", wanted, described(at)});
    }
    bool text(JsonValue value, std::string& into) {
        if (value.is_string()) into = value.text();
        if (!value.is_string()) wrong(value, {"a text", "un testo"});
        return value.is_string();
    }
    void flag(JsonValue value, bool& into) {
        if (value.kind() != JsonValue::Kind::boolean) return wrong(value, {"true or false", "true o false"});
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
        wrong(value, {"one of {0}", "uno fra {0}", listed(names)});
    }
    void number(JsonValue value, double least, double most, double& into) {
        double read = 0;
        const std::string_view digits = value.is_number() ? value.text() : std::string_view();
        const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), read);
        if (digits.empty() || end.ec != std::errc{} || !(read >= least && read <= most))
            return wrong(value, {"a number from {0} to {1}", "un numero da {0} a {1}",
                                 std::to_string(static_cast<int>(least)), std::to_string(static_cast<int>(most))});
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
        using namespace render;
        const std::string_view key = value.key();
        SolveRequest& request = line_.request;
        if (key == "lang")
            choice<Language>(value, languages_by_code(), request.language);
        else if (key == "paper")
            choice<Paper>(value, {{"A4", Paper::a4}, {"A3", Paper::a3}, {"letter", Paper::letter}}, request.paper);
        else if (key == "orientation")
            choice<Orientation>(value, {{"landscape", Orientation::landscape}, {"portrait", Orientation::portrait}},
                                request.orientation);
        else if (key == "dimensions")
            choice<Dimensions>(value,
                               {{"auto", Dimensions::automatic}, {"on", Dimensions::on}, {"off", Dimensions::off}},
                               request.dimensions);
        else if (key == "detail")
            choice<SolutionDetail>(value, {{"full", SolutionDetail::full}, {"brief", SolutionDetail::brief}},
                                   request.detail);
        else if (key == "sheet")
            choice<SheetKind>(
                value,
                {{"solution", SheetKind::solution}, {"question", SheetKind::question}, {"answers", SheetKind::answers}},
                request.sheet);
        else
            return read_plain_option(value);
        return true;
    }
    bool read_plain_option(JsonValue value) {
        const std::string_view key = value.key();
        SolveRequest& request = line_.request;
        if (key == "figure")
            text(value, request.figure);
        else if (key == "theme")
            text(value, request.theme);
        else if (key == "date")
            text(value, request.date);
        else if (key == "author")
            text(value, request.author);
        else if (key == "driver")
            text(value, request.driver);
        else if (key == "at")
            texts(value, request.at);
        else if (key == "with")
            read_with(value);
        else if (key == "grid")
            flag(value, request.grid);
        else if (key == "steps")
            flag(value, request.steps);
        else if (key == "exact")
            flag(value, request.exact);
        else if (key == "dpi")
            number(value, 20, 1200, request.dpi);
        else if (key == "branch")
            read_branch(value);
        else
            return false;
        return true;
    }
    void unknown(JsonValue member) {
        static constexpr auto known = std::to_array<std::string_view>(
            {"id",          "file",       "mechanism", "set",    "want",  "to",    "lang",   "paper",
             "orientation", "dimensions", "detail",    "sheet",  "grid",  "steps", "figure", "with",
             "theme",       "dpi",        "date",      "author", "exact", "at",    "driver", "branch"});
        Speller speller;
        fault(member,
              Words("a line has no key \"{0}\"", "una riga non ha la chiave \"{0}\"", std::string(member.key())) +
                  did_you_mean(speller.nearest(member.key(), known)));
    }

    void read_id(JsonValue value) {
        if (value.is_array() || value.is_object()) return wrong(value, {"a text or a number", "un testo o un numero"});
        line_.id = copied(value);
    }
    void read_settings(JsonValue value) {
        if (!value.is_object())
            return wrong(value, {"an object of parameters by name", "un oggetto di parametri per nome"});
        for (const JsonValue each : value) {
            if (each.is_string() || each.is_number())
                line_.request.set.push_back({std::string(each.key()), std::string(each.text())});
            else
                wrong(each, {"a number, a quantity or a formula", "un numero, una grandezza o una formula"});
        }
    }
    void read_wanted(JsonValue value) {
        line_.want.clear();
        if (!value.is_array() || value.size() == 0)
            return wrong(value, {"an array of json, svg, png, pdf, tex", "un array di json, svg, png, pdf, tex"});
        for (const JsonValue each : value) {
            Format format = Format::json;
            choice<Format>(each,
                           {{"json", Format::json},
                            {"svg", Format::svg},
                            {"png", Format::png},
                            {"pdf", Format::pdf},
                            {"tex", Format::tex}},
                           format);
            if (std::find(line_.want.begin(), line_.want.end(), format) == line_.want.end())
                line_.want.push_back(format);
        }
    }
    void read_target(JsonValue value) {
        if (!text(value, line_.to)) return;
        if (line_.to.empty() || line_.to.ends_with('/') || line_.to.find('\0') != std::string::npos)
            fault(value, {"names no file", "non indica un file"});
    }
    void read_with(JsonValue value) {
        line_.request.with.clear();
        if (!value.is_array()) return wrong(value, {"an array of figures", "un array di figure"});
        for (const JsonValue each : value)
            choice<std::string>(each, {{"joukowsky", "joukowsky"}}, line_.request.with.emplace_back());
    }
    void read_branch(JsonValue value) {
        double branch = 1;
        if (!is_whole_number(value)) return wrong(value, {"a whole number from 1", "un intero da 1"});
        number(value, 1, 1000, branch);
        line_.request.branch = static_cast<int>(branch);
    }
    void read_input(JsonValue root) {
        const JsonValue file = root["file"], mechanism = root["mechanism"];
        if (static_cast<bool>(file) == static_cast<bool>(mechanism)) {
            fault(root, file ? Words("\"file\" and \"mechanism\" exclude each other: leave one of them out",
                                     "\"file\" e \"mechanism\" si escludono: togliere uno dei due")
                             : Words("\"file\" or \"mechanism\" is missing", "manca \"file\" o \"mechanism\""));
        } else if (mechanism) {
            line_.request.file = "mechanism";
            line_.request.text = copied(mechanism);
        } else if (text(file, line_.request.file)) {
            const std::string& path = line_.request.file;
            if (path.empty() || path.find('\0') != std::string::npos)
                fault(file, {"names no file", "non indica un file"});
            if (path == "-")
                fault(file,
                      {"standard input carries the lines: give the mechanism's file, or the mechanism itself as "
                       "\"mechanism\"",
                       "l’ingresso standard porta le righe: dare il file del meccanismo, o il meccanismo stesso come "
                       "\"mechanism\""});
        }
    }

    const JsonSource& source_;
    BatchLine& line_;
};

}  // namespace

std::vector<Target> BatchLine::targets() const {
    std::string stem =
        to.empty() ? "/dev/null/answer" : to;  // a path below a file that is no folder: nothing can exist there
    for (const Format format : want) {
        const std::string_view ending = ending_of(format);
        if (!to.ends_with(ending)) continue;
        stem.resize(to.size() - ending.size());
        break;
    }
    std::vector<Target> all;
    for (const Format format : want) all.push_back({stem + std::string(ending_of(format)), format});
    return all;
}

BatchLine read_batch_line(std::string_view line, const SolveRequest& defaults) {
    BatchLine read;
    read.request = defaults;
    read.want = {Format::json};
    const auto source = JsonSource::read(line);
    if (!source) {
        read.errors = source.error();
        return read;
    }
    BatchLineReader(*source, read).read();
    return read;
}

}  // namespace kinegraph::app
