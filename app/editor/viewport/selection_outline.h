// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QImage>

#include "core/mesh.h"
#include "scene/scene.h"

namespace patina {

/// Draws the lines around objects as they are seen in a view. The picture is drawn again only when
/// something in it has changed. Where the objects have more than some hundred thousand triangles,
/// or are too many for a mask of bytes, it draws the edges of their boxes instead, so that nothing
/// waits for them.
class SelectionOutline {
  public:
    using Meshes = std::function<MeshView(const Object&)>;

    /// Returns a picture of `size` pixels with the lines around these objects of the scene; all
    /// else is transparent. It stays valid until the next call.
    const QImage& draw(const Scene& scene, const std::vector<int>& objects, const Camera& camera,
                       const QSize& size, const Meshes& meshes);

  private:
    /// Holds what one object's line depends on.
    struct Shown {
        glm::dmat4 world{1.0};
        const Vertex* vertices = nullptr;
        std::size_t triangles = 0;

        friend bool operator==(const Shown&, const Shown&) = default;
    };

    std::vector<Shown> shown_;
    Camera camera_;
    QImage image_;
    /// Holds per pixel the number of the object that covers it, from 1; 0 where none does.
    std::vector<unsigned char> mask_;
};

} // namespace patina
