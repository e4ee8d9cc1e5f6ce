// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "catalog/block.h"

namespace patina {

/// Tells what a program writes that is assembled from a set of effects.
enum class SurfaceOutput {
    Picture, ///< writes the light that the surface sends to the viewer
    /// Writes the luminance, what is wrong with its numbers, and the numbers themselves.
    Inspection,
    Buffer, ///< writes the inputs of shading: position, directions, what images and shadows give
    Tables, ///< writes the tables of the blocks, in one atlas
    LobeSamples, ///< samples the model's reflectance, to which lobes are fitted
    /// Writes the model's albedo by the viewer's direction, without mesh, lights or fog.
    AlbedoTable,
};

/// Tells whether such programs draw no mesh but cover a target of their own.
inline bool isTable(SurfaceOutput output) {
    return output == SurfaceOutput::AlbedoTable || output == SurfaceOutput::Tables ||
           output == SurfaceOutput::LobeSamples;
}

/// Says how finely a table of albedos samples directions.
struct AlbedoTableShape {
    glm::ivec2 size{24, 16}; ///< counts square roots of n.v, and azimuths of the viewer
    int sectors = 48;        ///< counts light directions in each ring around the mirror direction

    friend bool operator==(const AlbedoTableShape&, const AlbedoTableShape&) = default;
};

/// Returns the shape for a model. One that claims to be isotropic has one azimuth and needs fewer
/// directions.
AlbedoTableShape albedoTableShape(const Block& model);

/// Says how finely a model's reflectance is sampled for fitting lobes; passes/lobe_directions.glsl
/// uses the same numbers.
struct LobeTableShape {
    int viewers = 16;  ///< counts square roots of n.v
    int azimuths = 16; ///< counts azimuths of the viewer
    int sectors = 16;  ///< counts light directions in each ring around the mirror direction

    static constexpr int rings = 44;
    /// Is the width of the target of fits, which fill it row by row.
    static constexpr int fittedWidth = 8;
    static constexpr int steps = 8; ///< counts the table's steps from one viewer to the next

    glm::ivec2 fitted() const { return {fittedWidth, viewers * azimuths / fittedWidth}; }
    glm::ivec2 table() const {
        return {(viewers - 1) * steps + 1, azimuths > 1 ? azimuths * steps : 1};
    }
    /// Must agree with what lobe_fit.glsl writes.
    int layers() const { return azimuths > 1 ? 5 : 4; }
    glm::ivec2 samples() const { return {rings * sectors, viewers * azimuths}; }

    friend bool operator==(const LobeTableShape&, const LobeTableShape&) = default;
};
LobeTableShape lobeTableShape(const Block& model);

} // namespace patina
