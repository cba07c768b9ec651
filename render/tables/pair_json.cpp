// Pairs as JSON: one line per pair, body or scheme.
#include <array>
#include <map>
#include <sstream>

#include "engine/file/json_text.hpp"
#include "engine/mechanism/chain.hpp"
#include "engine/mechanism/pair_catalogue.hpp"
#include "render/tables/pair_tables.hpp"

namespace kinegraph::render {
namespace {

using Members = std::vector<std::pair<std::string, std::string>>;

std::string array_of(const std::vector<std::string>& values) {
    std::string json;
    for (const std::string& each : values) json += (json.empty() ? "[" : ", ") + each;
    return json.empty() ? "[]" : json + "]";
}
std::string object_of(const Members& members) {
    std::string json;
    for (const auto& [key, value] : members) json += (json.empty() ? "{" : ", ") + json_text(key) + ": " + value;
    return json.empty() ? "{}" : json + "}";
}
/// One entry per line.
std::string lines_of(const std::vector<std::string>& values) {
    std::string json;
    for (const std::string& each : values) json += (json.empty() ? "[\n    " : ",\n    ") + each;
    return json.empty() ? "[]" : json + "\n  ]";
}
std::string file_of(const Members& members) {
    std::string json = "{";
    for (const auto& [key, value] : members)
        json += (json.size() > 1 ? ",\n  " : "\n  ") + json_text(key) + ": " + value;
    return json + "\n}\n";
}
/// Words separated by spaces and commas.
std::string words_of(std::string_view text) {
    std::vector<std::string> words;
    std::string part;
    std::istringstream parts{std::string(text)};
    while (std::getline(parts, part, ',')) {
        while (part.starts_with(' ')) part.erase(0, 1);
        if (part.find('=') != std::string::npos) {
            words.push_back(json_text(part));
            continue;
        }
        std::istringstream single(part);
        for (std::string word; single >> word;) words.push_back(json_text(word));
    }
    return array_of(words);
}
std::string scheme_json(const BinaryScheme& scheme, const std::vector<std::string>& bodies) {
    std::vector<std::string> hinges;
    for (const auto& hinge : scheme.hinges)
        hinges.push_back(array_of({json_text(bodies[static_cast<std::size_t>(hinge[0])]),
                                   json_text(bodies[static_cast<std::size_t>(hinge[1])])}));
    return array_of(hinges);
}

std::string joint_json(const Mechanism& mechanism, const Joint& joint) {
    std::vector<std::string> names, bodies;
    for (const BodyIndex body : joint.bodies) {
        names.push_back(mechanism.body(body).name);
        bodies.push_back(json_text(names.back()));
    }
    const PlanePair& pair = joint.pair();
    Members members{{"joint", json_text(joint.name)},
                    {"kind", json_text(pair.key)},
                    {"bodies", array_of(bodies)},
                    {"freedoms", std::to_string(pair.freedoms())}};
    if (pair.freedoms() > 0) members.emplace_back("class", std::to_string(pair.freedoms()));
    if (names.size() < 3) return object_of(members);
    const auto n = static_cast<int>(names.size());
    members.emplace_back("multiplicity", std::to_string(n - 1));
    constexpr int listed_bodies = 4;  // 16 schemes
    if (n <= listed_bodies) {
        std::vector<std::string> schemes;
        for (const BinaryScheme& scheme : binary_schemes(n)) schemes.push_back(scheme_json(scheme, names));
        members.emplace_back("schemes", array_of(schemes));
    }
    return object_of(members);
}

const char* name_of(KinematicChain::Kind kind) {
    return kind == KinematicChain::Kind::open ? "open" : kind == KinematicChain::Kind::closed ? "closed" : "mixed";
}

}  // namespace

std::string pair_catalogue_json() {
    std::vector<std::string> plane, space;
    for (const PlanePair& pair : plane_pairs) {
        const std::string key(pair.key);
        Members members{{"key", json_text(key)},
                        {"name", json_text(word(pair.texts.name, Language::en))},
                        {"freedoms", std::to_string(pair.freedoms())},
                        {"reactions", std::to_string(pair.reactions())}};
        if (pair.freedoms() > 0) members.emplace_back("class", std::to_string(pair.freedoms()));
        members.emplace_back("reaction", json_text(word(pair.texts.reaction, Language::en)));
        plane.push_back(object_of(members));
    }
    for (const SpacePair& pair : space_pairs)
        space.push_back(object_of({{"key", json_text(pair.key)},
                                   {"freedoms", std::to_string(pair.freedoms)},
                                   {"class", std::to_string(pair.freedoms)},
                                   {"motions", words_of(pair.motions)},
                                   {"reactions", words_of(pair.reactions)}}));
    return file_of({{"plane", lines_of(plane)}, {"space", lines_of(space)}});
}

std::string pair_report_json(const Mechanism& mechanism, const Mobility& mobility,
                             const std::vector<Message>& remarks) {
    std::vector<std::string> joints, said;
    for (const Joint& joint : mechanism.joints) joints.push_back(joint_json(mechanism, joint));
    const KinematicChain chain = chain_of(mechanism);
    Members by_body;
    std::map<int, int> counts;
    for (const BodyIndex body : indices_of(mechanism.bodies)) {
        const int pairs = chain.pairs[at_index(body)];
        by_body.emplace_back(mechanism.body(body).name, std::to_string(pairs));
        ++counts[pairs];
    }
    Members links;
    for (const auto& [pairs, count] : counts) links.emplace_back(std::to_string(pairs), std::to_string(count));
    for (const Message& remark : remarks) said.push_back(json_text(tell(remark, Language::en)));
    return file_of({{"pairs", lines_of(joints)},
                    {"chain", object_of({{"kind", json_text(name_of(chain.kind()))},
                                         {"bodies", std::to_string(chain.pairs.size())},
                                         {"binary pairs", std::to_string(chain.joints)},
                                         {"loops", std::to_string(chain.loops)}})},
                    {"bodies by pairs", object_of(links)},
                    {"pairs of body", object_of(by_body)},
                    {"count", object_of({{"bodies", std::to_string(mobility.bodies)},
                                         {"class 1", std::to_string(mobility.class_1)},
                                         {"class 2", std::to_string(mobility.class_2)},
                                         {"welds", std::to_string(mobility.welds)}})},
                    {"mobility", object_of({{"gruebler", std::to_string(mobility.gruebler)},
                                            {"effective", std::to_string(mobility.effective)},
                                            {"repeated", std::to_string(mobility.repeated())},
                                            {"verdict", json_text(kinegraph::name_of(mobility.verdict()))}})},
                    {"remarks", lines_of(said)}});
}

}  // namespace kinegraph::render
