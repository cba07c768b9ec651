#include "engine/file/algebra.hpp"

#include <atomic>

namespace kinegraph {
namespace {

// Set once, when a program starts.
std::atomic<AlgebraSource> source{nullptr};  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

}  // namespace

void take_algebra_from(AlgebraSource from) { source = from; }

tl::expected<const Algebra*, Words> algebra() {
    const AlgebraSource from = source;
    if (from != nullptr) return from();
    return tl::make_unexpected(Words("this program names no algebra for derivatives (take_algebra_from)",
                                     "questo programma non indica un’algebra per le derivate (take_algebra_from)"));
}

}  // namespace kinegraph
