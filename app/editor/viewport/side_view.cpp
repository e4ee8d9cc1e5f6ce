// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/side_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include "document/scene_edits.h"
#include "resources/texture_library.h"
#include "scene/environment.h"
#include "shading/effects/effect_rows.h"
#include "text/counted.h"
#include "viewport/camera_moves.h"
#include "viewport/inspection_panel.h"
#include "viewport/light_handles.h"
#include "viewport/object_gizmo.h"
#include "viewport/ray_cast.h"
#include "viewport/side_accuracy.h"
#include "viewport/turning.h"
#include "viewport/view_handles.h"
#include "viewport/view_links.h"
#include "viewport/view_overlay.h"

namespace patina {
namespace {

constexpr int edge = 2; ///< pixels around a view
constexpr int titlePadding = 8;

/// Returns those of a light's values that are points or directions.
Values placesOf(const Values& values, const Block& light) {
    Values places;
    for (const Parameter& parameter : light.parameters) {
        if (parameter.space != Space::None) {
            const auto found = values.find(parameter.id);
            places.emplace(parameter.id,
                           found == values.end() ? parameter.defaultValue : found->second);
        }
    }
    return places;
}

std::map<int, Object> objectsAt(const Scene& scene, const std::vector<int>& indices) {
    std::map<int, Object> objects;
    for (const int index : indices) {
        objects.emplace(index, scene.objects[static_cast<std::size_t>(index)]);
    }
    return objects;
}

} // namespace

SideView::SideView(const ViewSources& sources, const ViewTools& tools, Side side, QWidget* parent)
    : QFrame(parent), document_(sources.document), meshes_(sources.meshes),
      switches_(sources.switches), side_(side), title_(new QLabel(this)),
      links_(new ViewLinks(document_, switches_, side, this)),
      viewport_(new Viewport(
          {[this, &turntable = tools.turntable]() -> const Scene& {
               return turntable.turned(switches_.scene(side_), side_);
           },
           [this]() -> const Scene& { return switches_.whole(side_); },
           [this](const Object& object) { return meshes_.view(object); },
           [this] { return switches_.effects(side_); },
           [this, &environments = sources.environments] {
               return environments.image(environmentPicture(document_, side_));
           },
           sources.context,
           [&textures = sources.textures](const TextureUse& use, TextureDecoding decoding) {
               return textures.find(use, decoding);
           },
           [&textures = sources.textures](int file) { return textures.table(file); },
           &sources.programs},
          this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(edge, edge, edge, edge);
    layout->setSpacing(0);
    auto* titleRow = new QHBoxLayout;
    titleRow->setSpacing(0);
    titleRow->addWidget(title_, 1);
    titleRow->addWidget(links_);
    links_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored); // as high as the title
    layout->addLayout(titleRow);
    layout->addWidget(viewport_, 1);
    title_->setObjectName("title");
    title_->setTextFormat(Qt::RichText);
    title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    viewport_->setAccessibleName(tr("View %1").arg(letterOf(side)));
    viewport_->setCatalog(document_.sharedCatalog());
    viewport_->setCamera(document_.scene().camera);
    connectNavigation();
    FrameLoop* frames = &viewport_->frames();
    onChange(document_, DocumentChange::Drawn, frames, [this, frames](const auto& change) {
        if (!shows(change)) {
            return;
        }
        const bool isOfPasses = change.path.isAt(kinds::pass) &&
                                !change.has(DocumentChange::Aspects(DocumentChange::Drawn) &
                                            ~(DocumentChange::Value | DocumentChange::Block));
        isOfPasses ? frames->restyle() : frames->refresh();
    });
    connect(&sources.effects, &ProgramEffects::changed, frames, &FrameLoop::refresh);
    connect(&sources.textures, &TextureLibrary::arrived, frames, &FrameLoop::refresh);
    connect(&sources.effects, &ProgramEffects::prewarmed, this, [this](const DocumentState& state) {
        if (viewport_->isVisible()) {
            viewport_->prewarmer().add(
                withoutEffects(shownScene(state, document_.selection().object(), side_),
                               switches_.offOn(side_), document_.catalog()));
        }
    });
    onChange(document_, DocumentChange::Drawn | DocumentChange::Current, this,
             &SideView::updateTitle);
    onChange(document_, DocumentChange::OwnView, this, [this] {
        this->layout()->activate(); // the title's width has changed
        updateTitle();
    });
    onChange(document_, DocumentChange::Scene, frames, &FrameLoop::announceScene);
    onChange(document_, DocumentChange::Catalog, this,
             [this] { viewport_->setCatalog(document_.sharedCatalog()); });
    connect(&switches_, &EffectSwitches::changed, frames, &FrameLoop::refresh);
    connect(&meshes_, &MeshLibrary::loaded, frames, &FrameLoop::refresh);
    connect(&meshes_, &MeshLibrary::opennessFound, frames, &FrameLoop::refresh);
    connect(&sources.environments, &EnvironmentLibrary::loaded, frames, &FrameLoop::refresh);
    connect(&sources.environments, &EnvironmentLibrary::failed, frames, &FrameLoop::refresh);
    connect(viewport_, &Viewport::filesDropped, this, &SideView::take);
    connect(viewport_, &Viewport::focusShown, this, [this](bool byKeyboard) {
        focusShown_ = byKeyboard;
        update();
    });
    connect(viewport_, &Viewport::activated, this, [this] {
        wasActive_ = document_.selection().side() == side_;
        document_.selection().setSide(side_);
    });
    std::vector<std::unique_ptr<HandleSet>> sets;
    sets.push_back(std::make_unique<ObjectGizmo>(document_, tools.modes));
    sets.push_back(std::make_unique<LightHandles>(document_, tools.modes,
                                                  [this](const Ray& ray) { return litBy(ray); }));
    auto* handles = new ViewHandles(*viewport_, std::move(sets));
    auto* overlay = new ViewOverlay(*viewport_, document_, meshes_, *handles, tools.modes);
    connect(&tools.turntable, &ViewTurntable::changed, overlay,
            [overlay, &turntable = tools.turntable] {
                overlay->setSuspended(turntable.turning().has_value());
            });
    connect(&tools.turntable, &ViewTurntable::moved, frames,
            [frames, &turntable = tools.turntable] {
                // A slow device skips frames, but not the one after the last turn.
                if (!frames->isDrawing() || !turntable.turning()) {
                    frames->refresh();
                }
            });
    updateTitle();
}

/// Tells whether a change concerns this view: all do but a value of another side alone.
bool SideView::shows(const DocumentChange& change) const {
    const DocumentChange::Aspects ofOne =
        DocumentChange::Value | DocumentChange::Texture | DocumentChange::OwnView;
    const bool isOfAnother = change.path.side != side_ &&
                             (change.path.isOfView || (change.path.owner == BlockOwner::Material &&
                                                       change.path.side != Side::A));
    return !isOfAnother || change.has(DocumentChange::Aspects(DocumentChange::Drawn) & ~ofOne);
}

void SideView::paintEvent(QPaintEvent* event) {
    QFrame::paintEvent(event);
    if (focusShown_) {
        QPainter(this).fillRect(rect(), palette().highlight());
    }
}

void SideView::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    updateTitle(); // shortens the caption to the new width
}

