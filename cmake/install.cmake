# cmake --install: program and modules, library with headers and find_package(kinegraph), schema, man page.
include(CMakePackageConfigHelpers)

set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/kinegraph)
if(TARGET kinegraph_app)
    install(TARGETS kinegraph_app)
    install(TARGETS ${modules} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/kinegraph)
    install(FILES ${PROJECT_BINARY_DIR}/generated/mechanism.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/kinegraph)
endif()
if(BUILD_SHARED_LIBS)
    install(TARGETS kinegraph_shared EXPORT kinegraph)
else()
    install(TARGETS kinegraph EXPORT kinegraph)
endif()
install(EXPORT kinegraph NAMESPACE kinegraph:: FILE kinegraphTargets.cmake DESTINATION ${package_directory})
install(DIRECTORY include/kinegraph DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

configure_package_config_file(cmake/kinegraphConfig.cmake.in ${PROJECT_BINARY_DIR}/generated/kinegraphConfig.cmake
                              INSTALL_DESTINATION ${package_directory})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/generated/kinegraphConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/generated/kinegraphConfig.cmake
              ${PROJECT_BINARY_DIR}/generated/kinegraphConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/link_dependencies.cmake
        DESTINATION ${package_directory})

configure_file(cmake/kinegraph.pc.in ${PROJECT_BINARY_DIR}/generated/kinegraph.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/generated/kinegraph.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(FILES docs/kinegraph.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
