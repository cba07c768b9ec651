// Figure needs: what figures turn out to take once they are lettered, and what they refuse. Owns how a room that was
// thought to do grows with what the drawing taught; draws nothing and plans nothing.
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

/// A figure as drawn, and the room it was drawn for (from the band's upper left corner).
struct DrawnFigure {
    std::size_t wanted = 0;
    Box room;
    Spot own{};  ///< of it, what is not for equations in a corner
    int number = 0;
    double promised = 0;         ///< the scale that the room was planned for
    double caption = 0;          ///< mm that it takes
    bool has_own_scale = false;  ///< a force polygon that is finer than the scale of all
    bool waits = false;          ///< for all others: it fills its room, whatever that is
    Figure figure;
    Spot size{};                 ///< of the figure alone
    double wide_enough = 0;      ///< a room so wide would do, for its caption has fewer lines there; 0: none
    std::vector<Mark> beside{};  ///< equations in its corner
    double height() const { return caption + figure.box.height(); }
    bool is_refused() const { return figure.scale == any_scale; }  ///< the room, by the figure
    bool is_too_wide() const;                                      ///< for its room
    bool is_too_high() const;                                      ///< …, with its caption
};

class FigureNeeds {
public:
    explicit FigureNeeds(WantedFigures& wanted) : wanted_(wanted) {}

    void begin_round() {
        refused_.clear();
        spared_ = 0;
    }
    /// Whether a figure may refuse a room: a few times, then it is taken as it comes.
    bool may_refuse(const Wanted& wanted);
    /// What a figure takes at the scale that it was drawn at is known from then on.
    void learn_from(const DrawnFigure& drawn);
    /// Whether it is coarser than its room was to let it be, and is given more room for that: a few times.
    bool asks_for_more_room(const DrawnFigure& drawn);
    /// Whether it takes more than its room. It is known now what its letters take; where it refused, that they take
    /// more.
    bool has_outgrown(const DrawnFigure& drawn);
    /// Whether it missed the scale that the file asks for.
    bool misses_its_scale(const DrawnFigure& drawn) const;
    /// … and is given more room for that: once.
    bool gives_room_for_its_scale(const DrawnFigure& drawn);
    /// Where the figures that refused their rooms in the last round want pages more for their letters, they take the
    /// rooms that they had, as they come, but for those that may refuse without a page more, the weightiest first.
    /// `has_room`: whether all has room now.
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
    /// Whether a figure came coarser than its room was planned for and is planned for more room, or, where that did not
    /// help, no larger from now on: what it does not use of its room is for others.
    bool is_planned_as_it_came(const DrawnFigure& drawn);
    /// Whether letters take so much less than was set aside for them that another plan may do with less paper; a few
    /// times.
    bool take_less_than_thought();

private:
    bool is_coarser_than_promised(const DrawnFigure& drawn) const;
    void fills_a_larger_room(const DrawnFigure& drawn, bool too_wide, bool too_high);
    void wants_more_than_its_room(const DrawnFigure& drawn);

    /// Of a room in the last round, by a figure: its rim there, and how often it is said to have refused where it takes
    /// it.
    struct Refusal {
        std::size_t wanted = 0;
        double rim_x = 0, rim_y = 0;
        int refusals = 0;
    };
    /// … or again not.
    void take_back(Refusal& refusal);
    /// A figure that is planned for more room at a scale at which it did not come.
    struct Tried {
        std::size_t wanted = 0;
        double promised = 0, came = 0;
    };
    void give_up(const Tried& tried);
    WantedFigures& wanted_;
    std::vector<Refusal> refused_;
    /// So often it refused; of a force polygon at the scale that all share now, for at another it has other rooms.
    int& refusals_of(const Wanted& wanted);
    std::map<std::pair<std::string, double>, int> refusals_;  // by the figure's name and that scale
    std::set<std::string> roomier_;                           // figures that got more room for the scale asked for
    std::set<std::string> said_to_take_more_;
    std::optional<Tried> tried_;  // the last of them
    double spared_ = 0;           // mm, of a room as it was planned in the last round
    int times_less_ = 0;          // plans anew because letters took less than was thought
};

}  // namespace kinegraph::render
