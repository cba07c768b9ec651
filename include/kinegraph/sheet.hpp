/// \file
/// Drawings: sheets, single figures, steps and live pages of a solution, and their bytes.
///
/// Everything is drawn to scale in millimetres. The same solution and options give the same bytes on every machine.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <kinegraph/error.hpp>
#include <kinegraph/solution.hpp>

namespace kinegraph {

/// How a solution is drawn.
struct DrawingOptions {
    /// Sizes of paper.
    enum class Paper { a4, a3, letter };
    /// How the paper lies.
    enum class Orientation { landscape, portrait };
    /// Whether the given lengths and angles stand on the mechanism's figure.
    enum class Dimensions { automatic, on, off };
    /// How much of a solution is told; brief: what a lecturer chalks up.
    enum class Detail { full, brief };
    /// What the pages are for: the worked solution, the exercise as it is handed out, the key.
    enum class Sheet { solution, question, answers };

    Language language = Language::en;                  ///< of all words on the drawing
    Paper paper = Paper::a4;                           ///< of every page
    Orientation orientation = Orientation::landscape;  ///< of every page
    Dimensions dimensions = Dimensions::automatic;     ///< of lengths and angles
    Detail detail = Detail::full;                      ///< of a solution
    Sheet sheet = Sheet::solution;                     ///< what the pages are for
    bool steps = false;                                ///< a page for each sentence instead of the sheet
    bool grid = false;             ///< a question gets blank rooms with pole and grid for its polygons
    bool lever = false;            ///< with Joukowsky's lever, where forces and velocities are known
    std::string figure;            ///< this figure alone, by a name of figure_names(); empty: the sheet
    std::string author;            ///< in the title block; empty: none
    std::string date;              ///< in the title block; empty: none
    std::string theme = "colour";  ///< "colour", "print" (black and grey) or "dark", where theme_file is empty
    std::string theme_file;        ///< the text of a theme file (docs/themes.md)
};

/// How SVG and PDF carry their words.
enum class Lettering {
    outlines,  ///< as outlines: the same picture everywhere
    live       ///< with text that can be selected, searched and read aloud
};

/// Pages laid out, with nothing left to decide. An immutable value; several threads may read one at the same time.
class Drawing {
public:
    /// How many pages there are, at least one.
    std::size_t pages() const;
    /// SVG 1.1, a document for each page; ids, classes and data attributes as docs/drawing.md says.
    std::vector<std::string> svg(Lettering lettering = Lettering::outlines) const;
    /// PNG of one page (from 0), RGB or grey, 8 bits, at `dpi` dots per inch (20 to 1200). Fails with Kind::output
    /// where the library that paints is missing, and where there is no such page.
    Expected<std::string> png(std::size_t page = 0, double dpi = 150) const;
    /// PDF with all pages. Fails with Kind::output where the library that paints is missing.
    Expected<std::string> pdf(Lettering lettering = Lettering::outlines) const;
    /// A LaTeX document for pdflatex with a TikZ picture for each page; read by \c \\input, the pictures alone.
    std::string tex() const;
    /// What a reader of the drawing should know: characters that the font has not, answers that no reading tells.
    std::vector<Text> remarks() const;

    /// \cond private
    struct State;
    explicit Drawing(Shared<const State> state) : state_(std::move(state)) {}
    const State& state() const { return *state_; }
    /// \endcond

private:
    Shared<const State> state_;
};

/// Lays out a solution. Fails for a figure of an unknown name, for a theme with faults (each with its place in
/// the theme), and with Kind::output where the font is missing. A thread that draws keeps its fonts open for its next
/// drawing; nothing is to be called before or after.
Expected<Drawing> draw(const Solved& solved, const DrawingOptions& options = {});
/// The same of several solutions in one document, in their order: positions of one mechanism.
Expected<Drawing> draw(const std::vector<Solved>& solved, const DrawingOptions& options = {});
/// The names of the figures that may be drawn alone, in the sheet's order.
Expected<std::vector<std::string>> figure_names(const Solved& solved, const DrawingOptions& options = {});
/// The live page: one HTML file that needs nothing else, in which the mechanism is moved and the construction follows.
/// Paper, figure, steps and sheet of the options are not used. Fails as draw() does.
Expected<std::string> live_page(const Solved& solved, const DrawingOptions& options = {});
/// The drawn catalogue of pairs. Fails as draw() does.
Expected<Drawing> draw_pair_catalogue(const DrawingOptions& options = {});

}  // namespace kinegraph
