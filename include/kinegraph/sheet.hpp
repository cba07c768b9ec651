/// \file
/// Drawings: sheets, single figures, steps and live pages of a solution, and their bytes.
///
/// Everything is drawn to scale in millimetres. The same solution and options give the same bytes on every machine.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <kinegraph/error.hpp>
#include <kinegraph/solution.hpp>

namespace kinegraph {

/// Scales of the figures of a sheet, for other sheets that are to have the same ones, such as those of a class.
struct FigureScales {
    /// By name, as in figure_names(), in units of the figure (m, m/s, m/s², N) per millimetre of paper.
    std::map<std::string, double> of_figures;
    std::optional<double>
        of_forces;  ///< the common scale of force polygons; none: there are none, or the file gives it
    /// Takes for each figure the coarser of both scales, with which both have room.
    void add(const FigureScales& other);
};

/// Options of a drawing.
struct DrawingOptions {
    /// Sizes of paper.
    enum class Paper { a4, a3, letter };
    /// Orientation of the paper.
    enum class Orientation { landscape, portrait };
    /// Whether the mechanism's figure shows the given lengths and angles.
    enum class Dimensions { automatic, on, off };
    /// Amount of detail; brief: what a lecturer would write on the board.
    enum class Detail { full, brief };
    /// How a superposition is drawn: one force polygon a body, its sides grouped by load; or the figures of each load.
    enum class Superposition { joined, each };
    /// Purpose of the pages: the worked solution, the exercise as handed out, or its answers.
    enum class Sheet { solution, question, answers };

    Language language = Language::en;                     ///< of all text on the drawing
    Paper paper = Paper::a4;                              ///< of every page
    Orientation orientation = Orientation::landscape;     ///< of every page
    Dimensions dimensions = Dimensions::automatic;        ///< whether to show lengths and angles
    Detail detail = Detail::full;                         ///< of a solution
    Superposition superposition = Superposition::joined;  ///< each: of a full solution only
    Sheet sheet = Sheet::solution;                        ///< what the pages are for
    bool steps = false;                                   ///< one page for each sentence instead of the sheet
    bool slides = false;  ///< with `steps`: pages of 16:9 for a projector, without title block; `paper` has no meaning
    int growing = 0;      ///< of slides for a film: so many pages before each, on which its new lines grow
    bool sentences = true;    ///< of slides: false leaves the sentences to captions, see Drawing::sentences()
    bool grid = false;        ///< a question gets blank space with pole and grid for its polygons
    bool lever = false;       ///< adds Joukowsky's lever, where forces and velocities are known
    bool even_pages = false;  ///< an empty page follows an odd number of pages, for printing on both sides
    std::optional<FigureScales> scales;  ///< of a sheet, kept as far as a page can hold the figures; none: its own
    std::string figure;                  ///< only this figure, a name from figure_names(); empty: the whole sheet
    std::string author;                  ///< in the title block; empty: none
    std::string date;                    ///< in the title block; empty: none
    std::string theme = "colour";        ///< "colour", "print" (black and grey) or "dark"; used if theme_file is empty
    std::string theme_file;              ///< the text of a theme file (docs/themes.md)
};

/// How SVG and PDF store text.
enum class Lettering {
    outlines,  ///< as outlines: the picture does not depend on installed fonts
    live,      ///< as text that can be selected, searched and read aloud, with its font in the file
    office     ///< an SVG as text in Times New Roman, which word processors have; a PDF as live
};

/// Finished pages. An immutable value; several threads may read the same one.
class Drawing {
public:
    /// Number of pages, at least one.
    std::size_t pages() const;
    /// One SVG 1.1 document for each page. For ids, classes and data attributes see docs/drawing.md.
    std::vector<std::string> svg(Lettering lettering = Lettering::outlines) const;
    /// PNG of one page (from 0), RGB or grey, 8 bits, at `dpi` dots per inch (20 to 1200). Fails with Kind::output if
    /// the rendering library is missing or the page does not exist.
    Expected<std::string> png(std::size_t page = 0, double dpi = 150) const;
    /// PDF with all pages. Fails with Kind::output if the rendering library is missing.
    Expected<std::string> pdf(Lettering lettering = Lettering::outlines) const;
    /// A LaTeX document for pdflatex with a TikZ picture for each page. Included by \c \\input it gives the pictures
    /// only.
    std::string tex() const;
    /// LaTeX for the class beamer: a frame for each figure of slides (DrawingOptions::slides), an overlay for each
    /// step, the sentences as text. A page that is no slide is a frame by itself. For pdflatex or lualatex, twice.
    std::string beamer() const;
    /// One DXF drawing (AutoCAD 2007) for each page, mm, for programs of drafting. For its layers see docs/drawing.md.
    std::vector<std::string> dxf() const;
    /// What a page of steps says, in plain text; empty for other pages, and for a page that does not exist.
    std::string sentences(std::size_t page) const;
    /// Whether a page is one of those before a slide on which its lines grow (DrawingOptions::growing).
    bool grows(std::size_t page) const;
    /// Warnings about the drawing: characters missing from the font, requested answers that the drawing does not show.
    std::vector<Text> remarks() const;
    /// Characters missing from the font, in Unicode order: "U+4E2D". They are drawn as this code in a box.
    const std::vector<std::string>& missing_characters() const;

