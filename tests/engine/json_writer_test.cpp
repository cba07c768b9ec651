// The writer of JSON: what it writes is read back by another reader, in the layout that the documents promise.
#include "engine/file/json_writer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace kinegraph::json_writer_test {
namespace {

using Json = nlohmann::ordered_json;
constexpr auto on_lines = JsonWriter::Entries::on_lines;

/// One value of each form, and brackets within brackets.
std::string document(JsonWriter json) {
    json.open('{', on_lines)
        .member("name", "a\"\\\n<b")
        .member("places", std::vector<Vector>{{1, 2}, {0, Exact::ratio(-1, 2)}});
    json.member("yes", true).member("count", 3).member("size", std::size_t{4}).member("nothing", std::nullopt);
    json.member("known", std::optional(0.1)).member("unknown", std::optional<double>());
    json.key("lines").open('[', on_lines).value("x").open('{').member("y", 2).close().close();
    json.key("none").open('{', on_lines).close().key("exact").fraction(Exact::ratio(1, 3));
    return json.close().take();
}

TEST(JsonWriter, WritesWhatAnotherReads) {
    const Json expected{{"name", "a\"\\\n<b"},
                        {"places", {{1, 2}, {0, -0.5}}},
                        {"yes", true},
                        {"count", 3},
                        {"size", 4},
                        {"nothing", nullptr},
                        {"known", 0.1},
                        {"unknown", nullptr},
                        {"lines", {"x", {{"y", 2}}}},
                        {"none", Json::object()},
                        {"exact", "1/3"}};
    EXPECT_EQ(Json::parse(document(JsonWriter())), expected);
    const std::string script = document(JsonWriter(JsonWriter::Style::script));
    EXPECT_EQ(Json::parse(script), expected);
    EXPECT_EQ(script.find('<'), std::string::npos) << "safe in a script element";
}

TEST(JsonWriter, IndentsLinesByTheBracketsRoundThem) {
    JsonWriter json;
    json.open('{', on_lines).key("a").open('[', on_lines).value(1).open('[').value(2).value(3).close().close();
    json.key("b").open('{').member("c", 4).on_line(5).member("d", 6).close();
    EXPECT_EQ(json.close().take(), "{\n  \"a\": [\n    1,\n    [2, 3]\n  ],\n  \"b\": {\"c\": 4,\n     \"d\": 6}\n}");
}

TEST(JsonWriter, HasNumbersThatReadBack) {
    constexpr std::array numbers{0.1, 1e300, 5e-324, 1.0 / 3, 123456789.125};
    for (const double number : numbers)
        EXPECT_EQ(Json::parse(JsonWriter().value(number).take()).get<double>(), number) << number;
    EXPECT_EQ(JsonWriter().value(-0.0).take(), "0");
    EXPECT_EQ(JsonWriter().value(std::numeric_limits<double>::infinity()).take(), "null");
}

TEST(JsonWriter, GoesOnAfterWhatWasTaken) {
    JsonWriter json;
    json.open('[', on_lines).value(1);
    const std::string first = json.take();
    json.value(2).close();
    EXPECT_EQ(Json::parse(first + json.take()), Json({1, 2}));
}

}  // namespace
}  // namespace kinegraph::json_writer_test
