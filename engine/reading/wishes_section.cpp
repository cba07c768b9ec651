#include "engine/reading/sections.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/wishes.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace kinegraph {
namespace {

/// The same relative motion asked twice is one.
void add_once(std::vector<RelativeMotionQuery>& all, RelativeMotionQuery query) {
    const auto same = std::find_if(all.begin(), all.end(), [&](const RelativeMotionQuery& each) {
        return each.point == query.point && each.observer == query.observer &&
               each.translating_with == query.translating_with;
    });
    if (same == all.end())
        all.push_back(std::move(query));
    else
        same->solves = same->solves || query.solves;
}

constexpr std::array<std::string_view, 7> wishes{"instant centres", "velocity",  "acceleration", "forces",
                                                 "curvature",       "equations", "virtual work"};

constexpr std::array translating_rows{
    FormRow("translating with", "Q", values::point_name).needed(lang::wishes::the_point_that_carries_the_observer)};
constexpr Form translating_observer{lang::wishes::an_observer, translating_rows};
constexpr std::array observer_choices{values::body_name, values::object(translating_observer)};
constexpr std::array relative_motion_rows{
    FormRow("relative motion", "P", values::point_name).needed(lang::wishes::the_point_whose_motion_is_observed),
    FormRow("observer", "i", values::any(observer_choices),
            "A body that carries the observer, or a point with which the observer translates.")
        .needed(lang::wishes::the_body_that_carries_the_observer),
    FormRow("solve", "true", values::flag,
            "Whether the motion itself is to be found through this observer, on a body.")};
constexpr Form relative_motion_form{lang::wishes::a_wish, relative_motion_rows};
constexpr std::array cut_rows{leading_key("cut", "[bar, bar, bar]", values::list(values::text, 3, 3),
                                          "Three bars of a truss, each named by its pins, that part it (Ritter).")};
constexpr Form cut_form{lang::wishes::a_cut, cut_rows};
constexpr std::array wish_choices{values::word(wishes), values::object(relative_motion_form), values::object(cut_form)};

}  // namespace

constinit const FormValue forms::wish = values::any(wish_choices).named("wish", {});

void WishesSection::read_wish(JsonValue value) {
    Find& find = mechanism_.find;
    const std::array<bool*, wishes.size()> flags{&find.instant_centres, &find.velocity,  &find.acceleration,
                                                 &find.forces,          &find.curvature, &find.equations,
                                                 &find.virtual_work};
    if (value.is_string()) {
        const auto* const known = std::find(wishes.begin(), wishes.end(), value.text());
        if (known != wishes.end()) {
            *flags[static_cast<std::size_t>(known - wishes.begin())] = true;
            return;
        }
        const auto meant = file_.speller().nearest(value.text(), wishes);
        file_.fault(value, {lang::wishes::is_nothing_to_find, quoted(value.text()),
                            meant ? did_you_mean(meant) : Words(lang::wishes::what_can_be_found, listed(wishes))});
        return;
    }
    if (!file_.expect(value, Kind::object, {lang::wishes::a_wish_as_velocity_or_relative})) return;
    if (is_cut(value)) {
        file_.members(value, cut_form);
        for (const JsonValue member : value)
            if (member.key() == "cut" && file_.expect(member, Kind::array, {lang::wishes::an_array_of_three_bars}))
                cuts_.push_back(member);
        find.forces = true;
        return;
    }
    const Members form = file_.members(value, relative_motion_form);
    RelativeMotionQuery query;
    query.where = value.pointer();
    query.point = form.point("relative motion");
    observed_.emplace_back(form["relative motion"], query.point);
    const JsonValue observer = form.value("observer");
    if (observer && observer.is_object()) {
        query.translating_with = file_.members(observer, translating_observer).point("translating with");
        observed_.emplace_back(observer["translating with"], query.translating_with);
    } else {
        query.observer = file_.body(observer);
    }
    query.solves = form.flag("solve");
    if (query.solves && query.translating_with != none)
        file_.fault(form["solve"], {lang::wishes::the_motion_is_solved_through});
    add_once(find.relative_motion, std::move(query));
}

void WishesSection::check_observed_points() {
    const auto is_carried = [&](PointIndex point) {
        const auto has = [&](const Body& body) {
            return std::find(body.points.begin(), body.points.end(), point) != body.points.end();
        };
        const auto joins = [&](const Joint& joint) { return joint.point == point; };
        return std::any_of(mechanism_.bodies.begin(), mechanism_.bodies.end(), has) ||
               std::any_of(mechanism_.joints.begin(), mechanism_.joints.end(), joins);
    };
    for (const auto& [at, point] : observed_)
        if (point != none && !is_carried(point))
            file_.fault(at, {lang::wishes::no_body_carries_it, quoted(mechanism_.point(point).name)});
}

void WishesSection::read_cuts() {
    if (cuts_.empty()) return;
    const std::optional<TrussStructure> truss = truss_of(mechanism_);
    for (const JsonValue cut : cuts_) {
        if (truss)
            read_cut(cut, *truss);
        else
            file_.fault(cut, {lang::wishes::only_a_truss_can_be_cut});
    }
}

bool WishesSection::is_cut(JsonValue value) {
    bool found = false;
    for (const JsonValue member : value) found = found || member.key() == "cut";
    return found;
}

void WishesSection::read_cut(JsonValue value, const TrussStructure& truss) {
    std::vector<std::string_view> known;
    for (const TrussStructure::Bar& bar : truss.bars) known.emplace_back(bar.name);
    std::vector<int> bars;
    CutQuery query;
    query.where = value.pointer();
    for (const JsonValue member : value) {
        if (!file_.expect(member, Kind::string, {lang::wishes::the_name_of_a_bar})) return;
        const int bar = truss.bar_named(mechanism_, member.text());
        if (bar < 0)
            return file_.fault(member, {lang::wishes::there_is_no_bar_the_bars, quoted(member.text()), listed(known)});
        if (std::find(bars.begin(), bars.end(), bar) != bars.end())
            return file_.fault(member, {lang::wishes::bar_is_cut_twice_name_three, quoted(member.text())});
        bars.push_back(bar);
        query.bars.push_back(truss.bars[static_cast<std::size_t>(bar)].body);
    }
    constexpr std::size_t needed = 3;
    if (bars.size() != needed) return file_.fault(value, {lang::wishes::a_cut_crosses_three_bars});
    for (std::size_t pin = 0; pin < truss.pins.size(); ++pin) {
        const auto& meeting = truss.pins[pin].bars;
        if (std::all_of(bars.begin(), bars.end(),
                        [&](int bar) { return std::find(meeting.begin(), meeting.end(), bar) != meeting.end(); }))
            return file_.fault(value,
                               {lang::wishes::the_bars_meet_in_pin, truss.name_of(mechanism_, static_cast<int>(pin))});
    }
    if (sides_of_cut(truss, bars).empty()) return file_.fault(value, {lang::wishes::these_bars_do_not_part});
    mechanism_.find.cuts.push_back(std::move(query));
}

}  // namespace kinegraph
