// dlopen.
#include "app/module.hpp"

#include <dlfcn.h>

#include <filesystem>

#include "engine/assert.hpp"

namespace kinegraph::app {

tl::expected<const void*, Words> open_module(const std::string& name, const Words& purpose) {
    std::error_code ignored;
    const std::string file = name + ".so";
    const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    const std::filesystem::path path = exists(here / file, ignored) ? here / file : here / KINEGRAPH_MODULES / file;
    void* const module = ::dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (module == nullptr)
        return tl::unexpected(Words("{0} by a module of the program, which cannot be loaded: {1}",
                                    "{0} da un modulo del programma, che non si può caricare: {1}", purpose,
                                    std::string(::dlerror())));
    const void* const functions = ::dlsym(module, name.c_str());
    KG_ASSERT(functions != nullptr, "a module exports its functions under its own name");
    return functions;
}

}  // namespace kinegraph::app
