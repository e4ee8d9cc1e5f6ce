// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "document/document.h"
#include "scene/turntable.h"

namespace patina {

/// Turns what all views show as a turntable does, without an edit: the document, its files and what
/// is exported stay as they are.
class ViewTurntable : public QObject {
    Q_OBJECT

  public:
    explicit ViewTurntable(const Document& document, QObject* parent = nullptr);

    /// Starts turning `what`, or stops turning where it is empty. Fails where the scene has nothing
    /// of that to turn.
    Result<void> setTurning(std::optional<TurntableOf> what);
    const std::optional<TurntableOf>& turning() const { return what_; }

    /// Returns what a side shows in place of a scene; the scene itself while nothing turns. Valid
    /// until the next call for the side.
    const Scene& turned(const Scene& scene, Side side);

  Q_SIGNALS:
    void moved();   ///< is sent when what the views show has turned a little further
    void changed(); ///< is sent when another thing begins to turn, or the turning stops

  private:
    const Document& document_;
    std::optional<TurntableOf> what_;
    QTimer tick_;
    QElapsedTimer since_;
    std::array<Scene, sides.size()> shown_;
};

} // namespace patina
