#include "constructions/statics/forces/loads_of_members.hpp"

#include <array>
#include <string>
#include <utility>
#include <variant>

#include "engine/drawing/spring_force.hpp"
#include "lang/keys/phrases.hpp"
#include "lang/keys/sentences.hpp"

namespace kinegraph::statics {
namespace {

class LoadsReading {
public:
    LoadsReading(Structure& structure, Board& board, const Motion& motion, const PinMembers& pins)
        : structure_(structure), board_(board), mechanism_(structure.mechanism()), motion_(motion), pins_(pins) {}

    LoadsOfMembers read() {
        for (std::size_t l = 0; l < mechanism_.loads.size(); ++l) {
            const auto index = static_cast<int>(l);
            const auto& given = mechanism_.loads[l];
            if (const auto* force = std::get_if<ForceLoad>(&given)) {
                const Force acting =
                    force->value ? board_.load_force(index)
                                 : board_.scale<Plane::force>(board_.load_magnitude(index), board_.load_unit(index));
                const Symbol symbol{Symbol::Letter::F, force->name, {}};
                const MemberIndex member = force->pin == none ? member_of(force->body) : pins_.at(force->pin);
                add_load({member, symbol, Quantity::Kind::load, acting, board_.place(force->at), {}, index});
            } else if (const auto* couple = std::get_if<CoupleLoad>(&given)) {
                const auto& points = mechanism_.bodies[at(couple->body)].points;
                add_load({member_of(couple->body),
                          {Symbol::Letter::M, couple->name, {}},
                          Quantity::Kind::load,
                          {},
                          board_.place(points.empty() ? PointIndex(0) : points.front()),
                          board_.load_magnitude(index),
                          index});
            } else if (const auto* distributed = std::get_if<DistributedLoad>(&given)) {
                add_distributed(index, *distributed);
            } else if (const auto* torsion = std::get_if<TorsionLoad>(&given)) {
                add_torsion(index, *torsion);
            } else {
                add_spring(index, std::get<SpringLoad>(given));
            }
        }
        for (std::size_t m = 0; m < mechanism_.masses.size(); ++m) {
            add_weight(static_cast<int>(m));
            if (mechanism_.inertia_forces) add_inertia(static_cast<int>(m));
        }
        return std::move(read_);
    }

private:
    void add_load(Load load) {
        if (load.member == member_of(frame)) return;
        if (load.force && board_.is_zero(*load.force)) load.force.reset();
        if (load.couple && board_.is_zero(*load.couple)) load.couple.reset();
        if (load.force || load.couple) read_.loads.push_back(std::move(load));
    }

    void add_spring(int index, const SpringLoad& spring) {
        const auto [first, second] = spring.between;
        if (board_.coincide(board_.place(first), board_.place(second))) {
            read_.missing.push_back(
                {{lang::phrases::all_forces, {}}, {lang::phrases::spring_without_direction, {spring.name}}});
            return;
        }
        const std::size_t before = read_.loads.size();
        for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
            const DirectionHandle pull = end == 0 ? board_.load_unit(index) : board_.load_unit_back(index);
            add_load({member_of(spring.bodies[end]),
                      {Symbol::Letter::F, spring.name, {}},
                      Quantity::Kind::load,
                      board_.scale<Plane::force>(board_.load_magnitude(index), pull),
                      board_.place(spring.between[end]),
                      {},
                      index});
        }
        const auto name = [&](PointIndex point) { return PointName{mechanism_.point(point).name}; };
        if (spring.elastic && read_.loads.size() > before)
            say_of_load(read_.loads.back(),
                        {lang::sentences::elastic_spring, {read_.loads.back().symbol, name(first), name(second)}},
                        "Hooke");
    }

    /// At the centroid of its diagram; a couple if its halves cancel.
    void add_distributed(int index, const DistributedLoad& load) {
        const Centroid resultant = centroid_of(load);
        const Force force = board_.scale<Plane::force>(board_.load_magnitude(index), board_.load_unit(index));
        const auto share = board_.scale<drawing>(board_.number(resultant.place),
                                                 board_.vector(board_.place(load.from), board_.place(load.to)));
        Load acting{member_of(load.body), {Symbol::Letter::F, load.name, {}}, Quantity::Kind::load, {}, {}, {}, index};
        if (resultant.is_couple) {
            acting.symbol.letter = Symbol::Letter::M;
            acting.place = board_.place(load.from);
            acting.couple = board_.moment(share, force);
        } else {
            acting.force = force;
            acting.place = board_.carry(board_.place(load.from), share);
        }
        const std::size_t before = read_.loads.size();
        add_load(acting);
        if (read_.loads.size() == before) return;
        const auto name = [&](PointIndex point) { return PointName{mechanism_.point(point).name}; };
        say_of_load(acting,
                    {resultant.is_couple ? lang::sentences::distributed_couple : lang::sentences::distributed_load,
                     {BodyName{mechanism_.body(load.body).name}, acting.symbol, name(load.from), name(load.to)}});
    }

