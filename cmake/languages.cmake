# The texts of the languages, lang/en.txt and so on: makes lang/keys/SECTION.hpp, a header of keys for each section of
# lang/en.txt, and lang/sections.cpp with the texts of all languages. Fails if a language has other keys than English.
# A header is written only if it changes, so a new text recompiles only what uses its section.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS include/kinegraph/error.hpp)
file(READ include/kinegraph/error.hpp error_header)
string(REGEX MATCH "std::array languages{[^}]*}" language_codes "${error_header}")
string(REGEX MATCHALL "Language::[a-z]+" language_codes "${language_codes}")
list(TRANSFORM language_codes REPLACE "Language::" "")
set(lang_directory ${PROJECT_BINARY_DIR}/generated/lang)

function(write_if_changed path content)
    if(EXISTS ${path})
        file(READ ${path} old)
    endif()
    if(NOT "${old}" STREQUAL "${content}")
        file(WRITE ${path} "${content}")
    endif()
endfunction()

# Sets LANGUAGE_SECTION to the text of each section, what stands between its heading and the next one; LANGUAGE_heads to
# the headings and keys in their order, without the keys of the cases, which are the language's own; and sections.
function(read_language language text)
    set(heads)
    set(names)
    string(REGEX REPLACE "(^|\n)(#[^\n]*| [^\n]*|== [a-z_]+ ==|[a-z][a-z0-9_]* = [^\n]+)" "\\1" rest "${text}")
    string(REGEX REPLACE "\n+" "" rest "${rest}")
    if(rest)
        message(FATAL_ERROR "lang/${language}.txt: \"${rest}\" is no comment, heading, `key = text` or continuation")
    endif()
    string(REGEX MATCHALL "\n== [a-z_]+ ==\n" headings "\n${text}")
    foreach(heading IN LISTS headings)
        string(REGEX REPLACE "[\n= ]" "" section "${heading}")
        string(LENGTH "${heading}" length)
        string(FIND "${text}" "${heading}" at)
        math(EXPR at "${at} + ${length}")
        string(SUBSTRING "${text}" ${at} -1 rest)
        string(FIND "${rest}" "\n== " end)
        string(SUBSTRING "${rest}" 0 ${end} own)
        set(${language}_${section} "${own}" PARENT_SCOPE)
        list(APPEND names ${section})
        list(APPEND heads "== ${section} ==")
        if(NOT section STREQUAL "cases")
            string(REGEX MATCHALL "\n[a-z][a-z0-9_]* =" keys "\n${own}")
            list(TRANSFORM keys REPLACE "[\n= ]" "")
            list(APPEND heads ${keys})
        endif()
    endforeach()
    set(${language}_heads ${heads} PARENT_SCOPE)
    set(sections ${names} PARENT_SCOPE)
endfunction()

# Writes the texts of the languages, each in the order of the languages.
function(write_sections path)
    set(all "// Made from lang/*.txt by cmake/languages.cmake.\n#include \"lang/words.hpp\"\n\nnamespace kinegraph::lang {\n")
    foreach(section IN LISTS sections)
        string(APPEND all "\nextern const Section ${section}_section;\nconstinit const Section ${section}_section{{")
        foreach(language IN LISTS ARGN)
            string(APPEND all "R\"lang(${${language}_${section}})lang\",\n")
        endforeach()
        string(APPEND all "}};\n")
    endforeach()
    list(TRANSFORM sections REPLACE "(.+)" "    &\\1_section" OUTPUT_VARIABLE addresses)
    list(JOIN addresses ",\n" addresses)
    string(APPEND all "\nstd::span<const Section* const> all_sections() {
    static constexpr const Section* all[] = {\n${addresses}};
    return all;\n}\n")
    write_if_changed(${path} "${all}\n}  // namespace kinegraph::lang\n")
endfunction()

foreach(language IN LISTS language_codes)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS lang/${language}.txt)
    file(READ lang/${language}.txt text)
    read_language(${language} "${text}")
    foreach(head IN LISTS en_heads)
        if(NOT head IN_LIST ${language}_heads)
            message(FATAL_ERROR "lang/${language}.txt lacks \"${head}\"")
        endif()
    endforeach()
    foreach(english own IN ZIP_LISTS en_heads ${language}_heads)
        if(NOT english STREQUAL own)
            message(FATAL_ERROR "lang/${language}.txt: \"${own}\" stands where English has \"${english}\"")
        endif()
    endforeach()
endforeach()

foreach(section IN LISTS sections)
    set(keys "// Made from lang/en.txt by cmake/languages.cmake.
#pragma once

#include \"lang/words.hpp\"

namespace kinegraph::lang {
extern const Section ${section}_section;
namespace ${section} {
")
    set(names)
    if(NOT section STREQUAL "cases")  # another language has other cases
        string(REGEX MATCHALL "\n[a-z][a-z0-9_]* =" names "\n${en_${section}}")
    endif()
    set(index 0)
    foreach(name IN LISTS names)
        string(REGEX REPLACE "[\n= ]" "" name "${name}")
        string(APPEND keys "inline constexpr Key ${name}{&${section}_section, ${index}};\n")
        math(EXPR index "${index} + 1")
    endforeach()
    string(APPEND keys "}  // namespace ${section}\n}  // namespace kinegraph::lang\n")
    write_if_changed(${lang_directory}/keys/${section}.hpp "${keys}")
endforeach()
write_sections(${lang_directory}/sections.cpp ${language_codes})
