// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace patina {

/// The hidden command `patina try-blocks SHADERS OWN KIND/ID...`, which a TrialGate starts: writes
/// trial reports to standard output. Gives the process' status back, or nothing where the arguments
/// are no such command.
std::optional<int> runTrialCommand(int argc, char** argv);

} // namespace patina
