// Loops are chosen from the graph of the pairs. Each pair gives the vectors between its bodies: none at a hinge, a
// slide along a guide and its perpendicular offset, the link that replaces a curved slot or two round profiles. Then
// letters are assigned, rows derived, and everything is evaluated in Exact with the letters' values, which are accurate
// to 2^-bits of the pose.
#include "engine/equations/equations.hpp"

#include <variant>

#include "engine/equations/choice_of_loops.hpp"
#include "engine/equations/equations_values.hpp"
#include "engine/equations/laws.hpp"
#include "engine/equations/letters.hpp"
#include "engine/equations/open_chains.hpp"
#include "engine/mechanism/problem.hpp"
#include "lang/keys/positions.hpp"

namespace kinegraph {
namespace vector_loops {
namespace {

/// Rates of the drivers by letter.
std::vector<std::pair<Exact, Exact>> rates(const VectorGraph& graph, const Laws& laws, const Mechanism& mechanism,
                                           std::size_t letters) {
    std::vector<std::pair<Exact, Exact>> all(letters);
    const auto set = [&](LetterIndex letter, int driver, int sense) {
        if (letter < 0 || driver < 0) return;
        std::visit(
            [&](const auto& given) {
                if constexpr (requires { given.omega; })
                    all[at_index(letter)] = {given.omega, given.alpha};
                else
                    all[at_index(letter)] = {Exact(sense) * given.speed, Exact(sense) * given.acceleration};
            },
            mechanism.drivers[at_index(driver)]);
    };
    for (const TurningClass& each : graph.classes)
        if (each.driver >= 0 && !each.letters.empty()) set(each.letters.back(), each.driver, 1);
    for (const Edge& edge : graph.edges) set(edge.slide, edge.driver, edge.sense);
    for (const auto& [letter, driver] : laws.apart()) set(letter, driver, 1);
    return all;
}

Equations refused(Words why) {
    Equations none;
    none.why_not = std::move(why);
    return none;
}

Equations written(const Mechanism& mechanism, const Pose& pose) {
    const AsDrawn drawn(mechanism, pose);
    VectorGraph graph = PairsAsEdges(drawn).graph();
    Equations found;
    found.why_not = std::move(graph.why_not);
    found.by_tangent = std::move(graph.by_tangent);
    if (!found.why_not.empty()) return found;
    Letters letters(drawn, graph, found);
    ChoiceOfLoops(drawn, graph, letters, found).choose_loops();
    for (Edge& edge : graph.edges) letters.give_letters(edge);
    OpenChains chains(drawn, graph, letters, found);
    chains.write_reaches();
    letters.name_what_is_left();
    Laws laws(drawn, graph, letters, found);
    laws.write_laws();
    letters.settle_names();
    complete(found, mechanism, pose, rates(graph, laws, mechanism, found.letters.size()));
    chains.find_motions();
    return found;
}

}  // namespace
}  // namespace vector_loops

Equations equations_of(const Mechanism& mechanism, const Pose& pose) {
    if (stands_for_joints(mechanism)) return vector_loops::refused({lang::positions::a_problem_in_place_of_joints});
    if (mechanism.joints.empty() || mechanism.motion)
        return vector_loops::refused({lang::positions::there_are_no_joints});
    return vector_loops::written(mechanism, pose);
}

std::optional<std::array<double, 2>> Equations::BodyState::velocity_of(const Vector& place) const {
    if (!velocity || !omega) return std::nullopt;
    const double x = (place.x - reference.x).to_double(), y = (place.y - reference.y).to_double();
    return std::array<double, 2>{(*velocity)[0] - *omega * y, (*velocity)[1] + *omega * x};
}
std::optional<std::array<double, 2>> Equations::BodyState::acceleration_of(const Vector& place) const {
    if (!acceleration || !omega || !alpha) return std::nullopt;
    const double x = (place.x - reference.x).to_double(), y = (place.y - reference.y).to_double(), w2 = *omega * *omega;
    return std::array<double, 2>{(*acceleration)[0] - *alpha * y - w2 * x, (*acceleration)[1] + *alpha * x - w2 * y};
}

std::string spelt(const Equations::Letter& letter) {
    return letter.sub.empty() ? letter.symbol : letter.symbol + "_" + letter.sub;
}

namespace {

std::string spelt(const Equations& equations, const Equations::Side& side) {
    constexpr std::array<const char*, 4> turned{"", "i ", "- ", "-i "};
    std::string text = turned.at(static_cast<std::size_t>(side.angle.quarters)) + spelt(equations.letter(side.length));
    std::string angle;
    for (const Equations::LetterIndex letter : side.angle.letters)
        angle += (angle.empty() ? "" : " + ") + spelt(equations.letter(letter));
    if (angle.empty()) return text;
    return text + " e^{i " + (side.angle.letters.size() > 1 ? "(" + angle + ")" : angle) + "}";
}

}  // namespace

std::string spelt(const Equations& equations, const Equations::Loop& loop) {
    std::array<std::string, 2> text;
    for (const Equations::Side& side : loop.sides) {
        std::string& own = text.at(side.on_the_right ? 1 : 0);
        const std::string term = spelt(equations, side);
        if (own.empty())
            own = term.starts_with("- ") ? "-" + term.substr(2) : term;
        else if (term.starts_with('-'))
            own += " - " + term.substr(term[1] == ' ' ? 2 : 1);
        else
            own += " + " + term;
    }
    for (std::string& own : text)
        if (own.empty()) own = "0";
    return text[0] + " = " + text[1];
}

std::string spelt(const Equations& equations, const Equations::Law& law) {
    std::string text;
    for (const Equations::Law::Part& part : law.parts) {
        std::string sum;
        for (const auto& [sign, letter] : part.sum)
            sum += (sum.empty() ? (sign < 0 ? "-" : "") : sign < 0 ? " - " : " + ") + spelt(equations.letter(letter));
        text += text.empty() ? (part.sign < 0 ? "-" : "") : part.sign < 0 ? " - " : " + ";
        if (part.radius >= 0) text += spelt(equations.letter(part.radius)) + " ";
        text += part.sum.size() > 1 ? "(" + sum + ")" : sum;
    }
    return text + " = const";
}

}  // namespace kinegraph
