// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "lobe/lobe_plot_widget.h"

class QCPItemText;

namespace patina {

/// Draws shares of the light over its angle from the normal, with 1 marked where it is exceeded,
/// and angles that have a name; the right axis of a Fresnel plot reads what is transmitted. Errors
/// of single precision are drawn over the viewer's angle, and a spectrum over the wavelength, with
/// the share that is mirrored on the right axis.
class SharePlot final : public LobePlotWidget {
    Q_OBJECT

  public:
    explicit SharePlot(LobePlot plot, QWidget* parent = nullptr);

  protected:
    double abscissaAt(const QPointF& place) const override;
    QString abscissaText(double at) const override;
    QString unit() const override;
    QStringList marksAt(double at) const override;
    void draw() override;
    void fitRanges() override { placeMarkNames(); }

  private:
    void addMarks(double top);
    /// Puts the names of marks beside their lines, each in the first row where it covers no other;
    /// one without room is left out, and read under the pointer.
    void placeMarkNames();
    QString markText(const LobeMark& mark) const;
    /// Set the axes' ranges, and return what the left one ends at.
    double fitAxes();
    double fitSpectrum();
    bool isOfErrors() const;
    bool hasLogarithm() const;

    QString quantity_;                    ///< says what the left axis is of
    std::vector<QCPItemText*> markNames_; ///< are the plot's
};

} // namespace patina
