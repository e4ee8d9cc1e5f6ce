# SPDX-License-Identifier: GPL-3.0-or-later
# Every library Patina uses, found once. Header-only ones become interface targets here.

find_package(PkgConfig REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Threads REQUIRED)
find_package(Boost 1.74 REQUIRED COMPONENTS filesystem)
find_package(CLI11 REQUIRED)
find_package(Qt6 REQUIRED COMPONENTS Core DBus Gui Widgets OpenGL OpenGLWidgets PrintSupport Svg)
find_package(assimp REQUIRED)
find_package(OpenImageIO REQUIRED)
# Debian's OpenImageIO names OpenCV's headers, which its package does not bring and nobody needs.
get_target_property(openimageio_folders OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
foreach(folder ${openimageio_folders})
    if(NOT EXISTS ${folder})
        list(REMOVE_ITEM openimageio_folders ${folder})
    endif()
endforeach()
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${openimageio_folders}")
find_package(meshoptimizer REQUIRED)
find_package(draco REQUIRED)
find_package(tinyobjloader REQUIRED)
find_package(PNG REQUIRED)
find_package(Ceres REQUIRED)
find_package(SPIRV-Tools-opt REQUIRED)
find_package(glslang REQUIRED)
find_package(Vulkan REQUIRED)
pkg_check_modules(epoxy REQUIRED IMPORTED_TARGET epoxy)
pkg_check_modules(egl REQUIRED IMPORTED_TARGET egl)
pkg_check_modules(glu REQUIRED IMPORTED_TARGET glu)
pkg_check_modules(minizip REQUIRED IMPORTED_TARGET minizip)

# QCustomPlot brings CMake files on Debian only; its library has another name on each system.
find_package(QCustomPlotQt6 QUIET)
if(NOT TARGET QCustomPlotQt6::QCustomPlotQt6)
    find_path(PATINA_QCUSTOMPLOT_INCLUDE qcustomplot.h REQUIRED)
    find_library(PATINA_QCUSTOMPLOT_LIBRARY
        NAMES QCustomPlotQt6 qcustomplot-qt6 qcustomplot REQUIRED)
    add_library(QCustomPlotQt6::QCustomPlotQt6 UNKNOWN IMPORTED)
    set_target_properties(QCustomPlotQt6::QCustomPlotQt6 PROPERTIES
        IMPORTED_LOCATION ${PATINA_QCUSTOMPLOT_LIBRARY}
        INTERFACE_INCLUDE_DIRECTORIES ${PATINA_QCUSTOMPLOT_INCLUDE}
        INTERFACE_LINK_LIBRARIES "Qt6::Widgets;Qt6::PrintSupport")
endif()

find_path(PATINA_EXPECTED_INCLUDE tl/expected.hpp REQUIRED)
find_path(PATINA_VALIJSON_INCLUDE valijson/validator.hpp REQUIRED)
find_path(PATINA_TINYGLTF_INCLUDE tiny_gltf.h REQUIRED)

function(patina_header_only name include)
    add_library(patina_${name} INTERFACE)
    add_library(patina::${name} ALIAS patina_${name})
    target_include_directories(patina_${name} SYSTEM INTERFACE ${include})
endfunction()
patina_header_only(expected ${PATINA_EXPECTED_INCLUDE})
patina_header_only(valijson ${PATINA_VALIJSON_INCLUDE})
patina_header_only(tinygltf ${PATINA_TINYGLTF_INCLUDE})
