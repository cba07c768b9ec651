# cmake -DSOURCE=web/src -DEXAMPLES=examples -DOUTPUT=workbench_files.cpp -P embed_web.cmake: embeds the workbench's page
# and the examples in the program, each file as text under the path by which it is served. Some compilers limit a
# literal to 64 kB, so that a file is smaller than that.
set(rows)
function(embed path file)
    file(READ ${file} text)
    string(LENGTH "${text}" size)
    if(size GREATER 60000)
        message(FATAL_ERROR "${file} is too long for a literal")
    endif()
    if(text MATCHES "\\)web\"")
        message(FATAL_ERROR "${file} holds )web\", which would end the literal")
    endif()
    set(rows "${rows}    {\"${path}\"sv, R\"web(${text})web\"sv},\n" PARENT_SCOPE)
endfunction()
file(GLOB_RECURSE pages RELATIVE ${SOURCE} ${SOURCE}/*.html ${SOURCE}/*.css ${SOURCE}/*.js ${SOURCE}/*.svg)
foreach(page IN LISTS pages)
    embed(${page} ${SOURCE}/${page})
endforeach()
file(GLOB examples RELATIVE ${EXAMPLES} ${EXAMPLES}/*.json ${EXAMPLES}/*/*.json)
foreach(example IN LISTS examples)
    embed(examples/${example} ${EXAMPLES}/${example})
endforeach()
file(WRITE ${OUTPUT} "// Made from web/src and examples by cmake/embed_web.cmake.
#include \"app/workbench/web_files.hpp\"

namespace kinegraph::app {
namespace {

using std::string_view_literals::operator\"\"sv;

constexpr WebFile web_file_table[] = {
${rows}};

}  // namespace

std::span<const WebFile> web_files() { return web_file_table; }

}  // namespace kinegraph::app
")
