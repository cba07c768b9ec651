// The forms of a file as tables, and the schema that is written from them. That the schema allows what the reader reads
// is tested on spoilt files (gate_test.cpp); here, that the tables are whole and that the patterns of the schema, which
// that test leaves out, know every unit.
#include <gtest/gtest.h>

#include <kinegraph/mechanism.hpp>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "engine/mechanism/mechanism.hpp"
#include "engine/reading/forms.hpp"

namespace kinegraph::forms_test {
namespace {

/// Every form that the value leads to, each once.
void collect(const FormValue& value, std::set<const Form*>& forms);
void collect(const Form& form, std::set<const Form*>& forms) {
    if (!forms.insert(&form).second) return;
    for (const FormRow& row : form.rows) collect(row.value, forms);
}
void collect(const FormValue& value, std::set<const Form*>& forms) {
    if (value.form != nullptr) collect(*value.form, forms);
    if (value.of != nullptr) collect(*value.of, forms);
    for (const FormValue& choice : value.choices) collect(choice, forms);
}
std::set<const Form*> all_forms() {
    std::set<const Form*> forms;
    collect(forms::mechanism(), forms);
    EXPECT_GT(forms.size(), 40U);
    return forms;
}

TEST(Forms, NameEachKeyOnce) {
    for (const Form* form : all_forms()) {
        std::set<std::string_view> keys;
        for (const FormRow& row : form->rows) EXPECT_TRUE(keys.insert(row.key).second) << row.key;
        for (const std::string_view other : form->others) EXPECT_TRUE(keys.insert(other).second) << other;
        EXPECT_FALSE(keys.empty());
    }
}

TEST(Forms, ChooseAmongTheirOwnKeys) {
    int choices = 0;
    for (const Form* form : all_forms())
        for (const Form::Choice& choice : form->choices) {
            ++choices;
            for (const std::string_view key : choice.keys)
                EXPECT_TRUE(key.empty() || form->row(key) != nullptr) << key << " in " << choice.says;
        }
    EXPECT_GT(choices, 5);
}

TEST(Forms, AreNamedInEveryLanguage) {
    for (const PlanePair& pair : plane_pairs) {
        const auto read = read_mechanism(R"({"kinegraph": 1, "points": {"O": [0, 0]}, "bodies": {}, "joints": [{")" +
                                             std::string(pair.key) + R"(": "O", "colour": "red"}]})",
                                         "file.json");
        ASSERT_FALSE(read.has_value());
        const auto unknown = std::find_if(read.error().begin(), read.error().end(),
                                          [](const Error& each) { return each.where == "/joints/0/colour"; });
        ASSERT_NE(unknown, read.error().end()) << pair.key;
        for (const Language language : languages) {
            const std::string message = unknown->message.in(language);
            EXPECT_EQ(message.find_first_of("{}"), std::string::npos) << message;
            EXPECT_NE(message.find(quoted(pair.key)), std::string::npos) << message;
        }
    }
}

/// The patterns of the schema's quantities, by the definition's name.
std::map<std::string, std::regex> patterns() {
    std::map<std::string, std::regex> patterns;
    const auto schema = nlohmann::json::parse(mechanism_schema());
    for (const auto& each : schema.at("definitions").items())
        if (each.value().contains("pattern") && each.key() != "name" && each.key() != "number")
            patterns.emplace(each.key(), each.value().at("pattern").get<std::string>());
    return patterns;
}

TEST(Forms, KnowEveryUnitInTheSchema) {
    const auto known = patterns();
    ASSERT_GE(known.size(), 15U);
    std::set<QuantityKind> kinds;
    for (const KnownUnit& unit : known_units()) {
        const std::string text = "-1.5e3 " + std::string(unit.symbol);
        std::vector<std::string> matching;
        for (const auto& [name, pattern] : known)
            if (std::regex_search(text, pattern)) matching.push_back(name);
        // No key of a file is a power.
        EXPECT_EQ(matching.size(), unit.kind == QuantityKind::power ? 0U : 1U) << text;
        if (matching.size() == 1) kinds.insert(unit.kind);
    }
    EXPECT_EQ(kinds.size(), known.size()) << "each quantity of the schema is one kind";
}

TEST(Forms, KnowOtherSpellingsOfUnits) {
    const auto known = patterns();
    const std::vector<std::pair<const char*, const char*>> spellings{
        {"angle", "30°"},    {"angularVelocity", "5°/s"},          {"acceleration", "9.81 m/s^2"},
        {"moment", "3 N*m"}, {"momentOfInertia", "2kg m^2"},       {"length", "= 2*r"},
        {"time", "=t"},      {"coefficientOfWear", "1 mm³/(N m)"},
    };
    for (const auto& [name, text] : spellings) {
        ASSERT_TRUE(known.contains(name)) << name;
        EXPECT_TRUE(std::regex_search(text, known.at(name))) << text;
    }
    for (const char* text : {"30", "m", "1 m m", "1 kg", " "})
        EXPECT_FALSE(std::regex_search(text, known.at("length"))) << text;
}

}  // namespace
}  // namespace kinegraph::forms_test
