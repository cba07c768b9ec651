// Checked numbers: the results of the numerical check for quantities, drawn vectors and forces, SI units. Values that
// are rounding noise relative to the largest of their kind become 0. Only looks up; computes no mechanics.
#pragma once

#include <cmath>
#include <map>
#include <optional>

#include "engine/number/functions.hpp"
#include "engine/solution/magnitudes.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph::render {

class CheckedNumbers {
public:
    explicit CheckedNumbers(const Solution& solution) : solution_(solution), magnitudes_(solution) {
        for (const CheckRow& row : solution.checks) rows_.emplace(row.quantity, row);
    }

    std::optional<double> of(const Quantity& quantity) const {
        const auto found = rows_.find(quantity);
        return found == rows_.end() ? std::nullopt
                                    : clean(quantity, found->second.numeric, found->second.graphical == 0);
    }
    /// The modulus of a vector, by its index in Protocol::vectors.
    std::optional<double> of_vector(int vector) const {
        const auto index = static_cast<std::size_t>(vector);
        if (index >= solution_.numeric_moduli.size()) return std::nullopt;
        const DrawnVector& drawn = solution_.protocol.vectors[index];
        return clean(drawn.quantity, solution_.numeric_moduli[index], drawn.vanishes);
    }
    /// The modulus of a force.
    std::optional<double> force_of(const FreeBody& body, const AppliedForce& applied) const {
        return clean(quantity_of(body, applied), applied.numeric_force, applied.force.is_zero());
    }
    std::optional<double> couple_of(const FreeBody& body, const AppliedForce& applied) const {
        Quantity quantity = quantity_of(body, applied);
        if (applied.is_reaction() || applied.kind == Quantity::Kind::inertia) quantity.kind = Quantity::Kind::couple;
        return clean(quantity, applied.numeric_couple, applied.couple.is_zero());
    }

private:
    /// `vanishes`: zero by the construction. With rounded data, a number of the check within their precision is then 0
    /// too.
    std::optional<double> clean(const Quantity& quantity, std::optional<double> value, bool vanishes) const {
        if (!value || magnitudes_.is_noise(quantity, *value)) return value ? 0 : value;
        const bool within = vanishes && solution_.pose.is_rounded() &&
                            std::abs(*value) <= nearest::cbrt(solution_.pose.rounding()) * magnitudes_.of(quantity);
        return within ? 0 : value;
    }

    const Solution& solution_;
    Magnitudes magnitudes_;
    std::map<Quantity, CheckRow> rows_;
};

}  // namespace kinegraph::render
