// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/effects_dock.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "docks/effect_list.h"
#include "docks/family_chooser.h"
#include "docks/panel.h"
#include "docks/pass_times_dialog.h"
#include "docks/settling.h"
#include "document/document.h"
#include "document/scene_edits.h"
#include "resources/environment_library.h"
#include "resources/mesh_library.h"
#include "resources/mesh_snapshot.h"
#include "resources/texture_library.h"
#include "viewport/compare_area.h"
#include "viewport/effect_switches.h"
#include "viewport/viewport.h"

namespace patina {
namespace {

constexpr int progressSteps = 1000;
constexpr int settleMs = 100;
constexpr int usualRows = 14;
constexpr int spacing = 4;

} // namespace

EffectsDock::EffectsDock(const DockContext& context)
    : document_(context.document), library_(context.meshes), textures_(context.textures),
      environments_(context.environments), switches_(context.switches), views_(context.views),
      measurement_(context.document),
      start_(textButton(tr("Measure costs"),
                        tr("Draw the scene with and without each effect and compare the times"),
                        this)),
      cancel_(textButton(tr("Cancel"), tr("Stop and keep what was measured so far"), this)),
      allOn_(textButton(tr("All on"), tr("Show every effect in the views again"), this)),
      passes_(textButton(tr("Passes…"),
                         tr("List what each pass of the measured frames takes: shadow maps, solid "
                            "objects, background and the others"),
                         this)),
      progress_(new QProgressBar(this)), state_(new QLabel(this)), family_(new FamilyChooser(this)),
      list_(new EffectList(document_, switches_, measurement_, this)) {
    settle_.setSingleShot(true);
    settle_.setInterval(settleMs);
    layOut();
    connectParts();
    watchViews();
    updateRows();
}

/// A view of another shape, or with a camera of its own, shows other parts of the scene.
void EffectsDock::watchViews() {
    views_.installEventFilter(this);
    const auto later = [this] { settle_.start(); };
    connect(&views_.cameras(), &ViewCameras::linkChanged, this, later);
    connect(&views_, &CompareArea::viewAdded, this,
            [this, later](SideView* view) { connect(view, &SideView::cameraWished, this, later); });
}

void EffectsDock::layOut() {
    progress_->setRange(0, progressSteps);
    progress_->setMaximumWidth(300);
    progress_->setAccessibleName(tr("Progress of the measurement"));
    state_->setObjectName("total");
    state_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    state_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // never widens the dock
    auto* row = new QHBoxLayout;
    row->addWidget(start_);
    row->addWidget(cancel_);
    row->addWidget(progress_);
    row->addWidget(state_, 1);
    row->addWidget(passes_);
    row->addWidget(family_);
    row->addWidget(allOn_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 0);
    layout->setSpacing(spacing);
    layout->addLayout(row);
    layout->addWidget(list_, 1);
}

void EffectsDock::connectParts() {
    connect(start_, &QToolButton::clicked, this, [this] { measure(); });
    connect(cancel_, &QToolButton::clicked, &measurement_, &EffectMeasurement::cancel);
    connect(passes_, &QToolButton::clicked, this, [this] {
        if (const EffectCosts* costs = measurement_.costs()) {
            (new PassTimesDialog(*costs, window()))->open();
        }
    });
    list_->setFamily(family_->family());
    connect(family_, &QComboBox::currentIndexChanged, this,
            [this] { list_->setFamily(family_->family()); });
    connect(allOn_, &QToolButton::clicked, &switches_, &EffectSwitches::switchAllOn);
    connect(&measurement_, &EffectMeasurement::progressed, this, [this](double share) {
        progress_->setValue(static_cast<int>(std::lround(share * progressSteps)));
    });
    connect(&measurement_, &EffectMeasurement::ended, this, &EffectsDock::refresh);
    connect(&settle_, &QTimer::timeout, this, &EffectsDock::updateRows);
    startWhenChanged(settle_, document_, library_);
    const auto later = [this] { settle_.start(); };
    connect(&textures_, &TextureLibrary::arrived, this, later);
    connect(&environments_, &EnvironmentLibrary::loaded, this, later);
    connect(&environments_, &EnvironmentLibrary::failed, this, later);
    connect(&switches_, &EffectSwitches::changed, this, &EffectsDock::updateRows);
    onChange(document_, DocumentChange::Scene, this, [this] {
        measurement_.forget();
        updateRows();
        list_->refresh();
    });
}

void EffectsDock::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    updateRows();
}

bool EffectsDock::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) {
        settle_.start();
    }
    return QWidget::eventFilter(watched, event);
}

/// Leaves the list alone while nobody sees it.
void EffectsDock::updateRows() {
    std::vector<EffectRow> rows = currentRows();
    if ((isVisible() && !list_->shows(rows)) || list_->rows().empty()) {
        list_->setRows(std::move(rows));
    }
    showState();
}

/// Returns the effects of the current object as the active view's camera sees it.
std::vector<EffectRow> EffectsDock::currentRows() const {
    const int object = document_.selection().object();
    if (object < 0) {
        return {};
    }
    const Scene& scene = document_.scene(document_.selection().side());
    const auto meshes = [this](const Object& each) { return library_.view(each); };
    const auto rowsOf = [&](const Scene& seen) {
        return objectRows(seen, static_cast<std::size_t>(object), document_.catalog(), meshes,
                          images(), aspect());
    };
    const Camera& camera = views_.active().viewport().camera();
    if (camera == scene.camera) {
        return rowsOf(scene);
    }
    Scene turned = scene;
    turned.camera = camera;
    return rowsOf(turned);
}

/// Returns what the views have of the images now; none is read for the list.
KnownImages EffectsDock::images() const {
    return {textures_.snapshot(),
            environments_.isMissing(environmentPicture(document_, document_.selection().side()))};
}

/// Returns width by height of the view that shows the current object.
double EffectsDock::aspect() const {
    const Viewport& view = views_.active().viewport();
    return double(view.width()) / std::max(view.height(), 1);
}

/// Has room for so many rows that most scenes show without scrolling.
QSize EffectsDock::sizeHint() const {
    return {640, list_->heightOf(usualRows) + start_->sizeHint().height() + 3 * spacing};
}

void EffectsDock::measure(EffectCostMeter::Options options) {
    if (isMeasuring() || document_.selection().object() < 0) {
        return;
    }
    updateRows();
    const Side side = document_.selection().side();
    const Scene& scene = document_.scene(side);
    progress_->setValue(0);
    measurement_.start({scene, scene.camera, meshSnapshot(scene, library_), list_->rows(),
                        document_.sharedCatalog(), images().textures,
                        environments_.image(environmentPicture(document_, side))},
                       std::move(options));
    refresh();
}

void EffectsDock::refresh() {
    list_->refresh();
    showState();
}

void EffectsDock::showState() {
    const bool running = isMeasuring();
    start_->setEnabled(!running && document_.selection().object() >= 0);
    cancel_->setVisible(running);
    progress_->setVisible(running);
    const EffectCosts* costs = measurement_.costs();
    passes_->setEnabled(!running && costs != nullptr && !costs->passes.empty());
    allOn_->setEnabled(!switches_.off().empty());
    state_->setText(measurement_.stateText(list_->rows()));
    state_->setToolTip(state_->text());
}

} // namespace patina
