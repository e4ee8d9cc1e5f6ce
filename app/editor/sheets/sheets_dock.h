// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QPersistentModelIndex>
#include <QTimer>
#include <QWidget>

#include "docks/dock_context.h"
#include "sheet/sheet_offers.h"
#include "sheets/sheet_drawing.h"
#include "sheets/sheet_start.h"

class QProgressBar;
class QToolButton;

namespace patina {

class ElidedLabel;
class NoticeBar;
class SheetControls;
class SheetGrid;
class VerticalTitle;

/// Shows a live contact sheet: what the active side shows, again and again along one or two axes.
/// It follows the document while it is seen. A click on a cell, or Enter, gives the document its
/// look.
class SheetsDock : public QWidget {
    Q_OBJECT

  public:
    explicit SheetsDock(const DockContext& context);
    ~SheetsDock() override;

    const Sheet& sheet() const { return sheet_; }
    void setSheet(const Sheet& sheet);

    /// Reads a sheet's file, and puts the preset that it names on the active side. Nothing happens
    /// for an empty name, as in the next.
    void open(const QString& file);
    void save(const QString& file);
    /// Draws the sheet into a file as `patina sheet` does.
    void writeTo(const QString& file);

    /// Tells whether nothing is drawn or written, or about to be.
    bool isIdle() const;

  Q_SIGNALS:
    void saved(const QString& file); ///< what was asked for is in the file

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void layOut();
    void connectParts();
    QString suggestedName() const;

    void followLater();
    void placeTitles();
    void follow();
    bool isUpToDate();
    void chooseAxes(const std::vector<AxisOffer>& offers);
    SheetDrawing::Request request();
    void showControls();

    void showPlan(const PlannedSheet& planned);
    void showRefusal(const SheetRefusal& why);
    void showEnd(const SheetEnd& end);
    void showWritten(const QString& file, const Errors& problems);
    void showProgress(double share, const QString& doing);
    void showRunning();
    QString wordsFor(const SheetAxis& axis) const;
    const AxisOffer* freeOffer(const SheetAxis* other) const;

    void choose(const QModelIndex& cell);
    void take(const QModelIndex& cell);

    DockContext context_;
    Document& document_;
    Sheet sheet_;
    bool hasAxes_ = false; ///< is false until the axes are chosen
    SheetStart start_;
    std::vector<AxisOffer> offers_;
    QPersistentModelIndex wished_; ///< was chosen while the sheet was out of date
    int revision_ = 0;             ///< counts changes of meshes and pictures
    SheetControls* controls_;
    NoticeBar* notice_;
    ElidedLabel* xTitle_;
    VerticalTitle* yTitle_;
    SheetGrid* grid_;
    ElidedLabel* state_;
    QProgressBar* progress_;
    QToolButton* stop_;
    QTimer settle_;
    SheetDrawing drawing_; ///< is destroyed first: it waits for its thread
};

} // namespace patina
