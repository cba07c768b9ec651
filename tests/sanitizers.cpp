// What the sanitizers are told of libraries that are not ours, in the tests and in the program that they run.

#if defined(__SANITIZE_ADDRESS__)  // GCC's word for it, and clang's:
#define KINEGRAPH_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define KINEGRAPH_SANITIZED
#endif
#endif

#ifdef KINEGRAPH_SANITIZED

extern "C" {
const char* __asan_default_options();
const char* __lsan_default_options();
const char* __lsan_default_suppressions();

/// The search for leaks reads the thread-local memory of modules opened late where it is not, and falls over at the end of a
/// program that did all it should: it is told to leave that memory alone.
const char* __asan_default_options() { return "intercept_tls_get_addr=0"; }
/// What a test reads on standard error is the program's.
const char* __lsan_default_options() { return "print_suppressions=0"; }
/// CLN keeps a string for as long as the program lives.
const char* __lsan_default_suppressions() { return "leak:libcln\n"; }
}

#endif
