// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/preset_view.h"

#include <algorithm>

#include <QAction>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <QToolTip>

#include "docks/rounded_picture.h"
#include "library/thumbnail_maker.h"
#include "material/variant.h"
#include "text/png.h"

namespace patina {
namespace {

constexpr int itemMargin = 14;
constexpr int maxAsked = 3;
constexpr int minKept = 200; ///< images
constexpr int tipMs = 60000;
const QString askedPrefix = QStringLiteral("preset/");
const QString tipName = QStringLiteral("preset-tip");

/// Lays a preset out in the grid or as a line of the list, with a star where it is a favourite.
class PresetDelegate : public QStyledItemDelegate {
  public:
    PresetDelegate(const PresetList& list, const PresetView& view, QObject* parent)
        : QStyledItemDelegate(parent), list_(list), view_(view) {}

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyledItemDelegate::paint(painter, option, index);
        if (list_.isFavourite(index)) {
            paintStar(*painter, option);
        }
    }

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
        if (!view_.isAsList()) {
            return view_.gridSize();
        }
        const int lines = 2 * option.fontMetrics.lineSpacing();
        return {view_.viewport()->width(), std::max(view_.pictureSize(), lines) + 8};
    }

  protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        option->decorationSize = {view_.pictureSize(), view_.pictureSize()};
        option->decorationPosition =
            view_.isAsList() ? QStyleOptionViewItem::Left : QStyleOptionViewItem::Top;
        option->displayAlignment =
            view_.isAsList() ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignHCenter | Qt::AlignTop;
        option->features.setFlag(QStyleOptionViewItem::WrapText, !view_.isAsList());
    }

  private:
    /// Draws a light star with a dark edge, so that it is visible on any image.
    void paintStar(QPainter& painter, const QStyleOptionViewItem& option) const {
        const int size = option.fontMetrics.height();
        const QRect& all = option.rect;
        const int right = view_.isAsList() ? all.left() + view_.pictureSize()
                                           : all.center().x() + view_.pictureSize() / 2;
        const QPointF place(right - size, all.top() + size + 2);
        QPainterPath star;
        star.addText(place, option.font, QStringLiteral("★"));
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.strokePath(star, QPen(QColor(0, 0, 0, 200), 3.0));
        painter.fillPath(star, QColor(0xff, 0xd2, 0x4a));
        painter.restore();
    }

    const PresetList& list_;
    const PresetView& view_;
};

QString paragraph(const QString& text) {
    return text.isEmpty() ? QString() : "<p>" + text.toHtmlEscaped() + "</p>";
}

QString asHtml(const QImage& picture) {
    constexpr int quick = 90; // compresses little, as it is shown once
    return QStringLiteral("<img src=\"data:image/png;base64,%1\" width=%2 height=%3>")
        .arg(QString::fromLatin1(asPng(picture, quick).toBase64()))
        .arg(picture.width())
        .arg(picture.height());
}

} // namespace

PresetView::PresetView(PresetList& list, ThumbnailMaker& thumbnails, QWidget* parent)
    : QListView(parent), list_(list), thumbnails_(thumbnails) {
    setModel(&list);
    setItemDelegate(new PresetDelegate(list, *this, this));
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setResizeMode(QListView::Adjust);
    setUniformItemSizes(true);
    setTextElideMode(Qt::ElideRight);
    setFrameShape(QFrame::NoFrame);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(&thumbnails, &ThumbnailMaker::ready, this, &PresetView::take);
    connect(this, &QListView::clicked, this, [this](const QModelIndex& index) {
        if (selectionModel()->selectedIndexes().size() == 1) {
            Q_EMIT tried(list_.entry(index));
        }
    });
    connect(this, &QListView::doubleClicked, this,
            [this](const QModelIndex& index) { Q_EMIT applied(list_.entry(index)); });
    setAsList(false);
}

void PresetView::setAsList(bool asList) {
    asList_ = asList;
    list_.setDetailed(asList);
    setViewMode(asList ? QListView::ListMode : QListView::IconMode);
    setMovement(QListView::Static); // each mode has its own
    setDragEnabled(true);
    setDragDropMode(QAbstractItemView::DragOnly);
    setSpacing(0);
    fit();
}

void PresetView::setPictureSize(int pixels) {
    const int size = std::clamp(pixels, minPictureSize, maxPictureSize);
    if (size > pictureSize_) {
        list_.forgetPictures(); // they are too small now
    }
    pictureSize_ = size;
    fit();
    if (currentIndex().isValid()) {
        doItemsLayout();
        scrollTo(currentIndex());
    }
}

