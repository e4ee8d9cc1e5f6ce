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

/// Holds what a widget shows: a scene with its meshes and images, the camera that looks at it, and
/// the blocks that it is computed with.
class ViewedScene {
  public:
    using SceneSource = std::function<const Scene&()>;

    struct Sources {
        SceneSource scene; ///< returns the scene as it is shown
        SceneSource whole; ///< returns the scene as it is exported
        MeshSource meshes;
        std::function<const Scene*()> effects; ///< see View::effects
        /// Returns View::environmentImage.
        std::function<std::shared_ptr<const EnvironmentImage>()> environment;
        ViewContext& context;     ///< is the context that the views draw in
        TextureSource textures{}; ///< finds the images of materials; without it none are shown
        MeasuredStore::Source tables = keptTable; ///< finds the tables of measured files
        ProgramWorker* programs = nullptr; ///< makes programs; without it frames wait for them
    };

    ViewedScene(Sources sources, const QWidget& widget);

    const Sources& sources() const { return sources_; }
    const Camera& camera() const { return camera_; }
    void setCamera(const Camera& camera) { camera_ = camera; }
    const std::shared_ptr<const Catalog>& catalog() const { return catalog_; }
    void setCatalog(std::shared_ptr<const Catalog> catalog) { catalog_ = std::move(catalog); }

    /// Returns how the scene is looked at now; its size is the widget's, in pixels of the screen.
    View view() const;

    /// Returns how many samples of an environment's light a view gathers while nothing changes: the
    /// number that the scene asks for.
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
