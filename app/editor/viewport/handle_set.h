// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "viewport/view_geometry.h"

class QPainter;

namespace patina {

/// Draws handles over a view and does what dragging one of them means. A handle is a number that is
/// the set's own.
class HandleSet {
  public:
    virtual ~HandleSet() = default;

    virtual bool isShown() const = 0;
    /// The handle under a place; nothing where there is none.
    virtual std::optional<int> handleAt(const ViewGeometry& view, QPointF place) const = 0;
    /// `hot` is the handle under the pointer or in the hand.
    virtual void draw(const ViewGeometry& view, QPainter& painter,
                      std::optional<int> hot) const = 0;

    /// One drag is one undo step; cancelled it is none.
    virtual void begin(const ViewGeometry& view, int handle, QPointF place) = 0;
    virtual void drag(const ViewGeometry& view, QPointF place, bool isStepped) = 0;
    virtual void end() = 0;
    virtual void cancel() = 0;
};

} // namespace patina
