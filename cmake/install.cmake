# What `cmake --install` puts under the prefix: the core as the package batten with the target batten::core, and the program with what
# belongs to it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/batten)
set(headers ${CMAKE_INSTALL_INCLUDEDIR}/batten)
set_target_properties(batten_core PROPERTIES EXPORT_NAME core)
# Headers of the core include each other as "core/..."; others may write <batten/core/...>, which says whose they are.
install(TARGETS batten_core EXPORT batten
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${headers})
# The inside of document/ alone speaks of JSON; other headers need the inside of their folders.
install(DIRECTORY core ${PROJECT_BINARY_DIR}/core/generated/core DESTINATION ${headers}
  FILES_MATCHING PATTERN "*.h" PATTERN "document/detail" EXCLUDE)
install(EXPORT batten NAMESPACE batten:: FILE battenTargets.cmake DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/battenConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/battenConfig.cmake cmake/glm_target.cmake ${PROJECT_BINARY_DIR}/battenConfigVersion.cmake DESTINATION ${package})

if(BATTEN_PROGRAM)
  install(TARGETS batten DESTINATION ${CMAKE_INSTALL_BINDIR})
  if(TARGET batten_occt)
    install(TARGETS batten_occt DESTINATION libexec/batten)  # where exchange/cad/occt_process.cpp looks for it
  endif()
  install(DIRECTORY assets/examples assets/lessons DESTINATION ${CMAKE_INSTALL_DATADIR}/batten)
  install(FILES assets/batten.schema.json assets/lesson.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/batten)
  if(TARGET man_page)
    install(FILES ${PROJECT_BINARY_DIR}/batten.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  endif()
  if(BATTEN_WINDOW)
    install(FILES assets/batten.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
    install(FILES assets/batten.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
  endif()
endif()
