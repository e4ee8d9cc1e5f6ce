# SPDX-License-Identifier: GPL-3.0-or-later
# Language level, warnings and sanitizers, carried by the interface target patina::compiler. A
# release is for people who only build it: no warning of a compiler that is newer ends it, and what
# a file shadows in those that are compiled with it counts for nothing.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

option(PATINA_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)
option(PATINA_TIDY "Run clang-tidy on every file" OFF)

add_library(patina_compiler INTERFACE)
add_library(patina::compiler ALIAS patina_compiler)
target_compile_options(patina_compiler INTERFACE
    -Wall -Wextra -Wpedantic -Wnon-virtual-dtor -Woverloaded-virtual
    $<$<NOT:$<CONFIG:Release>>:-Werror>)
# In files that are compiled together only what is local shadows what is local, which gcc can tell
# apart; the clang preset, which takes each alone, sees the rest.
if(NOT CMAKE_UNITY_BUILD)
    set(shadow -Wshadow)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(shadow -Wshadow=local)
endif()
target_compile_options(patina_compiler INTERFACE $<$<NOT:$<CONFIG:Release>>:${shadow}>)
# gcc 12 sees overlaps in sums of std::string that are not there (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(patina_compiler INTERFACE -Wno-restrict)
endif()
# In files that are compiled together it takes a source for a header, whose classes others see.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(patina_compiler INTERFACE
        $<$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>:-Wno-subobject-linkage>)
endif()
# Where gcc 12 joins the conversions of a vector's numbers it drops those to float and back, and
# with them the rounding: dvec3(vec3(x)) is then x. It joins them from -O2 on.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(patina_compiler INTERFACE
        $<$<CONFIG:Release,RelWithDebInfo>:-fno-tree-slp-vectorize>)
endif()

# patina_cold(<target>): code that waits for people, drivers and disks. A third of the time of a
# release goes into optimising it for nothing.
function(patina_cold target)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    set_property(TARGET ${target} PROPERTY PATINA_COLD ON)
endfunction()

if(PATINA_SANITIZE)
    add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined
                        -fno-omit-frame-pointer)
    add_link_options(-fsanitize=address,undefined)
    # gcc 12 takes what the sanitizers add for reads of unset memory, in std::function for one.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(patina_compiler INTERFACE -Wno-maybe-uninitialized)
    endif()
endif()

option(PATINA_FUZZ "Build patina-fuzz, which needs clang" OFF)
if(PATINA_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link)
endif()

if(PATINA_TIDY)
    find_program(PATINA_CLANG_TIDY clang-tidy REQUIRED)
    # Most of the time goes into the headers of the libraries, so it reads several files at a time.
    # The static analyser would see nothing of files that are included; editors run it on each.
    set(CMAKE_CXX_CLANG_TIDY ${PATINA_CLANG_TIDY} --quiet
        --checks=-clang-analyzer-*,-bugprone-suspicious-include
        "--header-filter=${PROJECT_SOURCE_DIR}/(app|engine|tests)/")
endif()

# A compiler cache and a fast linker only where they are installed; neither changes the result.
find_program(PATINA_CCACHE ccache)
if(PATINA_CCACHE AND NOT PATINA_TIDY)
    # What it must be told to keep files that read precompiled headers.
    set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_SLOPPINESS=pch_defines,time_macros ${PATINA_CCACHE})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        add_compile_options(-fpch-preprocess)
    endif()
endif()
find_program(PATINA_MOLD mold)
if(PATINA_MOLD)
    add_link_options(-fuse-ld=mold)
endif()
