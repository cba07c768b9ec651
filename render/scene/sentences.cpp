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

}  // namespace kinegraph::render
