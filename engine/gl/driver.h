// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/error.h"

namespace patina::gl {

/// Returns version, renderer and vendor of the current context in one line. Messages show it, and
/// caches tell one driver from another by it.
std::string driverText();

/// Returns true when the name of the renderer is that of a driver that draws on the CPU.
bool isSoftware();

/// Returns true when draw calls may begin at another instance than the first (OpenGL 4.2, or
/// GL_ARB_base_instance).
bool hasBaseInstances();

/// Returns how many bytes one uniform block may hold here; at least 16 KiB.
int largestUniformBlock();

/// Returns an error that says what was found when the current context is below OpenGL 4.1.
Result<void> checkVersion();

} // namespace patina::gl
