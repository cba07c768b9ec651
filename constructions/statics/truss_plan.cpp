#include "constructions/statics/truss_plan.hpp"

#include <algorithm>
#include <utility>

#include "engine/number/assert.hpp"

namespace kinegraph::statics {

TrussPlan::TrussPlan(Board& board, const TrussStructure& truss, const std::vector<int>& loaded)
    : board_(board), truss_(truss), round_(truss.pins.size()), face_(2 * truss.bars.size(), -1) {
    if (!hangs_together() || any_cross()) return;
    order_round_pins();
    walk_faces();
    exists_ = are_on_border(loaded);
}

bool TrussPlan::are_on_border(const std::vector<int>& loaded) {
    const auto inside = std::find_if_not(loaded.begin(), loaded.end(), [&](int pin) {
        return std::any_of(border_.begin(), border_.end(), [&](HalfBar half) { return head(half) == pin; });
    });
    if (inside != loaded.end()) inside_ = *inside;
    return inside == loaded.end();
}

bool TrussPlan::hangs_together() const {
    std::vector<bool> seen(truss_.pins.size(), false);
    std::vector<int> reached{0};
    seen[0] = true;
    for (std::size_t next = 0; next < reached.size(); ++next)
        for (const int bar : truss_.pins[at(reached[next])].bars) {
            const int other = truss_.other_end(bar, reached[next]);
            if (!seen[at(other)]) reached.push_back(other);
            seen[at(other)] = true;
        }
    return reached.size() == truss_.pins.size();
}

/// Whether two bars meet other than at a common pin.
bool TrussPlan::cross(int bar, int other) {
    const int a = truss_.bars[at(bar)].pins[0], b = truss_.bars[at(bar)].pins[1];
    const int c = truss_.bars[at(other)].pins[0], d = truss_.bars[at(other)].pins[1];
    const auto side = [&](int from, int to, int pin) {
        return board_.choose_turn(board_.vector(place(from), place(to)), board_.vector(place(from), place(pin)));
    };
    for (const int common : {a, b})
        if (common == c || common == d) {
            const int end = common == a ? b : a, its = common == c ? d : c;
            return side(common, end, its) == 0 && board_.choose_along(board_.vector(place(common), place(end)),
                                                                      board_.vector(place(common), place(its))) > 0;
        }
    const int sides[] = {side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b)};
    if (sides[0] == 0 &&
        sides[1] == 0) {  // collinear: separate if both ends of one bar are beyond the same end of the other
        const auto beyond = [&](int from, int to) {
            const auto along = board_.vector(place(from), place(to));
            return board_.choose_along(along, board_.vector(place(to), place(c))) > 0 &&
                   board_.choose_along(along, board_.vector(place(to), place(d))) > 0;
        };
        return !beyond(a, b) && !beyond(b, a);
    }
    return sides[0] * sides[1] <= 0 && sides[2] * sides[3] <= 0;
}

bool TrussPlan::any_cross() {
    const auto bars = static_cast<int>(truss_.bars.size());
    for (int bar = 0; bar < bars; ++bar)
        for (int other = bar + 1; other < bars; ++other)
            if (cross(bar, other)) {
                crossing_.emplace(bar, other);
                return true;
            }
    return false;
}

/// Which of two rays comes first when turning from a third; `sense` 1: counter-clockwise, −1: clockwise.
bool TrussPlan::comes_first(Ray from, Ray a, Ray b, int sense) {
    const auto half = [&](Ray v) {
        const int turned = sense * board_.choose_turn(from, v);
        return turned > 0 || (turned == 0 && board_.choose_along(from, v) > 0) ? 0 : 1;
    };
    const int half_a = half(a), half_b = half(b);
    return half_a != half_b ? half_a < half_b : sense * board_.choose_turn(a, b) > 0;
}

void TrussPlan::order_round_pins() {
    const Ray back = board_.scale<drawing>(board_.number(1), board_.own_direction({-1, 0}));
    for (std::size_t pin = 0; pin < truss_.pins.size(); ++pin) {
        for (const int bar : truss_.pins[pin].bars)
            round_[pin].push_back(2 * bar + (truss_.bars[at(bar)].pins[0] == static_cast<int>(pin) ? 0 : 1));
        std::stable_sort(round_[pin].begin(), round_[pin].end(),
                         [&](HalfBar a, HalfBar b) { return comes_first(back, ray(a), ray(b), 1); });
    }
}

