// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheets/sheets_dock.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QFileInfo>
#include <QHBoxLayout>
#include <QProgressBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "docks/elided_label.h"
#include "docks/notice_bar.h"
#include "docks/panel.h"
#include "document/document.h"
#include "document/scene_edits.h"
#include "files/file_actions.h"
#include "resources/environment_library.h"
#include "resources/mesh_library.h"
#include "resources/mesh_snapshot.h"
#include "resources/texture_library.h"
#include "scene/scene_assignment.h"
#include "sheet/sheet_file.h"
#include "sheets/cell_taking.h"
#include "sheets/sheet_controls.h"
#include "sheets/sheet_dialogs.h"
#include "sheets/sheet_grid.h"
#include "sheets/sheet_saving.h"
#include "sheets/vertical_title.h"
#include "text/as_text.h"
#include "text/short_text.h"

namespace patina {
namespace {

/// An edit is followed when nothing has changed for this long, so that a drag leaves the time to
/// the views.
constexpr int settleMs = 120;

constexpr int progressSteps = 1000;
constexpr int progressWidth = 80;
constexpr int longestName = 24; ///< letters of a name in a message

} // namespace

SheetsDock::SheetsDock(const DockContext& context)
    : context_(context), document_(context.document), controls_(new SheetControls(this)),
      notice_(new NoticeBar(this)), xTitle_(new ElidedLabel(this)),
      yTitle_(new VerticalTitle(this)), grid_(new SheetGrid(this)), state_(new ElidedLabel(this)),
      progress_(new QProgressBar(this)),
      stop_(textButton(tr("Stop"), tr("Stop drawing and keep the cells that are there"), this)),
      drawing_(programFolder(), this) {
    settle_.setSingleShot(true);
    settle_.setInterval(settleMs);
    layOut();
    connectParts();
    showRunning();
}

SheetsDock::~SheetsDock() = default;

void SheetsDock::layOut() {
    progress_->setRange(0, progressSteps);
    progress_->setMaximumWidth(progressWidth);
    progress_->setTextVisible(false);
    progress_->setAccessibleName(tr("Progress of the sheet"));
    state_->setObjectName("state");
    xTitle_->setAlignment(Qt::AlignCenter);
    auto* line = new QWidget(this);
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(state_, 1);
    row->addWidget(progress_);
    row->addWidget(stop_);
    line->setMinimumHeight(stop_->sizeHint().height()); // nothing moves when it comes
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 2);
    layout->setSpacing(4);
    layout->addWidget(controls_);
    layout->addWidget(notice_);
    layout->addWidget(xTitle_);
    auto* beside = new QHBoxLayout;
    beside->setSpacing(0);
    beside->addWidget(yTitle_);
    beside->addWidget(grid_, 1);
    layout->addLayout(beside, 1);
    layout->addWidget(line);
}

void SheetsDock::connectParts() {
    connect(controls_, &SheetControls::wished, this, &SheetsDock::setSheet);
    connect(controls_, &SheetControls::exampleWished, this, &SheetsDock::open);
    connect(controls_, &SheetControls::openWished, this,
            [this] { open(askForSheet(this, context_.session)); });
    connect(controls_, &SheetControls::saveWished, this,
            [this] { save(askWhereToSaveSheet(this, context_.session, suggestedName())); });
    connect(controls_, &SheetControls::exportWished, this,
            [this] { writeTo(askWhereToExportSheet(this, context_.session, suggestedName())); });
    connect(stop_, &QToolButton::clicked, this, [this] {
        drawing_.cancel();
        drawing_.cancelWriting();
    });
    connect(grid_, &SheetGrid::chosen, this, &SheetsDock::choose);
    connect(grid_, &SheetGrid::fitted, this, &SheetsDock::placeTitles);
    connect(&drawing_, &SheetDrawing::planned, this, &SheetsDock::showPlan);
    connect(&drawing_, &SheetDrawing::refused, this, &SheetsDock::showRefusal);
    connect(&drawing_, &SheetDrawing::drawn, this,
            [this](int index, const SheetCell& cell) { grid_->table().setCell(index, cell); });
    connect(&drawing_, &SheetDrawing::finished, this, &SheetsDock::showEnd);
    connect(&drawing_, &SheetDrawing::written, this, &SheetsDock::showWritten);
    connect(&drawing_, &SheetDrawing::progressed, this, &SheetsDock::showProgress);
    connect(&settle_, &QTimer::timeout, this, &SheetsDock::follow);
    onChange(document_, DocumentChange::Drawn | DocumentChange::Current, this,
             &SheetsDock::followLater);
    const auto renew = [this] {
        ++revision_;
        followLater();
    };
    connect(&context_.meshes, &MeshLibrary::loaded, this, renew);
    connect(&context_.meshes, &MeshLibrary::opennessFound, this, renew);
    connect(&context_.textures, &TextureLibrary::arrived, this, renew);
    connect(&context_.environments, &EnvironmentLibrary::loaded, this, renew);
}

