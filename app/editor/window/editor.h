// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Opens the editor with the files on the command line and runs it until it is closed. Returns the
/// exit status: 1, after a message that says what was found, when there is no display or no OpenGL
/// 4.1.
///
/// With PATINA_TIME_STARTUP set it writes a line to standard error when the first frame is on the
/// screen: "patina: first frame at <seconds> s", of the monotonic clock, so that whoever started
/// the program can subtract when that was. Where that frame takes long there is a line before it
/// for the sketch that the device shows sooner: "patina: sketch at <seconds> s". One with "presets"
/// says when the library was read.
int runEditor(int argc, char** argv);

} // namespace patina
