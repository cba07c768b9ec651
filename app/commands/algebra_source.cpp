#include "app/commands/algebra_source.hpp"

#include "app/commands/module.hpp"
#include "app/modules/algebra.hpp"

namespace kinegraph::app {

tl::expected<const Algebra*, Words> loaded_algebra() {
    static const auto functions = open_module_as<AlgebraFunctions>(
        "kinegraph_algebra", {"derivatives in symbols are found", "le derivate in simboli sono trovate"});
    return functions.map([](const AlgebraFunctions* loaded) { return &loaded->algebra; });
}

}  // namespace kinegraph::app
