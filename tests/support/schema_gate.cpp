#include "tests/support/schema_gate.hpp"

#include <kinegraph/mechanism.hpp>

#include <memory>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "engine/file/units.hpp"
#include "engine/number/assert.hpp"

namespace kinegraph {
namespace {

using Json = nlohmann::json;

/// Removes what is only for readers and editors, and the patterns that std::regex cannot match safely.
void strip(Json& part) {
    if (part.is_object())
        for (const char* key : {"description", "pattern", "examples"}) part.erase(key);
    for (Json& inner : part)
        if (inner.is_structured()) strip(inner);
}
Json schema_document() {
    Json document = Json::parse(mechanism_schema(), nullptr, false);
    KG_ASSERT(document.is_object(), "the built-in schema is JSON");
    strip(document);
    return document;
}

const valijson::Schema& schema() {
    static const std::unique_ptr<const valijson::Schema> parsed = [] {
        const Json document = schema_document();
        auto made = std::make_unique<valijson::Schema>();
        valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
        try {
            parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(document), *made);
        } catch (const std::exception& trouble) {
            fault(__FILE__, __LINE__, "populateSchema",
                  std::string("the built-in schema can be read: ") + trouble.what());
        }
        return std::unique_ptr<const valijson::Schema>(std::move(made));
    }();
    return *parsed;
}

/// Converts valijson's path: "<root>", "[\"joints\"]", "[0]".
std::string pointer_of(const std::vector<std::string>& path) {
    std::string pointer;
    for (std::string step : path) {
        if (step.starts_with('<')) continue;
        if (step.starts_with('[') && step.ends_with(']')) step = step.substr(1, step.size() - 2);
        if (step.starts_with('"') && step.ends_with('"') && step.size() > 1) step = step.substr(1, step.size() - 2);
        pointer += '/' + shown(step, 200);
    }
    return pointer;
}

}  // namespace

Errors refused_by_schema(std::string_view text) {
    const Json document = Json::parse(text, nullptr, false);
    KG_ASSERT(!document.is_discarded(), "the gate is shown JSON only");
    const valijson::adapters::NlohmannJsonAdapter target(document);
    valijson::Validator validator;
    if (validator.validate(schema(), target, nullptr)) return {};
    valijson::ValidationResults results;
    validator.validate(schema(), target, &results);
    // The deepest fault is the most specific.
    const valijson::ValidationResults::Error* deepest = nullptr;
    for (const auto& error : results) {
        if (deepest == nullptr || error.context.size() > deepest->context.size()) deepest = &error;
    }
    KG_ASSERT(deepest != nullptr, "who refuses gives a reason");
    return {{ErrorCode::bad_input, pointer_of(deepest->context),
             "against the format's schema: " + shown(deepest->description, 300)}};
}

}  // namespace kinegraph
