#include "constructions/free_bodies.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "engine/assert.hpp"

namespace kinegraph::statics {
namespace {

/// One force of a body's polygon.
struct Side {
    Symbol symbol;
    Force force;
    int bond = -1;         ///< −1: a load
    bool external = true;  ///< a load, an effort or reaction of the frame
    Quantity quantity;
};

using Corner = PointOn<Plane::force>;

class FreeBodies {
public:
    FreeBodies(ForceModel& model, Board& board, const Mechanism& mechanism, const Mobility& mobility, const NamedMeets& meets,
               const std::vector<Loose>& loose, bool one_by_one)
        : model_(model),
          board_(board),
          mechanism_(mechanism),
          mobility_(mobility),
          meets_(meets),
          loose_(loose),
          one_by_one_(one_by_one),
          loads_(&model.loads()) {}

    ForceResults cut(const Run& run) {
        collect(run);
        return std::move(results_);
    }

private:
    void collect(const Run& run) {
        for (const Loose& each : loose_) resultant(each);
        std::set<MemberIndex> open = out_of_equilibrium(run);
        for (const MemberIndex member : unbalanced_) open.erase(member);
        const bool balanced = open.empty(), complete = is_complete(run);
        if (!complete || !balanced) explain(run, balanced);
        for (std::size_t b = 0; b < model_.bonds().size(); ++b) {
            const Bond& bond = model_.bonds()[b];
            const bool held = unbalanced_.count(bond.first) == 0 && unbalanced_.count(bond.second) == 0;
            collect(bond, run.reactions[b], held && open.count(bond.first) == 0 && open.count(bond.second) == 0);
        }
        if ((!complete && run.redundant.empty()) || !balanced) return;
        if (one_by_one_) draw_bodies(run);
        for (const Released& released : run.released) virtual_motion(released);
        if (complete && one_by_one_) join_polygons();
        cut_together(run);
        if (complete && one_by_one_ && !run.parts.empty()) superpose(run);
        remark_lift_off(run);
    }
    void draw_bodies(const Run& run) {
        Group order;
        for (const Resolved& resolved : run.order) order.push_back(resolved.member);
        for (const MemberIndex member : model_.moving_members()) {
            if (!in(order, member)) order.push_back(member);
        }
        for (const MemberIndex member : order)
            if (unbalanced_.count(member) == 0 && (is_whole(member, run) || in(run.redundant, member))) free_body(member, run);
    }

    /// All that acts on it is known.
    bool is_whole(MemberIndex member, const Run& run) const {
        const auto& bonds = model_.bonds_of(member);
        return std::all_of(bonds.begin(), bonds.end(), [&](int b) { return run.reactions[at(b)].known; });
    }

    // --- loads that act alone, and bodies taken together ---------------------------------------------------------------------
    void superpose(const Run& run) {
        Superposition found;
        found.statement = run.summed;
        for (const PartRun& part : run.parts) {
            FreeBodies alone(model_, board_, mechanism_, mobility_, meets_, loose_, true);
            auto cut = alone.cut_part(part);
            if (!cut) return;
            found.parts.push_back(*std::move(cut));
        }
        for (std::size_t b = 0; b < model_.joint_bonds(); ++b) sum_parts(b, run, found);
        results_.superposition = std::move(found);
    }
    /// Nothing: what acts alone is not in equilibrium by itself.
    std::optional<Superposition::Part> cut_part(const PartRun& part) {
        loads_ = &part.loads;
        mark_ = model_.member_name(part.loaded);
        first_ = part.first;
        end_ = part.end;
        if (!out_of_equilibrium(part.run).empty()) return std::nullopt;
        draw_bodies(part.run);
        cut_together(part.run);
        Superposition::Part cut;
        cut.body = model_.body_of(part.loaded);
        if (model_.is_pin(part.loaded)) cut.pin = model_.pin_point(part.loaded);
        cut.first = part.first;
        cut.end = part.end;
        cut.bodies = std::move(results_.bodies);
        cut.together = std::move(results_.together);
        return cut;
    }
    /// Of one action, on a body that moves: forces tip to tail, and couples.
    void sum_parts(std::size_t b, const Run& run, Superposition& found) {
        const Bond& bond = model_.bonds()[b];
        const bool reversed = bond.first == member_of(frame);
        const MemberIndex on = reversed ? bond.second : bond.first;
        const Symbol symbol = reversed ? bond.reverse : bond.symbol;
        const auto turned = [&](Force force) { return reversed ? board_.negate(force) : force; };
        const auto turned_couple = [&](ScalarHandle couple) { return reversed ? board_.opposite(couple) : couple; };
        std::vector<Side> sides;
        Superposition::CoupleSum couples{symbol, {}, {}};
        couples.symbol.letter = Symbol::Letter::M;
        for (const PartRun& part : run.parts) {
            const Reaction& reaction = part.run.reactions[b];
            if (reaction.force)
                sides.push_back({marked(symbol, model_.member_name(part.loaded)), turned(*reaction.force), static_cast<int>(b),
                                 true, quantity_on(b, reversed)});
            if (reaction.couple) couples.parts.push_back(Recorded<Exact>::at(turned_couple(*reaction.couple).element));
        }
        const Reaction& total = run.reactions[b];
        if (couples.parts.size() > 1) {
            couples.total = total.couple ? found_couple(turned_couple(*total.couple)) : Recorded<Exact>::zero();
            found.couples.push_back(std::move(couples));
        }
        if (sides.size() < 2) return;
        const int polygon = add_force_polygon(Polygon::Kind::body_forces, "sum-" + name_of(symbol));
        const Corner start = board_.pole<Plane::force>();
        Corner here = start;
        Face face;
        for (const Side& side : sides) {
            const Corner next = board_.carry(here, side.force);
            draw_side(polygon, side, on, here, next);
            face.corners.push_back(here.element);
            here = next;
        }
        if (total.force)
            draw_side(polygon, {symbol, turned(*total.force), static_cast<int>(b), true, quantity_on(b, reversed)}, on, start,
                      here);
        face.corners.push_back(here.element);
        board_.add_face(polygon, std::move(face));
        found.sums.push_back({symbol, model_.body_of(on), polygon});
    }
    /// Of a bond, on its first member or, reversed, on its second.
    Quantity quantity_on(std::size_t b, bool reversed) const {
        const Bond& bond = model_.bonds()[b];
        if (bond.effort >= 0) return {.kind = Quantity::Kind::effort, .given = bond.effort};
        return {.kind = Quantity::Kind::force,
                .body = model_.body_of(reversed ? bond.second : bond.first),
                .other = model_.body_of(reversed ? bond.first : bond.second),
                .joint = bond.joint};
    }
    static Recorded<Exact> found_couple(ScalarHandle couple) { return Recorded<Exact>::at(couple.element); }

