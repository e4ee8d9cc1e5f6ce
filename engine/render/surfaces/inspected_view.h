// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace patina {

/// Names what a view shows in place of the picture. The numbers are those of
/// shaders/passes/inspection.glsl.
enum class InspectedView {
    Numbers,     ///< the numerical check: grey, with patterns where a number is wrong
    Energy,      ///< the share of a white sky that is sent to the viewer, red where it is above 1
    Normals,     ///< of shading, in world space, as colours
    Tangents,    ///< the same of the tangents
    Diffuse,     ///< light of the lamps by the diffuse term alone
    Highlight,   ///< light of the lamps by the highlight alone
    Coordinates, ///< of images: u as red, v as green, each from 0 to 1 again and again, over a
                 ///< checker
    Fresnel,     ///< the share that the Fresnel term reflects at the viewer's angle
    Light,       ///< light of one lamp alone, as the model returned it
    Occlusion,   ///< the share of its surroundings that a place sees past its own object
    Glow,        ///< the light that a surface sends out by itself
    Opacity      ///< the share of what is behind it that a surface hides
};

/// Says what a view shows in place of the picture.
struct Inspected {
    InspectedView view = InspectedView::Numbers;
    std::size_t light = 0; ///< is the scene's light that InspectedView::Light shows

    Inspected() = default;
    Inspected(InspectedView of, std::size_t lamp = 0) : view(of), light(lamp) {}

    friend bool operator==(const Inspected&, const Inspected&) = default;
};

} // namespace patina
