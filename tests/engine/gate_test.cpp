// The reader against the published schema: what the reader reads, the schema allows, on every example spoilt at random
// in many ways. So the program need not ask the schema at every start, and an editor that checks files by it is never
// told otherwise.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/mechanism/mechanism.hpp"
#include "tests/support/files.hpp"
#include "tests/support/random_mechanism.hpp"
#include "tests/support/schema_gate.hpp"

namespace gate_test {
namespace {

using namespace kinegraph;
using Json = nlohmann::ordered_json;

template <class Items>
const auto& any_of(const Items& items, Random& random) {
    return items[static_cast<std::size_t>(random.whole(0, static_cast<int>(items.size()) - 1))];
}
auto any_member(Json& object, Random& random) {
    return std::next(object.begin(), random.whole(0, static_cast<int>(object.size()) - 1));
}

/// Spoils files with pieces of themselves and of each other.
class Spoiler {
public:
    explicit Spoiler(std::uint64_t seed) : random_(seed) {
        for (const std::string& name : tests::example_names())
            files_.push_back(Json::parse(tests::contents(tests::example_file(name))));
        std::sort(files_.begin(), files_.end());
        for (const Json& file : files_) collect(file);
    }

    std::string next() {
        Json file = any_of(files_, random_);
        for (int times = random_.whole(1, 3); times > 0; --times) {
            std::vector<Json*> values;
            list(file, values);
            spoil(*any_of(values, random_));
        }
        return file.dump();
    }

private:
    void collect(const Json& value) {
        pieces_.push_back(value);
        if (value.is_object())
            for (const auto& member : value.items()) keys_.push_back(member.key());
        if (value.is_structured())
            for (const Json& inner : value) collect(inner);
    }
    static void list(Json& value, std::vector<Json*>& values) {
        values.push_back(&value);
        if (value.is_structured())
            for (Json& inner : value) list(inner, values);
    }
    Json strange() {
        static const std::vector<Json> values{nullptr,
                                              true,
                                              false,
                                              0,
                                              -1,
                                              1.5,
                                              -0.5,
                                              2.0,
                                              1e30,
                                              "",
                                              Json::array(),
                                              "1 m",
                                              "30 °",
                                              "near A",
                                              "A",
                                              Json::object(),
                                              Json::array({0, 1})};
        return random_.chance(50) ? any_of(values, random_) : any_of(pieces_, random_);
    }
    void spoil(Json& value) {
        const bool members = value.is_object() && !value.empty(), elements = value.is_array() && !value.empty();
        switch (random_.whole(1, 6)) {
            case 1: value = strange(); break;
            case 2:
                if (members) value.erase(any_member(value, random_));
                if (elements) value.erase(value.begin());
                break;
            case 3:
                if (value.is_object()) value[any_of(keys_, random_)] = strange();
                if (value.is_array()) value.push_back(strange());
                break;
            case 4:
                if (members) {
                    const auto renamed = any_member(value, random_);
                    const Json kept = renamed.value();
                    value.erase(renamed);
                    value[any_of(keys_, random_)] = kept;
                }
                break;
            case 5:
                if (value.is_number())
                    value = random_.chance(50) ? Json(-value.get<double>()) : Json(value.dump() + " m");
                break;
            default:
                if (value.is_string()) value = value.get<std::string>() + ' ';
                if (elements) std::swap(value.front(), value.back());
        }
    }

    Random random_;
    std::vector<Json> files_, pieces_;
    std::vector<std::string> keys_;
};

/// A small mechanism with one member more.
std::string with(const std::string& more) {
    return R"({"kinegraph": 1, "points": {"O": [0, 0], "A": [1, 0]}, "bodies": {"2": ["O", "A"]},
               "joints": [{"revolute": "O", "bodies": [0, 2]}])" +
           (more.empty() ? "" : ", " + more) + "}";
}

TEST(Gate, AllowsWhatTheReaderReads) {
    Spoiler spoiler(1);
    int read = 0, refused = 0;
    for (int file = 0; file < unless_sanitized(10000, 1500); ++file) {
        const std::string text = spoiler.next();
        const Errors errors = refused_by_schema(text);
        refused += errors.empty() ? 0 : 1;
        if (!read_mechanism(text, "spoilt.json")) continue;
        ++read;
        ASSERT_TRUE(errors.empty()) << errors.front().where << ": " << errors.front().message.in(Language::en) << '\n'
                                    << text;
    }
    // Both happen often, or nothing has been compared.
    EXPECT_GT(read, unless_sanitized(1500, 200));
    EXPECT_GT(refused, unless_sanitized(1500, 200));
}

TEST(Gate, LetsPassWhatIsInOrder) { EXPECT_TRUE(refused_by_schema(with("")).empty()); }

TEST(Gate, RefusesWithAPointer) {
    const Errors errors = refused_by_schema(with(R"("gravity": [0, -9.81, 3])"));
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_EQ(errors[0].where, "/gravity");
}

TEST(Gate, KnowsTheFormsOfTheFormat) {
    for (const char* more : {R"("spede": 1)", R"("drivers": {})", R"("frame": 1.5)", R"("scales": {"plot": "1:2"})",
                             R"("find": ["beauty"])", R"("motion": {"body": 1, "velocities": {}})",
                             R"("loads": [{"couple": "C", "body": 2}])"}) {
        EXPECT_FALSE(refused_by_schema(with(more)).empty()) << more;
    }
}

}  // namespace
}  // namespace gate_test
