// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/view_overlay.h"

#include <QPainter>

#include "viewport/handle_modes.h"
#include "viewport/view_handles.h"
#include "viewport/viewport.h"

namespace patina {
namespace {

/// Tells whether a change may move what is drawn over the picture: values of materials and of the
/// picture never do.
bool mayMove(const DocumentChange& change) {
    const DocumentChange::Aspects ofValues = DocumentChange::Value | DocumentChange::Texture;
    const bool isOfValue = !(change.aspects & ~ofValues);
    return !isOfValue || change.path.owner == BlockOwner::Light ||
           change.path.isAt(settings::object) || change.path.isAt(settings::camera) ||
           change.path.isAt(settings::scene); // whose ground lights have targets on
}

} // namespace

ViewOverlay::ViewOverlay(Viewport& viewport, Document& document, MeshLibrary& meshes,
                         const ViewHandles& handles, const HandleModes& modes)
    : QWidget(&viewport), viewport_(viewport), document_(document), meshes_(meshes),
      handles_(handles) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setObjectName("overlay");
    hide();
    onChange(document, DocumentChange::Drawn | DocumentChange::Current, this,
             [this](const DocumentChange& change) {
                 if (mayMove(change)) {
                     follow();
                 }
             });
    connect(&viewport, &Viewport::cameraChanged, this, &ViewOverlay::follow);
    connect(&viewport, &Viewport::resized, this, &ViewOverlay::follow);
    connect(&meshes, &MeshLibrary::loaded, this, &ViewOverlay::follow);
    connect(&handles, &ViewHandles::changed, this, &ViewOverlay::follow);
    connect(&modes, &HandleModes::changed, this, &ViewOverlay::follow);
    follow();
}

void ViewOverlay::follow() {
    const bool isSeen =
        !isSuspended_ && (!document_.selection().objects().empty() || handles_.isShown());
    if (isSeen) {
        setGeometry(viewport_.rect());
        update();
    }
    setVisible(isSeen);
}

void ViewOverlay::setSuspended(bool suspended) {
    isSuspended_ = suspended;
    follow();
}

void ViewOverlay::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    if (!document_.selection().objects().empty()) {
        drawSelection(painter);
    }
    handles_.draw(painter);
}

void ViewOverlay::drawSelection(QPainter& painter) {
    const auto mesh = [this](const Object& object) { return meshes_.view(object); };
    const glm::ivec2 pixels = pixelsOf(viewport_, size());
    QImage image = outline_.draw(document_.scene(), document_.selection().objects(),
                                 viewport_.camera(), {pixels.x, pixels.y}, mesh);
    painter.drawImage(rect(), image);
}

} // namespace patina
