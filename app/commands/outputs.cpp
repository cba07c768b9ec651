#include "app/commands/outputs.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "app/commands/commands.hpp"
#include "app/files/film.hpp"
#include "lang/keys/command_line.hpp"

namespace kinegraph::app {

using namespace std::string_literals;

namespace {

/// In the order of Format.
constexpr std::array<std::string_view, 12> format_names{"svg", "png",  "pdf", "tex",  "dxf", "json",
                                                        "csv", "html", "mp4", "webm", "gif", "ggb"};

std::optional<Format> format_named(std::string name, std::span<const Format> formats) {
    std::transform(name.begin(), name.end(), name.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    for (const Format format : formats)
        if (format_names[static_cast<std::size_t>(format)] == name) return format;
    return std::nullopt;
}

/// "svg, png, pdf or json".
Words listed(std::span<const Format> formats, const std::string& before) {
    Words list;
    for (std::size_t i = 0; i < formats.size(); ++i) {
        if (i > 0) list += i + 1 == formats.size() ? Words(lang::command_line::or_word) : Words(std::string(", "));
        list += before + std::string(format_names[static_cast<std::size_t>(formats[i])]);
    }
    return list;
}

/// The position of the extension's dot in a path, or the length of the path: "out/sheet.svg" → 9, "a.b/sheet" → 9.
std::size_t ending_begins(const std::string& path) {
    const std::size_t name = path.rfind('/') + 1;  // 0 if there is no slash
    const std::size_t dot = path.rfind('.');
    return dot == std::string::npos || dot <= name ? path.size() : dot;
}

/// Normalises a path: "./a.svg" and "a.svg" become equal.
std::string plain(const std::string& path) { return std::filesystem::path(path).lexically_normal().string(); }

}  // namespace

std::string Target::path_of_page(std::size_t page) const {
    if (page == 0) return path;
    std::string numbered = path;
    return numbered.insert(ending_begins(path), '-' + std::to_string(page + 1));
}

tl::expected<std::vector<Target>, Words> targets_of(const std::vector<std::string>& outputs, const std::string& format,
                                                    const std::string& file, std::span<const Format> formats) {
    std::vector<std::string> paths = outputs;
    if (paths.empty() && !format.empty()) paths.emplace_back("-");
    std::vector<Target> targets;
    for (const std::string& path : paths) {
        if (path.empty() || path.ends_with('/'))
            return tl::unexpected(Words(lang::command_line::o_names_no_file, path));
        const std::size_t ending = ending_begins(path);
        std::optional<Format> found;
        if (path != "-" && ending < path.size()) found = format_named(path.substr(ending + 1), formats);
        if (!found) found = format_named(format, formats);
        if (!found && path == "-")
            return tl::unexpected(Words(lang::command_line::o_needs_format, listed(formats, "")));
        if (!found)
            return tl::unexpected(Words(lang::command_line::o_the_ending_does_not_say, path, listed(formats, ".")));
        for (const Target& other : targets)
            if (other.path == path)
                return tl::unexpected(path == "-" ? Words(lang::command_line::standard_output_can_carry_one_output)
                                                  : Words(lang::command_line::o_is_given_twice, path));
        if (path != "-" && same_file(path, file))
            return tl::unexpected(Words(lang::command_line::o_would_overwrite_the_mechanism_file, path));
        targets.push_back({path, *found});
    }
    return targets;
}

bool any_drawn(const std::vector<Target>& targets) {
    return std::any_of(targets.begin(), targets.end(), [](const Target& target) { return target.is_drawn(); });
}

std::optional<Status> set_theme(DrawingOptions& options, const std::string& name, const std::string& file) {
    const Language language = options.language;
    if (name == "-" && file == "-") return refuse({lang::command_line::standard_input_can_be_the_mechanism}, language);
    const std::vector<std::string> names = theme_names();
    options.theme = name;
    if (std::find(names.begin(), names.end(), name) != names.end()) return std::nullopt;
    auto text = read_whole(name, {lang::command_line::theme_file});
    if (!text) {
        std::string known;
        for (const std::string& each : names) known.append(known.empty() ? "" : ", ").append(each);
        say(spoken(name), {lang::command_line::theme_is, text.error(), known}, language);
        return Status::bad_input;
    }
    if (const auto fits = check_theme(*text); !fits) return say(spoken(name), fits.error(), language);
    options.theme_file = *std::move(text);
    return std::nullopt;
}

bool names_clash(const std::vector<Output>& outputs, const std::string& file, Language language) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (plain(outputs[i].path) != plain(outputs[j].path)) continue;
            refuse({lang::command_line::two_outputs_of_this_run, outputs[i].path}, language);
            return true;
        }
        if (outputs[i].path != "-" && same_file(outputs[i].path, file)) {
            refuse({lang::command_line::would_overwrite_the_mechanism_file_itself, outputs[i].path}, language);
            return true;
        }
    }
    return false;
}

