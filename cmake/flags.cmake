# The compiler options of our own code: build type, warnings, sanitizers; ccache if installed.
if(PROJECT_IS_TOP_LEVEL)
    if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
        set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug, RelWithDebInfo or MinSizeRel" FORCE)
    endif()
    # -O2 takes 1.4 times as long to compile and makes no command faster by more than a twentieth: the time goes into
    # GMP and into allocation.
    set(CMAKE_CXX_FLAGS_RELEASE "-O1 -DNDEBUG")
    if(KINEGRAPH_WEB)
        set(CMAKE_CXX_FLAGS_RELEASE "-Os -DNDEBUG")  # the module is sent to each visitor
    elseif(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        # A compiler that collects its garbage less often is faster by a tenth, for a quarter more memory.
        string(APPEND CMAKE_CXX_FLAGS_RELEASE " --param ggc-min-expand=200 --param ggc-min-heapsize=500000")
    endif()
    set(CMAKE_CXX_EXTENSIONS OFF)
    set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
    find_program(KINEGRAPH_CCACHE ccache)
    mark_as_advanced(KINEGRAPH_CCACHE)
    if(KINEGRAPH_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
        # ccache caches precompiled headers only with these settings; the headers are compared by content.
        set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${KINEGRAPH_CCACHE})
        if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
            add_compile_options(-fpch-preprocess)
        endif()
    endif()
endif()

add_library(kinegraph_flags INTERFACE)
target_compile_options(kinegraph_flags INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion
    -ffp-contract=off                                 # the same results to the last bit on every processor
    -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=        # no absolute path in any output
    -ffunction-sections -fdata-sections)
if(NOT KINEGRAPH_WEB)
    target_compile_options(kinegraph_flags INTERFACE -fno-semantic-interposition)  # our functions are not replaced at load time
endif()

if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
    add_compile_options(-fsized-deallocation)  # on by default in C++14, but an option in clang
endif()

if(KINEGRAPH_FUZZ)
    set(CMAKE_CXX_FLAGS_RELEASE "-O1 -g1")
    add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all -D_GLIBCXX_ASSERTIONS)
    add_link_options(-fsanitize=address,undefined)
elseif(KINEGRAPH_SANITIZE)
    # Objects that are linked together must agree, so these options are for the whole tree.
    set(CMAKE_CXX_FLAGS_RELEASE "-O1 -g1")
    add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer -D_GLIBCXX_ASSERTIONS)
    # A null or dangling pointer that is used also ends the program under ASan; these checks before each use take a
    # third of the compile time. The libFuzzer target has all checks.
    add_compile_options(-fno-sanitize=null,alignment,vptr,object-size)
    # With sanitizers GCC 12 warns wrongly of uninitialised members in std::regex and std::variant.
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        add_compile_options(-Wno-maybe-uninitialized)
    endif()
    add_link_options(-fsanitize=address,undefined)
endif()
