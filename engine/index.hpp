// An index into a list, as std::vector wants it.
#pragma once

#include <cstddef>

namespace kinegraph {

inline std::size_t at_index(int index) { return static_cast<std::size_t>(index); }

}  // namespace kinegraph
