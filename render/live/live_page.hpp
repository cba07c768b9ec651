// The live page: a solution as one self-contained HTML file. It has the figures, sentences, tables and equations in
// the languages of the page, and the construction as data, which a small interpreter (the .js files in this folder)
// replays when the reader moves the mechanism. Computes no mechanics.
//
// Guarantees: the file loads nothing; its Content-Security-Policy allows only its own script and style sheet (by their
// hashes); names from the input file are always escaped text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "engine/solution/moving.hpp"
#include "render/sheet/sheet.hpp"

namespace kinegraph {
struct Solution;
}

namespace kinegraph::render {

/// `moving`: empty if the mechanism has one position only; then the page is static. `options.language`: shown first.
/// `dark`: theme for dark screens; empty if the user chose a theme. `served`: for a page that is served while its file
/// is watched, its version, from 1: the page polls the server for a later version or an error; 0: a file on disk.
/// Refused, with the reason: a figure that cannot be written (beyond_paper).
tl::expected<std::string, Words> live_page(const Solution& solution, const std::optional<Moving>& moving,
                                           const SheetOptions& options, const std::optional<Theme>& dark,
                                           const Fonts& fonts, int served = 0);
/// The page served before a file has been solved: its name, its errors, and a reload as soon as there is a solution.
std::string waiting_page(const std::string& name, const SheetOptions& options, const std::optional<Theme>& dark);

/// The interpreter, the additional script of a watched page, the style sheet, and the controls: the contents of
/// render/live/*.js, page.css and controls.html, built into the library.
extern const std::string_view live_script, live_watch_script, live_style, live_controls;

/// The same of the page of a cam: render/live/cam/cam.js, cam.css and cam.html; its style follows the sheet's.
extern const std::string_view cam_script, cam_style, cam_controls;

/// SHA-256 of a text in base 64, for a Content-Security-Policy.
std::string sha256_base64(std::string_view text);

}  // namespace kinegraph::render
