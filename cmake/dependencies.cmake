# What we build on, all of it Debian packages (cmake/packages.txt). The part that the installed library needs is in
# cmake/link_dependencies.cmake, which kinegraphConfig.cmake includes too.
find_package(PkgConfig REQUIRED)
include(${CMAKE_CURRENT_LIST_DIR}/link_dependencies.cmake)

# Headers alone, met only in our sources.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
# CGAL is used as headers over GMP; its own find_package looks for much that we do not use and sets flags for all.
find_path(CGAL_INCLUDE_DIR CGAL/Simple_cartesian.h REQUIRED)
mark_as_advanced(CGAL_INCLUDE_DIR)

# Met only in a module of the program.
pkg_check_modules(zip REQUIRED IMPORTED_TARGET libzip)

# What our own sources see besides the public headers: the headers of the folders, and of libraries that stay inside.
add_library(kinegraph_headers INTERFACE)
target_include_directories(kinegraph_headers INTERFACE ${PROJECT_SOURCE_DIR})
target_link_libraries(kinegraph_headers INTERFACE PkgConfig::gmp)
target_include_directories(kinegraph_headers SYSTEM INTERFACE ${CGAL_INCLUDE_DIR})
target_link_libraries(kinegraph_headers INTERFACE Eigen3::Eigen nlohmann_json::nlohmann_json CLI11::CLI11)
