// Checked numbers: what the check says, by the names of its rows and by the vectors drawn, SI units. Looks up and computes
// nothing but the modulus of two components.
#pragma once

#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "engine/solution.hpp"

namespace kinegraph::render {

class CheckedNumbers {
public:
    explicit CheckedNumbers(const Solution& solution) : moduli_(solution.numeric_moduli) {
        for (const CheckRow& row : solution.checks) rows_.emplace(row.quantity, row.numeric);
    }

    std::optional<double> scalar(const std::string& quantity) const {
        const auto found = rows_.find(quantity);
        if (found == rows_.end()) return std::nullopt;
        return found->second;
    }
    /// Of a quantity with rows for its components.
    std::optional<double> modulus(const std::string& quantity) const {
        const auto x = scalar(quantity + " x"), y = scalar(quantity + " y");
        if (!x || !y) return std::nullopt;
        return std::hypot(*x, *y);
    }
    /// Of Protocol::vectors.
    std::optional<double> modulus(int vector) const {
        const auto index = static_cast<std::size_t>(vector);
        return index < moduli_.size() ? moduli_[index] : std::nullopt;
    }

private:
    const std::vector<std::optional<double>>& moduli_;
    std::map<std::string, double> rows_;
};

}  // namespace kinegraph::render
