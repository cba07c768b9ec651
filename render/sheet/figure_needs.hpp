// Figure needs: what figures turn out to take once they are lettered, and what they refuse. Owns how a room that was thought to
// do grows with what the drawing taught; draws nothing and plans nothing.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "render/page/figure.hpp"
#include "render/page/scale.hpp"
#include "render/sheet/wanted_figures.hpp"

namespace kinegraph::render {

/// A figure as drawn, and the room it was drawn for (from the band's upper left corner).
struct DrawnFigure {
    std::size_t wanted = 0;
    Box room;
    Spot own{};  ///< of it, what is not for equations in a corner
    int number = 0;
    double promised = 0;  ///< the scale that the room was planned for
    double caption = 0;   ///< mm that it takes
    bool waits = false;   ///< for all others: it fills its room, whatever that is
    Figure figure;
    Spot size{};                 ///< of the figure alone
    std::vector<Mark> beside{};  ///< equations in its corner
    double height() const { return caption + figure.box.height(); }
    bool is_refused() const { return figure.scale == any_scale; }  ///< the room, by the figure
};

class FigureNeeds {
public:
    explicit FigureNeeds(WantedFigures& wanted) : wanted_(wanted) {}

    void begin_round() {
        refused_.clear();
        spared_ = 0;
    }
    /// Whether a figure may refuse a room: a few times, then it is taken as it comes.
    bool may_refuse(const Wanted& wanted) const;
    /// What a figure takes at the scale that it was drawn at is known from then on.
    void learn_from(const DrawnFigure& drawn);
    /// Whether it is coarser than its room was to let it be, and is given more room for that: a few times.
    bool asks_for_more_room(const DrawnFigure& drawn) const;
    /// Whether it takes more than its room. It is known now what its letters take; where it refused, that they take more.
    bool has_outgrown(const DrawnFigure& drawn);
    /// Whether it missed the scale that the file asks for.
    bool misses_its_scale(const DrawnFigure& drawn) const;
    /// … and is given more room for that: once.
    bool gives_room_for_its_scale(const DrawnFigure& drawn);
    /// A figure that would want a page more for its letters takes the room that it had, as it comes. False: there was none.
    bool take_back();
    /// Whether letters take so much less than was set aside for them that another plan may do with less paper; a few times.
    bool take_less_than_thought();

private:
    bool is_coarser_than_promised(const DrawnFigure& drawn) const;
    void wants_more_than_its_room(const DrawnFigure& drawn);

    /// Of a room in the last round, by a figure, and its rim there.
    struct Refusal {
        std::size_t wanted = 0;
        double rim_x = 0, rim_y = 0;
    };
    WantedFigures& wanted_;
    std::vector<Refusal> refused_;
    std::map<std::string, int> refusals_;  // by the figure's name
    std::set<std::string> roomier_;        // figures that got more room for the scale asked for
    double spared_ = 0;                    // mm, of a room as it was planned in the last round
    int times_less_ = 0;                   // plans anew because letters took less than was thought
};

}  // namespace kinegraph::render
