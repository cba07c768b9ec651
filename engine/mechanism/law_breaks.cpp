#include "engine/mechanism/law_breaks.hpp"

#include <algorithm>
#include <cmath>

namespace kinegraph {
namespace {

/// The state within a single piece, starting at s = 0; both ends have the piece's own derivatives.
LawState within(const LawPiece& piece, double t) { return Law{{piece}, {}, {}}.at(t); }
LawState raised(LawState state, double by) {
    state.s += by;
    return state;
}

}  // namespace

std::vector<LawBreak> breaks_of_cycle(const Law& law) {
    double slope = 0, bend = 0;
    for (const LawPiece& piece : law.pieces) {
        const double over = piece.over.to_double(), mean = std::abs(piece.rise.to_double()) / over;
        slope = std::max(slope, mean);
        bend = std::max(bend, mean / over);
    }
    constexpr double nothing = 1e-9;
    std::vector<LawBreak> breaks;
    const auto add = [&](double at, const LawState& before, const LawState& after) {
        const bool of_speed = std::abs(after.first - before.first) > nothing * slope;
        if (of_speed || std::abs(after.second - before.second) > nothing * bend)
            breaks.push_back({at, before, after, of_speed});
    };
    double start = 0, way = 0;
    for (std::size_t i = 0; i < law.pieces.size(); ++i) {
        const LawPiece& piece = law.pieces[i];
        const LawPiece& earlier = i == 0 ? law.pieces.back() : law.pieces[i - 1];
        const double over = piece.over.to_double();
        LawState before = within(earlier, earlier.over.to_double());
        before.s = way;
        add(start, before, raised(within(piece, 0), way));
        if (piece.form == LawForm::constant_acceleration) {
            // In the middle the acceleration becomes a deceleration of the same size.
            const LawState after = raised(within(piece, over / 2), way);
            add(start + over / 2, {after.s, after.first, -after.second}, after);
        }
        start += over;
        way += within(piece, over).s;
    }
    return breaks;
}

}  // namespace kinegraph
