// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "support/program.h"

namespace patina::tests {

inline std::filesystem::path patinaProgram() {
    return std::filesystem::path(PATINA_BINARY_DIR) / "bin" / "patina";
}

inline std::filesystem::path shipped(const std::string& path) {
    return std::filesystem::path(PATINA_SOURCE_DIR) / path;
}

inline const std::string gold = shipped("presets/cook-torrance/gold.patina.json").string();

/// Returns the folder of a compiled de_DE.UTF-8 locale (decimal comma), made when the tests are
/// built.
inline std::string localeFolder() {
    return (std::filesystem::path(PATINA_BINARY_DIR) / "locale").string();
}

/// Runs `patina` without a display and with an empty user folder.
inline Outcome patina(Start start) {
    const TemporaryFolder home;
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "PATINA_DATA_DIR"}) {
        start.environment.try_emplace(name, "");
    }
    for (const char* name :
         {"XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"}) {
        start.environment.try_emplace(name, (home / name).string());
    }
    makeCacheFolder(home / "XDG_CACHE_HOME");
    return run(patinaProgram(), start);
}

inline Outcome patina(std::vector<std::string> arguments) {
    return patina(Start{.arguments = std::move(arguments), .environment = {}, .input = {}});
}

/// Runs `patina` and interrupts it, as Ctrl-C does, a second after it handles that signal.
inline Outcome interrupted(std::vector<std::string> arguments) {
    constexpr const char* script = R"(
"$@" & program=$!
for try in $(seq 1200); do
    grep -q '^SigCgt:.*[2367abef]$' "/proc/$program/status" && break
    sleep 0.05
done
sleep 1
kill -INT "$program"
wait "$program"
)";
    const TemporaryFolder home;
    arguments.insert(arguments.begin(), {"-c", script, "sh", patinaProgram().string()});
    return run("/bin/sh",
               Start{.arguments = std::move(arguments),
                     .environment = {{"DISPLAY", ""}, {"XDG_CACHE_HOME", home.path().string()}},
                     .input = {}});
}

} // namespace patina::tests
