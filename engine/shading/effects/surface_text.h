// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/texture_writer.h"
#include "shading/program/block_source.h"
#include "shading/program/source_builder.h"
#include "shading/program/surface_output.h"

namespace patina {

/// Holds the text of a stage that draws surfaces, while the effects write it: each adds its
/// declarations to `out`, then its statement to `main`.
class SurfaceText {
  public:
    SurfaceText(SourceBuilder& stage, const EffectSet& effects, const ObjectLayout& objectLayout,
                const SceneLayout& sceneLayout, SurfaceOutput written = SurfaceOutput::Picture)
        : out(stage), set(effects), object(objectLayout), scene(sceneLayout), output(written),
          textures(effects, objectLayout) {}

    SourceBuilder& out;
    const EffectSet& set;
    const ObjectLayout& object;
    const SceneLayout& scene;
    const SurfaceOutput output;
    const TextureWriter textures;

    bool isOfFins = false;     ///< it draws strips on edges, with strands in place of a surface
    bool isOfMarks = false;    ///< it draws the marks of strokes, each lit as its point is
    std::string main;          ///< statements: `s` is the Surface, `shaded` the light so far
    std::string last;          ///< behind everything else in main
    std::string alpha = "1.0"; ///< an expression for the share that hides what is behind
    std::string stored = "shaded";
    std::string store = "store({}, {})"; ///< the colour, the opacity
    std::vector<SlotFill> filled;        ///< the model's slots

    /// Says what becomes of light from all around before it meets the surface.
    struct LightFromAround {
        std::string surface = "s";    ///< an expression for the surface that ambient light falls on
        std::string factor{};         ///< of ambient light, with its operator
        std::string directionsFile{}; ///< defines the macros of addOpenDirections()
    };
    LightFromAround around;

    /// Is a factor, with its operator, of light whose reflectance comes from a table of the model.
    std::string unasked;

    /// The inspection looks at values one by one, and nothing of it is in a picture's text.
    bool isInspected() const { return output == SurfaceOutput::Inspection; }

    /// The inspection and the surface buffer are exact, and the ground has four vertices.
    bool isPicture() const;
    bool lightsAtVertices() const { return isPicture() && set.lightsAtVertices; }
    bool leavesNormals() const { return isPicture() && set.leavesNormals; }
    /// Only a picture shows strands: other outputs are of the surface on which they grow.
    bool drawsShells() const { return isPicture() && set.shells.has_value(); }
    bool drawsStrokes() const { return isPicture() && set.strokes.has_value(); }
    bool fogsAtVertices() const { return isPicture() && set.fogsAtVertices; }

    /// Tells which array unpack functions read that are declared from now on.
    void readFrom(std::string_view array);

    /// Adds the block's constants, struct and functions, with its tables: once, however often it is
    /// asked for.
    void addBlock(const Block& block, std::span<const CompiledValue> compiled = {});
    void addUnpack(const BlockUse& use, const std::string& function);

    /// Adds code that several parts of the text need: once, however often it is asked for.
    void addOnce(const std::string& code);

    /// Defines what the code of an environment asks for: OPEN_TOWARDS(direction, width), OPEN_SHARE
    /// and OPEN_MEAN(normal), which are 1 and the normal where nothing is hidden.
    void addOpenDirections();

    /// Notes what a probe can read, as a statement of main behind the one that made it.
    void noteTerm(const std::string& term, const std::string& value, const std::string& detail);

  private:
    std::vector<const Block*> written_;
    std::vector<std::string> code_; ///< that addOnce() has added
};

} // namespace patina