/// Puts the titles of the axes in the middle of the cells: there is room beside them in a wide
/// panel.
void SheetsDock::placeTitles() {
    const QRect cells = grid_->cells();
    xTitle_->setContentsMargins(grid_->x() + cells.left() - xTitle_->x(), 0,
                                grid_->width() - cells.left() - cells.width(), 0);
    yTitle_->setContentsMargins(0, cells.top(), 0, grid_->height() - cells.top() - cells.height());
}

void SheetsDock::setSheet(const Sheet& sheet) {
    hasAxes_ = true;
    if (sheet != sheet_) {
        sheet_ = sheet;
        followLater();
    }
    showControls();
}

bool SheetsDock::isIdle() const {
    return !settle_.isActive() && !drawing_.isDrawing() && !drawing_.isWriting();
}

void SheetsDock::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    settle_.start(settleMs); // a tab may be seen for a moment only, while a window comes
}

void SheetsDock::hideEvent(QHideEvent* event) {
    settle_.stop();
    drawing_.cancel();
    QWidget::hideEvent(event);
}

/// Stops drawing what is out of date, and follows when edits have ended. A hidden panel follows
/// when it is shown.
void SheetsDock::followLater() {
    drawing_.cancel();
    if (isVisible()) {
        settle_.start(settleMs);
    }
}

void SheetsDock::follow() {
    const int object = document_.selection().object();
    if (object < 0) {
        grid_->table().clear();
        xTitle_->setElidedText({});
        yTitle_->setText({});
        notice_->say(tr("There is no object to draw."));
        return;
    }
    const SheetStart::Subject subject{document_.selection().side(),
                                      static_cast<std::size_t>(object)};
    const Scene shown = drawnScene(document_.ownScene(subject.side));
    if (!hasAxes_) {
        chooseAxes(axisOffers(shown, subject.object, document_.catalog()));
    }
    start_.follow(shown, subject, sheet_);
    offers_ = axisOffers(*start_.scene(), subject.object, document_.catalog());
    showControls();
    drawing_.ask(request());
}

/// Chooses the first two numbers of the model that count; the first thing there is where none does.
void SheetsDock::chooseAxes(const std::vector<AxisOffer>& offers) {
    std::vector<SheetAxis> axes;
    for (const AxisOffer& offer : offers) {
        if (offer.of && offer.counts && axes.size() < 2) {
            axes.push_back(offer.axis);
        }
    }
    if (axes.empty() && !offers.empty()) {
        axes.push_back(offers.front().axis);
    }
    if (!axes.empty()) {
        sheet_.x = axes[0];
        sheet_.y = axes.size() > 1 ? std::optional(axes[1]) : std::nullopt;
        hasAxes_ = true;
    }
}

