#include "constructions/statics/forces/trials.hpp"

#include <array>

#include "constructions/kinematics/trial_size.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::statics {

void Trials::close_by_trial(const std::vector<Load>& loads, Run& run) {
    int tried = -1, hinge = -1;
    for (std::size_t b = 0; b < model_.bonds().size() && tried < 0; ++b) {
        if (run.reactions[b].known) continue;
        const Bond::Kind of = known_.shape(static_cast<int>(b), run);
        if (of == Bond::Kind::line || of == Bond::Kind::couple) tried = static_cast<int>(b);
        if (of == Bond::Kind::pin && hinge < 0) hinge = static_cast<int>(b);
    }
    if (tried >= 0) {
        try_value(loads, run, tried);
    } else if (hinge >= 0) {
        model_.add_components(hinge);
        known_.fit(run);
        close_by_trial(loads, run);
    }
}

bool Trials::try_value(const std::vector<Load>& loads, Run& run, int b) {
    said_.say(lang::sentences::trial, {said_.with_mark(model_.bonds()[at(b)].symbol)}, "");
    Run first = run, second = run;
    const std::optional<Force> largest = largest_of(loads);
    give(first, b, 2, largest);
    give(second, b, 3, largest);
    said_.enter_trial();
    for (Run* trial : {&first, &second}) {
        rules_.advance(loads, *trial);
        if (!trial->complete) break;
    }
    said_.leave_trial();
    if (!first.complete || !second.complete) return false;
    const auto [gap, change] = clearest_gap(loads, first, second);
    if (!change) return false;
    const ScalarHandle share = board_.quotient(gap, *change);
    run = sums_.combine(first, board_.difference(board_.number(1), share), second, share);
    run.complete = true;
    return true;
}

std::pair<ScalarHandle, std::optional<ScalarHandle>> Trials::clearest_gap(const std::vector<Load>& loads,
                                                                          const Run& first, const Run& second) {
    ScalarHandle gap;
    std::optional<ScalarHandle> largest;
    for (const auto& components : {std::vector<std::size_t>{0, 1}, std::vector<std::size_t>{2}}) {
        for (const MemberIndex member : model_.moving_members()) {
            const auto gap_1 = gaps(member, loads, first), gap_2 = gaps(member, loads, second);
            for (const std::size_t c : components) {
                const ScalarHandle change = board_.difference(gap_1[c], gap_2[c]);
                if (board_.is_zero(change)) continue;
                if (largest && !board_.choose_longer(as_force(change), as_force(*largest))) continue;
                gap = gap_1[c];
                largest = change;
            }
        }
        if (largest) break;
    }
    return {gap, largest};
}

std::optional<Force> Trials::largest_of(const std::vector<Load>& loads) {
    std::optional<Force> largest;
    for (const Load& load : loads) {
        const Force size = load.force ? *load.force : as_force(*load.couple);
        if (!largest || board_.choose_longer(size, *largest)) largest = size;
    }
    return largest;
}

void Trials::give(Run& run, int b, int size, const std::optional<Force>& largest) {
    Reaction& reaction = run.reactions[at(b)];
    const Bond& bond = model_.bonds()[at(b)];
    reaction.known = true;
    const bool is_couple = known_.shape(b, run) == Bond::Kind::couple;
    const auto times = [&](const Exact& power) {
        const ScalarHandle number = board_.number(size * power);
        return is_couple ? as_force(number) : board_.scale<Plane::force>(number, reaction.action->direction);
    };
    const Exact power = largest ? power_of_ten_reaching(board_, *largest, times) : Exact(1);
    if (is_couple) {
        reaction.couple = board_.number(size * power);
        return;
    }
    reaction.force = times(power);
    if (bond.kind != Bond::Kind::guide) return;
    const ScalarHandle turning = board_.moment(board_.vector(bond.place, reaction.action->place), *reaction.force);
    if (!board_.is_zero(turning)) reaction.couple = turning;
}

std::array<ScalarHandle, 3> Trials::gaps(MemberIndex member, const std::vector<Load>& loads, const Run& run) {
    return model_.gap(member, loads, run, origin_);
}

}  // namespace kinegraph::statics
