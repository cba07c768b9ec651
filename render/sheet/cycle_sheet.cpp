#include "render/sheet/cycle_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "lang/keys/sheet.hpp"
#include "render/content/title_block.hpp"
#include "render/equations/prose.hpp"
#include "render/figures/caption.hpp"
#include "render/mechanism/sketch.hpp"
#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

constexpr double section_gap = 5.5;  // mm, between a figure and its table
constexpr double least_room = 45;    // mm; least height of a plot with its caption
constexpr std::size_t most_plots = 3;

using Kind = Quantity::Kind;

class CycleSheet {
public:
    CycleSheet(const Solution& drawn, const CycleTable& table, const std::vector<std::vector<std::size_t>>& plots,
               const std::vector<Way>& ways, const SheetOptions& options, const Fonts& fonts, const CamNotes* cam)
        : context_{drawn, options.theme, fonts, options.language, Dimensions::off},
          table_(table),
          plots_(plots),
          ways_(ways),
          cam_(cam),
          format_(format_of(options.paper, options.orientation)),
          signature_{options.author, options.date,
                     word(table.is_of_cam   ? lang::sheet::subtitle_cam
                          : table.parameter ? lang::sheet::subtitle_parameter
                                            : lang::sheet::subtitle_cycle,
                          options.language)},
          width_((format_.content.width() - 2 * gap) / 2) {}

    std::vector<Page> pages() {
        if (cam_ != nullptr)
            draw_first_page_of_cam();
        else
            draw_first_page();
        while (next_ < plots_.size()) draw_further_page();
        std::vector<Page> pages;
        for (std::size_t i = 0; i < sheets_.size(); ++i)
            pages.push_back(framed_page(context_, format_, signature_, sheets_[i], i == 0 ? scale_ : std::nullopt,
                                        i + 1, sheets_.size()));
        return pages;
    }

private:
    double bottom(double left) const {
        return left + width_ > format_.block.min.x - 2 ? format_.block.min.y - 4 : format_.content.max.y;
    }

    /// The mechanism and the table on the left, plots on the right.
    void draw_first_page() {
        sheets_.emplace_back();
        const Spot corner = format_.content.min;
        const Block table = extremes();
        const double room = bottom(corner.x) - corner.y - table.height - section_gap - 8;
        const double height = put_mechanism(corner, std::max(room, 45.0));
        set(sheets_.back(), table, {corner.x, corner.y + height + section_gap});
        put_plots(right_column(), corner.y, most_plots);
    }
    /// The figure in the first column; on its right the data, the extremes, and as many plots as fit.
    void draw_first_page_of_cam() {
        sheets_.emplace_back();
        const Spot corner = format_.content.min;
        put_mechanism(corner, bottom(corner.x) - corner.y - 8);
        double top = corner.y;
        for (const Block& block : {data(), extremes()}) {
            set(sheets_.back(), block, {right_column(), top});
            top += block.height + section_gap;
        }
        if (bottom(right_column()) - top >= least_room) put_plots(right_column(), top, most_plots);
    }
    void draw_further_page() {
        sheets_.emplace_back();
        const double top = format_.content.min.y;
        // Plots of a cam are placed side by side rather than all on the left.
        const std::size_t left = plots_.size() - next_;
        const std::size_t most = cam_ != nullptr ? std::min((left + 1) / 2, most_plots) : most_plots;
        put_plots(format_.content.min.x, top, most);
        put_plots(right_column(), top, most);
    }
    double right_column() const { return format_.content.min.x + width_ + 2 * gap; }
    double put_mechanism(Spot corner, double height) {
        return put_figure(
            [&](double x, double y) {
                Figure figure = mechanism_with_ways(context_, ways_, x, y);
                scale_ = figure.scale;
                if (table_.is_of_cam)
                    figure.caption = one_piece(word(lang::sheet::cam_and_follower, context_.language));
                if (cam_ != nullptr)
                    append(figure.caption,
                           " " + word(lang::sheet::at_the_position, context_.language) + " " +
                               drawing::given_number(cam_->drawn * 180 / std::numbers::pi, context_.language) + "°");
                if (table_.parameter) figure.caption = one_piece(word(lang::sheet::mechanism, context_.language));
                return figure;
            },
            corner, height);
    }

    /// Places at most `most` plots one below the other, fewer if they would be lower than `least_room`.
    void put_plots(double left, double top, std::size_t most) {
        const double all = bottom(left) - top;
        const std::size_t fit =
            std::clamp<std::size_t>(static_cast<std::size_t>(all / least_room), 1, format_.large ? most + 1 : most);
        const std::size_t count = std::min(plots_.size() - next_, fit);
        if (count == 0) return;
        const double each = std::min(all / static_cast<double>(cam_ != nullptr ? fit : count), 0.9 * width_);
        for (std::size_t i = 0; i < count; ++i, top += each) {
            const std::size_t plot = next_++;
            const PlotNotes notes = cam_ != nullptr ? PlotNotes{cam_->captions.at(plot), cam_->drawn} : PlotNotes{};
            put_figure(
                [&](double x, double y) {
                    return plot_figure(context_, table_, plots_[plot], static_cast<int>(plot) + 1, x, y, notes);
                },
                {left, top}, each - 7 - section_gap);
        }
    }

    template <class Draw>
    double put_figure(Draw draw, Spot corner, double height) {
        Figure figure = draw(width_, height);
        const double caption = set_caption(sheets_.back(), context_, figure, ++figures_, corner, width_);
        const double high = figure.box.height();
        figure.move(corner.x, corner.y + caption);
        for (Mark& mark : figure.marks) sheets_.back().push_back(std::move(mark));
        return caption + high;
    }

    Block extremes() const { return cycle_extremes(context_, table_, plots_, width_, format_.content.height() / 2); }
    Block data() const {
        Block block;
        set(block.marks, heading_block(context_, width_, word(lang::sheet::data, context_.language), {}), {0, 0});
        block.height = heading_height;
        for (const RichText& each : cam_->data) {
            const Block line = paragraph_block(context_, width_, each, 0, "");
            set(block.marks, line, {0, block.height});
            block.height += line.height;
        }
        block.width = width_;
        return block;
    }

    DrawingContext context_;
    const CycleTable& table_;
    const std::vector<std::vector<std::size_t>>& plots_;
    const std::vector<Way>& ways_;
    const CamNotes* cam_;  ///< null: not a cam
    SheetFormat format_;
    Signature signature_;
    double width_;  ///< of a column, mm
    std::vector<std::vector<Mark>> sheets_;
    std::optional<double> scale_;
    std::size_t next_ = 0;
    int figures_ = 0;
};

}  // namespace

std::vector<Page> lay_out_cycle(const Solution& drawn, const CycleTable& table,
                                const std::vector<std::vector<std::size_t>>& plots, const std::vector<Way>& ways,
                                const SheetOptions& options, const Fonts& fonts, const CamNotes* cam) {
    return CycleSheet(drawn, table, plots, ways, options, fonts, cam).pages();
}

}  // namespace kinegraph::render