/// The leftmost pin; of several the lowest. It is on the border.
int TrussPlan::extreme_pin() {
    const Ray right = board_.scale<drawing>(board_.number(1), board_.own_direction({1, 0})),
              up = board_.scale<drawing>(board_.number(1), board_.own_direction({0, 1}));
    int best = 0;
    for (int pin = 1; pin < static_cast<int>(truss_.pins.size()); ++pin) {
        const Ray apart = board_.vector(place(best), place(pin));
        const int along = board_.choose_along(right, apart);
        if (along < 0 || (along == 0 && board_.choose_along(up, apart) < 0)) best = pin;
    }
    return best;
}

/// Each half bar has its face on the left and continues with the next half bar clockwise from its reverse.
void TrussPlan::walk_faces() {
    const auto next = [&](HalfBar half) {
        const auto& round = round_[at(head(half))];
        const auto back = std::find(round.begin(), round.end(), half ^ 1);
        return back == round.begin() ? round.back() : *std::prev(back);
    };
    const auto walk = [&](HalfBar first, int face) {
        std::vector<HalfBar> passed;
        for (HalfBar half = first; face_[at(half)] < 0; half = next(half)) {
            face_[at(half)] = face;
            passed.push_back(half);
        }
        return passed;
    };
    border_ = walk(round_[at(extreme_pin())].back(), 0);
    for (HalfBar half = 0; half < static_cast<int>(face_.size()); ++half)
        if (face_[at(half)] < 0) walk(half, faces_++);
}

/// A force is drawn outside: its arrow ends at the pin, or starts there if its tail would be between the bars.
TrussPlan::Ray TrussPlan::ray_of(const OuterForce& force, std::size_t corner) {
    const Ray arriving = ray(border_[corner] ^ 1), leaving = ray(border_[(corner + 1) % border_.size()]);
    const Ray ahead = board_.scale<drawing>(board_.number(1), board_.direction(force.force)),
              behind = board_.negate(ahead);
    const auto is_outside = [&](Ray of) {
        return comes_first(arriving, of, leaving, -1) && board_.choose_turn(arriving, of) != 0;
    };
    return !is_outside(behind) && is_outside(ahead) ? ahead : behind;
}

/// Clockwise around the truss.
std::vector<OuterForce> TrussPlan::in_order(std::vector<OuterForce> outer) {
    std::vector<OuterForce> ordered;
    std::vector<bool> passed(truss_.pins.size(), false);
    for (std::size_t corner = 0; corner < border_.size(); ++corner) {
        const int pin = head(border_[corner]);
        if (passed[at(pin)]) continue;
        passed[at(pin)] = true;
        std::vector<std::pair<Ray, OuterForce>> here;
        for (OuterForce& force : outer)
            if (force.told.pin == pin) {
                const Ray own = ray_of(force, corner);
                here.emplace_back(own, std::move(force));
            }
        const Ray arriving = ray(border_[corner] ^ 1);
        std::stable_sort(here.begin(), here.end(),
                         [&](const auto& a, const auto& b) { return comes_first(arriving, a.first, b.first, -1); });
        for (auto& [own, force] : here) ordered.push_back(std::move(force));
    }
    return ordered;
}

void TrussPlan::name_spaces(Truss& truss, const std::vector<OuterForce>& outer) {
    const auto count = std::max<std::size_t>(outer.size(), 1);
    for (std::size_t s = 0; s < count; ++s) {
        constexpr std::size_t letters = 26;
        std::string letter(1, static_cast<char>('a' + static_cast<int>(s % letters)));
        if (s >= letters) letter += std::to_string(s / letters);
        truss.spaces.push_back({std::move(letter), true, {}});
    }
    for (int face = 1; face < faces_; ++face) truss.spaces.push_back({std::to_string(face), false, {}});
    std::vector<int> space(face_.size(), -1);
    for (std::size_t half = 0; half < face_.size(); ++half)
        if (face_[half] > 0) {
            space[half] = static_cast<int>(count) + face_[half] - 1;
            truss.spaces[at(space[half])].pins.push_back(tail(static_cast<HalfBar>(half)));
        }
    std::size_t now = 0, met = 0;
    std::vector<bool> passed(truss_.pins.size(), false);
    std::vector<int> closing;  // the start of the first space's border, used to close it at the end
    const auto borders = [&](int pin) { (now == 0 && met > 0 ? closing : truss.spaces[now].pins).push_back(pin); };
    borders(tail(border_.front()));
    for (const HalfBar half : border_) {
        space[at(half)] = static_cast<int>(now);
        const int pin = head(half);
        borders(pin);
        if (passed[at(pin)]) continue;
        passed[at(pin)] = true;
        while (met < outer.size() && outer[met].told.pin == pin) {
            truss.externals[met].before = static_cast<int>(now);
            now = (now + 1) % count;
            truss.externals[met].after = static_cast<int>(now);
            ++met;
            borders(pin);
        }
    }
    truss.spaces[0].pins.insert(truss.spaces[0].pins.begin(), closing.begin(), closing.end());
    for (std::size_t bar = 0; bar < truss.bars.size(); ++bar) {
        truss.bars[bar].left = space[2 * bar];
        truss.bars[bar].right = space[2 * bar + 1];
    }
}

