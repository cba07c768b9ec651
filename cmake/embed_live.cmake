# cmake -DSOURCE=render/live -DOUTPUT=live_script.cpp -P embed_live.cmake: embeds the scripts and the style sheet of the
# live page as text. Some compilers limit a literal to 64 kB, so the text is a concatenation of literals.
function(literal out text)
    if(text MATCHES "\\)live\"")
        message(FATAL_ERROR "a file of ${SOURCE} holds )live\", which would end the literal")
    endif()
    set(${out} "R\"live(${text})live\"" PARENT_SCOPE)
endfunction()

set(script)
foreach(name types closure replay given motion room figures bindings measure tasks report exercise traces panel tell rooms drag drive stage steps hall page)
    file(READ ${SOURCE}/${name}.js text)
    if(text MATCHES "</script")
        message(FATAL_ERROR "${name}.js would end the element that it stands in")
    endif()
    literal(piece "${text}")
    string(APPEND script "\n    ${piece}")
endforeach()
file(READ ${SOURCE}/watch.js text)
literal(watch "${text}")
file(READ ${SOURCE}/page.css text)
literal(style "${text}")
file(READ ${SOURCE}/controls.html text)
literal(controls "${text}")
file(WRITE ${OUTPUT} "// Made from render/live by cmake/embed_live.cmake.
#include \"render/live/live_page.hpp\"

namespace kinegraph::render {

constinit const std::string_view live_script =${script};
constinit const std::string_view live_watch_script = ${watch};
constinit const std::string_view live_style = ${style};
constinit const std::string_view live_controls = ${controls};

}  // namespace kinegraph::render
")
