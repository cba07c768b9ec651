#include "app/commands/outputs.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "app/commands/commands.hpp"
#include "render/backends/backends.hpp"

namespace kinegraph::app {
namespace {

/// In the order of Format.
constexpr std::array<std::string_view, 7> format_names{"svg", "png", "pdf", "tex", "json", "csv", "html"};

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
        if (i > 0) list += i + 1 == formats.size() ? Words(" or ", " o ") : Words(std::string(", "));
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
            return tl::unexpected(Words("-o \"{0}\" names no file", "-o \"{0}\" non indica un file", path));
        const std::size_t ending = ending_begins(path);
        std::optional<Format> found;
        if (path != "-" && ending < path.size()) found = format_named(path.substr(ending + 1), formats);
        if (!found) found = format_named(format, formats);
        if (!found && path == "-")
            return tl::unexpected(Words("-o - needs --format {0}", "-o - richiede --format {0}", listed(formats, "")));
        if (!found)
            return tl::unexpected(
                Words("-o {0}: the ending does not say what to write; it may be {1} (or --format says it)",
                      "-o {0}: l’estensione non dice che cosa scrivere; può essere {1} (o lo dice --format)", path,
                      listed(formats, ".")));
        for (const Target& other : targets)
            if (other.path == path)
                return tl::unexpected(path == "-" ? Words("standard output can carry one output only",
                                                          "l’uscita standard può portare un solo risultato")
                                                  : Words("-o {0} is given twice", "-o {0} è dato due volte", path));
        if (path != "-" && same_file(path, file))
            return tl::unexpected(Words("-o {0} would overwrite the mechanism file itself",
                                        "-o {0} sovrascriverebbe il file del meccanismo", path));
        targets.push_back({path, *found});
    }
    return targets;
}

tl::expected<render::Theme, Status> theme_of(const std::string& name, const std::string& file, Language language) {
    if (name == "-" && file == "-") {
        return tl::unexpected(refuse({"standard input can be the mechanism file or the theme, not both",
                                      "l’ingresso standard può essere il file del meccanismo o il tema, non entrambi"},
                                     language));
    }
    if (auto built_in = render::built_in_theme(name)) return *std::move(built_in);
    const auto text = read_whole(name, {"theme file", "file di tema"});
    if (!text) {
        std::string known;
        for (const std::string_view each : render::theme_names()) known.append(known.empty() ? "" : ", ").append(each);
        say(spoken(name),
            {"{0} (--theme is one of {1}, or the path of a theme file)",
             "{0} (--theme è uno fra {1}, o il percorso di un file di tema)", text.error(), known},
            language);
        return tl::unexpected(Status::bad_input);
    }
    auto theme = render::read_theme(*text);
    if (!theme) return tl::unexpected(say(spoken(name), theme.error(), language));
    return *std::move(theme);
}

bool names_clash(const std::vector<Output>& outputs, const std::string& file, Language language) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (plain(outputs[i].path) != plain(outputs[j].path)) continue;
            refuse({"two outputs of this run would both be {0}",
                    "due risultati di questo comando sarebbero entrambi {0}", outputs[i].path},
                   language);
            return true;
        }
        if (outputs[i].path != "-" && same_file(outputs[i].path, file)) {
            refuse({"{0} would overwrite the mechanism file itself; give the output another name",
                    "{0} sovrascriverebbe il file del meccanismo; dare al risultato un altro nome", outputs[i].path},
                   language);
            return true;
        }
    }
    return false;
}

std::optional<render::Theme> dark_beside(const std::string& theme) {
    return theme == "colour" ? render::built_in_theme("dark") : std::nullopt;
}

namespace {

tl::unexpected<Status> lacks(const Words& why, Language language) {
    refuse(why, language);
    return tl::unexpected(Status::output);
}

}  // namespace

tl::expected<OutputWriter, Status> OutputWriter::open(const std::vector<Target>& targets, Language language,
                                                      Lettering lettering) {
    std::optional<OutputWriter> press;
    const auto ready = prepare(press, language, lettering).and_then([&] { return press->prepare_to_print(targets); });
    if (!ready) return tl::unexpected(ready.error());
    return *std::move(press);
}

tl::expected<void, Status> OutputWriter::prepare(std::optional<OutputWriter>& press, Language language,
                                                 Lettering lettering) {
    if (press) {
        press->fonts_->start_anew();
    } else {
        auto fonts = render::Fonts::open();
        if (!fonts) return lacks(fonts.error(), language);
        press.emplace(OutputWriter());
        press->fonts_.emplace(*std::move(fonts));
    }
    press->language_ = language;
    press->lettering_ = lettering;
    return {};
}

tl::expected<void, Status> OutputWriter::prepare_to_print(const std::vector<Target>& targets) {
    const bool needs_cairo = std::any_of(targets.begin(), targets.end(), [](const Target& target) {
        return target.format == Format::png || target.format == Format::pdf;
    });
    if (!needs_cairo) return {};
    if (const auto opened = render::open_painter(); !opened) return lacks(opened.error(), language_);
    return {};
}

std::vector<std::string> OutputWriter::svg_of(std::span<const render::Page> pages) const {
    if (lettering_ == Lettering::live) return render::to_live_svg(pages, *fonts_);
    return render::to_svg(pages, *fonts_, glyph_paths_);
}

void OutputWriter::print(const std::vector<render::Page>& pages, const Target& target, double dpi,
                         std::vector<Output>& outputs, std::vector<std::string>& remarks) const {
    if (target.format == Format::pdf) {
        const bool live = lettering_ == Lettering::live;
        outputs.push_back({target.path, live ? render::to_live_pdf(pages, *fonts_) : render::to_pdf(pages, *fonts_)});
        return;
    }
    if (target.format == Format::tex) {
        outputs.push_back({target.path, render::to_tex(pages, *fonts_)});
        return;
    }
    const std::size_t count = target.standard() ? std::min<std::size_t>(pages.size(), 1) : pages.size();
    if (target.format == Format::svg) {
        std::vector<std::string> texts = svg_of(std::span(pages).first(count));
        for (std::size_t page = 0; page < count; ++page)
            outputs.push_back({target.path_of_page(page), std::move(texts[page])});
    } else {
        for (std::size_t page = 0; page < count; ++page)
            outputs.push_back({target.path_of_page(page), render::to_png(pages[page], *fonts_, dpi)});
    }
    if (count < pages.size())
        remarks.push_back(in({"the sheet has {0} pages and standard output carries the first only; a PDF has them all, "
                              "and so has -o with a name",
                              "il foglio ha {0} pagine e l’uscita standard porta solo la prima; un PDF le ha tutte, e "
                              "così -o con un nome",
                              std::to_string(pages.size())},
                             language_));
}

void OutputWriter::remark_missing(std::vector<std::string>& remarks) const {
    std::string absent;
    for (const std::string& character : fonts_->missing()) absent += (absent.empty() ? "" : ", ") + character;
    if (!absent.empty())
        remarks.push_back(in({"the font has no {0}: drawn as its code in a box",
                              "il font non ha {0}: disegnato come codice in un riquadro", absent},
                             language_));
}

}  // namespace kinegraph::app
