// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>

namespace patina {

/// Measures how alike the structures of two pictures are: the mean SSIM of Z. Wang, A. C. Bovik,
/// H. R. Sheikh, E. P. Simoncelli, Image Quality Assessment: From Error Visibility to Structural
/// Similarity, IEEE Trans. Image Process. 13(4), 2004, with their window and constants. 1 for equal
/// ones, down to -1. Planes of grey values 0 .. 1 of a display, rows from the top; beyond the edges
/// they go on as they end.
double structuralSimilarity(glm::ivec2 size, const std::vector<double>& a,
                            const std::vector<double>& b);

} // namespace patina
