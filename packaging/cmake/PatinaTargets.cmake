# SPDX-License-Identifier: GPL-3.0-or-later

# patina_engine_library(<folder> [COLD] [USES <engine folders>] [LINKS <other targets>]
#                       [ROOMS <folders>]):
# One static library per engine folder. USES are the arrows of ARCHITECTURE.md: a folder that is
# not named there does not link, so the linker keeps the layering. ROOMS are the folders inside.
# COLD: see patina_cold().
function(patina_engine_library folder)
    cmake_parse_arguments(ARG "COLD" "" "USES;LINKS;ROOMS" ${ARGN})
    set(patterns *.cpp *.h)
    foreach(room ${ARG_ROOMS})
        list(APPEND patterns ${room}/*.cpp ${room}/*.h)
    endforeach()
    file(GLOB sources CONFIGURE_DEPENDS ${patterns})
    add_library(patina_${folder} STATIC ${sources})
    add_library(patina::${folder} ALIAS patina_${folder})
    target_include_directories(patina_${folder} PUBLIC ${PROJECT_SOURCE_DIR}/engine)
    set_target_properties(patina_${folder} PROPERTIES LINKER_LANGUAGE CXX)
    list(TRANSFORM ARG_USES PREPEND patina::)
    target_link_libraries(patina_${folder} PUBLIC ${ARG_USES} ${ARG_LINKS} PRIVATE patina::compiler)
    if(ARG_COLD)
        patina_cold(patina_${folder})
    endif()
    if(folder STREQUAL "core")
        patina_precompile(patina_core HEADERS ${PATINA_ENGINE_HEADERS})
    else()
        patina_precompile(patina_${folder} AS patina_core)
    endif()
endfunction()
