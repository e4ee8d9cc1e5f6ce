// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/difference_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QSlider>

#include "document/scene_edits.h"
#include "resources/mesh_snapshot.h"
#include "resources/texture_library.h"
#include "text/display_number.h"

namespace patina {
namespace {

constexpr int restMs = 60;
constexpr int stepsPerDecade = 20; ///< of the gain
constexpr double usualGain = 10.0;
constexpr int longestEdge = 1024; ///< pixels; what is shown larger is stretched
constexpr QSize minSize{160, 120};

int stepOf(double gain) {
    return static_cast<int>(std::lround(stepsPerDecade * std::log10(gain)));
}

QString gainText(double gain) {
    return QStringLiteral("× %1").arg(roundText(gain));
}

} // namespace

DifferenceView::DifferenceView(const ViewSources& sources, Viewport& first,
                               std::filesystem::path programCache, QWidget* parent)
    : QFrame(parent), document_(sources.document), first_(first), meshes_(sources.meshes),
      textures_(sources.textures), environments_(sources.environments), switches_(sources.switches),
      effects_(sources.effects), worker_(std::move(programCache)), head_(new QWidget(this)),
      title_(new QLabel(head_)), mode_(new QComboBox(head_)),
      slider_(new QSlider(Qt::Horizontal, head_)), number_(new QLabel(head_)) {
    setMinimumSize(minSize);
    setAccessibleName(tr("View C: the difference of A and B"));
    settle_.setSingleShot(true);
    settle_.setInterval(restMs);
    layOut();
    connectParts();
    setGain(usualGain);
    showPicture();
}

void DifferenceView::layOut() {
    title_->setText(QStringLiteral("<b>&nbsp;C&nbsp;</b>"));
    mode_->addItem(tr("Difference"));
    mode_->setItemData(0, tr("How far A and B are apart in linear light, times the gain"),
                       Qt::ToolTipRole);
    mode_->addItem(tr("Error"));
    mode_->setItemData(1,
                       tr("How wrong B is beside A, relative to A's light: black a millionth or "
                          "less, violet, red, orange and yellow ten times more each, white all of "
                          "it"),
                       Qt::ToolTipRole);
    mode_->setAccessibleName(tr("What C shows"));
    mode_->setMinimumContentsLength(5);
    slider_->setRange(0, stepOf(maxGain));
    slider_->setPageStep(stepsPerDecade);
    slider_->setMinimumWidth(40);
    slider_->setAccessibleName(tr("Gain of the difference"));
    slider_->setToolTip(tr("The difference is shown so many times brighter"));
    number_->setMinimumWidth(fontMetrics().horizontalAdvance(gainText(maxGain)));
    auto* row = new QHBoxLayout(head_);
    row->setContentsMargins(4, 1, 6, 1);
    row->setSpacing(6);
    row->addWidget(title_);
    row->addWidget(mode_);
    row->addWidget(slider_, 1);
    row->addWidget(number_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(2, 2, 2, 2);
    layout->setSpacing(0);
    layout->addWidget(head_);
    layout->addStretch(1);
}

void DifferenceView::connectParts() {
    connect(slider_, &QSlider::valueChanged, this, &DifferenceView::showPicture);
    connect(mode_, &QComboBox::currentIndexChanged, this, &DifferenceView::showPicture);
    connect(&settle_, &QTimer::timeout, this, &DifferenceView::ask);
    connect(&worker_, &DifferenceWorker::finished, this, &DifferenceView::take);
    const auto soon = [this] { refreshSoon(); };
    onChange(document_, DocumentChange::Drawn | DocumentChange::Current, this, soon);
    connect(&effects_, &ProgramEffects::changed, this, soon);
    connect(&textures_, &TextureLibrary::arrived, this, soon);
    connect(&switches_, &EffectSwitches::changed, this, soon);
    connect(&meshes_, &MeshLibrary::loaded, this, soon);
    connect(&environments_, &EnvironmentLibrary::loaded, this, soon);
    connect(&environments_, &EnvironmentLibrary::failed, this, soon);
}

DifferenceView::Mode DifferenceView::mode() const {
    return mode_->currentIndex() == 0 ? Mode::Difference : Mode::Error;
}

void DifferenceView::setMode(Mode mode) {
    mode_->setCurrentIndex(mode == Mode::Difference ? 0 : 1);
}

QString DifferenceView::caption() const {
    return mode_->currentText() + (mode() == Mode::Difference ? ' ' + gainText(gain()) : QString());
}

double DifferenceView::gain() const {
    return std::pow(10.0, double(slider_->value()) / stepsPerDecade);
}

void DifferenceView::setGain(double gain) {
    slider_->setValue(stepOf(std::clamp(gain, 1.0, maxGain)));
}

bool DifferenceView::isUpToDate() const {
    return difference_ && !settle_.isActive() && worker_.isIdle();
}

/// A drag asks again and again: the timer is not put off, so that the picture follows.
void DifferenceView::refreshSoon() {
    if (isVisible() && !settle_.isActive()) {
        settle_.start();
    }
}

DifferenceWorker::Side DifferenceView::sideOf(Side side) {
    const Scene* effects = switches_.effects(side);
    return {switches_.scene(side), effects != nullptr ? std::optional(*effects) : std::nullopt};
}

void DifferenceView::ask() {
    if (!isVisible() || !document_.isComparing()) {
        return;
    }
    const QSizeF pixels = QSizeF(place().size()) * devicePixelRatioF();
    const double shrink =
        std::min(1.0, longestEdge / std::max({pixels.width(), pixels.height(), 1.0}));
    View view;
    view.size = {std::max(1, static_cast<int>(shrink * pixels.width())),
                 std::max(1, static_cast<int>(shrink * pixels.height()))};
    view.camera = first_.camera();
    view.environmentImage = environments_.image(environmentPicture(document_));
    worker_.ask({sideOf(Side::A), sideOf(Side::B), view, meshSnapshot(document_.scene(), meshes_),
                 textures_.snapshot(), document_.sharedCatalog()});
}

void DifferenceView::take(std::shared_ptr<const FrameDifference> difference,
                          const QString& problem) {
    difference_ = std::move(difference);
    problem_ = problem;
    showPicture();
}

void DifferenceView::showPicture() {
    const bool isDifference = mode() == Mode::Difference;
    slider_->setEnabled(isDifference);
    number_->setText(isDifference ? gainText(gain()) : QString());
    picture_ = {};
    if (difference_) {
        const std::vector<unsigned char> bytes =
            isDifference ? shownDifference(*difference_, gain()) : shownErrors(*difference_);
        const glm::ivec2 size = difference_->size;
        picture_ = QImage(bytes.data(), size.x, size.y, 3 * size.x, QImage::Format_RGB888).copy();
    }
    update();
}

QRect DifferenceView::place() const {
    return contentsRect().adjusted(2, 2 + head_->height(), -2, -2);
}

void DifferenceView::paintEvent(QPaintEvent* event) {
    QFrame::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (!picture_.isNull()) {
        painter.drawImage(place(), picture_);
        return;
    }
    painter.fillRect(place(), Qt::black);
    painter.setPen(Qt::lightGray);
    painter.drawText(place(), Qt::AlignCenter | Qt::TextWordWrap,
                     problem_.isEmpty() ? tr("Drawing the difference …") : problem_);
}

void DifferenceView::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    refreshSoon();
}

void DifferenceView::showEvent(QShowEvent* event) {
    QFrame::showEvent(event);
    refreshSoon();
}

void DifferenceView::mousePressEvent(QMouseEvent* event) {
    first_.navigation().press(*event);
}

void DifferenceView::mouseMoveEvent(QMouseEvent* event) {
    first_.navigation().move(*event);
}

void DifferenceView::mouseReleaseEvent(QMouseEvent* event) {
    first_.navigation().release(*event);
}

void DifferenceView::wheelEvent(QWheelEvent* event) {
    first_.navigation().wheel(*event);
    event->accept();
}

} // namespace patina
