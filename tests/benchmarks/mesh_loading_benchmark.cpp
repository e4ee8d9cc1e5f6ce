// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of a million triangles in the editor: its event loop must not notice.
#include "benchmarks.h"
#include "editor_stalls.h"
#include "large_obj.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

constexpr int runs = 3;
constexpr int meshes = 3;

} // namespace

bool meshLoading() {
    const tests::TemporaryFolder folder;
    tests::Start start{.arguments = {}, .environment = {}, .input = {}, .timeLimitSeconds = 3000.0};
    for (int mesh = 0; mesh < meshes; ++mesh) {
        start.arguments.push_back(folder / fmt::format("large{}.obj", mesh));
        writeLargeObj(start.arguments.back());
    }
    return reportStalls("patina-loading-editor", start, runs);
}

} // namespace patina::benchmarks
