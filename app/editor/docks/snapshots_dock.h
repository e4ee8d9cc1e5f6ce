// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "docks/dock_context.h"

class QListWidget;
class QPushButton;

namespace patina {

/// Keeps looks under names: takes them from the active side, restores them, and compares with them.
class SnapshotsDock : public QWidget {
    Q_OBJECT

  public:
    explicit SnapshotsDock(const DockContext& context);

    /// Keeps what the active side shows, with a small image.
    void take();

  private:
    void layOut();
    void connectParts();
    void fill();
    void followCurrent();

    Document& document_;
    CompareArea& views_;
    QListWidget* list_;
    QPushButton* take_;
    QPushButton* restore_;
    QPushButton* compare_;
    QPushButton* remove_;
    bool isFilling_ = false;
};

} // namespace patina
