// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "predict/gpu_family.h"

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace patina {

/// Adds --gpu, a list of families of graphics cards.
CLI::Option* addFamiliesOption(CLI::App& command, std::vector<const GpuFamily*>& families);

} // namespace patina
