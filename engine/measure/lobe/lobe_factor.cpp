// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/lobe_factor.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/vectors.h"
#include "measure/eval/reference_case.h"
#include "measure/stability/sweep_cases.h"

namespace patina {
namespace {

constexpr LobeTerm factorTerms[] = {LobeTerm::Distribution, LobeTerm::Masking, LobeTerm::Fresnel};

/// Returns how the function of a term ends; empty for the Fresnel factor.
std::string_view suffixOf(LobeTerm term) {
    return term == LobeTerm::Distribution ? reference::factorSuffixes[0]
           : term == LobeTerm::Masking    ? reference::factorSuffixes[1]
                                          : std::string_view();
}

/// Is a Fresnel block that reflects the same share at every angle, to find what a model does with
/// its slot.
reference::Block evenFresnel() {
    static constexpr reference::BlockCall calls[] = {
        {"", 2, 3, [](const double*, double* results, reference::Parameters share) {
             std::fill_n(results, 3, share[0]);
         }}};
    reference::Block block;
    block.kind = kinds::fresnel;
    block.size = 1;
    block.calls = calls;
    return block;
}

reference::Geometry geometryBetween(const glm::dvec3& l, const glm::dvec3& v) {
    reference::Geometry geometry;
    geometry.l = l;
    geometry.v = v;
    return geometry;
}

/// Lists directions at which a narrow lobe, too, has a value that can be divided by, with all
/// cosines different.
constexpr glm::dvec3 probes[][2] = {
    {{0.6, 0.0, 0.8}, {-0.55, 0.1, 0.82915619758885}},
    {{0.28, 0.0, 0.96}, {-0.1, 0.05, 0.99373034571758}},
    {{0.936, 0.0, 0.352}, {-0.7, 0.2, 0.68556546004010}},
};

} // namespace

Result<LobeFactor> LobeFactor::create(const Catalog& catalog, const Material& material,
                                      LobeTerm term) {
    const Result<EvalCase> request = sweepVariant(catalog, material);
    if (!request) {
        return tl::unexpected(request.error());
    }
    const auto code = ReferenceCode::find(*request);
    if (!code) {
        return tl::unexpected(code.error());
    }
    const std::string& label = request->block.block->label;
    LobeFactor factor;
    factor.block_ = code->block;
    factor.slot_ = code->slot;
    factor.values_ = request->block.packedValues();
    if (code->slot != nullptr) {
        factor.slotValues_ = request->slot.packedValues();
    }
    if (term == LobeTerm::Fresnel) {
        factor.name_ = "Fresnel";
        if (code->slot == nullptr || code->slot->kind != kinds::fresnel) {
            return failure(fmt::format("the highlight of {} has no Fresnel factor", label));
        }
        const auto cosine = factor.findCosine(*request);
        if (!cosine) {
            return tl::unexpected(cosine.error());
        }
        factor.cosine_ = *cosine;
        return factor;
    }
    factor.name_ = term == LobeTerm::Masking ? "masking" : "distribution";
    factor.factor_ = isFactor(term) ? code->block->findFactor(suffixOf(term)) : nullptr;
    if (factor.factor_ == nullptr) {
        return failure(fmt::format("{} does not tell a {} apart", label, factor.name_));
    }
    return factor;
}

/// Compares the share of the model's highlight that its slot leaves, of that with an even slot of
/// 1, with the slot's reflectance at each cosine.
Result<LobeFactor::Cosine> LobeFactor::findCosine(const EvalCase& request) const {
    constexpr double tolerance = 1e-6;
    const EvalCase highlight = withoutDiffuse(request);
    const std::vector<double> values = highlight.block.packedValues();
    const reference::Block even = evenFresnel();
    const std::array<double, 1> one{1.0};
    const reference::Filler fillers[] = {{&even, one}, {slot_, slotValues_}};
    for (const Cosine cosine : {Cosine::Half, Cosine::Light, Cosine::View}) {
        bool isIt = true;
        for (const auto& [l, v] : probes) {
            const reference::Geometry geometry = geometryBetween(l, v);
            const glm::dvec3 whole = modelValue(*block_, geometry, values, {&fillers[0], 1});
            const glm::dvec3 left = modelValue(*block_, geometry, values, {&fillers[1], 1});
            const glm::dvec3 off = glm::abs(left - whole * fresnelAt(cosine, l, v));
            isIt = isIt && std::max({off.x, off.y, off.z}) <=
                               tolerance * std::max({whole.x, whole.y, whole.z});
        }
        if (isIt) {
            return cosine;
        }
    }
    return failure(fmt::format("the highlight of {} is no product with its Fresnel term",
                               request.block.block->label));
}

glm::dvec3 LobeFactor::fresnelAt(Cosine cosine, const glm::dvec3& l, const glm::dvec3& v) const {
    const glm::dvec3 n(0.0, 0.0, 1.0);
    const glm::dvec3 sum = l + v;
    const double length = glm::length(sum);
    const glm::dvec3 half = length > 0.0 ? sum / length : n;
    const glm::dvec3& a = cosine == Cosine::View ? v : l;
    const glm::dvec3& b = cosine == Cosine::Half ? half : n;
    const glm::dvec3 apart = a - b;
    return slot_->fresnel(std::clamp(glm::dot(a, b), 0.0, 1.0),
                          std::min(0.5 * glm::dot(apart, apart), 1.0), slotValues_);
}

glm::dvec3 LobeFactor::at(const glm::dvec3& l, const glm::dvec3& v) const {
    glm::dvec3 value(0.0);
    if (factor_ != nullptr) {
        const reference::Filler filler{slot_, slotValues_};
        const reference::Fillers fillers(&filler, slot_ != nullptr ? 1 : 0);
        value = factor_->call(geometryBetween(l, v), values_, fillers);
    } else {
        value = fresnelAt(cosine_, l, v);
    }
    return isFinite(value) ? value : glm::dvec3(0.0);
}

std::vector<LobeTerm> factorsOf(const Catalog& catalog, const Material& material) {
    std::vector<LobeTerm> found;
    for (const LobeTerm term : factorTerms) {
        if (LobeFactor::create(catalog, material, term)) {
            found.push_back(term);
        }
    }
    return found;
}

} // namespace patina
