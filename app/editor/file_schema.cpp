// The schema's words that matter here: properties, additionalProperties, propertyNames, items, $ref, allOf, anyOf.
#include "app/editor/file_schema.hpp"

#include <algorithm>

namespace kinegraph::app {
namespace {

constexpr std::string_view to_definitions = "#/definitions/";

using Json = FileSchema::Json;

const Json* found_in(const Json& object, std::string_view key) {
    const auto found = object.is_object() ? object.find(key) : object.end();
    return found == object.end() ? nullptr : &*found;
}

bool may_have(const FileSchema::Form& object, const std::string& key) {
    const Json* const properties = found_in(*object.schema, "properties");
    const Json* const others = found_in(*object.schema, "additionalProperties");
    return (properties != nullptr && properties->contains(key)) || (others != nullptr && others->is_object());
}

/// Whether a value of that kind may have the form; one that is missing may have any.
bool is_of(const FileSchema::Form& form, Outline::Kind kind) {
    const Json* const type = found_in(*form.schema, "type");
    const bool is_object = type != nullptr && *type == "object", is_array = type != nullptr && *type == "array";
    if (kind == Outline::Kind::missing) return true;
    return is_object == (kind == Outline::Kind::object) && is_array == (kind == Outline::Kind::array);
}

}  // namespace

FileSchema::FileSchema(std::string_view schema) : schema_(Json::parse(schema)) {}

std::string FileSchema::Form::leading_key() const {
    const Json* const needed = found_in(*schema, "required");
    return needed == nullptr || needed->empty() ? "" : needed->front().get<std::string>();
}

void FileSchema::add(const Json& schema, Origin origin, Forms& forms) const {
    if (origin.says.empty()) origin.says = schema.value("description", "");
    // What only adds a limit or a need to another is no form of its own.
    if (schema.contains("type") || schema.contains("enum") || schema.contains("const"))
        forms.push_back({&schema, origin.definition, origin.says});
    if (const Json* const name = found_in(schema, "$ref")) {
        origin.definition = name->get<std::string>().substr(to_definitions.size());
        add(schema_["definitions"][origin.definition], origin, forms);
    }
    for (const char* const several : {"allOf", "anyOf"})
        if (const Json* const parts = found_in(schema, several))
            for (const Json& each : *parts) add(each, origin, forms);
}

FileSchema::Forms FileSchema::forms_under(const Forms& object, const std::string& key) const {
    Forms forms;
    for (const Form& each : object) {
        const Json* const properties = found_in(*each.schema, "properties");
        const Json* schema = properties == nullptr ? nullptr : found_in(*properties, key);
        if (schema == nullptr) schema = found_in(*each.schema, "additionalProperties");
        if (schema != nullptr && schema->is_object()) add(*schema, {}, forms);
    }
    return forms;
}

FileSchema::Forms FileSchema::forms_of_elements(const Forms& array) const {
    Forms forms;
    for (const Form& each : array)
        if (const Json* const items = found_in(*each.schema, "items")) add(*items, {}, forms);
    return forms;
}

FileSchema::Forms FileSchema::forms_of_keys(const Forms& object) const {
    Forms forms;
    for (const Form& each : object)
        if (const Json* const names = found_in(*each.schema, "propertyNames")) add(*names, {}, forms);
    return forms;
}

FileSchema::Forms FileSchema::fitting(Forms forms, const Told& told) {
    const Outline::Kind kind = told.outline[told.node].kind;
    std::erase_if(forms, [&](const Form& each) { return !is_of(each, kind); });
    if (kind != Outline::Kind::object) return forms;
    const auto has_all_keys = [&](const Form& form) {
        for (std::uint32_t each = told.outline[told.node].first_child; each != Outline::none;
             each = told.outline[each].next)
            if (each != told.typed && told.outline[each].has_key() && !may_have(form, told.outline.key_of(each)))
                return false;
        return true;
    };
    Forms best;
    std::copy_if(forms.begin(), forms.end(), std::back_inserter(best), has_all_keys);
    return best.empty() ? forms : best;
}

FileSchema::Forms FileSchema::forms_of(const Outline& outline, std::uint32_t node, std::uint32_t typed) const {
    std::vector<std::uint32_t> way;
    for (std::uint32_t each = node; each != 0 && each != Outline::none; each = outline[each].parent)
        way.push_back(each);
    Forms forms;
    if (way.empty()) return forms;
    add(schema_, {}, forms);
    while (true) {
        forms = fitting(std::move(forms), {outline, way.back(), typed});
        way.pop_back();
        if (way.empty()) return forms;
        forms =
            outline[way.back()].has_key() ? forms_under(forms, outline.key_of(way.back())) : forms_of_elements(forms);
    }
}

}  // namespace kinegraph::app
