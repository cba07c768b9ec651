// LawCurve: a law evaluated at many times, in doubles.
#pragma once

#include <vector>

#include "engine/mechanism/law.hpp"

namespace kinegraph {

/// A law's pieces in doubles, for values at many times: each takes the logarithm of the number of pieces.
class LawCurve {
public:
    LawCurve() = default;
    explicit LawCurve(const Law& law);
    double length() const { return length_; }
    /// As Law::at.
    LawState at(double t) const;

private:
    struct Piece {
        LawForm form;
        double over, rise;
        double start, end;  ///< of the piece
        double way;         ///< rise of all pieces before
    };
    std::vector<Piece> pieces_;
    double length_ = 0, way_ = 0;
};

}  // namespace kinegraph
