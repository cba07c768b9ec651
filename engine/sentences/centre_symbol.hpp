// Symbols and names for constructed points, used in text, tables and figures.
#pragma once

#include "engine/mechanism/mechanism.hpp"
#include "engine/sentences/statement.hpp"

namespace kinegraph {

/// A name for a constructed point that no point of the file has: K, K2, K3 …
std::string free_name(const Mechanism& mechanism, const std::string& letter);

/// P_13, the bodies in the file's order; P_1,3 where a body's name is longer than a letter, or where a point of the
/// file is called P1 or C1 (centres are C in Italian) and could be confused with it.
Symbol centre_symbol(const Mechanism& mechanism, BodyIndex first, BodyIndex second, bool at_infinity);

}  // namespace kinegraph
