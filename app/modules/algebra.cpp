// kinegraph_algebra.so: the library's derivatives by GiNaC, for the program to load when a file states laws of motion.
#include "app/modules/algebra.hpp"

namespace {

tl::expected<kinegraph::Expression, kinegraph::Words> derivative(const kinegraph::Expression& of,
                                                                 const kinegraph::NamedConstants& constants) {
    return kinegraph::ginac_algebra.derivative(of, constants);
}

}  // namespace

extern "C" [[gnu::visibility("default")]] const kinegraph::app::AlgebraFunctions kinegraph_algebra{{derivative}};