SheetDrawing::Request SheetsDock::request() {
    const Side side = document_.selection().side();
    SheetDrawing::Request request;
    request.sheet = sheet_;
    request.start = start_.scene();
    request.shown = drawnScene(document_.ownScene(side));
    request.object = static_cast<std::size_t>(document_.selection().object());
    request.catalog = document_.sharedCatalog();
    request.meshes = meshSnapshot(request.shown, context_.meshes);
    request.textures = context_.textures.snapshot();
    request.panoramaFile = std::string(environmentPicture(document_, side));
    request.panorama = context_.environments.image(request.panoramaFile);
    request.revision = revision_;
    return request;
}

void SheetsDock::showControls() {
    if (start_.scene() && hasAxes_) {
        const AxisRow::Subject subject{*start_.scene(), start_.object(), document_.catalog(),
                                       offers_};
        controls_->show(sheet_, &subject);
    } else {
        controls_->show(sheet_, nullptr);
    }
}

void SheetsDock::showPlan(const PlannedSheet& planned) {
    notice_->clear();
    grid_->table().setSheet(planned);
    xTitle_->setElidedText(asText(planned.plan->x().title));
    yTitle_->setText(planned.plan->y() ? asText(planned.plan->y()->title) : QString());
    if (const QModelIndex wished = std::exchange(wished_, {}); wished.isValid()) {
        choose(wished);
    }
}

/// Says why there is no sheet. A button lets each axis that has lost what it was of go through the
/// first thing there is that the other one does not go through.
void SheetsDock::showRefusal(const SheetRefusal& why) {
    grid_->table().clear();
    xTitle_->setElidedText({});
    yTitle_->setText({});
    QStringList words;
    QStringList names;
    Sheet mended = sheet_;
    if (why.isXDead) {
        words << wordsFor(sheet_.x);
        if (const AxisOffer* offer = freeOffer(mended.y && !why.isYDead ? &*mended.y : nullptr)) {
            mended.x = offer->axis;
            names << asText(offer->label);
        }
    }
    if (why.isYDead) {
        words << wordsFor(*sheet_.y);
        if (const AxisOffer* offer = freeOffer(&mended.x)) {
            mended.y = offer->axis;
            names << asText(offer->label);
        }
    }
    if (names.isEmpty()) {
        notice_->say(words.isEmpty() ? why.text : words.join(' '));
        return;
    }
    const QString others = names.join(tr(" and "));
    notice_->say(words.join(' '),
                 {{tr("Use %1").arg(shortened(others, longestName)),
                   tr("Go through %1 instead").arg(others), [this, mended] { setSheet(mended); }}});
}

/// Returns the first thing that an axis may be of but the other one is not; null where there is
/// none.
const AxisOffer* SheetsDock::freeOffer(const SheetAxis* other) const {
    const auto found = std::ranges::find_if(offers_, [other](const AxisOffer& each) {
        return other == nullptr || !isSameAxis(each.axis, *other);
    });
    return found == offers_.end() ? nullptr : &*found;
}

/// Returns the words for an axis that is of nothing that there is.
QString SheetsDock::wordsFor(const SheetAxis& axis) const {
    const Material* material = document_.material(document_.selection().side());
    const Block* model =
        material ? document_.catalog().find(kinds::models, material->model.id) : nullptr;
    if (!model || axis.kind != AxisKind::Value ||
        isForScene(axis.value + '=', document_.catalog())) {
        return tr("There is no “%1” any more.").arg(shortened(asText(axis.value), longestName));
    }
    QString name = asText(axis.value);
    for (const Block* each : document_.catalog().ofKind(kinds::models)) {
        if (const Parameter* parameter = each->parameter(axis.value)) {
            name = asText(parameter->label);
            break;
        }
    }
    return tr("%1 has no “%2”.")
        .arg(shortened(asText(model->label), longestName), shortened(name, longestName));
}

