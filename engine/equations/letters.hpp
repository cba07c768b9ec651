// Assigns letters: lengths and angles in pairs, each direction by the letters of the bodies it rotates with, radii of
// rolling pairs. No letter is used twice.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "engine/equations/graph.hpp"

namespace kinegraph::vector_loops {

class Letters {
public:
    struct Pair {
        std::string length, angle, sub;
    };

    Letters(const AsDrawn& drawn, VectorGraph& graph, Equations& found) : drawn_(drawn), graph_(graph), found_(found) {}

    Pair next_pair();
    LetterIndex add(Letter letter);
    std::optional<Side> side_of(BodyIndex body, const Vector& from, const Vector& to);
    void give_letters(Edge& edge);
    void name_what_is_left();
    LetterIndex radius(const Exact& reach, BodyIndex body);
    /// Distinguishes two coordinates of one name by their bodies.
    void settle_names();

private:
    LetterIndex add_length(const Pair& pair, const Exact& length, Letter::Role role = Letter::Role::given);
    LetterIndex add_angle(const Pair& pair, const Vector& direction, Letter::Role role = Letter::Role::given);
    /// 0 … 3 where it is a multiple of a quarter turn.
    std::optional<int> quarters_of(const Vector& direction) const;
    /// A direction that rotates with a class, in its letters. A class without a datum takes this direction as datum.
    Angle angle_of(int index, const Vector& direction, const Pair& pair);
    void set_datum(int index, const Vector& direction, const Pair& pair);
    /// From a joint of the class to the farthest of its points.
    Vector some_direction(int index) const;
    void give_link_letters(Edge& edge);
    /// Chooses the sense that makes the slide positive as drawn, because its length is what is written.
    void give_guide_letters(Edge& edge);
    void name(LetterIndex index, const char* kind, const Edge& edge);

    const AsDrawn& drawn_;
    VectorGraph& graph_;
    Equations& found_;
    std::vector<Side> body_sides_;
    std::vector<std::tuple<BodyIndex, Exact, LetterIndex>> radii_;
    std::size_t pairs_ = 0;
};

}  // namespace kinegraph::vector_loops
