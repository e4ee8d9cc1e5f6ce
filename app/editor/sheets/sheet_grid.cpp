// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheets/sheet_grid.h"

#include <algorithm>

#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <QStyledItemDelegate>

namespace patina {
namespace {

constexpr int gap = 2;          ///< pixels around a picture
constexpr int apart = 8;        ///< pixels above the control row
constexpr int smallest = 36;    ///< pixels of a cell's side
constexpr int wellSeen = 64;    ///< pixels; cells are not made smaller to show all rows
constexpr double faint = 0.35;  ///< is the opacity of pictures that are out of date
constexpr int widestLabel = 96; ///< pixels

QFont captionFont(const QFont& font) {
    QFont small = font;
    small.setPointSizeF(0.85 * font.pointSizeF());
    return small;
}

int captionHeight(const QFont& font, int lines) {
    return lines * QFontMetrics(captionFont(font)).height();
}

/// Draws a cell: its picture, what was measured below it, and a frame around what is shown.
class CellDelegate : public QStyledItemDelegate {
  public:
    CellDelegate(const CellTable& table, QObject* parent)
        : QStyledItemDelegate(parent), table_(table) {}

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const SheetCell& cell = table_.cell(index);
        QRect room = option.rect.adjusted(gap, gap, -gap, -gap);
        room.setTop(room.top() + (table_.isControl(index.row()) ? apart : 0));
        const int side = room.width();
        const QRect square(room.topLeft(), QSize(side, side));
        painter->save();
        painter->setRenderHint(QPainter::SmoothPixmapTransform);
        if (cell.picture.isNull()) {
            painter->fillRect(square, option.palette.color(QPalette::AlternateBase));
        } else {
            painter->setOpacity(cell.isDue ? faint : 1.0);
            painter->drawImage(square, scaled(cell.picture, square.size(), *painter));
            painter->setOpacity(1.0);
        }
        if (!cell.problem.isEmpty()) {
            writeProblem(*painter, option, square, cell.problem);
        }
        writeCaption(*painter, option, {square.left(), square.bottom() + 1, side, room.bottom()},
                     table_.caption(index));
        frame(*painter, option, square, cell.isShown);
        painter->restore();
    }

  private:
    /// Returns a picture no larger than it is shown: made smaller by the painter it would flicker
    /// between pixels.
    static QImage scaled(const QImage& picture, const QSize& size, const QPainter& painter) {
        const QSize pixels = size * painter.device()->devicePixelRatioF();
        return picture.width() > pixels.width()
                   ? picture.scaled(pixels, Qt::KeepAspectRatio, Qt::SmoothTransformation)
                   : picture;
    }

    static void writeProblem(QPainter& painter, const QStyleOptionViewItem& option,
                             const QRect& square, const QString& problem) {
        painter.setFont(captionFont(option.font));
        painter.setPen(option.palette.color(QPalette::PlaceholderText));
        painter.drawText(square.adjusted(2, 2, -2, -2), Qt::AlignCenter | Qt::TextWordWrap,
                         problem);
    }

    static void writeCaption(QPainter& painter, const QStyleOptionViewItem& option, QRect room,
                             const QStringList& lines) {
        const QFont font = captionFont(option.font);
        const QFontMetrics metrics(font);
        painter.setFont(font);
        painter.setPen(option.palette.color(QPalette::Text));
        for (const QString& line : lines) {
            const bool fits = metrics.horizontalAdvance(line) <= room.width();
            painter.drawText(QRect(room.left(), room.top(), room.width(), metrics.height()),
                             Qt::AlignCenter, fits ? line : withoutName(line));
            room.setTop(room.top() + metrics.height());
        }
    }

    /// Returns "0.82" of "albedo 0.82": what stands before the number goes first where room is
    /// short.
    static QString withoutName(const QString& line) {
        return line.front().isDigit() ? line : line.section(QLatin1Char(' '), -1);
    }

    /// Draws a frame around what the document shows, and one around the cell that has the focus or
    /// is under the mouse.
    static void frame(QPainter& painter, const QStyleOptionViewItem& option, const QRect& square,
                      bool isShown) {
        painter.setBrush(Qt::NoBrush);
        const bool isCurrent = option.state & QStyle::State_HasFocus;
        const bool isUnderMouse = option.state & QStyle::State_MouseOver;
        if (isShown) {
            painter.setPen(QPen(option.palette.color(QPalette::Highlight), 2, Qt::SolidLine,
                                Qt::SquareCap, Qt::MiterJoin));
            painter.drawRect(square.adjusted(0, 0, -1, -1));
        }
        if (isCurrent || isUnderMouse) {
            QColor color = option.palette.color(QPalette::Text);
            color.setAlphaF(isCurrent ? 1.0f : 0.5f);
            painter.setPen(QPen(color, 1, isCurrent ? Qt::DotLine : Qt::SolidLine));
            const int inside = isShown ? 2 : 0;
            painter.drawRect(square.adjusted(inside, inside, -1 - inside, -1 - inside));
        }
    }

