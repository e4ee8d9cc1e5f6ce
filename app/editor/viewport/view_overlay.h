// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "document/document.h"
#include "resources/mesh_library.h"
#include "viewport/selection_outline.h"
#include "viewport/view_surface.h"

namespace patina {

class HandleModes;
class ViewHandles;
class Viewport;

/// Draws what lies over a view and is not part of its picture: the lines around what is selected,
/// and the handles. It costs nothing while there is nothing to draw.
class ViewOverlay : public QObject, public OverlaySource {
    Q_OBJECT

  public:
    ViewOverlay(Viewport& viewport, Document& document, MeshLibrary& meshes,
                const ViewHandles& handles, const HandleModes& modes);

    /// Hides the overlay or shows it again; a turntable hides it, as it shows things elsewhere than
    /// the document has them.
    void setSuspended(bool suspended);

    bool isSeen() const override;
    void draw(QPainter& painter) override;

  private:
    void follow();
    void drawSelection(QPainter& painter);

    Viewport& viewport_;
    Document& document_;
    MeshLibrary& meshes_;
    const ViewHandles& handles_;
    SelectionOutline outline_;
    bool isSuspended_ = false;
    bool wasSeen_ = false;
};

} // namespace patina