    /// Of bodies that were balanced as one: what acts on them from outside, first what was known.
    void cut_together(const Run& run) {
        for (const Balanced& balanced : run.balanced) {
            const std::vector<int> outer = model_.outer_bonds(balanced.group);
            if (!std::all_of(outer.begin(), outer.end(), [&](int b) { return run.reactions[at(b)].known; })) continue;
            const Strings* strings = strings_of(balanced, run);
            // The plan of a truss has what closes, but no rays and no diagonal of Culmann's.
            if (!one_by_one_ && strings == nullptr && !has_diagonal(balanced, run)) continue;
            std::vector<std::pair<MemberIndex, Side>> sides;
            for (const Load& load : *loads_)
                if (load.force && in(balanced.group, load.member) && !model_.is_inner(load, balanced.group))
                    sides.push_back(
                        {load.member,
                         {load.symbol, *load.force, -1, true, quantity_of(empty_body(load.member), applied_load(load))}});
            for (const bool sought : {false, true})
                for (const int b : outer) {
                    const bool is_sought = std::find(balanced.sought.begin(), balanced.sought.end(), b) != balanced.sought.end();
                    const Reaction& reaction = run.reactions[at(b)];
                    if (is_sought != sought || !reaction.force) continue;
                    const Bond& bond = model_.bonds()[at(b)];
                    const bool on_first = in(balanced.group, bond.first);
                    sides.push_back({on_first ? bond.first : bond.second,
                                     {marked(on_first ? bond.symbol : bond.reverse, mark_),
                                      on_first ? *reaction.force : board_.negate(*reaction.force),
                                      b,
                                      true,
                                      {}}});
                }
            if (sides.size() > 2) draw_together(balanced, std::move(sides), strings, run);
        }
    }
    /// What is known and a force that is sought were added.
    static bool has_diagonal(const Balanced& balanced, const Run& run) {
        const auto is_sought = [&](int b) {
            return std::find(balanced.sought.begin(), balanced.sought.end(), b) != balanced.sought.end();
        };
        return std::any_of(run.added.begin(), run.added.end(), [&](const Added& added) {
            return added.group == balanced.group && std::any_of(added.bonds.begin(), added.bonds.end(), is_sought);
        });
    }
    /// By which the group was balanced; null: otherwise.
    static const Strings* strings_of(const Balanced& balanced, const Run& run) {
        const auto found = std::find_if(run.strings.begin(), run.strings.end(), [&](const Strings& strings) {
            return strings.group == balanced.group && strings.statement == balanced.statement;
        });
        return found == run.strings.end() ? nullptr : &*found;
    }
    void draw_together(const Balanced& balanced, std::vector<std::pair<MemberIndex, Side>> sides, const Strings* strings,
                       const Run& run) {
        TakenTogether together;
        together.statement = balanced.statement;
        if (strings != nullptr) {
            together.funicular = funicular(*strings);
            std::stable_sort(sides.begin(), sides.end(), [&](const auto& a, const auto& b) {
                return rank_in(*together.funicular, a.second.symbol) < rank_in(*together.funicular, b.second.symbol);
            });
        }
        std::string id = one_by_one_ ? "forces" : "forces-truss";
        for (const MemberIndex member : balanced.group)
            if (!model_.is_pin(member)) together.bodies.push_back(model_.body_of(member));
        // Of one body and its pin it is not the body's own.
        for (const MemberIndex member : balanced.group)
            if (one_by_one_ && (!model_.is_pin(member) || together.bodies.size() < 2)) id += "-" + model_.member_name(member);
        std::vector<const Added*> leading;
        for (const Added& added : run.added)
            if (added.group == balanced.group) {
                together.sums.push_back(applied_sum(added));
                leading.push_back(&added);
            }
        if (strings == nullptr)
            std::stable_sort(sides.begin(), sides.end(), [&](const auto& a, const auto& b) {
                return rank_in(leading, a.second) < rank_in(leading, b.second);
            });
        together.polygon = add_force_polygon(Polygon::Kind::body_forces, id + suffix());
        Face face;
        Corner here = board_.pole<Plane::force>();
        const Corner start = here;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const Corner next = i + 1 == sides.size() ? start : board_.carry(here, sides[i].second.force);
            draw_side(together.polygon, sides[i].second, sides[i].first, here, next);
            face.corners.push_back(here.element);
            here = next;
        }
        board_.add_face(together.polygon, std::move(face));
        results_.together.push_back(std::move(together));
    }
    std::string suffix() const { return mark_.empty() ? "" : "-load-" + mark_; }