void TrussPlan::draw_sides(Truss& truss, const std::vector<OuterForce>& outer,
                           const std::vector<std::optional<Force>>& pulls, StatementIndex opening) {
    using SpaceCorner = PointOn<Plane::force>;
    std::vector<std::optional<SpaceCorner>> corner(truss.spaces.size());
    corner[0] = board_.pole<Plane::force>();
    const auto side = [&](Symbol symbol, const Quantity& quantity, StatementIndex statement, SpaceCorner tail,
                          SpaceCorner tip, bool from_outside) {
        DrawnVector drawn;
        drawn.symbol = std::move(symbol);
        drawn.polygon = truss.polygon;
        drawn.tail = tail.element;
        drawn.tip = tip.element;
        drawn.statement = statement;
        drawn.quantity = quantity;
        drawn.role = from_outside ? DrawnVector::Role::external : DrawnVector::Role::internal;
        board_.draw(std::move(drawn));
    };
    for (std::size_t i = 0; i < outer.size(); ++i) {
        const Truss::External& told = truss.externals[i];
        const SpaceCorner before = *corner[at(told.before)], after = board_.carry(before, outer[i].force);
        if (told.after == 0)
            KG_ASSERT(board_.coincide(after, *corner[0]), "forces from outside in equilibrium close");
        else
            corner[at(told.after)] = after;
        side(told.symbol, outer[i].quantity, told.statement == none ? opening : told.statement, before,
             *corner[at(told.after)], true);
    }
    for (std::size_t round = 0; round < truss.spaces.size(); ++round)
        for (std::size_t bar = 0; bar < truss.bars.size(); ++bar) {
            auto &left = corner[at(truss.bars[bar].left)], &right = corner[at(truss.bars[bar].right)];
            if (left && !right) right = pulls[bar] ? board_.carry(*left, *pulls[bar]) : *left;
            if (right && !left) left = pulls[bar] ? board_.carry(*right, board_.negate(*pulls[bar])) : *right;
        }
    for (std::size_t bar = 0; bar < truss.bars.size(); ++bar) {
        if (!pulls[bar]) continue;
        const SpaceCorner left = *corner[at(truss.bars[bar].left)], right = *corner[at(truss.bars[bar].right)];
        const Quantity quantity{.kind = Quantity::Kind::bar, .body = truss_.bars[bar].body};
        side({Symbol::Letter::F, truss_.bars[bar].name, {}}, quantity, truss.bars[bar].statement, left, right, false);
    }
    for (std::size_t s = 0; s < truss.spaces.size(); ++s) {
        Image image;
        image.symbol = {Symbol::Letter::point, truss.spaces[s].letter, {}};
        image.polygon = truss.polygon;
        image.point = corner[s]->element;
        board_.label(std::move(image));
    }
}

void TrussPlan::draw(Truss& truss, std::vector<OuterForce> outer, const std::vector<std::optional<Force>>& pulls,
                     StatementIndex opening) {
    outer = in_order(std::move(outer));
    truss.externals.clear();
    for (const OuterForce& force : outer) truss.externals.push_back(force.told);
    if (outer.empty()) return;
    name_spaces(truss, outer);
    Polygon polygon;
    polygon.kind = Polygon::Kind::joined_forces;
    polygon.plane = Plane::force;
    polygon.id = "cremona";
    truss.polygon = board_.add_polygon(std::move(polygon));
    draw_sides(truss, outer, pulls, opening);
}

}  // namespace kinegraph::statics
