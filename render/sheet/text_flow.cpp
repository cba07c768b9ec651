// The flow of the text: what explains a figure beside it, the rest wherever there is room, in the order of reading.
#include "render/sheet/text_flow.hpp"

#include <algorithm>
#include <utility>

#include "engine/assert.hpp"
#include "render/figures/caption.hpp"
#include "render/sheet/sections.hpp"

namespace kinegraph::render {
namespace {

class TextFlow {
public:
    TextFlow(const DrawingContext& context, const SheetFormat& format, WantedFigures& wanted, const FigurePages& pages,
             std::vector<Section> sections)
        : context_(context),
          format_(format),
          wanted_(wanted),
          sections_(std::move(sections)),
          sheets_(pages.sheets),
          force_page_(pages.force_page),
          figures_(static_cast<int>(pages.drawn.size())) {}

    std::vector<Sheet> sheets() {
        flow();
        return std::move(sheets_);
    }

private:
    static bool pack(const std::vector<double>& heights, std::vector<Run>& runs,
                     std::vector<std::pair<std::size_t, double>>* where) {
        for (const double height : heights) {
            bool placed = false;
            for (std::size_t r = 0; r < runs.size() && !placed; ++r) {
                const double before = runs[r].used > 0 ? section_gap : 0;
                if (runs[r].left() < before + height) continue;
                if (where) where->emplace_back(r, runs[r].used + before);
                runs[r].used += before + height;
                placed = true;
            }
            if (!placed) return false;
        }
        return true;
    }

    static Figure drawn(Wanted& late, double width, double height) { return late.drawn_into(width, height - 7); }
    Block figure_block(Wanted& late, double width, double height) { return figure_block(drawn(late, width, height), width); }
    Block figure_block(Figure figure, double width) {
        Block block;
        const double caption = set_caption(block.marks, context_, figure, ++figures_, {0, 0}, width);
        figure.move(-figure.box.min.x + std::max(0.0, 0.5 * (width - figure.box.width())), caption - figure.box.min.y);
        block.marks.insert(block.marks.end(), figure.marks.begin(), figure.marks.end());
        block.width = width;
        block.height = caption + figure.box.height();
        return block;
    }

    void flow() {
        // What the pages with figures take.
        std::vector<Section> rest;
        // First what explains a figure beside that figure, then the others wherever there is room.
        bool waiting = false;  // steps that find no room at home hold up those after them
        for (Section& section : sections_)
            if (section.home >= 0 && !(section.in_order && waiting) && !place_section(section, true) && section.in_order)
                waiting = true;
        for (Section& section : sections_)
            if (!section.rows.empty() && !place_section(section)) rest.push_back(std::move(section));
        // Their room is kept in the flow; they are drawn at the end.
        std::vector<Wanted*> late_rest;
        for (Wanted& each : wanted_.late)
            if (!rest.empty() || !place_late(each)) late_rest.push_back(&each);
        if (rest.empty() && late_rest.empty()) return;

        // A page of columns: the late figures as large as the text lets them.
        std::vector<double> heights;
        for (const Section& section : rest) heights.push_back(section.height());
        double wide = 0, small = 0;
        for (const double w : {130.0, 115.0, 100.0, 88.0, 76.0, 66.0, 0.0}) {
            bool found = false;
            for (const double c : {80.0, 68.0, 58.0}) {
                std::vector<Run> runs = text_runs(late_rest.size() > 1 ? w : 0, late_rest.empty() ? 0 : c, late_rest.size());
                if (pack(heights, runs, nullptr)) {
                    wide = late_rest.size() > 1 ? w : 0;
                    small = late_rest.empty() ? 0 : c;
                    found = true;
                    break;
                }
            }
            if (found) break;
        }
        sheets_.emplace_back();
        if (small > 0) {
            double wide_drawn = 0, small_drawn = 0;
            std::size_t next = 0;
            if (wide > 0) {
                const Block block = figure_block(*late_rest[next++], 2 * format_.measure + gap, wide);
                set(sheets_.back().marks, block, format_.column(0).min);
                wide_drawn = block.height;
            }
            for (; next < late_rest.size(); ++next) {
                Box place = format_.column(format_.columns - 1 - (late_rest.size() > 1 && wide == 0 && next == 0 ? 1 : 0));
                if (wide > 0 && format_.columns < 3) place.min.y += wide_drawn + section_gap;  // no column beside the wide one
                const Block block = figure_block(*late_rest[next], format_.measure, small);
                set(sheets_.back().marks, block, place.min);
                small_drawn = std::max(small_drawn, block.height);
            }
            sheets_.back().runs = text_runs(wide_drawn, small_drawn, late_rest.size());
        } else {
            sheets_.back().runs = text_runs(0, 0, 0);
        }
        for (Section& section : rest)
            while (!section.rows.empty())
                if (!place_section(section)) split_section(section);
        if (small <= 0) place_last(late_rest);
    }

