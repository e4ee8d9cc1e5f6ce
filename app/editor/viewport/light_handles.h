// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QColor>

#include "document/document.h"
#include "viewport/handle_modes.h"
#include "viewport/handle_set.h"
#include "viewport/light_pose.h"

namespace patina {

/// Draws the lights into a view and moves them: where they are, what they shine at, how far they
/// are from it and how wide their cones are. The current one has all of these; of the others the
/// place, which makes one the current.
class LightHandles : public HandleSet {
  public:
    /// The surface under a place of a view; nothing where there is none.
    using SurfaceAt = std::function<std::optional<Hit>(const Ray& ray)>;

    LightHandles(Document& document, const HandleModes& modes, SurfaceAt surfaceAt);

    bool isShown() const override;
    std::optional<int> handleAt(const ViewGeometry& view, QPointF place) const override;
    void draw(const ViewGeometry& view, QPainter& painter, std::optional<int> hot) const override;
    void begin(const ViewGeometry& view, int handle, QPointF place) override;
    void drag(const ViewGeometry& view, QPointF place, bool isStepped) override;
    void end() override;
    void cancel() override;

  private:
    /// A light as it stands in a view.
    struct Shown {
        LightPose place;
        glm::dvec3 target{0.0}; ///< what it shines at, or stands about
        bool isOn = true;
        QColor color;
    };

    std::optional<Shown> shown(const ViewGeometry& view, int light) const;
    glm::dvec3 targetOf(const ViewGeometry& view, const LightPose& place) const;
    std::optional<glm::dvec3> pointOf(const Shown& light, int part) const;
    void drawLight(const ViewGeometry& view, QPainter& painter, int index,
                   std::optional<int> hot) const;
    void drawCone(const ViewGeometry& view, QPainter& painter, const Shown& light) const;
    void store(const Values& values);

    Document& document_;
    const HandleModes& modes_;
    SurfaceAt surfaceAt_;
    int light_ = -1; ///< that is dragged
    int part_ = 0;   ///< of it
    QPointF from_;   ///< where the drag began
    Shown start_;    ///< as it was then
    Values held_;    ///< as they were then
};

} // namespace patina
