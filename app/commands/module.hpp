// Modules: parts of the program that a run loads only where it needs them.
#pragma once

#include <future>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "engine/file/words.hpp"

namespace kinegraph::app {

/// What a module exports under its own name, looked for in NAME.so: beside the program, as it is built, or in
/// lib/kinegraph, where it is installed. It stays loaded to the end of the run. `purpose`: what it does, for the
/// message where it cannot be loaded.
tl::expected<const void*, Words> open_module(const std::string& name, const Words& purpose);

/// Loads modules one after the other beside what the run does until it opens them; what cannot be loaded is said then.
/// Once a run.
[[nodiscard]] std::future<void> load_modules_ahead(std::vector<std::string> names);

template <class Functions>
tl::expected<const Functions*, Words> open_module_as(const std::string& name, const Words& purpose) {
    return open_module(name, purpose).map([](const void* functions) {
        return static_cast<const Functions*>(functions);
    });
}

}  // namespace kinegraph::app
