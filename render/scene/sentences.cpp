// Classes of sentences: see sentences.hpp.
#include "render/scene/sentences.hpp"
#include "lang/keys/sentences.hpp"

#include <algorithm>
#include <array>

#include "engine/number/assert.hpp"
#include "lang/keys/sheet.hpp"

namespace kinegraph::render {

namespace {

template <std::size_t count>
bool is_among(const Key& sentence, const std::array<Key, count>& some) {
    return std::find(some.begin(), some.end(), sentence) != some.end();
}

}  // namespace

bool names_a_pair(Key sentence) {
    using namespace lang::sentences;
    static constexpr std::array pairs{primary_revolute, primary_prismatic, primary_rolling, primary_gear, primary_weld};
    return is_among(sentence, pairs);
}

bool told_by_list(Key sentence) {
    using namespace lang::sentences;
    static constexpr std::array of_kennedy{kennedy, kennedy_line, kennedy_two_normals};
    return names_a_pair(sentence) || is_among(sentence, of_kennedy);
}

Key steps_heading(Topic topic) {
    switch (topic) {
        case Topic::velocity: return lang::sheet::steps_velocity;
        case Topic::acceleration: return lang::sheet::steps_acceleration;
        case Topic::relative_motion: return lang::sheet::steps_relative_motion;
        case Topic::centres: return lang::sheet::steps_centres;
        case Topic::curvature: return lang::sheet::steps_curvature;
        case Topic::forces: return lang::sheet::steps_forces;
        case Topic::unnamed: break;
    }
    KG_ASSERT(false, "a sentence has a topic");
}

namespace {

bool carries_on(Key sentence) {
    using namespace lang::sentences;
    static constexpr std::array carrying{
        image_velocity,       image_acceleration,       image_acceleration_without_omega,
        translating_velocity, translating_acceleration, omega_by_sleeve,
        alpha_by_sleeve,      omega_by_joint,           alpha_by_joint,
        omega_by_fixed_guide, alpha_by_fixed_guide,     omega_by_driver,
        alpha_by_driver,      slide_velocity_on_rest,   slide_acceleration_on_rest,
        kennedy_same,         centre_by_rigidity,       centre_from_velocities,
        second_way,           known_resultant};  // drawn, and stated by the sentence that needs it
    return is_among(sentence, carrying);
}

/// Whether another sentence mentions the resultant that this one adds up.
bool is_spoken_of(const std::vector<Statement>& statements, std::size_t which) {
    if (statements[which].message.sentence != lang::sentences::known_resultant) return false;
    const Symbol& sum = std::get<Symbol>(statements[which].message.arguments[2]);
    return std::any_of(statements.begin(), statements.end(), [&](const Statement& other) {
        return &other != &statements[which] && other.message.sentence != lang::sentences::known_resultant &&
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
