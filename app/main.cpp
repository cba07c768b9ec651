// The command line: its commands and options, and the exit status. A new command is one function here, which declares
// its options and passes its request to a file of its own. Exceptions from our own faults are caught only here.
#include <fcntl.h>
#include <unistd.h>

#include <kinegraph/version.hpp>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/command_table.hpp"
#include "app/commands/commands.hpp"
#include "app/files/files.hpp"
#include "lang/keys/command_line.hpp"
#include "lang/keys/option_parser.hpp"

namespace kinegraph::app {
namespace {

const std::string& program_version() {
    static const std::string text = "kinegraph " + std::string(version());
    return text;
}
constexpr const char* statuses =
    "Exit status: 0 done; 1 diff found a difference, or an editor left without notice; 2 the command line or the file\n"
    "is wrong, nothing is written; 3 no unique answer (locked, dead point): what could be found is written; 4 the\n"
    "output can't be written, or the font or a module of the program is missing, or the port can't be had; 70 a fault\n"
    "of ours.";

/// The command that was typed, ready to run.
using Action = std::function<Status()>;

CLI::App* add_command(CLI::App& program, const char* name, const char* purpose) {
    CLI::App* command = program.add_subcommand(name, purpose);
    command->set_help_flag("-h,--help", "Print this help");
    command->set_version_flag("--version", program_version(), "Print the version");
    command->footer(statuses);
    return command;
}

/// A number from `least` to `most`; empty if the text is anything else.
std::optional<double> number_within(const std::string& text, double least, double most) {
    double value = 0;
    // This comparison is false for NaN.
    if (!CLI::detail::lexical_cast(text, value) || !(value >= least && value <= most)) return std::nullopt;
    return value;
}

/// The fault that a validator of ours found. The option parser passes its English text on, behind the option's name.
std::optional<Words>& own_fault() {
    static std::optional<Words> fault;
    return fault;
}
std::string fault(Words words) {
    own_fault() = std::move(words);
    return in_english(*own_fault());
}
/// In every language: our own fault, or what the option parser says.
Words words_of(const CLI::ParseError& error) {
    const std::string said = error.what(), own = own_fault() ? in_english(*own_fault()) : "";
    if (own.empty() || !said.ends_with(own)) return library_message(said, lang::option_parser_section);
    return Words(said.substr(0, said.size() - own.size())) + *own_fault();
}

/// A validator for integers from `least` to `most`, digits only. The option parser alone would clamp a number that is
/// too large, and read an empty text as 0.
auto whole_number(std::uint64_t least, std::uint64_t most) {
    return [least, most](const std::string& text) {
        std::uint64_t value = 0;
        const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool whole = end.ec == std::errc() && end.ptr == text.data() + text.size();
        if (whole && value >= least && value <= most) return std::string();
        return fault(
            {lang::command_line::is_not_a_whole_number_from_to, text, std::to_string(least), std::to_string(most)});
    };
}

/// A sanity limit for the number of rows.
constexpr std::uint64_t most_steps = 10'000'000;

/// A share: 0.005 or 0.5%.
std::optional<double> share(const std::string& text) {
    if (!text.ends_with('%')) return number_within(text, 0, 1);
    const auto percent = number_within(text.substr(0, text.size() - 1), 0, 100);
    return percent ? std::optional(*percent / 100) : std::nullopt;
}

/// A validator for numbers from `least` to `most`.
auto number_from(int least, int most) {
    return [least, most](const std::string& text) {
        if (number_within(text, least, most)) return std::string();
        return fault({lang::command_line::is_not_a_number_from_to, text, std::to_string(least), std::to_string(most)});
    };
}

/// The words that options take, or propose, for completion and manual.
std::map<const CLI::Option*, std::vector<std::string>>& words_of_options() {
    static std::map<const CLI::Option*, std::vector<std::string>> words;
    return words;
}
/// Restricts an option to several words.
template <class... Filters>
CLI::Option* one_of(CLI::Option* option, const std::vector<std::string>& words, Filters... filters) {
    words_of_options()[option] = words;
    return option->check(CLI::IsMember(words, filters...));
}
/// The same, in lower or upper case.
CLI::Option* one_of_any_case(CLI::Option* option, const std::vector<std::string>& words) {
    words_of_options()[option] = words;
    return option->transform(CLI::IsMember(words, CLI::ignore_case));
}

/// An option that takes one of several words, in lower or upper case.
void add_choice(CLI::App& command, const char* name, std::string& chosen, const char* help,
                const std::vector<std::string>& words, const char* type) {
    one_of_any_case(command.add_option(name, chosen, help), words)->type_name(type)->capture_default_str();
}

/// The requested language, even if the rest of the command line is wrong.
Language language_asked_for(int count, char** arguments) {
    std::string word;
    for (int i = 1; i < count; ++i) {
        const std::string argument = arguments[i];
        if (argument.starts_with("--lang=")) word = argument.substr(7);
        if (argument == "--lang" && i + 1 < count) word = arguments[i + 1];
    }
    return language_named(word);
}

void add_format(CLI::App& command, std::string& format, const std::vector<std::string>& formats) {
    const char* const help = "What to write where the name of the output does not say it";
    one_of(command.add_option("--format", format, help), formats, CLI::ignore_case)->type_name("FORMAT");
}

void add_language(CLI::App& command, std::string& chosen, const std::string& help) {
    std::vector<std::string> codes;
    std::string listed;
    for (const Language language : languages) {
        codes.push_back(code_of(language));
        listed += (listed.empty() ? ": " : language == languages.back() ? " or " : ", ") + codes.back();
    }
    add_choice(command, "--lang", chosen, (help + listed).c_str(), codes, "LANG");
}

/// The option that replaces values of the file's parameters.
void add_settings(CLI::App& command, std::vector<ParameterValue>& set) {
    command
        .add_option_function<std::vector<std::string>>(
            "--set",
            [&set](const std::vector<std::string>& texts) {
                set.clear();
                for (const std::string& text : texts)
                    set.push_back({text.substr(0, text.find('=')), text.substr(text.find('=') + 1)});
            },
            "A parameter of the file with another value: r=45mm, k=3, \"r==2*k*1mm\"; may be given again")
        ->check([](const std::string& text) {
            const std::size_t sign = text.find('=');
            const bool whole = sign != std::string::npos && sign > 0 && sign + 1 < text.size();
            return whole ? std::string() : fault({lang::command_line::is_not_name_value, text});
        })
        ->allow_extra_args(false)
        ->type_name("NAME=VALUE");
}

/// The arguments of a command that solves: the request, and the texts of options not yet converted.
struct SolveWords {
    SolveRequest request;
    std::string language = "en", paper = "A4", orientation = "landscape", dimensions = "auto", detail = "full",
                sheet = "solution", superposition = "joined", film_height = "720";

