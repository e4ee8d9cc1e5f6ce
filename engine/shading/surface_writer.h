// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "shading/block_source.h"
#include "shading/data_layout.h"
#include "shading/effect_set.h"
#include "shading/source_builder.h"

namespace patina {

/// Writes the fragment stage that draws surfaces: each effect adds its declarations, then its
/// statement in main. Nothing is written for an effect that is not in the set.
class SurfaceWriter {
  public:
    SurfaceWriter(SourceBuilder& out, const EffectSet& set, const ObjectLayout& object,
                  const SceneLayout& scene);

    void write();

  private:
    void writeFrame();
    void writeSlots();
    void writeModel();
    void writeLights();
    void writeLightGroup(std::size_t index);
    void writeAmbient();
    void writeEmission();
    void writeBlend();
    void writeFog();
    void writeOpacity();
    void writeMain();
    void writeBlock(const Block& block);
    void writeUnpack(const Block& block, const BlockUse& use, const std::string& function);
    void readFrom(const std::string& array);

    SourceBuilder& out_;
    const EffectSet& set_;
    const ObjectLayout& object_;
    const SceneLayout& scene_;
    std::vector<const Block*> written_;
    std::vector<SlotFill> filled_;
    std::string main_;
    std::string alpha_ = "1.0";
};

} // namespace patina
