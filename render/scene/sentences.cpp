// Sentences, by kind.
#include "render/scene/sentences.hpp"

#include <algorithm>

#include "engine/pair.hpp"

namespace kinegraph::render {

bool names_a_pair(Sentence sentence) {
    return std::any_of(plane_pairs.begin(), plane_pairs.end(), [&](const PlanePair& pair) { return pair.primary == sentence; });
}

bool told_by_list(Sentence sentence) {
    return names_a_pair(sentence) || sentence == Sentence::kennedy || sentence == Sentence::kennedy_line ||
           sentence == Sentence::kennedy_two_normals;
}

bool is_incidental(Sentence sentence) {
    switch (sentence) {
        case Sentence::image_velocity:
        case Sentence::image_acceleration:
        case Sentence::image_acceleration_without_omega:
        case Sentence::translating_velocity:
        case Sentence::translating_acceleration:
        case Sentence::omega_by_sleeve:
        case Sentence::alpha_by_sleeve:
        case Sentence::omega_by_joint:
        case Sentence::alpha_by_joint:
        case Sentence::omega_by_fixed_guide:
        case Sentence::alpha_by_fixed_guide:
        case Sentence::omega_by_driver:
        case Sentence::alpha_by_driver:
        case Sentence::slide_velocity_on_rest:
        case Sentence::slide_acceleration_on_rest:
        case Sentence::kennedy_same:
        case Sentence::centre_by_rigidity:
        case Sentence::centre_from_velocities:
        case Sentence::second_way:
        case Sentence::known_resultant:  // the sentence that needs it says so, and it is drawn
            return true;
        default:
            return false;
    }
}

}  // namespace kinegraph::render
