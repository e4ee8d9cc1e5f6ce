// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include <QTimer>
#include <QWidget>

#include "background/worker.h"
#include "docks/dock_context.h"
#include "lobe/lobe_answer.h"
#include "lobe/lobe_times.h"
#include "lobe/picked_incidence.h"

class QAction;
class QComboBox;
class QToolButton;

namespace patina {

class ElidedLabel;
class LobePlots;
class SideView;

/// Plots the reflectance of the materials on screen, in double precision. Only the plot that is
/// seen is computed: a sketch of it while values move, and all of it when they rest.
class LobeDock : public QWidget {
    Q_OBJECT

  public:
    explicit LobeDock(const DockContext& context);

    /// Says that what is shown is what is on screen, and no sketch.
    bool isUpToDate() const { return !isComputing() && !isStale_; }
    bool isTiming() const { return times_->isMeasuring(); }
    bool isComputing() const { return !worker_.isIdle() || settle_.isActive(); }

    /// Counts the plots of materials that were computed since the dock was made.
    int computed() const { return computed_; }

    /// Writes the plot that is seen into a file: .svg, .png or .csv.
    void exportTo(const QString& file);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    /// Overlays a preset; returns its name where there is no room for it.
    QString addPreset(const std::filesystem::path& file);
    /// Returns what is on screen and what is overlaid, as many as there is room for.
    std::vector<LobeMaterial> shownMaterials() const;
    QWidget* makeControls();
    QToolButton* makePick();
    void watchPicks(SideView& view);
    /// Takes the light and the viewer of a place on an object.
    void takePick(SideView& view, const Hit& hit);
    void forgetPick();
    void connectParts(const DockContext& context);
    void follow();
    void ask(bool isSketch);
    /// Shows answers to the question, one for each material, and keeps them.
    void show(const LobeQuestion& question, const std::vector<SharedAnswer>& answers);
    QString noteOf(const std::vector<SharedAnswer>& answers) const;
    std::vector<SharedAnswer> withEarlier(std::vector<SharedAnswer> answers) const;

    /// Holds what the note below the plots is made of.
    struct Note {
        QString event;   ///< is why what was just done did nothing; the next change takes it away
        QString times;   ///< is what Time has found
        QString answers; ///< is what the plots leave out, and why there are none
    };
    /// Changes a part of the note and writes it, all of it for a screen reader, too.
    void say(QString Note::*part, const QString& text);

    Document& document_;
    TriedMaterial& tried_;
    MessageLog& messages_;
    CompareArea& views_;
    LobePlots* plots_;
    QComboBox* scale_;
    QComboBox* term_;
    QAction* snapshots_;
    QToolButton* forget_;               ///< takes the dropped presets away
    std::vector<LobeMaterial> dropped_; ///< are presets that were dropped on the dock
    ElidedLabel* note_;
    LobeTimes* times_;
    std::optional<PickedIncidence> picked_; ///< is empty where the light was turned by hand
    std::vector<LobeMaterial> materials_;   ///< are those that were asked for last
    LobeAnswers answers_;                   ///< are what is known of them
    std::vector<SharedAnswer> shown_;       ///< are in the plot that is seen
    Note said_;
    int computed_ = 0;
    bool isStale_ = true;
    QTimer settle_;
    Worker worker_;
};

} // namespace patina