    const CellTable& table_;
};

} // namespace

SheetGrid::SheetGrid(QWidget* parent) : QTableView(parent), table_(new CellTable(this)) {
    setModel(table_);
    setItemDelegate(new CellDelegate(*table_, this));
    setAccessibleName(tr("Cells of the contact sheet"));
    setFrameShape(QFrame::NoFrame);
    setShowGrid(false);
    setSelectionMode(SingleSelection);
    setEditTriggers(NoEditTriggers);
    setTabKeyNavigation(false); // Tab leaves
    setMouseTracking(true);
    setHorizontalScrollMode(ScrollPerPixel);
    setVerticalScrollMode(ScrollPerPixel);
    setCornerButtonEnabled(false);
    setWordWrap(false);
    for (QHeaderView* header : {horizontalHeader(), verticalHeader()}) {
        header->setSectionResizeMode(QHeaderView::Fixed);
        header->setSectionsClickable(false);
        header->setHighlightSections(false);
        header->setMinimumSectionSize(1);
        header->setTextElideMode(Qt::ElideRight);
    }
    connect(verticalHeader(), &QHeaderView::geometriesChanged, this, &SheetGrid::fitted);
    verticalHeader()->setMaximumWidth(widestLabel);
    verticalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    connect(this, &QTableView::clicked, this, &SheetGrid::chosen);
    connect(table_, &QAbstractItemModel::modelReset, this, &SheetGrid::fit);
    connect(table_, &QAbstractItemModel::headerDataChanged, this, &SheetGrid::fit);
}

QSize SheetGrid::sizeHint() const {
    return {4 * wellSeen, 5 * wellSeen};
}

/// Returns the side of a cell in pixels: as much as there is room for all columns, and less to have
/// all rows in sight where the cells can still be seen well.
int SheetGrid::cellSide() const {
    const int columns = std::max(table_->columnCount(), 1);
    const int rows = std::max(table_->rowCount(), 1);
    const int lines = static_cast<int>(table_->sheet().numbers.size());
    const QSize room = maximumViewportSize();
    const int around = 2 * gap + captionHeight(font(), lines);
    const auto sideIn = [&](int width) {
        const int wide = width / columns - 2 * gap;
        const int high = (room.height() - apart) / rows - around;
        const int fitting = std::min(wide, std::max(high, wellSeen));
        return std::clamp(fitting, smallest, std::max(table_->sheet().cellPixels, smallest));
    };
    const int side = sideIn(room.width());
    const bool isScrolled = rows * (side + around) + apart > room.height();
    return isScrolled ? sideIn(room.width() - verticalScrollBar()->sizeHint().width()) : side;
}

void SheetGrid::fit() {
    if (!table_->plan()) {
        return;
    }
    verticalHeader()->setVisible(table_->plan()->y().has_value() ||
                                 table_->isControl(table_->rowCount() - 1));
    const int lines = static_cast<int>(table_->sheet().numbers.size());
    const int side = cellSide() + 2 * gap;
    for (int column = 0; column < table_->columnCount(); ++column) {
        setColumnWidth(column, side);
    }
    for (int row = 0; row < table_->rowCount(); ++row) {
        const bool isApart = table_->isControl(row);
        setRowHeight(row, side + captionHeight(font(), lines) + (isApart ? apart : 0));
    }
    Q_EMIT fitted();
}

QRect SheetGrid::cells() const {
    const QSize all(horizontalHeader()->length(), verticalHeader()->length());
    return {viewport()->pos(), all.boundedTo(viewport()->size())};
}

void SheetGrid::resizeEvent(QResizeEvent* event) {
    QTableView::resizeEvent(event);
    fit();
}

void SheetGrid::changeEvent(QEvent* event) {
    QTableView::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        fit();
    }
}

void SheetGrid::keyPressEvent(QKeyEvent* event) {
    const bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (isEnter && currentIndex().isValid()) {
        Q_EMIT chosen(currentIndex());
        return;
    }
    QTableView::keyPressEvent(event);
}

/// Makes the first cell current where none is: the keys need a place to start from.
void SheetGrid::focusInEvent(QFocusEvent* event) {
    QTableView::focusInEvent(event);
    if (!currentIndex().isValid() && table_->rowCount() > 0) {
        setCurrentIndex(table_->index(0, 0));
    }
}

/// A drag over the cells chooses none of them.
QItemSelectionModel::SelectionFlags SheetGrid::selectionCommand(const QModelIndex& index,
                                                                const QEvent* event) const {
    const bool isDrag = event && event->type() == QEvent::MouseMove;
    return index.isValid() && !isDrag ? QTableView::selectionCommand(index, event)
                                      : QItemSelectionModel::NoUpdate;
}

} // namespace patina
