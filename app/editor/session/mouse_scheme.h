// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace patina {

/// Tells which buttons move the camera.
enum class MouseScheme {
    Default, ///< left orbits, middle pans, right moves nearer; with Alt as in Maya
    Maya,    ///< with Alt only: left orbits, middle pans, right moves nearer
    Blender, ///< middle orbits, with Shift it pans, with Ctrl it moves nearer
    Trackpad ///< left orbits; two fingers orbit, with Shift they pan, with Ctrl they move nearer
};

inline constexpr std::array<std::string_view, 4> mouseSchemeIds{"default", "maya", "blender",
                                                                "trackpad"};

/// Says how the mouse moves the cameras of the views.
struct MouseHabits {
    MouseScheme scheme = MouseScheme::Default;
    bool wheelZooms = true; ///< says that the wheel zooms without Ctrl, too

    friend bool operator==(const MouseHabits&, const MouseHabits&) = default;
};

} // namespace patina
