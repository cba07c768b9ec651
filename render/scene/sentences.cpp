// Classes of sentences: see sentences.hpp.
#include "render/scene/sentences.hpp"

#include <algorithm>

namespace kinegraph::render {

bool names_a_pair(Sentence sentence) {
    switch (sentence) {
        case Sentence::primary_revolute:
        case Sentence::primary_prismatic:
        case Sentence::primary_rolling:
        case Sentence::primary_gear:
        case Sentence::primary_weld: return true;
        default: return false;
    }
}

bool told_by_list(Sentence sentence) {
    return names_a_pair(sentence) || sentence == Sentence::kennedy || sentence == Sentence::kennedy_line ||
           sentence == Sentence::kennedy_two_normals;
}

namespace {

bool carries_on(Sentence sentence) {
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
        case Sentence::known_resultant:  // drawn, and stated by the sentence that needs it
            return true;
        default: return false;
    }
}

/// Whether another sentence mentions the resultant that this one adds up.
bool is_spoken_of(const std::vector<Statement>& statements, std::size_t which) {
    if (statements[which].message.sentence != Sentence::known_resultant) return false;
    const Symbol& sum = std::get<Symbol>(statements[which].message.arguments[2]);
    return std::any_of(statements.begin(), statements.end(), [&](const Statement& other) {
        return &other != &statements[which] && other.message.sentence != Sentence::known_resultant &&
               std::any_of(other.message.arguments.begin(), other.message.arguments.end(),
                           [&](const Argument& argument) {
                               const auto* symbol = std::get_if<Symbol>(&argument);
                               const auto* symbols = std::get_if<Symbols>(&argument);
                               return (symbol != nullptr && *symbol == sum) ||
                                      (symbols != nullptr &&
                                       std::find(symbols->begin(), symbols->end(), sum) != symbols->end());
                           });
    });
}

/// Whether it determines a term that another sentence's equation marks as known (✓).
bool leads_to_known_term(const std::vector<Statement>& statements, std::size_t which) {
    const auto speaks_of = [&](const Symbol& term) {
        const std::vector<Argument>& arguments = statements[which].message.arguments;
        return std::any_of(arguments.begin(), arguments.end(), [&](const Argument& argument) {
            const auto* symbol = std::get_if<Symbol>(&argument);
            return symbol != nullptr && *symbol == term;
        });
    };
    return std::any_of(statements.begin(), statements.end(), [&](const Statement& other) {
        if (!other.equation) return false;
        for (const std::vector<Term>& side : other.equation->sides)
            for (const Term& term : side)
                if (term.magnitude_known && speaks_of(term.symbol)) return true;
        return false;
    });
}

}  // namespace

bool is_incidental(const std::vector<Statement>& statements, std::size_t which) {
    return carries_on(statements[which].message.sentence) && !is_spoken_of(statements, which) &&
           !leads_to_known_term(statements, which);
}

}  // namespace kinegraph::render
