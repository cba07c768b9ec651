#include "engine/reading/sections.hpp"

#include <variant>

namespace kinegraph {

void ProfilesOfContact::read_profiles(const Members& form, Joint& joint) {
    const JsonValue shape = file_.one_of(form, {"profiles", "tangent"}, false);
    if (form["profiles"] && form["tangent"]) return;
    if (shape && shape.key() == "tangent") {
        joint.tangent = file_.bearing(shape);
        return;
    }
    if (form.has_or_misspells("tangent") || (!shape && form.has_or_misspells("profiles"))) return;
    bool complete = joint.bodies.size() == 2 && joint.bodies[0] != none && joint.bodies[1] != none;
    if (shape) {
        if (!file_.expect(shape, Kind::object, {"an object of profiles by body", "un oggetto con i profili per corpo"}))
            return;
        for (const JsonValue member : shape) complete = read_profile(member, joint) && complete;
    }
    if (!complete) return;
    const JsonValue place = shape ? shape : form.object();
    for (const BodyIndex on : joint.bodies) {
        if (joint.profiles.contains(on)) continue;
        const Body& owner = mechanism_.body(on);
        if (owner.circle) {
            if (owner.circle->centre == joint.point && joint.point != none) {
                file_.fault(place,
                            {"the circle of body {0} has its centre at the contact itself",
                             "la circonferenza del corpo {0} ha il centro nel contatto stesso", quoted(owner.name)});
            }
            joint.profiles.emplace(on, CircleProfile{owner.circle->centre, true});
        } else {
            file_.fault(place, {"the profile of body {0} is missing: give it under \"profiles\", or the body a "
                                "\"circle\", or the joint a \"tangent\"",
                                "manca il profilo del corpo {0}: assegnarlo in \"profiles\", o dare al corpo un "
                                "\"circle\", o alla coppia una \"tangent\"",
                                quoted(owner.name)});
            complete = false;
        }
    }
    if (!complete || joint.bodies[0] == joint.bodies[1]) return;
    const Profile& first = joint.profiles.at(joint.bodies[0]);
    const Profile& second = joint.profiles.at(joint.bodies[1]);
    if (std::holds_alternative<LineProfile>(first) && std::holds_alternative<LineProfile>(second)) {
        file_.fault(
            place, {"two lines are no contact: they touch everywhere or nowhere; one of the bodies has another profile",
                    "due rette non fanno un contatto: si toccano ovunque o in nessun punto; uno dei corpi ha un altro "
                    "profilo"});
    }
    if (std::holds_alternative<TipProfile>(first) && std::holds_alternative<TipProfile>(second)) {
        file_.fault(place,
                    {"two tips are no contact: they have no common tangent; one of the bodies has another profile",
                     "due punte non fanno un contatto: non hanno tangente comune; uno dei corpi ha un altro profilo"});
    }
}

bool ProfilesOfContact::read_profile(JsonValue member, Joint& joint) {
    const BodyIndex on = file_.look_up_body(member, member.key());
    if (on != none && !joint.connects(on)) {
        if (!joint.connects(none)) {
            file_.fault(member, {"the body {0} is not in this joint", "il corpo {0} non è in questa coppia",
                                 quoted(member.key())});
        }
        return false;
    }
    if (!file_.expect(member, Kind::object,
                      {"a profile, {\"line\": …}, {\"circle\": …} or {\"tip\": true},",
                       "un profilo, {\"line\": …}, {\"circle\": …} o {\"tip\": true},"}))
        return false;
    const Members form = file_.members(member, {"line", "circle", "tip"}, {"a profile", "un profilo"});
    const JsonValue shape = file_.one_of(form, {"line", "circle", "tip"});
    if (!shape) return false;
    if (shape.key() == "line") {
        const auto along = file_.bearing(shape);
        if (!along) return false;
        joint.profiles.emplace(on, LineProfile{*along});
    } else if (shape.key() == "circle") {
        const PointIndex centre = file_.point(shape);
        if (centre != none && centre == joint.point)
            file_.fault(shape, {"a circle about the contact itself has no radius; name its centre",
                                "una circonferenza attorno al contatto stesso non ha raggio; indicarne il centro"});
        joint.profiles.emplace(on, CircleProfile{centre});
    } else {
        if (!is_true(shape)) {
            file_.fault(shape, {"a tip is {\"tip\": true}", "una punta è {\"tip\": true}"});
            return false;
        }
        joint.profiles.emplace(on, TipProfile{});
    }
    return on != none;
}

}  // namespace kinegraph
