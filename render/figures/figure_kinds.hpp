// Which figure of a solution a figure is, as a type: its kind and what it is of. What a row of the table of kinds
// (figure_table.hpp) holds, and what it gives: names, sizes, drawings.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/words.hpp"
#include "render/figures/fit.hpp"
#include "render/scene/drawing_context.hpp"
#include "render/scene/load_case.hpp"
#include "render/scene/polygon_scene.hpp"

namespace kinegraph::render {

/// The kinds stand in figure_table.hpp, which who names one includes.
enum class FigureKind : std::uint8_t;

struct FigureId {
    FigureKind kind{};
    int of = -1;           ///< an index, see FigureKind; −1: a solution has one
    int part = all_loads;  ///< of the superposition, whose loads act alone
    friend auto operator<=>(const FigureId&, const FigureId&) = default;  // NOLINT(modernize-use-nullptr)
};

/// How large a figure should be, and how it may be changed for that.
struct SizeWanted {
    double extent_x = 0, extent_y = 0;  ///< in the units of its scale; 0: the size does not depend on it
    double subject = 0;                 ///< longer extent of what it is about, such as the links; 0: of all
    double rim_x = 20, rim_y = 14;      ///< of a figure that fills its room: space round its strokes, mm
    double least = 18;                  ///< mm; nothing can be read off the figure if its longer extent is less
    double enough = 200;                ///< mm; it gains nothing from a larger size
    double weight = 1;                  ///< of its score, relative to other figures
    double arrow = 0;                   ///< mm, of its longest vector, at a scale of its own; 0: it has no such vectors
    std::optional<double> asked{};      ///< the scale in the file
    bool empty = false;                 ///< all vectors are zero: a pole and names
    bool spare = false;                 ///< shown alone, or if there is room
    bool is_straight = false;           ///< all its vectors lie along one line: it shows lengths and no angle
    bool to_force_scale = false;        ///< has the common scale of forces
    bool may_be_larger = false;         ///< … or a finer one, if it were too small to read
    bool is_row = false;                ///< several polygons side by side, which may stand in several rows
    bool fills = false;                 ///< drawn to fill its room; its scale is that of the vectors
    bool has_corner = false;            ///< equations may stand in a free corner of it

    double extent() const { return extent_x > extent_y ? extent_x : extent_y; }
    double extent_of_subject() const { return subject > 0 ? subject : extent(); }
    void take(const Box& extent) {
        extent_x = extent.width();
        extent_y = extent.height();
    }
};

/// What figures show: a solution, and how much of it.
class Shown {
public:
    /// Brief: no more than a lecturer would draw. `with_lever`: also where the lever is not the construction of a
    /// result.
    explicit Shown(const DrawingContext& of, bool brief = false, bool with_lever = false)
        : context(of), is_brief(brief), has_lever(with_lever) {}

    const DrawingContext& context;
    const bool is_brief, has_lever;

    const Solution& solution() const { return context.solution; }
    /// Whether the mechanism is drawn with its instant centres. Brief: only if the file asks for them.
    bool has_centres() const;
    /// Of a polygon of the protocol; cached.
    const PolygonScene& scene(int polygon) const;

private:
    mutable std::map<int, PolygonScene> scenes_;
};

/// What a figure's file gives to its row.
struct FigureFunctions {
    /// The figures of this kind, by `of`: under all loads, or under those of a part. Null: none is listed.
    std::vector<int> (*all)(const Shown&, const LoadCase&) = nullptr;
    /// Sets the extents, and what else depends on the solution.
    void (*measure)(const Shown&, FigureId, SizeWanted&) = nullptr;
    Figure (*draw)(const Shown&, FigureId, Spot room, const ScaleWish&) = nullptr;
    /// Adds optional content to a drawn figure. Empty and at any_scale if the room has no space for it. Null: there is
    /// nothing to add.
    Figure (*enrich)(const Shown&, FigureId, const Figure& plain, Spot room) = nullptr;
};

/// What a figure is in the live page. The page decides by these, and never by names.
struct InPage {
    /// Whether the marks say what they belong to, and move with that.
    enum class Marks : std::uint8_t {
        by_id,        ///< they are known by their ids, or by the polygon that they draw
        if_said,      ///< if some say it
        always_said,  ///< all of them
    };
    /// What a reader constructs who tries the figure.
    enum class Tasks : std::uint8_t { none, sides, forces };