    // --- what was added up on the way ----------------------------------------------------------------------------------------
    static AppliedForce applied_sum(const Added& added) {
        AppliedForce applied;
        applied.symbol = added.symbol;
        applied.kind = AppliedForce::Kind::resultant;
        applied.elements.force = added.force.element;
        applied.elements.at = added.place.element;
        applied.line_by_construction = true;
        applied.line_statement = applied.force_statement = added.statement;
        return applied;
    }
    bool bears_load(MemberIndex member) const {
        return std::any_of(loads_->begin(), loads_->end(), [&](const Load& load) { return load.member == member; });
    }
    /// Sums, arms and strings of a member; what leads the order of its polygon.
    std::vector<const Added*> add_way(MemberIndex member, const Run& run, FreeBody& body) {
        const Group alone{member};
        if (bears_load(member)) {
            for (const Added& moved : model_.moved())
                if (moved.group == alone) body.sums.push_back(applied_sum(moved));
            for (const Lever& shift : model_.shifts())
                if (shift.member == member) add_lever(shift, body);
        }
        std::vector<const Added*> leading;
        for (const Added& added : run.added)
            if (added.group == alone) {
                body.sums.push_back(applied_sum(added));
                leading.push_back(&added);
            }
        for (const Lever& lever : run.levers)
            if (lever.member == member) add_lever(lever, body);
        for (const Strings& strings : run.strings)
            if (strings.group == alone) body.funicular = funicular(strings);
        return leading;
    }
    void add_lever(const Lever& lever, FreeBody& body) {
        if (board_.on_line(lever.about, board_.through(lever.place, board_.direction(lever.force)))) return;
        FreeBody::Arm arm = arm_about(lever.about, lever.force, lever.place, lever.statement, false);
        arm.is_shift = lever.is_shift;
        body.arms.push_back(std::move(arm));
    }
    static FreeBody::Funicular funicular(const Strings& strings) {
        FreeBody::Funicular found;
        found.statement = strings.statement;
        found.first = strings.first;
        found.second = strings.second;
        found.known = strings.known;
        for (const Corner& corner : strings.corners) found.corners.push_back(Recorded<Vector>::at(corner.element));
        for (const PlaceOnDrawing& place : strings.vertices) found.vertices.push_back(Recorded<Vector>::at(place.element));
        found.pole = Recorded<Vector>::at(strings.pole.element);
        found.dividing = Recorded<Vector>::at(strings.dividing.element);
        if (strings.resultant) found.resultant = Recorded<Vector>::at(strings.resultant->element);
        return found;
    }
    /// What was added first comes first, so that the sums are diagonals from the polygon's first corner.
    void put_in_order(std::vector<Side>& sides, const std::vector<const Added*>& leading) {
        sort_round(sides);
        if (leading.empty()) return;
        std::stable_sort(sides.begin(), sides.end(),
                         [&](const Side& a, const Side& b) { return rank_in(leading, a) < rank_in(leading, b); });
    }
    /// By the first sum that it is part of.
    static std::ptrdiff_t rank_in(const std::vector<const Added*>& leading, const Side& side) {
        const auto has_it = [&](const Added* added) {
            return side.bond < 0 || std::find(added->bonds.begin(), added->bonds.end(), side.bond) != added->bonds.end();
        };
        return std::find_if(leading.begin(), leading.end(), has_it) - leading.begin();
    }

