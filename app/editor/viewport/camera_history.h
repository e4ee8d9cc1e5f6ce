// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QElapsedTimer>
#include <QObject>

#include "document/document.h"

namespace patina {

/// The undo of camera moves, apart from that of edits. A drag is one step; so are moves that follow
/// each other at once, as turns of a wheel do.
class CameraHistory : public QObject {
    Q_OBJECT

  public:
    explicit CameraHistory(Document& document, QObject* parent = nullptr);

    bool canUndo() const { return !undo_.empty(); }
    bool canRedo() const { return !redo_.empty(); }
    void undo() { step(undo_, redo_); }
    void redo() { step(redo_, undo_); }

    /// What moves between these is one step, and none where it ends where it began.
    void beginDrag();
    void endDrag();

  Q_SIGNALS:
    void changed();

  private:
    void follow();
    void step(std::vector<Camera>& from, std::vector<Camera>& to);
    void forget();

    Document& document_;
    Camera now_;
    std::vector<Camera> undo_; ///< the newest last
    std::vector<Camera> redo_; ///< the next one last
    bool isDragging_ = false;
    bool isOpen_ = false; ///< the next move belongs to the last step
    QElapsedTimer sinceMove_;
};

} // namespace patina
