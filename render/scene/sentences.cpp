// Classes of sentences: see sentences.hpp.
#include "render/scene/sentences.hpp"
#include "lang/keys/sentences.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <variant>

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

std::optional<Topic> follows(Key sentence) {
    using namespace lang::sentences;
    static constexpr std::array after_velocities{centre_from_velocities, centre_from_omega, centre_beside_translation,
                                                 centre_by_ratio};
    if (is_among(sentence, after_velocities)) return Topic::velocity;
    if (sentence == centre_from_accelerations) return Topic::acceleration;
    return std::nullopt;
}

namespace {

/// A sentence about one subject and that about several. What the places `listed` hold differs, and is listed; what is
/// behind the last place of `kept` is left out; all else is the same.
struct SeveralSubjects {
    Key one, several;
    std::vector<std::size_t> listed;
    std::size_t kept = std::numeric_limits<std::size_t>::max();

    bool lists(std::size_t place) const { return std::find(listed.begin(), listed.end(), place) != listed.end(); }
};

const SeveralSubjects* several_subjects_of(Key sentence) {
    using namespace lang::sentences;
    static const std::array all{
        SeveralSubjects{crank_velocity, lang::sentences::crank_velocities, {2, 3}},
        SeveralSubjects{crank_acceleration, lang::sentences::crank_accelerations, {2, 3}},
        SeveralSubjects{image_velocity, lang::sentences::image_velocities, {0, 2}},
        SeveralSubjects{image_acceleration, lang::sentences::image_accelerations, {0, 2}},
        SeveralSubjects{image_acceleration_without_omega, lang::sentences::image_accelerations_without_omega, {0, 2}},
        SeveralSubjects{translating_velocity, lang::sentences::translating_velocities, {1, 2}},
        SeveralSubjects{translating_acceleration, lang::sentences::translating_accelerations, {1, 2}},
        SeveralSubjects{centre_from_velocities, lang::sentences::centres_from_velocities, {0}, 1},
        SeveralSubjects{centre_by_ratio, lang::sentences::centres_by_ratio, {0}, 1},
        SeveralSubjects{centre_from_accelerations, lang::sentences::centres_from_accelerations, {0}, 1}};
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.one == sentence; });
    return found == all.end() ? nullptr : &*found;
}

bool are_same(const Argument& first, const Argument& second) {
    if (const auto* point = std::get_if<PointName>(&first))
        return std::holds_alternative<PointName>(second) && std::get<PointName>(second).name == point->name;
    if (const auto* body = std::get_if<BodyName>(&first))
        return std::holds_alternative<BodyName>(second) && std::get<BodyName>(second).name == body->name;
    if (const auto* symbol = std::get_if<Symbol>(&first))
        return std::holds_alternative<Symbol>(second) && std::get<Symbol>(second) == *symbol;
    const auto* text = std::get_if<std::string>(&first);
    return text != nullptr && std::holds_alternative<std::string>(second) && std::get<std::string>(second) == *text;
}

/// The list of what one place holds in each message.
Argument list_of(const std::vector<const Message*>& messages, std::size_t place) {
    Names names;
    Symbols symbols;
    for (const Message* message : messages)
        if (const auto* symbol = std::get_if<Symbol>(&message->arguments[place]))
            symbols.push_back(*symbol);
        else
            names.push_back(std::get<PointName>(message->arguments[place]).name);
    if (names.empty()) return symbols;
    return names;
}

}  // namespace

bool may_be_told_together(const Message& first, const Message& second) {
    const SeveralSubjects* const form = several_subjects_of(first.sentence);
    if (form == nullptr || second.sentence != first.sentence || second.arguments.size() != first.arguments.size())
        return false;
    for (std::size_t place = 0; place < std::min(form->kept, first.arguments.size()); ++place) {
        const Argument &one = first.arguments[place], &other = second.arguments[place];
        if (form->lists(place) ? one.index() != other.index() : !are_same(one, other)) return false;
    }
    return true;
}

Message told_together(const std::vector<const Message*>& messages) {
    const SeveralSubjects* const form = several_subjects_of(messages.front()->sentence);
    KG_ASSERT(form != nullptr && messages.size() > 1, "sentences that are told together");
    Message all{form->several, {}};
    for (std::size_t place = 0; place < std::min(form->kept, messages.front()->arguments.size()); ++place)
        all.arguments.push_back(form->lists(place) ? list_of(messages, place) : messages.front()->arguments[place]);
    for (const Message* message : messages)
        all.worked_arithmetic.insert(all.worked_arithmetic.end(), message->worked_arithmetic.begin(),
                                     message->worked_arithmetic.end());
    return all;
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
        kennedy_same,         centre_by_rigidity,       second_way,
        known_resultant};  // drawn, and stated by the sentence that needs it
    return is_among(sentence, carrying) || follows(sentence);
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
