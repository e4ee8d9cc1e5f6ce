// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/eval/eval_case.h"

#include "catalog/value_json.h"

namespace patina {
namespace {

using Json = nlohmann::json;
using Subject = EvalCase::Subject;

Json numbers(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

Json parametersOf(const EvalBlock& block) {
    Json parameters = Json::object();
    for (const auto& [id, value] : block.values) {
        parameters[id] = toJson(value);
    }
    return parameters;
}

Json nested(const EvalBlock& block) {
    Json json{{"id", block.block->id}, {"parameters", parametersOf(block)}};
    if (!block.accuracy.empty()) {
        json["accuracy"] = block.accuracy;
    }
    return json;
}

/// Returns the key of a block in a line, which is the word for its kind.
std::string keyOf(const EvalBlock& block) {
    return std::string(findKind(block.block->kind)->singular);
}

Json modelJson(const EvalCase& request) {
    Json json{{"n", numbers(request.n)},
              {"t", numbers(request.t)},
              {"l", numbers(request.l)},
              {"v", numbers(request.v)}};
    if (request.pixel != glm::dvec2(0.0)) {
        json["pixel"] = {request.pixel.x, request.pixel.y};
    }
    if (request.block.block->kind != kinds::models) {
        json[keyOf(request.block)] = nested(request.block);
        return json;
    }
    json["model"] = request.block.block->id;
    json["parameters"] = parametersOf(request.block);
    if (!request.block.accuracy.empty()) {
        json["accuracy"] = request.block.accuracy;
    }
    if (request.slot.block != nullptr) {
        json[keyOf(request.slot)] = nested(request.slot);
    }
    return json;
}

Json fieldJson(const ArgumentField& field, std::span<const double> numbers) {
    if (field.isTriple()) {
        return {numbers[0], numbers[1], numbers[2]};
    }
    return field.type == ArgumentField::Type::Flag    ? Json(numbers[0] != 0.0)
           : field.type == ArgumentField::Type::Whole ? Json(int(numbers[0]))
                                                      : Json(numbers[0]);
}

Json fieldsJson(const EvalCase& request) {
    Json json{{keyOf(request.block), nested(request.block)}};
    std::span<const double> numbers(request.fields);
    for (const ArgumentField& field : fieldsOf(request)) {
        json[std::string(field.key)] = fieldJson(field, numbers);
        numbers = numbers.subspan(field.numbers());
    }
    return json;
}

Json subjectJson(const EvalCase& request) {
    switch (request.subject) {
    case Subject::Model:
        return modelJson(request);
    case Subject::Fresnel:
        return {{keyOf(request.block), nested(request.block)}, {"cos", request.number}};
    case Subject::Light:
        return {{keyOf(request.block), nested(request.block)}, {"x", numbers(request.l)}};
    case Subject::Fog:
        return {{keyOf(request.block), nested(request.block)},
                {"distance", request.number},
                {"eye", numbers(request.l)},
                {"direction", numbers(request.v)}};
    case Subject::Fields:
        return fieldsJson(request);
    default:
        return {{"function", request.function}, {"arguments", request.arguments}};
    }
}

} // namespace

const BlockFunction& calledFunction(const EvalCase& request) {
    return request.called != nullptr ? *request.called
                                     : findKind(request.block.block->kind)->functions.front();
}

std::size_t resultsOf(const EvalCase& request) {
    const std::string_view type = calledFunction(request).result;
    return type == "Illumination" ? 6 : type == "float" ? 1 : type == "vec2" ? 2 : 3;
}

std::size_t signedResultsOf(const EvalCase& request) {
    const BlockFunction& function = calledFunction(request);
    return function.result == "Illumination" ? 3 : function.isSigned ? resultsOf(request) : 0;
}

std::span<const ArgumentField> fieldsOf(const EvalCase& request) {
    return request.subject == Subject::Fields ? calledFunction(request).fields
                                              : std::span<const ArgumentField>();
}

std::optional<Subject> subjectOf(const BlockFunction& function) {
    if (!function.fields.empty()) {
        const bool isHeld = numbersOf(function.fields) <= FieldNumbers().size();
        return isHeld ? std::optional(Subject::Fields) : std::nullopt;
    }
    constexpr std::pair<std::string_view, Subject> arguments[] = {{"", Subject::Fields},
                                                                  {"Directions", Subject::Model},
                                                                  {"Incidence", Subject::Fresnel},
                                                                  {"vec3", Subject::Light},
                                                                  {"FogRay", Subject::Fog}};
    for (const auto& [argument, subject] : arguments) {
        if (function.argument == argument) {
            return subject;
        }
    }
    return std::nullopt;
}

std::vector<const BlockFunction*> evaluatedFunctions(const BlockKind& kind) {
    std::vector<const BlockFunction*> functions;
    for (const BlockFunction& function : kind.functions) {
        if (subjectOf(function)) {
            functions.push_back(&function);
        }
    }
    return functions;
}

std::vector<const BlockFunction*> evaluatedFunctions(const Block& block) {
    const BlockKind* kind = findKind(block.kind);
    return kind == nullptr ? std::vector<const BlockFunction*>() : evaluatedFunctions(*kind);
}

Json evalJson(const EvalCase& request) {
    Json json = subjectJson(request);
    if (request.called != nullptr && !request.called->suffix.empty()) {
        json["call"] = request.called->suffix;
    }
    json["precision"] = request.gpu ? "gpu" : "double";
    if (!request.id.is_null()) {
        json["id"] = request.id;
    }
    return json;
}

} // namespace patina
