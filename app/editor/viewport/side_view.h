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

/// Holds the settings and the turntable that all views share.
struct ViewTools {
    HandleModes& modes;
    ViewTurntable& turntable;
};

/// Holds what views show and draw with; everything in it outlives them.
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

/// Shows one side of the comparison: a viewport under a coloured, lettered title. It carries out
/// what the mouse does in it to the document. It does not own the camera: it only asks for another
/// one.
class SideView : public QFrame {
    Q_OBJECT

  public:
    SideView(const ViewSources& sources, const ViewTools& tools, Side side,
             QWidget* parent = nullptr);

    Side side() const { return side_; }
    Viewport& viewport() { return *viewport_; }
    void setTitleVisible(bool visible);
    /// Returns its model and the material's name, and the accuracy choice where sides differ only
    /// in that.
    QString caption() const;

    /// Shows something in place of the picture with its legend and the pointer's numbers, or the
    /// picture.
    void setInspected(std::optional<Inspected> shown);

    /// Toggles between the orthographic lens and the one before it.
    void toggleLens();

    /// Makes the next click place the current light's highlight, or the shadow that it throws of
    /// the current object.
    void awaitLightPick(bool isShadow);

    /// Makes the next click on an object tell of the place, by surfacePicked().
    void awaitSurfacePick();

    /// Moves the camera so that the current object fills the view.
    void frameCurrentObject();

    /// Moves the camera so that the current object fills the view; where it does so already, or
    /// none is current, all visible objects fill it.
    void frameObjects();

  Q_SIGNALS:
    void cameraWished(patina::Camera camera);
    void resetWished();
    void filesDropped(QStringList files);
    void captionChanged();
    void surfacePicked(const patina::Hit& hit);
    void bookmarkWished(int digit); ///< asks to store the camera under a digit
    /// Asks for a camera that the document stores.
    void bookmarkChosen(const patina::Camera& bookmark);
    void bookmarkMissed(int digit); ///< tells that the document stores none under a digit

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
    std::optional<Hit> litBy(const Ray& ray) const;
    Ray rayAt(QPointF place) const;
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
    ViewLinks* links_; ///< stands beside the title
    Viewport* viewport_;
    InspectionPanel* inspection_ = nullptr; ///< is null until it is first wanted
    /// Names what the next click is for.
    enum class Awaited { Highlight, Shadow, Surface };
    void await(Awaited awaited);

    std::optional<Awaited> awaited_; ///< is empty where a click selects
    bool turning_ = false;
    Camera atPress_;                ///< holds the camera when a drag began
    std::function<void()> restore_; ///< restores what is turned as it was when the drag began
    /// Degrees; the field of view before the orthographic lens.
    double usualLens_ = Camera().fieldOfView;
    bool wasActive_ = true; ///< this side was the active one before the mouse was pressed
    /// An edge around the view says that it has the focus of the keyboard.
    bool focusShown_ = false;
};

/// Returns the colour or the letter of a side; neither view nor picture shows the colour alone.
QColor colourOf(Side side);
QString letterOf(Side side);

} // namespace patina
