// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QImage>

#include "core/mesh.h"
#include "scene/scene.h"

namespace patina {

/// Draws the lines around objects as they are seen in a view. The picture is made anew only when
/// something in it has changed. Meshes of more than some hundred thousand triangles have the edges
/// of their boxes in place of outlines, so that nothing waits for them.
class SelectionOutline {
  public:
    using Meshes = std::function<MeshView(const Object&)>;

    /// A picture of `size` pixels, transparent but for the lines around these objects of the scene.
    const QImage& draw(const Scene& scene, const std::vector<int>& objects, const Camera& camera,
                       const QSize& size, const Meshes& meshes);

  private:
    /// What one object's line depends on.
    struct Shown {
        glm::dmat4 world{1.0};
        const Vertex* vertices = nullptr;
        std::size_t triangles = 0;

        friend bool operator==(const Shown&, const Shown&) = default;
    };

    std::vector<Shown> shown_;
    Camera camera_;
    QImage image_;
    std::vector<unsigned char> mask_; ///< by pixel: which of the objects covers it, from 1
};

} // namespace patina
