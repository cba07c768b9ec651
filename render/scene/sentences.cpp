// Sentences, by kind.
#include "render/scene/sentences.hpp"

#include <algorithm>
#include <string_view>

namespace kinegraph::render {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

}  // namespace

bool names_a_pair(Sentence sentence) {
    return std::any_of(plane_pairs.begin(), plane_pairs.end(), [&](const PlanePair& pair) { return pair.primary == sentence; });
}

bool told_by_list(Sentence sentence) {
    return names_a_pair(sentence) || sentence == Sentence::kennedy || sentence == Sentence::kennedy_line ||
           sentence == Sentence::kennedy_two_normals;
}

const Symbol* turning_found(const Message& message) {
    std::size_t argument = 0;
    switch (message.sentence) {
        case Sentence::omega_from_pair:
        case Sentence::alpha_from_pair:
        case Sentence::omega_by_sleeve:
        case Sentence::alpha_by_sleeve:
        case Sentence::omega_by_joint:
        case Sentence::alpha_by_joint:
        case Sentence::omega_by_fixed_guide:
        case Sentence::alpha_by_fixed_guide:
        case Sentence::omega_by_driver:
        case Sentence::alpha_by_driver:
        case Sentence::omega_from_parallels:
        case Sentence::alpha_from_parallels:
            break;
        case Sentence::trial_closes_on_line:
        case Sentence::trial_closes_by_spin:
            argument = 2;
            break;
        default:
            return nullptr;
    }
    if (argument >= message.arguments.size()) return nullptr;
    const auto* symbol = std::get_if<Symbol>(&message.arguments[argument]);
    const bool turns = symbol && (symbol->letter == Symbol::Letter::omega || symbol->letter == Symbol::Letter::alpha);
    return turns ? symbol : nullptr;
}

bool joins_two_forces(Sentence sentence) {
    return sentence == Sentence::two_force_body || sentence == Sentence::two_force_guide ||
           sentence == Sentence::two_force_group || sentence == Sentence::two_forces_and_couple;
}

bool finds_a_meet(Sentence sentence) {
    return sentence == Sentence::three_force_line || sentence == Sentence::triangle_at || sentence == Sentence::culmann ||
           sentence == Sentence::culmann_line;
}

bool closes_a_polygon(Sentence sentence) {
    switch (sentence) {
        case Sentence::triangle:
        case Sentence::triangle_at:
        case Sentence::parallel_forces:
        case Sentence::culmann:
        case Sentence::culmann_line:
        case Sentence::force_and_couple:
        case Sentence::single_reaction:
            return true;
        default:
            return false;
    }
}

bool speaks_of(const Solution& solution, const Message& message, const FreeBody& body) {
    const auto* said = message.arguments.empty() ? nullptr : std::get_if<BodyName>(&message.arguments.front());
    if (!said) return false;
    const std::string& name =
        body.body >= 0 ? solution.mechanism.bodies[at(body.body)].name : solution.mechanism.points[at(body.pin)].name;
    if (said->name == name) return true;
    constexpr std::string_view and_then = " + ";
    for (std::string_view rest = said->name; !rest.empty();) {
        const std::size_t end = rest.find(and_then);
        if (rest.substr(0, end) == name) return true;
        if (end == std::string_view::npos) break;
        rest.remove_prefix(end + and_then.size());
    }
    return false;
}

}  // namespace kinegraph::render
