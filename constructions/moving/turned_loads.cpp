#include "constructions/moving/turned_loads.hpp"

#include <utility>
#include <variant>

#include "engine/number/functions.hpp"

namespace kinegraph {
namespace {

constexpr int directions = 24;
// Off the multiples of a degree, where two lines are parallel by chance.
constexpr double beside = 0.0137, step = 6.283185307179586 / directions;

/// Limits of the search, so that it is short beside the page: hundreds of loads are not all turned.
constexpr std::size_t most_strokes = 10'000'000;
constexpr std::size_t most_unplanned = 100;

bool is_of(const Given& given, const MovingSetting& setting) {
    if (given.index != setting.of) return false;
    using Kind = Given::Kind;
    if (setting.kind == MovingSetting::Kind::point_velocity) return given.kind == Kind::act_velocity;
    return given.kind == Kind::load_force || given.kind == Kind::load_magnitude || given.kind == Kind::load_unit ||
           given.kind == Kind::load_unit_back;
}

}  // namespace

TurnedLoads::TurnedLoads(const Mechanism& mechanism, const Pose& pose, const std::vector<MovingSetting>& settings)
    : mechanism_(mechanism), pose_(pose), settings_(settings), changed_(mechanism) {}

void TurnedLoads::add(const Program& program) {
    known_.push_back({program, Replay(program, givens_of(program, mechanism_, pose_), pose_.size.to_double())});
}

void TurnedLoads::each_unplanned(const std::function<bool(const Mechanism&)>& plan) {
    // Each alone, then all together.
    for (const double size : {1.0, 2.5, 0.4})
        for (std::size_t alone = 0; alone < settings_.size(); ++alone) {
            if (!settings_[alone].direction) continue;
            for (int k = -4; k < directions; ++k) {
                change(alone, k < 0 ? Change{k + 4, 0, size} : Change{0, k * step + beside, size});
                const bool goes_on = look_at(plan);
                restore(alone);
                if (!goes_on) return;
            }
        }
    for (int k = 0; settings_.size() > 1 && k < directions; ++k) {
        for (std::size_t each = 0; each < settings_.size(); ++each)
            if (settings_[each].direction) change(each, {0, (k + 0.4 * static_cast<double>(each)) * step + beside, 1});
        if (!look_at(plan)) return;
    }
}

bool TurnedLoads::look_at(const std::function<bool(const Mechanism&)>& plan) {
    if (is_planned()) return strokes_ <= most_strokes;
    return plan(changed_) && ++unplanned_ < most_unplanned && strokes_ <= most_strokes;
}

bool TurnedLoads::is_planned() {
    for (Known& known : known_) {
        strokes_ += known.program.strokes.size();
        if (!known.replay.run()) return true;
    }
    return false;
}

void TurnedLoads::change(std::size_t setting, const Change& by) {
    const Exact size = Exact::from_double(by.size);
    const Vector more{Exact::from_double(nearest::cos(by.more)), Exact::from_double(nearest::sin(by.more))};
    const auto turned = [&](Vector vector) {
        for (int i = 0; i < by.quarters; ++i) vector = quarter_turn(vector);
        return by.more == 0 ? vector : faced(more, vector);
    };
    const std::size_t of = at_index(settings_[setting].of);
    if (settings_[setting].kind == MovingSetting::Kind::point_velocity) {
        changed_.motion->velocities[of].value =
            size * turned(std::get<Vector>(mechanism_.motion->velocities[of].value));
    } else {
        const auto& drawn = std::get<ForceLoad>(mechanism_.loads[of]);
        auto& force = std::get<ForceLoad>(changed_.loads[of]);
        if (drawn.value) force.value = size * turned(*drawn.value);
        if (drawn.magnitude)
            force.magnitude = {size * drawn.magnitude->first,
                               Bearing{turned(direction_of(drawn.magnitude->second, pose_))}};
    }
    give(setting);
}

void TurnedLoads::restore(std::size_t setting) {
    const std::size_t of = at_index(settings_[setting].of);
    if (settings_[setting].kind == MovingSetting::Kind::point_velocity)
        changed_.motion->velocities[of] = mechanism_.motion->velocities[of];
    else
        changed_.loads[of] = mechanism_.loads[of];
    give(setting);
}

void TurnedLoads::give(std::size_t setting) {
    for (Known& known : known_) {
        const std::vector<Given>& givens = known.program.givens;
        for (std::size_t i = 0; i < givens.size(); ++i)
            if (is_of(givens[i], settings_[setting]))
                known.replay.give(static_cast<int>(i), to_double(given_value(givens[i], changed_, pose_)));
    }
}

}  // namespace kinegraph