    /// Figures after the text, as large as the last page has columns to spare for them.
    void place_last(const std::vector<Wanted*>& figures) {
        if (figures.empty()) return;
        int free = 0;
        std::vector<Run>& runs = sheets_.back().runs;
        while (free < static_cast<int>(runs.size()) && runs[runs.size() - 1 - static_cast<std::size_t>(free)].used == 0) ++free;
        if (free < 2) {
            std::vector<Wanted*> left;
            for (Wanted* each : figures)
                if (!place_late(*each)) left.push_back(each);
            if (left.empty()) return;
            sheets_.emplace_back();
            sheets_.back().runs = text_runs(0, 0, 0);
            place_last(left);
            return;
        }
        // The mechanism over two columns, the circle in the third or below.
        const int first = format_.columns - free;
        Box place = format_.column(first);
        const bool third = free > 2 && figures.size() > 1;
        const double bottom = std::min(format_.column(first + 1).max.y, place.max.y);
        const double height = bottom - place.min.y - (figures.size() > 1 && !third ? 68 : 0);
        const Block block = figure_block(*figures.front(), 2 * format_.measure + gap, std::min(height, 150.0));
        set(sheets_.back().marks, block, place.min);
        if (figures.size() < 2) return;
        place = third ? format_.column(first + 2) : rectangle(place.min.x, place.min.y + block.height + gap, place.max.x, bottom);
        set(sheets_.back().marks, figure_block(*figures.back(), format_.measure, std::min(place.height(), 85.0)), place.min);
    }

    /// Columns of a text page below its figures.
    std::vector<Run> text_runs(double wide, double small, std::size_t figures) const {
        std::vector<Run> runs;
        for (int k = 0; k < format_.columns; ++k) {
            Run run{format_.column(k)};
            const bool last = k == format_.columns - 1;
            if (wide > 0 && k < 2) run.box.min.y += wide + section_gap;
            if (small > 0 && (last || (wide == 0 && figures > 1 && k == format_.columns - 2)))
                run.box.min.y += small + section_gap;
            runs.push_back(run);
        }
        return runs;
    }

    /// Whether a section may stand in a run: under a caption only what explains that figure.
    static bool may_stand(const Section& section, const Run& run) { return run.home == section.home || !run.under_caption; }

    bool place_section(Section& section, bool only_at_home = false) {
        const double height = section.height();
        for (const bool at_home : {true, false}) {
            if (at_home ? section.home < 0 : only_at_home) continue;
            for (Sheet& sheet : sheets_)
                for (Run& run : sheet.runs) {
                    if (section.of_forces && &sheet < sheets_.data() + force_page_) break;
                    if (section.in_order && place_of(sheet, run) < last_steps_) continue;
                    if (section.continued && (&sheet != &sheets_.back() || run.used > 0)) continue;
                    if (at_home ? run.home != section.home : !may_stand(section, run)) continue;
                    const double before = run.used > 0 ? section_gap : 0;
                    if (run.left() < before + height) continue;
                    run.used += before;
                    for (const Block& row : section.rows) {
                        set(sheet.marks, row, {run.box.min.x, run.box.min.y + run.used});
                        run.used += row.height;
                    }
                    section.rows.clear();
                    if (section.in_order) last_steps_ = place_of(sheet, run);
                    return true;
                }
        }
        return false;
    }

