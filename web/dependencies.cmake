# The dependencies of the module for the browser, in place of cmake/dependencies.cmake: what web/libraries.sh compiled,
# and headers of Debian's packages that are the same for every machine. KINEGRAPH_WEB_PREFIX is the folder that has both.
set(KINEGRAPH_WEB_PREFIX ${PROJECT_SOURCE_DIR}/build-web/cache/prefix CACHE PATH "Libraries compiled for WebAssembly")

# What the browser does itself (PNG and PDF), or what no page asks for: web/module/back_ends.cpp has these functions.
set(replaced_in_the_browser "/(algebra_ginac|cairo_backend|picture_difference|archive|font_files)\\.cpp$")

add_library(kinegraph_web_prefix INTERFACE)
target_include_directories(kinegraph_web_prefix SYSTEM INTERFACE
    ${PROJECT_SOURCE_DIR}/web/module/standard  # before the standard library's folder
    ${KINEGRAPH_WEB_PREFIX}/include ${KINEGRAPH_WEB_PREFIX}/include/eigen3)
add_library(tl::expected INTERFACE IMPORTED)
target_include_directories(tl::expected SYSTEM INTERFACE ${KINEGRAPH_WEB_PREFIX}/include)

foreach(name mpfr gmp harfbuzz nettle pugixml)
    list(APPEND linked_archives ${KINEGRAPH_WEB_PREFIX}/lib/lib${name}.a)
endforeach()
set(linked_libraries kinegraph_web_prefix)

add_library(kinegraph_headers INTERFACE)
target_include_directories(kinegraph_headers INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
target_link_libraries(kinegraph_headers INTERFACE kinegraph_web_prefix)
