// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QTabWidget>

#include "docks/dock_page.h"
#include "lobe/lobe_answer.h"
#include "lobe/picked_incidence.h"
#include "measure/lobe/lobe_scale.h"

namespace patina {

class Document;
class EnergyBar;
class LobePlotWidget;
class PaintedPlot;
class PolarPlot;
class SlicePlot;
class SolidPlot;

/// Shows what was found of materials as plots, a tab for each kind.
class LobePlots : public QTabWidget {
    Q_OBJECT

  public:
    LobePlots(const Document& document, QWidget* parent);

    /// Returns the tabs in the order of LobePage, which also commands open by their names.
    static std::vector<DockPage> pages();

    LobePage page() const;

    /// Returns the angle of the light in the plane of incidence, in degrees from the normal.
    double light() const;

    /// Shows the light and the viewer of a place on an object; only the light that is set where
    /// there is none.
    void setPicked(const std::optional<PickedIncidence>& picked);

    void setScale(LobeScale scale);

    /// Shows a text beside the name of each material.
    void setDetails(const QStringList& details);

    /// Shows answers to a question of the tab that is seen, one for each material.
    void showAnswers(const LobeQuestion& question, const std::vector<SharedAnswer>& answers);

    /// Writes the plot that is seen into a file: .svg, .png or .csv.
    Result<void> exportTo(const QString& file) const;

  Q_SIGNALS:
    void lightTurned(); ///< by hand

  private:
    void addPages();
    /// Shows in the energy bar what was found of the first material.
    void showEnergy(const LobeAnswer& answer, bool isOneOfSeveral);
    /// Return the widget of the tab that is seen: one of lines or a painted one.
    LobePlotWidget* linePlot() const;
    PaintedPlot* paintedPlot() const;
    std::string csv() const;

    const Document& document_;
    PolarPlot* polar_;
    SolidPlot* solid_;
    LobePlotWidget* albedo_;
    LobePlotWidget* fresnel_;
    LobePlotWidget* spectrum_;
    SlicePlot* slice_;
    LobePlotWidget* float32_;
    LobePlotWidget* float16_;
    EnergyBar* energy_;
};

} // namespace patina
