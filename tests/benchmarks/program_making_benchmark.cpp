// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that are in no cache: the editor's event loop must not notice that they are made.
#include "benchmarks.h"
#include "editor_stalls.h"

namespace patina::benchmarks {
namespace {

constexpr int runs = 3;

} // namespace

bool programMaking() {
    return reportStalls("patina-compiling-editor", {.arguments = {},
                                                    .environment = {},
                                                    .input = {},
                                                    .timeLimitSeconds = 400.0},
                        runs);
}

} // namespace patina::benchmarks
