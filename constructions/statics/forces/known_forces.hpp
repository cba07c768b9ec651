// What is known of the forces in a run, bond by bond: which are unknown, in which form, and which bodies can be solved
// next.
#pragma once

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "constructions/statics/force_model.hpp"

namespace kinegraph::statics {

class KnownForces {
public:
    /// Unknown bonds by the form of what is unknown.
    struct Unknowns {
        std::vector<int> pins, guides, fixed, couples, clamps;
    };

    /// `adrift`: members that are skipped. `wholes`: structures on the frame that are first taken as one free body.
    KnownForces(ForceModel& model, std::set<MemberIndex> adrift, std::vector<Group> wholes)
        : model_(model), adrift_(std::move(adrift)), wholes_(std::move(wholes)) {}

    const std::vector<Group>& wholes() const { return wholes_; }
    Run fresh() const;
    /// The form of what is unknown of a bond: that of its kind, a line once its line is known.
    Bond::Kind shape(int b, const Run& run) const;
    std::vector<int> unknown_of(const Group& group, const Run& run) const;
    Unknowns sorted(const std::vector<int>& unknown, const Run& run) const;
    bool all_known(const Run& run) const;
    std::vector<Group> groups(const Run& run) const;
    bool is_whole(const Group& group) const {
        return std::find(wholes_.begin(), wholes_.end(), group) != wholes_.end();
    }
    void note(const Group& group, Run& run) const;
    /// A place on a bond's line, or the bond's own place.
    PlaceOnDrawing place_of(int b, const Run& run) const;

private:
    ForceModel& model_;
    std::set<MemberIndex> adrift_;
    std::vector<Group> wholes_;
};

}  // namespace kinegraph::statics
