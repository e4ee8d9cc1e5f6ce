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

Json modelJson(const EvalCase& request) {
    Json json{{"n", numbers(request.n)},
              {"t", numbers(request.t)},
              {"l", numbers(request.l)},
              {"v", numbers(request.v)}};
    if (request.pixel != glm::dvec2(0.0)) {
        json["pixel"] = {request.pixel.x, request.pixel.y};
    }
    if (request.block.block->kind != "models") {
        json[request.block.block->kind] = nested(request.block);
        return json;
    }
    json["model"] = request.block.block->id;
    json["parameters"] = parametersOf(request.block);
    if (!request.block.accuracy.empty()) {
        json["accuracy"] = request.block.accuracy;
    }
    if (request.slot.block != nullptr) {
        json[request.slot.block->kind] = nested(request.slot);
    }
    return json;
}

Json subjectJson(const EvalCase& request) {
    switch (request.subject) {
    case Subject::Model:
        return modelJson(request);
    case Subject::Fresnel:
        return {{"fresnel", nested(request.block)}, {"cos", request.number}};
    case Subject::Light:
        return {{"light", nested(request.block)}, {"x", numbers(request.l)}};
    case Subject::Fog:
        return {{"fog", nested(request.block)},
                {"distance", request.number},
                {"eye", numbers(request.l)},
                {"direction", numbers(request.v)}};
    default:
        return {{"function", request.function}, {"arguments", request.arguments}};
    }
}

} // namespace

std::size_t resultsOf(EvalCase::Subject subject) {
    switch (subject) {
    case EvalCase::Subject::Light:
        return 6;
    case EvalCase::Subject::Fog:
        return 1;
    default:
        return 3;
    }
}

std::optional<Subject> subjectOfKind(std::string_view kind) {
    constexpr std::pair<std::string_view, Subject> kinds[] = {{"models", Subject::Model},
                                                              {"specular", Subject::Model},
                                                              {"fresnel", Subject::Fresnel},
                                                              {"lights", Subject::Light},
                                                              {"fog", Subject::Fog}};
    for (const auto& [name, subject] : kinds) {
        if (name == kind) {
            return subject;
        }
    }
    return std::nullopt;
}

Json evalJson(const EvalCase& request) {
    Json json = subjectJson(request);
    json["precision"] = request.gpu ? "gpu" : "double";
    if (!request.id.is_null()) {
        json["id"] = request.id;
    }
    return json;
}

} // namespace patina
