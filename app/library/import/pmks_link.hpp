// What a link of PMKS+ holds: its sections as values, before anything is made of them. Knows no mechanism file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "lang/words.hpp"

namespace kinegraph::app {

/// Coordinates and other decimals: whole thousandths.
using Thousandths = std::int64_t;

struct PmksJoint {
    bool slides = false, is_input = false, is_ground = false, is_welded = false;
    std::string id, name;
    Thousandths x = 0, y = 0;
    Thousandths angle = 0;             ///< of a slot on the ground, rad
    std::string carrier;               ///< id of the link that carries the slot; empty: the ground does
    std::string slot_a, slot_b;        ///< ids of the joints that give the line of a carried slot
    std::optional<Thousandths> speed;  ///< of this input alone, signed: rpm, or units of length per second
};

struct PmksLink {
    bool is_piston = false;
    bool is_part = false;  ///< welded into another link, which stands for it
    std::string id, name;
    Thousandths mass = 0, inertia = 0;
    Thousandths centre_x = 0, centre_y = 0;
    std::vector<std::string> joints;  ///< ids
    std::vector<std::string> parts;   ///< ids of the links welded into it
};

struct PmksForce {
    bool turns_with_link = false, faces_out = true;
    std::string id, name, link;
    Thousandths from_x = 0, from_y = 0, to_x = 0, to_y = 0;
    Thousandths magnitude = 0;
};

/// Trailing entries of a link, by kind.
struct PmksLeftOut {
    int locks = 0, anchors = 0, poses = 0, colours = 0, unknown = 0;
};

struct PmksDrawing {
    enum class Length { inch, centimetre, metre };

    bool turns_clockwise = false, has_gravity = false;
    Length length = Length::centimetre;
    bool forces_in_pounds = false;
    std::int64_t input_speed = 0;             ///< rpm
    std::optional<Thousandths> slider_speed;  ///< units of length per second
    std::vector<PmksJoint> joints;            ///< with ids that differ
    std::vector<PmksLink> links;              ///< with ids that differ; their joints and parts exist
    std::vector<PmksForce> forces;            ///< with links that exist
    PmksLeftOut left_out;
};

/// Reads a link, what stands behind its question mark, or a saved file, which holds one of the two. Error: what cannot
/// be read, with the remedy.
tl::expected<PmksDrawing, Words> read_pmks(std::string_view text);

}  // namespace kinegraph::app
