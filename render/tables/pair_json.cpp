// Pairs as JSON: one line per pair, body or scheme.
#include <map>

#include "engine/file/json_writer.hpp"
#include "engine/mechanism/chain.hpp"
#include "engine/mechanism/pair_catalogue.hpp"
#include "render/tables/pair_tables.hpp"

namespace kinegraph::render {
namespace {

constexpr auto on_lines = JsonWriter::Entries::on_lines;

std::vector<std::string_view> all_of(const SpacePair::Components& components) {
    std::vector<std::string_view> all(components.free.begin(), components.free.end());
    all.push_back(components.tied);
    std::erase(all, "");
    return all;
}

void write_schemes(const std::vector<std::string>& bodies, JsonWriter& json) {
    json.key("schemes").open('[');
    for (const BinaryScheme& scheme : binary_schemes(static_cast<int>(bodies.size()))) {
        json.open('[');
        for (const auto& hinge : scheme.hinges)
            json.open('[')
                .value(bodies[static_cast<std::size_t>(hinge[0])])
                .value(bodies[static_cast<std::size_t>(hinge[1])])
                .close();
        json.close();
    }
    json.close();
}

void write_joint(const Mechanism& mechanism, const Joint& joint, JsonWriter& json) {
    std::vector<std::string> bodies;
    for (const BodyIndex body : joint.bodies) bodies.push_back(mechanism.body(body).name);
    const PlanePair& pair = joint.pair();
    json.open('{').member("joint", joint.name).member("kind", pair.key).member("bodies", bodies);
    json.member("freedoms", pair.freedoms());
    if (pair.freedoms() > 0) json.member("class", pair.freedoms());
    constexpr std::size_t listed_bodies = 4;  // 16 schemes
    if (bodies.size() > 2) json.member("multiplicity", bodies.size() - 1);
    if (bodies.size() > 2 && bodies.size() <= listed_bodies) write_schemes(bodies, json);
    json.close();
}

const char* name_of(KinematicChain::Kind kind) {
    return kind == KinematicChain::Kind::open ? "open" : kind == KinematicChain::Kind::closed ? "closed" : "mixed";
}

void write_chain(const Mechanism& mechanism, JsonWriter& json) {
    const KinematicChain chain = chain_of(mechanism);
    json.key("chain").open('{').member("kind", name_of(chain.kind())).member("bodies", chain.pairs.size());
    json.member("binary pairs", chain.joints).member("loops", chain.loops).close();
    std::map<int, int> counts;
    for (const int pairs : chain.pairs) ++counts[pairs];
    json.key("bodies by pairs").open('{');
    for (const auto& [pairs, count] : counts) json.member(std::to_string(pairs), count);
    json.close().key("pairs of body").open('{');
    for (const BodyIndex body : indices_of(mechanism.bodies))
        json.member(mechanism.body(body).name, chain.pairs[at_index(body)]);
    json.close();
}

}  // namespace

std::string pair_catalogue_json() {
    JsonWriter json;
    json.open('{', on_lines).key("plane").open('[', on_lines);
    for (const PlanePair& pair : plane_pairs) {
        json.open('{').member("key", pair.key).member("name", word(pair.texts.name, Language::en));
        json.member("freedoms", pair.freedoms()).member("reactions", pair.reactions());
        if (pair.freedoms() > 0) json.member("class", pair.freedoms());
        json.member("reaction", word(pair.texts.reaction, Language::en)).close();
    }
    json.close().key("space").open('[', on_lines);
    for (const SpacePair& pair : space_pairs) {
        json.open('{').member("key", pair.key).member("freedoms", pair.freedoms).member("class", pair.freedoms);
        json.member("motions", all_of(pair.motions)).member("reactions", all_of(pair.reactions)).close();
    }
    return json.close().close().take() + '\n';
}

std::string pair_report_json(const Mechanism& mechanism, const Mobility& mobility,
                             const std::vector<Message>& remarks) {
    JsonWriter json;
    json.open('{', on_lines).key("pairs").open('[', on_lines);
    for (const Joint& joint : mechanism.joints) write_joint(mechanism, joint, json);
    json.close();
    write_chain(mechanism, json);
    json.key("count").open('{').member("bodies", mobility.bodies).member("class 1", mobility.class_1);
    json.member("class 2", mobility.class_2).member("welds", mobility.welds).close();
    json.key("mobility").open('{').member("gruebler", mobility.gruebler).member("effective", mobility.effective);
    json.member("repeated", mobility.repeated()).member("verdict", kinegraph::name_of(mobility.verdict())).close();
    json.key("remarks").open('[', on_lines);
    for (const Message& remark : remarks) json.value(tell(remark, Language::en));
    return json.close().close().take() + '\n';
}

}  // namespace kinegraph::render