void SideView::setTitleVisible(bool visible) {
    title_->setVisible(visible);
    links_->setVisible(visible);
    layout()->activate(); // the title gets its width only now
    updateTitle();
}

void SideView::setInspected(std::optional<Inspected> shown) {
    if (shown && !inspection_) {
        inspection_ = new InspectionPanel(viewport_);
        auto* layout = new QVBoxLayout(viewport_);
        layout->setSizeConstraint(QLayout::SetNoConstraint);
        layout->addWidget(inspection_, 0, Qt::AlignLeft | Qt::AlignBottom);
        viewport_->frames().surface().addToOverlay(*inspection_);
        connect(&viewport_->prober(), &PixelProber::probed, inspection_,
                [this](const std::optional<PixelProbe>& numbers) {
                    inspection_->showNumbers(numbers, document_.scene(side_));
                });
    }
    if (inspection_) {
        inspection_->setVisible(shown.has_value());
        inspection_->explain(shown.value_or(Inspected()), document_.scene(side_));
    }
    viewport_->setInspected(shown);
}

double SideView::aspect() const {
    return double(viewport_->width()) / std::max(viewport_->height(), 1);
}

/// Returns the camera framing the objects that an edit changes; the camera itself where there are
/// none.
Camera SideView::framedOnCurrent() const {
    std::vector<PlacedMesh> shown;
    for (const int index : document_.selection().editedObjects()) {
        const Object& object = document_.scene(side_).objects[static_cast<std::size_t>(index)];
        shown.push_back({object, meshes_.view(object)});
    }
    return framed(viewport_->camera(), shown, aspect());
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
    connect(&navigation, &CameraNavigation::zoomWished, this, [this](double factor, QPointF place) {
        Q_EMIT cameraWished(zoomedTo(viewport_->camera(), factor, {place.x(), place.y()},
                                     {viewport_->width(), viewport_->height()}));
    });
    connect(&navigation, &CameraNavigation::lensWished, this, &SideView::toggleLens);
    connect(&navigation, &CameraNavigation::bookmarkWished, this, &SideView::bookmark);
    connect(&navigation, &CameraNavigation::dragBegan, this, &SideView::beginDrag);
    connect(&navigation, &CameraNavigation::dragCancelled, this, &SideView::cancelDrag);
    connect(&navigation, &CameraNavigation::pickCancelled, this, [this] {
        if (std::exchange(awaited_, std::nullopt)) {
            viewport_->unsetCursor();
        }
    });
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
    connect(&navigation, &CameraNavigation::pickWished, this, &SideView::pick);
    connect(&navigation, &CameraNavigation::lightPickWished, this, &SideView::placeLight);
    connect(&navigation, &CameraNavigation::frameWished, this, &SideView::frameObjects);
    connect(&navigation, &CameraNavigation::resetWished, this, &SideView::resetWished);
}

