// The table of Joukowsky's lever. Forces, velocities and powers come from the Solution; computes no statics.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/number/assert.hpp"
#include "engine/number/functions.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/sheet.hpp"
#include "render/page/shapes.hpp"
#include "render/tables/tables.hpp"

namespace kinegraph::render {
namespace {

/// Table cells show scalars.
RichText scalar(RichText text) {
    for (Piece& piece : text)
        if (piece.face == Face::bold_italic) piece.face = Face::italic;
    return text;
}

/// The lines of the table: force, magnitude, arm or ω, power.
class LeverTable {
public:
    explicit LeverTable(const DrawingContext& context)
        : context_(context),
          units_(context.solution.mechanism.units),
          theme_(context.theme),
          work_(work_of(context.solution)) {
        for (const VirtualWork::Entry& entry : work_.entries)
            largest_ = std::max(largest_, std::abs(entry.power.to_double()));
        plain_powers_ = largest_ == 0 || (largest_ >= 1e-3 && largest_ < 1e7);
        decimals_ = largest_ > 0 ? std::clamp(3 - static_cast<int>(std::floor(nearest::log10(largest_))), 0, 6) : 0;
        add_head();
        for (const VirtualWork::Entry& entry : work_.entries) {
            if (!entry.force.is_zero()) add_force(entry);
            if (!entry.couple.is_zero()) add_couple(entry);
        }
        sum_.letters = theme_.text;
        sum_.cells[0] = shape(word(lang::sheet::sum, context_.language), theme_.body_text);
        sum_.cells[3] = shape(power(work_.total.to_double()), theme_.body_text);
    }

    Block block(double most) const {
        Block block;
        const std::array<double, 4> right = columns(most);
        block.width = right[3];
        const auto rule = [&](double y, double width) {
            block.marks.emplace_back(line({0, y}, {block.width, y}, {width, theme_.text, {}, false}));
        };
        const auto set_line = [&](const Line& each, double baseline, Colour colour) {
            set_text(block.marks, each.cells[0], {0, baseline}, each.letters, "text");
            for (std::size_t c = 1; c < 4; ++c)
                set_text(block.marks, each.cells[c], {right[c] - each.cells[c].width, baseline}, colour, "text");
        };
        rule(0, theme_.outline);
        set_line(head_, 3.4, theme_.secondary);
        rule(5, theme_.thin);
        double baseline = 9;
        for (const Line& each : lines_) {
            set_line(each, baseline, theme_.text);
            baseline += 4.5;
        }
        rule(baseline - 2.9, theme_.thin);
        set_line(sum_, baseline + 0.8, theme_.text);
        rule(baseline + 2.5, theme_.outline);
        baseline += 7;
        const Message said{couples_ ? lang::sheet::lever_with_couples : lang::sheet::lever_of_forces, {}};
        for (ShapedLine& each : context_.fonts.wrap(say(said, context_.language), theme_.small, block.width)) {
            set_text(block.marks, std::move(each), {0, baseline}, theme_.secondary, "text");
            baseline += 3.9;
        }
        block.height = baseline - 3.9 + 1.2;
        return block;
    }

private:
    struct Line {
        std::array<ShapedLine, 4> cells;
        Colour letters;
    };

    static const VirtualWork& work_of(const Solution& solution) {
        KG_ASSERT(solution.virtual_work, "the lever wants the powers");
        return *solution.virtual_work;
    }
    ShapedLine shape(const std::string& text, double size) const {
        return context_.fonts.shape(with_powers(text), size);
    }
    std::string amount(double si, const Unit& unit) const {
        return number(si / unit.si.to_double(), 4, context_.language) + " " + unit.symbol;
    }
    std::string power(double value) const {
        if (std::abs(value) <= 1e-9 * largest_) return "0";
        return plain_powers_ ? fixed(value, decimals_, context_.language) : number(value, 4, context_.language);
    }
    ShapedLine quantity(const Symbol& symbol) const {
        return context_.fonts.shape(scalar(typeset(symbol, context_.language)), theme_.body_text + 0.5);
    }

    void add_head() {
        const Language language = context_.language;
        head_ = {{shape("", theme_.small), shape(word(lang::common::magnitude, language), theme_.small), {}, {}},
                 theme_.secondary};
        RichText arm = one_piece(word(lang::sheet::lever_arm, language) + " ");
        append(arm, one_piece("h", Face::italic));
        append(arm, with_powers(", " + units_.velocity.symbol));
        head_.cells[2] = context_.fonts.shape(arm, theme_.small);
        head_.cells[3] = shape(word(lang::sheet::power, language) + ", W", theme_.small);
    }
    void add_force(const VirtualWork::Entry& entry) {
        const double f = kinegraph::length(entry.force), p = dot(entry.force, entry.velocity).to_double();
        const double reach = std::abs(p) / f / units_.velocity.si.to_double();
        lines_.push_back(
            {{quantity(entry.symbol), shape(amount(f, units_.force), theme_.body_text),
              shape(number(reach, 4, context_.language), theme_.body_text), shape(power(p), theme_.body_text)},
             theme_.colour_of(entry.body).letter});
    }
    void add_couple(const VirtualWork::Entry& entry) {
        couples_ = true;
        Symbol symbol = entry.symbol;
        symbol.letter = Symbol::Letter::M;
        const std::string& body = context_.solution.mechanism.bodies[at_index(entry.body)].name;
        RichText omega = typeset(Symbol{Symbol::Letter::omega, body, ""}, context_.language);
        append(omega, with_powers(" = " + amount(entry.omega.to_double(), units_.angular_velocity)));
        lines_.push_back({{quantity(symbol), shape(amount(entry.couple.to_double(), units_.moment), theme_.body_text),
                           context_.fonts.shape(omega, theme_.body_text),
                           shape(power((entry.couple * entry.omega).to_double()), theme_.body_text)},
                          theme_.colour_of(entry.body).letter});
    }

    /// Right edges of the columns.
    std::array<double, 4> columns(double most) const {
        std::array<double, 4> widths{};
        const auto measure = [&](const Line& each) {
            for (std::size_t c = 0; c < 4; ++c) widths[c] = std::max(widths[c], each.cells[c].width);
        };
        measure(head_);
        measure(sum_);
        for (const Line& each : lines_) measure(each);
        const double gap = std::clamp((most - widths[0] - widths[1] - widths[2] - widths[3]) / 3, 2.0, 4.0);
        std::array<double, 4> right{};
        for (std::size_t c = 0; c < 4; ++c) right[c] = (c == 0 ? 0 : right[c - 1] + gap) + widths[c];
        return right;
    }

    const DrawingContext& context_;
    const Units& units_;
    const Theme& theme_;
    const VirtualWork& work_;
    double largest_ = 0;  // largest power, which fixes the decimals of all
    bool plain_powers_ = true;
    int decimals_ = 0;
    Line head_, sum_;
    std::vector<Line> lines_;
    bool couples_ = false;
};

}  // namespace

Block joukowsky_block(const DrawingContext& context, double most) { return LeverTable(context).block(most); }

}  // namespace kinegraph::render
