// The scores of a figure's scales, and the search for the best arrangement of a band's figures and text.
#include "render/layout/band_layout.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/number/assert.hpp"

namespace kinegraph::render {
namespace {

constexpr double least_beside = 25;
constexpr double price_of_columns = 0.05;
constexpr double price_of_broken_row = 0.02;  // a table is read along its rows; more would cost the main figure a step
constexpr double price_of_corner = 0.3;       // half a step of a scale: an equation is read at its step
constexpr int most_beside = 3;                // columns of text
constexpr int most_columns_more = 2;          // beyond those of the format, for a page of short lines

}  // namespace

const ColumnText& BandTexts::of(const Band& band, int divided, bool cornered) {
    // What has no figure beside it takes the height of its tables.
    const bool whole_tables = band.figures.empty();
    const Rows key{{band.question, divided, cornered}, band.first_row, band.end_row, whole_tables};
    const auto found = texts_.find(key);
    if (found != texts_.end()) return found->second;
    std::vector<Passage> own = own_rows(whole(band, divided, cornered), band);
    return texts_.emplace(key, ColumnText(std::move(own), format_.span(1, divided), size_, whole_tables)).first->second;
}

BandTexts::Whole& BandTexts::begun(const Band& band, int divided, bool cornered) {
    Whole& whole = wholes_[{band.question, divided, cornered}];
    // A band that has only figures of a question, and no parts, may ask first.
    if (whole.passages.size() < band.parts.size()) {
        whole.passages.resize(band.parts.size());
        whole.is_set.resize(band.parts.size());
    }
    return whole;
}

const Passage& BandTexts::passage(const Band& band, std::size_t part, int divided, bool cornered) {
    Whole& text = begun(band, divided, cornered);
    if (text.is_set[part]) return text.passages[part];
    // Only steps differ if equations are in a corner; only results differ if a plan is repeated.
    const Band::Part::Kind kind = band.parts[part].kind;
    if (cornered && kind != Band::Part::Kind::steps)
        text.passages[part] = passage(band, part, divided, false);
    else if (!cornered && planned_ != nullptr && kind != Band::Part::Kind::results)
        text.passages[part] = planned_->passage(band, part, divided, false);
    else
        text.passages[part] = bands_.text(band.parts[part], format_.span(1, divided) / size_, cornered, results_);
    text.is_set[part] = true;
    return text.passages[part];
}

const std::vector<Passage>& BandTexts::whole(const Band& band, int divided, bool cornered) {
    for (std::size_t part = 0; part < band.parts.size(); ++part) passage(band, part, divided, cornered);
    return begun(band, divided, cornered).passages;
}

bool BandTexts::has_too_wide(const Band& band, int divided, bool cornered) {
    if (band.first_row > 0 || band.end_row < Band{}.end_row) return false;
    const double measure = format_.span(1, divided);
    for (std::size_t part = 0; part < band.parts.size(); ++part) {
        // Sentences adapt to any width.
        if (band.parts[part].kind == Band::Part::Kind::steps) continue;
        const Passage& set = passage(band, part, divided, cornered);
        if (!set.rows.empty() && is_wider(set, size_, measure)) return true;
    }
    return false;
}

std::size_t BandTexts::rows(const Band& band) {
    std::size_t rows = 0;
    for (const RowsOfPassage& passage : rows_by_passage(band)) rows += passage.count;
    return rows;
}

std::vector<BandTexts::RowsOfPassage> BandTexts::rows_by_passage(const Band& band) {
    std::vector<RowsOfPassage> rows;
    for (const Passage& passage : own_rows(whole(band, format_.columns, false), band))
        rows.push_back({passage.rows.size(), passage.is_table});
    return rows;
}

const Block& BandTexts::equations(const Band& band) {
    const auto [found, fresh] = equations_.try_emplace(band.question);
    constexpr double of_measure = 1.25;
    if (fresh) found->second = scaled(bands_.equations(band, of_measure * format_.measure / size_), size_);
    return found->second;
}

void BandTexts::forget(const std::string& question) {
    ++forgotten_[question];
    std::erase_if(wholes_, [&](const auto& each) { return std::get<0>(each.first) == question; });
    std::erase_if(texts_, [&](const auto& each) { return std::get<0>(std::get<0>(each.first)) == question; });
}

BandLayouts::BandLayouts(BandTexts& texts, const Band& band, const WantedFigures& wanted, MeasuredFigures& measured,
                         const SheetFormat& format, std::vector<std::vector<FigureSize>> sizes, bool narrow)
    : all_texts_(texts),
      band_(band),
      format_(format),
      narrow_(narrow),
      times_forgotten_(texts.times_forgotten(band.question)) {
    if (sizes.size() == 1 && wanted.list[band.figures.front()].has_corner)
        if (const Block& set = texts.equations(band); set.width > 0) {
            equations_ = &set;
            for (FigureSize& size : sizes.front()) size.wider = measured.wider_for(band.figures.front(), size, set);
        }
    figures_ = FigureShares(std::move(sizes));
}

const ColumnText& BandLayouts::text(int divided, bool cornered) const {
    const std::size_t index = 2 * static_cast<std::size_t>(divided) + (cornered ? 1 : 0);
    if (texts_.size() <= index) texts_.resize(index + 1);
    if (texts_[index] == nullptr) texts_[index] = &all_texts_.of(band_, divided, cornered);
    return *texts_[index];
}

bool BandLayouts::may_be_narrow(int divided, bool cornered) const {
    const std::size_t index = 2 * static_cast<std::size_t>(divided) + (cornered ? 1 : 0);
    if (may_be_narrow_.size() <= index) may_be_narrow_.resize(index + 1);
    std::optional<bool>& known = may_be_narrow_[index];
    if (!known)
        known = narrow_ && !all_texts_.has_too_wide(band_, divided, cornered) && !text(divided, cornered).is_too_wide();
    return *known;
}

double BandLayouts::taken_by(const BandLayout& layout) const {
    constexpr double of_text = 0.7;     // lines end before their columns do, and there is white space between tables
    constexpr double of_figures = 0.5;  // much of a figure is white: two small ones fill a page better than one
    double sum = 0;
    if (layout.divided > 0) {
        const ColumnText& own = text(layout.divided, layout.cornered);
        sum += of_text * own.whole_height() * own.measure();
    }
    for (const FigureSize& size : layout.sizes)
        sum += of_figures * (size.x + (layout.cornered ? size.wider : 0)) * size.y;
    return sum;
}

bool BandLayouts::may_improve(const Best& best, const Arrangement& layout) const {
    return layout.score + best.most_of_figures > best.layout.score;
}

bool BandLayouts::improves(const Best& best, const Arrangement& layout, Spot room) const {
    if (!may_improve(best, layout)) return false;
    for (const bool stacked : {false, true}) {
        if (stacked && figures_.sizes().size() < 2) break;
        const auto share = figures_.in(room, {stacked, layout.cornered});
        if (share && layout.score + share->score > best.layout.score) return true;
    }
    return false;
}

/// The price of the white beside the figures, below them and below the text beside them.
double BandLayouts::price_of_white(const Arrangement& layout, const Best& best, Spot figures, int shown) const {
    const double page = format_.content.width() * format_.content.height();
    const auto price = [&](double width, double height) {
        return render::price_of_white(std::max(width, 0.0) * std::max(height, 0.0) / page);
    };
    double left = best.whole, high = figures.y, sum = 0;
    if (layout.divided > 0) {
        const ColumnText& words = text(layout.divided, layout.cornered);
        const int beside = layout.beside ? layout.columns - layout.under : 0;  // at least one, if so
        const double columns = beside * (words.measure() + gap);
        left -= columns;
        if (layout.under > 0) {
            // Where all text has room beside the figures, white is below it.
            sum += price(columns, figures.y - words.whole_height() / beside);
            high = std::max(high,
                            words.whole_height() / layout.columns + (high + text_gap) * layout.under / layout.columns);
        } else if (layout.beside) {
            const double text = words.height(layout.columns);
            high = std::max(high, text);
            // The figures stand in the middle of this height.
            sum += price(columns, figures.y - text) + 2 * price(left, 0.5 * (text - figures.y));
        } else {
            const double text = words.height(layout.columns);
            high += text_gap + text;
            sum += price(left - layout.columns * (words.measure() + gap), text);
        }
    }
    const double beside_figures = layout.beside && layout.under == 0 ? high : figures.y;
    return sum + price(best.whole, best.ends - high) + price((left - figures.x) / std::max(shown, 2), beside_figures);
}

void BandLayouts::try_figures(Best& best, const Arrangement& layout, Spot room, double spare,
                              double share_of_height) const {
    if (!may_improve(best, layout)) return;
    for (const bool stacked : {false, true}) {
        if (stacked && figures_.sizes().size() < 2) break;
        const auto share = figures_.in(room, {stacked, layout.cornered});
        if (!share || !(layout.score + share->score > best.layout.score)) continue;
        const Spot taken = stacked ? Spot{share->across, share->length} : Spot{share->length, share->across};
        const double score = layout.score + share->score - price_of_white(layout, best, taken, share->shown);
        if (!(score > best.layout.score)) continue;
        best.layout = layout;
        best.room = room;
        best.layout.stacked = stacked;
        best.layout.score = score;
        best.spare = std::min(spare, share_of_height * (room.y - (stacked ? share->length : share->across)));
        // With several figures a lower room may have another division; with text below a figure the height is a result
        // of a search.
        best.lasts = figures_.sizes().size() == 1 && share_of_height == 1;
    }
}

void BandLayouts::add_rooms(BandLayout& layout, const Best& best) const {
    if (best.layout.score < BandLayout::possible || figures_.sizes().empty()) return;
    const FigureShares::Order order{best.layout.stacked, best.layout.cornered};
    const auto share = figures_.in(best.room, order);
    KG_ASSERT(share, "what was tried has room");
    const std::vector<std::size_t> taken = figures_.taken_in(best.room, order);
    const double whole = order.stacked ? best.room.y : best.room.x, wide = order.stacked ? best.room.x : best.room.y;
    // The rest is divided equally among the figures shown.
    const double left = (whole - share->length) / std::max(share->shown, 1);
    for (std::size_t f = 0; f < figures_.sizes().size(); ++f) {
        const FigureSize& size = figures_.sizes()[f][taken[f]];
        const double needed = FigureShares::along(size, order);
        const double own = needed > 0 ? needed + left : 0;
        layout.rooms.push_back(own > 0 ? (order.stacked ? Spot{wide, own} : Spot{own, wide}) : Spot{0, 0});
        layout.sizes.push_back(size);
    }
}

const WorthByHeight& BandLayouts::score(Width width, const Notch& notch, double step, int most) const {
    const auto [found, fresh] = score_.try_emplace(std::tuple(width, notch.left, notch.high));
    if (!fresh) return found->second;
    WorthByHeight& score = found->second;
    score.assign(static_cast<std::size_t>(most) + 1, BandLayout::impossible);
    struct Asked {
        std::size_t least;  ///< estimate of the least height with the same score
        bool is_certain;    ///< `least` is exact, and the heights between are filled in
    };
    const auto ask = [&](std::size_t height) -> Asked {
        const Best best = best_in(width, static_cast<double>(height) * step, notch, false);
        score[height] = best.layout.score;
        constexpr double rounding = 1e-6;
        const auto lower =
            static_cast<std::size_t>(std::max(0.0, best.spare / step + (best.lasts ? -rounding : rounding)));
        const std::size_t least = std::max<std::size_t>(height - std::min(lower, height), 1);
        if (best.lasts && least < height)
            std::fill(score.begin() + static_cast<std::ptrdiff_t>(least),
                      score.begin() + static_cast<std::ptrdiff_t>(height), score[height]);
        return {least, best.lasts};
    };
    // Fills the scores between two known heights by bisection.
    const std::function<void(std::size_t, std::size_t)> fill = [&](std::size_t low, std::size_t high) {
        if (score[low] == score[high])
            std::fill(score.begin() + static_cast<std::ptrdiff_t>(low),
                      score.begin() + static_cast<std::ptrdiff_t>(high), score[low]);
        if (score[low] == score[high] || high - low < 2) return;
        const std::size_t middle = (low + high) / 2;
        const Asked asked = ask(middle);
        fill(low, asked.is_certain ? std::max(asked.least, low) : middle);
        fill(middle, high);
    };
    // From the top down, each time to the height at which the score is expected to fall.
    std::size_t high = score.size() - 1, stride = 1;
    Asked asked = ask(high);
    while (high > 1 && score[high] > BandLayout::possible) {
        if (asked.is_certain && asked.least < high) {
            high = asked.least;
            stride = 1;
            if (high == 1) break;
        }
        const bool knows_where = asked.least < high;
        const std::size_t next = knows_where ? asked.least : high - std::min(stride, high - 1);
        asked = ask(next);
        fill(next, high);
        if (!knows_where) stride = score[next] == score[high] ? 2 * stride : 1;
        high = next;
    }
    fill(0, high);
    return score;
}

bool BandLayouts::is_like(const BandLayouts& other) const {
    return &all_texts_ == &other.all_texts_ && &band_ == &other.band_ && narrow_ == other.narrow_ &&
           times_forgotten_ == other.times_forgotten_ && figures_.sizes() == other.figures_.sizes() &&
           (equations_ != nullptr) == (other.equations_ != nullptr);
}

BandLayout BandLayouts::in(Width width, double height, Notch notch) const {
    const Best best = best_in(width, height, notch, true);
    BandLayout layout{best.layout};
    add_rooms(layout, best);
    return layout;
}

BandLayouts::Best BandLayouts::best_in(Width width, double height, Notch notch, bool fills) const {
    const double whole = format_.span(width.columns, width.of);
    constexpr double spaced = 12;  // mm, about what rows and figures are spaced by
    Best best{whole, fills ? height - notch.high - spaced : 0};
    if (height <= notch.high) return best;
    best.most_of_figures = figures_.best_score_in({whole, height});
    if (best.most_of_figures < BandLayout::possible) return best;
    for (const bool cornered : {false, true}) {
        if (cornered && equations_ == nullptr) break;
        Arrangement base;
        base.cornered = cornered;
        base.score = cornered ? -price_of_corner : 0;
        for (base.divided = format_.columns; base.divided <= format_.columns + most_columns_more; ++base.divided)
            try_all(best, base, whole, height, notch);
    }
    return best;
}

void BandLayouts::try_all(Best& best, Arrangement base, double whole, double height, Notch notch) const {
    constexpr double score_of_beside = 0.02;
    static_assert(score_of_beside <= price_of_columns, "no layout of this text is worth more than the base of all");
    if (!may_improve(best, base)) return;
    const double above = height - notch.high;
    if (base.divided > format_.columns && !may_be_narrow(base.divided, base.cornered)) return;
    const ColumnText& words = text(base.divided, base.cornered);
    base.score -= price_of_broken_row * words.broken_rows();
    Arrangement layout = base;
    if (words.empty()) {
        layout.divided = 0;
        return try_figures(best, layout, {whole, above}, above);
    }
    layout.columns = static_cast<int>((whole + gap + 0.1) / (words.measure() + gap));
    if (layout.columns > 0 && words.height(layout.columns) <= above) {
        if (figures_.sizes().empty()) {
            layout.score -= price_of_columns * layout.columns;
            if (!(layout.score > best.layout.score)) return;
            best.layout = layout;
            best.spare = above - words.height(layout.columns);
            best.lasts = true;
            return;
        }
        const double left = above - words.height(layout.columns) - text_gap;
        if (left > least_beside) try_figures(best, layout, {whole, left}, left - least_beside);
    }
    layout.beside = true;
    for (layout.columns = 1; layout.columns <= most_beside && !figures_.sizes().empty(); ++layout.columns) {
        // The penalty grows with the number of columns.
        layout.score = base.score + score_of_beside - price_of_columns * layout.columns;
        if (!may_improve(best, layout)) break;
        const double left = whole - layout.columns * (words.measure() + gap);
        if (left < least_beside || words.height(layout.columns) > above) continue;
        const double spare = above - words.height(layout.columns);
        try_figures(best, layout, {left, above}, spare);
        // Figures may stand left of the title block with the text above it.
        if (notch.high > 0 && std::min(left, notch.left) > least_beside)
            try_figures(best, layout, {std::min(left, notch.left), height}, spare);
    }
    layout.score = base.score;
    if (!figures_.sizes().empty()) try_round(best, layout, whole, height, notch);
}

TextColumns Arrangement::text_columns(double whole, double measure, double figures, const Notch& notch) const {
    TextColumns all;
    for (int i = 0; i < columns; ++i) {
        const bool below = !beside || i < under;
        // Columns beside the figures are aligned with the right edge.
        const double x = below ? i * (measure + gap) : whole - (columns - i) * (measure + gap) + gap;
        const bool over_block = notch.high > 0 && x + measure > notch.left + 0.05;
        all.push_back({x, below && figures > 0 ? figures + text_gap : 0, over_block ? notch.high : 0});
    }
    return all;
}

/// Tries figures in the upper left corner with text below and beside them. The height of the figures is the greatest
/// for which the text fits, found by bisection.
void BandLayouts::try_round(Best& best, Arrangement layout, double whole, double height, Notch notch) const {
    const ColumnText& words = text(layout.divided, layout.cornered);
    layout.beside = true;
    layout.columns = static_cast<int>((whole + gap + 0.1) / (words.measure() + gap));
    layout.score -= price_of_columns * layout.columns;
    if (!may_improve(best, layout) || layout.columns * height - least_beside < words.whole_height()) return;
    for (layout.under = 1; layout.under < layout.columns; ++layout.under) {
        const double left = whole - (layout.columns - layout.under) * (words.measure() + gap);
        double low = least_beside, high = left <= notch.left || notch.high == 0 ? height : height - notch.high;
        // Skip the search if neither the full height nor the height that the text can leave improves the score.
        const double most = (layout.columns * height - words.least_height(layout.columns)) / layout.under - text_gap;
        if (left < least_beside || !improves(best, layout, {left, std::min(high, most)})) continue;
        TextColumns columns = layout.text_columns(whole, words.measure(), least_beside, notch);
        const auto holds = [&](double figures) {
            for (int i = 0; i < layout.under; ++i) columns[static_cast<std::size_t>(i)].top = figures + text_gap;
            return words.fits(columns, height);
        };
        if (!holds(least_beside)) continue;
        constexpr double fine = 2;
        while (high - low > fine) {
            const double middle = 0.5 * (low + high);
            (holds(middle) ? low : high) = middle;
        }
        // A height taken from the figures is divided among all columns of text.
        try_figures(best, layout, {left, low}, height, static_cast<double>(layout.under) / layout.columns);
    }
}

}  // namespace kinegraph::render
