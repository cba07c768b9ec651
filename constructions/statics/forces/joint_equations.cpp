#include "constructions/statics/forces/joint_equations.hpp"
#include "lang/keys/sentences.hpp"

#include <algorithm>
#include <utility>

namespace kinegraph::statics {

bool JointEquations::advance(const std::vector<Load>& loads, Run& run) {
    const Board::Mark before = board_.mark();
    const System all = system(loads, run);
    for (const SolvableBlock& block : blocks(all)) {
        const auto values = solve(all, block);
        if (!values) continue;
        say(all, block, *values);
        settle(all, block, *values, run);
        return true;
    }
    board_.rewind(before);
    return false;
}

// --- unknowns and equations

JointEquations::System JointEquations::system(const std::vector<Load>& loads, const Run& run) {
    System all;
    std::set<int> taken;
    Group others;
    for (const MemberIndex member : model_.moving_members()) {
        const auto& bonds = model_.bonds_of(member);
        const bool open = std::any_of(bonds.begin(), bonds.end(), [&](int b) { return !run.reactions[at(b)].known; });
        if (open && !add_link(member, loads, run, taken, all)) others.push_back(member);
    }
    for (std::size_t b = 0; b < model_.bonds().size(); ++b)
        if (!run.reactions[b].known && taken.count(static_cast<int>(b)) == 0) add_unknowns(static_cast<int>(b), all);
    for (const MemberIndex member : others) add_equations(member, loads, run, all);
    return all;
}

bool JointEquations::add_link(MemberIndex member, const std::vector<Load>& loads, const Run& run, std::set<int>& taken,
                              System& system) {
    const std::vector<int> unknown = known_.unknown_of({member}, run);
    if (unknown.size() != 2) return false;
    const auto &one = run.reactions[at(unknown[0])].action, &two = run.reactions[at(unknown[1])].action;
    if (!one || !two || taken.count(unknown[0]) + taken.count(unknown[1]) > 0) return false;
    if (!board_.parallel(one->line, two->line) || !board_.on_line(two->place, one->line)) return false;
    if (!model_.known_on({member}, loads, run).vanishes()) return false;
    Unknown link;
    link.bonds = unknown;
    link.link = member;
    link.unit = board_.scale<Plane::force>(board_.number(1), one->direction);
    link.place = one->place;
    for (const int b : unknown) {
        const Bond& bond = model_.bonds()[at(b)];
        link.ends.push_back({bond.first == member ? bond.second : bond.first, b == unknown[0]});
        taken.insert(b);
    }
    system.unknowns.push_back(std::move(link));
    return true;
}

void JointEquations::add_unknowns(int b, System& system) {
    const Bond& bond = model_.bonds()[at(b)];
    const auto add = [&](std::optional<DirectionHandle> along) {
        Unknown each;
        each.bonds = {b};
        if (along) each.unit = board_.scale<Plane::force>(board_.number(1), *along);
        each.place = bond.place;
        each.ends = {{bond.first, false}, {bond.second, true}};
        system.unknowns.push_back(std::move(each));
    };
    if (bond.kind == Bond::Kind::line || bond.kind == Bond::Kind::guide) add(bond.direction);
    if (bond.kind == Bond::Kind::pin || bond.kind == Bond::Kind::clamp)
        for (const Vector& axis : {Vector{1, 0}, Vector{0, 1}}) add(board_.own_direction(axis));
    if (bond.kind == Bond::Kind::couple || bond.kind == Bond::Kind::guide || bond.kind == Bond::Kind::clamp)
        add(std::nullopt);
}

PlaceOnDrawing JointEquations::moments_about(MemberIndex member, const System& system) const {
    std::map<ElementIndex, int> passing;
    PlaceOnDrawing best = board_.place(PointIndex(0));
    int most = 0;
    for (const Unknown& unknown : system.unknowns)
        for (const Unknown::End& end : unknown.ends) {
            if (end.member != member || !unknown.unit) continue;
            const int count = ++passing[unknown.place.element];
            if (count <= most) continue;
            most = count;
            best = unknown.place;
        }
    return best;
}

void JointEquations::add_equations(MemberIndex member, const std::vector<Load>& loads, const Run& run, System& system) {
    const PlaceOnDrawing about = moments_about(member, system);
    const auto left = model_.gap(member, loads, run, about);
    std::vector<Equation> rows(model_.is_pin(member) ? 2 : 3);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].member = member;
        if (!board_.is_zero(left[i])) rows[i].known = left[i];
    }
    for (std::size_t u = 0; u < system.unknowns.size(); ++u) {
        const Unknown& unknown = system.unknowns[u];
        for (const Unknown::End& end : unknown.ends) {
            if (end.member != member) continue;
            const auto enter = [&](std::size_t i, ScalarHandle value) {
                if (!board_.is_zero(value)) rows[i].terms.emplace(u, end.reversed ? board_.opposite(value) : value);
            };
            if (!unknown.unit) {
                enter(2, board_.number(1));
                continue;
            }
            enter(0, board_.moment(board_.own_direction({0, -1}), *unknown.unit));
            enter(1, board_.moment(board_.own_direction({1, 0}), *unknown.unit));
            if (rows.size() > 2 && unknown.place.element != about.element)
                enter(2, board_.moment(board_.vector(about, unknown.place), *unknown.unit));
        }
    }
    for (Equation& row : rows) system.equations.push_back(std::move(row));
}

