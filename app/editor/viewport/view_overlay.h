// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "document/document.h"
#include "resources/mesh_library.h"
#include "viewport/selection_outline.h"

namespace patina {

class HandleModes;
class ViewHandles;
class Viewport;

/// Lies over a view and draws what is not part of its picture: the lines around what is selected,
/// and the handles. Mouse events go through it. It is hidden while there is nothing to draw, so
/// that it costs nothing then.
class ViewOverlay : public QWidget {
    Q_OBJECT

  public:
    ViewOverlay(Viewport& viewport, Document& document, MeshLibrary& meshes,
                const ViewHandles& handles, const HandleModes& modes);

    /// Hides the overlay or shows it again; a turntable hides it, as it shows things elsewhere than
    /// the document has them.
    void setSuspended(bool suspended);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void follow();
    void drawSelection(QPainter& painter);

    Viewport& viewport_;
    Document& document_;
    MeshLibrary& meshes_;
    const ViewHandles& handles_;
    SelectionOutline outline_;
    bool isSuspended_ = false;
};

} // namespace patina
