// SPDX-License-Identifier: GPL-3.0-or-later
// A million triangles from an OBJ file to a PNG file, against f3d on the same file and size.
#include "benchmarks.h"
#include "large_obj.h"
#include "programs.h"
#include "statistics.h"
#include "support/program.h"

namespace patina::benchmarks {
namespace {

constexpr int runs = 5;

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