void SideView::toggleLens() {
    const double held = viewport_->camera().fieldOfView;
    const bool isNarrow = held <= orthographicLens;
    usualLens_ = isNarrow ? usualLens_ : held;
    Q_EMIT cameraWished(withLens(viewport_->camera(), isNarrow ? usualLens_ : orthographicLens));
}

void SideView::bookmark(int digit, bool isKept) {
    if (isKept) {
        Q_EMIT bookmarkWished(digit);
        return;
    }
    const auto& bookmarks = document_.scene().bookmarks;
    if (const auto found = bookmarks.find(digit); found != bookmarks.end()) {
        Q_EMIT bookmarkChosen(found->second);
    } else {
        Q_EMIT bookmarkMissed(digit);
    }
}

void SideView::turnObject(double yaw, double pitch) {
    const int current = document_.selection().object();
    if (current < 0) {
        return;
    }
    const std::vector<int> edited = document_.selection().editedObjects();
    const QString label = counted(edited.size(), tr("Turn object"), tr("Turn %1 objects"));
    beginTurn([this, before = objectsAt(document_.scene(), edited), label] {
        setObjects(document_, before, label);
    });
    changeObjects(document_, edited, label, [&](Object& object) {
        object.rotation = turnedRotation(object.rotation, viewport_->camera(), yaw, pitch);
    });
}

