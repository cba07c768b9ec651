// dlopen. It and dlsym wait for each other: so what is loaded ahead is asked for its functions by the thread that loads
// it.
#include "app/commands/module.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <map>
#include <system_error>
#include <utility>

#include "engine/number/assert.hpp"

namespace kinegraph::app {
namespace {

using Loaded = tl::expected<const void*, std::string>;

Loaded load(const std::string& name) {
    std::error_code ignored;
    const std::string file = name + ".so";
    const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    const std::filesystem::path path = exists(here / file, ignored) ? here / file : here / KINEGRAPH_MODULES / file;
    void* const module = ::dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (module == nullptr) return tl::unexpected(std::string(::dlerror()));
    const void* const functions = ::dlsym(module, name.c_str());
    KG_ASSERT(functions != nullptr, "a module exports its functions under its own name");
    return functions;
}

/// Modules that are loaded ahead, by name. Filled before there is another thread that reads it.
std::map<std::string, std::shared_future<Loaded>>& loaded_ahead() {
    static std::map<std::string, std::shared_future<Loaded>> modules;
    return modules;
}

}  // namespace

std::future<void> load_modules_ahead(std::vector<std::string> names) {
    std::vector<std::packaged_task<Loaded()>> tasks;
    for (std::string& name : names) {
        std::packaged_task<Loaded()> task([name] { return load(name); });
        loaded_ahead()[std::move(name)] = task.get_future().share();
        tasks.push_back(std::move(task));
    }
    try {
        return std::async(std::launch::async, [tasks = std::move(tasks)]() mutable {
            for (std::packaged_task<Loaded()>& task : tasks) task();
        });
    } catch (const std::system_error&) {
        loaded_ahead().clear();  // the machine gives no thread: they are loaded when they are opened
        return {};
    }
}

tl::expected<const void*, Words> open_module(const std::string& name, const Words& purpose) {
    const auto ahead = loaded_ahead().find(name);
    Loaded loaded = ahead != loaded_ahead().end() ? ahead->second.get() : load(name);
    // What a thread had no room for beside the others may have some now.
    if (!loaded && ahead != loaded_ahead().end()) loaded = load(name);
    if (!loaded)
        return tl::unexpected(Words("{0} by a module of the program, which cannot be loaded: {1}",
                                    "{0} da un modulo del programma, che non si può caricare: {1}", purpose,
                                    loaded.error()));
    return *loaded;
}

}  // namespace kinegraph::app
