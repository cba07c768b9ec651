// Holds: see holds.hpp.
#include "render/ink/holds.hpp"

#include <array>

namespace kinegraph::render {

std::string_view name_of(Holds::Form form) {
    static constexpr std::array<std::string_view, 12> names{"",        "at",      "with",   "arrow",  "couple", "line",
                                                            "segment", "through", "normal", "circle", "arc",    "body"};
    return names[static_cast<std::size_t>(form)];
}

}  // namespace kinegraph::render
