// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QPen>
#include <QStringList>

#include "accuracy/plot_widget.h"
#include "measure/lobe/lobe_lines.h"

class QCPItemText;
class QCPLayoutElement;
class QCustomPlot;

namespace patina {

/// Draws the lines of materials over an angle. The pointer reads the values below it.
class LobePlotWidget : public PlotWidget {
    Q_OBJECT

  public:
    explicit LobePlotWidget(LobePlot kind, QWidget* parent = nullptr);

    /// Takes all materials, so that each keeps its colour; one that has no lines has its name
    /// alone.
    void setSubjects(std::vector<LobeSubject> subjects);
    const std::vector<LobeSubject>& subjects() const { return subjects_; }

    /// Sets what stands beside the name of each material; empty for nothing.
    void setDetails(QStringList details);

    /// Returns what the plot reads at a place of this widget, a line per material; empty beside the
    /// plot.
    QString readingAt(const QPointF& place) const;

    /// Return the plot as the bytes of a file.
    QByteArray png() const;
    QByteArray svg() const;

    QSize sizeHint() const override;

  protected:
    /// Is a line as it is drawn: its values over degrees or nanometres, in a colour.
    struct Stroke {
        std::vector<double> at;
        std::vector<double> values;
        QPen pen;
        bool isShare = false;   ///< is a share of the light where the plot's others are not
        bool isSampled = false; ///< is known at its points alone
    };

    /// Returns the lines to draw: of several materials the overlaidValue(), of one its channels
    /// where they differ.
    std::vector<Stroke> strokes() const;

    /// Returns the angle below a place of the plot, in degrees from the normal, or the wavelength
    /// in nanometres; NaN beside it.
    virtual double abscissaAt(const QPointF& place) const = 0;
    /// Says that place: "30° from the normal".
    virtual QString abscissaText(double at) const;
    /// Returns what a value is called in a reading: "1/sr"; empty for a share.
    virtual QString unit() const = 0;

    /// Returns the names of the marks at a place of the plot.
    virtual QStringList marksAt(double) const { return {}; }

    /// Sets the axes to the size that is drawn, the widget's or a file's.
    virtual void fitRanges() {}

    /// Keeps room for the legend beside the plot, where that is wide enough.
    void setLegendBeside();

    /// Adds the names of materials in their colours, where there are several or one has details.
    void addLegend();

    QCustomPlot& plot() const { return *plot_; }
    LobePlot kind() const { return kind_; }
    /// Returns what an axis is of, and what is drawn there for channels that differ.
    QString axisText(const QString& what) const;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void makeRoomForLegend();
    void placeLegend();
    QSizeF legendSize() const;
    QPointF emptyPlace() const; ///< is where the legend lies on as little as may be

    /// Returns a line's value at a place as text, with what the plot draws for it in front.
    QString numberText(const LobeLine& line, double at) const;

    LobePlot kind_;
    std::vector<LobeSubject> subjects_;
    std::vector<QCPItemText*> legend_; ///< are the plot's, a name in each
    QStringList details_;
    QCustomPlot* plot_;
    QCPLayoutElement* beside_ = nullptr; ///< holds the room of a legend beside the plot
};

} // namespace patina
