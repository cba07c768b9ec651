// What the module exports: one function that answers a request, as text in memory.
#include <cstddef>
#include <string>

#include "app/workbench/answer.hpp"

namespace {
std::string text;  // the request, then its answer
}

// Room for a request of so many bytes of UTF-8, to be written by the caller.
extern "C" [[gnu::visibility("default")]] char* kinegraph_request(std::size_t size) {
    text.resize(size);
    return text.data();
}

// Answers the request, and returns the length of the answer, which kinegraph_text() points to.
extern "C" [[gnu::visibility("default")]] std::size_t kinegraph_answer() {
    text = kinegraph::app::workbench_answer(text);
    return text.size();
}

extern "C" [[gnu::visibility("default")]] const char* kinegraph_text() { return text.data(); }
