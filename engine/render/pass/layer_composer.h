// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>

#include "catalog/catalog.h"
#include "gl/framebuffer.h"
#include "gl/sample_query.h"
#include "gl/target_texture.h"
#include "gl/vertex_array.h"
#include "render/gpu/hdr_target.h"
#include "render/gpu/pipeline.h"
#include "shading/program/program_cache.h"

namespace patina {

/// Composes transparent objects independently of the order in which they are drawn: layer by layer
/// from the nearest on, or all at once as a weighted mean. It works on each sample of a pixel. Its
/// memory (24 bytes for each sample) exists only while it is in use.
class LayerComposer {
  public:
    /// Says what the objects are drawn for.
    enum class Stage {
        Depths, ///< draws with the programs of useDepths()
        Layers  ///< draws with the objects' own programs
    };
    /// Draws all objects for a stage. Returns false when the budget is used up; in the stage Layers
    /// some objects are missing then, and the next call continues.
    using DrawObjects = std::function<bool(Stage)>;

    /// Prepares a frame for a target that has been fitted. `layers` is how many layers are drawn in
    /// order; 0 mixes all of them. It returns true after an image or a program, which take long to
    /// make; then it must be called again.
    Result<bool> begin(const HdrTarget& target, int layers, const Catalog& catalog,
                       ProgramCache& cache);

    /// Frees all memory, for frames that need no layers.
    void leaveOut();

    bool isIn() const { return isIn_; }

    /// Returns true when layers are drawn in order (depth peeling), false when they are mixed.
    bool isPeeled() const { return shape_.isPeeled; }

    /// Makes the program that useDepths() needs for a pipeline. Does nothing where layers are
    /// mixed.
    Result<void> addPipeline(const std::shared_ptr<const Pipeline>& pipeline, ProgramCache& cache);
    void useDepths(const std::shared_ptr<const Pipeline>& pipeline) const;

    /// Draws the objects as often as needed and composes them over the target. Returns false when
    /// the budget is used up; the next call continues.
    bool draw(const HdrTarget& target, const DrawObjects& drawObjects);

    /// Draws with all programs that draw() may use, also for empty layers, because drivers compile
    /// when something is drawn.
    void drawUnseen(const HdrTarget& target, const DrawObjects& drawObjects);

    /// Drops all programs, because the shader files may have changed.
    void forget();

  private:
    struct Shape {
        glm::ivec2 size{0};
        int samples = 0;
        bool isPeeled = false;
        friend bool operator==(const Shape&, const Shape&) = default;
    };
    /// Holds the depths of one layer; the other side has those of the layer before.
    struct Side {
        gl::TargetTexture depths;
        gl::Framebuffer framebuffer;
        gl::SampleQuery isAnySeen;
    };

    /// Remembers how much of the frame is drawn.
    struct Progress {
        bool isCleared = false;
        int layer = 0;
        bool hasDepths = false; ///< says that the depths of the layer are drawn
        bool isUnseen = false;
    };

    Result<void> buildNext();
    Result<void> buildSide(Side& side);
    Result<void> makeComposition(const Catalog& catalog, ProgramCache& cache);
    bool drawInOrder(const HdrTarget& target, const DrawObjects& drawObjects);
    void clearLayers() const;
    bool drawDepths(const HdrTarget& target, const DrawObjects& drawObjects) const;
    bool drawLayer(const DrawObjects& drawObjects) const;
    void beginConditionOf(const Side& side) const;
    void endCondition() const;
    bool drawMixed(const HdrTarget& target, const DrawObjects& drawObjects);
    const Side& side(int layer) const { return sides_[static_cast<std::size_t>(layer % 2)]; }
    void compose(const HdrTarget& target) const;
    bool isMultisampled() const { return shape_.samples > 1; }

    bool isIn_ = false;
    int layers_ = 0;
    Progress progress_;
    Shape shape_;
    bool isBuilt_ = false; ///< says that all images and framebuffers below are made
    gl::TargetTexture sum_;
    gl::TargetTexture share_; ///< holds the transmitted share of mixed layers
    gl::Framebuffer mixed_;
    std::array<Side, 2> sides_; ///< are used for layers in order
    gl::VertexArray noVertices_ = gl::VertexArray::create();
    std::shared_ptr<const gl::Program> composition_; ///< is made for shape_
    std::map<std::shared_ptr<const Pipeline>, std::shared_ptr<const gl::Program>>
        depthPrograms_; ///< are made for the number of samples in shape_
};

} // namespace patina
