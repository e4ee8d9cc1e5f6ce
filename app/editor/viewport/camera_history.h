// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QElapsedTimer>
#include <QObject>

#include "document/document.h"

namespace patina {

/// Undoes and redoes camera moves, apart from the undo of edits. A drag is one step; so are moves
/// that quickly follow each other, such as turns of a wheel. Another scene empties it.
class CameraHistory : public QObject {
    Q_OBJECT

  public:
    explicit CameraHistory(Document& document, QObject* parent = nullptr);

    bool canUndo() const { return !undo_.empty(); }
    bool canRedo() const { return !redo_.empty(); }
    void undo() { step(undo_, redo_); }
    void redo() { step(redo_, undo_); }

    /// Makes one step of all moves between these two calls, and none where the camera ends where it
    /// began.
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
    std::vector<Camera> undo_; ///< ends with the newest
    std::vector<Camera> redo_; ///< ends with the one that redo() takes next
    bool isDragging_ = false;
    bool isOpen_ = false; ///< the next move extends the last step
    QElapsedTimer sinceMove_;
};

} // namespace patina
