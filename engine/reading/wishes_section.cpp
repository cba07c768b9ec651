#include "engine/reading/sections.hpp"

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

}  // namespace

void WishesSection::read_wish(JsonValue value) {
    constexpr std::array<std::string_view, 7> wishes{"instant centres", "velocity",  "acceleration", "forces",
                                                     "curvature",       "equations", "virtual work"};
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
        file_.fault(value, {"{0} is nothing to find{1}", "{0} non è cosa da trovare{1}", quoted(value.text()),
                            meant ? did_you_mean(meant)
                                  : Words("; what can be found is {0} and {\"relative motion\": …}",
                                          "; si può trovare {0} e {\"relative motion\": …}", listed(wishes))});
        return;
    }
    if (!file_.expect(value, Kind::object,
                      {"a wish, as \"velocity\" or {\"relative motion\": …, \"observer\": …},",
                       "una richiesta, come \"velocity\" o {\"relative motion\": …, \"observer\": …},"}))
        return;
    if (is_cut(value)) {
        file_.members(value, {"cut"}, {"a cut", "una sezione"});
        for (const JsonValue member : value)
            if (member.key() == "cut" &&
                file_.expect(member, Kind::array, {"an array of three bars", "un array di tre aste"}))
                cuts_.push_back(member);
        find.forces = true;
        return;
    }
    const Members form = file_.members(value, {"relative motion", "observer", "solve"}, {"a wish", "una richiesta"});
    RelativeMotionQuery query;
    query.where = value.pointer();
    query.point = file_.point(file_.required(
        form, "relative motion", {"the point whose motion is observed", "il punto di cui si osserva il moto"}));
    const JsonValue observer = file_.required(form, "observer",
                                              {"the body that carries the observer, or {\"translating with\": Q}",
                                               "il corpo solidale all’osservatore, o {\"translating with\": Q}"});
    if (observer && observer.is_object()) {
        const Members translating = file_.members(observer, {"translating with"}, {"an observer", "un osservatore"});
        query.translating_with = file_.point(
            file_.required(translating, "translating with",
                           {"the point that carries the observer", "il punto con cui trasla l’osservatore"}));
    } else {
        query.observer = file_.body(observer);
    }
    read_solve(form["solve"], query);
    add_once(find.relative_motion, std::move(query));
}

void WishesSection::read_cuts() {
    if (cuts_.empty()) return;
    const std::optional<TrussStructure> truss = truss_of(mechanism_);
    for (const JsonValue cut : cuts_) {
        if (truss)
            read_cut(cut, *truss);
        else
            file_.fault(
                cut,
                {"only a truss can be cut: three bars or more, hinged at both ends and loaded at their pins, without "
                 "efforts and drivers, on supports that hold it with as many reactions as it needs",
                 "si può sezionare solo una travatura reticolare: almeno tre aste, incernierate ai due estremi e "
                 "caricate nei nodi, senza azioni equilibranti né moventi, con tante reazioni quante ne occorrono"});
    }
}

void WishesSection::read_solve(JsonValue value, RelativeMotionQuery& query) {
    if (!value || !file_.expect(value, Kind::boolean, {"true or false", "true o false"})) return;
    query.solves = is_true(value);
    if (query.solves && query.translating_with != none)
        file_.fault(
            value,
            {"the motion is solved through an observer on a body: name one as \"observer\", or leave \"solve\" out",
             "il moto si risolve con un osservatore solidale a un corpo: indicarlo in \"observer\", o togliere "
             "\"solve\""});
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
        if (!file_.expect(member, Kind::string, {"the name of a bar", "il nome di un’asta"})) return;
        const int bar = truss.bar_named(mechanism_, member.text());
        if (bar < 0)
            return file_.fault(member, {"there is no bar {0}; the bars are {1}",
                                        "non c’è un’asta {0}; le aste sono {1}", quoted(member.text()), listed(known)});
        if (std::find(bars.begin(), bars.end(), bar) != bars.end())
            return file_.fault(member,
                               {"bar {0} is cut twice; name three different bars",
                                "l’asta {0} è nominata due volte; indicare tre aste diverse", quoted(member.text())});
        bars.push_back(bar);
        query.bars.push_back(truss.bars[static_cast<std::size_t>(bar)].body);
    }
    constexpr std::size_t needed = 3;
    if (bars.size() != needed)
        return file_.fault(value,
                           {"a cut crosses three bars, for a body has three equations; name three",
                            "una sezione incontra tre aste, tante quante le equazioni di un corpo; indicarne tre"});
    for (std::size_t pin = 0; pin < truss.pins.size(); ++pin) {
        const auto& meeting = truss.pins[pin].bars;
        if (std::all_of(bars.begin(), bars.end(),
                        [&](int bar) { return std::find(meeting.begin(), meeting.end(), bar) != meeting.end(); }))
            return file_.fault(
                value, {"the bars meet in pin {0}, so that no moment gives one of them alone; cut bars that do not "
                        "all meet",
                        "le aste concorrono nel nodo {0}: nessun momento ne dà una sola; sezionare aste che non "
                        "concorrono tutte",
                        truss.name_of(mechanism_, static_cast<int>(pin))});
    }
    if (sides_of_cut(truss, bars).empty())
        return file_.fault(
            value, {"these bars do not part the truss in two; name all bars that the section crosses",
                    "queste aste non dividono in due la travatura; indicare tutte le aste che la sezione incontra"});
    mechanism_.find.cuts.push_back(std::move(query));
}

}  // namespace kinegraph
