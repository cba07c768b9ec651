// Figure needs: the space that figures were found to need once they were lettered, and the rooms that they refused.
// Updates the estimates of WantedFigures from drawings; draws nothing and plans nothing.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "render/content/wanted_figures.hpp"
#include "render/page/figure.hpp"
#include "render/page/scale.hpp"

namespace kinegraph::render {

/// A figure as drawn, and the room it was drawn for (relative to the upper left corner of the band).
struct DrawnFigure {
    std::size_t wanted = 0;
    Box room;
    Spot own{};  ///< size of the room without the part for equations in a corner
    int number = 0;
    double promised = 0;         ///< the scale planned for the room
    double caption = 0;          ///< its height, mm
    bool has_own_scale = false;  ///< a force polygon at a finer scale than the common one
    bool waits = false;          ///< it fills its room, and is therefore drawn after all others
    Figure figure;
    Spot size{};             ///< of the figure alone
    double wide_enough = 0;  ///< a room of this width would be enough, since the caption has fewer lines there; 0: none
    std::vector<Mark> beside{};  ///< equations in a corner
    double height() const { return caption + figure.box.height(); }
    bool is_refused() const { return figure.scale == any_scale; }  ///< the figure refused the room
    bool is_too_wide() const;                                      ///< for its room
    bool is_too_high() const;                                      ///< for its room, with its caption
};

class FigureNeeds {
public:
    explicit FigureNeeds(WantedFigures& wanted) : wanted_(wanted) {}

    void begin_round() {
        refused_.clear();
        spared_ = 0;
    }
    /// Whether a figure may refuse a room. After a few refusals it must accept any.
    bool may_refuse(const Wanted& wanted);
    /// Records the space that a figure took at its scale.
    void learn_from(const DrawnFigure& drawn);
    /// Whether the figure is coarser than planned and gets more room for that. Limited to a few times for each figure.
    bool asks_for_more_room(const DrawnFigure& drawn);
    /// Whether the figure takes more than its room or refused it. Updates the estimate of the space for its labels.
    bool has_outgrown(const DrawnFigure& drawn);
    /// Whether the file gives a scale for the figure and it was drawn at another.
    bool misses_its_scale(const DrawnFigure& drawn) const;
    /// Adds space for that scale. True once for each figure, then false.
    bool gives_room_for_its_scale(const DrawnFigure& drawn);
    /// If honouring all refusals of the last round would add a page, the rooms are accepted as they are, except for
    /// figures (largest weight first) whose refusal adds none. `has_room`: makes a plan and returns whether it needs no
    /// more pages.
    template <class HasRoom>
    void take_back_until(HasRoom has_room) {
        if (const auto tried = std::exchange(tried_, std::nullopt)) {
            give_up(*tried);
            if (has_room()) return;
        }
        for (Refusal& refusal : refused_) take_back(refusal);
        bool settled = has_room();
        if (refused_.size() < 2) return;
        std::stable_sort(refused_.begin(), refused_.end(), [&](const Refusal& one, const Refusal& other) {
            return wanted_.list[one.wanted].weight > wanted_.list[other.wanted].weight;
        });
        for (Refusal& refusal : refused_) {
            take_back(refusal);
            settled = has_room();
            if (!settled) take_back(refusal);
        }
        if (!settled) has_room();
    }
    /// Whether the plan must change because a figure is coarser than planned. First the figure is planned with more
    /// room; if that does not help, its scale is limited to the drawn one, so that other figures get the space it
    /// leaves.
    bool is_planned_as_it_came(const DrawnFigure& drawn);
    /// Whether labels take so much less space than estimated that a new plan may need fewer pages. True at most a few
    /// times.
    bool take_less_than_thought();

private:
    bool is_coarser_than_promised(const DrawnFigure& drawn) const;
    void fills_a_larger_room(const DrawnFigure& drawn, bool too_wide, bool too_high);
    void wants_more_than_its_room(const DrawnFigure& drawn);

    /// A refusal in the last round: the figure, and the values that take_back() exchanges.
    struct Refusal {
        std::size_t wanted = 0;
        double rim_x = 0, rim_y = 0;
        int refusals = 0;
    };
    /// Undoes a refusal; a second call restores it.
    void take_back(Refusal& refusal);
    /// A figure that is planned with more room for a scale that it did not reach.
    struct Tried {
        std::size_t wanted = 0;
        double promised = 0, came = 0;
    };
    void give_up(const Tried& tried);
    WantedFigures& wanted_;
    std::vector<Refusal> refused_;
    /// Number of refusals. For a force polygon it is counted for each common scale, because its room depends on it.
    int& refusals_of(const Wanted& wanted);
    std::map<std::pair<std::string, double>, int> refusals_;  // by name of the figure and common scale of forces
    std::set<std::string> roomier_;                           // figures that got more room for the scale in the file
    std::set<std::string> said_to_take_more_;
    std::optional<Tried> tried_;  // the last one
    double spared_ = 0;           // mm; largest overestimate in the last round
    int times_less_ = 0;          // number of new plans because labels took less than estimated
};

}  // namespace kinegraph::render
