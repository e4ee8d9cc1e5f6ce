// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Names what a view shows in place of the picture. The numbers are those of
/// shaders/passes/inspection.glsl.
enum class InspectedView {
    Numbers,  ///< the numerical check: grey, with patterns where a number is wrong
    Energy,   ///< the share of a white sky that is sent to the viewer, red where it is above 1
    Normals,  ///< of shading, in world space, as colours
    Tangents, ///< the same of the tangents
    Diffuse,  ///< light of the lamps by the diffuse term alone
    Highlight ///< light of the lamps by the highlight alone
};

} // namespace patina
