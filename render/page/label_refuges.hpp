// Label refuges: where a label goes that found no place. Owns the maps of what labels and their leaders take, and finds
// the nearest room that is free, with a leader; does not know which label had better go.
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
    /// Beside labels that all stand somewhere, be it for now. What is given must outlive it.
    Refuges(const LabelSetting& setting, const std::vector<Lettered>& letters, const std::vector<Candidate>& chosen);

    /// What a label takes where it stands is no longer free …
    void take(std::size_t label);
    /// … and is free again, while another place is looked for.
    void give_back(std::size_t label);
    /// The nearest free place in the figure or at its edge, further out where the room is not strict.
    std::optional<Candidate> nearest(std::size_t label);

private:
    std::optional<Candidate> nearest(std::size_t label, const Box& middles);
    void look_at(std::size_t label, Spot centre, double step, std::optional<Candidate>& found);
    double crossings_of(const Candidate& candidate, double enough) const;

    const LabelSetting& setting_;
    const std::vector<Lettered>& letters_;
    const std::vector<Candidate>& chosen_;
    InkMap taken_, threads_;  // what labels take, and their leaders
    int looks_left_;
};

}  // namespace kinegraph::render::lettering
