// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shading/effects/effect_parts.h"

namespace patina {

/// Holds what the scene's picture accuracy changes in programs, where nothing stands against it.
struct PictureEffect {
    bool wantsVertexLight = false;
    bool wantsBlendedNormals = false;
    bool wantsWideHighlights = false;

    bool lightsAtVertices = false; ///< the model is asked there and its light blended
    bool leavesNormals = false;    ///< as short as blending those of the vertices makes them
    bool widensHighlights = false; ///< by what the surface turns within a pixel

    void choose(const SceneSubject& subject, const EffectSet& set);
    void adjust(const EffectSet& set);
    void addTo(ChoiceHash& hash) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;

    friend bool operator==(const PictureEffect&, const PictureEffect&) = default;
};

/// Tells whether a model draws marks on the picture, which is known by a parameter in pixels.
bool drawsMarks(const Block& model);

} // namespace patina
