// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/json_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace patina {
namespace {

using Json = nlohmann::json;

/// Returns a number as a float, which documents hold; one that is too large becomes the largest.
double asFloat(const Json& json) {
    constexpr double largest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(json.get<double>(), -largest, largest));
}

bool isNumber(const Json& json) {
    return json.is_number();
}

/// Returns "an array of 3", and the first element that is no number where others are.
std::string describedArray(const nlohmann::json& json) {
    std::string text = fmt::format("an array of {}", json.size());
    const auto odd = std::find_if_not(json.begin(), json.end(), isNumber);
    if (odd != json.end() && std::any_of(json.begin(), json.end(), isNumber)) {
        text += fmt::format(" with {} at place {}", described(*odd), odd - json.begin() + 1);
    }
    return text;
}

} // namespace

std::string escapedToken(std::string_view key) {
    std::string out;
    for (const char c : key) {
        if (c == '~' || c == '/') {
            out += c == '~' ? "~0" : "~1";
        } else {
            out += c;
        }
    }
    return out;
}

std::string described(const nlohmann::json& json) {
    if (json.is_number()) {
        return "the number " + json.dump();
    }
    if (json.is_string()) {
        return fmt::format("the text \"{}\"", json.get_ref<const std::string&>().substr(0, 40));
    }
    if (json.is_array()) {
        return describedArray(json);
    }
    return json.is_object() ? "an object" : json.dump();
}

JsonReader::JsonReader(const LocatedJson& document, std::string pointer, Errors& errors)
    : JsonReader(document, std::move(pointer), errors, Missing{}) {
    const Json& value = document.value.at(Json::json_pointer(pointer_));
    if (value.is_object()) {
        object_ = &value;
    } else {
        errors_.push_back(document.error(pointer_, described(value) + " stands here", "an object"));
    }
}

JsonReader::JsonReader(const LocatedJson& document, std::string pointer, Errors& errors, Missing)
    : document_(document), pointer_(std::move(pointer)), errors_(errors) {}

std::string JsonReader::pointer(std::string_view key) const {
    return pointer_ + '/' + escapedToken(key);
}

const nlohmann::json* JsonReader::find(std::string_view key) {
    known_.emplace(key);
    if (object_ == nullptr) {
        return nullptr;
    }
    const auto found = object_->find(key);
    return found == object_->end() ? nullptr : &*found;
}

void JsonReader::addError(std::string_view key, std::string problem, std::string expected) {
    errors_.push_back(document_.error(pointer(key), std::move(problem), std::move(expected)));
}

void JsonReader::addError(std::string_view key, const ValueError& error) {
    errors_.push_back(document_.error(pointer(key) + error.within, error.problem, error.expected));
}

void JsonReader::addWrongType(std::string_view key, const Json& found, std::string expected) {
    addError(key, fmt::format("{} stands at \"{}\"", described(found), key), std::move(expected));
}

void JsonReader::read(std::string_view key, std::string& into) {
    const Json* json = find(key);
    if (json != nullptr && json->is_string()) {
        into = json->get<std::string>();
    } else if (json != nullptr) {
        addWrongType(key, *json, "text");
    }
}

void JsonReader::read(std::string_view key, bool& into) {
    const Json* json = find(key);
    if (json != nullptr && json->is_boolean()) {
        into = json->get<bool>();
    } else if (json != nullptr) {
        addWrongType(key, *json, "true or false");
    }
}

void JsonReader::read(std::string_view key, int& into) {
    constexpr double largest = std::numeric_limits<int>::max();
    const Json* json = find(key);
    if (json != nullptr && json->is_number() && std::floor(json->get<double>()) == *json &&
        std::abs(json->get<double>()) <= largest) {
        into = static_cast<int>(json->get<double>());
    } else if (json != nullptr) {
        addWrongType(key, *json, "a whole number");
    }
}

void JsonReader::read(std::string_view key, double& into) {
    const Json* json = find(key);
    if (json != nullptr && json->is_number()) {
        into = asFloat(*json);
    } else if (json != nullptr) {
        addWrongType(key, *json, "a number");
    }
}

void JsonReader::read(std::string_view key, glm::dvec3& into) {
    const Json* json = find(key);
    if (json == nullptr) {
        return;
    }
    if (json->is_array() && json->size() == 3 &&
        std::all_of(json->begin(), json->end(), isNumber)) {
        into = {asFloat((*json)[0]), asFloat((*json)[1]), asFloat((*json)[2])};
    } else {
        addWrongType(key, *json, "an array of 3 numbers");
    }
}

void JsonReader::readObject(std::string_view key, nlohmann::json& into) {
    const Json* json = find(key);
    if (json != nullptr && json->is_object()) {
        into = *json;
    } else if (json != nullptr) {
        addWrongType(key, *json, "an object");
    }
}

const nlohmann::json* JsonReader::array(std::string_view key) {
    const Json* json = find(key);
    if (json != nullptr && !json->is_array()) {
        addWrongType(key, *json, "an array");
        return nullptr;
    }
    return json;
}

JsonReader JsonReader::child(std::string_view key) {
    return has(key) ? JsonReader(document_, pointer(key), errors_)
                    : JsonReader(document_, pointer(key), errors_, Missing{});
}

nlohmann::json JsonReader::unknown() const {
    Json rest = Json::object();
    if (object_ != nullptr) {
        for (const auto& [key, value] : object_->items()) {
            if (!known_.contains(key)) {
                rest[key] = value;
            }
        }
    }
    return rest;
}

} // namespace patina
