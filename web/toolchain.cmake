# CMake toolchain of the module for the browser: Debian's clang for the target and the system libraries of Debian's
# emscripten. emcc would call the same compiler, but takes a second for each file to start; it only links.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(emscripten /usr/share/emscripten)
set(CMAKE_CXX_COMPILER clang++-14)
set(CMAKE_ASM_COMPILER clang-14)
set(CMAKE_AR llvm-ar-14)
set(CMAKE_RANLIB llvm-ranlib-14)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(target "--target=wasm32-unknown-emscripten --sysroot=${emscripten}/cache/sysroot")
set(CMAKE_ASM_FLAGS_INIT "${target}")
# Exceptions as WebAssembly has them, and what emcc tells clang.
set(CMAKE_CXX_FLAGS_INIT "${target} -fwasm-exceptions -D_LIBCPP_ABI_VERSION=2 -fno-threadsafe-statics \
-fvisibility=default -Xclang -iwithsysroot/include/compat \
-mllvm -combiner-global-alias-analysis=false -mllvm -disable-lsr")
set(CMAKE_FIND_ROOT_PATH ${emscripten}/cache/sysroot)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
