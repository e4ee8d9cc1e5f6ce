// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/eval_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <regex>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "catalog/fills.h"
#include "catalog/json_text.h"
#include "catalog/suggestion.h"
#include "catalog/value_json.h"
#include "cli/eval_numbers.h"
#include "core/number_text.h"
#include "material/material.h"

namespace patina {
namespace {

using Json = nlohmann::json;
using Subject = EvalCase::Subject;

/// Puts the name of a key in front of what is wrong with its value.
tl::unexpected<Error> at(const std::string& key, Error error) {
    error.problem = key + ": " + error.problem;
    return tl::unexpected(std::move(error));
}

Result<void> checkKeys(const Json& json, std::vector<std::string> known) {
    known.insert(known.end(), {"id", "precision"});
    for (const auto& [key, value] : json.items()) {
        if (std::find(known.begin(), known.end(), key) == known.end()) {
            return failure("\"" + key + "\" means nothing here", oneOf(key, known));
        }
    }
    return {};
}

/// Repeats a single number three times where a colour or the like is wanted.
Json asWanted(const Parameter& parameter, const Json& json) {
    const bool three = componentCount(parameter.type) == 3;
    if (three && json.is_number()) {
        return Json::array({json, json, json});
    }
    return json;
}

Result<Value> readParameter(const Parameter& parameter, const Json& json) {
    Result<Value> value = valueFromJson(parameter, asWanted(parameter, json));
    if (!value) {
        return at(parameter.id, value.error());
    }
    if (conformed(parameter, *value) != *value) {
        return failure(fmt::format("{}: {} is outside its range", parameter.id, json.dump()),
                       fmt::format("{} to {}", shortestText(static_cast<float>(parameter.min)),
                                   shortestText(static_cast<float>(parameter.max))));
    }
    return value;
}

Result<Values> readValues(const Block& block, const Json& json) {
    if (!json.is_object()) {
        return failure("parameters is not an object", "an object of parameter ids and values");
    }
    std::vector<std::string> ids;
    for (const Parameter& parameter : block.parameters) {
        ids.push_back(parameter.id);
    }
    Values values;
    for (const auto& [id, value] : json.items()) {
        const Parameter* parameter = block.parameter(id);
        if (parameter == nullptr) {
            return failure(fmt::format("{} has no parameter \"{}\"", block.id, id), oneOf(id, ids));
        }
        const Result<Value> read = readParameter(*parameter, value);
        if (!read) {
            return tl::unexpected(read.error());
        }
        values.emplace(id, *read);
    }
    fillGaps(block, values);
    return values;
}

Result<AccuracyLevels> readLevels(const Block& block, const Json& json) {
    AccuracyLevels levels;
    for (const auto& [id, level] : json.items()) {
        const AccuracyChoice* choice = block.accuracyChoice(id);
        const auto known = [&word = level](const EnumValue& value) {
            return word.is_string() && value.id == word.get<std::string>();
        };
        if (choice == nullptr ||
            std::none_of(choice->values.begin(), choice->values.end(), known)) {
            return failure(fmt::format("{} has no accuracy {}: {}", block.id, id, level.dump()));
        }
        levels.emplace(id, level.get<std::string>());
    }
    return levels;
}

Result<EvalBlock> readBlock(const Catalog& catalog, std::string_view kind, const std::string& id,
                            const Json& parameters, const Json& accuracy) {
    const Block* block = catalog.find(kind, id);
    if (block == nullptr) {
        std::vector<std::string> ids;
        for (const Block* known : catalog.ofKind(kind)) {
            ids.push_back(known->id);
        }
        return failure(fmt::format("there is no \"{}\" in {}", id, kind), oneOf(id, ids));
    }
    const Result<Values> values = readValues(*block, parameters);
    if (!values) {
        return tl::unexpected(values.error());
    }
    const Result<AccuracyLevels> levels = readLevels(*block, accuracy);
    if (!levels) {
        return tl::unexpected(levels.error());
    }
    return EvalBlock{block, *values, *levels};
}

/// Reads a block that is written as {"id": ..., "parameters": {...}, "accuracy": {...}}, or as the
/// id alone.
Result<EvalBlock> readNested(const Catalog& catalog, std::string_view kind, const Json& json) {
    const Json& id = json.is_object() ? json.value("id", Json()) : json;
    if (!id.is_string()) {
        return failure("the block has no id", R"({"id": ..., "parameters": {...}})");
    }
    const Json none = Json::object();
    return readBlock(catalog, kind, id.get<std::string>(),
                     json.is_object() ? json.value("parameters", none) : none,
                     json.is_object() ? json.value("accuracy", none) : none);
}

/// Reads the pixel, for models that draw marks; (0, 0) unless it is given.
Result<void> readPixel(const Json& json, EvalCase& request) {
    if (!json.contains("pixel")) {
        return {};
    }
    const Json& value = json["pixel"];
    if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number()) {
        return failure("pixel is not a place", "an array of 2 numbers");
    }
    request.pixel = {value[0].get<double>(), value[1].get<double>()};
    return {};
}

Result<void> readFrame(const Json& json, EvalCase& request) {
    for (const auto& [key, target] : {std::pair{"n", &request.n}, {"t", &request.t}}) {
        Result<void> done = json.contains(key) ? readDirection(json, key, *target) : Result<void>();
        if (!done) {
            return done;
        }
    }
    for (const auto& done : {readDirection(json, "l", request.l),
                             readDirection(json, "v", request.v), readPixel(json, request)}) {
        if (!done) {
            return done;
        }
    }
    return {};
}

/// Fills the slot of a model with the given block or the descriptor's default.
Result<void> readSlot(const Json& json, const Catalog& catalog, EvalCase& request) {
    if (request.block.block->slots.empty()) {
        return {};
    }
    const Slot& slot = request.block.block->slots.front();
    const Json usual = slot.defaultBlock.empty() ? Json() : Json(slot.defaultBlock);
    const Json wanted = json.value(slot.kind, usual);
    if (wanted.is_null()) {
        return {};
    }
    const Result<EvalBlock> filled = readNested(catalog, slot.kind, wanted);
    if (!filled) {
        return at(slot.kind, filled.error());
    }
    request.slot = *filled;
    return {};
}

Result<void> checkModelKeys(const Json& json) {
    std::vector<std::string> known{"model", "parameters", "accuracy", "l",   "v",
                                   "n",     "t",          "pixel",    "call"};
    const auto parts = partKinds(BlockOwner::Material);
    known.insert(known.end(), parts.begin(), parts.end());
    return checkKeys(json, known);
}

/// Fails for a block that the model has no slot for, as it would not change the answer.
Result<void> checkParts(const Json& json, const Block& model) {
    for (const std::string_view kind : partKinds(BlockOwner::Material)) {
        const auto part = json.find(kind);
        if (part != json.end() && !part->is_null() && model.slot(kind) == nullptr) {
            return failure(fmt::format("{} has no slot for \"{}\"", model.id, kind),
                           "a model with that slot, or no such key");
        }
    }
    return {};
}

Result<EvalCase> readModel(const Json& json, const Catalog& catalog, EvalCase request) {
    if (const auto keys = checkModelKeys(json); !keys) {
        return tl::unexpected(keys.error());
    }
    if (!json["model"].is_string()) {
        return failure("model is not the id of a model", "text");
    }
    const Json none = Json::object();
    const Result<EvalBlock> block =
        readBlock(catalog, kinds::models, json["model"].get<std::string>(),
                  json.value("parameters", none), json.value("accuracy", none));
    if (!block) {
        return tl::unexpected(block.error());
    }
    request.block = *block;
    for (const auto& step : {checkParts(json, *block->block), readFrame(json, request),
                             readSlot(json, catalog, request)}) {
        if (!step) {
            return tl::unexpected(step.error());
        }
    }
    return request;
}

/// Reads a block of a slot that is a function of directions, as a model is.
Result<EvalCase> readSurfacePart(const Json& json, const Catalog& catalog, EvalCase request,
                                 const BlockKind& kind) {
    const std::string key(kind.singular);
    const auto keys = checkKeys(json, {key, "l", "v", "n", "t", "pixel", "call"});
    const Result<EvalBlock> block = readNested(catalog, kind.folder, json[key]);
    if (!keys || !block) {
        return tl::unexpected(keys ? block.error() : keys.error());
    }
    request.block = *block;
    const Result<void> frame = readFrame(json, request);
    return frame ? Result<EvalCase>(request) : tl::unexpected(frame.error());
}

/// Reads the ray through fog: from the origin along -z unless it is given.
Result<EvalCase> readRay(const Json& json, EvalCase request) {
    request.v = {0.0, 0.0, -1.0};
    if (json.contains("direction")) {
        if (const auto read = readDirection(json, "direction", request.v); !read) {
            return tl::unexpected(read.error());
        }
        request.v = glm::normalize(request.v);
    }
    if (json.contains("eye")) {
        const Result<glm::dvec3> eye = vector(json, "eye");
        if (!eye) {
            return tl::unexpected(eye.error());
        }
        request.l = *eye;
    }
    return request;
}

/// Reads a block that is a function of a number, of a point or of a ray.
Result<EvalCase> readAlone(const Json& json, const Catalog& catalog, EvalCase request,
                           const BlockKind& kind) {
    const std::string key(kind.singular);
    const bool isLight = request.subject == Subject::Light;
    const bool isFog = request.subject == Subject::Fog;
    const std::string argument = isLight ? "x" : isFog ? "distance" : "cos";
    std::vector<std::string> known{key, argument, "call"};
    if (isFog) {
        known.insert(known.end(), {"eye", "direction"});
    }
    const auto keys = checkKeys(json, known);
    const Result<EvalBlock> block = readNested(catalog, kind.folder, json[key]);
    if (!keys || !block) {
        return tl::unexpected(keys ? block.error() : keys.error());
    }
    request.block = *block;
    if (isLight) {
        const Result<glm::dvec3> x = vector(json, argument);
        request.l = x.value_or(request.l);
        return x ? Result<EvalCase>(request) : tl::unexpected(x.error());
    }
    const Result<double> x = number(json, argument);
    if (!x) {
        return tl::unexpected(x.error());
    }
    if (!isFog && !(std::abs(*x) <= 1.0)) {
        return failure(fmt::format("cos is {}", json[argument].dump()), "-1 .. 1");
    }
    if (isFog && !(*x >= 0.0)) {
        return failure(fmt::format("distance is {}", json[argument].dump()), "0 or more");
    }
    request.number = *x;
    return isFog ? readRay(json, request) : Result<EvalCase>(request);
}

/// Reads a direction and normalizes it, unless it is of unit length up to the rounding of floats.
Result<glm::dvec3> readUnit(const Json& json, const std::string& key) {
    glm::dvec3 direction;
    return readDirection(json, key, direction).map([&direction] {
        const bool isUnit = std::abs(glm::dot(direction, direction) - 1.0) < 2e-7;
        return isUnit ? direction : glm::normalize(direction);
    });
}

/// Reads a number within the field's range, which fills all three components, or a colour.
Result<glm::dvec3> readNumbers(const Json& json, const ArgumentField& field) {
    const std::string key(field.key);
    Result<glm::dvec3> value = field.isTriple()
                                   ? vector(json, key)
                                   : number(json, key).map([](double x) { return glm::dvec3(x); });
    if (!value) {
        return value;
    }
    const bool isOpen = field.isTriple() || field.type == ArgumentField::Type::Amount;
    const double largest = isOpen ? std::numeric_limits<float>::max() : field.max;
    const bool isWhole =
        field.type != ArgumentField::Type::Whole || std::round(value->x) == value->x;
    const bool isInside = glm::all(glm::greaterThanEqual(*value, glm::dvec3(0.0))) &&
                          glm::all(glm::lessThanEqual(*value, glm::dvec3(largest)));
    if (!isInside || !isWhole) {
        return failure(fmt::format("{} is {}", key, json[key].dump()),
                       isOpen ? std::string("0 or more, within a float's range")
                              : fmt::format("0 .. {}", shortestText(float(largest))));
    }
    return value;
}

/// Reads the numbers of one field; `before` is the direction read before it.
Result<glm::dvec3> readField(const Json& json, const ArgumentField& field,
                             const glm::dvec3& before) {
    const std::string key(field.key);
    if (!json.contains(key) && field.usual) {
        return glm::dvec3(*field.usual);
    }
    if (field.isDirection()) {
        const Result<glm::dvec3> direction = readUnit(json, key);
        const bool isBehind = direction && field.type == ArgumentField::Type::Normal &&
                              glm::dot(*direction, before) < 0.0;
        return isBehind ? failure(key + " points to the other side", "a direction on that side")
                        : direction;
    }
    if (field.type == ArgumentField::Type::Flag) {
        return json[key].is_boolean() ? Result<glm::dvec3>(glm::dvec3(json[key].get<bool>()))
                                      : failure(key + " is not a truth", "true or false");
    }
    return readNumbers(json, field);
}

/// Reads a block that is a function of the fields of a struct.
Result<EvalCase> readFields(const Json& json, const Catalog& catalog, EvalCase request,
                            const BlockKind& kind) {
    const std::string key(kind.singular);
    const std::span<const ArgumentField> fields = fieldsOf(request);
    std::vector<std::string> known{key, "call"};
    for (const ArgumentField& field : fields) {
        known.emplace_back(field.key);
    }
    const auto keys = checkKeys(json, known);
    const Result<EvalBlock> block = readNested(catalog, kind.folder, json[key]);
    if (!keys || !block) {
        return tl::unexpected(keys ? block.error() : keys.error());
    }
    request.block = *block;
    glm::dvec3 before(0.0);
    double* next = request.fields.data();
    for (const ArgumentField& field : fields) {
        const Result<glm::dvec3> value = readField(json, field, before);
        if (!value) {
            return tl::unexpected(value.error());
        }
        before = field.type == ArgumentField::Type::Direction ? *value : before;
        for (std::size_t i = 0; i < field.numbers(); ++i) {
            *next++ = (*value)[int(i)];
        }
    }
    return request;
}

/// Returns the function of the kind that is called: its first one unless "call" is given.
Result<const BlockFunction*> readCall(const Json& json, const BlockKind& kind) {
    const Json wanted = json.value("call", Json(kind.functions.front().suffix));
    std::vector<std::string> names;
    for (const BlockFunction* function : evaluatedFunctions(kind)) {
        if (wanted == function->suffix) {
            return function;
        }
        if (!function->suffix.empty()) {
            names.emplace_back(function->suffix);
        }
    }
    const std::string word = wanted.is_string() ? wanted.get<std::string>() : wanted.dump();
    return failure(fmt::format("{} have no function \"{}\" to evaluate", kind.plural, word),
                   names.empty() ? "no \"call\"" : oneOf(word, names));
}

/// Reads a case that calls a function of a block on its own.
Result<EvalCase> readBlockCase(const Json& json, const Catalog& catalog, EvalCase request,
                               const BlockKind& kind) {
    const Result<const BlockFunction*> called = readCall(json, kind);
    if (!called) {
        return tl::unexpected(called.error());
    }
    request.called = *called;
    request.subject = *subjectOf(**called);
    if (kind.folder == kinds::models) {
        return readModel(json, catalog, request);
    }
    return request.subject == Subject::Model    ? readSurfacePart(json, catalog, request, kind)
           : request.subject == Subject::Fields ? readFields(json, catalog, request, kind)
                                                : readAlone(json, catalog, request, kind);
}

Result<EvalCase> readFunction(const Json& json, EvalCase request) {
    if (const auto keys = checkKeys(json, {"function", "arguments"}); !keys) {
        return tl::unexpected(keys.error());
    }
    const Json arguments = json.value("arguments", Json::array());
    const bool numbers = arguments.is_array() &&
                         std::all_of(arguments.begin(), arguments.end(),
                                     [](const Json& element) { return element.is_number(); });
    if (!json["function"].is_string() || !numbers) {
        return failure("the function or its arguments cannot be read",
                       R"({"function": "name", "arguments": [numbers]})");
    }
    request.function = json["function"].get<std::string>();
    request.arguments = arguments.get<std::vector<double>>();
    return request;
}

Result<bool> readPrecision(const Json& json) {
    const Json precision = json.value("precision", Json("double"));
    if (precision != "double" && precision != "gpu") {
        return failure("precision is " + precision.dump(), R"("double" or "gpu")");
    }
    return precision == "gpu";
}

Result<EvalCase> readCase(const Json& json, const Catalog& catalog) {
    const Result<bool> gpu = readPrecision(json);
    if (!gpu) {
        return tl::unexpected(gpu.error());
    }
    EvalCase request;
    request.id = json.value("id", Json());
    request.gpu = *gpu;
    if (json.contains("function")) {
        request.subject = Subject::Function;
        return readFunction(json, request);
    }
    std::string keys;
    for (const BlockKind& kind : blockKinds()) {
        const bool isEvaluated = !evaluatedFunctions(kind).empty();
        if (json.contains(kind.singular) && !isEvaluated) {
            return failure(
                fmt::format("{} have no value of their own: they read what is drawn", kind.plural),
                "a picture of them, as `patina render` makes it");
        }
        if (json.contains(kind.singular)) {
            return readBlockCase(json, catalog, request, kind);
        }
        if (isEvaluated) {
            keys += fmt::format("{}{}", keys.empty() ? "a " : ", ", kind.singular);
        }
    }
    return failure("nothing to evaluate", keys + " or function");
}

/// Finds the id in a line that is not valid JSON, so that the writer can match the error to its
/// line.
Json idInBrokenLine(std::string_view line) {
    static const std::regex form(R"re("id"\s*:\s*("[^"\\]*"|-?[0-9]{1,18}))re");
    const std::string start(line.substr(0, 1000));
    std::smatch match;
    return std::regex_search(start, match, form) ? Json::parse(match[1].str(), nullptr, false)
                                                 : Json();
}

} // namespace

EvalLine readEvalLine(std::string_view line, const Catalog& catalog) {
    const Result<LocatedJson> document = parseJson(line, {});
    if (!document) {
        const Json id = idInBrokenLine(line);
        return {id.is_discarded() ? Json() : id, tl::unexpected(document.error())};
    }
    if (!document->value.is_object()) {
        return {Json(), failure("the line is not an object", "one case as a JSON object")};
    }
    return {document->value.value("id", Json()), readCase(document->value, catalog)};
}

} // namespace patina
