// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListView>
#include <QMap>
#include <QSet>

#include "docks/preset_list.h"

namespace patina {

class ThumbnailMaker;

/// Presets as a grid of pictures or as a list, of which several may be selected. A click or a key
/// that moves to one tries it, a double click or Enter applies it. Only pictures that are in sight
/// are asked for, a few at a time, so that what is scrolled away is not waited for. The keys of its
/// actions are its own while it has the focus.
class PresetView : public QListView {
    Q_OBJECT

  public:
    PresetView(PresetList& list, ThumbnailMaker& thumbnails, QWidget* parent = nullptr);

    /// Replaces what is shown; what is selected stays so where it is still shown, and so does the
    /// place that is scrolled to.
    void setRows(std::vector<PresetPtr> rows);
    void setAsList(bool asList);
    bool isAsList() const { return asList_; }
    void setPictureSize(int pixels);
    int pictureSize() const { return pictureSize_; }

    /// What pictures are of has changed; they stay until there are new ones.
    void wishAnew();

    PresetPtr current() const; ///< null: none
    /// In the order in which they are shown.
    std::vector<PresetPtr> selected() const;
    const std::vector<PresetPtr>& shown() const { return list_.rows(); }

    static constexpr int minPictureSize = 48;
    static constexpr int maxPictureSize = 192;

  Q_SIGNALS:
    void tried(patina::PresetPtr entry);
    void applied(patina::PresetPtr entry);
    void selectedChanged();

  protected:
    bool event(QEvent* event) override;
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

    PresetList& list_;
    ThumbnailMaker& thumbnails_;
    int pictureSize_ = 72;
    bool asList_ = false;
    int columns_ = 1;
    QMap<QString, PresetPtr> asked_; ///< pictures that are on their way, by the name asked under
    QSet<QString> without_;          ///< files of which there is no picture
    int lastAsked_ = 0;
    PresetPtr tipOf_; ///< whose large picture is on its way
    QPoint tipPlace_;
};

/// What is to be said of a preset, as rich text.
QString toolTipOf(const PresetEntry& entry);

} // namespace patina
