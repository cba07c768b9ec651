// How a band stands in a room: its figures left and its text right of them, or its text under them. Owns what a room is
// worth to a band; draws nothing.
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

namespace kinegraph::render {

/// A band is so many of the columns wide that a page is divided into.
struct Width {
    int columns = 1, of = 1;
    auto operator<=>(const Width&) const = default;  // NOLINT(modernize-use-nullptr): as in quantity.hpp
};

/// What the title block takes of a room: its lower right corner.
struct Notch {
    double left = 0;  ///< of it the room is as wide
    double high = 0;
};

/// How figures and text of a band stand to each other. (A plan compares tens of thousands: nothing here asks for
/// memory.)
struct Arrangement {
    static constexpr double impossible = -1e300, possible = 0.5 * impossible;
    double worth = impossible;
    int divided = 0;        ///< the text's column is a page divided by this; 0: no text
    int columns = 0;        ///< of text
    bool beside = false;    ///< the text stands right of the figures, else under them
    int under = 0;          ///< beside: so many of its columns, the first, go on under the figures
    bool stacked = false;   ///< the figures stand one under the other
    bool cornered = false;  ///< the equations stand in a corner of the figure

    /// The columns of its text, in a room so wide of which the title block takes a corner; `figures`: how high these
    /// are.
    TextColumns text_columns(double whole, double measure, double figures, const Notch& notch) const;
};
struct BandLayout : Arrangement {
    std::vector<Spot> rooms{};  ///< of the figures; no width: left out
};

/// The text of bands as they were set, kept from one plan to the next. A text that goes on over pages is set once.
class BandTexts {
public:
    /// `planned`: the same with other results, of which the rest is taken.
    BandTexts(const Bands& bands, const std::vector<ResultRow>& results, const SheetFormat& format,
              BandTexts* planned = nullptr)
        : bands_(bands), results_(results), format_(format), planned_(planned) {}

    /// In the columns of a page divided by so many; `cornered`: without its equations.
    const ColumnText& of(const Band& band, int divided, bool cornered);
    /// Whether some of it, a table, is found to be too wide for such columns: then the rest need not be set for them.
    /// Of a text that goes on over pages nothing is said.
    bool has_too_wide(const Band& band, int divided, bool cornered);
    /// How many rows it has.
    std::size_t rows(const Band& band);
    /// … by its passages, in their order.
    std::vector<std::size_t> rows_by_passage(const Band& band);
    /// As a block to stand in a corner of a figure.
    const Block& equations(const Band& band);
    /// What was set of a band that now says more.
    void forget(const std::string& question);
    /// How often that was.
    int times_forgotten(const std::string& question) const {
        const auto found = forgotten_.find(question);
        return found == forgotten_.end() ? 0 : found->second;
    }

private:
    using Setting = std::tuple<std::string, int, bool>;  // question, division, cornered
    /// Passages by part; those that were not asked for yet are not set.
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
    BandTexts* planned_;
    using Rows = std::tuple<Setting, std::size_t, std::size_t>;  // the first, the end
    std::map<Setting, Whole> wholes_;
    std::map<Rows, ColumnText> texts_;
    std::map<std::string, Block> equations_;
    std::map<std::string, int> forgotten_;
};

/// What a band is worth in rooms of one width, by their height in steps. It never falls with the height: between two
/// heights at which it is the same it need not be asked for.
using WorthByHeight = std::vector<double>;

class BandLayouts {
public:
    /// `force_scale`: no force polygon is drawn larger. `crowded`: figures may be so small that they are hard to read;
    /// `cornered`: equations may stand in a corner of their polygon; `narrow`: columns may be narrower than the
    /// format's.
    BandLayouts(BandTexts& texts, const Band& band, const WantedFigures& wanted, const SheetFormat& format,
                bool crowded, bool cornered, bool narrow);

    /// The best in a room so high.
    BandLayout in(Width width, double height, Notch notch = {}) const;
    /// By heights that are multiples of `step`, the greatest `most` of them; kept once asked for.
    const WorthByHeight& worth(Width width, const Notch& notch, double step, int most) const;
    /// What it takes of such a room, about, mm²: its text, and its figures with their letters.
    double taken_in(Width width, double height, Notch notch) const;
    /// Whether another has the same figures and the same text, so that all it was asked for holds here.
    bool is_like(const BandLayouts& other) const;
    /// The text in the columns of a page divided by so many.
    const ColumnText& text(int divided, bool cornered) const;
    /// The equations, where they may stand in a corner.
    const Block& equations() const { return *equations_; }
    /// What of a room is for the equations in the figure's corner.
    double wider_in(Spot room) const;
    /// Of a figure of the band, by its place among them: the scale that a room promises.
    double scale_in(std::size_t figure, Spot room) const;

private:
    const FigureSize& size_in(std::size_t figure, Spot room, bool cornered) const;
    /// Whether its text may stand in narrower columns than the format's.
    bool may_be_narrow(int divided, bool cornered) const;
    /// The best of what was tried, and what its figures share.
    struct Best {
        Arrangement layout{};
        Spot room{};
        double most_of_figures = 0;  ///< no worth of them is more
        double spare = 0;            ///< by how much the room may be lower and still hold it, about
        bool lasts = false;          ///< … for certain
    };
    Best best_in(Width width, double height, Notch notch) const;
    void try_round(Best& best, Arrangement layout, double whole, double height, Notch notch) const;
    void try_all(Best& best, const Arrangement& base, double whole, double height, Notch notch) const;
    /// `spare`: of the text, as Best's; `share_of_height`: by how much the room is lower where the figures are by 1 mm.
    void try_figures(Best& best, const Arrangement& layout, Spot room, double spare, double share_of_height = 1) const;
    bool may_improve(const Best& best, const Arrangement& layout) const;
    bool improves(const Best& best, const Arrangement& layout, Spot room) const;
    std::vector<Spot> rooms_of(const Best& best) const;

    BandTexts& all_texts_;
    const Band& band_;
    const SheetFormat& format_;
    FigureShares figures_;
    const Block* equations_ = nullptr;  // that find room in a corner; they are the texts'
    bool narrow_;
    int times_forgotten_;                                                       // its text, before
    mutable std::vector<const ColumnText*> texts_;                              // by division and whether cornered
    mutable std::vector<std::optional<bool>> may_be_narrow_;                    // … too
    mutable std::map<std::tuple<Width, double, double>, WorthByHeight> worth_;  // by width and notch
};

}  // namespace kinegraph::render
