// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/lobe_model.h"

#include <algorithm>
#include <iterator>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "core/vectors.h"
#include "measure/stability/sweep_cases.h"

namespace patina {
namespace {

constexpr std::pair<LobeTerm, std::string_view> termWords[] = {
    {LobeTerm::Whole, "whole"},         {LobeTerm::Diffuse, "diffuse"},
    {LobeTerm::Highlight, "highlight"}, {LobeTerm::Distribution, "distribution"},
    {LobeTerm::Masking, "masking"},     {LobeTerm::Fresnel, "fresnel"}};

} // namespace

std::string_view wordOf(LobeTerm term) {
    return std::ranges::find(termWords, term, &std::pair<LobeTerm, std::string_view>::first)
        ->second;
}

std::optional<LobeTerm> lobeTermOf(std::string_view word) {
    const auto found =
        std::ranges::find(termWords, word, &std::pair<LobeTerm, std::string_view>::second);
    return found == std::end(termWords) ? std::nullopt : std::optional(found->first);
}

Result<LobeModel> LobeModel::create(const Catalog& catalog, const Material& material,
                                    LobeTerm term) {
    if (isFactor(term)) {
        return failure("a factor of the highlight is no reflectance", "a polar plot of it");
    }
    const Result<EvalCase> request = sweepVariant(catalog, material);
    if (!request) {
        return tl::unexpected(request.error());
    }
    const Block& block = *request->block.block;
    if (term != LobeTerm::Whole && !hasTerms(block)) {
        return failure(fmt::format("{} does not add a highlight to a diffuse term", block.label));
    }
    const EvalCase looked = term == LobeTerm::Highlight ? withoutDiffuse(*request) : *request;
    Result<ModelValues> values = ModelValues::of(looked, catalog);
    if (!values) {
        return tl::unexpected(values.error());
    }
    LobeModel model(block, std::move(*values));
    model.isIsotropic_ = block.hasClaim("isotropic");
    if (term == LobeTerm::Diffuse) {
        model.subtracted_ = model.values_.with(withoutDiffuse(*request));
    }
    return model;
}

Result<void> LobeModel::ending() const {
    return values_.isEndless() ? tl::unexpected(endlessError(*block_)) : Result<void>();
}

glm::dvec3 LobeModel::value(const glm::dvec3& l, const glm::dvec3& v) const {
    const glm::dvec3 whole = values_.at({l, v});
    return subtracted_ ? glm::max(whole - subtracted_->at({l, v}), glm::dvec3(0.0)) : whole;
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

Result<LobeModel> reflectanceModel(const Catalog& catalog, const Material& material,
                                   LobeTerm term) {
    const Block* block = catalog.find(kinds::models, material.model.id);
    if (block != nullptr && !whyNoPlots(*block).empty()) {
        return failure(whyNoPlots(*block), "a model of a reflectance");
    }
    return LobeModel::create(catalog, material, term);
}

std::string whyNoPlots(const Block& model) {
    const std::string why = whyNoReflectance(model);
    return why.empty() ? why
                       : why + ": its lobe, in the plane of incidence or in 3D, its albedo, the "
                               "slice over half angles and the errors of single precision and "
                               "of 16 bits mean nothing";
}

bool hasTerms(const Block& model) {
    return model.withRole(roles::diffuse) != nullptr;
}

EvalCase withoutDiffuse(const EvalCase& request) {
    EvalCase alone = request;
    for (const Parameter& parameter : request.block.block->parameters) {
        if (parameter.role == roles::diffuse) {
            alone.block.values[parameter.id] = glm::dvec3(0.0);
        }
    }
    return alone;
}

Material atExactLevels(const Material& material) {
    Material exact = material;
    exact.accuracy.clear();
    return exact;
}

} // namespace patina
