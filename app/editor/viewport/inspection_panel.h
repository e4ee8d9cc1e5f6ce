// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QFrame>

#include "render/surfaces/inspected_view.h"
#include "render/surfaces/pixel_probe.h"
#include "scene/scene.h"

class QLabel;

namespace patina {

/// Explains, over a view that shows no picture, what it shows, and has the numbers of
/// the pixel under the pointer.
class InspectionPanel : public QFrame {
    Q_OBJECT

  public:
    explicit InspectionPanel(QWidget* parent = nullptr);

    /// Says what a view shows, and what the patterns of the numerical check mean.
    void explain(const Inspected& shown, const Scene& scene);

    /// Shows the numbers of a pixel, or a hint where `probe` is empty as no surface is under the
    /// pointer.
    void showNumbers(const std::optional<PixelProbe>& probe, const Scene& scene);

  private:
    QWidget* legendRow(PixelDefect defect, const QString& text, const QString& toolTip);

    QWidget* legend_;
    QLabel* title_;
    QLabel* numbers_;
};

/// Returns what a light of the scene is called.
QString shownLightName(const Scene& scene, std::size_t index);

/// Returns the numbers of a pixel as the rows of an HTML table.
QString probeText(const PixelProbe& probe, const Scene& scene);

} // namespace patina
