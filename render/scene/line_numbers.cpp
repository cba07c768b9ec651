// Line numbers: see line_numbers.hpp.
#include "render/scene/line_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace kinegraph::render {
namespace {

// The font has circled digits up to 9.
constexpr std::array<const char*, 9> circled{"①", "②", "③", "④", "⑤", "⑥", "⑦", "⑧", "⑨"};

constexpr const char* unbroken_blank = "\u00A0";

/// Lines with the same direction through the same point are one line, whichever statement draws them.
bool is_same(const SceneLine& a, const SceneLine& b, double size) {
    constexpr double coincident = 1e-6;
    const auto near = [&](Place p, Place q) {
        return std::abs(p.x - q.x) <= coincident * size && std::abs(p.y - q.y) <= coincident * size;
    };
    return a.reason == b.reason && near(a.support, b.support) && near(a.meet, b.meet);
}

}  // namespace

LineNumbers::LineNumbers(const PolygonScene& scene) {
    std::vector<const SceneLine*> distinct;
    for (const SceneLine& line : scene.lines) {
        if (line.reason.kind == LineReason::Kind::known) continue;
        const auto same = std::find_if(distinct.begin(), distinct.end(),
                                       [&](const SceneLine* other) { return is_same(*other, line, scene.size()); });
        const auto number = static_cast<std::size_t>(same - distinct.begin());
        if (same == distinct.end()) distinct.push_back(&line);
        lines_.push_back({line.statement, line.reason, number});
    }
    if (distinct.size() < 2) lines_.clear();
}

std::string LineNumbers::of(StatementIndex statement, const LineReason& reason) const {
    const auto found = std::find_if(lines_.begin(), lines_.end(), [&](const Numbered& each) {
        return each.statement == statement && each.reason == reason;
    });
    if (found == lines_.end() || found->number >= circled.size()) return {};
    return circled[found->number];
}

std::string LineNumbers::before(StatementIndex statement, const LineReason& reason) const {
    const std::string number = of(statement, reason);
    return number.empty() ? number : number + unbroken_blank;
}

}  // namespace kinegraph::render
