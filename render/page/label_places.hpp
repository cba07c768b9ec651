// Label places: the candidate places of one label, their order and the part of their price that does not depend on
// where other labels stand.
//
// Method: point-feature labelling by candidates on rings about the anchor (after Imhof's rules), or beside the named
// line. Most candidates are never examined, so their prices are evaluated lazily.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "render/page/figure.hpp"
#include "render/page/label_bodies.hpp"
#include "render/page/label_boxes.hpp"
#include "render/page/label_ground.hpp"
#include "render/page/label_lines.hpp"

namespace kinegraph::render::lettering {

/// What all labels of a figure share.
struct LabelSetting {
    const std::vector<LabelRequest>& requests;
    const Ground& ground;
    LeaderEnds ends;
    Bodies bodies;
    Box box;               ///< of the figure
    Spot spare{1e9, 1e9};  ///< how far a label may extend beyond it on each side, mm
    bool strict = false;   ///< a label finds no place rather than leave the room

    /// How far a box extends beyond the figure's, horizontally and vertically.
    Spot outside(const Box& extent) const {
        return {std::max({0.0, box.min.x - extent.min.x, extent.max.x - box.max.x}),
                std::max({0.0, box.min.y - extent.min.y, extent.max.y - box.max.y})};
    }
};

/// A candidate place of a label.
struct Candidate {
    Candidate() = default;
    explicit Candidate(double least) : price(least) {}

    InkBox box;
    double price = 0;      ///< the part independent of other labels
    bool free = false;     ///< covers no ink
    bool covered = false;  ///< covers ink, or leaves the room
    bool ringed = false;   ///< a number in a circle; neighbouring letters do not seem to continue it
    bool leader = false;
    Spot leader_from, leader_to;
    Box extent = nowhere;  ///< of box and leader, with the clearance that other labels must keep
    InkBox thread;         ///< of the leader

    /// Adds a leader to what the request with that index names.
    void add_leader(const LabelSetting& setting, std::size_t label);
    /// Computes `extent`; call when box and leader are final. `of_box`: the bounding box of the former, if already
    /// known.
    void close_extent(const Box& of_box);
    void close_extent() { close_extent(extent_of(box)); }
};

/// A candidate before evaluation: its position about the anchor or line, and a lower bound of its price.
struct Seed {
    double bound;
    double extra;         ///< distance beyond the nearest place, mm
    double at = 0;        ///< beside a line: position along it, as a fraction of its half length
    Spot along{};         ///< about an anchor: the direction
    double side = 1;      ///< beside a line: on which side
    bool leader = false;  ///< with a leader
};

class LabelPlaces {
public:
    /// The nearest places of the request with index `label`, whose box has these half extents. The setting must outlive
    /// this object.
    LabelPlaces(const LabelSetting& setting, std::size_t label, Spot half);

    const Candidate& operator[](std::size_t place) const { return all_[place]; }
    /// How many of the nearest places cover nothing and stay in the room.
    int uncovered() const { return uncovered_; }
    /// Bounding box of all places proposed so far.
    const Box& span() const { return span_; }

    /// Proposes less desirable places as a further batch. False if there are none, or none can cost less than `least`.
    bool propose_more(double least);
    std::size_t batches() const { return batches_.size(); }
    /// Calls look() with the places of a batch that cover no ink, or with those that do, in order of price, as long as
    /// they cost less than `least`; look() may lower `least`.
    template <class Look>
    void look_through(std::size_t batch, bool free, const double& least, Look look) {
        Batch& of = batches_[batch];
        Queue& queue = free ? of.free : of.covering;
        for (std::size_t rank = 0; is_met(of, queue, rank, least); ++rank) look(queue.met[rank].place);
    }

private:
    /// A place with its price; before evaluation, with the lower bound of its price.
    struct Ranked {
        double price;
        std::size_t place;
        bool priced;
        bool operator>(const Ranked& other) const {
            return price > other.price || (price == other.price && place > other.place);
        }
    };
    /// Lazy priority queue of places: most are never examined.
    struct Queue {
        std::vector<Ranked> met{};      // examined so far, in order of price
        std::vector<Ranked> waiting{};  // a heap with the cheapest on top
        void wait(Ranked place);
    };
    /// Places that were proposed together. Seeds become places in the order of their lower bounds; most never do.
    struct Batch {
        const std::vector<Seed>* seeds;
        double penalty;            // added to every price of the batch
        bool beside;               // beside the line, else about the anchor
        double farthest;           // from the anchor, mm; more distant seeds are skipped
        std::size_t next = 0;      // next seed
        Queue free{}, covering{};  // places that cover ink are dearer, and slower to evaluate
        bool has_seeds() const { return next < seeds->size(); }
        double bound() const { return penalty + (*seeds)[next].bound; }
    };
    bool is_beside_line() const;

    void propose(const std::vector<Seed>& seeds, double penalty, bool beside, double farthest);
    /// Whether the queue has a place of that rank that costs less than `least`; evaluates places as needed.
    bool is_met(Batch& batch, Queue& queue, std::size_t rank, double least);
    void place_next(Batch& batch);
    void stand_beside(const Seed& seed, Candidate& candidate) const;
    void stand_around(const Seed& seed, Candidate& candidate) const;
    void finish(Candidate& candidate) const;

    void look_about(Candidate& candidate) const;
    bool is_on_foreign_tint(const Candidate& candidate) const;
    double near_other_points(const Candidate& candidate) const;
    double near_other_lines(const Candidate& candidate) const;

    /// For places beside a line: its direction, the rotation of the label and the better side.
    struct Beside {
        Spot along, across, axis;
        double slide, reach_across;
        std::array<double, 2> price;  // for the sides −1 and 1
    };
    Beside beside_of(Spot toward) const;

    const LabelSetting& setting_;
    const LabelRequest& request_;
    std::size_t label_;  // index of the request
    Spot half_;          // half extents of its box
    std::optional<Beside> beside_;
    std::vector<Candidate> all_;
    std::vector<Batch> batches_;
    int uncovered_ = 0;
    int stage_ = 0;  // number of batches proposed so far
    Box span_ = nowhere;
};

}  // namespace kinegraph::render::lettering