    /// \cond private
    struct State;
    explicit Drawing(Shared<const State> state) : state_(std::move(state)) {}
    const State& state() const { return *state_; }
    /// \endcond

private:
    Shared<const State> state_;
};

/// Lays out a solution. Fails for an unknown figure name, for a theme with faults (each with its place in the theme),
/// and with Kind::output if the font is missing. Each thread keeps its fonts open for its next drawing; no set-up or
/// clean-up is needed.
Expected<Drawing> draw(const Solved& solved, const DrawingOptions& options = {});
/// The scales of the figures of a solution's sheet. Fails as draw() does.
Expected<FigureScales> figure_scales(const Solved& solved, const DrawingOptions& options = {});
/// Draws several solutions in one document, in the given order, for example positions of one mechanism.
Expected<Drawing> draw(const std::vector<Solved>& solved, const DrawingOptions& options = {});
/// The pages of several drawings in one document, in the given order. Fails if there are none.
Expected<Drawing> joined(const std::vector<Drawing>& drawings);
/// The remark on characters missing from the font, for several drawings together: each is named once.
Text remark_on_missing(const std::vector<std::string>& characters);
/// Names of the figures that can be drawn alone, in the sheet's order.
Expected<std::vector<std::string>> figure_names(const Solved& solved, const DrawingOptions& options = {});
/// A live page: one self-contained HTML file in which the user moves the mechanism and the construction follows.
struct LivePage {
    std::string html;           ///< UTF-8
    std::vector<Text> remarks;  ///< characters missing from the font
};
/// Makes the live page. Ignores the paper, figure, steps and sheet options. `version`: of a page that a server makes
/// again whenever the file changes, from 1: the page asks the server for a later one (docs/live_page.md); 0: none.
/// Fails as draw() does.
Expected<LivePage> live_page(const Solved& solved, const DrawingOptions& options = {}, int version = 0);
/// The page to serve until the file called `name` has been solved for the first time. Fails as draw() does.
Expected<std::string> waiting_page(const std::string& name, const DrawingOptions& options = {});
/// A construction for GeoGebra.
struct GeoGebraFile {
    std::string bytes;          ///< a .ggb file
    std::vector<Text> remarks;  ///< what it leaves out
};
/// Makes a construction for GeoGebra: the points placed as in the file, then the record of velocities, accelerations
/// and instant centres as commands that follow when a point is dragged. SI units; forces are left out. Uses the
/// language and the theme of the options. Fails for a file without joints, in another position than the drawn one,
/// where a stroke has no command, and with Kind::output if the library for archives is missing.
Expected<GeoGebraFile> geogebra_file(const Solved& solved, const DrawingOptions& options = {});
/// The XML of that construction, "geogebra.xml" in the archive, for programs that pack it themselves. Fails as
/// geogebra_file() does, but for the library.
Expected<std::string> geogebra_xml(const Solved& solved, const DrawingOptions& options = {});
/// The built-in themes.
std::vector<std::string> theme_names();
/// Reads the text of a theme file. Fails with all its faults, each with its place.
Expected<void> check_theme(std::string_view theme_file);
/// The illustrated catalogue of pairs. Fails as draw() does.
Expected<Drawing> draw_pair_catalogue(const DrawingOptions& options = {});

}  // namespace kinegraph
