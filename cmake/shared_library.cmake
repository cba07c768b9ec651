# The shared library: the objects of the static one, of which only the public face is visible. -DBUILD_SHARED_LIBS=ON
# builds and installs it in place of the static library; otherwise it is a target of its own, for its test.
set(exported ${PROJECT_SOURCE_DIR}/cmake/exported_symbols.map)
file(WRITE ${PROJECT_BINARY_DIR}/generated/shared_library.cpp "")
add_library(kinegraph_shared SHARED ${PROJECT_BINARY_DIR}/generated/shared_library.cpp)
set_target_properties(kinegraph_shared PROPERTIES
    OUTPUT_NAME kinegraph EXPORT_NAME kinegraph LINKER_LANGUAGE CXX LINK_DEPENDS ${exported}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
target_compile_features(kinegraph_shared PUBLIC cxx_std_20)
target_include_directories(kinegraph_shared PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                                   $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(kinegraph_shared
    PUBLIC tl::expected
    PRIVATE -Wl,--whole-archive $<BUILD_INTERFACE:kinegraph> -Wl,--no-whole-archive)
target_link_options(kinegraph_shared PRIVATE
    LINKER:--version-script=${exported} LINKER:--gc-sections LINKER:--as-needed LINKER:--no-undefined)
if(NOT BUILD_SHARED_LIBS)
    set_target_properties(kinegraph_shared PROPERTIES EXCLUDE_FROM_ALL ON)
endif()
