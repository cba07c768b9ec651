// What a solution says, in English, for tests that look for words in it.
#pragma once

#include <string>

#include "engine/solution/solution.hpp"
#include "render/text/words.hpp"

namespace kinegraph {

inline std::string english(const Message& message) { return render::tell(message, render::Language::en); }
inline std::string english_of(const Unsolved& unsolved) {
    return english(unsolved.what) + ": " + english(unsolved.why);
}

}  // namespace kinegraph
