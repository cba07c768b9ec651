// Band layout: the arrangement of one band in a given space, with its text beside or below its figures. Computes the
// score of each arrangement; draws nothing.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "render/content/bands.hpp"
#include "render/content/sheet_parts.hpp"
#include "render/layout/column_text.hpp"
#include "render/layout/figure_shares.hpp"
#include "render/layout/measured_figures.hpp"

namespace kinegraph::render {

/// The width of a band: `columns` of the `of` equal columns that the page is divided into.
struct Width {
    int columns = 1, of = 1;
    auto operator<=>(const Width&) const = default;  // NOLINT(modernize-use-nullptr): as in quantity.hpp
};

/// The price of white in one piece, a part of the page. It is quadratic, because one large area is what is seen. A
/// fifth of the page costs a little less than a step of a scale that can be read anyway.
constexpr double price_of_white(double part) { return 8 * part * part; }

/// The part of a space that the title block covers: its lower right corner.
struct Notch {
    double left = 0;  ///< the width that stays free left of the block
    double high = 0;
};

/// An arrangement of the figures and the text of a band. A plan compares tens of thousands of them, so that nothing
/// here allocates memory.
struct Arrangement {
    static constexpr double impossible = -1e300, possible = 0.5 * impossible;
    double score = impossible;
    int divided = 0;        ///< number of columns that the page is divided into for the text; 0: no text
    int columns = 0;        ///< columns of text
    bool beside = false;    ///< the text stands right of the figures, otherwise below them
    int under = 0;          ///< if beside: the number of its first columns that stand below the figures
    bool stacked = false;   ///< the figures stand below each other
    bool cornered = false;  ///< the equations stand in a corner of the figure

    /// The columns of its text. `whole`: width of the space, mm; `measure`: width of a column; `figures`: height of the
    /// figures.
    TextColumns text_columns(double whole, double measure, double figures, const Notch& notch) const;
};
struct BandLayout : Arrangement {
    std::vector<Spot> rooms{};        ///< of the figures; width 0: the figure is left out
    std::vector<FigureSize> sizes{};  ///< of the figures
};

/// Cache of the typeset text of bands, kept from one plan to the next. A text that is divided over pages is typeset
/// once.
class BandTexts {
public:
    /// `size`: of the text, relative to the theme.
    BandTexts(const Bands& bands, const std::vector<ResultRow>& results, const SheetFormat& format, double size)
        : bands_(bands), results_(results), format_(format), size_(size), planned_(nullptr) {}
    /// Texts with other results than `planned`; everything that does not depend on results is copied from it.
    BandTexts(const std::vector<ResultRow>& results, BandTexts& planned)
        : bands_(planned.bands_),
          results_(results),
          format_(planned.format_),
          size_(planned.size_),
          planned_(&planned) {}

    double size() const { return size_; }
    /// The text for columns of a page that is divided into `divided`; `cornered`: without its equations.
    const ColumnText& of(const Band& band, int divided, bool cornered);
    /// Whether a table is too wide for such columns; the other parts are not typeset then. Always false for a text that
    /// is divided over pages.
    bool has_too_wide(const Band& band, int divided, bool cornered);
    /// Number of rows.
    std::size_t rows(const Band& band);
    struct RowsOfPassage {
        std::size_t count;
        bool is_table;
    };
    std::vector<RowsOfPassage> rows_by_passage(const Band& band);  ///< in order
    /// The equations as a block for a corner of a figure.
    const Block& equations(const Band& band);
    /// Removes the text of a band from the cache, because the text has changed.
    void forget(const std::string& question);
    /// How often forget() was called for it.
    int times_forgotten(const std::string& question) const {
        const auto found = forgotten_.find(question);
        return found == forgotten_.end() ? 0 : found->second;
    }

private:
    using Setting = std::tuple<std::string, int, bool>;  // question, division, cornered
    /// Passages by part; they are typeset when they are first needed.
    struct Whole {
        std::vector<Passage> passages;
        std::vector<bool> is_set;
    };
    Whole& begun(const Band& band, int divided, bool cornered);
    const Passage& passage(const Band& band, std::size_t part, int divided, bool cornered);
    const std::vector<Passage>& whole(const Band& band, int divided, bool cornered);

