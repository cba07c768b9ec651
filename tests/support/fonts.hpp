// The fonts, opened once for all tests that draw.
#pragma once

#include "render/text/text.hpp"

namespace kinegraph::tests {

inline const render::Fonts& fonts() {
    static const render::Fonts opened = render::Fonts::open().value();
    return opened;
}

}  // namespace kinegraph::tests