void SheetsDock::showEnd(const SheetEnd& end) {
    if (!end.problem.isEmpty()) {
        notice_->say(end.problem);
    }
    const auto& plan = grid_->table().plan();
    const int cells = plan ? plan->columns() * plan->rows() : 0;
    state_->setElidedText(!plan         ? QString()
                          : end.isWhole ? tr("%1 × %2 cells").arg(plan->columns()).arg(plan->rows())
                                        : tr("Stopped: %1 of %2 cells are out of date")
                                              .arg(grid_->table().dueCells())
                                              .arg(cells));
    showRunning();
}

void SheetsDock::showWritten(const QString& file, const Errors& problems) {
    for (const Error& problem : problems) {
        context_.files.report(problem);
    }
    if (!problems.empty()) {
        notice_->say(tr("%1 is not written: %2")
                         .arg(QFileInfo(file).fileName(), asText(problems.front().text())));
    } else if (!file.isEmpty()) {
        state_->setElidedText(tr("%1 is written").arg(QFileInfo(file).fileName()));
        Q_EMIT saved(file);
    }
    showRunning();
}

void SheetsDock::showProgress(double share, const QString& doing) {
    progress_->setValue(static_cast<int>(std::lround(share * progressSteps)));
    state_->setElidedText(doing);
    showRunning();
}

void SheetsDock::showRunning() {
    const bool isRunning = drawing_.isDrawing() || drawing_.isWriting();
    progress_->setVisible(isRunning);
    stop_->setVisible(isRunning);
}

/// Takes a cell, at once or when the sheet has followed: one that is out of date would take back
/// what has changed since.
void SheetsDock::choose(const QModelIndex& cell) {
    const Scene shown = drawnScene(document_.ownScene(document_.selection().side()));
    if (grid_->table().sheet() == sheet_ && start_.holds(shown)) {
        take(cell);
        return;
    }
    wished_ = cell;
    settle_.start(0);
}

void SheetsDock::take(const QModelIndex& cell) {
    const std::shared_ptr<const SheetPlan> plan = grid_->table().plan();
    if (plan && takeCell(document_, *plan, cell.column(), cell.row())) {
        start_.noteTaken(drawnScene(document_.ownScene(document_.selection().side())));
        grid_->table().markShown(cell);
    }
}

void SheetsDock::open(const QString& file) {
    if (file.isEmpty()) {
        return;
    }
    const auto reading = readSheet(file.toStdString());
    if (!reading) {
        for (const Error& error : reading.error()) {
            context_.files.report(error);
        }
        notice_->say(tr("%1 cannot be read: %2")
                         .arg(QFileInfo(file).fileName(), asText(reading.error().front().text())));
        return;
    }
    for (const Error& note : reading->notes) {
        context_.files.report(note);
    }
    if (!reading->sheet.preset.empty()) {
        context_.files.applyPreset(asText(reading->sheet.preset), document_.selection().side());
    }
    setSheet(reading->sheet);
}

void SheetsDock::save(const QString& file) {
    if (file.isEmpty() || !isUpToDate()) {
        return;
    }
    const Material& start = start_.scene()->objects[start_.object()].material;
    const auto written = saveSheet(file.toStdString(), sheet_, start, document_.catalog());
    if (!written) {
        showWritten(file, oneError(written.error()));
        return;
    }
    sheet_ = *written;
    showWritten(file, {});
}

void SheetsDock::writeTo(const QString& file) {
    if (!file.isEmpty() && isUpToDate()) {
        drawing_.write(request(), file.toStdString());
        showRunning();
    }
}

/// Follows what has changed; returns false where there is nothing to make a sheet of.
bool SheetsDock::isUpToDate() {
    if (settle_.isActive() || !start_.scene()) {
        settle_.stop();
        follow();
    }
    return start_.scene() && document_.selection().object() >= 0;
}

QString SheetsDock::suggestedName() const {
    const Material* material = document_.material(document_.selection().side());
    const QString name = !sheet_.name.empty() ? asText(sheet_.name)
                         : material           ? asText(material->name)
                                              : QString();
    return SaveActions::asFileName(name.isEmpty() ? tr("Sheet") : name);
}

} // namespace patina