    SolveRequest meant() const {
        SolveRequest full = request;
        DrawingOptions& drawing = full.drawing;
        using Options = DrawingOptions;
        drawing.language = language_named(language);
        if (paper == "A3") drawing.paper = Options::Paper::a3;
        if (paper == "letter") drawing.paper = Options::Paper::letter;
        if (dimensions == "on") drawing.dimensions = Options::Dimensions::on;
        if (dimensions == "off") drawing.dimensions = Options::Dimensions::off;
        if (orientation == "portrait") drawing.orientation = Options::Orientation::portrait;
        if (detail == "brief") drawing.detail = Options::Detail::brief;
        if (superposition == "each") drawing.superposition = Options::Superposition::each;
        if (sheet == "question") drawing.sheet = Options::Sheet::question;
        if (sheet == "answers") drawing.sheet = Options::Sheet::answers;
        if (full.beamer) drawing.slides = true;
        full.film_height = std::stoi(film_height);
        return full;
    }
};

void add_outputs(CLI::App& command, SolveRequest& request) {
    command.add_option("FILE", request.file, "The mechanism file; - is standard input")->required();
    command
        .add_option(
            "-o,--output", request.outputs,
            "OUT.svg, .png, .pdf, .tex, .dxf, .json, .html (the live page), .ggb (for GeoGebra), or .mp4, .webm, .gif "
            "(a film of the steps); may be given again. Further pages are OUT-2.svg, OUT-3.svg. "
            "- is standard output and needs --format (of several SVG or PNG pages it carries the first)")
        ->allow_extra_args(false)
        ->type_name("OUT");
    add_format(command, request.format,
               {"svg", "png", "pdf", "tex", "dxf", "json", "html", "mp4", "webm", "gif", "ggb"});
}

void add_paper(CLI::App& command, SolveWords& words) {
    add_language(command, words.language, "Language of sheet, table and messages");
    add_choice(command, "--paper", words.paper, "Size of the sheet: A4, A3 or letter", {"A4", "A3", "letter"}, "PAPER");
    add_choice(command, "--orientation", words.orientation, "How the sheet lies: landscape or portrait",
               {"landscape", "portrait"}, "HOW");
}

/// Options for the content of the drawing.
void add_sheet(CLI::App& command, SolveWords& words) {
    command
        .add_option(
            "--figure", words.request.drawing.figure,
            "One figure alone, on a page of its size: mechanism, centres, velocity, acceleration, forces, closure, "
            "body-3 …; of a wrong name the message lists those there are")
        ->type_name("NAME");
    add_choice(
        command, "--dimensions", words.dimensions,
        "Given lengths, radii and angles on the mechanism figure: auto (each that finds a free place), on (all) or off",
        {"auto", "on", "off"}, "WHICH");
    add_choice(
        command, "--detail", words.detail,
        "How much of the solution is told: full, or brief (mechanism, polygons, the decisive sentences, answers)",
        {"full", "brief"}, "HOW");
    add_choice(
        command, "--superposition", words.superposition,
        "How superposed loads are drawn: joined (one force polygon a body, its sides grouped by load) or each (a "
        "free body and a polygon for each load; of a full solution)",
        {"joined", "each"}, "HOW");
    add_choice(
        command, "--sheet", words.sheet,
        "What is handed out: the solution, the question (the mechanism with its data, what is sought, scales) or the "
        "answers (the key, with tolerances)",
        {"solution", "question", "answers"}, "WHICH");
    command.add_flag("--grid", words.request.drawing.grid,
                     "With --sheet question: blank rooms for the polygons, with pole and grid");
    command
        .add_flag("--steps", words.request.drawing.steps,
                  "The solution as a sequence, each page adding one step: pages of a PDF, or OUT.svg, OUT-2.svg …")
        ->excludes("--figure");
    command
        .add_flag("--slides", words.request.drawing.slides,
                  "With --steps: pages of 16:9 for a projector, with large type and without title block")
        ->excludes("--paper")
        ->excludes("--orientation");
}

void add_film_height(CLI::App& command, std::string& height) {
    add_choice(command, "--height", height, "Height of the pictures of a film, pixels; they are 16:9",
               {"360", "540", "720", "1080", "1440", "2160"}, "N");
}

/// Options of slides in LaTeX, and of a film of the steps.
void add_lecture(CLI::App& command, SolveWords& words) {
    command.add_flag("--beamer", words.request.beamer,
                     "With --steps: OUT.tex for the class beamer, a frame for each figure, an overlay for each step");
    one_of_any_case(
        command.add_option("--captions", words.request.captions,
                           "Where a film has the sentences: file (OUT.vtt beside it), burnt (in the pictures) or none; "
                           "without it file, of a .gif burnt"),
        {"file", "burnt", "none"})
        ->type_name("HOW");
    add_film_height(command, words.film_height);
}

void add_theme(CLI::App& command, std::string& theme) {
    CLI::Option* option = command.add_option(
        "--theme", theme,
        "The look: colour, print (black and one grey), dark (slides), or the path of a theme file (docs/themes.md)");
    words_of_options()[option] = theme_names();
    option->type_name("THEME")->capture_default_str();
}

/// Options for the title block and the page.
void add_print(CLI::App& command, std::string& date, std::string& author, std::string& theme, double& dpi) {
    command.add_option("--date", date, "A date for the title block, as it is to be printed")->type_name("TEXT");
    command.add_option("--author", author, "A name for the title block")->type_name("TEXT");
    add_theme(command, theme);
    command.add_option("--dpi", dpi, "Resolution of a PNG, dots per inch, 20 to 1200")
        ->check(number_from(20, 1200))
        ->type_name("N")
        ->capture_default_str();
}

void add_text(CLI::App& command, Lettering& lettering) {
    one_of_any_case(
        command.add_option_function<std::string>(
            "--text",
            [&lettering](const std::string& how) {
                lettering = how == "live" ? Lettering::live : how == "office" ? Lettering::office : Lettering::outlines;
            },
            "How SVG and PDF carry their words: outlines, live (they can be selected, searched and read aloud) or "
            "office "
            "(an SVG for word processors, in Times New Roman)"),
        {"outlines", "live", "office"})
        ->type_name("HOW")
        ->default_str("outlines");
}

/// Options for the theme and additional figures.
void add_look(CLI::App& command, SolveRequest& request) {
    add_print(command, request.drawing.date, request.drawing.author, request.theme, request.dpi);
    add_text(command, request.lettering);
    CLI::Option* with = command.add_option(
        "--with", request.with,
        "A figure more on the sheet; may be given again. joukowsky: Joukowsky's lever, the powers of the forces as "
        "moments about the pole of the velocities; equations: the closure equations with their Jacobian; virtual "
        "work: virtual displacements and "
        "what they say of the efforts");
    one_of(with, {"joukowsky", "equations", "virtual work"})->allow_extra_args(false)->type_name("FIGURE");
    command.add_flag("--exact", request.exact, "Add exact values to the JSON results, as fractions");
}

void add_driver(CLI::App& command, std::string& driver) {
    command
        .add_option("--driver", driver,
                    "Which driver moves, by the name of its body, joint or point; without it the first of the file. "
                    "Others rest")
        ->type_name("NAME");
}

void add_branch(CLI::App& command, int& branch) {
    command
        .add_option("--branch", branch,
                    "Out of a change point that is drawn: which of the branches that the results list, from 1; without "
                    "it the one "
                    "on which the bodies move least")
        ->check(whole_number(1, 1000))
        ->type_name("N");
}

void add_positions(CLI::App& command, PositionsWanted& positions) {
    command
        .add_option(
            "--at", positions.at,
            "The position in which it is solved: the driver's turn or slide from the drawn one, 30°, 0.5 rad, 20 mm; "
            "may be given again, a sheet each; every 30° for a whole turn")
        ->allow_extra_args(false)
        ->type_name("TURN");
    add_driver(command, positions.driver);
    add_branch(command, positions.branch);
}

void add_solve(CLI::App& program, Action& action) {
    CLI::App* command =
        add_command(program, "solve", "Solve a mechanism: the sheet and the results, or a table on the terminal");
    auto words = std::make_shared<SolveWords>();
    add_outputs(*command, words->request);
    add_settings(*command, words->request.set);
    add_paper(*command, *words);
    add_sheet(*command, *words);
    add_lecture(*command, *words);
    add_look(*command, words->request);
    add_positions(*command, words->request.positions);
    command->callback([&action, words] { action = [words] { return solve_command(words->meant()); }; });
}

void add_batch(CLI::App& program, Action& action) {
    CLI::App* command =
        add_command(program, "batch",
                    "A filter: requests as JSON Lines on standard input, an answer for each, in their order, on "
                    "standard output (docs/format.md)");
    auto request = std::make_shared<BatchRequest>();
    auto words = std::make_shared<SolveWords>();
    command
        ->add_option("--jobs", request->jobs, "So many lines are worked on at a time, each on a processor of its own")
        ->check(whole_number(1, 1024))
        ->type_name("N")
        ->capture_default_str();
    command->add_flag("--resume", request->resume,
                      "What the same line, the same files and the same options have made before is known by its hash "
                      "and not made again");
    add_settings(*command, words->request.set);
    add_paper(*command, *words);
    add_sheet(*command, *words);
    add_look(*command, words->request);
    add_positions(*command, words->request.positions);
    command->callback([&action, request, words] {
        request->defaults = words->meant();
        action = [request] { return batch_command(*request); };
    });
}

/// The arguments of a command whose sheet is no solution.
template <class Request>
struct WordsOf {
    Request request;
    SolveWords sheet;

