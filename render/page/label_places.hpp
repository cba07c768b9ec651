// Label places: the places that one label may take. Owns which are proposed and in which order they are asked for, and
// what each costs as far as its own position goes; does not know where the other labels stand, only what they name.
//
// Method: point-feature labelling by candidate places on rings about the anchor (after Imhof's rules), or beside the
// line that is named. Most places are never asked for: each stands somewhere, and what is dear to find about it is
// found, when it is its turn.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
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
    Candidate() = default;
    explicit Candidate(double least) : price(least) {}

    InkBox box;
    double price = 0;      ///< what does not depend on other labels
    bool free = false;     ///< covers no ink
    bool covered = false;  ///< … or is out of the room
    bool ringed = false;   ///< a number in a circle, which no letters beside it run on from
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

/// A place before it is one: where about its anchor or line, and the least that it costs there.
struct Seed {
    double bound;
    double extra;         ///< mm further than the nearest
    double at = 0;        ///< beside a line: how far along it; of half of it
    Spot along{};         ///< about an anchor: the direction
    double side = 1;      ///< beside a line: of which
    bool leader = false;  ///< it is tied to what it names
};

class LabelPlaces {
public:
    /// The near places of the request with that index, whose box has these half extents. The setting must outlive them.
    LabelPlaces(const LabelSetting& setting, std::size_t label, Spot half);

    const Candidate& operator[](std::size_t place) const { return all_[place]; }
    /// How many of the nearer ones cover nothing and stay in the room.
    int uncovered() const { return uncovered_; }
    /// What all proposed so far may take.
    const Box& span() const { return span_; }

    /// Proposes less wanted places as a further batch. False: there are none, or none that could cost less than
    /// `least`.
    bool propose_more(double least);
    std::size_t batches() const { return batches_.size(); }
    /// Shows look() the places of a batch that cover no ink, or those that do, the cheapest first, as long as they cost
    /// less than `least`; look may lower that.
    template <class Look>
    void look_through(std::size_t batch, bool free, const double& least, Look look) {
        Batch& of = batches_[batch];
        Queue& queue = free ? of.free : of.covering;
        for (std::size_t rank = 0; is_met(of, queue, rank, least); ++rank) look(queue.met[rank].place);
    }

private:
    /// A place by its price; until it is priced, by the least that it can cost.
    struct Ranked {
        double price;
        std::size_t place;
        bool priced;
        bool operator>(const Ranked& other) const {
            return price > other.price || (price == other.price && place > other.place);
        }
    };
    /// Places that are asked for in the order of price: most of them never are.
    struct Queue {
        std::vector<Ranked> met{};      // in their order
        std::vector<Ranked> waiting{};  // a heap, the cheapest on top
        void wait(Ranked place);
    };
    /// Places that were proposed together. Most never stand anywhere: they become places in the order of the least they
    /// can cost.
    struct Batch {
        const std::vector<Seed>* seeds;
        double penalty;            // of all of them
        bool beside;               // the line, else about the anchor
        double farthest;           // of the anchor, mm; seeds that are farther are left out
        std::size_t next = 0;      // seed
        Queue free{}, covering{};  // those that cover ink: dearer than most, and the dearest to price
        bool has_seeds() const { return next < seeds->size(); }
        double bound() const { return penalty + (*seeds)[next].bound; }
    };
    bool is_beside_line() const;

    void propose(const std::vector<Seed>& seeds, double penalty, bool beside, double farthest);
    /// Whether a place of a queue that costs less than `least` is met after so many others.
    bool is_met(Batch& batch, Queue& queue, std::size_t rank, double least);
    void place_next(Batch& batch);
    void stand_beside(const Seed& seed, Candidate& candidate) const;
    void stand_around(const Seed& seed, Candidate& candidate) const;
    void finish(Candidate& candidate) const;

    void look_about(Candidate& candidate) const;
    bool is_on_foreign_tint(const Candidate& candidate) const;
    double near_other_points(const Candidate& candidate) const;
    double near_other_lines(const Candidate& candidate) const;

    /// Beside a line: how it runs, how the label is turned there, and which side is the better one.
    struct Beside {
        Spot along, across, axis;
        double slide, reach_across;
        std::array<double, 2> price;  // of the sides −1 and 1
    };
    Beside beside_of(Spot toward) const;

    const LabelSetting& setting_;
    const LabelRequest& request_;
    std::size_t label_;  // its index
    Spot half_;          // of its box
    std::optional<Beside> beside_;
    std::vector<Candidate> all_;
    std::vector<Batch> batches_;
    int uncovered_ = 0;
    int stage_ = 0;  // how many batches have been thought of
    Box span_ = nowhere;
};

}  // namespace kinegraph::render::lettering
