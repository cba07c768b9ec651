// Driver clock: the rates of a course's driver in a row, and its time.
#pragma once

#include "engine/board/program.hpp"
#include "engine/mechanism/law_curve.hpp"
#include "engine/motion/positions.hpp"

namespace kinegraph {

/// Rates are the file's at every position, or those of the driver's law.
class DriverClock {
public:
    /// Keeps a reference to the mechanism.
    DriverClock(const Mechanism& mechanism, const Course& course);

    const Law* law() const { return law_; }  ///< null: none
    /// Whether a row has a time: the driver has a law, or its rate is constant and not zero, and drivers that go along
    /// have rates in proportion.
    bool has_time() const { return law_ != nullptr || rate_ != 0; }
    /// Goes to a row, a coordinate or the time of a law since the drawn position. Returns its coordinate.
    double go_to(double at);
    double time(double coordinate) const { return law_ != nullptr ? time_ : coordinate / rate_; }
    /// Sets the rates of the law in a mechanism moved to this row.
    void put_rates(Mechanism& moved) const;

    /// Whether a given is a rate of the law, and its value in this row.
    bool changes(const Given& given) const { return is_rate(given) && at_index(given.index) == driver_ && law_; }
    static bool is_rate(const Given& given) {
        return given.kind == Given::Kind::driver_velocity || given.kind == Given::Kind::driver_acceleration;
    }
    double value(const Given& given) const {
        return given.kind == Given::Kind::driver_velocity ? state_.first : state_.second;
    }

private:
    std::size_t driver_;
    const Law* law_;
    LawCurve curve_;                         ///< of the law: its pieces are read once, not in every row
    std::pair<double, double> drawn_{0, 0};  ///< time and coordinate of the law in the drawn position
    LawState state_;                         ///< of the law, here
    double time_ = 0;                        ///< since the drawn position, by the law
    double rate_ = 0;                        ///< zero: no time
};

}  // namespace kinegraph
