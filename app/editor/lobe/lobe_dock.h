// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include <QTimer>
#include <QWidget>

#include "background/worker.h"
#include "docks/dock_context.h"
#include "lobe/lobe_subjects.h"
#include "measure/lobe/lobe_lines.h"

class QAction;
class QComboBox;
class QTabWidget;
class QToolButton;

namespace patina {

class EnergyBar;
class LobePlotWidget;
class LongLine;
class PolarPlot;

/// Plots the reflectance of the materials on screen, in double precision. Only the plot that is
/// seen is computed: a sketch of it while values move, and all of it when they rest.
class LobeDock : public QWidget {
    Q_OBJECT

  public:
    explicit LobeDock(const DockContext& context);

    /// Says that what is shown is what is on screen, and no sketch.
    bool isUpToDate() const { return !isComputing() && !isStale_; }
    bool isComputing() const { return !worker_.isIdle() || settle_.isActive(); }

    /// Writes the plot that is seen into a file: .svg, .png or .csv.
    void exportTo(const QString& file);

  protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    /// Is what the worker found: the lines of each material that has some, and why the others have
    /// none.
    struct Answer {
        LobePlot plot = LobePlot::Polar;
        std::vector<LobeSubject> subjects;
        QStringList problems;
        bool isSketch = false;
    };

    void addPages();
    void addPreset(const std::filesystem::path& file);
    QWidget* makeControls();
    void connectParts(const DockContext& context);
    void follow();
    void ask(bool isSketch);
    static Answer answerTo(const LobeRequest& request, const std::vector<LobeMaterial>& materials,
                           const Catalog& catalog, Worker::Control& control);
    void show(const Answer& answer);
    LobePlot shownPlot() const;
    LobePlotWidget& page() const;

    Document& document_;
    TriedMaterial& tried_;
    MessageLog& messages_;
    QTabWidget* pages_;
    PolarPlot* polar_;
    LobePlotWidget* albedo_;
    LobePlotWidget* fresnel_;
    LobePlotWidget* float32_;
    EnergyBar* energy_;
    QComboBox* scale_;
    QComboBox* term_;
    QAction* snapshots_;
    QToolButton* forget_;               ///< takes the dropped presets away
    std::vector<LobeMaterial> dropped_; ///< are presets that were dropped on the dock
    LongLine* note_;
    std::vector<LobeMaterial> materials_; ///< are those that were asked for last
    bool isStale_ = true;
    QTimer settle_;
    Worker worker_;
};

} // namespace patina