std::vector<SolvableBlock> JointEquations::blocks(const System& system) {
    std::vector<std::vector<std::size_t>> unknowns_in;
    std::vector<std::size_t> member_of_equation;
    for (const Equation& equation : system.equations) {
        unknowns_in.emplace_back();
        for (const auto& [unknown, coefficient] : equation.terms) unknowns_in.back().push_back(unknown);
        member_of_equation.push_back(at(equation.member));
    }
    return solvable_blocks(unknowns_in, member_of_equation, system.unknowns.size());
}

// --- elimination

std::size_t JointEquations::pivot(const std::vector<Equation>& rows, const std::set<std::size_t>& left,
                                  std::size_t unknown) {
    const auto as_force = [&](std::size_t row) {
        return board_.scale<Plane::force>(rows[row].terms.at(unknown), board_.own_direction({1, 0}));
    };
    std::optional<std::size_t> best;
    for (const std::size_t row : left)
        if (!best || board_.choose_longer(as_force(row), as_force(*best))) best = row;
    return *best;
}

void JointEquations::subtract(Equation& row, const Equation& other, ScalarHandle factor, std::size_t unknown) {
    const auto less = [&](const Cell& from, ScalarHandle what) -> Cell {
        const ScalarHandle product = board_.product(factor, what);
        if (!from) return board_.opposite(product);
        const ScalarHandle rest = board_.difference(*from, product);
        return board_.is_zero(rest) ? Cell() : rest;
    };
    row.terms.erase(unknown);
    for (const auto& [other_unknown, coefficient] : other.terms) {
        if (other_unknown == unknown) continue;
        const auto here = row.terms.find(other_unknown);
        const Cell rest = less(here == row.terms.end() ? Cell() : here->second, coefficient);
        if (here != row.terms.end()) row.terms.erase(here);
        if (rest) row.terms.emplace(other_unknown, *rest);
    }
    if (other.known) row.known = less(row.known, *other.known);
}

