# cmake -DSOURCE=render/live -DOUTPUT=live_script.cpp -P embed_live.cmake: embeds the scripts and the style sheet of the
# live page as text. Some compilers limit a literal to 64 kB, so the text is a concatenation of literals.
function(literal out text)
    if(text MATCHES "\\)live\"")
        message(FATAL_ERROR "a file of ${SOURCE} holds )live\", which would end the literal")
    endif()
    set(${out} "R\"live(${text})live\"sv" PARENT_SCOPE)
endfunction()

set(script)
set(modules types closure guards replay given motion path room marks paper area arrow_binder line_binder placed_labels
    label_binder link_binder ground_binder held_marks held_shapes held_forms held_binder figures measure loaded tasks
    report choices pen exercise plot panel tell drag drive stage steps hall keys page main)
foreach(name ${modules})
    file(READ ${SOURCE}/${name}.js text)
    string(REGEX REPLACE "(^|\n)import [^;]*;" "\\1" text "${text}")
    string(REGEX REPLACE "\nexport ({};|)" "\n" text "${text}")
    if(text MATCHES "</script")
        message(FATAL_ERROR "${name}.js would end the element that it stands in")
    endif()
    literal(piece "${text}")
    string(APPEND script "\n    ${piece}")
endforeach()
file(READ ${SOURCE}/watch.js text)
literal(watch "${text}")
foreach(part page.css controls.html cam/cam.js cam/cam.css cam/cam.html)
    file(READ ${SOURCE}/${part} text)
    string(REGEX REPLACE "\nexport {};" "" text "${text}")
    literal(${part} "${text}")
endforeach()
file(WRITE ${OUTPUT} "// Made from render/live by cmake/embed_live.cmake.
#include \"render/live/live_page.hpp\"

namespace kinegraph::render {

using std::string_view_literals::operator\"\"sv;  // which knows its length: counting takes a compiler too long

constinit const std::string_view live_script =${script};
constinit const std::string_view live_watch_script = ${watch};
constinit const std::string_view live_style = ${page.css};
constinit const std::string_view live_controls = ${controls.html};
constinit const std::string_view cam_script = ${cam/cam.js};
constinit const std::string_view cam_style = ${cam/cam.css};
constinit const std::string_view cam_controls = ${cam/cam.html};

}  // namespace kinegraph::render
")