    /// Pages and their columns in the order of reading.
    using Place = std::pair<std::ptrdiff_t, std::ptrdiff_t>;
    Place place_of(const Sheet& sheet, const Run& run) const { return {&sheet - sheets_.data(), &run - sheet.runs.data()}; }

    /// A section longer than what is left anywhere: its first rows into the roomiest run, the rest goes on.
    void split_section(Section& section) {
        // From left to right, so that the rows are read in order.
        Run* best = nullptr;
        Sheet* on = &sheets_.back();
        const auto may_take = [&](const Run& run) { return !section.in_order || place_of(*on, run) >= last_steps_; };
        for (Run& run : on->runs)
            if (!best && may_take(run) && run.left() >= 30 + section_gap) best = &run;
        for (Run& run : on->runs)
            if (may_take(run) && (!best || (best->left() < 30 && run.left() > best->left()))) best = &run;
        const double first = section.rows.front().height + (section.rows.size() > 1 ? section.rows[1].height : 0);
        const double before = best && best->used > 0 ? section_gap : 0;
        // Not worth a split: a new page, unless this one is new already.
        const bool fresh = best && best->used == 0;
        if (!best || best->left() < before + std::max(first, fresh ? 0.0 : 30.0)) {
            KG_ASSERT(!fresh || first > best->left(), "a fresh column takes at least a row");
            if (!fresh) {
                sheets_.emplace_back();
                sheets_.back().runs = text_runs(0, 0, 0);
                return;
            }
        }
        // Rows that go on at the head of a column follow by themselves; below something else they need their heading.
        if (section.continued && before > 0) section.rows.insert(section.rows.begin(), section.heading_again);
        best->used += before;
        if (section.in_order) last_steps_ = place_of(*on, *best);
        std::size_t count = 0;
        while (count < section.rows.size() && (count == 0 || best->left() >= section.rows[count].height)) {
            set(on->marks, section.rows[count], {best->box.min.x, best->box.min.y + best->used});
            best->used += section.rows[count].height;
            ++count;
        }
        section.rows.erase(section.rows.begin(), section.rows.begin() + static_cast<std::ptrdiff_t>(count));
        section.continued = true;
    }

    bool place_late(Wanted& late) {
        for (Sheet& sheet : sheets_)
            for (Run& run : sheet.runs) {
                const double before = run.used > 0 ? section_gap : 0;
                const double room = std::min(run.left() - before, 0.95 * format_.measure);
                if (room < 58 || run.under_caption) continue;
                // A scale takes steps: a drawing of a few centimetres that misses the larger one says nothing.
                constexpr double least = 35;
                Figure figure = drawn(late, format_.measure, room);
                if (std::max(figure.box.width(), figure.box.height()) < least) continue;
                const Block block = figure_block(std::move(figure), format_.measure);
                set(sheet.marks, block, {run.box.min.x, run.box.min.y + run.used + before});
                run.used += before + block.height;
                return true;
            }
        return false;
    }

    const DrawingContext& context_;
    const SheetFormat& format_;
    WantedFigures& wanted_;
    std::vector<Section> sections_;
    std::vector<Sheet> sheets_;
    std::size_t force_page_;  // where forces begin
    int figures_;             // numbered so far
    Place last_steps_{0, 0};  // where the last steps stand that are read in order
};

}  // namespace

std::vector<Sheet> flow_text(const DrawingContext& context, const SheetFormat& format, WantedFigures& wanted,
                             const FigurePages& pages, std::vector<Section> sections) {
    return TextFlow(context, format, wanted, pages, std::move(sections)).sheets();
}

}  // namespace kinegraph::render
