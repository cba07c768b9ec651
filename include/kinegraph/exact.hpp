/// \file
/// Exact numbers as text.
#pragma once

#include <string>

namespace kinegraph {

/// A rational number in lowest terms.
struct ExactNumber {
    std::string numerator;    ///< decimal digits, with a minus sign if the number is negative
    std::string denominator;  ///< decimal digits, positive; "1" for an integer
    double value = 0;         ///< the nearest double

    /// "3/4", or "3" for an integer.
    std::string text() const { return denominator == "1" ? numerator : numerator + "/" + denominator; }
};

}  // namespace kinegraph
