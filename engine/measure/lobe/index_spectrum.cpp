// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/index_spectrum.h"

#include <algorithm>
#include <array>
#include <functional>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "catalog/fills.h"
#include "catalog/index_trend.h"
#include "catalog/spectrum.h"
#include "catalog/wavelengths.h"
#include "measure/lobe/fresnel_block.h"
#include "shading/program/compiled_block.h"

namespace patina {
namespace {

constexpr double shortestNm = 380.0; ///< nm
constexpr double longestNm = 780.0;  ///< nm
constexpr double stepNm = 2.5;       ///< nm

/// Stands for red, green and blue in terms without wavelengths, in nm: where the constants of
/// metals were read, and those of lib/interface.glsl.
constexpr glm::dvec3 usualChannels{650.0, 550.0, 450.0};

/// Is the index and the extinction at one wavelength.
struct OpticalConstants {
    double index = 1.0;
    double extinction = 0.0;
};
using ConstantsAt = std::function<OpticalConstants(double nm)>;

/// Returns what goes straight from one channel's value to the next, and is even beyond them.
double betweenChannels(const glm::dvec3& channels, const glm::dvec3& values, double nm) {
    std::array<int, 3> order{0, 1, 2};
    std::ranges::sort(order, {}, [&channels](int i) { return channels[i]; });
    if (nm <= channels[order[0]]) {
        return values[order[0]];
    }
    for (std::size_t i = 1; i < order.size(); ++i) {
        const double from = channels[order[i - 1]];
        const double to = channels[order[i]];
        if (nm <= to) {
            const double share = to > from ? (nm - from) / (to - from) : 1.0;
            return glm::mix(values[order[i - 1]], values[order[i]], share);
        }
    }
    return values[order[2]];
}

/// Returns the block with other wavelengths in its channels.
ValuedBlock atWavelengths(const ValuedBlock& fresnel, const glm::dvec3& nm) {
    ValuedBlock moved = fresnel;
    if (const Parameter* parameter = fresnel.block->withRole(roles::wavelengths)) {
        moved.values[parameter->id] = nm;
    }
    return moved;
}

/// Returns the index over the wavelength of a clear body whose colours bend apart: Cauchy's two
/// terms through those that lib/interface.glsl has for red and blue. Nothing where they do not.
std::optional<ConstantsAt> dispersedBody(const Catalog& catalog, const Material& material,
                                         double outside, double inside) {
    const BlockValues* part = material.part(kinds::refraction);
    const Block* block = part == nullptr ? nullptr : catalog.find(kinds::refraction, part->id);
    const double dispersion =
        block == nullptr
            ? 0.0
            : ValuedBlock{block, part->parameters}.number(roles::dispersion).value_or(0.0);
    if (dispersion == 0.0) {
        return std::nullopt;
    }
    const std::array<double, 2> arguments{inside / outside, dispersion};
    glm::dvec3 indices(0.0);
    reference::findFunction("dispersedIndices")->call(arguments.data(), &indices.x);
    const auto inverseSquare = [](double nm) { return 1.0 / (nm * nm); };
    const double red = inverseSquare(usualChannels.x);
    const double slope = (indices.z - indices.x) / (inverseSquare(usualChannels.z) - red);
    return [=](double nm) {
        return OpticalConstants{outside * (indices.x + slope * (inverseSquare(nm) - red)), 0.0};
    };
}

/// Returns the constants that a choice of the block has by the wavelength; nothing where it has
/// none.
std::optional<ConstantsAt> measuredConstants(const ValuedBlock& fresnel) {
    for (const Parameter& parameter : fresnel.block->parameters) {
        const EnumValue* choice = spectralChoice(parameter, fresnel.values);
        const auto spectrum = [&](std::string_view role) -> const NumberList* {
            const Parameter* filled = fresnel.block->withRole(role);
            if (choice == nullptr || filled == nullptr || !choice->fills.contains(filled->id)) {
                return nullptr;
            }
            return spectrumIn(choice->fills.at(filled->id));
        };
        const NumberList* index = spectrum(roles::index);
        const NumberList* extinction = spectrum(roles::extinction);
        if (index != nullptr && extinction != nullptr) {
            return [index = *index, extinction = *extinction](double nm) {
                const glm::dvec3 all(nm);
                return OpticalConstants{atWavelengths(index, all).x,
                                        atWavelengths(extinction, all).x};
            };
        }
    }
    return std::nullopt;
}

/// Returns the constants of the medium below the surface; an error where the term knows none.
Result<ConstantsAt> constantsOf(const Catalog& catalog, const Material& material,
                                const ValuedBlock& fresnel, IndexSpectrum& spectrum) {
    if (workedOutIndices(fresnel)) {
        return [fresnel](double nm) {
            return OpticalConstants{workedOutIndices(atWavelengths(fresnel, glm::dvec3(nm)))->x,
                                    0.0};
        };
    }
    if (const auto measured = measuredConstants(fresnel)) {
        spectrum.channels = srgbWavelengths;
        return *measured;
    }
    if (const auto measured = fresnel.number(roles::indexInside)) {
        const double inside = indexAtTemperature(*fresnel.block, fresnel.values, *measured);
        const double outside = fresnel.number(roles::indexOutside).value_or(1.0);
        return dispersedBody(catalog, material, outside, inside).value_or([inside](double) {
            return OpticalConstants{inside, 0.0};
        });
    }
    const auto index = fresnel.vector(roles::index);
    if (!index) {
        return failure(fmt::format("{} knows no index of refraction", fresnel.block->label),
                       "a Fresnel term by an index");
    }
    const glm::dvec3 extinction = fresnel.vector(roles::extinction).value_or(glm::dvec3(0.0));
    const glm::dvec3 channels = spectrum.channels;
    spectrum.isOfChannels =
        *index != glm::dvec3(index->x) || extinction != glm::dvec3(extinction.x);
    return [=, index = *index](double nm) {
        return OpticalConstants{betweenChannels(channels, index, nm),
                                betweenChannels(channels, extinction, nm)};
    };
}

/// Returns the wavelengths of a spectrum: even steps and the channels', or these alone.
std::vector<double> wavelengthsOf(const glm::dvec3& channels, bool areChannelsAlone) {
    std::vector<double> all{channels.x, channels.y, channels.z};
    const double first = std::min(shortestNm, *std::ranges::min_element(all));
    const double last = std::max(longestNm, *std::ranges::max_element(all));
    constexpr int steps = static_cast<int>((longestNm - shortestNm) / stepNm);
    for (int i = 0; i <= steps && !areChannelsAlone; ++i) {
        all.push_back(first + (last - first) * i / steps);
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

} // namespace

Result<IndexSpectrum> indexSpectrum(const Catalog& catalog, const Material& material) {
    const Result<ValuedBlock> fresnel = fresnelBlock(catalog, material);
    if (!fresnel) {
        return tl::unexpected(fresnel.error());
    }
    const auto code = compiledBlock(*fresnel->block);
    if (!code) {
        return tl::unexpected(code.error());
    }
    IndexSpectrum spectrum;
    const Parameter* own = fresnel->block->withRole(roles::wavelengths);
    spectrum.channels = fresnel->vector(roles::wavelengths).value_or(usualChannels);
    if (own != nullptr) {
        takeWavelengths(*own, srgbWavelengths, &spectrum.channels.x);
    }
    const Result<ConstantsAt> constants = constantsOf(catalog, material, *fresnel, spectrum);
    if (!constants) {
        return tl::unexpected(constants.error());
    }
    spectrum.wavelengths =
        wavelengthsOf(spectrum.channels, spectrum.isOfChannels && own == nullptr);
    bool isClear = true;
    for (const double nm : spectrum.wavelengths) {
        const OpticalConstants at = (*constants)(nm);
        spectrum.index.push_back(at.index);
        spectrum.extinction.push_back(at.extinction);
        isClear = isClear && at.extinction == 0.0;
        ValuedBlock here = atWavelengths(*fresnel, glm::dvec3(nm));
        for (const auto& [role, value] :
             {std::pair{roles::index, at.index}, std::pair{roles::extinction, at.extinction}}) {
            if (const Parameter* parameter = fresnel->block->withRole(role)) {
                here.values[parameter->id] = glm::dvec3(value);
            }
        }
        spectrum.reflectance.push_back(
            (*code)->fresnel(1.0, 0.0, packed(*here.block, here.values, material.accuracy)).x);
    }
    if (isClear) {
        spectrum.extinction.clear();
    }
    return spectrum;
}

} // namespace patina