    void add_torsion(int index, const TorsionLoad& torsion) {
        const std::size_t before = read_.loads.size();
        for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
            const ScalarHandle couple = board_.load_magnitude(index);
            add_load({member_of(torsion.bodies[side]),
                      {Symbol::Letter::M, torsion.name, {}},
                      Quantity::Kind::load,
                      {},
                      board_.place(torsion.at),
                      side == 0 ? couple : board_.opposite(couple),
                      index});
        }
        if (read_.loads.size() == before) return;
        const auto name = [&](BodyIndex body) { return BodyName{mechanism_.body(body).name}; };
        say_of_load(read_.loads.back(),
                    {lang::sentences::torsion_spring,
                     {read_.loads.back().symbol, name(torsion.bodies[0]), name(torsion.bodies[1])}},
                    "Hooke");
    }

    std::string mass_name(const Mass& mass, const char* letter) const {
        return mechanism_.masses.size() == 1 ? std::string(letter)
                                             : std::string(letter) + mechanism_.bodies[at(mass.body)].name;
    }

    void add_weight(int index) {
        if (!mechanism_.gravity) return;
        const Mass& mass = mechanism_.masses[at(index)];
        add_load({member_of(mass.body),
                  {Symbol::Letter::F, mass_name(mass, "g"), {}},
                  Quantity::Kind::weight,
                  board_.scale<Plane::force>(board_.mass(index), board_.gravity()),
                  board_.place(mass.centre),
                  {},
                  index});
    }

    /// d'Alembert: −m a_G at the mass centre and −J_G α.
    void add_inertia(int index) {
        const Mass& mass = mechanism_.masses[at(index)];
        const auto& track = motion_.acceleration;
        const NodeIndex centre = structure_.find(mass.centre, mass.body);
        if (track.polygon < 0 || centre == none || !track.has(centre) || !track.turns(mass.body)) {
            read_.missing.push_back(
                {{lang::phrases::all_forces, {}},
                 {lang::phrases::inertia_without_motion, {BodyName{mechanism_.bodies[at(mass.body)].name}}}});
            return;
        }
        const auto acceleration = board_.vector(board_.pole<Plane::acceleration>(), track.tip(centre));
        Load load{member_of(mass.body),
                  {Symbol::Letter::F, mass_name(mass, "i"), {}},
                  Quantity::Kind::inertia,
                  board_.negate(board_.scale<Plane::force>(board_.mass(index), acceleration)),
                  board_.place(mass.centre),
                  {},
                  index};
        const BodyName body{mechanism_.bodies[at(mass.body)].name};
        const std::string& label = structure_.node(centre).label;
        add_said(load, {lang::sentences::inertia_force,
                        {body, load.symbol, Symbol{Symbol::Letter::a, label, {}}, PointName{label}}});
        const Load force = load;
        load.force.reset();
        load.symbol.letter = Symbol::Letter::M;
        load.couple = board_.opposite(board_.product(board_.inertia(index), track.spin(mass.body)));
        add_said(load,
                 {lang::sentences::inertia_couple, {body, load.symbol, Symbol{Symbol::Letter::alpha, body.name, {}}}});
        move_inertia(force, load);
    }

    void move_inertia(const Load& force, const Load& couple) {
        if (force.member == member_of(frame) || board_.is_zero(*force.force) || board_.is_zero(*couple.couple)) return;
        Sum one{{force.member}, moved_aside(force.symbol), *force.force, {}, {}, none};
        one.place = board_.carry(force.place, board_.arm(*couple.couple, *force.force));
        one.statement = say_of_load(force,
                                    {lang::sentences::inertia_moved,
                                     {BodyName{mechanism_.body(BodyIndex(force.member.number())).name}, force.symbol,
                                      couple.symbol, one.symbol}},
                                    "d’Alembert");
        read_.shifts.push_back({force.member, force.place, *force.force, one.place, one.statement, true});
        read_.moved.push_back(std::move(one));
    }

    /// Adds a load with the sentence that finds it, unless it vanishes.
    void add_said(const Load& load, Message message) {
        const std::size_t before = read_.loads.size();
        add_load(load);
        if (read_.loads.size() > before) say_of_load(load, std::move(message), "d’Alembert");
    }

    StatementIndex say_of_load(const Load& load, Message message, const char* source = "") {
        Statement statement;
        statement.message = std::move(message);
        statement.section = Topic::forces;
        statement.source = source;
        if (at(load.member) < mechanism_.bodies.size()) statement.bodies = {BodyIndex(load.member.number())};
        return board_.state(std::move(statement));
    }

    Structure& structure_;
    Board& board_;
    const Mechanism& mechanism_;
    const Motion& motion_;
    const PinMembers& pins_;
    LoadsOfMembers read_;
};

}  // namespace

LoadsOfMembers loads_of_members(Structure& structure, Board& board, const Motion& motion, const PinMembers& pins) {
    return LoadsReading(structure, board, motion, pins).read();
}

}  // namespace kinegraph::statics
