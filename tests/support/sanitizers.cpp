// What the sanitizers are told of libraries that are not ours, in the tests and in the program that they run.

#include "tests/support/sanitized.hpp"

#if defined(KINEGRAPH_SANITIZED)

extern "C" {
const char* __asan_default_options();
const char* __lsan_default_options();
const char* __lsan_default_suppressions();

/// The search for leaks reads the thread-local memory of modules opened late where it is not, and falls over at the end
/// of a program that did all it should: it is told to leave that memory alone. The rest is time: eight calls say where
/// a block was made, and the last 64 MB that were freed are watched.
const char* __asan_default_options() { return "intercept_tls_get_addr=0:malloc_context_size=8:quarantine_size_mb=64"; }
/// What a test reads on standard error is the program's.
const char* __lsan_default_options() { return "print_suppressions=0"; }
/// CLN keeps a string for as long as the program lives.
const char* __lsan_default_suppressions() { return "leak:libcln\n"; }
}

#endif
