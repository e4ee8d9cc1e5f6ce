# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` puts where. The programs find share/patina relative to themselves, so an
# installation may be moved.

install(TARGETS patina patina-files RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY shaders presets schemas DESTINATION ${CMAKE_INSTALL_DATADIR}/patina)
install(FILES packaging/desktop/patina.desktop
        DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES packaging/desktop/patina.metainfo.xml
        DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo RENAME org.patina_editor.patina.metainfo.xml)
install(FILES packaging/desktop/patina-mime.xml
        DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages RENAME patina.xml)
install(FILES packaging/desktop/patina.svg
        DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
