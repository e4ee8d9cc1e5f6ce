// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>

namespace patina {

/// Returns the mean SSIM of two pictures, from -1 to 1 for equal ones: Z. Wang, A. C. Bovik,
/// H. R. Sheikh, E. P. Simoncelli, Image Quality Assessment: From Error Visibility to Structural
/// Similarity, IEEE Trans. Image Process. 13(4), 2004, with their window and constants. The planes
/// hold a display's grey values 0 .. 1, rows from the top; beyond their edges they continue with
/// their border values.
double structuralSimilarity(glm::ivec2 size, const std::vector<double>& a,
                            const std::vector<double>& b);

} // namespace patina
