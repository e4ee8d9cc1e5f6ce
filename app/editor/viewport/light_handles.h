// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QColor>

#include "document/document.h"
#include "viewport/handle_modes.h"
#include "viewport/handle_set.h"
#include "viewport/light_pose.h"

namespace patina {

/// Draws the lights into a view and moves them: their position, their target, their distance to it
/// and the width of their cones. The current light has all these handles; the others have only that
/// of their position, which makes the light the current one.
class LightHandles : public HandleSet {
  public:
    /// Returns the surface that a ray meets; nothing where there is none.
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
    /// Describes a light as it is drawn in a view.
    struct Shown {
        LightPose place;
        /// Is the point it shines at, or the pivot for a light that shines everywhere.
        glm::dvec3 target{0.0};
        bool isOn = true;
        QColor color;
        /// Says where the handle of the distance is, as a share of the way from the light to its
        /// target.
        double distanceShare = 0.0;
    };

    std::optional<Shown> shown(const ViewGeometry& view, int light) const;
    glm::dvec3 targetOf(const ViewGeometry& view, const LightPose& place) const;
    double distanceShareOf(const ViewGeometry& view, int index, const Shown& light) const;
    std::optional<glm::dvec3> pointOf(const Shown& light, int part) const;
    std::optional<QPointF> placeOf(const ViewGeometry& view, const Shown& light, int part) const;
    void drawLight(const ViewGeometry& view, QPainter& painter, int index,
                   std::optional<int> hot) const;
    void drawCone(const ViewGeometry& view, QPainter& painter, const Shown& light) const;
    void store(const Values& values);

    Document& document_;
    const HandleModes& modes_;
    SurfaceAt surfaceAt_;
    int light_ = -1; ///< is the index of the dragged light; -1 before the first drag
    int part_ = 0;   ///< says which Part of the light is dragged
    QPointF from_;   ///< says where the drag began, in the view
    QPointF lampAt_; ///< says where the lamp was seen then
    bool isDragging_ = false;
    Shown start_; ///< holds the light as it was when the drag began
    Values held_; ///< holds the light's values as they were when the drag began
};

} // namespace patina
