#include "constructions/statics/equilibria.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "engine/number/assert.hpp"

namespace kinegraph::statics {

Equilibria::Equilibria(const ForceModel& model, Board& board, const Run& run, Group group, PlaceOnDrawing origin,
                       const std::function<Gap(MemberIndex)>& gap)
    : model_(model), board_(board), group_(std::move(group)), origin_(origin) {
    std::set<int> bonds;
    for (const MemberIndex member : group_) {
        const std::size_t first = rows_.size(), count = model_.is_pin(member) ? 2 : 3;
        first_row_.emplace(member, first);
        rows_.resize(first + count);
        const Gap left = gap(member);
        for (std::size_t i = 0; i < count; ++i)
            if (!board_.is_zero(left[i])) rows_[first + i].power = left[i];
        for (const int b : model_.bonds_of(member))
            if (!run.reactions[at(b)].known) bonds.insert(b);
    }
    for (const int b : bonds) add_columns(b);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        rows_[i].work.resize(columns_.size());
        if (!follows_motions()) continue;
        rows_[i].motion.resize(rows_.size());
        rows_[i].motion[i] = board_.number(1);
    }
    for (std::size_t c = 0; c < columns_.size(); ++c) write(columns_[c], c);
    eliminate();
}

void Equilibria::add_columns(int bond) {
    const Bond& here = model_.bonds()[at(bond)];
    const auto unit = [&](DirectionHandle along) { return board_.scale<Plane::force>(board_.number(1), along); };
    if (here.kind == Bond::Kind::line || here.kind == Bond::Kind::guide)
        columns_.push_back({bond, unit(here.direction)});
    if (here.kind == Bond::Kind::pin || here.kind == Bond::Kind::clamp)
        for (const Vector& axis : {Vector{1, 0}, Vector{0, 1}})
            columns_.push_back({bond, unit(board_.own_direction(axis))});
    if (here.kind == Bond::Kind::couple || here.kind == Bond::Kind::guide || here.kind == Bond::Kind::clamp)
        columns_.push_back({bond, std::nullopt});
}

void Equilibria::write(const Column& column, std::size_t index) {
    const Bond& bond = model_.bonds()[at(column.bond)];
    write_end(column, index, bond.first, false);
    write_end(column, index, bond.second, true);
}

void Equilibria::write_end(const Column& column, std::size_t index, MemberIndex member, bool reversed) {
    const auto found = first_row_.find(member);
    if (found == first_row_.end()) return;
    const auto enter = [&](std::size_t i, ScalarHandle value) {
        if (!board_.is_zero(value)) rows_[found->second + i].work[index] = reversed ? board_.opposite(value) : value;
    };
    if (!column.unit) return enter(2, board_.number(1));
    enter(0, board_.moment(board_.own_direction({0, -1}), *column.unit));
    enter(1, board_.moment(board_.own_direction({1, 0}), *column.unit));
    if (model_.is_pin(member)) return;
    const PlaceOnDrawing place = model_.bonds()[at(column.bond)].place;
    if (!board_.coincide(place, origin_)) enter(2, board_.moment(board_.vector(origin_, place), *column.unit));
}

// --- elimination

Equilibria::Cell Equilibria::times(const Cell& factor, const Cell& what) {
    if (!factor || !what) return {};
    return board_.product(*factor, *what);
}

Equilibria::Cell Equilibria::minus_times(const Cell& from, const Cell& factor, const Cell& what) {
    const Cell product = times(factor, what);
    if (!product) return from;
    if (!from) return board_.opposite(*product);
    const ScalarHandle left = board_.difference(*from, *product);
    return board_.is_zero(left) ? Cell() : left;
}

void Equilibria::divide(Row& row, ScalarHandle by) {
    const auto each = [&](Cell& cell) {
        if (cell) cell = board_.quotient(*cell, by);
    };
    std::for_each(row.work.begin(), row.work.end(), each);
    std::for_each(row.motion.begin(), row.motion.end(), each);
    each(row.power);
}

void Equilibria::subtract(Row& row, const Row& other, ScalarHandle factor) {
    const auto each = [&](std::vector<Cell>& to, const std::vector<Cell>& what) {
        for (std::size_t i = 0; i < to.size(); ++i) to[i] = minus_times(to[i], factor, what[i]);
    };
    each(row.work, other.work);
    each(row.motion, other.motion);
    row.power = minus_times(row.power, factor, other.power);
}

