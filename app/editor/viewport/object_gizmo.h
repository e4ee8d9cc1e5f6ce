// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "document/document.h"
#include "viewport/handle_modes.h"
#include "viewport/handle_set.h"

namespace patina {

/// Moves, turns and scales the objects that an edit changes: along and about the axes of the world,
/// and along those of the current object for scaling. Ctrl while dragging snaps to steps.
class ObjectGizmo : public HandleSet {
  public:
    ObjectGizmo(Document& document, const HandleModes& modes);

    bool isShown() const override;
    std::optional<int> handleAt(const ViewGeometry& view, QPointF place) const override;
    void draw(const ViewGeometry& view, QPainter& painter, std::optional<int> hot) const override;
    void begin(const ViewGeometry& view, int handle, QPointF place) override;
    void drag(const ViewGeometry& view, QPointF place, bool isStepped) override;
    void end() override;
    void cancel() override;

  private:
    /// Says where the handles stand: in the middle of the objects that they move.
    struct Frame {
        glm::dvec3 origin{0.0};
        std::array<glm::dvec3, 3> axes;
        double length = 1.0; ///< metres
    };

    Frame frame(const ViewGeometry& view) const;
    std::vector<QPointF> line(const ViewGeometry& view, const Frame& frame, int axis) const;
    void move(const ViewGeometry& view, QPointF place, bool isStepped);
    void turn(const ViewGeometry& view, QPointF place, bool isStepped);
    void scale(const ViewGeometry& view, QPointF place, bool isStepped);
    QString label() const;
    void apply(const std::function<void(Object&)>& change);

    Document& document_;
    const HandleModes& modes_;
    int handle_ = 0;
    QPointF from_; ///< says where the drag began, in the view
    Frame start_;  ///< holds the frame as it was when the drag began
    /// Maps their index to the objects as they were when the drag began.
    std::map<int, Object> held_;
};

} // namespace patina
