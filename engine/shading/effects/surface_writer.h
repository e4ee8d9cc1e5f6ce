// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/texture_writer.h"
#include "shading/glsl/source_builder.h"
#include "shading/program/block_source.h"
#include "shading/program/surface_output.h"

namespace patina {

/// Writes the fragment stage that draws surfaces: each effect adds its declarations, then its
/// statement in main. Nothing is written for an effect that is not in the set, and nothing of the
/// inspection into the program of a picture.
class SurfaceWriter {
  public:
    SurfaceWriter(SourceBuilder& out, const EffectSet& set, const ObjectLayout& object,
                  const SceneLayout& scene);

    void write(SurfaceOutput output = SurfaceOutput::Picture);

    /// Writes instead what the vertex stage works out for a picture behind
    /// passes/surface.vert, and returns the statements of its main.
    std::string writeVertices(int sceneVec4s);

  private:
    void writeSurface();
    void writeAlbedoTable();
    void writeTables();
    void writeFrame();
    void writeSlots();
    void writeModel();
    void writeLights();
    void writeLightGroup(std::size_t index);
    void addLightGroup(std::size_t index, const std::string& function);
    void writeShadowCode();
    void writeShadow(std::size_t index);
    bool hasShadows() const;
    bool isLitFromBehind() const;
    void writeAmbient();
    std::string ambientShare();
    std::string hemisphereSource() const;
    void writeHemisphere();
    void writeEnvironment();
    void writeKeptShare();
    void writeEmission();
    void writeBlend();
    void writeFog();
    void writeOpacity();
    void writeDistance();
    void writeRefraction();
    void writeLayer();
    void writeFogBlock();
    void writeWideHighlights();
    void writeBlendedLight();
    std::string writeVertexFog();
    std::string writeVertexLight();
    bool isPicture() const;
    bool lightsAtVertices() const { return isPicture() && set_.lightsAtVertices; }
    bool leavesNormals() const { return isPicture() && set_.leavesNormals; }
    bool fogsAtVertices() const { return isPicture() && set_.scene.fogsAtVertices; }
    void writeGround();
    void addToGround(const std::string& light);
    void writeMain();
    void writeBlock(const Block& block, std::span<const CompiledValue> compiled = {});
    void writeUnpack(const Block& block, const BlockUse& use, const std::string& function);
    void readFrom(const std::string& array);
    bool isInspected() const { return output_ == SurfaceOutput::Inspection; }
    void writeBuffer();
    void writeSamples();
    void writeShares();
    void noteValues(std::string_view kind, const std::string& variable);
    void noteTerm(const std::string& term, const std::string& value, const std::string& detail);

    SourceBuilder& out_;
    const EffectSet& set_;
    const ObjectLayout& object_;
    const SceneLayout& scene_;
    TextureWriter textures_;
    SurfaceOutput output_ = SurfaceOutput::Picture;
    std::vector<const Block*> written_;
    std::vector<SlotFill> filled_;
    std::string main_;
    int nextLine_ = 0; ///< in `sceneData`: the values of the next light that has a line
    std::string last_; ///< behind everything else in main
    std::string alpha_ = "1.0";
    std::string stored_ = "shaded";
    std::string store_ = "store({}, {})"; ///< the colour, the opacity
};

} // namespace patina
