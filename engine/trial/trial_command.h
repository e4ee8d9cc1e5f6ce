// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace patina {

/// Runs the hidden command `patina try-blocks SHADERS OWN KIND/ID...`, which a TrialGate starts and
/// which writes trial reports to standard output. Returns the process' status, or nothing where the
/// arguments are another command.
std::optional<int> runTrialCommand(int argc, char** argv);

} // namespace patina
