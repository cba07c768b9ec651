// Label places: the places that one label may take. Owns which are proposed and in which order they are asked for, and what each
// costs as far as its own position goes; does not know where the other labels stand, only what they name.
//
// Method: point-feature labelling by candidate places on rings about the anchor (after Imhof's rules), or beside the line that is
// named. Most places are never asked for, so that what is dear to find about one is found when it is its turn.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "render/page/figure.hpp"
#include "render/page/label_boxes.hpp"
#include "render/page/label_ground.hpp"

namespace kinegraph::render::lettering {

/// What all labels of a figure are placed in.
struct LabelSetting {
    const std::vector<LabelRequest>& requests;
    const Ground& ground;
    Box box;               ///< the figure's
    Spot spare{1e9, 1e9};  ///< how far a label may stand out of it on each side
    bool strict = false;   ///< rather than leave the room, a label finds no place

    /// How far a box stands out of the figure's, to the left or right and above or below.
    Spot outside(const Box& extent) const {
        return {std::max({0.0, box.min.x - extent.min.x, extent.max.x - box.max.x}),
                std::max({0.0, box.min.y - extent.min.y, extent.max.y - box.max.y})};
    }
};

/// A place that a label may take.
struct Candidate {
    InkBox box;
    double price = 0;      ///< what does not depend on other labels
    bool free = false;     ///< covers no ink
    bool covered = false;  ///< … or is out of the room
    bool leader = false;
    Spot leader_from, leader_to;
    Box extent = nowhere;  ///< of box and leader and what another label must keep off it
    InkBox thread;         ///< the leader's

    /// Ties it to what the request names.
    void add_leader(const LabelRequest& request);
    /// Once box and leader are as they stay; the upright box round the former may be known.
    void close_extent(const Box& of_box);
    void close_extent() { close_extent(extent_of(box)); }
};

class LabelPlaces {
public:
    /// The most wanted places of the request with that index, whose box has these half extents. The setting must outlive them.
    LabelPlaces(const LabelSetting& setting, std::size_t label, Spot half);

    const Candidate& operator[](std::size_t place) const { return all_[place]; }
    /// How many of those proposed so far cover nothing and stay in the room.
    int uncovered() const;
    /// What all proposed so far take.
    const Box& span() const { return span_; }

    /// Proposes less wanted places as a further batch. False: there are none, or none that could cost less than `least`.
    bool propose_more(double least);
    std::size_t batches() const { return free_.size(); }
    /// Shows look() the places of a batch that cover no ink, or those that do, the cheapest first, as long as they cost less than
    /// `least`; look may lower that.
    template <class Look>
    void look_through(std::size_t batch, bool free, const double& least, Look look) {
        Queue& queue = free ? free_[batch] : covering_[batch];
        rank(queue, free);
        for (std::size_t rank = 0; queue.least(rank) < least; ++rank) look(next_of(queue, rank));
    }

private:
    /// A place by its price; until it is priced, by the least that it can cost.
    struct Ranked {
        double price;
        std::size_t place;
        bool priced;
        bool operator>(const Ranked& other) const { return price > other.price || (price == other.price && place > other.place); }
    };
    /// Places that were proposed together, and are asked for in the order of price: most of them never are.
    struct Queue {
        std::size_t first, end;         // among all
        bool is_ranked = false;         // only once it is asked for
        std::vector<Ranked> met{};      // in their order
        std::vector<Ranked> waiting{};  // a heap, the cheapest on top
        /// What the next place costs at least of which `rank` have been asked for; infinity: there is none.
        double least(std::size_t rank) const {
            if (rank < met.size()) return met[rank].price;
            return waiting.empty() ? std::numeric_limits<double>::infinity() : waiting.front().price;
        }
    };
    bool is_beside_line() const;

    void propose_beside_line(Spot toward);
    void propose_around(double penalty, double half_line, bool far);
    void stand_around(Spot u, double extra, bool leader, Candidate& candidate) const;
    void finish(Candidate& candidate);
    void keep_as_batch();

    void rank(Queue& queue, bool free) const;
    std::size_t next_of(Queue& queue, std::size_t rank);
    void look_about(Candidate& candidate) const;
    double near_other_points(const Candidate& candidate) const;
    double near_other_lines(const Candidate& candidate) const;

    const LabelSetting& setting_;
    const LabelRequest& request_;
    std::size_t label_;  // its index
    Spot half_;          // of its box
    std::vector<Candidate> all_;
    std::vector<Queue> free_, covering_;  // those that cover ink: dearer than most, and the dearest to price
    int stage_ = 0;                       // how many less wanted batches have been thought of
    Box span_ = nowhere;
};

}  // namespace kinegraph::render::lettering
