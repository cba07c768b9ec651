/// \file
/// Requests written as JSON, one of which says all of what to solve and to draw: the lines of `kinegraph batch`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <kinegraph/error.hpp>
#include <kinegraph/mechanism.hpp>
#include <kinegraph/sheet.hpp>

namespace kinegraph {

/// What to solve, and what to make of it. docs/batch.md has the keys of the JSON object.
struct Request {
    /// Formats that can be requested.
    enum class Format { svg, png, pdf, tex, dxf, json };

    std::string id = "null";                 ///< returned with the answer: a JSON value as the request gives it
    std::string file;                        ///< path of the mechanism file; "mechanism" if the request contains it
    std::optional<std::string> text;         ///< the mechanism file, if the request contains it
    std::vector<ParameterValue> set;         ///< values that replace parameters of the file
    PositionsWanted positions;               ///< none: the position of the file
    DrawingOptions drawing;                  ///< without its theme and Joukowsky's lever
    std::string theme = "colour";            ///< a built-in theme, or the path of a theme file
    std::vector<std::string> with;           ///< additions: "joukowsky", "equations", "virtual work"
    bool exact = false;                      ///< add fractions to JSON results
    double dpi = 150;                        ///< of PNG, 20 to 1200
    std::vector<Format> want{Format::json};  ///< each once, in the order of the request
    std::string to;                          ///< path of the files without extension; empty: into the answer
    Diagnostics faults;  ///< of the request; if there is one, only `id` and `drawing.language` are of use

    /// Reads a request. Missing keys have the values of `defaults`; parameters are added to those of `defaults`. Every
    /// fault is listed in `faults`, with its place in the JSON text. Opens no file. May be called by several threads.
    static Request parse(std::string_view json, const Request& defaults);
    /// The same with the values above as defaults.
    static Request parse(std::string_view json);
    /// The beginning of a JSON text for a message: at most 80 bytes, control characters and bytes that are not UTF-8
    /// escaped.
    static std::string excerpt(std::string_view json);
};

/// A text as a JSON string, in quotation marks, for an answer. `text` must be UTF-8.
std::string json_string(std::string_view text);

}  // namespace kinegraph
