// The catalogue of pairs: besides those of the plane, the lower pairs in space and the binary hinges equivalent to a
// multiple hinge. Data, from which `kinegraph pairs` and docs/pairs.md are printed; the texts are elsewhere.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "engine/mechanism/pair.hpp"
#include "lang/keys/sheet.hpp"

namespace kinegraph {

/// A lower pair in space: surfaces in contact (Reuleaux). Axis z; the planar pair's normal is z.
struct SpacePair {
    std::string_view key;
    Key name;
    int freedoms;
    struct Components {
        std::array<std::string_view, 5> free{};  ///< of each other; those behind the last one are empty
        std::string_view tied = {};              ///< the equation between two more; empty: there is none

        /// "F_x F_y, p F_z = −M_z".
        std::string in_words() const {
            std::string words;
            for (const std::string_view each : free)
                if (!each.empty()) words += (words.empty() ? "" : " ") + std::string(each);
            return words + (tied.empty() ? "" : ", ") + std::string(tied);
        }
    };
    Components motions;    ///< freedoms left: translations t_x …, rotations r_x …
    Components reactions;  ///< components it can transmit: forces F_x …, couples M_x …
    int reaction_count() const { return 6 - freedoms; }
};
inline constexpr std::array space_pairs{
    SpacePair{"revolute", lang::sheet::space_revolute, 1, {{"r_z"}}, {{"F_x", "F_y", "F_z", "M_x", "M_y"}}},
    SpacePair{"prismatic", lang::sheet::space_prismatic, 1, {{"t_z"}}, {{"F_x", "F_y", "M_x", "M_y", "M_z"}}},
    SpacePair{"helical",
              lang::sheet::space_helical,
              1,
              {{"r_z"}, "t_z = p r_z"},
              {{"F_x", "F_y", "M_x", "M_y"}, "p F_z = −M_z"}},
    SpacePair{"cylindrical", lang::sheet::space_cylindrical, 2, {{"t_z", "r_z"}}, {{"F_x", "F_y", "M_x", "M_y"}}},
    SpacePair{"planar", lang::sheet::space_planar, 3, {{"t_x", "t_y", "r_z"}}, {{"F_z", "M_x", "M_y"}}},
    SpacePair{"spherical", lang::sheet::space_spherical, 3, {{"r_x", "r_y", "r_z"}}, {{"F_x", "F_y", "F_z"}}},
};

/// A hinge of n bodies is equivalent to n − 1 binary ones: each scheme is a tree on the bodies, an edge a binary hinge.
struct BinaryScheme {
    std::vector<std::array<int, 2>> hinges;  ///< positions in the hinge's list of bodies, smaller first
};
/// All n^(n−2) of them (Cayley, 1889), by their Prüfer sequences in order, 2 ≤ n. The n stars, in which one body
/// carries all the hinges, are among them; for n = 3 there are no others.
std::vector<BinaryScheme> binary_schemes(int bodies);

}  // namespace kinegraph
