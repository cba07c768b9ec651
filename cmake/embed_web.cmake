# cmake -DSOURCE=web/src -DSCRIPT=main.js -DEXAMPLES=examples -DOUTPUT=web_files.cpp -P embed_web.cmake: embeds the
# workbench's page, its script and the examples in the program, each file as text under the path by which it is served.
# Some compilers limit a literal to 64 kB, so the text of a longer file is a concatenation of literals.
set(rows)
function(embed path file)
    file(READ ${file} text)
    if(text MATCHES "\\)web\"")
        message(FATAL_ERROR "${file} holds )web\", which would end the literal")
    endif()
    set(literals)
    string(LENGTH "${text}" size)
    set(at 0)
    if(size GREATER 60000 AND text MATCHES "[^\t\n\r -~]")
        message(FATAL_ERROR "${file} is long and not ASCII, as esbuild writes scripts: a character might be cut in two")
    endif()
    while(at LESS size)
        string(SUBSTRING "${text}" ${at} 60000 piece)
        string(APPEND literals "\n        R\"web(${piece})web\"")
        math(EXPR at "${at} + 60000")
    endwhile()
    set(rows "${rows}    {\"${path}\"sv,${literals}sv},\n" PARENT_SCOPE)
endfunction()
embed(main.js ${SCRIPT})
file(GLOB_RECURSE pages RELATIVE ${SOURCE} ${SOURCE}/*.html ${SOURCE}/*.css ${SOURCE}/*.svg)
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
