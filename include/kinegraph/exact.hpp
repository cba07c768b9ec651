/// \file
/// Exact numbers as text.
#pragma once

#include <string>

namespace kinegraph {

/// A rational number in lowest terms.
struct ExactNumber {
    std::string numerator;    ///< decimal digits, with a minus sign where the number is negative
    std::string denominator;  ///< decimal digits, positive; "1" of a whole number
    double value = 0;         ///< the nearest double

    /// "3/4", or "3" of a whole number.
    std::string text() const { return denominator == "1" ? numerator : numerator + "/" + denominator; }
};

}  // namespace kinegraph
