// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/plot_shapes.h"
#include "measure/lobe/half_difference_slice.h"
#include "measure/lobe/lobe_lines.h"
#include "measure/lobe/lobe_scale.h"

namespace patina {

/// Returns the polar plot for light at an angle in degrees, which stands at the left; the light's
/// mirror direction is at the right. Of several materials the overlaidValue() is drawn, of one its
/// channels where they differ.
std::vector<PlotShape> polarDrawing(const std::vector<LobeSubject>& subjects, LobeScale scale,
                                    double lightDegrees, glm::ivec2 size);

/// Returns the plot of shares of the light over the angle, with 1 marked. Shares above 1 extend the
/// axis.
std::vector<PlotShape> shareDrawing(const std::vector<LobeSubject>& subjects, glm::ivec2 size);

/// Returns the plot of indices of refraction over the wavelength, what is mirrored by the axis at
/// the right.
std::vector<PlotShape> spectrumDrawing(const std::vector<LobeSubject>& subjects, glm::ivec2 size);

/// Returns the plot of errors of single precision, or of 16 bits, over the viewer's angle, -90 ..
/// 90 degrees.
std::vector<PlotShape> errorDrawing(const std::vector<LobeSubject>& subjects, LobePlot plot,
                                    glm::ivec2 size);

/// Returns the slice as a picture of cells, bright where much is reflected on this scale.
std::vector<PlotShape> sliceDrawing(const HalfDifferenceSlice& slice, const std::string& name,
                                    LobeScale scale, glm::ivec2 size);

} // namespace patina
