// Outputs: reads -o, --format and --theme, and gives drawings as bytes. Shared by the commands that draw.
#pragma once

#include <kinegraph/sheet.hpp>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/files/files.hpp"

namespace kinegraph::app {

enum class Format { svg, png, pdf, tex, dxf, json, csv, html, mp4, webm, gif, ggb };
/// The formats of every drawing, and others.
template <class... Others>
constexpr auto drawings_and(Others... others) {
    return std::array{Format::svg, Format::png, Format::pdf, Format::tex, Format::dxf, others...};
}

struct Target {
    std::string path;
    Format format = Format::svg;
    bool standard() const { return path == "-"; }
    bool is_drawn() const { return format != Format::json && format != Format::csv && format != Format::ggb; }
    bool is_film() const { return format == Format::mp4 || format == Format::webm || format == Format::gif; }
    bool is_page() const { return format == Format::html; }  ///< a live page, which has its own layout
    std::string path_of_page(std::size_t page) const;        ///< OUT.svg, OUT-2.svg, OUT-3.svg …
};
/// Whether a drawing is asked for.
bool any_drawn(const std::vector<Target>& targets);

/// The output files, or why the options are wrong. Without `outputs`, a given `format` goes to standard output.
tl::expected<std::vector<Target>, Words> targets_of(const std::vector<std::string>& outputs, const std::string& format,
                                                    const std::string& file, std::span<const Format> formats);

/// Sets the theme of the options to a built-in one or to that of a file; a status after an error was reported.
std::optional<Status> set_theme(DrawingOptions& options, const std::string& name, const std::string& file);

/// The names of further pages are known only after layout. Returns true, and reports it, if one of them is another
/// output or the mechanism file.
bool names_clash(const std::vector<Output>& outputs, const std::string& file, Language language);

/// How a drawing is written.
struct Printing {
    Language language = Language::en;           ///< of messages
    Lettering lettering = Lettering::outlines;  ///< of SVG and PDF
    double dpi = 150;                           ///< of PNG
    bool beamer = false;                        ///< LaTeX is that of slides
};
/// Adds the bytes of a drawing for a target, and to `remarks` what standard output cannot contain. A status after an
/// error was reported.
std::optional<Status> print(const Drawing& drawing, const Target& target, const Printing& printing,
                            std::vector<Output>& outputs, std::vector<Text>& remarks);
/// Words of a film that are read: in a file beside it, in the pictures, or nowhere.
enum class Captions { file, burnt, none };
/// Adds the bytes of a film with a picture for each page, and its captions: each stands as long as its words are read,
/// or, of a motion, for one frame. `height`: pixels of a picture. A status after an error was reported.
struct FilmOptions {
    Language language = Language::en;  ///< of messages
    Captions captions = Captions::file;
    int height = 720;
    enum class Course { steps, round, to_and_fro } course = Course::steps;  ///< steps, or the frames of a motion
};
std::optional<Status> add_film(const Drawing& drawing, const Target& target, const FilmOptions& options,
                               std::vector<Output>& outputs);
/// Reports why something cannot be drawn: a missing library or font is the program's fault, all else the file's.
Status cannot_draw(const Words& file, const Diagnostics& faults, Language language);

}  // namespace kinegraph::app