/// The largest, so that a value near the rounding error of the data is not chosen.
std::optional<std::size_t> Equilibria::pivot_row(std::size_t column) {
    const auto as_force = [&](ScalarHandle value) {
        return board_.scale<Plane::force>(value, board_.own_direction({1, 0}));
    };
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i].pivot >= 0 || !rows_[i].work[column]) continue;
        if (!best || board_.choose_longer(as_force(*rows_[i].work[column]), as_force(*rows_[*best].work[column])))
            best = i;
    }
    return best;
}

void Equilibria::eliminate() {
    if (follows_motions())
        eliminate_in_turn();
    else
        eliminate_sparse();
    for (const Row& row : rows_) {
        if (row.pivot >= 0) continue;
        free_.push_back(motion_of(row));
        exist_ = exist_ && !row.power;
    }
}

void Equilibria::clear(Row& row, const Row& pivot, std::size_t column) {
    const ScalarHandle factor = *row.work[column];
    subtract(row, pivot, factor);
    row.work[column].reset();
}

/// Forward elimination by the unknowns that occur least, then back substitution: less fills in than if each column is
/// cleared in turn.
void Equilibria::eliminate_sparse() {
    std::vector<bool> is_pivot(columns_.size());
    std::vector<std::size_t> order;
    while (const auto column = sparsest_column(is_pivot)) {
        const std::size_t pivot = *pivot_row(*column);
        divide(rows_[pivot], *rows_[pivot].work[*column]);
        rows_[pivot].pivot = static_cast<int>(*column);
        is_pivot[*column] = true;
        order.push_back(pivot);
        for (Row& row : rows_)
            if (row.pivot < 0 && row.work[*column]) clear(row, rows_[pivot], *column);
    }
    for (std::size_t last = order.size(); last-- > 0;) {
        const Row& pivot = rows_[order[last]];
        const auto column = static_cast<std::size_t>(pivot.pivot);
        for (std::size_t earlier = 0; earlier < last; ++earlier)
            if (rows_[order[earlier]].work[column]) clear(rows_[order[earlier]], pivot, column);
    }
    for (std::size_t column = 0; column < columns_.size(); ++column)
        if (!is_pivot[column]) free_columns_.push_back(column);
}

std::optional<std::size_t> Equilibria::sparsest_column(const std::vector<bool>& is_pivot) const {
    std::optional<std::size_t> best;
    std::ptrdiff_t fewest = 0;
    for (std::size_t column = 0; column < columns_.size(); ++column) {
        if (is_pivot[column]) continue;
        const auto count = std::count_if(rows_.begin(), rows_.end(),
                                         [&](const Row& row) { return row.pivot < 0 && row.work[column]; });
        if (count == 0 || (best && count >= fewest)) continue;
        best = column;
        fewest = count;
    }
    return best;
}

void Equilibria::eliminate_in_turn() {
    for (std::size_t column = 0; column < columns_.size(); ++column) {
        const auto pivot = pivot_row(column);
        if (!pivot) {
            free_columns_.push_back(column);
            continue;
        }
        Row& row = rows_[*pivot];
        divide(row, *row.work[column]);
        row.pivot = static_cast<int>(column);
        for (std::size_t i = 0; i < rows_.size(); ++i)
            if (i != *pivot && rows_[i].work[column]) clear(rows_[i], row, column);
    }
}

// --- common values of all equilibria

Equilibria::Motion Equilibria::motion_of(const Row& row) const {
    Motion motion;
    motion.power = row.power;
    if (!follows_motions()) return motion;
    for (const MemberIndex member : group_) {
        const std::size_t first = first_row_.at(member);
        Motion::Twist twist{row.motion[first], row.motion[first + 1], {}};
        if (!model_.is_pin(member)) twist.turn = row.motion[first + 2];
        if (twist.x || twist.y || twist.turn) motion.members.emplace(member, twist);
    }
    return motion;
}

std::size_t Equilibria::moving(const Row& row) const { return motion_of(row).members.size(); }

Equilibria::Motion Equilibria::simplest(Row row, const Row* known) {
    if (!follows_motions()) return motion_of(row);
    const auto simplify = [&](const Row& by) {
        Row best = row;
        for (std::size_t i = 0; i < row.motion.size(); ++i) {
            if (!row.motion[i] || !by.motion[i]) continue;
            Row tried = row;
            subtract(tried, by, board_.quotient(*row.motion[i], *by.motion[i]));
            if (moving(tried) < moving(best)) best = std::move(tried);
        }
        row = std::move(best);
    };
    for (const Row& free : rows_)
        if (free.pivot < 0) simplify(free);
    if (known != nullptr) simplify(*known);
    return motion_of(row);
}

