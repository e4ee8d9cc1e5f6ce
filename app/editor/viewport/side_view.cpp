// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/side_view.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include "document/scene_edits.h"
#include "resources/texture_library.h"
#include "scene/environment.h"
#include "shading/effects/effect_rows.h"
#include "viewport/camera_moves.h"
#include "viewport/inspection_panel.h"
#include "viewport/ray_cast.h"
#include "viewport/side_accuracy.h"
#include "viewport/turning.h"

namespace patina {
namespace {

constexpr int edge = 2; ///< pixels around a view
constexpr int titlePadding = 8;

/// Every value of a light that turning changed, as one edit each of the same interaction.
void storeTurned(Document& document, const BlockPath& path, const Values& before,
                 const Values& after) {
    for (const auto& [id, value] : after) {
        const auto found = before.find(id);
        if (found == before.end() || !(found->second == value)) {
            document.setValue(path, id, value);
        }
    }
}

} // namespace

SideView::SideView(const ViewSources& sources, Side side, const std::filesystem::path& programCache,
                   QWidget* parent)
    : QFrame(parent), document_(sources.document), meshes_(sources.meshes),
      switches_(sources.switches), side_(side), title_(new QLabel(this)),
      viewport_(new Viewport(
          {[this]() -> const Scene& { return switches_.scene(side_); },
           [this]() -> const Scene& { return document_.scene(side_); },
           [this](const Object& object) { return meshes_.view(object); },
           [this] { return switches_.effects(side_); },
           [this, &environments = sources.environments] {
               return environments.image(environmentPicture(document_));
           },
           programCache,
           [&textures = sources.textures](const TextureUse& use, TextureDecoding decoding) {
               return textures.find(use, decoding);
           },
           &sources.programs},
          this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(edge, edge, edge, edge);
    layout->setSpacing(0);
    layout->addWidget(title_);
    layout->addWidget(viewport_, 1);
    title_->setObjectName("title");
    title_->setTextFormat(Qt::RichText);
    title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    viewport_->setAccessibleName(tr("View %1").arg(letterOf(side)));
    viewport_->setCatalog(document_.sharedCatalog());
    viewport_->setCamera(document_.scene().camera);
    connectNavigation();
    FrameLoop* frames = &viewport_->frames();
    onChange(document_, DocumentChange::Drawn, frames, &FrameLoop::refresh);
    connect(&sources.effects, &ProgramEffects::changed, frames, &FrameLoop::refresh);
    connect(&sources.textures, &TextureLibrary::arrived, frames, &FrameLoop::refresh);
    connect(&sources.effects, &ProgramEffects::prewarmed, this, [this](const DocumentState& state) {
        if (viewport_->isVisible()) {
            viewport_->prewarmer().add(
                withoutEffects(shownScene(state, document_.currentObject(), side_), switches_.off(),
                               document_.catalog()));
        }
    });
    onChange(document_, DocumentChange::Drawn | DocumentChange::Current, this,
             &SideView::updateTitle);
    onChange(document_, DocumentChange::Scene, frames, &FrameLoop::announceScene);
    onChange(document_, DocumentChange::Catalog, this,
             [this] { viewport_->setCatalog(document_.sharedCatalog()); });
    connect(&switches_, &EffectSwitches::changed, frames, &FrameLoop::refresh);
    connect(&meshes_, &MeshLibrary::loaded, frames, &FrameLoop::refresh);
    connect(&sources.environments, &EnvironmentLibrary::loaded, frames, &FrameLoop::refresh);
    connect(&sources.environments, &EnvironmentLibrary::failed, frames, &FrameLoop::refresh);
    connect(viewport_, &Viewport::filesDropped, this, &SideView::take);
    connect(viewport_, &Viewport::focusShown, this, [this](bool byKeyboard) {
        focusShown_ = byKeyboard;
        update();
    });
    connect(viewport_, &Viewport::activated, this, [this] { document_.setActiveSide(side_); });
    updateTitle();
}

void SideView::paintEvent(QPaintEvent* event) {
    QFrame::paintEvent(event);
    if (focusShown_) {
        QPainter(this).fillRect(rect(), palette().highlight());
    }
}

void SideView::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    updateTitle(); // what does not fit ends in an ellipsis
}

void SideView::setTitleVisible(bool visible) {
    title_->setVisible(visible);
    layout()->activate(); // it has its width only now
    updateTitle();
}

void SideView::setInspecting(bool on) {
    if (on && !inspection_) {
        inspection_ = new InspectionPanel(viewport_);
        auto* layout = new QVBoxLayout(viewport_);
        layout->setSizeConstraint(QLayout::SetNoConstraint);
        layout->addWidget(inspection_, 0, Qt::AlignLeft | Qt::AlignBottom);
        connect(&viewport_->prober(), &PixelProber::probed, inspection_,
                [this](const std::optional<PixelProbe>& numbers) {
                    inspection_->showNumbers(numbers, document_.scene(side_));
                });
    }
    if (inspection_) {
        inspection_->setVisible(on);
    }
    viewport_->setInspecting(on);
}

double SideView::aspect() const {
    return double(viewport_->width()) / std::max(viewport_->height(), 1);
}

/// The camera as it is where no object is current.
Camera SideView::framedOnCurrent() const {
    const int current = document_.currentObject();
    const Scene& scene = document_.scene(side_);
    if (current < 0 || current >= static_cast<int>(scene.objects.size())) {
        return viewport_->camera();
    }
    const Object& object = scene.objects[static_cast<std::size_t>(current)];
    return framed(viewport_->camera(), object, meshes_.view(object), aspect());
}

Camera SideView::framedOnAll() const {
    std::vector<PlacedMesh> shown;
    for (const Object& object : document_.scene(side_).objects) {
        if (object.visible) {
            shown.push_back({object, meshes_.view(object)});
        }
    }
    return framed(viewport_->camera(), shown, aspect());
}

void SideView::frameCurrentObject() {
    Q_EMIT cameraWished(framedOnCurrent());
}

void SideView::frameObjects() {
    const Camera onCurrent = framedOnCurrent();
    const bool isFramed = isSameView(onCurrent, viewport_->camera());
    Q_EMIT cameraWished(isFramed ? framedOnAll() : onCurrent);
}

void SideView::connectNavigation() {
    CameraNavigation& navigation = viewport_->navigation();
    connect(&navigation, &CameraNavigation::orbitWished, this, [this](double yaw, double pitch) {
        Q_EMIT cameraWished(orbited(viewport_->camera(), yaw, pitch));
    });
    connect(&navigation, &CameraNavigation::panWished, this, [this](QPointF pixels) {
        Q_EMIT cameraWished(
            panned(viewport_->camera(), {pixels.x(), pixels.y()}, viewport_->height()));
    });
    connect(&navigation, &CameraNavigation::dollyWished, this,
            [this](double factor) { Q_EMIT cameraWished(dollied(viewport_->camera(), factor)); });
    connect(&navigation, &CameraNavigation::directionWished, this,
            [this](double yaw, double pitch) {
                Camera camera = viewport_->camera();
                camera.yaw = yaw;
                camera.pitch = pitch;
                Q_EMIT cameraWished(camera);
            });
    connect(&navigation, &CameraNavigation::objectTurnWished, this, &SideView::turnObject);
    connect(&navigation, &CameraNavigation::lightTurnWished, this, &SideView::turnLight);
    connect(&navigation, &CameraNavigation::environmentTurnWished, this,
            &SideView::turnEnvironment);
    connect(&navigation, &CameraNavigation::dragFinished, this, &SideView::endTurn);
    connect(&navigation, &CameraNavigation::pivotWished, this, &SideView::pivotOn);
    connect(&navigation, &CameraNavigation::frameWished, this, &SideView::frameObjects);
    connect(&navigation, &CameraNavigation::resetWished, this, &SideView::resetWished);
}

void SideView::turnObject(double yaw, double pitch) {
    const int current = document_.currentObject();
    if (current < 0) {
        return;
    }
    beginTurn();
    Object object = document_.scene().objects[static_cast<std::size_t>(current)];
    object.rotation = turnedRotation(object.rotation, viewport_->camera(), yaw, pitch);
    setObject(document_, current, object);
}

void SideView::turnLight(double yaw, double pitch) {
    const int index = lightToTurn(document_.scene(), document_.catalog(), document_.currentLight());
    if (index < 0) {
        return;
    }
    beginTurn();
    const Values before =
        document_.scene().lights[static_cast<std::size_t>(index)].block.parameters;
    const BlockPath path = pathOf(kinds::lights, index);
    const Block* block = document_.block(path);
    storeTurned(document_, path, before,
                turnedLight(before, *block, viewport_->camera(), yaw, pitch));
}

/// As the mouse pulls what the front of an object mirrors.
void SideView::turnEnvironment(double yaw) {
    const BlockPath path = pathOf(kinds::environment);
    const BlockValues* environment = document_.scene().part(kinds::environment);
    const Block* block = environment != nullptr ? document_.block(path) : nullptr;
    const Parameter* rotation = block != nullptr ? block->withRole(roles::rotate) : nullptr;
    if (rotation == nullptr) {
        return;
    }
    beginTurn();
    const double now = environmentNumber(*environment, *block, roles::rotate);
    document_.setValue(path, rotation->id, std::remainder(now + yaw, 360.0));
}

void SideView::beginTurn() {
    if (!turning_) {
        turning_ = true;
        document_.beginInteraction();
    }
}

void SideView::endTurn() {
    if (turning_) {
        turning_ = false;
        document_.endInteraction();
    }
}

std::optional<Hit> SideView::hitAt(QPointF place) const {
    const Ray ray = rayThrough(viewport_->camera(), {place.x(), place.y()},
                               {viewport_->width(), viewport_->height()});
    const auto meshes = [this](const Object& object) { return meshes_.pickMesh(object); };
    return cast(ray, document_.scene(side_), meshes);
}

void SideView::pivotOn(QPointF place) {
    if (const std::optional<Hit> hit = hitAt(place)) {
        Q_EMIT cameraWished(pivotedAt(viewport_->camera(), hit->point));
    }
}

/// A preset is for the object that it was dropped on.
void SideView::take(const QStringList& files, QPointF place) {
    if (const std::optional<Hit> hit = hitAt(place)) {
        document_.setCurrentObject(hit->object);
    }
    Q_EMIT filesDropped(files);
}

QString SideView::caption() const {
    const Material* material = document_.material(side_);
    const Block* model =
        material ? document_.catalog().find(kinds::models, material->model.id) : nullptr;
    const QString modelName = model      ? QString::fromStdString(model->label)
                              : material ? QString::fromStdString(material->model.id)
                                         : tr("nothing selected");
    const QString name = material ? QString::fromStdString(material->name) : QString();
    const QString dash = tr(" \u2013 ");
    const QString accuracy = accuracyOfSide(document_, side_);
    return (accuracy.isEmpty() ? modelName : accuracy + dash + modelName) +
           (name.isEmpty() ? name : dash + name);
}

void SideView::updateTitle() {
    const bool active = document_.activeSide() == side_;
    const QString state = active ? tr(" (being edited)") : QString();
    const QString called = caption();
    const QFontMetrics font = title_->fontMetrics();
    const int room = title_->width() - 2 * titlePadding -
                     font.horizontalAdvance(QStringLiteral("   WW ") + state);
    const QString text =
        QStringLiteral("<b>&nbsp;%1&nbsp;</b>&nbsp; %2%3")
            .arg(letterOf(side_), font.elidedText(called, Qt::ElideRight, room).toHtmlEscaped(),
                 state);
    title_->setToolTip(called.toHtmlEscaped());
    viewport_->setAccessibleDescription(tr("Shows %1").arg(called)); // also while nothing fits
    if (text != title_->text()) {
        Q_EMIT captionChanged();
        title_->setText(text);
        // A style sheet takes margins away, but not in each case.
        title_->setStyleSheet(
            QStringLiteral("color: %1; background: %2; padding: 3px %3px;")
                .arg(active ? "#101010" : "#f0f0f0",
                     active ? colourOf(side_).name() : colourOf(side_).darker(260).name())
                .arg(titlePadding));
    }
}

QColor colourOf(Side side) {
    static constexpr std::array colours{0xf0a04bu, 0x5bb6e8u, 0x8fce6au, 0xd58be0u};
    return QColor::fromRgb(colours[indexOf(side)]);
}

QString letterOf(Side side) {
    return QString(QChar(u'A' + static_cast<char16_t>(indexOf(side))));
}

} // namespace patina
