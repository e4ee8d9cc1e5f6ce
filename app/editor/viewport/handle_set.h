// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "viewport/view_geometry.h"

class QPainter;

namespace patina {

/// Draws handles over a view and carries out what dragging one of them means. A handle is a number
/// whose meaning only the set knows.
class HandleSet {
  public:
    virtual ~HandleSet() = default;

    virtual bool isShown() const = 0;
    /// Returns the handle under a place; nothing where there is none.
    virtual std::optional<int> handleAt(const ViewGeometry& view, QPointF place) const = 0;
    /// Draws all handles; `hot` is the one under the pointer or being dragged, and is highlighted.
    virtual void draw(const ViewGeometry& view, QPainter& painter,
                      std::optional<int> hot) const = 0;

    /// These make one undo step of a drag, and none of one that is cancelled.
    virtual void begin(const ViewGeometry& view, int handle, QPointF place) = 0;
    virtual void drag(const ViewGeometry& view, QPointF place, bool isStepped) = 0;
    virtual void end() = 0;
    virtual void cancel() = 0;
};

} // namespace patina
