# SPDX-License-Identifier: GPL-3.0-or-later
# Headers of other projects that most files read, parsed once for many targets: a second of CPU less
# for each file. Off in the clang and tidy presets, which see each file with its own includes; the
# presets that have it compile several files at a time as well (CMAKE_UNITY_BUILD).
option(PATINA_PRECOMPILE "Precompile the headers of the libraries" ON)

set(PATINA_STANDARD_HEADERS <algorithm> <array> <chrono> <cmath> <cstdint> <filesystem> <functional>
    <limits> <map> <memory> <optional> <set> <span> <string> <string_view> <utility> <vector>)
set(PATINA_ENGINE_HEADERS ${PATINA_STANDARD_HEADERS} <epoxy/gl.h> <fmt/format.h> <glm/common.hpp>
    <glm/geometric.hpp> <glm/mat3x3.hpp> <glm/mat4x4.hpp> <glm/matrix.hpp> <glm/trigonometric.hpp>
    <glm/vec2.hpp> <glm/vec3.hpp> <glm/vec4.hpp> <nlohmann/json.hpp> <tl/expected.hpp>)
set(PATINA_WIDGET_HEADERS ${PATINA_ENGINE_HEADERS} <QApplication> <QComboBox> <QDockWidget>
    <QFileInfo> <QHBoxLayout> <QKeyEvent> <QLabel> <QMenu> <QMouseEvent> <QPainter> <QPushButton>
    <QString> <QThreadPool> <QTimer> <QToolButton> <QTreeWidget> <QVBoxLayout> <QWidget>)

# patina_precompile(<target> HEADERS <headers> | AS <target that has them>)
function(patina_precompile target)
    cmake_parse_arguments(ARG "" "AS" "HEADERS" ${ARGN})
    if(NOT PATINA_PRECOMPILE OR target STREQUAL ARG_AS)
        return()
    endif()
    # gcc reads headers only where it optimises as far as it did in them.
    get_target_property(cold ${target} PATINA_COLD)
    if(ARG_AS AND cold AND CMAKE_BUILD_TYPE STREQUAL "Release")
        get_property(ARG_AS GLOBAL PROPERTY PATINA_COLD_HEADERS)
        if(NOT ARG_AS)
            set_property(GLOBAL PROPERTY PATINA_COLD_HEADERS ${target})
            set(ARG_HEADERS ${PATINA_ENGINE_HEADERS})
        endif()
    endif()
    if(ARG_AS)
        target_precompile_headers(${target} REUSE_FROM ${ARG_AS})
    else()
        target_precompile_headers(${target} PRIVATE ${ARG_HEADERS})
    endif()
endfunction()