    Request meant() const {
        Request full = request;
        const SolveRequest words = sheet.meant();
        full.sheet.language = words.drawing.language;
        full.sheet.paper = words.drawing.paper;
        full.sheet.orientation = words.drawing.orientation;
        return full;
    }
};

void add_drivers(CLI::App& command, SweepRequest& request) {
    command
        .add_option("--driver", request.drivers,
                    "Which driver moves, by the name of its body, joint or point; without it the first of the file. "
                    "Given again: a "
                    "driver that goes along, by its --step. Others rest")
        ->allow_extra_args(false)
        ->type_name("NAME");
    command
        .add_option("--step", request.step,
                    "By how much a driver that goes along moves at each step of the first: 2°, -1 mm; one for each, in "
                    "their order")
        ->allow_extra_args(false)
        ->type_name("TURN");
    add_branch(command, request.options.branch);
}

void add_travel(CLI::App& command, SweepRequest& request) {
    command
        .add_option("--from", request.options.from,
                    "Where it starts, from the drawn position: 90°, 1.57 rad, 20 mm; without --from and --to a full "
                    "turn, or from "
                    "limit to limit")
        ->type_name("TURN");
    command.add_option("--to", request.options.to, "Where it ends")->type_name("TURN");
    command.add_option("--steps", request.options.steps, "Steps from the first position to the last")
        ->check(whole_number(0, most_steps))
        ->each([&request](const std::string&) { request.says_steps = true; })
        ->type_name("N")
        ->capture_default_str();
}

void add_plots(CLI::App& command, SweepRequest& request) {
    command
        .add_option(
            "--plot", request.options.plots,
            "Columns of one unit in one plot, up to four, by their names: \"x B,x C\"; may be given again. Without it "
            "what slides or turns last, and the efforts")
        ->allow_extra_args(false)
        ->type_name("QUANTITIES");
    command
        .add_option(
            "--columns", request.options.columns,
            "Which columns the rows have beside the driver's: names of results and expressions of them, such as "
            "\"omega 4 / omega 2, |v B|\"")
        ->type_name("QUANTITIES");
    command
        .add_option("--trace", request.options.traces,
                    "The path of a point, \"P\", or as a body sees it, \"P,on BODY\"; may be given again")
        ->allow_extra_args(false)
        ->type_name("P[,on BODY]");
    command
        .add_option("--centrodes", request.options.centrodes,
                    "The centrodes of body j against body i, the fixed and the moving one: on the drawing and in the "
                    "JSON; may be "
                    "given again")
        ->allow_extra_args(false)
        ->type_name("i,j");
    command.add_option("--poses", request.options.poses, "So many positions thin behind the mechanism")
        ->check(whole_number(0, 360))
        ->type_name("N");
    add_print(command, request.sheet.date, request.sheet.author, request.theme, request.dpi);
    add_text(command, request.lettering);
}

void add_sweep(CLI::App& program, Action& action) {
    CLI::App* command = add_command(
        program, "sweep", "The results in one position after another: rows of numbers, plots, paths of points");
    auto words = std::make_shared<WordsOf<SweepRequest>>();
    SweepRequest& request = words->request;
    command->add_option("FILE", request.file, "The mechanism file; - is standard input")->required();
    command
        ->add_option("-o,--output", request.outputs,
                     "OUT.csv or .json (SI units), .svg, .png, .pdf, .tex or .dxf (the sheet with plots), .mp4, .webm "
                     "or .gif (a film of the motion); may be given again. Without it CSV goes to standard output")
        ->allow_extra_args(false)
        ->type_name("OUT");
    add_format(*command, request.format, {"csv", "json", "svg", "png", "pdf", "tex", "dxf", "mp4", "webm", "gif"});
    add_settings(*command, request.set);
    command->add_option("--frames", request.frames, "Pictures of a film, from one end of the motion to the other")
        ->check(whole_number(2, 720))
        ->type_name("N")
        ->capture_default_str();
    add_film_height(*command, words->sheet.film_height);
    command
        ->add_option("--over", request.options.over,
                     "A parameter of the file that is swept in place of a driver, --from … --to … in --steps or by "
                     "--step: every "
                     "row is the file solved anew")
        ->type_name("PARAMETER");
    add_drivers(*command, request);
    add_travel(*command, request);
    add_plots(*command, request);
    add_paper(*command, words->sheet);
    command->callback([&action, words] {
        action = [words] {
            SweepRequest meant = words->meant();
            meant.film_height = words->sheet.meant().film_height;
            return sweep_command(meant);
        };
    });
}

void add_variants(CLI::App& program, Action& action) {
    CLI::App* command = add_command(program, "variants", "Many exercises of one file: questions, solutions, key");
    auto words = std::make_shared<WordsOf<VariantsRequest>>();
    VariantsRequest& request = words->request;
    command->add_option("FILE", request.file, "The mechanism file, with \"vary\"; - is standard input")->required();
    command->add_option("-o,--output", request.folder, "The folder where they go; made where it is missing")
        ->required()
        ->type_name("OUT/");
    command->add_option("--count", request.count, "How many, 1 to 1000000; without it one for each name of the roster")
        ->check(whole_number(1, 1'000'000))
        ->type_name("N");
    command->add_option("--seed", request.seed, "Which of them: the same seed gives the same variants")
        ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
        ->type_name("S")
        ->capture_default_str();
    command
        ->add_option("--roster", request.roster,
                     "A CSV file with a student on each line, who is named in the title block")
        ->type_name("CSV");
    command->add_flag("--merge", request.merge,
                      "One PDF of all questions and one of all solutions, in place of a file each");
    command->add_flag("--class", request.is_class,
                      "For a class: all copies have the same scales, and each sheet an even number of pages");
    add_choice(*command, "--format", request.format, "What the sheets are: pdf, svg or png", {"pdf", "svg", "png"},
               "FORMAT");
    CLI::Option* platforms = command->add_option(
        "--for", request.platforms,
        "A file for a learning platform besides: moodle (XML), qti (2.1, zipped) or csv; may be given "
        "again, or parted "
        "by commas");
    one_of(platforms, {"moodle", "qti", "csv"})->delimiter(',')->allow_extra_args(false)->type_name("PLATFORM");
    command->add_flag("--resume", request.resume,
                      "What an earlier run of the same request has written whole is not done again");
    add_settings(*command, request.set);
    add_choice(*command, "--detail", words->sheet.detail, "How much of a solution is told: full or brief",
               {"full", "brief"}, "HOW");
    command->add_flag("--grid", request.sheet.grid,
                      "On the questions: blank rooms for the polygons, with pole and grid");
    add_print(*command, request.sheet.date, request.sheet.author, request.theme, request.dpi);
    add_paper(*command, words->sheet);
    command->callback([&action, words] {
        action = [words] {
            VariantsRequest meant = words->meant();
            meant.sheet.detail = words->sheet.meant().drawing.detail;
            return variants_command(meant);
        };
    });
}

void add_cam(CLI::App& program, Action& action) {
    CLI::App* command =
        add_command(program, "cam", "The disc cam that gives a follower its law: profile, pressure angle, curvature");
    auto words = std::make_shared<WordsOf<CamRequest>>();
    CamRequest& request = words->request;
    command->add_option("FILE", request.file, "The cam's file; - is standard input")->required();
    command
        ->add_option(
            "-o,--output", request.outputs,
            "OUT.csv (SI units), .svg, .png, .pdf, .tex or .dxf (the sheet), .html (a page on which the cam turns), "
            ".json (the mechanism file of one position); may be given again. Without it CSV goes to standard "
            "output")
        ->allow_extra_args(false)
        ->type_name("OUT");
    add_format(*command, request.format, {"csv", "json", "svg", "png", "pdf", "tex", "dxf"});
    command
        ->add_option("--at", request.options.at,
                     "The cam's turn at which it is drawn and its mechanism written: 30°, 0.5 rad; without it where "
                     "the law begins")
        ->type_name("TURN");
    command->add_option("--steps", request.options.steps, "Rows over the whole turn")
        ->check(whole_number(0, most_steps))
        ->type_name("N")
        ->capture_default_str();
    add_print(*command, request.sheet.date, request.sheet.author, request.theme, request.dpi);
    add_text(*command, request.lettering);
    add_paper(*command, words->sheet);
    command->callback([&action, words] { action = [words] { return cam_command(words->meant()); }; });
}

void add_check(CLI::App& program, Action& action) {
    CLI::App* command =
        add_command(program, "check", "Read and validate a mechanism file; nothing is solved or written");
    auto request = std::make_shared<CheckRequest>();
    auto language = std::make_shared<std::string>("en");
    command->add_option("FILE", request->file, "The mechanism file; - is standard input")->required();
    add_settings(*command, request->set);
    add_language(*command, *language, "Language of messages");
    command->callback([&action, request, language] {
        request->language = language_named(*language);
        action = [request] { return check_command(*request); };
    });
}

void add_import(CLI::App& program, Action& action) {
    CLI::App* command = add_command(program, "import", "A mechanism file from a link or a saved file of PMKS+");
    auto request = std::make_shared<ImportRequest>();
    auto language = std::make_shared<std::string>("en");
    command
        ->add_option("LINK", request->source,
                     "The link, in quotes (its ? is not for the shell), or the saved file; - is standard input")
        ->required();
    command
        ->add_option("-o,--output", request->outputs,
                     "OUT.json, the mechanism file; without it the file goes to standard output")
        ->allow_extra_args(false)
        ->type_name("OUT");
    add_language(*command, *language, "Language of messages");
    command->callback([&action, request, language] {
        request->language = language_named(*language);
        action = [request] { return import_command(*request); };
    });
}

void add_diff(CLI::App& program, Action& action) {
    CLI::App* command = add_command(program, "diff", "Compare two pictures, PNG or SVG, as the eye does");
    auto request = std::make_shared<DiffRequest>();
    command->add_option("EXPECTED", request->expected, "The picture as it should be; - is standard input")->required();
    command->add_option("ACTUAL", request->actual, "The picture as it is")->required();
    command
        ->add_option("-o,--output", request->output,
                     "Where a PNG goes that shows the expected picture, the difference (red; amber what antialiasing "
                     "explains) and "
                     "the actual picture side by side")
        ->type_name("DIFF.png");
    command
        ->add_option_function<std::string>(
            "--threshold", [request](const std::string& text) { request->threshold = share(text).value_or(0); },
            "The share of pixels that may differ: 0.005 or 0.5%")
        ->check([](const std::string& text) {
            return share(text) ? std::string() : fault({lang::command_line::is_not_a_share, text});
        })
        ->type_name("SHARE")
        ->default_str("0");
    command
        ->add_option("--tolerance", request->tolerance,
                     "How far two colours may be apart and count as the same: 0 not at all, 1 as far as any two")
        ->check(number_from(0, 1))
        ->type_name("T")
        ->capture_default_str();
    command
        ->add_option("--dpi", request->dpi,
                     "Resolution at which an SVG is compared, dots per inch, 20 to 1200; else that of the PNG, or 150")
        ->check(number_from(20, 1200))
        ->type_name("N");
    auto language = std::make_shared<std::string>("en");
    add_language(*command, *language, "Language of messages");
    command->callback([&action, request, language] {
        request->language = language_named(*language);
        action = [request] { return diff_command(*request); };
    });
}

void add_pairs(CLI::App& program, Action& action) {
    CLI::App* command = add_command(
        program, "pairs",
        "The catalogue of pairs, printed or drawn; with FILE, its pairs, its chain, freedoms counted, and the verdict");
    auto words = std::make_shared<WordsOf<PairsRequest>>();
    PairsRequest& request = words->request;
    command->add_option("FILE", request.file, "The mechanism file; - is standard input");
    command
        ->add_option(
            "-o,--output", request.outputs,
            "The catalogue drawn, OUT.svg, .png, .pdf, .tex or .dxf, or what is printed as .json; may be given again. "
            "Further pages "
            "are OUT-2.svg, OUT-3.svg")
        ->allow_extra_args(false)
        ->type_name("OUT");
    one_of(command->add_option("--format", request.format,
                               "text, markdown or json; of what is drawn svg, png, pdf, tex or dxf"),
           {"text", "markdown", "json", "svg", "png", "pdf", "tex", "dxf"})
        ->type_name("FORMAT")
        ->capture_default_str();
    add_print(*command, request.sheet.date, request.sheet.author, request.theme, request.dpi);
    add_paper(*command, words->sheet);
    command->callback([&action, words] { action = [words] { return pairs_command(words->meant()); }; });
}

void add_equations(CLI::App& program, Action& action) {
    CLI::App* command = add_command(
        program, "equations",
        "The closure equations in complex form, their Jacobian, velocity ratios, accelerations; of the motion of a "
        "point the derivatives of its laws");
    auto request = std::make_shared<EquationsRequest>();
    auto language = std::make_shared<std::string>("en");
    command->add_option("FILE", request->file, "The mechanism file; - is standard input")->required();
    add_settings(*command, request->set);
    add_language(*command, *language, "Language");
    add_choice(*command, "--format", request->format,
               "text, latex (a document) or json (matrices and unknowns by name)", {"text", "latex", "json"}, "FORMAT");
    command->callback([&action, request, language] {
        request->language = language_named(*language);
        action = [request] { return equations_command(*request); };
    });
}

void add_schema(CLI::App& program, Action& action) {
    CLI::App* command = add_command(
        program, "schema", "Print the JSON Schema of the mechanism file, by which an editor completes and checks it");
    auto language = std::make_shared<std::string>("en");
    add_language(*command, *language, "Language of messages");
    command->callback([&action, language] {
        action = [language] { return print(std::string(mechanism_schema()), language_named(*language)); };
    });
}

void add_watch(CLI::App& program, Action& action) {
    CLI::App* command =
        add_command(program, "watch", "The live page of a file in your browser, made anew whenever the file is saved");
    auto request = std::make_shared<WatchRequest>();
    auto language = std::make_shared<std::string>("en");
    command->add_option("FILE", request->file, "The mechanism file")->required();
    command
        ->add_option("--port", request->port, "The port on 127.0.0.1, 0 to 65535; without it, or 0, any that is free")
        ->check(whole_number(0, 65535))
        ->type_name("N");
    add_language(*command, *language, "The language that is shown first, and that of messages");
    add_theme(*command, request->theme);
    command->callback([&action, request, language] {
        request->language = language_named(*language);
        action = [request] { return watch_command(*request); };
    });
}

void add_edit(CLI::App& program, Action& action) {
    CLI::App* command =
        add_command(program, "edit", "The workbench in your browser: a mechanism drawn, solved and saved");
    auto request = std::make_shared<EditRequest>();
    auto language = std::make_shared<std::string>("en");
    command->add_option("FILE", request->file, "The mechanism file; one that does not exist is begun")->required();
    command
        ->add_option("--port", request->port, "The port on 127.0.0.1, 0 to 65535; without it, or 0, any that is free")
        ->check(whole_number(0, 65535))
        ->type_name("N");
    add_language(*command, *language, "The language that is shown first, and that of messages");
    command->callback([&action, request, language] {
        request->language = language_named(*language);
        action = [request] { return edit_command(*request); };
    });
}

void add_language_server(CLI::App& program, Action& action) {
    CLI::App* command =
        add_command(program, "language-server",
                    "For editors: faults, completion and the meaning of keys, by the Language Server Protocol on "
                    "standard input and output");
    auto language = std::make_shared<std::string>();
    add_language(*command, *language, "Language of messages; without it the editor's, else English");
    command->callback([&action, language] {
        LanguageServerRequest request;
        if (!language->empty()) request.language = language_named(*language);
        action = [request] { return language_server_command(request); };
    });
}

OptionForm form_of(const CLI::Option& option) {
    OptionForm form;
    form.is_argument = option.get_positional();
    if (form.is_argument) form.names.push_back(option.get_name());
    for (const std::string& letter : option.get_snames()) form.names.push_back("-" + letter);
    for (const std::string& word : option.get_lnames()) form.names.push_back("--" + word);
    const bool has_value = option.get_items_expected_max() > 0;
    // The parser's name of a type lists the words, too.
    if (has_value) form.type = option.get_type_name().substr(0, option.get_type_name().find(':'));
    form.help = option.get_description();
    form.fallback = option.get_default_str();
    const auto words = words_of_options().find(&option);
    if (words != words_of_options().end()) form.words = words->second;
    constexpr std::array paths{"OUT", "OUT/", "CSV", "DIFF.png", "THEME"};
    form.is_path =
        form.words.empty() && (form.is_argument || std::find(paths.begin(), paths.end(), form.type) != paths.end());
    form.is_required = option.get_required();
    return form;
}

/// The command line as data.
CommandTable table_of(const CLI::App& program) {
    CommandTable table{program.get_description(), program_version(), statuses, {}};
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        CommandForm form{command->get_name(), command->get_description(), {}};
        for (const bool arguments : {true, false})
            for (const CLI::Option* option : command->get_options())
                if (option->get_positional() == arguments) form.options.push_back(form_of(*option));
        table.commands.push_back(std::move(form));
    }
    return table;
}

/// This command and the next print what is made of the table of all commands, themselves included.
void add_completion(CLI::App& program, Action& action) {
    CLI::App* command =
        add_command(program, "completion", "Print the script by which a shell completes this command line");
    auto shell = std::make_shared<std::string>();
    auto language = std::make_shared<std::string>("en");
    one_of(command->add_option("SHELL", *shell, "bash, zsh or fish"), {"bash", "zsh", "fish"})->required();
    add_language(*command, *language, "Language of messages");
    command->callback([&program, &action, shell, language] {
        action = [&program, shell, language] {
            return print(completion_script(table_of(program), *shell), language_named(*language));
        };
    });
}
void add_manual(CLI::App& program, Action& action) {
    CLI::App* command = add_command(program, "manual", "Print a manual page, for man -l, or write all of them");
    auto about = std::make_shared<std::string>();
    auto folder = std::make_shared<std::string>();
    auto language = std::make_shared<std::string>("en");
    std::vector<std::string> names;
    for (const CLI::App* each : program.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(each->get_name());
    one_of(command->add_option("COMMAND", *about, "The command that is described; without it the program"), names);
    command->add_option("-o,--output", *folder, "The folder into which all pages go: kinegraph.1, kinegraph-solve.1 …")
        ->type_name("OUT/");
    add_language(*command, *language, "Language of messages");
    command->callback([&program, &action, about, folder, language] {
        action = [&program, about, folder, language] {
            const CommandTable table = table_of(program);
            if (folder->empty()) return print(manual_page(table, *about), language_named(*language));
            return write_manual(table, *folder, language_named(*language));
        };
    });
}

Status run(int count, char** arguments, Language language) {
    CLI::App program("Planar mechanisms solved as at the drawing board, exactly.", "kinegraph");
    program.set_help_flag("-h,--help", "Print this help; after a command, its own");
    program.set_version_flag("--version", program_version(), "Print the version");
    program.footer(statuses);
    program.require_subcommand(1);
    Action action;
    for (const auto add :
         {add_solve, add_sweep, add_variants, add_cam, add_check, add_import, add_diff, add_pairs, add_equations,
          add_schema, add_batch, add_watch, add_edit, add_language_server, add_completion, add_manual})
        add(program, action);

    const std::string first = count > 1 ? arguments[1] : "";
    if (first.empty() || first[0] != '-') {
        std::string known;
        bool named = false;
        for (const CLI::App* command : program.get_subcommands([](CLI::App*) { return true; })) {
            known += (known.empty() ? "" : ", ") + command->get_name();
            named = named || command->get_name() == first;
        }
        if (!named) {
            return refuse({lang::command_line::there_are_kinegraph_help_says_more,
                           first.empty() ? Words(lang::command_line::a_command_is_missing)
                                         : Words(lang::command_line::no_command_is_named, first),
                           known},
                          language);
        }
    }
    // Joins "--at every 30°" into one argument. CLI11 takes its arguments in reverse order.
    std::vector<std::string> words;
    for (int i = count; i-- > 1;) {
        if (!words.empty() && arguments[i] == std::string("every") && i > 1 && arguments[i - 1] == std::string("--at"))
            words.back() = "every " + words.back();
        else
            words.emplace_back(arguments[i]);
    }
    try {
        program.parse(std::move(words));
    } catch (const CLI::CallForHelp&) {
        return print(program.help(), language);
    } catch (const CLI::CallForVersion&) {
        return print(program_version() + '\n', language);
    } catch (const CLI::ParseError& error) {
        const auto given = program.get_subcommands();
        const std::string command = given.empty() ? "kinegraph" : "kinegraph " + given.front()->get_name();
        return refuse({lang::command_line::help_says_more, words_of(error), command}, language);
    }
    return action();
}

/// Opens a stand-in for each closed standard stream. Otherwise the next file opened would get its number, and messages
/// would end in an output. A stand-in fails like the closed stream: input cannot be read, output cannot be written.
void hold_standard_streams() {
    for (int stream = 0; stream < 3; ++stream)
        if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace
}  // namespace kinegraph::app

int main(int count, char** arguments) {
    using namespace kinegraph::app;
    using kinegraph::Language, kinegraph::Words;
    namespace lang = kinegraph::lang;
    hold_standard_streams();
    // A closed pipe and a file size limit are reported as write errors.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    const Language language = language_asked_for(count, arguments);
    // Said before there is a fault: where memory lacks, the texts could not be read.
    const std::string& ours = lang::command_line::this_is_a_fault_of_ours_2.in(language);
    const std::string out_of_memory = ours + lang::command_line::out_of_memory.in(language);
    try {
        return static_cast<int>(run(count, arguments, language));
    } catch (const std::bad_alloc&) {
        refuse(out_of_memory, language);
    } catch (const std::exception& fault) {
        refuse(Words(lang::command_line::this_is_a_fault_of_ours, std::string(fault.what())), language);
    } catch (...) {
        refuse(ours, language);
    }
    return static_cast<int>(Status::fault);
}