const Equilibria::Row* Equilibria::row_of(std::size_t column) const {
    const auto found =
        std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) { return row.pivot == static_cast<int>(column); });
    return found == rows_.end() ? nullptr : &*found;
}

std::vector<Equilibria::Cell> Equilibria::change_of(std::size_t column) {
    std::vector<Cell> changes;
    const Row* row = row_of(column);
    for (const std::size_t free : free_columns_) {
        if (row == nullptr)
            changes.push_back(free == column ? Cell(board_.number(1)) : Cell());
        else
            changes.push_back(row->work[free] ? Cell(board_.opposite(*row->work[free])) : Cell());
    }
    return changes;
}

bool Equilibria::vanishes(const std::vector<Cell>& cells) {
    return std::none_of(cells.begin(), cells.end(), [](const Cell& cell) { return cell.has_value(); });
}

Equilibria::Row Equilibria::combined(const Cell& c_0, std::size_t first, const Cell& c_1, std::size_t second) {
    Row sum;
    sum.work.resize(columns_.size());
    if (follows_motions()) sum.motion.resize(rows_.size());
    for (const auto& [factor, column] : {std::pair{c_0, first}, std::pair{c_1, second}}) {
        const Row* row = row_of(column);
        if (row != nullptr && factor) subtract(sum, *row, board_.opposite(*factor));
    }
    return sum;
}

Equilibria::Component Equilibria::along_unit(std::size_t column) {
    const Row* row = row_of(column);
    KG_ASSERT(row != nullptr, "what no equilibrium changes has an equation of its own");
    const Force unit = *columns_[column].unit;
    Component found{unit, !row->power, board_.direction(unit), simplest(*row)};
    if (row->power) found.force = board_.scale<Plane::force>(board_.opposite(*row->power), board_.direction(unit));
    return found;
}

/// For a force with two variable components: the direction perpendicular to all changes, if these are parallel.
std::optional<Equilibria::Component> Equilibria::component(std::size_t first, std::size_t second) {
    const std::vector<Cell> x = change_of(first), y = change_of(second);
    if (vanishes(x)) return along_unit(first);
    if (vanishes(y)) return along_unit(second);
    std::size_t some = 0;
    while (!x[some] && !y[some]) ++some;
    for (std::size_t f = 0; f < x.size(); ++f) {
        const Cell one = times(x[f], y[some]), turned = minus_times(one, y[f], x[some]);
        if (turned && !board_.is_zero(*turned)) return std::nullopt;
    }
    // c = (−y, x) of the change; in the combination c_0 row + c_1 row only c · F is left.
    const Cell c_0 = y[some] ? Cell(board_.opposite(*y[some])) : Cell(), c_1 = x[some];
    const Row sum = combined(c_0, first, c_1, second);
    return component(c_0, first, c_1, second, sum, simplest(sum));
}

Equilibria::Component Equilibria::component(const Cell& c_0, std::size_t first, const Cell& c_1, std::size_t second,
                                            const Row& sum, Motion motion) {
    const auto along = [&](const Cell& c, std::size_t column) {
        return board_.scale<Plane::force>(c ? *c : board_.number(0), board_.direction(*columns_[column].unit));
    };
    const Force direction = board_.add(along(c_0, first), along(c_1, second));
    Component found{direction, !sum.power, board_.direction(direction), std::move(motion)};
    if (!sum.power) return found;
    const Cell square_0 = times(c_0, c_0), square_1 = times(c_1, c_1);
    const ScalarHandle square = square_0 && square_1 ? board_.sum(*square_0, *square_1)
                                : square_0           ? *square_0
                                                     : *square_1;
    found.force =
        board_.scale<Plane::force>(board_.quotient(board_.opposite(*sum.power), square), board_.direction(direction));
    return found;
}

std::pair<std::vector<std::size_t>, std::optional<std::size_t>> Equilibria::columns_of(int bond) const {
    std::vector<std::size_t> forces;
    std::optional<std::size_t> couple;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        if (columns_[c].bond != bond) continue;
        if (columns_[c].unit)
            forces.push_back(c);
        else
            couple = c;
    }
    return {std::move(forces), couple};
}

