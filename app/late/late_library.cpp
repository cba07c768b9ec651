#include "app/late/late_library.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

#include "engine/number/assert.hpp"
#include "lang/keys/library.hpp"

namespace kinegraph::app {

tl::expected<const void*, Words> late_library(const std::string& name, const Words& purpose) {
    std::error_code ignored;
    const std::string file = name + ".so";
    const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    const std::filesystem::path built = here / file, installed = here / KINEGRAPH_MODULE_FOLDER / file;
    void* const library = ::dlopen((exists(built, ignored) ? built : installed).c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (library == nullptr)
        return tl::unexpected(Words(lang::library::by_a_module_of_the_program, purpose, std::string(::dlerror())));
    const void* const exported = ::dlsym(library, name.c_str());
    KG_ASSERT(exported != nullptr, "a module exports its functions under its own name");
    return exported;
}

}  // namespace kinegraph::app
