// Bands: a solution as a sequence of questions, each with its figures and text. Owns the grouping and the reading
// order; chooses neither position nor size.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "render/content/wanted_figures.hpp"
#include "render/equations/equation_block.hpp"
#include "render/equations/equation_text.hpp"
#include "render/equations/prose.hpp"
#include "render/page/block.hpp"
#include "render/scene/line_numbers.hpp"
#include "render/tables/tables.hpp"

namespace kinegraph::render {

/// Rows under a heading. In the next column a table repeats its head; on the next page the heading is repeated, too.
struct Passage {
    SharedBlock heading, heading_again;  ///< height 0: none
    SharedBlock head;
    std::vector<SharedBlock> rows{};
    bool is_table = false;  ///< rows that are read together: no few of them stand alone in a column

    void take_rows(std::vector<Block> blocks);
    /// The first line of a table is its head. Without lines there are neither head nor rows.
    void take_table(std::vector<Block> lines);
    void take_table(std::vector<SharedBlock> lines);
};

/// One question of the solution: the unit that a page plan places.
struct Band {
    /// The parts of its text, in order.
    struct Part {
        enum class Kind {
            bodies,
            mobility,
            centres,
            steps,
            results,
            reactions,
            bars,
            lever,
            equations,
            answers,
            unsolved,
            remarks
        } kind;
        std::vector<std::size_t> which{};  ///< steps: statements; results: rows of the table; equations: the first and
                                           ///< last item of a section
    };
    std::string question;
    std::vector<std::size_t> figures{};  ///< indices into WantedFigures::list, left to right
    std::vector<Part> parts{};
    std::size_t first_row = 0;  ///< of its text; the text is divided only if no page can hold all of it
    std::size_t end_row = std::numeric_limits<std::size_t>::max();
};

/// The sentence of a statement. Cached.
struct Said {
    Paragraph sentence;
    std::optional<SharedBlock> equation{};  ///< in one row, at its natural width
};
/// Cache of what does not depend on the width.
struct MadeOnce {
    NaturalBlocks natural{};             ///< of the equations, at their natural width
    std::map<std::size_t, Said> said{};  ///< by index of the statement
    std::optional<CentresTable> centres{};
    std::optional<BodiesTable> bodies{};
    std::vector<Paragraph> conventions{};
};

/// The rows of a band, cut out of the text of the whole question. A continuation begins in the middle of it.
std::vector<Passage> own_rows(const std::vector<Passage>& text, const Band& band);

/// The bands of a solution, and their text for a given width.
class Bands {
public:
    /// Statements that say the same of other subjects are merged into one sentence. Brief: only the decisive sentences,
    /// and the answers in place of all results.
    Bands(const DrawingContext& context, const WantedFigures& wanted, SolutionDetail detail = SolutionDetail::full);

    std::vector<Band> list;

    /// Adds a remark on a drawn figure. False if it has this remark already.
    bool remark(const std::string& figure, const RichText& text);

    /// Adds "Fig. 1–3, sheet 1" where text continues on another page. `page` counts from 0.
    void tell_figures(const std::string& question, int first, int last, std::size_t page);

    /// Rows of all results. Lengths are measured on those figures that were drawn.
    std::vector<ResultRow> results_on(const std::vector<Figure>& drawn) const;
    /// The same rows without measured lengths; they have the same width and height.
    const std::vector<ResultRow>& results() const { return results_; }
    /// The text for a width of `measure` mm; `equations_apart`: without the equations of steps, which stand in the
    /// figure.
    Passage text(const Band::Part& part, double measure, bool equations_apart,
                 const std::vector<ResultRow>& results) const;
    /// The equations of motion of a band, one below the other, at most `most` mm wide where possible. Width 0: there
    /// are none, or too many for a figure.
    Block equations(const Band& band, double most) const;

private:
    void collect_motion();
    void collect_curvature();
    void collect_forces();
    void collect_bodies();
    std::size_t home_of_forces(StatementIndex statement, std::size_t at_lines) const;
    std::vector<std::size_t> collect_superposition();
    std::size_t home_of_sums(const std::vector<std::size_t>& parts) const;
    void collect_truss();
    void collect_equations();
    void collect_apart();
    void collect_virtual_work();
    void add_items(std::vector<EquationItem> items, const std::string& pages);
    Band& add(const std::string& question, const std::vector<FigureId>& figures);
    Band& add(const std::vector<FigureId>& figures);
    bool draws(const Band& band, FigureId id) const;
    bool draws_curvature(const Band& band, BodyIndex body) const;
    void add_step(Band& band, std::size_t statement);
    std::optional<std::size_t> same_before(const Band& band, const Statement& added) const;
    void number_steps();
    void deal_out_results();
    /// In the order of their bands.
    std::vector<const FreeBody*> bodies_with_polygons() const;
    Passage table(const std::vector<std::size_t>& which, const std::vector<ResultRow>& results, double measure) const;
    void add_remarks();
    const std::string& question_of(const Band::Part& part) const;

    const DrawingContext& context_;
    const Solution& solution_;
    const WantedFigures& wanted_;
    SolutionDetail detail_;
    std::size_t first_of_curvature_ = 0, end_of_curvature_ = 0;  // its bands
    std::map<std::size_t, int> step_;                            // number of a step, by statement
    std::map<std::size_t, std::vector<std::size_t>> likewise_;   // merged statements, by the one kept
    std::vector<ResultRow> results_;
    std::map<std::string, RichText> remarks_;                   // on drawn figures
    mutable std::map<std::string, std::string> figures_stand_;  // position of the figures in words, by question
    std::vector<EquationItem> equations_;
    std::vector<LineNumbers> lines_;  // numbers of lines in the polygons of motion
    mutable MadeOnce made_;
    mutable std::map<std::size_t, ResultsTable> tables_;  // tables without measured lengths, by their first row
};

}  // namespace kinegraph::render