    std::string_view layer = "others";  ///< turns it on; empty: it is always shown
    bool is_mechanism = false;          ///< shows points in their places
    bool is_stacked = false;            ///< laid on the other drawings of the whole mechanism
    Marks marks = Marks::by_id;
    Tasks tasks = Tasks::sides;
    bool is_lever = false;            ///< its rays turn with velocities, and its scale with it
    bool is_of_one = false;           ///< shows one body, larger than a figure of several
    bool may_rest = false;            ///< what belongs to no force stays true where nothing moves
    std::string_view vectors_like{};  ///< id of the polygon whose vectors it repeats; empty: its own
};

/// A kind of figure.
struct FigureRow {
    FigureKind kind{};
    std::string_view key{};  ///< its name for --figure, or the beginning of it
    /// What follows the key in the name. Null: nothing.
    std::string (*rest)(const Solution&, FigureId) = nullptr;
    std::optional<FigureKind> plain{};  ///< the same figure without what this one shows besides; none: this one
    std::string_view svg_id{};          ///< the id of its group under all loads; empty: its name
    std::string_view data_figure{};     ///< the attribute of its group; empty: its name
    std::optional<Key> caption{};       ///< or its first words; none: they depend on what it shows
    FigureTraits traits{};
    std::array<std::string_view, 2> scales{};  ///< keys of its scale in the file; the first one present counts
    SizeWanted size{};
    InPage in_page{};
    const FigureFunctions* by = nullptr;  ///< null: it is drawn beside steps only
};

const FigureRow& row_of(FigureKind kind);
/// For FigureFunctions::all: the only figure of its kind, if it is there.
inline std::vector<int> once(bool is_there) { return is_there ? std::vector<int>{-1} : std::vector<int>{}; }
/// FigureFunctions::measure for a figure of the whole mechanism without centres.
void measure_mechanism(const Shown& shown, FigureId id, SizeWanted& size);

// The names of a figure. Nothing else makes text of its identity.

/// Its name for --figure: "velocity", "curvature-3", "body-2-load-K".
std::string name_of(const Solution& solution, FigureId id);
/// The body whose free body it is; none of that of a pin. Null: it is not a free body.
std::optional<BodyIndex> free_body_in(const Solution& solution, FigureId id);
/// What the ids in a figure of one load begin with; empty: it shows all loads.
std::string prefix_of_load(const Solution& solution, FigureId id);
/// A figure with its traits, the id of its group and the first words of its caption; without marks.
Figure begun(const DrawingContext& context, FigureId id);
/// The scale that the file prescribes for figures of a kind, SI units per mm.
std::optional<double> asked_scale(const Mechanism& mechanism, FigureKind kind);

// What a solution shows.

/// All its figures in the order of the table; those of a part of the loads stand together.
std::vector<FigureId> all_figures(const Shown& shown);
SizeWanted size_of(const Shown& shown, FigureId id);
/// Draws it into a room, mm, within the limits of the wish.
Figure draw_figure(const Shown& shown, FigureId id, Spot room, const ScaleWish& wish);
/// The identity of a polygon of motion.
FigureId motion_polygon(const Solution& solution, int polygon);

bool has_forces(const Solution& solution);
bool has_motion(const Solution& solution);
/// Whether it has both motion and forces; each has pages of its own then.
bool is_mixed(const Solution& solution);

}  // namespace kinegraph::render
