#include "engine/reading/problem_sections.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/laws.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace kinegraph {
namespace {

/// A quantity in a compound unit without a name, "2 m/s^3", "0.4 1/s", as a formula: "= 2*(1 m)/(1 s)^3". Empty for any
/// other text.
std::optional<std::string> with_unit_put_together(std::string_view text) {
    const std::size_t space = text.find(' ');
    if (space == std::string_view::npos || is_formula(text)) return std::nullopt;
    constexpr auto spelt = std::to_array<std::pair<std::string_view, std::string_view>>(
        {{"²", "^2"}, {"³", "^3"}, {"·", "*"}, {" ", "*"}});
    std::string formula = "= " + std::string(text.substr(0, space)) + "*";
    std::string_view rest = text.substr(space + 1);
    while (!rest.empty()) {
        const auto* const other =
            std::find_if(spelt.begin(), spelt.end(), [&](const auto& each) { return rest.starts_with(each.first); });
        const auto letters = static_cast<std::size_t>(
            std::find_if_not(rest.begin(), rest.end(), [](unsigned char c) { return std::isalpha(c) != 0; }) -
            rest.begin());
        if (other != spelt.end()) {
            formula += other->second;
            rest.remove_prefix(other->first.size());
        } else if (letters > 0) {
            formula += "(1 " + std::string(rest.substr(0, letters)) + ")";
            rest.remove_prefix(letters);
        } else if (std::string_view("0123456789/*^-()").find(rest.front()) != std::string_view::npos) {
            formula += rest.front();
            rest.remove_prefix(1);
        } else {
            return std::nullopt;
        }
    }
    return formula;
}

}  // namespace

void LawConstants::read(JsonValue constants) {
    if (!constants || !file_.expect(constants, Kind::object, {lang::laws::an_object_of_constants_by_name})) return;
    for (const JsonValue member : constants) {
        std::optional<Measured> value;
        if (!is_parameter_name(member.key()) || member.key() == "t" || member.key() == "x" ||
            elementary_called(member.key()))
            file_.fault(member, {lang::laws::can_be_no_constant_name, quoted(member.key())});
        else if (file_.has_parameter(member.key()))
            file_.fault(member, {lang::laws::is_a_parameter_already_rename, quoted(member.key())});
        else
            value = read_one(member);
        constants_.emplace_back(member.key(), std::move(value));
    }
}

std::optional<Measured> LawConstants::read_one(JsonValue member) {
    if (!FormReader::is_numeric(member) && !member.is_string()) {
        file_.wrong(member, {lang::laws::a_number_a_quantity_as_20});
        return std::nullopt;
    }
    const auto known = [this](std::string_view name) { return look_up(name, "t"); };
    auto value = read_measured(member.text(), known);
    if (!value && member.is_string())
        if (const auto formula = with_unit_put_together(member.text()))
            if (auto read = read_measured(*formula, known)) value = std::move(read);
    if (value && member.is_string() && !is_formula(member.text()) && value->is_bare)
        value = tl::make_unexpected(Words(lang::common::has_no_unit, quoted(member.text())));
    if (value) return *std::move(value);
    if (!value.error().empty()) file_.fault(member, std::move(value.error()));
    return std::nullopt;
}

tl::expected<Measured, Words> LawConstants::look_up(std::string_view name, std::string_view variable) {
    const auto found =
        std::find_if(constants_.begin(), constants_.end(), [&](const auto& each) { return each.first == name; });
    if (found != constants_.end()) {
        if (!found->second) return tl::make_unexpected(Words());
        return *found->second;
    }
    if (file_.has_parameter(name)) {
        auto value = file_.look_up_parameter(name);
        if (value) file_.note(*value);
        return value;
    }
    std::vector<std::string_view> known(file_.parameter_names());
    for (const auto& each : constants_) known.push_back(each.first);
    known.push_back(variable);
    return tl::make_unexpected(
        Words(lang::laws::no_constant_is_named_give, quoted(name), did_you_mean(file_.speller().nearest(name, known))));
}

}  // namespace kinegraph
