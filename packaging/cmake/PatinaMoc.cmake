# SPDX-License-Identifier: GPL-3.0-or-later

# patina_moc(<target> <headers>): adds what Qt's moc writes for these headers, which lie below the
# current folder, to the target; one file of each room is compiled. CMake's AUTOMOC gives moc all
# include folders, so it reads Qt's headers for each of ours, a second a header, and finds the same:
# what the macros of a class declare stands in its own header.
function(patina_moc target)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/moc)
    foreach(header IN LISTS ARGN)
        file(RELATIVE_PATH name ${CMAKE_CURRENT_SOURCE_DIR} ${header})
        get_filename_component(room ${name} DIRECTORY)
        string(REPLACE "/" "-" room ${room})
        set(written ${folder}/${name}.cpp)
        get_filename_component(written_in ${written} DIRECTORY)
        file(MAKE_DIRECTORY ${written_in})
        add_custom_command(OUTPUT ${written} DEPENDS ${header} VERBATIM
            COMMAND Qt6::moc --no-notes -f ${name} -o ${written} ${header})
        set_source_files_properties(${written} PROPERTIES HEADER_FILE_ONLY ON)
        target_sources(${target} PRIVATE ${written})
        list(APPEND rooms ${room})
        string(APPEND includes_${room} "#include \"${written}\"\n")
    endforeach()
    list(REMOVE_DUPLICATES rooms)
    foreach(room IN LISTS rooms)
        file(CONFIGURE OUTPUT ${folder}/${room}.cpp CONTENT "${includes_${room}}" @ONLY)
        target_sources(${target} PRIVATE ${folder}/${room}.cpp)
    endforeach()
endfunction()
