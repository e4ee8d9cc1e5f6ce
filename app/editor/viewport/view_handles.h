// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QObject>

#include "viewport/handle_set.h"

class QMouseEvent;
class QPainter;

namespace patina {

class Viewport;

/// Takes the mouse events of a view over a handle and gives them to the handle, so that they do not
/// move the camera.
class ViewHandles : public QObject {
    Q_OBJECT

  public:
    /// The first set that has a handle under the pointer gets the event.
    ViewHandles(Viewport& viewport, std::vector<std::unique_ptr<HandleSet>> sets);

    bool isShown() const;
    void draw(QPainter& painter) const;

  Q_SIGNALS:
    void changed(); ///< is sent when another handle is under the pointer, or while one is dragged

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    struct Handle {
        HandleSet* set = nullptr;
        int number = 0;

        friend bool operator==(const Handle&, const Handle&) = default;
    };

    ViewGeometry geometry() const;
    std::optional<Handle> handleAt(QPointF place) const;
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    void setHot(const std::optional<Handle>& handle);

    Viewport& viewport_;
    std::vector<std::unique_ptr<HandleSet>> sets_;
    std::optional<Handle> hot_; ///< is the handle under the pointer or being dragged
    bool isDragged_ = false;
    bool isWaiting_ = false; ///< a drag was cancelled, and the button is still down
};

} // namespace patina
