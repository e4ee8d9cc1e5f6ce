// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/refraction_packer.h"

#include "catalog/wavelengths.h"
#include "shading/effects/body_index.h"
#include "shading/effects/refracted_wavelengths.h"
#include "shading/program/parameter_packer.h"
#include "shading/program/storable.h"

namespace patina {
namespace {

/// Puts the body's index for each wavelength in the place of that.
void packIndices(std::span<glm::vec4> wavelengths, const BodyIndex& index,
                 const glm::dvec3& ofScene) {
    for (glm::vec4& each : wavelengths) {
        each.w = static_cast<float>(index.at(movedWavelength(double(each.w), ofScene)));
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
    const BodyIndex index(material, choice, *pipeline.catalog, scene.wavelengths);
    const auto put = [&](std::string_view role, double number) {
        if (const ParameterField* field = place.layout.withRole(role)) {
            own[field->offset / 4][static_cast<int>(field->offset % 4)] =
                static_cast<float>(number);
        }
    };
    put(roles::index, index.ofBlock());
    put(roles::dispersion, index.dispersion());
    out[static_cast<std::size_t>(pipeline.object.refractionBackground())] =
        storable(scene.background);
    if (const auto wavelengths = wavelengthPlace(pipeline.object)) {
        packIndices(out.subspan(static_cast<std::size_t>(wavelengths->first),
                                static_cast<std::size_t>(wavelengths->count)),
                    index, scene.wavelengths);
    }
}

} // namespace patina
