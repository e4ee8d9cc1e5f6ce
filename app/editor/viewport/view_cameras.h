// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QObject>

#include "viewport/camera_history.h"
#include "viewport/side_view.h"

namespace patina {

/// Knows where the views of a document look from. Side A's camera is the document's, a step back
/// where a view is narrower than high; the other sides' is the same one until they are unlinked.
class ViewCameras : public QObject {
    Q_OBJECT

  public:
    explicit ViewCameras(Document& document);

    /// Takes a view in, which looks from where side A does, and follows what its user does.
    void add(SideView& view);

    /// Links the other sides with side A, or unlinks them.
    void setLinked(bool linked);

    /// Lets all sides look from where side A does.
    void realign();

    /// Moves a side to the camera that the scene had when it was opened.
    void reset(Side side);

    /// Steps back as far as the narrowest view that is shown needs: the field of view is the
    /// height's, and what is in a square is not cut off. The document's camera stays where it is.
    void fitNarrowViews();

    /// Returns the undo of the document's camera.
    CameraHistory& history() { return history_; }

  Q_SIGNALS:
    void linkChanged(bool linked);
    /// Is emitted with a sentence on what a bookmark's key has done.
    void said(const QString& text);

  private:
    SideView& first() const { return *views_.front(); }
    SideView* view(Side side) const;
    bool isLinked(Side side) const { return side == Side::A || linked_; }
    void move(Side side, const Camera& shown);
    void show();
    Camera shownFrom(const Camera& camera) const;
    Camera heldFrom(const Camera& shown) const;

    Document& document_;
    CameraHistory history_;
    std::vector<SideView*> views_; ///< begins with side A's
    Camera home_;                  ///< is the document's as it was opened
    bool linked_ = true;
    double stepBack_ = 1.0; ///< the factor by which views look from farther than the document does
};

} // namespace patina
