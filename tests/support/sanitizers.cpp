// Options of the sanitizers for third-party libraries, in the tests and in the program that they run.

#include "tests/support/sanitized.hpp"

#if defined(KINEGRAPH_SANITIZED)

extern "C" {
const char* __asan_default_options();
const char* __lsan_default_options();
const char* __lsan_default_suppressions();

/// The leak detector crashes at the end of a successful program when it reads the thread-local memory of modules loaded
/// late; so it does not intercept that memory. The other options save time: stacks of eight calls, and a quarantine of
/// 64 MB of freed memory.
const char* __asan_default_options() { return "intercept_tls_get_addr=0:malloc_context_size=8:quarantine_size_mb=64"; }
/// Tests read standard error, which must contain only the program's output.
const char* __lsan_default_options() { return "print_suppressions=0"; }
/// CLN keeps a string until the end of the program.
const char* __lsan_default_suppressions() { return "leak:libcln\n"; }
}

#endif
