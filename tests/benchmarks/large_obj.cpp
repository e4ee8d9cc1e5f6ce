// SPDX-License-Identifier: GPL-3.0-or-later
#include "large_obj.h"

#include <cmath>
#include <cstdio>

namespace patina::benchmarks {
namespace {

constexpr int gridSide = 708; // 2 * 707^2 triangles: just under a million
constexpr double tau = 6.283185307179586;

} // namespace

void writeLargeObj(const std::filesystem::path& path) {
    std::FILE* file = std::fopen(path.c_str(), "w");
    for (int row = 0; row < gridSide; ++row) {
        for (int column = 0; column < gridSide; ++column) {
            const double polar = 0.5 * tau * (row + 0.5) / gridSide;
            const double azimuth = tau * column / (gridSide - 1);
            const double radius = 1.0 + 0.05 * std::sin(24.0 * polar) * std::cos(24.0 * azimuth);
            std::fprintf(file, "v %.6f %.6f %.6f\n", radius * std::sin(polar) * std::cos(azimuth),
                         radius * std::cos(polar), radius * std::sin(polar) * std::sin(azimuth));
        }
    }
    for (int row = 0; row + 1 < gridSide; ++row) {
        for (int column = 0; column + 1 < gridSide; ++column) {
            const int a = row * gridSide + column + 1; // OBJ counts from one
            const int b = a + gridSide;
            std::fprintf(file, "f %d %d %d\nf %d %d %d\n", a, a + 1, b, a + 1, b + 1, b);
        }
    }
    std::fclose(file);
}

} // namespace patina::benchmarks
