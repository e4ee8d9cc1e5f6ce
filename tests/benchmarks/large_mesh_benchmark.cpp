// SPDX-License-Identifier: GPL-3.0-or-later
// A million triangles from an OBJ file to a PNG file, against f3d on the same file and size.
#include <cmath>
#include <cstdio>

#include "benchmarks.h"
#include "programs.h"
#include "statistics.h"
#include "support/program.h"

namespace patina::benchmarks {
namespace {

constexpr int runs = 5;
constexpr int gridSide = 708; // 2 * 707^2 triangles: just under a million
constexpr double tau = 6.283185307179586;

/// A sphere with waves on it, as a grid of quads cut in two.
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

} // namespace

bool largeMesh() {
    const tests::TemporaryFolder folder;
    const std::string mesh = folder / "large.obj";
    writeLargeObj(mesh);
    const tests::Start ours{.arguments = {"render", "--model", "phong", "--mesh", mesh, "--size",
                                          "800x600", "-o", folder / "ours.png"},
                            .environment = {},
                            .input = {}};
    const tests::Start theirs{
        .arguments = {mesh, "--resolution", "800,600", "--output", folder / "theirs.png"},
        .environment = {},
        .input = {}};

    std::vector<double> ourSeconds;
    std::vector<double> theirSeconds;
    std::vector<double> ratios;
    for (int run = 0; run < runs; ++run) {
        const tests::Outcome our = tests::run(program("patina"), ours);
        const tests::Outcome their = tests::run("/usr/bin/f3d", theirs);
        if (our.exitCode != 0 || their.exitCode != 0) {
            report("Million triangles", our.err + their.err, false, "");
            return false;
        }
        ourSeconds.push_back(our.seconds);
        theirSeconds.push_back(their.seconds);
        ratios.push_back(our.seconds / their.seconds);
    }
    const Spread ratio = spreadOf(ratios);
    report("Million triangles: patina render", text(spreadOf(ourSeconds), 1.0, "s"), true, "");
    report("Million triangles: f3d", text(spreadOf(theirSeconds), 1.0, "s"), true, "");
    report("Million triangles: patina / f3d", text(ratio, 1.0, "x"), ratio.median <= 1.0, "<= 1");
    return ratio.median <= 1.0;
}

} // namespace patina::benchmarks