void PresetView::setRows(std::vector<PresetPtr> rows) {
    const int inSight = verticalScrollBar()->value();
    const PresetPtr before = current();
    const std::vector<PresetPtr> chosen = selected();
    list_.setRows(std::move(rows));
    QItemSelection selection;
    for (const PresetPtr& entry : chosen) {
        const QModelIndex index = list_.indexOf(entry->path);
        if (index.isValid()) {
            selection.select(index, index);
        }
    }
    const QModelIndex same = before ? list_.indexOf(before->path) : QModelIndex();
    if (same.isValid()) {
        selectionModel()->setCurrentIndex(same, QItemSelectionModel::NoUpdate);
    }
    selectionModel()->select(selection, QItemSelectionModel::ClearAndSelect);
    fit();
    doItemsLayout(); // gives the scroll bar its range
    verticalScrollBar()->setValue(inSight);
}

void PresetView::choose(const PresetPtr& entry) {
    if (const QModelIndex index = list_.indexOf(entry->path); index.isValid()) {
        setCurrentIndex(index);
    }
}

PresetPtr PresetView::current() const {
    return currentIndex().isValid() ? list_.entry(currentIndex()) : nullptr;
}

std::vector<PresetPtr> PresetView::selected() const {
    QModelIndexList indexes = selectionModel()->selectedIndexes();
    std::ranges::sort(indexes, {}, &QModelIndex::row);
    std::vector<PresetPtr> entries;
    for (const QModelIndex& index : indexes) {
        entries.push_back(list_.entry(index));
    }
    return entries;
}

void PresetView::paintEvent(QPaintEvent* event) {
    QListView::paintEvent(event);
    wishPictures();
}

void PresetView::wishPictures() {
    if (list_.rowCount() == 0) {
        return;
    }
    const int height = asList_ ? sizeHintForIndex(list_.index(0)).height() : gridSize().height();
    const int top = std::max(verticalScrollBar()->value() / std::max(height, 1), 0) * columns_;
    for (int row = top; row < list_.rowCount() && asked_.size() < maxAsked; ++row) {
        const QModelIndex index = list_.index(row);
        if (visualRect(index).top() > viewport()->height()) {
            return;
        }
        const PresetPtr& entry = list_.entry(index);
        const bool isAsked = std::ranges::find(asked_, entry) != asked_.end();
        if (!list_.hasPicture(index) && !isAsked && !without_.contains(entry->path)) {
            const QString name = askedPrefix + QString::number(++lastAsked_);
            asked_[name] = entry;
            thumbnails_.ask(name, entry->material);
        }
    }
}

void PresetView::take(const QString& name, const QImage& picture) {
    if (name == tipName && tipOf_) {
        const QModelIndex below = indexAt(viewport()->mapFromGlobal(QCursor::pos()));
        if (QToolTip::isVisible() && below.isValid() && list_.entry(below) == tipOf_) {
            QToolTip::showText(tipPlace_, asHtml(picture) + toolTipOf(*tipOf_), viewport(),
                               visualRect(below), tipMs);
        }
        tipOf_ = nullptr;
        return;
    }
    const PresetPtr entry = asked_.take(name);
    if (!entry) {
        return;
    }
    if (picture.isNull()) {
        without_.insert(entry->path);
        list_.setPicture(entry, emptyPicture());
    } else {
        const int size = static_cast<int>(pictureSize_ * devicePixelRatioF());
        list_.setPicture(entry, rounded(picture.scaled(size, size, Qt::IgnoreAspectRatio,
                                                       Qt::SmoothTransformation)));
    }
    wishPictures();
}

void PresetView::wishAnew() {
    without_.clear();
    asked_.clear();
    list_.outdatePictures();
    viewport()->update();
}

/// Draws the small pictures that were given up when the user stopped that.
void PresetView::showEvent(QShowEvent* event) {
    if (thumbnails_.isStopped()) {
        thumbnails_.goOn();
        wishAnew();
    }
    QListView::showEvent(event);
}

/// Makes the first row current so that the keys have a place to start; does not select it.
void PresetView::focusInEvent(QFocusEvent* event) {
    if (!currentIndex().isValid() && list_.rowCount() > 0) {
        selectionModel()->setCurrentIndex(list_.index(0), QItemSelectionModel::NoUpdate);
    }
    QListView::focusInEvent(event);
}

namespace {

/// Returns the enabled action for a key; null if there is none.
QAction* actionOf(const QWidget& widget, const QKeyEvent& event) {
    const QKeySequence pressed(event.keyCombination());
    const QList<QAction*> actions = widget.actions();
    const auto found = std::ranges::find_if(actions, [&pressed](const QAction* action) {
        return action->isEnabled() && action->shortcuts().contains(pressed);
    });
    return found == actions.end() ? nullptr : *found;
}

} // namespace

/// Takes keys of its own actions, so that the window's actions with these keys, such as undo, do
/// not run.
bool PresetView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride &&
        actionOf(*this, *static_cast<QKeyEvent*>(event))) {
        event->accept();
        return true;
    }
    return QListView::event(event);
}

