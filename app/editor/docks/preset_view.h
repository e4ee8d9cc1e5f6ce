// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListView>
#include <QMap>
#include <QSet>

#include "docks/preset_list.h"

namespace patina {

class ThumbnailMaker;

/// Shows presets as a grid or a list, of which several may be selected. A click or a key that moves
/// to one tries it, a double click or Enter applies it; while two sides are compared the arrows are
/// steps of theirs. It asks only for images in view, a few at a
/// time, so that those scrolled away are not waited for. The keys of its actions are its own while
/// it has the focus.
class PresetView : public QListView {
    Q_OBJECT

  public:
    PresetView(PresetList& list, ThumbnailMaker& thumbnails, QWidget* parent = nullptr);

    /// Replaces the rows; keeps the selection where it is still shown, and the scroll position.
    void setRows(std::vector<PresetPtr> rows);
    void setAsList(bool asList);
    bool isAsList() const { return asList_; }
    void setPictureSize(int pixels);
    int pictureSize() const { return pictureSize_; }

    /// Lets the arrows be steps(), and Shift no part of a selection.
    void setArrowsAreSteps(bool are) { arrowsAreSteps_ = are; }

    /// Makes a preset the current and only selected one without trying it.
    void choose(const PresetPtr& entry);

    /// Asks for all images again, as their look has changed; the old ones stay until then.
    void wishAnew();

    PresetPtr current() const; ///< is null if there is none
    /// Returns the selected presets in the order of the rows.
    std::vector<PresetPtr> selected() const;
    const std::vector<PresetPtr>& shown() const { return list_.rows(); }

    static constexpr int minPictureSize = 48;
    static constexpr int maxPictureSize = 192;

  Q_SIGNALS:
    void tried(patina::PresetPtr entry);
    void applied(patina::PresetPtr entry);
    void selectedChanged();
    /// Is emitted where an arrow goes to the row that lies `by` behind the one of a side; with
    /// Shift it is the other side's.
    void stepped(int by, bool isOther);

  protected:
    bool event(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void selectionChanged(const QItemSelection& on, const QItemSelection& off) override;

  private:
    void fit();
    void wishPictures();
    void take(const QString& name, const QImage& picture);
    void showTip(const QModelIndex& index, const QPoint& place);
    QIcon emptyPicture() const;
    int stepOf(const QKeyEvent& event) const;

    PresetList& list_;
    ThumbnailMaker& thumbnails_;
    int pictureSize_ = 72;
    bool asList_ = false;
    bool arrowsAreSteps_ = false;
    int columns_ = 1;
    QMap<QString, PresetPtr> asked_; ///< holds presets whose image was asked for, by request name
    QSet<QString> without_;          ///< holds files of which no image can be made
    int lastAsked_ = 0;
    PresetPtr tipOf_; ///< is the preset whose tool tip waits for a large image; null if none does
    QPoint tipPlace_;
};

/// Returns the tool tip of a preset as rich text.
QString toolTipOf(const PresetEntry& entry);

} // namespace patina
