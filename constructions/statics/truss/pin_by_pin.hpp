// The polygon of forces at one pin after another, each with at most two unknowns (Cremona, Le figure reciproche nella
// statica grafica, 1872).
#pragma once

#include <optional>
#include <vector>

#include "constructions/statics/truss/known_truss.hpp"

namespace kinegraph::statics {

class PinByPin {
public:
    explicit PinByPin(KnownTruss& truss)
        : truss_(truss), board_(truss.board()), resolved_(truss.structure().pins.size(), false) {}

    /// Finds the unknown forces at a pin by its polygon; false if the polygon does not determine them.
    bool resolve(int pin);
    /// Whether at a pin with one unknown the known forces had another line: the given forces are not in equilibrium.
    bool is_contradictory() const { return contradictory_; }
    /// Checks the pins that had no unknown left: their polygons must close, and a sentence names them. False if one
    /// does not close.
    bool check_rest();

private:
    /// A bar or a support that is not known, with its direction at a pin.
    struct Unknown {
        int bar = -1, support = -1;
        std::optional<DirectionHandle> along;
    };
    std::vector<Unknown> unknown_at(int pin) const;
    std::optional<Force> known_at(int pin);
    bool close(int pin, const std::vector<Unknown>& unknown);
    void say(int pin, const std::vector<Unknown>& unknown);
    void settle(int pin, const Unknown& unknown, const std::optional<Force>& force);

    KnownTruss& truss_;
    Board& board_;
    std::vector<bool> resolved_;  ///< by pin
    bool contradictory_ = false;
};

}  // namespace kinegraph::statics