Status cannot_draw(const Words& file, const Diagnostics& faults, Language language) {
    if (faults.front().kind != Diagnostic::Kind::output) return say(file, faults, language);
    refuse(faults.front().text, language);
    return Status::output;
}

std::optional<Status> print(const Drawing& drawing, const Target& target, const Printing& printing,
                            std::vector<Output>& outputs, std::vector<Text>& remarks) {
    const auto add = [&](const std::string& path, Expected<std::string> bytes) -> std::optional<Status> {
        if (!bytes) return cannot_draw("kinegraph"s, bytes.error(), printing.language);
        outputs.push_back({path, *std::move(bytes)});
        return std::nullopt;
    };
    if (target.format == Format::pdf) return add(target.path, drawing.pdf(printing.lettering));
    if (target.format == Format::tex) return add(target.path, printing.beamer ? drawing.beamer() : drawing.tex());
    const std::size_t count = target.standard() ? 1 : drawing.pages();
    if (target.format == Format::svg || target.format == Format::dxf) {
        std::vector<std::string> pages = target.format == Format::svg ? drawing.svg(printing.lettering) : drawing.dxf();
        for (std::size_t page = 0; page < count; ++page)
            outputs.push_back({target.path_of_page(page), std::move(pages[page])});
    } else {
        for (std::size_t page = 0; page < count; ++page)
            if (const auto failed = add(target.path_of_page(page), drawing.png(page, printing.dpi))) return failed;
    }
    if (count < drawing.pages())
        remarks.push_back(Words(lang::command_line::the_sheet_has_pages_and_standard, std::to_string(drawing.pages())));
    return std::nullopt;
}

std::optional<Status> add_film(const Drawing& drawing, const Target& target, const FilmOptions& options,
                               std::vector<Output>& outputs) {
    using Course = FilmOptions::Course;
    const FilmKind kind = target.format == Format::mp4    ? FilmKind::mp4
                          : target.format == Format::webm ? FilmKind::webm
                                                          : FilmKind::gif;
    const bool is_motion = options.course != Course::steps;
    const int rate = is_motion ? rate_of_motion(kind) : rate_of_stills(kind);
    constexpr double inches_high = 4.5;  // of a slide
    std::vector<Shot> shots;
    int lead = 0;  // pictures in which the lines of the next one grow
    for (std::size_t page = 0; page < drawing.pages(); ++page) {
        auto png = drawing.png(page, options.height / inches_high);
        if (!png) return cannot_draw("kinegraph"s, png.error(), options.language);
        if (drawing.grows(page)) {
            shots.push_back({*std::move(png)});
            ++lead;
            continue;
        }
        const std::string words = drawing.sentences(page);
        const int frames = is_motion ? 1 : reading_frames(words, rate) - lead;
        shots.push_back({*std::move(png), frames, words, std::exchange(lead, 0)});
    }
    if (options.course == Course::to_and_fro)
        for (std::size_t page = shots.size() - 1; page-- > 1;) shots.push_back(shots[page]);
    auto film = film_of(shots, rate, kind);
    if (!film) {
        refuse(film.error(), options.language);
        return Status::output;
    }
    outputs.push_back({target.path, *std::move(film)});
    const bool has_captions =
        std::any_of(shots.begin(), shots.end(), [](const Shot& shot) { return !shot.caption.empty(); });
    if (options.captions != Captions::file || target.standard() || !has_captions) return std::nullopt;
    Output captions{target.path.substr(0, ending_begins(target.path)) + ".vtt", captions_of(shots, rate)};
    // Two films of one name share their captions.
    const bool is_there = std::any_of(outputs.begin(), outputs.end(), [&](const Output& other) {
        return other.path == captions.path && other.bytes == captions.bytes;
    });
    if (!is_there) outputs.push_back(std::move(captions));
    return std::nullopt;
}

}  // namespace kinegraph::app
