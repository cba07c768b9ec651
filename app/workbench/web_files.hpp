// The files of the workbench's page (web/src) and the examples, as they stand in the program (cmake/embed_web.cmake).
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace kinegraph::app {

struct WebFile {
    std::string_view path;  ///< "index.html", "canvas.js", "examples/four_bar.json"
    std::string_view text;
};

/// Sorted by folder, the page's files first.
std::span<const WebFile> web_files();

/// The file of a path; null: there is none.
const WebFile* web_file(std::string_view path);

/// The media type of a file by its ending.
std::string media_type_of(std::string_view path);

/// [{"path": "examples/four_bar.json", "title": {"en": "Four-bar linkage", …}}, …]
std::string examples_json();

/// web/src/index.html with its Content-Security-Policy, and the language in which it begins.
std::string workbench_page(std::string_view language);

}  // namespace kinegraph::app
