// The program's commands: each has a request with the options of the command line, and a function that executes it and
// returns the exit status. One file for each command; only main.cpp knows the spelling of the options.
#pragma once

#include <kinegraph/motion.hpp>
#include <kinegraph/request.hpp>

#include <optional>
#include <string>
#include <vector>

#include "app/files/messages.hpp"

namespace kinegraph::app {

/// solve FILE: a table on the terminal, or sheets and results in files. A line of `batch` is such a request, too.
struct SolveRequest : Request {
    std::vector<std::string> outputs;  ///< "-" is standard output
    std::string format;                ///< svg, png, pdf, json: for outputs without a known extension; may be empty
    Lettering lettering = Lettering::outlines;
    bool beamer = false;    ///< LaTeX for the class beamer, of steps
    std::string captions;   ///< of a film: file, burnt or none; empty: not said, file
    int film_height = 720;  ///< of a film, pixels

    Language language() const { return drawing.language; }
};
Status solve_command(const SolveRequest& request);

/// batch: a filter with JSON Lines as input and output; each line is a request to solve.
struct BatchRequest {
    SolveRequest defaults;  ///< for keys that a line does not have
    int jobs = 1;           ///< number of lines processed in parallel
    bool resume = false;    ///< skip lines that an earlier run has done
};
Status batch_command(const BatchRequest& request);

/// sweep FILE: the results in a sequence of positions.
struct SweepRequest {
    std::string file;
    std::vector<ParameterValue> set;  ///< values that replace parameters of the file
    std::vector<std::string> outputs;
    std::string format;
    SweepOptions options;              ///< without drivers and step
    std::vector<std::string> drivers;  ///< by name: the first moves, the others follow; empty: the first of the file
    std::vector<std::string> step;     ///< quantities: step of each driver that follows, or of the parameter
    bool says_steps = false;           ///< whether their number is said, too
    DrawingOptions sheet;
    std::string theme = "colour";
    Lettering lettering = Lettering::outlines;
    double dpi = 150;
    int frames = 120;       ///< of a film, for one way
    int film_height = 720;  ///< pixels
};
Status sweep_command(const SweepRequest& request);

/// variants FILE: many variants of one exercise, each with its question, its solution and a line of the answer key.
struct VariantsRequest {
    std::string file;
    std::vector<ParameterValue> set;     ///< values that replace parameters of the file
    long count = 0;                      ///< number of variants; 0: one for each student of the roster
    unsigned long long seed = 1;         ///< seed of the random values
    std::string roster;                  ///< a file of names; empty: none
    bool merge = false;                  ///< all questions in one PDF, all solutions in another
    bool is_class = false;               ///< all copies have the same scales and an even number of pages
    std::string folder;                  ///< output folder
    std::string format = "pdf";          ///< of the sheets: pdf, svg, png
    std::vector<std::string> platforms;  ///< moodle, qti, csv: additional files for learning platforms
    bool resume = false;                 ///< do not write files again that are complete and from the same request
    DrawingOptions sheet;
    std::string theme = "colour";
    double dpi = 150;
};
Status variants_command(const VariantsRequest& request);

/// cam FILE: the disc cam that gives its follower a law.
struct CamRequest {
    std::string file;
    std::vector<std::string> outputs;
    std::string format;
    CamOptions options;
    DrawingOptions sheet;
    std::string theme = "colour";
    Lettering lettering = Lettering::outlines;
    double dpi = 150;
};
Status cam_command(const CamRequest& request);

/// check FILE: reads the file, finds its points and reports likely mistakes. Solves and writes nothing.
struct CheckRequest {
    std::string file;
    std::vector<ParameterValue> set;
    Language language = Language::en;
};
Status check_command(const CheckRequest& request);

/// import LINK|FILE: a mechanism file from another program's drawing, with remarks on what changed.
struct ImportRequest {
    std::string source;  ///< an address with a question mark, or a file; "-" is standard input
    std::vector<std::string> outputs;
    Language language = Language::en;
};
Status import_command(const ImportRequest& request);

/// diff EXPECTED ACTUAL: whether two pictures (PNG or SVG) look the same.
struct DiffRequest {
    std::string expected, actual;  ///< "-" is standard input, allowed for one of them
    std::string output;            ///< path of the difference picture; may be empty
    double threshold = 0;          ///< share of pixels that may differ
    double tolerance = 0.1;        ///< allowed distance of two colours, as a share of the largest distance
    double dpi = 0;                ///< for SVG; 0: that of the PNG it is compared with, or 150
    Language language = Language::en;
};
Status diff_command(const DiffRequest& request);

/// pairs [FILE]: the catalogue of pairs, printed or drawn, or the pairs of a mechanism.
struct PairsRequest {
    std::string file;  ///< "-" is standard input; empty: the catalogue
    std::vector<std::string> outputs;
    std::string format = "text";  ///< text, markdown, json; for drawings svg, png, pdf
    DrawingOptions sheet;
    std::string theme = "colour";
    double dpi = 150;
};
Status pairs_command(const PairsRequest& request);

/// equations FILE: the closure equations with their derivatives and values.
struct EquationsRequest {
    std::string file;                 ///< "-" is standard input
    std::vector<ParameterValue> set;  ///< parameters in place of the file's
    Language language = Language::en;
    std::string format = "text";  ///< or "latex", "json"
};
Status equations_command(const EquationsRequest& request);

/// watch FILE: serves the live page on this machine and makes it again whenever the file is saved.
struct WatchRequest {
    std::string file;
    int port = 0;  ///< 0: any that is free
    Language language = Language::en;
    std::string theme = "colour";  ///< a built-in theme, or the path of a theme file
};
/// Returns when interrupted (Ctrl-C).
Status watch_command(const WatchRequest& request);

/// edit FILE: serves the workbench, in which the file is drawn, solved and saved.
struct EditRequest {
    std::string file;
    Language language = Language::en;
    int port = 0;  ///< 0: any that is free
};
Status edit_command(const EditRequest& request);

/// language-server: faults, completion and the meaning of keys, for an editor.
struct LanguageServerRequest {
    std::optional<Language> language;  ///< of messages; none: the editor's
};
Status language_server_command(const LanguageServerRequest& request);

/// Reads a mechanism file; returns a status after errors were reported.
tl::expected<MechanismFile, Status> mechanism_of(const std::string& file, Language language,
                                                 const std::vector<ParameterValue>& set = {});
/// The file name without its folder, so that a sheet is the same wherever it is made.
std::string bare_name(const std::string& file);
/// The message for a command that needs joints when the file states a problem without joints.
Words no_mechanism(const char* command);

}  // namespace kinegraph::app