    /// As the corners of its rays have them: what is known, the force of the line, that of the place.
    static void put_in_order(std::vector<Side>& sides, const FreeBody::Funicular& funicular) {
        std::stable_sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
            return rank_in(funicular, a.symbol) < rank_in(funicular, b.symbol);
        });
    }
    static std::ptrdiff_t rank_in(const FreeBody::Funicular& funicular, const Symbol& symbol) {
        Symbols order = funicular.known;
        order.push_back(funicular.first);
        order.push_back(funicular.second);
        // What is known was one resultant: its parts come before all.
        const auto found = std::find(order.begin(), order.end(), symbol);
        return found == order.end() ? -1 : found - order.begin();
    }

    // --- bodies that nothing holds ---------------------------------------------------------------------------------------------
    /// All but what bodies exert on each other that are not in equilibrium.
    bool is_complete(const Run& run) const {
        for (std::size_t b = 0; b < model_.joint_bonds(); ++b)
            if (!run.reactions[b].known && unbalanced_.count(model_.bonds()[b].first) == 0) return false;
        return true;
    }

    /// All that is given on a group as one force along a line, one couple, or nothing.
    void resultant(const Loose& loose) {
        const Group& group = loose.group;
        std::vector<const Load*> loads;
        for (const Load& load : model_.loads())
            if (in(group, load.member)) loads.push_back(&load);
        if (loads.empty()) return;
        const auto origin = board_.pole<drawing>();
        std::optional<Force> sum;
        std::optional<ScalarHandle> turn;
        const auto turn_by = [&](ScalarHandle moment) { turn = turn ? board_.sum(*turn, moment) : moment; };
        for (const Load* load : loads) {
            if (load->force) {
                sum = sum ? board_.add(*sum, *load->force) : *load->force;
                turn_by(board_.moment(board_.vector(origin, load->place), *load->force));
            }
            if (load->couple) turn_by(*load->couple);
        }
        const std::optional<Force> force = unless_zero(sum);
        const std::optional<ScalarHandle> couple = unless_zero(turn);
        Resultant result;
        for (const MemberIndex member : group)
            if (!model_.is_pin(member)) result.bodies.push_back(model_.body_of(member));
        result.force = found(force);
        result.couple = found(couple);
        result.vanishes = !force && !couple;
        if (force) {
            const PlaceOnDrawing foot = couple ? board_.carry(origin, board_.arm(*couple, *force)) : origin;
            result.through = Recorded<Vector>::at(foot.element);
        }
        // The freedom of a body on the frame is not balanced, whatever the sum.
        const bool is_free = !loose.balanced && (loose.centre || loose.along);
        if (force && is_free) find_residual(loose, *force, loads, result);
        say_resultant(result, force, couple);
        if (!loose.balanced) {
            unbalanced_.insert(group.begin(), group.end());
            cut_unbalanced(group, loads, result, force, couple);
            if (force && loose.centre && group.size() == 1) turn_by_resultant(result, *loose.centre, *force);
        }
        results_.resultants.push_back(std::move(result));
    }
    /// What is given does on the one freedom that the joints leave: its moment about the centre, or its part along the guide.
    void find_residual(const Loose& loose, Force force, const std::vector<const Load*>& loads, Resultant& result) {
        if (loose.centre) {
            std::optional<ScalarHandle> turn;
            const auto turn_by = [&](ScalarHandle moment) { turn = turn ? board_.sum(*turn, moment) : moment; };
            for (const Load* load : loads) {
                if (load->force) turn_by(board_.moment(board_.vector(*loose.centre, load->place), *load->force));
                if (load->couple) turn_by(*load->couple);
            }
            result.about = Recorded<Vector>::at(loose.centre->element);
            result.residual_couple = found(turn);
            return;
        }
        const Force unit = board_.scale<Plane::force>(board_.number(1), *loose.along);
        const auto start = board_.pole<Plane::force>();
        const auto foot = board_.meet(board_.through(start, *loose.along),
                                      board_.through(board_.carry(start, force), board_.perpendicular(board_.direction(unit))));
        KG_ASSERT(foot, "a line meets one across it");
        result.residual_force = found(std::optional<Force>(board_.vector(start, *foot)));
    }
    /// The arm of the resultant about the place that its body is free to turn about.
    void turn_by_resultant(const Resultant& result, PlaceOnDrawing centre, Force force) {
        FreeBody& body = results_.bodies.back();
        const AppliedForce& applied = body.forces.back();
        const PlaceOnDrawing place{applied.elements.at};
        if (board_.on_line(centre, board_.through(place, board_.direction(force)))) return;
        body.arms.push_back(arm_about(centre, force, place, result.statement, true));
    }
    FreeBody::Arm arm_about(PlaceOnDrawing about, Force force, PlaceOnDrawing place, StatementIndex statement, bool is_sought) {
        FreeBody::Arm arm;
        const ScalarHandle moment = board_.moment(board_.vector(about, place), force);
        arm.name = point_at(about);
        arm.statement = statement;
        arm.is_sought = is_sought;
        arm.elements.about = about.element;
        arm.elements.foot = board_.carry(about, board_.arm(moment, force)).element;
        return arm;
    }
    /// A point of the file that lies there; empty: none does.
    std::string point_at(PlaceOnDrawing place) {
        for (const PointIndex point : indices_of(mechanism_.points))
            if (board_.coincide(board_.place(point), place)) return mechanism_.point(point).name;
        return "";
    }

    // --- bodies that redundant constraints hold
    // ---------------------------------------------------------------------------------
    /// The motion of a sentence, and the arms of what does work in it.
    void virtual_motion(const Released& released) {
        VirtualMotion motion;
        motion.statement = released.statement;
        motion.sought = released.sought;
        if (released.along)
            motion.force = found(released.force);
        else
            motion.couple = found(released.couple);
        for (const Released::Turning& turning : released.members) {
            if (model_.is_pin(turning.member)) continue;
            motion.bodies.push_back({model_.body_of(turning.member), {}});
            if (turning.omega) motion.bodies.back().omega = Recorded<Exact>::at(turning.omega->element);
            if (turning.centre) take_moments(released, turning);
        }
        results_.virtual_motions.push_back(std::move(motion));
    }
    void take_moments(const Released& released, const Released::Turning& turning) {
        const auto free = std::find_if(results_.bodies.begin(), results_.bodies.end(),
                                       [&](const FreeBody& each) { return each.body == model_.body_of(turning.member); });
        if (free == results_.bodies.end()) return;
        const auto add = [&](Force force, PlaceOnDrawing place, bool is_sought) {
            if (board_.on_line(*turning.centre, board_.through(place, board_.direction(force)))) return;
            FreeBody::Arm arm = arm_about(*turning.centre, force, place, released.statement, is_sought);
            arm.name = turning.name;
            free->arms.push_back(std::move(arm));
        };
        for (const Load& load : model_.loads())
            if (load.member == turning.member && load.force) add(*load.force, load.place, false);
        const Bond& bond = model_.bonds()[at(released.bond)];
        const bool bears = bond.first == turning.member || bond.second == turning.member;
        if (bears && released.along && released.force)
            add(board_.scale<Plane::force>(board_.number(1), *released.along), bond.place, true);
    }
    /// What of a reaction equilibrium leaves open: all of it, the component across that which is known, its couple.
    static Symbols open_symbols(const Bond& bond, const Reaction& reaction, bool reversed) {
        Symbols open;
        if (reaction.known) return open;
        Symbol symbol = reversed ? bond.reverse : bond.symbol;
        const bool takes_couple = bond.kind == Bond::Kind::guide || bond.kind == Bond::Kind::clamp;
        if (reaction.alike == Reaction::Alike::component) {
            Symbol across = symbol;
            across.term += (across.term.empty() ? "" : ",") + std::string(reaction.across);
            open.push_back(std::move(across));
        } else if (reaction.alike == Reaction::Alike::nothing) {
            open.push_back(symbol);
        }
        if (takes_couple && !reaction.couple_alike && reaction.alike != Reaction::Alike::nothing) {
            symbol.letter = Symbol::Letter::M;
            open.push_back(std::move(symbol));
        }
        return open;
    }

    template <class Handle>
    std::optional<Handle> unless_zero(const std::optional<Handle>& value) {
        return value && !board_.is_zero(*value) ? value : std::nullopt;
    }
    static Symbol resultant_symbol(bool is_force) {
        return {is_force ? Symbol::Letter::F : Symbol::Letter::M, is_force ? "F_R" : "M_R", {}};
    }
    void say_resultant(Resultant& result, const std::optional<Force>& force, const std::optional<ScalarHandle>& couple) {
        std::string names;
        for (const BodyIndex body : result.bodies) names += (names.empty() ? "" : " + ") + mechanism_.body(body).name;
        Statement statement;
        statement.section = Topic::forces;
        statement.bodies = result.bodies;
        statement.message = {Sentence::in_equilibrium, {BodyName{names}}};
        const Symbol resultant = resultant_symbol(true);
        if (result.residual_couple) {
            const std::string centre = point_at({result.about.element()});
            statement.message = {Sentence::residual_couple,
                                 {BodyName{names}, resultant, PointName{centre}, Symbol{Symbol::Letter::M, centre, {}}}};
            statement.finds.push_back({.kind = Quantity::Kind::resultant, .body = result.bodies.front()});
        } else if (result.residual_force) {
            Symbol along = resultant;
            along.term = "t";
            statement.message = {Sentence::residual_force, {BodyName{names}, resultant, along}};
            statement.finds.push_back({.kind = Quantity::Kind::resultant, .body = result.bodies.front()});
        } else if (force || couple) {
            statement.message.sentence = force ? Sentence::resultant_force : Sentence::resultant_couple;
            statement.message.arguments.emplace_back(resultant_symbol(force.has_value()));
            statement.finds.push_back({.kind = Quantity::Kind::resultant, .body = result.bodies.front()});
        }
        result.statement = board_.state(std::move(statement));
    }

    /// What acts on each, and the polygon with its gap: on one body among its forces, else of all together.
    void cut_unbalanced(const Group& group, const std::vector<const Load*>& loads, Resultant& result,
                        const std::optional<Force>& force, const std::optional<ScalarHandle>& couple) {
        const bool alone = group.size() == 1;
        std::vector<Side> sides;
        for (const MemberIndex member : group) {
            FreeBody body = empty_body(member);
            body.statement = result.statement;
            for (const Load* load : loads) {
                if (load->member != member) continue;
                AppliedForce applied = applied_load(*load);
                if (load->force) sides.push_back({applied.symbol, *load->force, -1, true, quantity_of(body, applied)});
                body.forces.push_back(std::move(applied));
            }
            if (alone) body.forces.push_back(applied_resultant(*loads.front(), result.statement, force, couple));
            if (!body.forces.empty()) results_.bodies.push_back(std::move(body));
        }
        if (sides.empty()) return;
        const std::string id = (alone ? "forces-" : "resultant-") + model_.member_name(group.front());
        result.polygon = add_force_polygon(alone ? Polygon::Kind::body_forces : Polygon::Kind::joined_forces, id);
        draw_open_polygon(result.polygon, group, sides, force);
        if (alone) results_.bodies.back().polygon = result.polygon;
    }
    /// On its line, at the foot of the perpendicular from where the first load acts.
    AppliedForce applied_resultant(const Load& first, StatementIndex statement, const std::optional<Force>& force,
                                   const std::optional<ScalarHandle>& couple) {
        AppliedForce applied;
        applied.kind = AppliedForce::Kind::resultant;
        applied.symbol = resultant_symbol(force.has_value());
        applied.line_statement = applied.force_statement = statement;
        applied.line_by_construction = force.has_value();
        applied.elements.at = first.place.element;
        if (!force) {
            applied.elements.couple = couple->element;
            return applied;
        }
        applied.elements.force = force->element;
        const ScalarHandle there = board_.moment(board_.vector(first.place, board_.pole<drawing>()), *force);
        const ScalarHandle about = couple ? board_.sum(*couple, there) : there;
        if (!board_.is_zero(about)) applied.elements.at = board_.carry(first.place, board_.arm(about, *force)).element;
        return applied;
    }
    void draw_open_polygon(int polygon, const Group& group, const std::vector<Side>& sides, const std::optional<Force>& force) {
        const Corner start = board_.pole<Plane::force>();
        Corner here = start;
        Face face;
        face.body = model_.body_of(group.front());
        for (const Side& side : sides) {
            const Corner next = board_.carry(here, side.force);
            draw_side(polygon, side, group.front(), here, next);
            face.corners.push_back(here.element);
            here = next;
        }
        if (force) {
            const Quantity quantity{.kind = Quantity::Kind::resultant, .body = face.body};
            draw_side(polygon, {resultant_symbol(true), *force, -1, true, quantity}, group.front(), start,
                      board_.carry(start, *force));
            face.corners.push_back(here.element);
        }
        // A face for each body would say that they were closed one by one.
        if (group.size() > 1) face.corners = {start.element, here.element};
        board_.add_face(polygon, face);
        if (group.size() > 1) board_.add_face(polygon, std::move(face));
    }

    FreeBody empty_body(MemberIndex member) const {
        FreeBody body;
        if (model_.is_pin(member)) {
            body.pin = model_.pin_point(member);
        } else {
            body.body = model_.body_of(member);
        }
        return body;
    }
    static AppliedForce applied_load(const Load& load) {
        AppliedForce applied;
        applied.symbol = load.symbol;
        applied.kind = load.kind;
        applied.given = load.given;
        applied.elements.at = load.place.element;
        if (load.couple) applied.elements.couple = load.couple->element;
        if (load.force) applied.elements.force = load.force->element;
        return applied;
    }

    /// Members that do not balance though all their bonds are known, and what hangs on them by known bonds (not through the
    /// frame): of these nothing is known.
    std::set<MemberIndex> out_of_equilibrium(const Run& run) {
        Group found;
        for (const MemberIndex member : model_.moving_members()) {
            const auto& bonds = model_.bonds_of(member);
            const bool all_known = std::all_of(bonds.begin(), bonds.end(), [&](int b) { return run.reactions[at(b)].known; });
            if (all_known && !model_.known_on({member}, *loads_, run).vanishes()) found.push_back(member);
        }
        std::set<MemberIndex> open(found.begin(), found.end());
        for (std::size_t next = 0; next < found.size(); ++next) {
            for (const int b : model_.bonds_of(found[next])) {
                const Bond& bond = model_.bonds()[at(b)];
                const MemberIndex other = bond.first == found[next] ? bond.second : bond.first;
                if (other != member_of(frame) && run.reactions[at(b)].known && open.insert(other).second) found.push_back(other);
            }
        }
        return open;
    }

    /// A contact that would have to pull.
    void remark_lift_off(const Run& run) {
        for (std::size_t b = 0; b < model_.joint_bonds(); ++b) {
            const JointIndex joint = model_.bonds()[b].joint;
            if (joint != none && mechanism_.joints[at(joint)].pushes && model_.pulls(b, run))
                results_.remarks.push_back({Sentence::lift_off, {file_name(mechanism_.joints[at(joint)])}});
        }
    }

    /// Why the forces are not determined; `open`: which ones, where some are.
    Message reason(const Run& run, Symbols open) const {
        if (run.beyond_members > 0)
            return {Sentence::beyond_members, {Count{static_cast<int>(run.beyond_members)}, std::move(open)}};
        const auto efforts = static_cast<int>(mechanism_.efforts.size());
        const Count freedoms{mobility_.effective};
        if (efforts < mobility_.effective) return {Sentence::unbalanced, {freedoms, Count{efforts}, std::move(open)}};
        if (efforts > mobility_.effective) return {Sentence::too_many_efforts, {Count{efforts}, freedoms, std::move(open)}};
        int repeated = 0;
        Names joints;
        for (const Mobility::Redundant& redundant : mobility_.redundant) {
            repeated += redundant.rows;
            joints.push_back(mechanism_.joints[at(redundant.joint)].name);
        }
        if (repeated > 0) return {Sentence::indeterminate, {Count{repeated}, std::move(joints), std::move(open)}};
        return {efforts > 0 ? Sentence::effort_without_work : Sentence::beyond_trials, {std::move(open)}};
    }

    void explain(const Run& run, bool balanced) {
        Symbols open;
        for (std::size_t b = 0; b < model_.bonds().size() && balanced; ++b) {
            for (Symbol& symbol : open_symbols(model_.bonds()[b], run.reactions[b], model_.bonds()[b].first == member_of(frame)))
                open.push_back(std::move(symbol));
        }
        results_.unsolved.push_back({{Sentence::all_forces, {}}, reason(run, std::move(open))});
    }

    static Recorded<Vector> found(const std::optional<Force>& force) {
        return force ? Recorded<Vector>::at(force->element) : Recorded<Vector>::zero();
    }
    static Recorded<Exact> found(const std::optional<ScalarHandle>& couple) {
        return couple ? Recorded<Exact>::at(couple->element) : Recorded<Exact>::zero();
    }

    void collect(const Bond& bond, const Reaction& reaction, bool valid) {
        if (bond.effort >= 0) {
            EffortValue result;
            result.name = std::visit([](const auto& effort) { return effort.name; }, mechanism_.efforts[at(bond.effort)]);
            if (valid && reaction.known) {
                if (bond.kind == Bond::Kind::couple) {
                    result.value = found(reaction.couple);
                } else if (reaction.force) {
                    // In units of the direction, which is a unit vector.
                    const Force unit = board_.scale<Plane::force>(board_.number(1), bond.direction);
                    result.value = Recorded<Exact>::at(board_.ratio(*reaction.force, unit).element);
                } else {
                    result.value = Recorded<Exact>::zero();
                }
            }
            results_.efforts.push_back(std::move(result));
            return;
        }
        JointForce on_first;
        on_first.joint = bond.joint;
        on_first.on = model_.body_of(bond.first);
        on_first.from = model_.body_of(bond.second);
        if (valid && reaction.known) {
            on_first.force = found(reaction.force);
            on_first.couple = found(reaction.couple);
        } else if (valid) {
            if (reaction.alike == Reaction::Alike::force) on_first.force = found(reaction.force);
            if (reaction.alike == Reaction::Alike::component) {
                on_first.component = found(reaction.force);
                on_first.along = Recorded<Vector>::at(reaction.along->element);
            }
            const bool bears_none = bond.kind != Bond::Kind::guide && bond.kind != Bond::Kind::clamp;
            if (reaction.couple_alike || (bears_none && reaction.alike != Reaction::Alike::nothing))
                on_first.couple = found(reaction.couple);
        }
        results_.joints.push_back(on_first);
        if (model_.is_pin(bond.second)) return;
        JointForce on_second = on_first;
        std::swap(on_second.on, on_second.from);
        if (on_second.force && reaction.force) on_second.force = found(board_.negate(*reaction.force));
        if (on_second.component && reaction.force) on_second.component = found(board_.negate(*reaction.force));
        if (on_second.couple && reaction.couple) on_second.couple = found(board_.opposite(*reaction.couple));
        results_.joints.push_back(on_second);
    }

    void free_body(MemberIndex member, const Run& run) {
        FreeBody body = empty_body(member);
        std::vector<Side> sides;
        body.in_parts = run.in_parts;
        const auto apply = [&](AppliedForce applied, const std::optional<Force>& force, int bond) {
            if (force) {
                applied.elements.force = force->element;
                const bool external = bond < 0 || model_.bonds()[at(bond)].first == member_of(frame) ||
                                      model_.bonds()[at(bond)].second == member_of(frame);
                sides.push_back({applied.symbol, *force, bond, external, quantity_of(body, applied)});
            }
            if (applied.elements.force != none || applied.elements.couple != none) body.forces.push_back(std::move(applied));
        };
        for (const Load& load : *loads_) {
            if (load.member != member) continue;
            apply(applied_load(load), load.force, -1);
        }
        for (const int b : model_.bonds_of(member)) {
            const Bond& bond = model_.bonds()[at(b)];
            const Reaction& reaction = run.reactions[at(b)];
            const bool reversed = bond.second == member;
            for (Symbol& symbol : open_symbols(bond, reaction, reversed)) body.open.push_back(std::move(symbol));
            if (!reaction.known && reaction.alike == Reaction::Alike::nothing && !reaction.couple_alike) continue;
            AppliedForce applied;
            applied.symbol = marked(reversed ? bond.reverse : bond.symbol, mark_);
            applied.is_component = !reaction.known;
            if (reaction.alike == Reaction::Alike::component && !reaction.known)
                applied.symbol.term += (applied.symbol.term.empty() ? "" : ",") + std::string(reaction.axis);
            applied.kind = bond.effort >= 0 ? AppliedForce::Kind::effort : AppliedForce::Kind::reaction;
            applied.joint = bond.joint;
            applied.given = bond.effort;
            if (bond.effort < 0) applied.line_statement = reaction.line_statement;
            applied.force_statement = reaction.force_statement;
            body.statement = std::max(body.statement, reaction.force_statement);
            applied.from = model_.body_of(reversed ? bond.first : bond.second);
            applied.elements.at = bond.place.element;
            applied.line_by_construction = reaction.deduced;
            std::optional<Force> force;
            if (reaction.force) force = reversed ? board_.negate(*reaction.force) : *reaction.force;
            if (reaction.couple) {
                const ScalarHandle couple = reversed ? board_.opposite(*reaction.couple) : *reaction.couple;
                // A force with a couple is the same force moved aside: its real line. A part of a force has none.
                if (force && reaction.known) {
                    applied.elements.at = board_.carry(bond.place, board_.arm(couple, *force)).element;
                } else {
                    applied.elements.couple = couple.element;
                }
            }
            apply(std::move(applied), force, b);
        }
        list_meets(member, body);
        const std::vector<const Added*> leading = add_way(member, run, body);
        const bool whole = is_whole(member, run);
        if (!whole) body.statement = none;  // no one sentence closes it
        if (!sides.empty() && whole) {
            put_in_order(sides, leading);
            if (body.funicular) put_in_order(sides, *body.funicular);
            body.polygon = draw_polygon(member, sides);
            sides_.emplace_back(member, std::move(sides));
        }
        if (!body.forces.empty()) results_.bodies.push_back(std::move(body));
    }

    /// The points of concurrency used at a member.
    void list_meets(MemberIndex member, FreeBody& body) const {
        const auto meets = meets_.find(member);
        if (meets == meets_.end()) return;
        for (const NamedMeet& meet : meets->second) {
            const bool listed =
                std::any_of(body.meets.begin(), body.meets.end(), [&](const auto& m) { return m.name == meet.name; });
            const bool alone = first_ != none;  // these loads, by the sentences that speak of them
            if (listed || (alone && (meet.used < first_ || !(meet.used < end_)))) continue;
            body.meets.push_back({meet.name, {}, alone ? meet.used : meet.statement, meet.place.element});
        }
    }

    /// Counter-clockwise by direction from the first on: the polygon is convex, and neighbours lie on the far sides of common
    /// forces.
    void sort_round(std::vector<Side>& sides) {
        const Force first = sides.front().force;
        const auto half = [&](Force v) {
            const int turned = board_.choose_turn(first, v);
            return turned > 0 || (turned == 0 && board_.choose_along(first, v) > 0) ? 0 : 1;
        };
        std::stable_sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
            if (half(a.force) != half(b.force)) return half(a.force) < half(b.force);
            return board_.choose_turn(a.force, b.force) > 0;
        });
    }

    int add_force_polygon(Polygon::Kind kind, std::string id) {
        Polygon polygon;
        polygon.kind = kind;
        polygon.plane = Plane::force;
        polygon.id = std::move(id);
        return board_.add_polygon(std::move(polygon));
    }

    void draw_side(int polygon, const Side& side, MemberIndex member, Corner tail, Corner tip) {
        DrawnVector drawn;
        drawn.symbol = side.symbol;
        drawn.polygon = polygon;
        drawn.tail = tail.element;
        drawn.tip = tip.element;
        drawn.body = model_.body_of(member);
        drawn.quantity = side.quantity;
        drawn.role = side.external ? DrawnVector::Role::external : DrawnVector::Role::internal;
        board_.draw(std::move(drawn));
    }

    /// Tip to tail: the forces of a body in equilibrium close.
    int draw_polygon(MemberIndex member, const std::vector<Side>& sides) {
        const int polygon = add_force_polygon(Polygon::Kind::body_forces, "forces-" + model_.member_name(member) + suffix());
        place_sides(polygon, member, sides, 0, board_.pole<Plane::force>(), -1);
        return polygon;
    }

    /// Sets the sides off from `start`, beginning with the one at `from`; the side of the bond `shared` is there already.
    /// Returns the tails of the sides, in their order.
    std::vector<Corner> place_sides(int polygon, MemberIndex member, const std::vector<Side>& sides, std::size_t from,
                                    Corner start, int shared) {
        std::vector<Corner> tails(sides.size());
        Face face;
        face.body = model_.body_of(member);
        Corner here = start;
        for (std::size_t n = 0; n < sides.size(); ++n) {
            const std::size_t i = (from + n) % sides.size();
            const Corner next = n + 1 == sides.size() ? start : board_.carry(here, sides[i].force);
            if (n + 1 == sides.size()) {
                KG_ASSERT(board_.coincide(board_.carry(here, sides[i].force), start),
                          "the forces of a body in equilibrium close");
            }
            if (shared < 0 || sides[i].bond != shared) draw_side(polygon, sides[i], member, here, next);
            tails[i] = here;
            face.corners.push_back(here.element);
            here = next;
        }
        board_.add_face(polygon, std::move(face));
        return tails;
    }

    /// The triangles laid side by side on their common forces, so that the external forces close.
    void join_polygons() {
        std::set<MemberIndex> placed;
        int count = 0;
        for (std::size_t first = 0; first < sides_.size(); ++first) {
            if (placed.count(sides_[first].first) != 0 || sides_.size() < 2) continue;
            const int polygon =
                add_force_polygon(Polygon::Kind::joined_forces, count == 0 ? "closure" : "closure-" + std::to_string(count + 1));
            ++count;
            struct Open {
                std::size_t index, from;
                Corner start;
                int shared;
            };
            std::vector<Open> open{{first, 0, board_.pole<Plane::force>(), -1}};
            placed.insert(sides_[first].first);
            for (std::size_t next = 0; next < open.size(); ++next) {
                const Open here = open[next];
                const auto& [member, sides] = sides_[here.index];
                const std::vector<Corner> tails = place_sides(polygon, member, sides, here.from, here.start, here.shared);
                for (std::size_t i = 0; i < sides.size(); ++i) {
                    if (sides[i].external) continue;
                    const Bond& bond = model_.bonds()[at(sides[i].bond)];
                    const MemberIndex other = bond.first == member ? bond.second : bond.first;
                    if (placed.count(other) != 0) continue;
                    for (std::size_t k = 0; k < sides_.size(); ++k) {
                        if (sides_[k].first != other) continue;
                        const auto& across = sides_[k].second;
                        for (std::size_t m = 0; m < across.size(); ++m) {
                            if (across[m].bond != sides[i].bond) continue;
                            placed.insert(other);
                            open.push_back({k, m, tails[(i + 1) % sides.size()], sides[i].bond});
                        }
                    }
                }
            }
        }
    }

    ForceModel& model_;
    Board& board_;
    const Mechanism& mechanism_;
    const Mobility& mobility_;
    const NamedMeets& meets_;
    const std::vector<Loose>& loose_;
    bool one_by_one_;
    const std::vector<Load>* loads_;                                ///< all, or those that act alone
    std::string mark_;                                              ///< of the member that bears these; empty: all act
    StatementIndex first_ = none, end_ = none;                      ///< and its sentences
    std::vector<std::pair<MemberIndex, std::vector<Side>>> sides_;  ///< by member, in the order resolved
    std::set<MemberIndex> unbalanced_;                              ///< floating, and what is given on them does not balance
    ForceResults results_;
};

}  // namespace