void PresetView::keyPressEvent(QKeyEvent* event) {
    if (QAction* action = actionOf(*this, *event)) {
        action->trigger();
        return;
    }
    if (const int by = arrowsAreSteps_ ? stepOf(*event) : 0; by != 0) {
        Q_EMIT stepped(by, event->modifiers().testFlag(Qt::ShiftModifier));
        return;
    }
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const PresetPtr before = current();
    if (isEnter && before) {
        Q_EMIT applied(before);
        return;
    }
    QListView::keyPressEvent(event);
    if (const PresetPtr now = current(); now && now != before && selected().size() == 1) {
        Q_EMIT tried(now);
    }
}

/// Returns how many rows an arrow goes on; 0 for another key.
int PresetView::stepOf(const QKeyEvent& event) const {
    if ((event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) != Qt::NoModifier) {
        return 0;
    }
    switch (event.key()) {
    case Qt::Key_Left:
        return -1;
    case Qt::Key_Right:
        return 1;
    case Qt::Key_Up:
        return -columns_;
    case Qt::Key_Down:
        return columns_;
    default:
        return 0;
    }
}

void PresetView::selectionChanged(const QItemSelection& on, const QItemSelection& off) {
    QListView::selectionChanged(on, off);
    Q_EMIT selectedChanged();
}

bool PresetView::viewportEvent(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto& help = *static_cast<QHelpEvent*>(event);
        showTip(indexAt(help.pos()), help.globalPos());
        return true;
    }
    return QListView::viewportEvent(event);
}

/// Shows the tool tip at once with the small image; take() replaces that with the large one.
void PresetView::showTip(const QModelIndex& index, const QPoint& place) {
    if (!index.isValid()) {
        QToolTip::hideText();
        return;
    }
    tipOf_ = list_.entry(index);
    tipPlace_ = place;
    QString picture;
    if (list_.hasPicture(index)) {
        const QSize size(ThumbnailMaker::pixels, ThumbnailMaker::pixels);
        const QIcon icon = index.data(Qt::DecorationRole).value<QIcon>();
        picture = asHtml(icon.pixmap(icon.availableSizes().value(0))
                             .toImage()
                             .scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    }
    QToolTip::showText(place, picture + toolTipOf(*tipOf_), viewport(), visualRect(index), tipMs);
    thumbnails_.ask(tipName, tipOf_->material);
}

/// Keeps the current item in view when the items move to other rows.
void PresetView::resizeEvent(QResizeEvent* event) {
    QListView::resizeEvent(event);
    fit();
    if (currentIndex().isValid()) {
        doItemsLayout(); // updates the items' places
        scrollTo(currentIndex());
    }
}

void PresetView::changeEvent(QEvent* event) {
    QListView::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::PaletteChange) {
        fit();
    }
}

/// Fits as many columns as have room, and spreads them over the whole width.
void PresetView::fit() {
    setIconSize({pictureSize_, pictureSize_});
    list_.setEmptyPicture(emptyPicture());
    const int bar = verticalScrollBar()->isVisible() ? 0 : verticalScrollBar()->sizeHint().width();
    const int width = viewport()->width() - bar - 2;
    columns_ = asList_ ? 1 : std::max(1, width / (pictureSize_ + itemMargin));
    const int height = pictureSize_ + 2 * fontMetrics().lineSpacing() + itemMargin;
    setGridSize(asList_ ? QSize() : QSize(std::max(width / columns_, 1), height));
    const int lines = viewport()->height() / std::min(height, pictureSize_ + 8) + 2;
    list_.setMaxPictures(std::max(minKept, 3 * columns_ * lines));
    scheduleDelayedItemsLayout();
}

QIcon PresetView::emptyPicture() const {
    QImage empty(pictureSize_, pictureSize_, QImage::Format_RGB888);
    empty.fill(palette().color(QPalette::Midlight));
    return rounded(empty);
}

QString toolTipOf(const PresetEntry& entry) {
    const Material& material = entry.material;
    const QString author = QString::fromStdString(material.author);
    QString tip = QStringLiteral("<p><b>%1</b><br>%2</p>")
                      .arg(entry.name.toHtmlEscaped(), entry.modelLabel.toHtmlEscaped());
    tip += paragraph(QString::fromStdString(material.description));
    tip += paragraph(joinedTags(material));
    if (const std::filesystem::path parent = parentOf(material); !parent.empty()) {
        tip += paragraph(QObject::tr("Variant of %1")
                             .arg(QString::fromStdString(parent.stem().stem().string())));
    }
    const QString from = entry.shipped ? QObject::tr("Comes with Patina") : entry.path;
    return tip + QStringLiteral("<p><i>%1</i></p>")
                     .arg((author.isEmpty() || entry.shipped ? from : author + ", " + from)
                              .toHtmlEscaped());
}

} // namespace patina
