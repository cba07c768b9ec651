// Measured figures: the space of each figure at the standard scales that its page could take. It is that of its strokes
// until a plan chooses it; then the figure is drawn, letters included, and the plan is made again with what it takes.
// Nothing is drawn twice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "engine/number/assert.hpp"
#include "render/content/kept_scales.hpp"
#include "render/content/sheet_parts.hpp"
#include "render/content/wanted_figures.hpp"
#include "render/layout/figure_shares.hpp"
#include "render/page/block.hpp"

namespace kinegraph::render {

/// mm, the longest vector or the longer side of the links: below it a figure grows where it has room …
constexpr double large_enough = 80;
/// … and below this one a polygon may have a scale between those of the series, which no rule has.
constexpr double hardly_measured = 50;

class MeasuredFigures {
public:
    MeasuredFigures(const DrawingContext& context, const WantedFigures& wanted, const SheetFormat& format,
                    const std::optional<KeptScales>& kept)
        : context_(context),
          wanted_(wanted),
          format_(format),
          kept_(kept),
          drawings_(wanted.list.size()),
          times_drawn_(wanted.list.size()) {}

    /// The sizes that are measured: down to a small one, to one that can hardly be read, or up to the page.
    enum class Range : std::uint8_t { usual, small, crowded, up_to_page };
    /// The sizes of a figure (index into WantedFigures::list), the highest score first, estimated where it is not drawn
    /// yet. `force_scale`: the common scale of force polygons.
    const std::vector<FigureSize>& sizes(std::size_t figure, std::optional<double> force_scale, Range range);
    /// The same, all of them drawn.
    const std::vector<FigureSize>& drawn_sizes(std::size_t figure, std::optional<double> force_scale, Range range);
    /// Draws what is only estimated. False: the size is that of a drawing.
    bool draws(std::size_t figure, const FigureSize& size);
    /// Whether it has sizes in that range that it has not in the usual one.
    bool has_more_sizes(std::size_t figure, std::optional<double> force_scale, Range range) const;
    /// The common scales of force polygons that a plan may choose from, the finest first. Empty: there are no force
    /// polygons, or the file gives their scale.
    std::vector<double> force_scales() const;
    /// Where a figure may grow: the room of its band, the part of it that nothing covers, mm², and the size, mm, that
    /// is large enough.
    struct Growth {
        Spot room;
        double left, enough;
    };
    /// Its sizes at finer scales than that of `now` that there may be room for, the highest score first: drawings at
    /// the next scale of the series, polygons also at those between.
    std::vector<FigureSize> grown(std::size_t figure, const FigureSize& now, const Growth& growth);
    /// The common scales of force polygons between this one and the next finer one of the series, the finest first,
    /// where the largest polygon is smaller than `enough` mm.
    std::vector<double> force_scales_between(double scale, double enough) const;
    /// Only of a size that is drawn.
    const Figure& drawing(std::size_t figure, const FigureSize& size) const {
        const std::optional<Figure>& drawn = drawings_[figure][size.drawing].figure;
        KG_ASSERT(drawn, "a plan draws what it chooses");
        return *drawn;
    }
    /// By how many mm the room of a drawing must be wider to hold the equations of its band in one of its corners.
    /// Infinity: no room is wide enough.
    double wider_for(std::size_t figure, const FigureSize& size, const Block& equations);

private:
    struct Drawing {
        Spot room;
        ScaleWish wish;
        std::optional<Figure> figure;  // when a plan has chosen it
        double beside = 0, wider = 0;  // width of the equations of its band, and by how much it must be wider for them
        std::vector<FigureSize> sizes{};  // with its caption in one line and in several; without a score
    };
    struct Measure {
        double scale;  // units of the extents per mm
        Spot room;
        ScaleWish wish;
    };
    void measure(std::vector<FigureSize>& sizes, std::size_t figure, const Measure& measure, Range range);
    double score_of(const Wanted& wanted, const Measure& measure, const Figure* drawing, double enough) const;
    const Wanted* largest_of_forces() const;
    bool may_grow(std::size_t figure) const;
    std::vector<double> finer_scales(const Wanted& wanted, double scale, bool is_white) const;
    Spot about_strokes(std::size_t figure) const;
    std::optional<double> narrower(double width, double least) const;
    std::vector<Measure> measures(const Wanted& wanted, std::optional<double> force_scale, Range range) const;
    Measure filling(const Wanted& wanted) const;
    std::vector<Measure> with_arrows(const Wanted& wanted, std::vector<Measure> all) const;
    std::vector<Measure> as_kept(const Wanted& wanted, std::vector<Measure> all) const;
    std::vector<Measure> at_force_scale(const Wanted& wanted, double force_scale) const;
    std::vector<Measure> at_scales(const Wanted& wanted, Range range) const;
    std::size_t entered(std::size_t figure, const Measure& measure);
    std::size_t drawn(std::size_t figure, const Measure& measure);
    void add_sizes(std::vector<FigureSize>& sizes, std::size_t figure, std::size_t drawing, double score, double scale);
    std::vector<FigureSize> sizes_of(const Figure& drawn) const;
    Spot page() const { return {format_.content.width(), format_.content.height() - caption_line}; }

    const DrawingContext& context_;
    const WantedFigures& wanted_;
    const SheetFormat& format_;
    const std::optional<KeptScales>& kept_;
    std::vector<std::deque<Drawing>> drawings_;  // by figure; a deque, because references to drawings are kept
    std::vector<std::size_t> times_drawn_;       // by figure
    struct Sizes {
        std::size_t drawings = 0;  // of the figure, when they were taken
        std::vector<FigureSize> list{};
    };
    std::map<std::tuple<std::size_t, double, Range>, Sizes> sizes_;
};

}  // namespace kinegraph::render
