// The polygon of forces at one pin after another, each with two unknowns at most (Cremona, Le figure reciproche nella
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

    /// Finds the unknown forces at a pin where its polygon gives them; false where it does not.
    bool resolve(int pin);
    /// At a pin with one unknown the known forces had another line: what is given is not in equilibrium.
    bool is_contradictory() const { return contradictory_; }
    /// At the end: pins of which all was known when their turn came must close, and a sentence names them. False where
    /// one does not.
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
