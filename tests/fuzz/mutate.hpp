// Mutations of a mechanism file as a tree: what comes out is JSON nearly always, and nearly a mechanism often.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace kinegraph::fuzz {

/// Half the time a few numbers change by some percent, so that many files are drawn; otherwise one to four changes of
/// numbers, names, members, whole subtrees; `donor`, where it is another file, gives of its own.
/// The same seed changes the same. Empty where the text is no JSON.
std::string mutated(std::string_view text, std::string_view donor, std::uint32_t seed);

}  // namespace kinegraph::fuzz