void SideView::turnLight(double yaw, double pitch) {
    const int index =
        lightToTurn(document_.scene(), document_.catalog(), document_.selection().light());
    if (index < 0) {
        return;
    }
    const BlockPath path = pathOf(kinds::lights, index);
    const Block& block = *document_.block(path);
    const Values& held = document_.scene().lights[static_cast<std::size_t>(index)].block.parameters;
    const Values turned = turnedLight(held, block, viewport_->camera(), yaw, pitch);
    const QString label = tr("Turn light");
    beginTurn([this, path, before = placesOf(held, block), label] {
        document_.setValues(path, before, label);
    });
    document_.setValues(path, placesOf(turned, block), label);
}

/// Turns the environment so that its reflection on the front of an object follows the mouse.
void SideView::turnEnvironment(double yaw) {
    const BlockPath path = environmentPath(document_.state(), side_);
    const BlockValues* environment = blockValuesAt(document_.state(), path);
    const Block* block = environment != nullptr ? document_.block(path) : nullptr;
    const Parameter* rotation = block != nullptr ? block->withRole(roles::rotate) : nullptr;
    if (rotation == nullptr) {
        return;
    }
    const double now = environmentNumber(*environment, *block, roles::rotate);
    beginTurn([this, path, id = rotation->id, before = document_.value(path, *rotation)] {
        document_.setValue(path, id, before);
    });
    document_.setValue(path, rotation->id, std::remainder(now + yaw, 360.0));
}

void SideView::beginDrag() {
    atPress_ = viewport_->camera();
}

void SideView::beginTurn(std::function<void()> restore) {
    if (!turning_) {
        turning_ = true;
        restore_ = std::move(restore);
        document_.interaction().begin();
    }
}

void SideView::endTurn() {
    if (turning_) {
        turning_ = false;
        document_.interaction().end();
    }
}

/// Restores what was turned, which leaves no undo step, or the camera.
void SideView::cancelDrag() {
    if (turning_) {
        restore_();
        endTurn();
    } else {
        Q_EMIT cameraWished(atPress_);
    }
}

Ray SideView::rayAt(QPointF place) const {
    return rayThrough(viewport_->camera(), {place.x(), place.y()},
                      {viewport_->width(), viewport_->height()});
}

std::optional<Hit> SideView::hitAt(QPointF place) const {
    const auto meshes = [this](const Object& object) { return meshes_.pickMesh(object); };
    return cast(rayAt(place), document_.scene(side_), meshes);
}

/// Returns what a light shines on along a ray: objects and the ground.
std::optional<Hit> SideView::litBy(const Ray& ray) const {
    const auto meshes = [this](const Object& object) { return meshes_.pickMesh(object); };
    return castWithGround(ray, document_.scene(side_), eye(viewport_->camera()), meshes);
}

void SideView::pivotOn(QPointF place) {
    if (const std::optional<Hit> hit = hitAt(place)) {
        Q_EMIT cameraWished(pivotedAt(viewport_->camera(), hit->point));
    }
}

/// Selects what was clicked on. A click on nothing clears the selection, but the current object
/// stays the one that panels show. The click that makes a view the active one picks nothing.
void SideView::pick(QPointF place, bool adds) {
    if (awaited_) {
        viewport_->unsetCursor();
        const Awaited awaited = *std::exchange(awaited_, std::nullopt);
        if (awaited != Awaited::Surface) {
            placeLight(place, awaited == Awaited::Shadow);
        } else if (const std::optional<Hit> hit = hitAt(place)) {
            Q_EMIT surfacePicked(*hit);
        }
        return;
    }
    const std::optional<Hit> hit = wasActive_ ? hitAt(place) : std::nullopt;
    if (!hit) {
        if (wasActive_ && !adds) {
            document_.selection().setObjects({});
        }
        return;
    }
    std::vector<int> picked = withGroups(document_.scene(), {hit->object});
    const std::vector<int>& before = document_.selection().objects();
    if (adds && std::ranges::binary_search(before, hit->object)) {
        std::vector<int> rest;
        std::ranges::set_difference(before, picked, std::back_inserter(rest));
        document_.selection().setObjects(rest);
        return;
    }
    if (adds) {
        picked.insert(picked.begin(), before.begin(), before.end());
    }
    picked.push_back(hit->object); // which becomes the current one
    document_.selection().setObjects(picked);
}

