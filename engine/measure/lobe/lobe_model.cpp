// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/lobe_model.h"

#include <numbers>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "core/vectors.h"
#include "measure/stability/sweep_cases.h"

namespace patina {
namespace {

std::vector<double> packedOf(const EvalBlock& block) {
    return block.block == nullptr ? std::vector<double>() : block.packedValues();
}

std::unique_ptr<ReferenceCase> compiledCase(const ReferenceCode& code, const EvalCase& request) {
    return std::make_unique<ReferenceCase>(code, packedOf(request.block), packedOf(request.slot));
}

/// Returns the case without its diffuse term.
EvalCase highlightOf(const EvalCase& request) {
    EvalCase alone = request;
    for (const Parameter& parameter : request.block.block->parameters) {
        if (parameter.role == roles::diffuse) {
            alone.block.values[parameter.id] = glm::dvec3(0.0);
        }
    }
    return alone;
}

glm::dvec3 shadedValue(const ReferenceCase& code, const EvalPlace& place) {
    const ReferenceNumbers numbers = code.evaluate(place);
    const glm::dvec3 shaded(numbers[0], numbers[1], numbers[2]);
    return isFinite(shaded) ? glm::max(shaded, glm::dvec3(0.0)) : glm::dvec3(0.0);
}

} // namespace

Result<LobeModel> LobeModel::create(const Catalog& catalog, const Material& material,
                                    LobeTerm term) {
    const Result<EvalCase> request = sweepVariant(catalog, material);
    if (!request) {
        return tl::unexpected(request.error());
    }
    const Block& block = *request->block.block;
    if (term != LobeTerm::Whole && !hasTerms(block)) {
        return failure(fmt::format("{} does not add a highlight to a diffuse term", block.label));
    }
    const Result<ReferenceCode> code = ReferenceCode::find(*request);
    if (!code) {
        return tl::unexpected(code.error());
    }
    LobeModel model;
    model.isIsotropic_ = block.hasClaim("isotropic");
    model.code_ =
        compiledCase(*code, term == LobeTerm::Highlight ? highlightOf(*request) : *request);
    if (term == LobeTerm::Diffuse) {
        model.subtracted_ = compiledCase(*code, highlightOf(*request));
    }
    return model;
}

glm::dvec3 LobeModel::value(const glm::dvec3& l, const glm::dvec3& v) const {
    EvalPlace place;
    place.l = l;
    place.v = v;
    const glm::dvec3 whole = shadedValue(*code_, place);
    return subtracted_ == nullptr
               ? whole
               : glm::max(whole - shadedValue(*subtracted_, place), glm::dvec3(0.0));
}

glm::dvec3 LobeModel::reflectance(const glm::dvec3& l, const glm::dvec3& v) const {
    if (!(l.z > 0.0)) {
        return glm::dvec3(0.0);
    }
    const glm::dvec3 f = value(l, v) / (std::numbers::pi * l.z);
    return isFinite(f) ? f : glm::dvec3(0.0);
}

std::string whyNoReflectance(const Block& model) {
    return model.lighting == LightsWanted::Key
               ? fmt::format("{} draws tones, which are no share of the light", model.label)
               : std::string();
}

bool hasTerms(const Block& model) {
    return model.withRole(roles::diffuse) != nullptr;
}

Material atExactLevels(const Material& material) {
    Material exact = material;
    exact.accuracy.clear();
    return exact;
}

} // namespace patina
