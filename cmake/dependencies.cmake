# The dependencies, all of them Debian packages (cmake/packages.txt). Those of the installed library are in
# cmake/link_dependencies.cmake, which kinegraphConfig.cmake also includes.
find_package(PkgConfig REQUIRED)
include(${CMAKE_CURRENT_LIST_DIR}/link_dependencies.cmake)

# Header-only libraries, used only in our sources.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
# CGAL is used as headers over GMP. Its own find_package searches for libraries that we do not use and sets global
# flags.
find_path(CGAL_INCLUDE_DIR CGAL/Simple_cartesian.h REQUIRED)
mark_as_advanced(CGAL_INCLUDE_DIR)

# Include paths of our own sources: the folders, and the libraries that no public header uses.
add_library(kinegraph_headers INTERFACE)
target_include_directories(kinegraph_headers INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
target_link_libraries(kinegraph_headers INTERFACE PkgConfig::gmp)
target_include_directories(kinegraph_headers SYSTEM INTERFACE ${CGAL_INCLUDE_DIR})
target_link_libraries(kinegraph_headers INTERFACE Eigen3::Eigen nlohmann_json::nlohmann_json CLI11::CLI11)

# Sums in the order of their terms, so that the check's last digits are the same on every machine.
target_compile_definitions(kinegraph_headers INTERFACE EIGEN_DONT_VECTORIZE)

# What the library links.
set(linked_libraries PkgConfig::gmp PkgConfig::mpfr PkgConfig::ginac PkgConfig::cairo PkgConfig::harfbuzz_subset
    PkgConfig::harfbuzz PkgConfig::freetype PkgConfig::png PkgConfig::nettle PkgConfig::zip pugixml::pugixml)