void note_first_use_of_lines(std::vector<FreeBody>& bodies, const Pose& pose) {
    // On rounded data a line passes a place that is as near as their precision, amplified a little, makes it.
    constexpr double amplified = 64;
    const auto passes = [&](const AppliedForce& applied, const Vector& place) {
        const Exact moment = cross(applied.force, place - applied.at);
        return moment.is_zero() || (pose.is_rounded() && std::abs(moment.to_double()) <=
                                                             amplified * pose.precision.to_double() * length(applied.force));
    };
    for (FreeBody& body : bodies) {
        for (AppliedForce& applied : body.forces) {
            if (applied.kind == AppliedForce::Kind::reaction || applied.kind == AppliedForce::Kind::resultant) continue;
            for (const FreeBody::Meet& meet : body.meets) {
                if (!passes(applied, meet.place)) continue;
                if (applied.line_statement == none || meet.statement < applied.line_statement)
                    applied.line_statement = meet.statement;
            }
        }
    }
}

ForceResults cut_free(ForceModel& model, Board& board, const Mechanism& mechanism, const Mobility& mobility, const Run& run,
                      const NamedMeets& meets, const std::vector<Loose>& loose, bool one_by_one) {
    return FreeBodies(model, board, mechanism, mobility, meets, loose, one_by_one).cut(run);
}

}  // namespace kinegraph::statics
