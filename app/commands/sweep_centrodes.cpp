#include "app/commands/sweep_centrodes.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "app/commands/row_file.hpp"
#include "engine/file/spelling.hpp"
#include "engine/sentences/centre_symbol.hpp"

namespace kinegraph::app {
namespace {

std::string number(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value == 0 ? 0.0 : value);
    return {digits.data(), end.ptr};
}
std::string list(const std::vector<double>& values) {
    std::string text = "[";
    for (const double each : values) text += (text.size() > 1 ? ", " : "") + number(each);
    return text + "]";
}
std::string list(const std::vector<Centrodes::Spot>& places) {
    std::string text = "[";
    for (const auto& each : places)
        text += std::string(text.size() > 1 ? ", " : "") + "[" + number(each.x) + ", " + number(each.y) + "]";
    return text + "]";
}
std::string trimmed(std::string text) {
    while (text.ends_with(' ')) text.pop_back();
    while (text.starts_with(' ')) text.erase(0, 1);
    return text;
}

}  // namespace

tl::expected<std::vector<std::pair<BodyIndex, BodyIndex>>, Words> centrode_pairs_of(
    const std::vector<std::string>& asked, const Mechanism& mechanism) {
    std::vector<std::string> names;
    for (const Body& body : mechanism.bodies) names.push_back(body.name);
    std::vector<std::pair<BodyIndex, BodyIndex>> pairs;
    for (const std::string& text : asked) {
        const std::size_t comma = text.find(',');
        if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos)
            return tl::unexpected(Words("--centrodes {0} is no pair of bodies; give two as \"1,3\"",
                                        "--centrodes {0} non è una coppia di corpi; darne due come \"1,3\"",
                                        quoted(text)));
        std::array<BodyIndex, 2> bodies{none, none};
        const std::array parts{trimmed(text.substr(0, comma)), trimmed(text.substr(comma + 1))};
        for (std::size_t i = 0; i < 2; ++i) {
            const auto body = mechanism.body_named(parts[i]);
            Speller speller;
            if (!body)
                return tl::unexpected(Words("--centrodes: no body is named {0}{1}",
                                            "--centrodes: nessun corpo si chiama {0}{1}", quoted(parts[i]),
                                            did_you_mean(speller.nearest(parts[i], names))));
            bodies[i] = *body;
        }
        if (bodies[0] == bodies[1])
            return tl::unexpected(Words("--centrodes {0}: a body has no motion against itself; give two bodies",
                                        "--centrodes {0}: un corpo non si muove rispetto a se stesso; dare due corpi",
                                        quoted(text)));
        pairs.emplace_back(bodies[0], bodies[1]);
    }
    return pairs;
}

std::string json_of(const std::vector<Centrodes>& centrodes, const Mechanism& mechanism) {
    std::string text = "[";
    for (const Centrodes& each : centrodes) {
        text += std::string(text.size() > 1 ? "," : "") + "\n    {\"bodies\": [" +
                in_json(mechanism.body(each.first).name) + ", " + in_json(mechanism.body(each.second).name) +
                "], \"to infinity\": " + list(each.infinities) + ", \"branches\": [";
        for (std::size_t i = 0; i < each.branches.size(); ++i) {
            const Centrodes::Branch& branch = each.branches[i];
            text += std::string(i > 0 ? "," : "") + "\n      {\"turn\": " + list(branch.coordinates) +
                    ",\n       \"fixed\": " + list(branch.fixed) + ",\n       \"moving\": " + list(branch.moving) +
                    ",\n       \"from infinity\": " + (branch.comes_from_infinity ? "true" : "false") +
                    ", \"to infinity\": " + (branch.goes_to_infinity ? "true" : "false") + "}";
        }
        text += "]}";
    }
    return text + "\n  ]";
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
