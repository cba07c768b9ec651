# cmake --install: program and modules with manual, completion and what a desktop shows, schema; library with headers
# and find_package(kinegraph). The package for Python is a component of its own (python/CMakeLists.txt).
include(CMakePackageConfigHelpers)

set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/kinegraph)
if(TARGET kinegraph_app)
    install(TARGETS kinegraph_app)
    install(TARGETS ${modules} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/kinegraph)
    set(printed ${PROJECT_BINARY_DIR}/generated)
    install(FILES ${printed}/mechanism.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/kinegraph)
    install(DIRECTORY ${printed}/manual/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
    install(FILES ${printed}/completion.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
            RENAME kinegraph)
    install(FILES ${printed}/completion.zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions
            RENAME _kinegraph)
    install(FILES ${printed}/completion.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d
            RENAME kinegraph.fish)
    set(desktop ${PROJECT_SOURCE_DIR}/packaging/desktop)
    install(FILES ${desktop}/kinegraph.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
    install(FILES ${desktop}/kinegraph.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages)
    install(FILES ${desktop}/org.kinegraph.Kinegraph.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
    set(icons ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable)
    install(FILES ${desktop}/kinegraph.svg DESTINATION ${icons}/apps)
    install(FILES ${desktop}/kinegraph.svg DESTINATION ${icons}/mimetypes RENAME application-vnd.kinegraph+json.svg)
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

# Relative to the file, so that `cmake --install --prefix` may choose another one.
file(RELATIVE_PATH to_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" to_prefix "${to_prefix}")
configure_file(cmake/kinegraph.pc.in ${PROJECT_BINARY_DIR}/generated/kinegraph.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/generated/kinegraph.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
