#include "render/sheet/cycle_sheet.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "engine/sentences/result_catalogue.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/sheet.hpp"
#include "render/equations/prose.hpp"
#include "render/page/shapes.hpp"
#include "render/tables/extremes.hpp"

namespace kinegraph::render {
namespace {

class ExtremesTable {
public:
    ExtremesTable(const DrawingContext& context, const CycleTable& table,
                  const std::vector<std::vector<std::size_t>>& plots, double width, double most_height)
        : context_(context),
          theme_(context.theme),
          table_(table),
          plots_(plots),
          width_(width),
          most_height_(most_height) {}

    Block drawn() {
        Block block;
        set(block.marks,
            heading_block(
                context_, width_,
                word(table_.parameter ? lang::sheet::extremes_of_rows : lang::sheet::extremes, context_.language), {}),
            {0, 0});
        y_ = 6.2;
        rule(block, theme_.outline);
        cells(block,
              {one_piece(word(lang::common::quantity, context_.language)),
               one_piece(word(lang::sheet::least, context_.language)),
               one_piece(word(lang::sheet::at_the_position, context_.language)),
               one_piece(word(lang::sheet::greatest, context_.language)),
               one_piece(word(lang::sheet::at_the_position, context_.language))},
              theme_.secondary);
        rule(block, theme_.thin);
        for (const auto& plot : plots_)
            for (const std::size_t column : plot) row_of(block, column);
        rule(block, theme_.outline);
        y_ += 1;
        for (const RichText& each : facts()) {
            const Block line = paragraph_block(context_, width_, each, 0, "");
            set(block.marks, line, {0, y_});
            y_ += line.height;
        }
        block.width = width_;
        block.height = y_;
        return block;
    }

private:
    using Kind = Quantity::Kind;

    std::string coordinate(double si) const {
        if (table_.parameter) {
            const Unit& unit = table_.parameter->unit;
            const bool is_close = unit.symbol.empty() || unit.symbol == "°";
            return number(si / unit.si.to_double(), 4, context_.language) + (is_close ? "" : " ") + unit.symbol;
        }
        const Unit unit =
            table_.turns ? Unit{"°", pi() / 180} : unit_of(QuantityKind::length, context_.solution.mechanism);
        return number(si / unit.si.to_double(), 4, context_.language) + (table_.turns ? "°" : " " + unit.symbol);
    }

    /// The driver's coordinate of a position, or its time if the driver has a law of motion.
    std::string place(double at) const {
        return table_.travel.times ? number(at, 4, context_.language) + " s" : coordinate(at);
    }

    std::string amount(double si, const Column& column) const {
        return amount(si, unit_of(column, context_.solution.mechanism));
    }
    std::string amount(double si, const Unit& unit) const {
        const bool is_close = unit.symbol == "°" || unit.symbol.empty();
        return number(si / unit.si.to_double(), 4, context_.language) + (is_close ? "" : " ") + unit.symbol;
    }

    void rule(Block& block, double weight) {
        block.marks.emplace_back(line({0, y_}, {width_, y_}, {weight, theme_.text, {}, false}));
        y_ += 1;
    }

    void cells(Block& block, const std::array<RichText, 5>& words, Colour colour) {
        const std::array<double, 5> rights{0, 0.44 * width_, 0.6 * width_, 0.84 * width_, width_};
        for (std::size_t i = 0; i < words.size(); ++i) {
            const ShapedLine shaped = context_.fonts.shape(words[i], theme_.small);
            set_text(block.marks, shaped, {i == 0 ? 0 : rights[i] - shaped.width, y_ + 3.2}, colour, "text");
        }
        y_ += 4.4;
    }

    void row_of(Block& block, std::size_t column) {
        if (table_.rows.empty() || y_ > most_height_) return;
        const auto [least, most] = extremes_of(table_, column);
        const Column& of = table_.columns[column];
        const RichText name = typeset(table_.columns[column], context_.solution.mechanism, context_.language);
        if (is_constant(table_, column)) {
            const RichText value = with_powers(amount((least.value + most.value) / 2, of));
            return cells(block, {name, value, {}, value, {}}, theme_.text);
        }
        const auto value = [&](const Extreme& each, bool below) {
            if (is_beside_gap(table_, each)) return one_piece("–");
            return is_unbounded(table_, column, below) ? one_piece(word(lang::sheet::without_limit, context_.language))
                                                       : with_powers(amount(each.value, of));
        };
        const auto where = [&](const Extreme& each, bool below) {
            return is_unbounded(table_, column, below) || is_beside_gap(table_, each) ? RichText()
                                                                                      : one_piece(place(each.at));
        };
        cells(block, {name, value(least, true), where(least, true), value(most, false), where(most, false)},
              theme_.text);
    }