Equilibria::Alike Equilibria::of(int bond, DirectionHandle first) {
    const auto found = columns_of(bond);
    const std::vector<std::size_t>& forces = found.first;
    KG_ASSERT(forces.size() == 2, "a hinge has two components");
    const Force way = board_.scale<Plane::force>(board_.number(1), first);
    const auto part = [&](const Vector& across) {
        const ScalarHandle value = board_.moment(board_.own_direction(across), way);
        return board_.is_zero(value) ? Cell() : Cell(value);
    };
    const Cell x = part({0, -1}), y = part({1, 0}), across = y ? Cell(board_.opposite(*y)) : Cell();
    const Row one = combined(x, forces[0], y, forces[1]), other = combined(across, forces[0], x, forces[1]);
    Alike alike;
    alike.components.push_back(component(x, forces[0], y, forces[1], one, simplest(one)));
    alike.components.push_back(component(across, forces[0], x, forces[1], other, simplest(other, &one)));
    alike.whole_force = alike.all = true;
    return alike;
}

Equilibria::Alike Equilibria::of(int bond) {
    const auto found = columns_of(bond);
    const std::vector<std::size_t>& forces = found.first;
    const std::optional<std::size_t> couple = found.second;
    Alike alike;
    alike.whole_force =
        std::all_of(forces.begin(), forces.end(), [&](std::size_t c) { return vanishes(change_of(c)); });
    if (alike.whole_force) {
        for (const std::size_t c : forces) alike.components.push_back(along_unit(c));
    } else if (forces.size() == 2) {
        if (auto one = component(forces[0], forces[1])) alike.components.push_back(std::move(*one));
    }
    if (couple && vanishes(change_of(*couple))) {
        const Row* row = row_of(*couple);
        KG_ASSERT(row != nullptr, "what no equilibrium changes has an equation of its own");
        alike.couple = Couple{row->power ? Cell(board_.opposite(*row->power)) : Cell(), simplest(*row)};
    }
    alike.all = alike.whole_force && (!couple || alike.couple);
    return alike;
}

// --- motions

std::optional<PlaceOnDrawing> Equilibria::centre(const Motion::Twist& twist) {
    if (!twist.turn) return std::nullopt;
    if (!twist.x && !twist.y) return origin_;
    // From the translation s = (x, y) and the rotation ω: 0 = s + ω z ∧ r, so r = z ∧ s / ω.
    const auto moved = shift(twist);
    const ScalarHandle inverse = board_.quotient(board_.number(1), *twist.turn);
    return board_.carry(origin_, board_.scale<drawing>(inverse, board_.turn(moved)));
}

VectorOn<drawing> Equilibria::shift(const Motion::Twist& twist) {
    const auto part = [&](const Cell& cell, const Vector& axis) {
        return board_.scale<drawing>(cell ? *cell : board_.number(0), board_.own_direction(axis));
    };
    const auto x = part(twist.x, {1, 0}), y = part(twist.y, {0, 1});
    return board_.add(x, y);
}

DirectionHandle Equilibria::direction(const Motion::Twist& twist) { return board_.direction(shift(twist)); }

bool Equilibria::moves_as_one(const Motion& motion) {
    const auto same = [&](const Cell& a, const Cell& b) {
        if (!a || !b) return a.has_value() == b.has_value();
        return board_.is_zero(board_.difference(*a, *b));
    };
    const Motion::Twist* first = nullptr;
    for (const auto& [member, twist] : motion.members) {
        if (model_.is_pin(member)) continue;  // a pin moves with its bodies
        if (first == nullptr)
            first = &twist;
        else if (!same(first->x, twist.x) || !same(first->y, twist.y) || !same(first->turn, twist.turn))
            return false;
    }
    return first != nullptr;
}

std::vector<Group> groups_in_question(const ForceModel& model, const Run& run) {
    std::vector<Group> groups;
    std::set<MemberIndex> seen;
    for (const MemberIndex first : model.moving_members()) {
        const auto& own = model.bonds_of(first);
        const bool open = std::any_of(own.begin(), own.end(), [&](int b) { return !run.reactions[at(b)].known; });
        if (!open || !seen.insert(first).second) continue;
        Group group{first};
        for (std::size_t next = 0; next < group.size(); ++next)
            for (const int b : model.bonds_of(group[next])) {
                if (run.reactions[at(b)].known) continue;
                const Bond& bond = model.bonds()[at(b)];
                const MemberIndex other = bond.first == group[next] ? bond.second : bond.first;
                if (other != member_of(frame) && seen.insert(other).second) group.push_back(other);
            }
        std::sort(group.begin(), group.end());
        groups.push_back(std::move(group));
    }
    return groups;
}

}  // namespace kinegraph::statics
