// The program's commands, each a request as the command line gives it and a function that carries it out and says how
// it ended. One file for each command; main.cpp alone knows the options' spelling.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/files/messages.hpp"
#include "render/sheet/sheet.hpp"
#include "render/tables/pair_tables.hpp"

namespace kinegraph::app {

/// solve FILE: the table on the terminal, or sheets and results in files.
struct SolveRequest {
    std::string file;  ///< "-" is standard input
    std::optional<std::string>
        text;                  ///< what the file holds, where it is at hand: `file` is then its name and is not opened
    std::vector<Setting> set;  ///< parameters in place of the file's
    std::vector<std::string> outputs;  ///< "-" is standard output
    std::string format;                ///< svg, png, pdf, json: for outputs whose name does not say; may be empty
    Language language = Language::en;
    render::Paper paper = render::Paper::a4;
    render::Orientation orientation = render::Orientation::landscape;
    render::Dimensions dimensions = render::Dimensions::automatic;
    std::string author, date;      ///< in the title block, where given
    std::string figure;            ///< this one alone; empty: the sheet
    bool live_text = false;        ///< words of SVG and PDF can be selected, searched and read aloud
    std::string theme = "colour";  ///< a built-in theme, or the path of a theme file
    bool steps = false;            ///< the solution as a sequence of pages
    render::SolutionDetail detail = render::SolutionDetail::full;
    render::SheetKind sheet = render::SheetKind::solution;
    bool grid = false;  ///< blank rooms with pole and grid on a question
    double dpi = 150;
    bool exact = false;
    std::vector<std::string> at;  ///< positions: "30°", "every 30°"; empty: the drawn one
    std::string driver;           ///< whose coordinate `at` is; empty: the first of the file
    int branch = 0;  ///< out of a change point that is drawn: from 1, as results list them; 0: none is asked for
    std::vector<std::string> with;  ///< figures on request: "joukowsky"
};
Status solve_command(const SolveRequest& request);

/// batch: a filter, JSON Lines in and out, each line a request to solve.
struct BatchRequest {
    SolveRequest defaults;  ///< what a line does not say
    int jobs = 1;           ///< lines worked on at a time
    bool resume = false;    ///< what has been done before is not done again
};
Status batch_command(const BatchRequest& request);

/// sweep FILE: the results in one position after another.
struct SweepRequest {
    std::string file;
    std::vector<Setting> set;  ///< parameters in place of the file's
    std::vector<std::string> outputs;
    std::string format;
    std::string over;  ///< a parameter that takes the place of the driver; empty: none
    std::vector<std::string>
        drivers;  ///< by name: the one that moves, and those that go along; empty: the first of the file
    std::vector<std::string> step;  ///< quantities: by how much those that go along move at each step, or the parameter
    int branch = 0;                 ///< out of a change point that is drawn: from 1; 0: none is asked for
    std::string from, to;           ///< quantities, as a file writes them; empty: a full turn, or from limit to limit
    long steps = 360;
    std::vector<std::string> plots;      ///< columns by name, parted by commas; empty: what suits
    std::vector<std::string> traces;     ///< "P" or "P,on BODY"
    std::vector<std::string> centrodes;  ///< pairs of bodies, "i,j"
    int poses = 0;
    render::SheetOptions sheet;
    std::string theme = "colour";
    bool live_text = false;  ///< as a solution's
    double dpi = 150;
};
Status sweep_command(const SweepRequest& request);

/// variants FILE: many exercises of one, each with its question, its solution and a line of the key.
struct VariantsRequest {
    std::string file;
    std::vector<Setting> set;            ///< parameters in place of the file's
    long count = 0;                      ///< how many; 0: one for each student of the roster
    unsigned long long seed = 1;         ///< which of them
    std::string roster;                  ///< a file of names; empty: none
    bool merge = false;                  ///< all questions in one PDF, and all solutions
    std::string folder;                  ///< where they go
    std::string format = "pdf";          ///< of the sheets: pdf, svg, png
    std::vector<std::string> platforms;  ///< moodle, qti, csv: files for learning platforms besides
    bool resume = false;                 ///< what is there, whole and from the same request, is not written again
    render::SheetOptions sheet;
    std::string theme = "colour";
    double dpi = 150;
};
Status variants_command(const VariantsRequest& request);

/// cam FILE: the disc cam that gives its follower a law.
struct CamRequest {
    std::string file;
    std::vector<std::string> outputs;
    std::string format;
    std::string at;  ///< the cam's turn at which its mechanism is written and drawn; empty: where the law begins
    long steps = 360;
    render::SheetOptions sheet;
    std::string theme = "colour";
    bool live_text = false;  ///< as a solution's
    double dpi = 150;
};
Status cam_command(const CamRequest& request);

/// check FILE: the file is read, its points are found, what was probably forgotten is said; nothing is solved or
/// written.
struct CheckRequest {
    std::string file;
    std::vector<Setting> set;
    Language language = Language::en;
};
Status check_command(const CheckRequest& request);

/// diff EXPECTED ACTUAL: whether two pictures, PNG or SVG, are the same to the eye.
struct DiffRequest {
    std::string expected, actual;  ///< "-" is standard input, for one of them
    std::string output;            ///< where the difference picture goes; may be empty
    double threshold = 0;          ///< the share of pixels that may differ
    double tolerance = 0.1;        ///< how far two colours may be apart, of the farthest
    double dpi = 0;                ///< for SVG; 0: as a PNG it is compared with, or 150
    Language language = Language::en;
};
Status diff_command(const DiffRequest& request);

/// pairs [FILE]: the catalogue of pairs, printed or drawn, or the pairs of a mechanism.
struct PairsRequest {
    std::string file;  ///< "-" is standard input; empty: the catalogue
    std::vector<std::string> outputs;
    std::string format = "text";  ///< text, markdown, json; of drawings svg, png, pdf
    render::SheetOptions sheet;
    std::string theme = "colour";
    double dpi = 150;
};
Status pairs_command(const PairsRequest& request);

/// equations FILE: the closure equations with their derivatives and values.
struct EquationsRequest {
    std::string file;          ///< "-" is standard input
    std::vector<Setting> set;  ///< parameters in place of the file's
    Language language = Language::en;
    std::string format = "text";  ///< or "latex", "json"
};
Status equations_command(const EquationsRequest& request);

/// watch FILE: the live page, served on this machine, made anew whenever the file is saved.
struct WatchRequest {
    std::string file;
    int port = 0;  ///< 0: any that is free
    Language language = Language::en;
    std::string theme = "colour";  ///< a built-in theme, or the path of a theme file
};
/// Returns when it is interrupted (Ctrl-C).
Status watch_command(const WatchRequest& request);

/// How messages call a file: its path as given, or "standard input".
Words spoken(const std::string& file);
/// A mechanism file read; else it has been said what is wrong.
tl::expected<Mechanism, Status> mechanism_of(const std::string& file, Language language,
                                             std::span<const Setting> set = {});
/// The same without its folder: what a sheet may show, the same wherever it is made.
std::string bare_name(const std::string& file);
/// Why a command that moves or counts joints has nothing to do with a file that states a problem in place of them.
Words no_mechanism(const char* command);

}  // namespace kinegraph::app