    /// Further results: strokes, change points, largest speeds.
    std::vector<RichText> facts() const {
        std::vector<RichText> said;
        const auto say = [&](const std::string& what, const std::string& value) {
            said.push_back(with_powers(what + word(lang::notation::colon, context_.language) + value));
        };
        const auto in_words = [&](Key key) { return word(key, context_.language); };
        const std::string at = " " + in_words(lang::sheet::at_the_position) + " ";
        const Travel& travel = table_.travel;
        if (travel.starts_at_limit || travel.ends_at_limit)
            say(in_words(lang::sheet::limits_of_the_driver),
                (travel.starts_at_limit ? coordinate(travel.from) : "") +
                    (travel.starts_at_limit && travel.ends_at_limit ? ", " : "") +
                    (travel.ends_at_limit ? coordinate(travel.to) : ""));
        if (!travel.change_points.empty()) {
            std::string all;
            for (const double each : travel.change_points) all += (all.empty() ? "" : ", ") + coordinate(each);
            say(in_words(lang::sheet::change_points), all);
        }
        for (std::size_t i = 0; i < table_.columns.size(); ++i) tell_of_column(i, said);
        tell_of_separations(said);
        if (table_.transmission)
            say(in_words(lang::sheet::least_transmission_angle),
                // To hundredths: at a dead point, where the angle is zero, the position is not known more precisely.
                number(std::round(table_.transmission->least * 18000 / std::numbers::pi) / 100, 4, context_.language) +
                    "°" + at + coordinate(table_.transmission->at));
        if (const auto fastest = largest_of_points(Kind::velocity)) say(in_words(lang::sheet::largest_speed), *fastest);
        if (const auto hardest = largest_of_points(Kind::acceleration))
            say(in_words(lang::sheet::largest_acceleration), *hardest);
        for (const Words& fact : table_.facts) said.push_back(with_powers(in(fact, context_.language)));
        return said;
    }

    void tell_of_column(std::size_t column, std::vector<RichText>& said) const {
        const Column& of = table_.columns[column];
        if (table_.rows.size() < 3) return;
        const auto say = [&](Key key, const std::string& value) {
            RichText text = one_piece(word(key, context_.language) + "  ");
            append(text, typeset(of, context_.solution.mechanism, context_.language));
            append(text, with_powers(word(lang::notation::colon, context_.language) + value));
            said.push_back(std::move(text));
        };
        // Of all other columns nothing but their poles is told, and there may be thousands.
        if (of.kind != Column::Kind::slid && of.quantity.kind != Kind::effort) return tell_of_poles(column, said);
        const auto [least, most] = extremes_of(table_, column);
        if (of.kind == Column::Kind::slid && !is_beside_gap(table_, least) && !is_beside_gap(table_, most)) {
            const bool is_far = is_unbounded(table_, column, true) || is_unbounded(table_, column, false);
            say(lang::sheet::stroke,
                is_far ? word(lang::sheet::without_limit, context_.language) : amount(most.value - least.value, of));
            if (is_far) return tell_of_poles(column, said);
            // For a full turn at constant speed the time is proportional to the rotation between the two ends of the
            // stroke, if it goes forth once and back once.
            const double whole = std::abs(table_.travel.to - table_.travel.from), one = std::abs(most.at - least.at);
            if (!table_.turns || table_.travel.times || std::abs(whole - 2 * std::numbers::pi) > 1e-9 || one == 0 ||
                one == whole || rests(column, least) || rests(column, most) || reversals(column) != 2)
                return;
            const double ratio = std::max(one, whole - one) / std::min(one, whole - one);
            // Equal times in both directions are no quick return.
            if (ratio > 1.001) say(lang::sheet::time_ratio, number(ratio, 4, context_.language));
        }
        tell_of_poles(column, said);
        if (const FollowedColumn* followed = followed_of(table_, column); followed && of.quantity.kind == Kind::effort)
            return say(lang::sheet::mean, followed->mean ? amount(*followed->mean, of)
                                                         : word(lang::sheet::without_limit, context_.language));
        if (of.quantity.kind == Kind::effort) {
            double sum = 0, way = 0;
            for (std::size_t i = 1; i < table_.rows.size(); ++i) {
                const double step = table_.rows[i][table_.over()] - table_.rows[i - 1][table_.over()];
                sum += (table_.rows[i][column] + table_.rows[i - 1][column]) / 2 * step;
                way += step;
            }
            const double rounding = 1e-9 * std::max(std::abs(least.value), std::abs(most.value));
            if (way != 0) say(lang::sheet::mean, amount(std::abs(sum / way) < rounding ? 0 : sum / way, of));
        }
    }