/// Each time the unknown that occurs in fewest equations is eliminated: little fills in.
std::optional<JointEquations::Values> JointEquations::solve(const System& system, const SolvableBlock& block) {
    std::vector<Equation> rows;
    for (const std::size_t e : block.equations) rows.push_back(system.equations[e]);
    std::map<std::size_t, std::set<std::size_t>> rows_with;  // by unknown that is not yet eliminated
    for (const std::size_t u : block.unknowns) rows_with[u];
    for (std::size_t r = 0; r < rows.size(); ++r)
        for (const auto& [u, coefficient] : rows[r].terms) rows_with[u].insert(r);
    std::vector<std::pair<std::size_t, std::size_t>> pivots;
    while (!rows_with.empty()) {
        const auto fewest = std::min_element(rows_with.begin(), rows_with.end(), [](const auto& a, const auto& b) {
            return a.second.size() < b.second.size();
        });
        const auto [unknown, with] = *fewest;
        if (with.empty()) return std::nullopt;
        const std::size_t chosen = pivot(rows, with, unknown);
        rows_with.erase(fewest);
        const auto each_term = [&](std::size_t row, auto change) {
            for (const auto& [u, coefficient] : rows[row].terms)
                if (const auto found = rows_with.find(u); found != rows_with.end()) change(found->second);
        };
        each_term(chosen, [&](auto& set) { set.erase(chosen); });
        for (const std::size_t row : with) {
            if (row == chosen) continue;
            each_term(row, [&](auto& set) { set.erase(row); });
            subtract(rows[row], rows[chosen],
                     board_.quotient(rows[row].terms.at(unknown), rows[chosen].terms.at(unknown)), unknown);
            each_term(row, [&](auto& set) { set.insert(row); });
        }
        pivots.emplace_back(chosen, unknown);
    }
    Values values;
    std::reverse(pivots.begin(), pivots.end());
    for (const auto& [chosen, unknown] : pivots) {
        Cell sum = rows[chosen].known;
        for (const auto& [u, coefficient] : rows[chosen].terms) {
            if (u == unknown || !values.of.at(u)) continue;
            const ScalarHandle term = board_.product(coefficient, *values.of.at(u));
            sum = sum ? board_.sum(*sum, term) : term;
        }
        if (sum && board_.is_zero(*sum)) sum.reset();
        if (sum) sum = board_.opposite(board_.quotient(*sum, rows[chosen].terms.at(unknown)));
        values.of.emplace(unknown, sum);
        values.order.push_back(unknown);
    }
    return values;
}

// --- results

void JointEquations::say(const System& system, const SolvableBlock& block, const Values& values) {
    Group group;
    for (const std::size_t e : block.equations)
        if (!in(group, system.equations[e].member)) group.push_back(system.equations[e].member);
    std::sort(group.begin(), group.end());
    Symbols found;
    for (const std::size_t u : values.order)
        for (const int b : system.unknowns[u].bonds) {
            const Bond& bond = model_.bonds()[at(b)];
            const bool within = in(group, bond.first) || in(group, bond.second);
            Symbol symbol = said_.symbol_on(b, within ? group : Group{bond.first});
            if (within && std::find(found.begin(), found.end(), symbol) == found.end())
                found.push_back(std::move(symbol));
        }
    // More than a line of symbols would not be read.
    constexpr std::size_t most_symbols = 12;
    if (found.size() > most_symbols) found.clear();
    said_.say_of(group, lang::sentences::equations_together,
                 {Count{static_cast<int>(block.equations.size())}, std::move(found)});
}

void JointEquations::settle(const System& system, const SolvableBlock& block, const Values& values, Run& run) {
    struct Part {
        std::optional<Force> force;
        Cell couple;
    };
    std::map<int, Part> parts;
    for (const std::size_t u : block.unknowns) {
        const Unknown& unknown = system.unknowns[u];
        const Cell value = values.of.at(u);
        if (unknown.link) {
            const Group alone{*unknown.link};
            for (const int b : unknown.bonds) {
                if (!value) {
                    settled_.found(b, alone, run);
                    continue;
                }
                const Force force = board_.scale<Plane::force>(*value, board_.direction(*unknown.unit));
                settled_.settle(b, b == unknown.bonds.front() ? force : board_.negate(force), unknown.place, alone,
                                run);
            }
            known_.note(alone, run);
            continue;
        }
        Part& part = parts[unknown.bonds.front()];
        if (!value) continue;
        if (!unknown.unit) {
            part.couple = value;
            continue;
        }
        const Force force = board_.scale<Plane::force>(*value, board_.direction(*unknown.unit));
        part.force = part.force ? board_.add(*part.force, force) : force;
    }
    for (const auto& [b, part] : parts) {
        const Bond& bond = model_.bonds()[at(b)];
        const Group on{bond.first};
        if (part.force && part.couple)
            settled_.settle_with_couple(b, *part.force, *part.couple, on, run);
        else if (part.force)
            settled_.settle(b, *part.force, bond.place, on, run);
        else if (part.couple)
            settled_.settle_couple(b, *part.couple, on, run);
        else
            settled_.found(b, on, run);
    }
    for (const std::size_t e : block.equations) known_.note({system.equations[e].member}, run);
}

}  // namespace kinegraph::statics
