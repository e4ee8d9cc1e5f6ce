// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "catalog/block.h"

namespace patina {

/// Tells what a program writes that is made from a set of effects.
enum class SurfaceOutput {
    Picture,     ///< the light that the surface sends to the viewer
    Inspection,  ///< its luminance, what is wrong with its numbers, and the numbers themselves
    Buffer,      ///< what it is shaded from: place, directions, what images and shadows give it
    Tables,      ///< what blocks read in place of computing: an atlas of their tables
    LobeSamples, ///< what the model reflects, to be taken apart into lobes
    AlbedoTable, ///< the model's albedo by the viewer's direction, without mesh, lights or fog
};

/// Tells whether such programs draw no mesh but cover a target of their own.
inline bool isTable(SurfaceOutput output) {
    return output == SurfaceOutput::AlbedoTable || output == SurfaceOutput::Tables ||
           output == SurfaceOutput::LobeSamples;
}

/// Says how finely a table of albedos is made.
struct AlbedoTableShape {
    glm::ivec2 size{24, 16}; ///< roots of n.v, azimuths of the viewer
    int sectors = 48;        ///< directions of light in each ring around the mirror direction

    friend bool operator==(const AlbedoTableShape&, const AlbedoTableShape&) = default;
};

/// A model that claims to be isotropic has one azimuth and needs fewer directions.
AlbedoTableShape albedoTableShape(const Block& model);

/// Says how finely a model's reflectance is taken apart into lobes, as passes/lobe_directions.glsl
/// has it.
struct LobeTableShape {
    int viewers = 16;  ///< roots of n.v
    int azimuths = 16; ///< of the viewer
    int sectors = 16;  ///< directions of light in each ring around the mirror direction

    static constexpr int rings = 44;
    static constexpr int fittedWidth = 8; ///< of the target of fits, which stand row by row in it
    static constexpr int steps = 8;       ///< of the table from one viewer to the next

    glm::ivec2 fitted() const { return {fittedWidth, viewers * azimuths / fittedWidth}; }
    glm::ivec2 table() const {
        return {(viewers - 1) * steps + 1, azimuths > 1 ? azimuths * steps : 1};
    }
    int layers() const { return azimuths > 1 ? 5 : 4; } ///< as lobe_fit.glsl writes them
    glm::ivec2 samples() const { return {rings * sectors, viewers * azimuths}; }

    friend bool operator==(const LobeTableShape&, const LobeTableShape&) = default;
};
LobeTableShape lobeTableShape(const Block& model);

} // namespace patina
