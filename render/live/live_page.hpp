// The live page: a solution as one HTML file that needs nothing else. It carries the figures, the sentences, tables and
// equations in both languages, and the construction itself as data, which a small interpreter (the .js files beside
// this one) replays where a reader moves the mechanism. Computes no mechanics.
//
// What the file promises: it loads nothing, its own head forbids all but the one script and the one style sheet in it
// (by their hashes), and what a file names is text wherever it stands.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/solution/moving.hpp"
#include "engine/solution/solution.hpp"
#include "render/sheet/sheet.hpp"

namespace kinegraph::render {

/// `moving`: nothing where the mechanism has one position only; then the page is for reading. `options.language` is the
/// one that is shown first; `dark`: the theme for dark screens, nothing where the look was asked for. `served`: the
/// number of a page that is served while its file is watched, from 1: it asks where it came from whether there is a
/// later one or a fault; 0: from disk.
std::string live_page(const Solution& solution, const std::optional<Moving>& moving, const SheetOptions& options,
                      const std::optional<Theme>& dark, const Fonts& fonts, int served = 0);
/// What is served before a file was first solved: its name, its faults, and a page as soon as there is one.
std::string waiting_page(const std::string& name, const SheetOptions& options, const std::optional<Theme>& dark);

/// The interpreter, what a watched page has besides, and the style sheet, word for word render/live/*.js and page.css,
/// built into the library.
extern const std::string_view live_script, live_watch_script, live_style;

/// SHA-256 of a text in base 64, as a Content-Security-Policy names it.
std::string sha256_base64(std::string_view text);

}  // namespace kinegraph::render
