// The sentences of a solution in English, for tests that search for words.
#pragma once

#include <string>

#include "engine/solution/findings.hpp"
#include "render/text/words.hpp"

namespace kinegraph {

inline std::string english(const Message& message) { return render::tell(message, Language::en); }
inline std::string english_of(const Unsolved& unsolved) {
    return english(unsolved.what) + ": " + english(unsolved.why);
}

}  // namespace kinegraph
