// Sentences, by kind.
#include "render/tables/sentences.hpp"

namespace kinegraph::render {

bool names_a_pair(Sentence sentence) {
    switch (sentence) {
        case Sentence::primary_revolute:
        case Sentence::primary_prismatic:
        case Sentence::primary_rolling:
        case Sentence::primary_gear:
        case Sentence::primary_weld:
            return true;
        default:
            return false;
    }
}

bool told_by_list(Sentence sentence) {
    return names_a_pair(sentence) || sentence == Sentence::kennedy || sentence == Sentence::kennedy_line ||
           sentence == Sentence::kennedy_two_normals;
}

}  // namespace kinegraph::render
