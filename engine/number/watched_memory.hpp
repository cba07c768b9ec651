// Watched memory: whether a sanitizer looks after memory. It must see every block end, and keeps what is freed from
// being used again; so where it does, nothing is kept at hand.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define KINEGRAPH_MEMORY_WATCHED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define KINEGRAPH_MEMORY_WATCHED 1
#endif
#endif
