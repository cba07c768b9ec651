# How our own code is compiled: the build type, the warnings, the sanitizers, ccache where it is.
if(PROJECT_IS_TOP_LEVEL)
    if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
        set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug, RelWithDebInfo or MinSizeRel" FORCE)
    endif()
    set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
    set(CMAKE_CXX_EXTENSIONS OFF)
    set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
    find_program(KINEGRAPH_CCACHE ccache)
    mark_as_advanced(KINEGRAPH_CCACHE)
    if(KINEGRAPH_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
        # Precompiled headers are cached only where it is said that what they define counts by the headers' own bytes.
        set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${KINEGRAPH_CCACHE})
        if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
            add_compile_options(-fpch-preprocess)
        endif()
    endif()
endif()

add_library(kinegraph_flags INTERFACE)
target_compile_options(kinegraph_flags INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion
    -ffp-contract=off                                 # the same program gives the same bits
    -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=        # no path of this machine in any output
    -ffunction-sections -fdata-sections
    -fno-semantic-interposition)                      # nobody puts a function of his own in the place of one of ours

if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
    add_compile_options(-fsized-deallocation)  # which C++ has since 2014, and clang when it is asked
endif()

if(KINEGRAPH_FUZZ)
    set(CMAKE_CXX_FLAGS_RELEASE "-O1 -g1")
    add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -D_GLIBCXX_ASSERTIONS)
    add_link_options(-fsanitize=address,undefined)
elseif(KINEGRAPH_SANITIZE)
    # Everything that is linked together must agree, so these are for the whole tree.
    set(CMAKE_CXX_FLAGS_RELEASE "-O1 -g1")
    add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer -D_GLIBCXX_ASSERTIONS)
    # A null or dangling pointer that is used ends the program by ASan's hand too; to ask before each use costs a third of the
    # compile time. The target of libFuzzer asks everything.
    add_compile_options(-fno-sanitize=null,alignment,vptr,object-size)
    # GCC 12 sees uninitialised members in std::regex and std::variant once the sanitizers' code stands between.
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        add_compile_options(-Wno-maybe-uninitialized)
    endif()
    add_link_options(-fsanitize=address,undefined)
endif()
