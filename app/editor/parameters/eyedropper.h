// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>

#include <QObject>
#include <glm/vec3.hpp>

#include "core/image.h"

class QWidget;

namespace patina {

/// Takes a colour from whatever the pointer is on: linear light from a ColorSource, and what the
/// screen shows from anything else. A click or Enter takes it; Esc or another button gives up.
class Eyedropper : public QObject {
    Q_OBJECT

  public:
    /// `anchor` is a visible widget that has the mouse and the keys meanwhile.
    explicit Eyedropper(QWidget* anchor);

    void start();

  Q_SIGNALS:
    void hovered(const glm::dvec3& linear);
    void finished(bool taken);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool handle(QEvent& event);
    void finish(bool taken);
    std::optional<glm::dvec3> colorAt(const QPoint& place);
    std::optional<glm::dvec3> lightAt(QWidget& widget, const QPoint& place);

    QWidget* anchor_;
    bool isPicking_ = false;
    bool hadTracking_ = false;
    /// Holds the pictures of widgets, taken once each: picking changes what the widgets show.
    std::map<QWidget*, Image> stills_;
};

} // namespace patina
