#include "engine/mechanism/compound_units.hpp"

#include <initializer_list>
#include <string>

#include "engine/file/units.hpp"

namespace kinegraph {
namespace {

/// The first that is a unit of the kind; else the default unit of the kind.
Unit first_known(QuantityKind kind, std::initializer_list<std::string> wanted) {
    for (const std::string& each : wanted)
        if (const KnownUnit* known = unit_spelt(each); known != nullptr && known->kind == kind)
            return {std::string(known->symbol), known->si};
    const KnownUnit& own = default_unit(kind);
    return {std::string(own.symbol), own.si};
}

}  // namespace

Unit unit_of_force_per_length(const Units& units) {
    return first_known(QuantityKind::force_per_length,
                       {units.force.symbol + "/" + units.length.symbol, units.force.symbol + "/m"});
}

Unit unit_of_torsional_stiffness(const Units& units) {
    return first_known(QuantityKind::torsional_stiffness, {units.moment.symbol + "/rad"});
}

}  // namespace kinegraph
