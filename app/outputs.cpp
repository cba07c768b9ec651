#include "app/outputs.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "app/commands.hpp"
#include "app/module.hpp"
#include "app/modules/type.hpp"
#include "render/backends/backends.hpp"

namespace kinegraph::app {
namespace {

/// In the order of Format.
constexpr std::array<std::string_view, 5> names{"svg", "png", "pdf", "json", "csv"};

std::optional<Format> format_named(std::string name, std::span<const Format> formats) {
    std::transform(name.begin(), name.end(), name.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    for (const Format format : formats)
        if (names[static_cast<std::size_t>(format)] == name) return format;
    return std::nullopt;
}

/// "svg, png, pdf or json".
std::string listed(std::span<const Format> formats, const std::string& before) {
    std::string list;
    for (std::size_t i = 0; i < formats.size(); ++i) {
        if (i > 0) list += i + 1 == formats.size() ? " or " : ", ";
        list.append(before).append(names[static_cast<std::size_t>(formats[i])]);
    }
    return list;
}

/// Where a path's last dot is, or its end: "out/sheet.svg" → 9, "a.b/sheet" → 9.
std::size_t ending_of(const std::string& path) {
    const std::size_t name = path.rfind('/') + 1;  // 0 where there is no slash
    const std::size_t dot = path.rfind('.');
    return dot == std::string::npos || dot <= name ? path.size() : dot;
}

/// "./a.svg" and "a.svg" alike.
std::string plain(const std::string& path) { return std::filesystem::path(path).lexically_normal().string(); }

}  // namespace

std::string Target::path_of_page(std::size_t page) const {
    if (page == 0) return path;
    std::string numbered = path;
    return numbered.insert(ending_of(path), '-' + std::to_string(page + 1));
}

tl::expected<std::vector<Target>, std::string> targets_of(const std::vector<std::string>& outputs, const std::string& format,
                                                          const std::string& file, std::span<const Format> formats) {
    std::vector<std::string> paths = outputs;
    if (paths.empty() && !format.empty()) paths.emplace_back("-");
    std::vector<Target> targets;
    for (const std::string& path : paths) {
        if (path.empty() || path.ends_with('/')) return tl::unexpected("-o \"" + path + "\" names no file");
        const std::size_t ending = ending_of(path);
        std::optional<Format> found;
        if (path != "-" && ending < path.size()) found = format_named(path.substr(ending + 1), formats);
        if (!found) found = format_named(format, formats);
        if (!found && path == "-") return tl::unexpected("-o - needs --format " + listed(formats, ""));
        if (!found)
            return tl::unexpected("-o " + path + ": the ending does not say what to write; it may be " + listed(formats, ".") +
                                  " (or --format says it)");
        for (const Target& other : targets)
            if (other.path == path)
                return tl::unexpected(path == "-" ? std::string("standard output can carry one output only")
                                                  : "-o " + path + " is given twice");
        if (path != "-" && same_file(path, file))
            return tl::unexpected("-o " + path + " would overwrite the mechanism file itself");
        targets.push_back({path, *found});
    }
    return targets;
}

tl::expected<render::Theme, Status> theme_of(const std::string& name, const std::string& file) {
    if (name == "-" && file == "-") {
        say("kinegraph", "standard input can be the mechanism file or the theme, not both");
        return tl::unexpected(Status::bad_input);
    }
    if (auto built_in = render::built_in_theme(name)) return *std::move(built_in);
    const auto text = read_whole(name, "theme file");
    if (!text) {
        std::string known;
        for (const std::string_view each : render::theme_names()) known.append(known.empty() ? "" : ", ").append(each);
        say(spoken(name), text.error() + " (--theme is one of " + known + ", or the path of a theme file)");
        return tl::unexpected(Status::bad_input);
    }
    auto theme = render::read_theme(*text);
    if (!theme) return tl::unexpected(say(spoken(name), theme.error()));
    return *std::move(theme);
}

bool names_clash(const std::vector<Output>& outputs, const std::string& file) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (plain(outputs[i].path) != plain(outputs[j].path)) continue;
            say("kinegraph", "two outputs of this run would both be " + outputs[i].path);
            return true;
        }
        if (outputs[i].path != "-" && same_file(outputs[i].path, file)) {
            say("kinegraph", outputs[i].path + " (a further page) would overwrite the mechanism file itself");
            return true;
        }
    }
    return false;
}

tl::expected<Press, Status> Press::open(const std::vector<Target>& targets) {
    const auto fails = [](const std::string& why) {
        say("kinegraph", why);
        return tl::unexpected(Status::output);
    };
    Press press;
    auto typefaces = open_module_as<TypeFunctions>("kinegraph_type", "Type is set").and_then([](const TypeFunctions* functions) {
        return functions->open_typefaces();
    });
    if (!typefaces) return fails(typefaces.error());
    press.fonts_.emplace(*std::move(typefaces));
    if (std::any_of(targets.begin(), targets.end(),
                    [](const Target& target) { return target.format == Format::png || target.format == Format::pdf; })) {
        auto loaded = Painter::open();
        if (!loaded) return fails(loaded.error());
        press.painter_.emplace(*std::move(loaded));
    }
    return press;
}

void Press::print(const std::vector<render::Page>& pages, const Target& target, double dpi, std::vector<Output>& outputs,
                  std::vector<std::string>& remarks) const {
    if (target.format == Format::pdf) {
        outputs.push_back({target.path, painter_->to_pdf(pages, *fonts_)});
        return;
    }
    const std::size_t count = target.standard() ? std::min<std::size_t>(pages.size(), 1) : pages.size();
    if (target.format == Format::svg) {
        std::vector<std::string> texts =
            count == 1 ? std::vector{render::to_svg(pages.front(), *fonts_)} : render::to_svg(pages, *fonts_);
        for (std::size_t page = 0; page < count; ++page) outputs.push_back({target.path_of_page(page), std::move(texts[page])});
    } else {
        for (std::size_t page = 0; page < count; ++page)
            outputs.push_back({target.path_of_page(page), painter_->to_png(pages[page], *fonts_, dpi)});
    }
    if (count < pages.size())
        remarks.push_back("the sheet has " + std::to_string(pages.size()) +
                          " pages and standard output carries the first only; a PDF has them all, and so has -o with a name");
}

void Press::remark_missing(std::vector<std::string>& remarks) const {
    std::string absent;
    for (const std::string& character : fonts_->missing()) absent += (absent.empty() ? "" : ", ") + character;
    if (!absent.empty()) remarks.push_back("the font has no " + absent + ": drawn as its code in a box");
}

}  // namespace kinegraph::app