void SideView::awaitLightPick(bool isShadow) {
    await(isShadow ? Awaited::Shadow : Awaited::Highlight);
}

void SideView::awaitSurfacePick() {
    await(Awaited::Surface);
}

void SideView::await(Awaited awaited) {
    awaited_ = awaited;
    viewport_->setCursor(Qt::CrossCursor);
    viewport_->setFocus();
}

/// Moves the current light so that its highlight, or the shadow of the current object, falls on
/// what is under the pointer.
void SideView::placeLight(QPointF place, bool isShadow) {
    const std::optional<Hit> hit = litBy(rayAt(place));
    const int index =
        lightToTurn(document_.scene(), document_.catalog(), document_.selection().light());
    const BlockPath path = pathOf(kinds::lights, index);
    const Block* block = index < 0 ? nullptr : document_.block(path);
    const auto held =
        block
            ? lightPose(document_.scene().lights[static_cast<std::size_t>(index)].block.parameters,
                        *block, viewport_->camera())
            : std::nullopt;
    if (!hit || !held) {
        return;
    }
    if (isShadow) {
        const std::vector<Object>& objects = document_.scene().objects;
        const auto caster = static_cast<std::size_t>(document_.selection().object());
        const glm::dvec3 middle(worldMatrix(objects[caster]) *
                                glm::dvec4(meshes_.view(objects[caster]).bounds.center(), 1.0));
        document_.setValues(path,
                            valuesAt(withShadowAt(*held, hit->point, middle), viewport_->camera()),
                            tr("Put the shadow there"));
    } else {
        document_.setValues(
            path,
            valuesAt(withHighlightAt(*held, hit->point, hit->normal, viewport_->camera()),
                     viewport_->camera()),
            tr("Put the highlight there"));
    }
}

/// Makes the object under the pointer the current one, as a dropped preset is meant for it.
void SideView::take(const QStringList& files, QPointF place) {
    if (const std::optional<Hit> hit = hitAt(place)) {
        document_.selection().setObject(hit->object);
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
    const bool active = document_.selection().side() == side_;
    QString state = active ? tr(" (being edited)") : QString();
    const QString called = caption();
    const QFontMetrics font = title_->fontMetrics();
    const auto roomBeside = [this, &font](const QString& said) {
        return title_->width() - 2 * titlePadding -
               font.horizontalAdvance(QStringLiteral("   WW ") + said);
    };
    int room = roomBeside(state);
    if (room < font.horizontalAdvance(QStringLiteral("a few letters"))) {
        state.clear(); // the colour of the title says so, too
        room = roomBeside(state);
    }
    const QString text =
        QStringLiteral("<b>&nbsp;%1&nbsp;</b>&nbsp; %2%3")
            .arg(letterOf(side_), font.elidedText(called, Qt::ElideRight, room).toHtmlEscaped(),
                 state);
    title_->setToolTip(called.toHtmlEscaped());
    viewport_->setAccessibleDescription(tr("Shows %1").arg(called)); // without an ellipsis
    if (text != title_->text()) {
        Q_EMIT captionChanged();
        title_->setText(text);
        const QString foreground = active ? "#101010" : "#f0f0f0";
        const QString background = (active ? colourOf(side_) : colourOf(side_).darker(260)).name();
        // A style sheet resets margins, but not in every case.
        title_->setStyleSheet(QStringLiteral("color: %1; background: %2; padding: 3px %3px;")
                                  .arg(foreground, background)
                                  .arg(titlePadding));
        links_->setStyleSheet(
            QStringLiteral("QToolButton { color: %1; background: %2; border: none; padding: 3px "
                           "14px 3px %3px; }")
                .arg(foreground, background)
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
