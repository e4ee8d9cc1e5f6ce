// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

#include <boost/container/small_vector.hpp>

#include "core/error.h"
#include "shading/effects/effect_parts.h"
#include "shading/program/program_source.h"

namespace patina {

struct DisplaySet;

/// Is a pass over the picture that is drawn.
struct PassUse {
    BlockUse use;
    std::size_t place; ///< is its index in Scene::passes

    friend bool operator==(const PassUse&, const PassUse&) = default;
};

/// Holds the passes over the finished picture in the scene's order, without those that do nothing.
struct PassesEffect {
    boost::container::small_vector<PassUse, 4> passes;

    void choose(const Scene& scene, const Catalog& catalog);
    void addTo(ChoiceHash& hash) const;
    void list(EffectListing& listing, const DisplaySet& set) const;
    void listMissing(LeftOutListing& listing, const DisplaySet& set) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    bool readSurfaces() const;

    friend bool operator==(const PassesEffect&, const PassesEffect&) = default;
};

/// Returns the program of one stage of a pass, which draws what the stage's function returns, or,
/// where `stage` is empty, of its result. It reads `pictureImage`, `stageImage`, where the block
/// reads surfaces `normalImage` and `depthImage`, and the block's values, `passData`.
Checked<ProgramSource> pictureProgram(const BlockUse& pass, std::string_view stage,
                                      const Catalog& catalog);

/// Returns the program that draws the normal, depth and number of surfaces for passes. It reads
/// `worldToCamera` and `objectNumber`.
Checked<ProgramSource> pictureSurfacesProgram(const Catalog& catalog);

/// Returns a program that calls all functions of a pass, by which its text is tried.
Checked<ProgramSource> pictureTrialProgram(const BlockUse& pass, const Catalog& catalog);

} // namespace patina
