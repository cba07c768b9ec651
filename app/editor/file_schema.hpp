// What may stand in a place of a mechanism file, by its JSON Schema.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/files/outline.hpp"

namespace kinegraph::app {

class FileSchema {
public:
    using Json = nlohmann::ordered_json;
    /// A schema, with the name of the definition from which it comes.
    struct Form {
        const Json* schema = nullptr;
        std::string definition{};
        std::string says{};  ///< description of the place in which it may stand

        /// The key of an object that tells its kind: "revolute"; empty: it is told by none.
        std::string leading_key() const;
        /// What the schema says about the form itself; empty where it says nothing.
        std::string description() const { return schema->value("description", ""); }
        bool has(const char* keyword) const { return schema->contains(keyword); }
    };
    using Forms = std::vector<Form>;

    explicit FileSchema(std::string_view schema);

    /// The forms that the node can have: of several kinds of objects those that have all of its keys. The key `typed`,
    /// a node, does not count.
    Forms forms_of(const Outline& outline, std::uint32_t node, std::uint32_t typed = Outline::none) const;
    /// The forms of what stands under the key, in an object of these forms.
    Forms forms_under(const Forms& object, const std::string& key) const;
    /// The forms of the elements of arrays.
    Forms forms_of_elements(const Forms& array) const;
    /// The forms of the keys themselves, of an object whose keys are names.
    Forms forms_of_keys(const Forms& object) const;

private:
    /// An object whose kind is to be told from others.
    struct Told {
        const Outline& outline;
        std::uint32_t node, typed;
    };
    struct Origin {
        std::string definition{}, says{};
    };
    void add(const Json& schema, Origin origin, Forms& forms) const;
    static Forms fitting(Forms forms, const Told& told);
    Json schema_;
};

}  // namespace kinegraph::app
