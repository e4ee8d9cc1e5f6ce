// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include <QSize>

#include "render/renderer.h"

class QWidget;

namespace patina {

class ProgramWorker;
class ViewContext;

/// Knows what a widget shows: a scene with its meshes and images, the camera that looks at it, and
/// the blocks that it is computed with.
class ViewedScene {
  public:
    using SceneSource = std::function<const Scene&()>;

    struct Sources {
        SceneSource scene; ///< as it is shown
        SceneSource whole; ///< as it is exported
        MeshSource meshes;
        std::function<const Scene*()> effects; ///< see View::effects
        /// See View::environmentImage.
        std::function<std::shared_ptr<const EnvironmentImage>()> environment;
        ViewContext& context;              ///< what the views draw in
        TextureSource textures{};          ///< the images of materials; without it none are shown
        ProgramWorker* programs = nullptr; ///< makes programs; without it frames wait for them
    };

    ViewedScene(Sources sources, const QWidget& widget);

    const Sources& sources() const { return sources_; }
    const Camera& camera() const { return camera_; }
    void setCamera(const Camera& camera) { camera_ = camera; }
    const std::shared_ptr<const Catalog>& catalog() const { return catalog_; }
    void setCatalog(std::shared_ptr<const Catalog> catalog) { catalog_ = std::move(catalog); }

    /// Its size is the widget's.
    View view() const;

    /// So many samples of an environment's light a view gathers while nothing changes: as many as
    /// the scene says.
    int wantedSamples() const;

    /// Tells whether the scene's light is fitted while it changes, and sampled at rest.
    bool fitsWhileMoving() const;

  private:
    Sources sources_;
    const QWidget& widget_;
    Camera camera_;
    std::shared_ptr<const Catalog> catalog_;
};

/// Returns a size in the pixels of the widget's screen; never empty.
glm::ivec2 pixelsOf(const QWidget& widget, const QSize& size);

} // namespace patina
