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

/// Puts together what is transparent, whatever the order in which it is drawn: layer by layer from
/// the nearest on, or all at once as a weighted mean. Works on every sample of a pixel by itself.
/// Its memory (24 bytes for each sample) is there only while it is in use.
class LayerComposer {
  public:
    /// Tells what the objects are drawn for.
    enum class Stage {
        Depths, ///< with useDepths()
        Layers  ///< with their own programs
    };
    /// False where it is time to stop; Layers are not all drawn then, and the next call goes on.
    using DrawObjects = std::function<bool(Stage)>;

    /// `layers`: so many are put in order; 0: all are mixed. The target has been fitted. Stops
    /// behind an image or a program, which take long to make: true as long as there may be more,
    /// and the next call goes on.
    Result<bool> begin(const HdrTarget& target, int layers, const Catalog& catalog,
                       ProgramCache& cache);

    /// The frame needs none of this.
    void leaveOut();

    bool isIn() const { return isIn_; }

    /// Tells whether layers are put in order.
    bool isPeeled() const { return shape_.isPeeled; }

    /// Makes what useDepths() needs of a pipeline. Does nothing where layers are not put in order.
    Result<void> addPipeline(const std::shared_ptr<const Pipeline>& pipeline, ProgramCache& cache);
    void useDepths(const std::shared_ptr<const Pipeline>& pipeline) const;

    /// Draws the objects as often as it takes, over what is in the target. False where they were
    /// not all drawn: the next call goes on there.
    bool draw(const HdrTarget& target, const DrawObjects& drawObjects);

    /// Uses all programs that draw() may, those of layers that nobody sees too: drivers compile
    /// when something is drawn.
    void drawUnseen(const HdrTarget& target, const DrawObjects& drawObjects);

    /// The shader files may have changed.
    void forget();

  private:
    struct Shape {
        glm::ivec2 size{0};
        int samples = 0;
        bool isPeeled = false;
        friend bool operator==(const Shape&, const Shape&) = default;
    };
    /// Holds the depths of one layer; the other side has those of the layer before it.
    struct Side {
        gl::TargetTexture depths;
        gl::Framebuffer framebuffer;
        gl::SampleQuery isAnySeen;
    };

    /// Holds what of the frame is drawn.
    struct Progress {
        bool isCleared = false;
        int layer = 0;
        bool hasDepths = false; ///< of the layer
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
    bool isBuilt_ = false; ///< all that follows
    gl::TargetTexture sum_;
    gl::TargetTexture share_; ///< of mixed layers: what they transmit
    gl::Framebuffer mixed_;
    std::array<Side, 2> sides_; ///< of layers in order
    gl::VertexArray noVertices_ = gl::VertexArray::create();
    std::shared_ptr<const gl::Program> composition_; ///< for shape_
    std::map<std::shared_ptr<const Pipeline>, std::shared_ptr<const gl::Program>>
        depthPrograms_; ///< for shape_'s number of samples
};

} // namespace patina
