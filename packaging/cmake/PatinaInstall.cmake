# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` puts where. The programs lie together in libexec/patina, with a link in
# bin/, and find each other and share/patina relative to themselves: an installation may be moved.

set(program_folder ${CMAKE_INSTALL_LIBEXECDIR}/patina)
install(TARGETS patina patina-files patina-cost RUNTIME DESTINATION ${program_folder})
install(TARGETS patina_images LIBRARY DESTINATION ${program_folder})
file(RELATIVE_PATH program_from_bin
    ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBEXECDIR}/patina/patina)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/link)
file(CREATE_LINK ${program_from_bin} ${PROJECT_BINARY_DIR}/link/patina SYMBOLIC)
install(FILES ${PROJECT_BINARY_DIR}/link/patina DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY shaders presets schemas DESTINATION ${CMAKE_INSTALL_DATADIR}/patina
        PATTERN *.py EXCLUDE)
install(FILES packaging/desktop/patina.desktop
        DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES packaging/desktop/patina.metainfo.xml
        DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo RENAME org.patina_editor.patina.metainfo.xml)
install(FILES packaging/desktop/patina-mime.xml
        DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME patina.xml)
install(FILES packaging/desktop/patina.svg
        DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
