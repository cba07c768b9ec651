#include "app/library/sweep_centrodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/file/spelling.hpp"
#include "engine/sentences/centre_symbol.hpp"
#include "lang/keys/sweeps.hpp"

namespace kinegraph::app {
namespace {

std::string trimmed(std::string text) {
    while (text.ends_with(' ')) text.pop_back();
    while (text.starts_with(' ')) text.erase(0, 1);
    return text;
}

}  // namespace

tl::expected<std::vector<std::pair<BodyIndex, BodyIndex>>, Words> centrode_pairs_of(
    const std::vector<std::string>& asked, const Mechanism& mechanism, const std::string& dashes) {
    std::vector<std::string> names;
    for (const Body& body : mechanism.bodies) names.push_back(body.name);
    std::vector<std::pair<BodyIndex, BodyIndex>> pairs;
    for (const std::string& text : asked) {
        const std::size_t comma = text.find(',');
        if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos)
            return tl::unexpected(Words(lang::sweeps::centrodes_is_no_pair_of_bodies, quoted(text), dashes));
        std::array<BodyIndex, 2> bodies{none, none};
        const std::array parts{trimmed(text.substr(0, comma)), trimmed(text.substr(comma + 1))};
        for (std::size_t i = 0; i < 2; ++i) {
            const auto body = mechanism.body_named(parts[i]);
            Speller speller;
            if (!body)
                return tl::unexpected(Words(lang::sweeps::centrodes_no_body_is_named, quoted(parts[i]),
                                            did_you_mean(speller.nearest(parts[i], names)), dashes));
            bodies[i] = *body;
        }
        if (bodies[0] == bodies[1])
            return tl::unexpected(Words(lang::sweeps::centrodes_a_body_has_no_motion, quoted(text), dashes));
        pairs.emplace_back(bodies[0], bodies[1]);
    }
    return pairs;
}

void write_centrodes(const std::vector<Centrodes>& centrodes, const Mechanism& mechanism, JsonWriter& json) {
    constexpr int branch_line = 6, curve_line = 7;
    json.key("centrodes").open('[', JsonWriter::Entries::on_lines);
    for (const Centrodes& each : centrodes) {
        json.open('{').key("bodies").open('[');
        json.value(mechanism.body(each.first).name).value(mechanism.body(each.second).name).close();
        json.member("to infinity", each.infinities).key("branches").open('[');
        for (const Centrodes::Branch& branch : each.branches) {
            json.on_line(branch_line).open('{').member("turn", branch.coordinates);
            json.on_line(curve_line).member("fixed", branch.fixed);
            json.on_line(curve_line).member("moving", branch.moving);
            json.on_line(curve_line).member("from infinity", branch.comes_from_infinity);
            json.member("to infinity", branch.goes_to_infinity).close();
        }
        json.close().close();
    }
    json.close();
}

void add_ways(const Centrodes& centrodes, const Mechanism& mechanism, std::vector<render::Way>& ways) {
    using Kind = render::Way::Kind;
    const std::string name = mechanism.body(centrodes.first).name + "," + mechanism.body(centrodes.second).name;
    // The sample nearest to coordinate zero, the position of the file.
    double nearest = 1e300;
    render::Way pole{centre_symbol(mechanism, centrodes.first, centrodes.second, false).about, false, {}, Kind::pole};
    for (const Centrodes::Branch& branch : centrodes.branches) {
        ways.push_back(
            {name, false, branch.fixed, Kind::fixed_centrode, branch.comes_from_infinity, branch.goes_to_infinity});
        ways.push_back(
            {name, false, branch.moving, Kind::moving_centrode, branch.comes_from_infinity, branch.goes_to_infinity});
        for (std::size_t i = 0; i < branch.coordinates.size(); ++i) {
            if (!(std::abs(branch.coordinates[i]) < nearest)) continue;
            nearest = std::abs(branch.coordinates[i]);
            pole.places = {branch.fixed[i]};
        }
    }
    constexpr double as_drawn = 1e-9;
    if (nearest < as_drawn) ways.push_back(std::move(pole));
}

}  // namespace kinegraph::app
