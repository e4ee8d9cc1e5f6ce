# SPDX-License-Identifier: GPL-3.0-or-later

# patina_engine_library(<folder> [USES <engine folders>] [LINKS <other targets>])
# One static library per engine folder. USES are the arrows of ARCHITECTURE.md: a folder that is
# not named there does not link, so the linker keeps the layering.
function(patina_engine_library folder)
    cmake_parse_arguments(ARG "" "" "USES;LINKS" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS *.cpp *.h)
    add_library(patina_${folder} STATIC ${sources})
    add_library(patina::${folder} ALIAS patina_${folder})
    target_include_directories(patina_${folder} PUBLIC ${PROJECT_SOURCE_DIR}/engine)
    set_target_properties(patina_${folder} PROPERTIES LINKER_LANGUAGE CXX)
    list(TRANSFORM ARG_USES PREPEND patina::)
    target_link_libraries(patina_${folder} PUBLIC ${ARG_USES} ${ARG_LINKS} PRIVATE patina::compiler)
    if(folder STREQUAL "core")
        patina_precompile(patina_core HEADERS ${PATINA_ENGINE_HEADERS})
    else()
        patina_precompile(patina_${folder} AS patina_core)
    endif()
endfunction()
