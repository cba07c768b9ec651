#include "engine/reading/sections.hpp"

#include <utility>

namespace kinegraph {
namespace {

Words nothing_moves_the_frame() {
    return {"an effort on the frame balances nothing; name a body that moves",
            "un’azione sul telaio non equilibra nulla; indicare un corpo che si muove"};
}

}  // namespace

void EffortsSection::read_effort(JsonValue value) {
    if (!file_.expect(value, Kind::object, {"an effort", "un’azione equilibrante"})) return;
    const Named name = value["couple"]  ? read_couple_effort(value)
                       : value["joint"] ? read_actuator(value)
                                        : read_force_effort(value);
    if (!name.text.empty() && !effort_names_.insert(name.text).second) {
        file_.fault(name.at,
                    {"two efforts are named {0}; results go by the name, so rename one",
                     "due azioni equilibranti si chiamano {0}; i risultati vanno per nome, quindi rinominarne una",
                     quoted(name.text)});
    }
}

EffortsSection::Named EffortsSection::effort_name(JsonValue given, const Words& wanted) {
    return {given ? std::string(file_.new_name(given, wanted)) : std::string(), given};
}

EffortsSection::Named EffortsSection::read_couple_effort(JsonValue value) {
    const Members form = file_.members(value, {"couple", "body", "from", "force"},
                                       {"a couple that balances", "una coppia di forze equilibrante"});
    file_.one_of(form, {"couple", "force"});
    Named name = effort_name(form["couple"], {"the couple's name", "il nome della coppia di forze"});
    CoupleEffort couple;
    couple.where = value.pointer();
    couple.body = file_.body(file_.required(form, "body", {"the body on which it acts", "il corpo su cui agisce"}));
    if (const JsonValue from = form["from"]) couple.from = file_.body(from);
    if (couple.body != none && couple.body == couple.from) {
        file_.fault(form["from"] ? form["from"] : form["body"],
                    form["from"]
                        ? Words("a couple from a body on itself balances nothing; name another",
                                "una coppia di forze da un corpo su se stesso non equilibra nulla; indicarne un altro")
                        : nothing_moves_the_frame());
    }
    couple.name = name.text;
    mechanism_.efforts.emplace_back(std::move(couple));
    return name;
}

EffortsSection::Named EffortsSection::read_actuator(JsonValue value) {
    const Members form = file_.members(value, {"force", "joint"}, {"an actuator", "un attuatore"});
    Named name = effort_name(file_.required(form, "force", {"the force's name", "il nome della forza"}),
                             {"the force's name", "il nome della forza"});
    ActuatorEffort actuator;
    actuator.where = value.pointer();
    const Words remedy("an actuator works in a prismatic joint", "un attuatore agisce in una coppia prismatica");
    actuator.joint = joints_.sliding_joint(form["joint"], remedy);
    if (actuator.joint != none) {
        const PlanePair& pair = mechanism_.joint(actuator.joint).pair();
        if (!pair.is_sleeve()) joints_.wrong_kind(form["joint"], pair.key, remedy);
    }
    actuator.name = name.text;
    mechanism_.efforts.emplace_back(std::move(actuator));
    return name;
}

EffortsSection::Named EffortsSection::read_force_effort(JsonValue value) {
    const Members form = file_.members(value, {"force", "body", "at", "along", "couple", "joint"},
                                       {"a force that balances", "una forza equilibrante"});
    if (form.has_or_misspells("couple") || form.has_or_misspells("joint")) return {};
    if (!form.has_or_misspells("force")) {
        file_.fault(value, {"the effort's name is missing: \"force\" or \"couple\"",
                            "manca il nome dell’azione equilibrante: \"force\" o \"couple\""});
        return {};
    }
    Named name = effort_name(form["force"], {"the force's name", "il nome della forza"});
    ForceEffort force;
    force.where = value.pointer();
    force.body = file_.moving_body(file_.required(form, "body",
                                                  {"the body on which it acts (or give \"joint\")",
                                                   "il corpo su cui agisce (o assegnare \"joint\")"}),
                                   nothing_moves_the_frame());
    force.at = file_.point(file_.required(form, "at", {"the point at which it acts", "il punto in cui agisce"}));
    force.along = file_.bearing_or_default(
        file_.required(form, "along", {"the direction of the force", "la direzione della forza"}));
    force.name = name.text;
    mechanism_.efforts.emplace_back(std::move(force));
    return name;
}

}  // namespace kinegraph
