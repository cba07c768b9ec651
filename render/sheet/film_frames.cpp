#include "render/sheet/film_frames.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include "render/content/title_block.hpp"
#include "render/equations/prose.hpp"
#include "render/figures/caption.hpp"
#include "render/figures/figure.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

constexpr std::size_t most_plots_of_film = 2;

class FilmPages {
public:
    FilmPages(const std::vector<FilmFrame>& frames, const CycleTable& table,
              const std::vector<std::vector<std::size_t>>& plots, const std::vector<Way>& ways,
              const SheetOptions& options, const Fonts& fonts)
        : frames_(frames),
          table_(table),
          plots_(plots),
          ways_(ways),
          options_(options),
          fonts_(fonts),
          format_(format_of(options.paper, options.orientation)) {
        constexpr double heading = 9;
        const Box& content = format_.content;
        const double bottom = format_.block.min.y - above_block, top = content.min.y + heading;
        const double width = plots.empty() ? content.width() : 0.58 * content.width();
        mechanism_ = rectangle(content.min.x, top, content.min.x + width, bottom);
        plots_room_ = rectangle(mechanism_.max.x + gap, top, content.max.x, bottom);
        measure();
    }

    std::vector<Page> pages() const {
        std::vector<Page> pages;
        for (std::size_t i = 0; i < frames_.size(); ++i) pages.push_back(page(i));
        return pages;
    }

private:
    DrawingContext context_of(const FilmFrame& frame) const {
        return {frame.solution, options_.theme, fonts_, options_.language, Dimensions::off};
    }

    /// One scale for all positions, and the place of the origin on the page.
    void measure() {
        Box all = extent_of_mechanism(frames_.front().solution, false);
        for (const FilmFrame& frame : frames_) all.include(extent_of_mechanism(frame.solution, false));
        for (const Way& way : ways_)
            if (way.is_path)
                for (const VectorOf<double>& place : way.places) all.include(Spot{place.x, -place.y});
        constexpr double round_it = 11;  // mm: symbols of the ground, names
        scale_ = choose_scale(all.width(), all.height(), mechanism_.width() - 2 * round_it,
                              mechanism_.height() - 2 * round_it, std::nullopt);
        const Spot middle = mechanism_.middle(), of_all = all.middle();
        origin_ = {middle.x - of_all.x / scale_, middle.y - of_all.y / scale_};
    }

    Page page(std::size_t i) const {
        const DrawingContext context = context_of(frames_[i]);
        std::vector<Mark> marks;
        set(marks,
            heading_block(context, format_.content.width(), title_of(frames_.front().solution, options_.language)),
            format_.content.min);
        for (const Way& way : ways_)
            if (way.is_path && way.places.size() > 1) marks.emplace_back(path_of(way));
        // In a room in which any position has its names.
        constexpr double ample = 1000;
        Figure figure = mechanism_figure(context, ample, ample, false, {scale_, scale_});
        figure.move(origin_.x - figure.origin.x, origin_.y - figure.origin.y);
        std::move(figure.marks.begin(), figure.marks.end(), std::back_inserter(marks));
        add_plots(marks, context, frames_[i].at);
        return framed_page(context, format_, {}, std::move(marks), std::nullopt, 1, 1);
    }

    Path path_of(const Way& way) const {
        std::vector<Spot> spots;
        for (const VectorOf<double>& place : way.places)
            spots.push_back({origin_.x + place.x / scale_, origin_.y - place.y / scale_});
        return polyline(spots, {options_.theme.outline, options_.theme.accent, {}, false});
    }

    void add_plots(std::vector<Mark>& marks, const DrawingContext& context, double at) const {
        const std::size_t count = std::min(plots_.size(), most_plots_of_film);
        const double height = plots_room_.height() / static_cast<double>(std::max<std::size_t>(count, 1));
        for (std::size_t k = 0; k < count; ++k) {
            const Spot corner{plots_room_.min.x, plots_room_.min.y + static_cast<double>(k) * height};
            Figure figure = plot_figure(context, table_, plots_[k], static_cast<int>(k) + 1, plots_room_.width(),
                                        std::min(height - 8, 0.8 * plots_room_.width()), {{}, at});
            set_text(marks, fonts_.shape(figure.caption, options_.theme.label), {corner.x, corner.y + 3.8},
                     options_.theme.text, "text");
            figure.move(corner.x, corner.y + 6);
            std::move(figure.marks.begin(), figure.marks.end(), std::back_inserter(marks));
        }
    }

    const std::vector<FilmFrame>& frames_;
    const CycleTable& table_;
    const std::vector<std::vector<std::size_t>>& plots_;
    const std::vector<Way>& ways_;
    const SheetOptions& options_;
    const Fonts& fonts_;
    SheetFormat format_;
    Box mechanism_, plots_room_;
    double scale_ = 1;  // m per mm
    Spot origin_;
};

}  // namespace

std::vector<Page> lay_out_film(const std::vector<FilmFrame>& frames, const CycleTable& table,
                               const std::vector<std::vector<std::size_t>>& plots, const std::vector<Way>& ways,
                               const SheetOptions& options, const Fonts& fonts) {
    return FilmPages(frames, table, plots, ways, options, fonts).pages();
}

}  // namespace kinegraph::render