    const Bands& bands_;
    const std::vector<ResultRow>& results_;
    const SheetFormat& format_;
    double size_;
    BandTexts* planned_;
    using Rows = std::tuple<Setting, std::size_t, std::size_t, bool>;  // the first, the end, with tables whole
    std::map<Setting, Whole> wholes_;
    std::map<Rows, ColumnText> texts_;
    std::map<std::string, Block> equations_;
    std::map<std::string, int> forgotten_;
};

/// The score of a band by height, in steps, for one width. It does not decrease with the height, so that heights
/// between two equal scores need no computation.
using WorthByHeight = std::vector<double>;

class BandLayouts {
public:
    /// `sizes`: of its figures; `narrow`: columns may be narrower than those of the format.
    BandLayouts(BandTexts& texts, const Band& band, const WantedFigures& wanted, MeasuredFigures& measured,
                const SheetFormat& format, std::vector<std::vector<FigureSize>> sizes, bool narrow);

    /// The arrangement with the highest score for this height, mm, where white below it has a price too.
    BandLayout in(Width width, double height, Notch notch = {}) const;
    /// The scores for the heights 0, step, … most × step. Cached.
    const WorthByHeight& score(Width width, const Notch& notch, double step, int most) const;
    /// Estimate of the area that text and lettered figures cover, mm².
    double taken_by(const BandLayout& layout) const;
    /// Whether `other` has the same figures and text, so that the cached scores are valid for both.
    bool is_like(const BandLayouts& other) const;
    /// The text for columns of a page that is divided into `divided`.
    const ColumnText& text(int divided, bool cornered) const;
    /// The equations that may stand in a corner. Only if there are some.
    const Block& equations() const { return *equations_; }

private:
    /// Whether its text may stand in narrower columns than those of the format.
    bool may_be_narrow(int divided, bool cornered) const;
    /// The best arrangement so far, and bounds for the search.
    struct Best {
        double whole = 0;  ///< width of the space, mm
        double ends = 0;   ///< height down to which white has a price
        Arrangement layout{};
        Spot room{};
        double most_of_figures = 0;  ///< upper bound of the score of the figures
        double spare = 0;            ///< by how much the height may decrease with the same arrangement, about, mm
        bool lasts = false;          ///< `spare` is exact
    };
    /// `fills`: white at the end of the space has a price.
    Best best_in(Width width, double height, Notch notch, bool fills) const;
    void try_round(Best& best, Arrangement layout, double whole, double height, Notch notch) const;
    void try_all(Best& best, Arrangement base, double whole, double height, Notch notch) const;
    /// `spare`: the same bound for the text; `share_of_height`: the decrease of the height for a decrease of 1 mm of
    /// the figures.
    void try_figures(Best& best, const Arrangement& layout, Spot room, double spare, double share_of_height = 1) const;
    double price_of_white(const Arrangement& layout, const Best& best, Spot figures, int shown) const;
    bool may_improve(const Best& best, const Arrangement& layout) const;
    bool improves(const Best& best, const Arrangement& layout, Spot room) const;
    void add_rooms(BandLayout& layout, const Best& best) const;

    BandTexts& all_texts_;
    const Band& band_;
    const SheetFormat& format_;
    FigureShares figures_;
    const Block* equations_ = nullptr;  // those for a corner, owned by texts
    bool narrow_;
    int times_forgotten_;                                                       // of its text, when this was made
    mutable std::vector<const ColumnText*> texts_;                              // by division and whether cornered
    mutable std::vector<std::optional<bool>> may_be_narrow_;                    // by the same index
    mutable std::map<std::tuple<Width, double, double>, WorthByHeight> score_;  // by width and notch
};

}  // namespace kinegraph::render
