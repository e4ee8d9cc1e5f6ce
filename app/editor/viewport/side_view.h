// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QFrame>

#include "resources/environment_library.h"
#include "resources/mesh_library.h"
#include "resources/texture_library.h"
#include "viewport/effect_switches.h"
#include "viewport/handle_modes.h"
#include "viewport/ray_cast.h"
#include "viewport/view_turntable.h"
#include "viewport/viewport.h"

class QLabel;

namespace patina {

class InspectionPanel;
class ViewLinks;
class ProgramWorker;
class ViewContext;

/// Holds what all views have in common in how they show it.
struct ViewTools {
    HandleModes& modes;
    ViewTurntable& turntable;
};

/// Holds what views show.
struct ViewSources {
    Document& document;
    MeshLibrary& meshes;
    TextureLibrary& textures;
    EnvironmentLibrary& environments;
    EffectSwitches& switches;
    ProgramEffects& effects;
    ProgramWorker& programs;
    ViewContext& context;
};

/// One side of the comparison: a viewport under a coloured, lettered title, and what the mouse
/// does in it to the document. The camera is not its own: it only asks for another one.
class SideView : public QFrame {
    Q_OBJECT

  public:
    SideView(const ViewSources& sources, const ViewTools& tools, Side side,
             QWidget* parent = nullptr);

    Side side() const { return side_; }
    Viewport& viewport() { return *viewport_; }
    void setTitleVisible(bool visible);
    /// What it shows: its model, the material's name, and how exactly where that is compared.
    QString caption() const;

    /// The numerical check with its legend and the pointer's numbers, or the picture.
    void setInspecting(bool on);

    /// The orthographic lens, or the one before it.
    void toggleLens();

    /// The next click says where the current light's highlight is to be, or the shadow that it
    /// throws of the current object.
    void awaitLightPick(bool isShadow);

    /// Moves the camera so that the current object fills the view.
    void frameCurrentObject();

    /// The same; where it does already, and where there is none, all visible objects fill it.
    void frameObjects();

  Q_SIGNALS:
    void cameraWished(patina::Camera camera);
    void resetWished();
    void filesDropped(QStringList files);
    void captionChanged();
    void bookmarkWished(int digit);                      ///< what is seen is to be kept
    void bookmarkChosen(const patina::Camera& bookmark); ///< as the document has it

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    bool shows(const DocumentChange& change) const;
    void connectNavigation();
    double aspect() const;
    Camera framedOnCurrent() const;
    Camera framedOnAll() const;
    void turnObject(double yaw, double pitch);
    void turnLight(double yaw, double pitch);
    void turnEnvironment(double yaw);
    void bookmark(int digit, bool isKept);
    void beginDrag();
    void cancelDrag();
    void beginTurn(std::function<void()> restore);
    void endTurn();
    std::optional<Hit> hitAt(QPointF place) const;
    std::optional<Hit> hitOf(const Ray& ray) const;
    void placeLight(QPointF place, bool isShadow);
    void pivotOn(QPointF place);
    void pick(QPointF place, bool adds);
    void take(const QStringList& files, QPointF place);
    void updateTitle();

    Document& document_;
    MeshLibrary& meshes_;
    EffectSwitches& switches_;
    Side side_;
    QLabel* title_;
    ViewLinks* links_; ///< beside the title
    Viewport* viewport_;
    InspectionPanel* inspection_ = nullptr; ///< made when it is first wanted
    std::optional<bool> awaited_;           ///< see awaitLightPick()
    bool turning_ = false;
    Camera atPress_;                          ///< the camera when a drag began
    std::function<void()> restore_;           ///< makes what is turned as it was
    double usualLens_ = Camera().fieldOfView; ///< degrees, before the orthographic one
    bool wasActive_ = true;                   ///< before the button was pressed
    bool focusShown_ = false; ///< an edge around the view says that the keys go there
};

/// The colour and the letter of a side; a side is never told by its colour alone.
QColor colourOf(Side side);
QString letterOf(Side side);

} // namespace patina
