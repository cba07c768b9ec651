// Bands: a solution as a sequence of questions, each with its figures and the text that belongs to them. Owns what
// belongs together and in which order it is read; chooses no place and no size.
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

/// Rows under a heading. Where they go on in a further column a table sets its head again; on a further page the
/// heading too.
struct Passage {
    SharedBlock heading, heading_again;  ///< no height: none
    SharedBlock head;
    std::vector<SharedBlock> rows{};

    void take_rows(std::vector<Block> blocks);
    /// Of a table: the first line is its head. No lines: neither head nor rows.
    void take_table(std::vector<Block> lines);
    void take_table(std::vector<SharedBlock> lines);
};

/// One question of the solution.
struct Band {
    /// What its text is made of, in order.
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
        std::vector<std::size_t>
            which{};  ///< steps: statements; results: rows of the table; equations: a section's first and last item
    };
    std::string question;
    std::vector<std::size_t> figures{};  ///< of WantedFigures::list, left to right
    std::vector<Part> parts{};
    std::size_t first_row = 0;  ///< of its text, which goes on over pages only where no page holds it
    std::size_t end_row = std::numeric_limits<std::size_t>::max();
};

/// A statement as it is said, once it was asked for.
struct Said {
    Paragraph sentence;
    std::optional<SharedBlock> equation{};  ///< in one row, as wide as that is
};
/// What is the same at all widths, made once it was asked for.
struct MadeOnce {
    NaturalBlocks natural{};             ///< of the equations, as they were set first
    std::map<std::size_t, Said> said{};  ///< by statement
    std::optional<CentresTable> centres{};
    std::optional<BodiesTable> bodies{};
    std::vector<Paragraph> conventions{};
};

/// Of the text of a band and of those that it goes on in, its own rows; what goes on from a page before begins in the
/// middle.
std::vector<Passage> own_rows(const std::vector<Passage>& text, const Band& band);

/// The bands of a solution, and their text once a width is chosen.
class Bands {
public:
    /// Sentences that repeat each other stand in one. Brief: the decisive sentences, and the answers in the place of
    /// all results.
    Bands(const DrawingContext& context, const WantedFigures& wanted, SolutionDetail detail = SolutionDetail::full);

    std::vector<Band> list;

    /// A remark on a figure, once it is drawn; false where it is made already.
    bool remark(const std::string& figure, const RichText& text);

    /// What goes on from another page says where its figures are: numbered so, on a page counted from 0.
    void tell_figures(const std::string& question, int first, int last, std::size_t page);

    /// Rows of all results, lengths measured on the figures where there are some.
    std::vector<ResultRow> results_on(const std::vector<Figure>& drawn) const;
    /// The same with no length measured: as wide and as high as they will be.
    const std::vector<ResultRow>& results() const { return results_; }
    /// Set to a width of `measure` mm; `equations_apart`: the equations of its steps stand in the figure.
    Passage text(const Band::Part& part, double measure, bool equations_apart,
                 const std::vector<ResultRow>& results) const;
    /// The equations of motion of a band, one under the other, not wider than `most` mm where they can; no width: it
    /// has none, or so many that no figure has room for them.
    Block equations(const Band& band, double most) const;

private:
    void collect_motion();
    void collect_curvature();
    void collect_forces();
    void collect_bodies();
    std::size_t home_of_forces(StatementIndex statement, std::size_t at_lines) const;
    std::vector<std::size_t> collect_superposition();
    void collect_truss();
    void collect_equations();
    void collect_apart();
    void collect_virtual_work();
    void add_items(std::vector<EquationItem> items, const std::string& pages);
    Band& add(const std::string& question, const std::vector<std::string>& figures);
    void add_step(Band& band, std::size_t statement);
    std::optional<std::size_t> same_before(const Band& band, const Statement& added) const;
    void number_steps();
    void deal_out_results();
    Passage table(const std::vector<std::size_t>& which, const std::vector<ResultRow>& results, double measure) const;
    void add_remarks();
    const std::string& question_of(const Band::Part& part) const;

    const DrawingContext& context_;
    const Solution& solution_;
    const WantedFigures& wanted_;
    SolutionDetail detail_;
    std::map<std::size_t, int> step_;                           // number of a statement
    std::map<std::size_t, std::vector<std::size_t>> likewise_;  // statements that say the same of others, by the first
    std::vector<ResultRow> results_;
    std::map<std::string, RichText> remarks_;                   // on figures as drawn
    mutable std::map<std::string, std::string> figures_stand_;  // by question, in words
    std::vector<EquationItem> equations_;
    std::vector<LineNumbers> lines_;  // of the polygons of motion
    mutable MadeOnce made_;
    mutable std::map<std::size_t, ResultsTable> tables_;  // of results that are not measured, by their first row
};

}  // namespace kinegraph::render
