// Fallback places: where a label goes that found no place near its object. Owns maps of the area that labels and
// leaders occupy, and finds the nearest free place, connected by a leader. Does not choose which label to move.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "render/page/ink_map.hpp"
#include "render/page/label_boxes.hpp"
#include "render/page/label_places.hpp"

namespace kinegraph::render::lettering {

class Refuges {
public:
    /// Every label already has a provisional place. The arguments must outlive this object.
    Refuges(const LabelSetting& setting, const std::vector<Lettered>& letters, const std::vector<Candidate>& chosen);

    /// Marks the place of a label as occupied.
    void take(std::size_t label);
    /// Marks it as free, while another place is searched for that label.
    void give_back(std::size_t label);
    /// The nearest free place in the figure or at its edge; beyond the edge as well unless the room is strict.
    std::optional<Candidate> nearest(std::size_t label);

private:
    std::optional<Candidate> nearest(std::size_t label, const Box& middles);
    using WayOut = std::optional<double> (InkMap::*)(const InkBox&) const;
    double look_at(std::size_t label, Spot centre, double step, WayOut way_out, std::optional<Candidate>& found);
    /// Whether the leader of a label would come too close to another label.
    bool leads_over_another(std::size_t label, const InkBox& thread) const;
    double crossings_of(std::size_t label, const Candidate& candidate, double enough) const;

    const LabelSetting& setting_;
    const std::vector<Lettered>& letters_;
    const std::vector<Candidate>& chosen_;
    InkMap taken_, threads_;  // areas occupied by labels and by their leaders
    int looks_left_;
};

}  // namespace kinegraph::render::lettering
