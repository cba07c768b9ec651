// Symbols and names of what a construction adds to a file's points, wherever they are said, tabulated or drawn.
#pragma once

#include "engine/mechanism/mechanism.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

/// A name that no point of the file has, for a point of the construction: K, K2, K3 …
std::string free_name(const Mechanism& mechanism, const std::string& letter);

/// P_13, the bodies in the file's order; P_1,3 where a body's name is longer than a letter, or a point of the file is
/// called P1 or C1 (centres are C in Italian): the two would be taken for one another.
Symbol centre_symbol(const Mechanism& mechanism, BodyIndex first, BodyIndex second, bool at_infinity);

}  // namespace kinegraph
