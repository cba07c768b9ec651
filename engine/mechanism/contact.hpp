// Materials of the bodies at a contact: at joints of a mechanism, where the file gives them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/mechanism/mechanism.hpp"

namespace kinegraph {

/// The material of one of two elastic bodies that are pressed together.
struct ElasticBody {
    BodyIndex body = none;
    Exact young;  ///< Pa
    Exact poisson;
    std::optional<Exact> depth;  ///< line contact of a flat or concave body: depth of the datum of its approach, m
    std::string where;
};
/// Materials and length of the contact at a joint. The load is the normal force found there; the radii are those of the
/// profiles or of the teeth in the drawn position.
struct LoadedContact {
    JointIndex joint = none;
    std::array<ElasticBody, 2> bodies;  ///< as the joint's
    Exact length;                       ///< m
    std::string where;
};
using LoadedContacts = std::vector<LoadedContact>;

}  // namespace kinegraph
