// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/refraction_packer.h"

#include <algorithm>
#include <cmath>

#include "catalog/wavelengths.h"
#include "shading/effects/refracted_wavelengths.h"
#include "shading/effects/refraction.h"
#include "shading/program/given_value.h"
#include "shading/program/parameter_packer.h"
#include "shading/program/storable.h"

namespace patina {
namespace {

double dispersionOf(const RefractionChoice& choice) {
    const Parameter* parameter = choice.block->withRole(roles::dispersion);
    const auto* number = parameter == nullptr ? nullptr
                                              : std::get_if<double>(&givenValue(*parameter,
                                                                                *choice.values));
    return number != nullptr && std::isfinite(*number)
               ? std::clamp(*number, parameter->min, parameter->max)
               : 0.0;
}

/// Puts the body's index for each wavelength in the place of that.
void packIndices(std::span<glm::vec4> wavelengths, double index, double dispersion,
                 const glm::dvec3& ofScene) {
    for (glm::vec4& each : wavelengths) {
        const double wavelength = movedWavelength(double(each.w), ofScene);
        each.w = static_cast<float>(indexAt(wavelength, index, dispersion));
    }
}

} // namespace

void packRefraction(std::span<glm::vec4> out, const Pipeline& pipeline, const Material& material,
                    const Scene& scene) {
    static const Values none;
    const BlockPlace& place = *pipeline.object.refraction;
    const BlockValues* part = material.part(place.block->kind);
    const bool isPart = part != nullptr && part->id == place.block->id;
    const RefractionChoice choice{place.block, isPart ? &part->parameters : &none, ""};
    const std::span<glm::vec4> own = out.subspan(static_cast<std::size_t>(place.first));
    packInto(own, place.layout, *choice.values, material.accuracy, glm::dmat4(1.0));
    for (const ParameterField& field : place.layout.fields) {
        if (field.parameter != nullptr && field.parameter->role == roles::index) {
            own[field.offset / 4][static_cast<int>(field.offset % 4)] =
                static_cast<float>(bodyIndex(material, choice, *pipeline.catalog));
        }
    }
    out[static_cast<std::size_t>(pipeline.object.refractionBackground())] =
        storable(scene.background);
    if (const auto wavelengths = wavelengthPlace(pipeline.object)) {
        packIndices(out.subspan(static_cast<std::size_t>(wavelengths->first),
                                static_cast<std::size_t>(wavelengths->count)),
                    bodyIndex(material, choice, *pipeline.catalog), dispersionOf(choice),
                    scene.wavelengths);
    }
}

} // namespace patina
