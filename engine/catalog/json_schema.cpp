// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/json_schema.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "catalog/catalog.h"
#include "catalog/suggestion.h"

namespace patina {
namespace {

using Json = nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;

/// Follows "#/definitions/..." once; the schemas that ship use no other references.
const Json& resolved(const Json& root, const Json& schema) {
    const auto reference = schema.find("$ref");
    if (reference == schema.end()) {
        return schema;
    }
    return root.at(Json::json_pointer(reference->get<std::string>().substr(1)));
}

/// Returns the part of a schema for the member or element `token` of what `schema` describes; null
/// where there is none.
const Json* step(const Json& schema, const std::string& token) {
    const auto properties = schema.find("properties");
    if (properties != schema.end() && properties->contains(token)) {
        return &(*properties)[token];
    }
    for (const char* keyword : {"additionalProperties", "items"}) {
        const auto rest = schema.find(keyword);
        if (rest != schema.end() && rest->is_object()) {
            return &*rest;
        }
    }
    return nullptr;
}

/// Returns the part of a schema for the value at a JSON pointer; null where there is none.
const Json* partAt(const Json& root, const Json::json_pointer& pointer) {
    if (pointer.empty()) {
        return &root;
    }
    const Json* parent = partAt(root, pointer.parent_pointer());
    const Json* part = parent == nullptr ? nullptr : step(*parent, pointer.back());
    return part == nullptr ? nullptr : &resolved(root, *part);
}

/// Returns the JSON pointer of a place, which valijson names by steps "[key]" or "[3]" after a
/// first "<root>".
std::string pointerOf(const std::vector<std::string>& context) {
    Json::json_pointer pointer;
    for (const std::string& entry : context) {
        if (entry.size() >= 2 && entry.front() == '[') {
            pointer.push_back(entry.substr(1, entry.size() - 2));
        }
    }
    return pointer.to_string();
}

std::string quoted(const std::string& text) {
    const std::size_t first = text.find('\'');
    const std::size_t last = text.rfind('\'');
    return first == last ? std::string() : text.substr(first + 1, last - first - 1);
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

std::vector<std::string> knownKeys(const Json* part) {
    std::vector<std::string> keys;
    if (part != nullptr && part->contains("properties")) {
        for (const auto& [key, ignored] : (*part)["properties"].items()) {
            keys.push_back(key);
        }
    }
    return keys;
}

/// Says what a part of a schema allows: its description, else the type of its values.
std::string allowed(const Json* part) {
    if (part == nullptr) {
        return {};
    }
    if (part->contains("description")) {
        return (*part)["description"];
    }
    const auto type = part->find("type");
    return type != part->end() && type->is_string() ? "type " + type->get<std::string>() : "";
}

/// Reports all unknown keys of an object, since valijson names only the first.
Errors unknownKeys(const LocatedJson& document, const std::string& pointer, const Json* part) {
    const std::vector<std::string> known = knownKeys(part);
    Errors errors;
    for (const auto& [key, ignored] : document.value.at(Json::json_pointer(pointer)).items()) {
        if (std::find(known.begin(), known.end(), key) == known.end()) {
            const auto place = (Json::json_pointer(pointer) / key).to_string();
            errors.push_back(document.error(place, fmt::format("the key \"{}\" is not known", key),
                                            oneOf(key, known)));
        }
    }
    return errors;
}

Error missingKey(const LocatedJson& document, const std::string& pointer, const Json& schema,
                 const Json* part, const std::string& key) {
    const Json* missing = part == nullptr ? nullptr : step(*part, key);
    return document.error(pointer, fmt::format("the key \"{}\" is missing", key),
                          allowed(missing == nullptr ? nullptr : &resolved(schema, *missing)));
}

/// Returns one violation in the project's words.
Errors violations(const LocatedJson& document, const Json& schema,
                  const valijson::ValidationResults::Error& found) {
    const std::string pointer = pointerOf(found.context);
    const Json* part = partAt(schema, Json::json_pointer(pointer));
    if (contains(found.description, "'additionalProperties' constraints")) {
        return unknownKeys(document, pointer, part);
    }
    if (contains(found.description, "Missing required property")) {
        return {missingKey(document, pointer, schema, part, quoted(found.description))};
    }
    const Json& value = document.value.at(Json::json_pointer(pointer));
    const std::string shown = value.is_primitive() ? value.dump() : value.type_name();
    return {document.error(pointer, shown + " is not allowed here", allowed(part))};
}

/// Tells whether an error only repeats another: valijson reports a failed value once more at each
/// object around it.
bool isEcho(const std::string& description) {
    return contains(description, "Failed to validate");
}

} // namespace

struct JsonSchema::Implementation {
    Json json;
    valijson::Schema schema;
    valijson::Validator validator{valijson::Validator::kStrongTypes}; ///< keeps compiled patterns
};

JsonSchema::JsonSchema(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
JsonSchema::JsonSchema(JsonSchema&&) noexcept = default;
JsonSchema& JsonSchema::operator=(JsonSchema&&) noexcept = default;
JsonSchema::~JsonSchema() = default;

Result<JsonSchema> JsonSchema::load(const std::string& name) {
    auto document = readJson(dataFolder() / "schemas" / (name + ".schema.json"));
    if (!document) {
        return tl::unexpected(document.error());
    }
    auto implementation = std::make_unique<Implementation>();
    implementation->json = std::move(document->value);
    try {
        valijson::SchemaParser parser;
        parser.populateSchema(Adapter(implementation->json), implementation->schema);
    } catch (const std::exception& problem) {
        return tl::unexpected(document->error("", std::string("not a schema: ") + problem.what()));
    }
    return JsonSchema(std::move(implementation));
}

Errors JsonSchema::check(const LocatedJson& document) const {
    valijson::ValidationResults results;
    implementation_->validator.validate(implementation_->schema, Adapter(document.value), &results);
    Errors errors;
    for (const auto& found : results) {
        if (!isEcho(found.description)) {
            const Errors more = violations(document, implementation_->json, found);
            errors.insert(errors.end(), more.begin(), more.end());
        }
    }
    return errors;
}

} // namespace patina
