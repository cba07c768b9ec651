#include "constructions/statics/forces/sentences.hpp"

#include "lang/keys/sentences.hpp"

#include <algorithm>
#include <iterator>

#include "constructions/kinematics/motion.hpp"

namespace kinegraph::statics {

void ForceSentences::rewind(const Mark& mark) {
    statement_ = mark.statement;
    meets_ = mark.meets;
    named_meets_ = mark.named_meets;
    unsaid_meets_.clear();
    mark_.clear();
}

void ForceSentences::say(Key sentence, std::vector<Argument> arguments, const char* source, const Group& group) {
    Statement statement;
    statement.message = {sentence, std::move(arguments)};
    statement.section = Topic::forces;
    statement.source = source;
    for (const MemberIndex member : group)
        if (!model_.is_pin(member)) statement.bodies.push_back(model_.body_of(member));
    statement_ = board_.state(std::move(statement));
    remember_meets();
}

void ForceSentences::say_of(const Group& group, Key sentence, std::vector<Argument> arguments, const char* source) {
    std::string names;
    constexpr std::ptrdiff_t most_names = 4;
    const std::ptrdiff_t bodies = bodies_in(group);
    if (bodies > most_names || group.size() > most_members)
        names = model_.member_name(group.front()) + " … " +
                model_.member_name(bodies > most_names ? last_body_of(group) : group.back());
    else
        for (const MemberIndex member : group)
            if (!model_.is_pin(member) ||
                bodies < 2)  // "2 + 3", but "2+C" for a body with its pin, which is not another body
                names += (names.empty() ? "" : bodies < 2 ? "+" : " + ") + model_.member_name(member);
    const auto bar = group.size() == 1 ? bar_names_.find(group.front()) : bar_names_.end();
    if (bar != bar_names_.end()) {
        arguments.insert(arguments.begin(), BodyName{bar->second, BodyName::As::truss});
        if (sentence == lang::sentences::two_force_body) sentence = lang::sentences::two_force_bar;
    } else {
        arguments.insert(arguments.begin(), BodyName{names, as_what(group)});
    }
    say(sentence, std::move(arguments), source, group);
}

void ForceSentences::add(std::vector<Argument> arguments) {
    std::vector<Argument>& said = board_.statement(statement_).message.arguments;
    said.insert(said.end(), std::make_move_iterator(arguments.begin()), std::make_move_iterator(arguments.end()));
}

std::ptrdiff_t ForceSentences::bodies_in(const Group& group) const {
    return std::count_if(group.begin(), group.end(), [&](MemberIndex each) { return !model_.is_pin(each); });
}

BodyName::As ForceSentences::as_what(const Group& group) const {
    if (of_truss_ && known_.is_whole(group)) return BodyName::As::truss;
    if (group.size() == 1) return model_.is_pin(group.front()) ? BodyName::As::pin : BodyName::As::body;
    return bodies_in(group) < 2 && group.size() <= most_members ? BodyName::As::with_pin : BodyName::As::bodies;
}

Symbol ForceSentences::symbol_on(int b, const Group& group) const {
    const Bond& bond = model_.bonds()[at(b)];
    return marked(in(group, bond.first) ? bond.symbol : bond.reverse, mark_);
}

Symbol ForceSentences::couple_on(int b, const Group& group) const {
    Symbol symbol = symbol_on(b, group);
    symbol.letter = Symbol::Letter::M;
    return symbol;
}

Quantity ForceSentences::quantity_on(int b, const Group& group) const {
    return model_.quantity_at(at(b), in(group, model_.bonds()[at(b)].first));
}

PointName ForceSentences::place_name(int b) const {
    const Bond& bond = model_.bonds()[at(b)];
    if (bond.joint != none) return {mechanism_.points[at(mechanism_.joints[at(bond.joint)].point)].name};
    return {bond.symbol.about};
}

std::string ForceSentences::names_of(const Group& group) const {
    if (known_.is_whole(group) && known_.wholes().size() == 1) return "";  // the whole structure
    std::string names;
    for (const MemberIndex member : group)
        if (!model_.is_pin(member) || group.size() == 1)
            names += (names.empty() ? "" : ",") + model_.member_name(member);
    return names;
}

std::string ForceSentences::meet_name(const Group& group, PlaceOnDrawing place) {
    auto known = std::find_if(named_meets_.begin(), named_meets_.end(),
                              [&](const NamedMeet& meet) { return board_.coincide(meet.place, place); });
    if (known == named_meets_.end()) known = named_meets_.insert(known, {free_letter(), place});
    unsaid_meets_.emplace_back(group, known - named_meets_.begin());
    return known->name;
}

std::string ForceSentences::name_at(const Group& group, PlaceOnDrawing place) {
    for (const PointIndex point : indices_of(mechanism_.points))
        if (board_.coincide(board_.place(point), place)) return mechanism_.point(point).name;
    return meet_name(group, place);
}

std::optional<LineReason> ForceSentences::guide_along(const Group& group, DirectionHandle way) {
    for (const MemberIndex member : group)
        for (const int b : model_.bonds_of(member)) {
            const Bond& bond = model_.bonds()[at(b)];
            if (bond.joint == none || (bond.kind != Bond::Kind::guide && bond.kind != Bond::Kind::line)) continue;
            if (!board_.parallel(board_.perpendicular(bond.direction), way)) continue;
            const Joint& joint = mechanism_.joint(bond.joint);
            if (joint.pair().meshes()) continue;  // their normal is the line of action of the teeth
            if (joint.along) return along_guide(mechanism_, bond.joint, false);
            return LineReason{LineReason::Kind::parallel_to_tangent, mechanism_.point(joint.point).name, {}};
        }
    return std::nullopt;
}

MemberIndex ForceSentences::last_body_of(const Group& group) const {
    const auto last =
        std::find_if(group.rbegin(), group.rend(), [&](MemberIndex member) { return !model_.is_pin(member); });
    return last == group.rend() ? group.back() : *last;
}

std::string ForceSentences::free_letter() const {
    static const char* const letters[] = {"H", "K", "L", "Q", "R", "T", "U", "V", "W", "Y", "Z"};
    for (int round = 0;; ++round) {
        for (const char* letter : letters) {
            std::string candidate = letter + (round == 0 ? std::string() : std::to_string(round));
            if (mechanism_.point_named(candidate)) continue;
            if (std::none_of(named_meets_.begin(), named_meets_.end(),
                             [&](const NamedMeet& meet) { return meet.name == candidate; }))
                return candidate;
        }
    }
}

void ForceSentences::remember_meets() {
    for (const auto& [group, index] : unsaid_meets_) {
        NamedMeet& meet = named_meets_[static_cast<std::size_t>(index)];
        if (meet.statement == none) meet.statement = statement_;
        meet.used = statement_;
        for (const MemberIndex member : group) meets_[member].push_back(meet);
    }
    unsaid_meets_.clear();
}

}  // namespace kinegraph::statics