    /// Where a plotted column has poles.
    void tell_of_poles(std::size_t column, std::vector<RichText>& said) const {
        const FollowedColumn* followed = followed_of(table_, column);
        if (followed == nullptr || followed->poles.empty()) return;
        std::string all;
        for (const double each : followed->poles) all += (all.empty() ? "" : ", ") + place(each);
        RichText text = typeset(table_.columns[column], context_.solution.mechanism, context_.language);
        append(text, " " + word(lang::sheet::grows_without_limit_at, context_.language) + " " + all);
        said.push_back(std::move(text));
    }
    /// Contacts that would have to pull, from where to where.
    void tell_of_separations(std::vector<RichText>& said) const {
        const std::vector<Separation>& all = table_.followed.separations;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (i == 0 || all[i].joint != all[i - 1].joint)
                said.push_back(one_piece(word(lang::sheet::separation, context_.language) + " " +
                                         context_.solution.mechanism.joint(all[i].joint).name +
                                         word(lang::notation::colon, context_.language)));
            else
                append(said.back(), ", ");
            append(said.back(), place(all[i].from) + " … " + place(all[i].to));
        }
    }

    /// How often a column turns round in a whole turn, of which the last row is the first again.
    std::size_t reversals(std::size_t column) const {
        const double rounding = rounding_of(table_, column);
        std::vector<bool> rising;
        for (std::size_t i = 1; i < table_.rows.size(); ++i)
            if (const double step = table_.rows[i][column] - table_.rows[i - 1][column]; std::abs(step) > rounding)
                rising.push_back(step > 0);
        std::size_t count = 0;
        for (std::size_t i = 0; i < rising.size(); ++i) count += rising[i] != rising[(i + 1) % rising.size()] ? 1 : 0;
        return count;
    }

    /// Whether it dwells at its extreme for more than two rows, so that this end of the stroke is not a single
    /// position.
    bool rests(std::size_t column, const Extreme& end) const {
        const double near = 1e-9 * std::abs(end.value) + rounding_of(table_, column);
        return std::count_if(table_.rows.begin(), table_.rows.end(),
                             [&](const auto& row) { return std::abs(row[column] - end.value) <= near; }) > 2;
    }

    /// Whether a velocity grows without bound next to a limit of the travel, so that it has no largest value.
    bool grows_to_a_limit(const Extreme& largest, const std::vector<double>& sizes) const {
        if (table_.limits.empty() || sizes.size() < 2) return false;
        const double at = largest.at;
        const double first = table_.rows.front()[table_.over()], last = table_.rows.back()[table_.over()];
        return (at == first && table_.travel.starts_at_limit) || (at == last && table_.travel.ends_at_limit);
    }

    /// "1.23 m/s (A) at 45°".
    std::optional<std::string> largest_of_points(Kind kind) const {
        Extreme largest;
        PointIndex point;
        bool is_same_everywhere = false;  // then no position is its own
        constexpr double rounding = 1e-9;
        for (std::size_t i = 0; i + 1 < table_.columns.size(); ++i) {
            const Column &x = table_.columns[i], &y = table_.columns[i + 1];
            if (x.kind != Column::Kind::result || x.quantity.kind != kind ||
                x.quantity.component != Quantity::Component::x || y.quantity.point != x.quantity.point ||
                y.quantity.kind != kind)
                continue;
            std::vector<double> sizes;
            for (const auto& row : table_.rows) sizes.push_back(length(Spot{row[i], row[i + 1]}));
            const auto [least, of_point] = extremes_of(table_, sizes);
            if (grows_to_a_limit(of_point, sizes) || is_beside_gap(table_, of_point)) return std::nullopt;
            if (of_point.value <= largest.value * (1 + rounding)) continue;
            largest = of_point;
            is_same_everywhere = of_point.value - least.value <= rounding * of_point.value;
            point = x.quantity.point;
        }
        if (point == none) return std::nullopt;
        return amount(largest.value, unit_of(result_kind(kind).unit, context_.solution.mechanism)) + " (" +
               context_.solution.mechanism.point(point).name + ")" +
               (is_same_everywhere
                    ? ""
                    : " " + word(lang::sheet::at_the_position, context_.language) + " " + place(largest.at));
    }

    const DrawingContext& context_;
    const Theme& theme_;
    const CycleTable& table_;
    const std::vector<std::vector<std::size_t>>& plots_;
    double width_, most_height_;
    double y_ = 0;
};

}  // namespace

Block cycle_extremes(const DrawingContext& context, const CycleTable& table,
                     const std::vector<std::vector<std::size_t>>& plots, double width, double most_height) {
    return ExtremesTable(context, table, plots, width, most_height).drawn();
}

}  // namespace kinegraph::render
