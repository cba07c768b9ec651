#include "engine/mechanism/mechanism.hpp"

#include <algorithm>

namespace kinegraph {
namespace {

template <class Item>
std::optional<ListIndex<Item>> named_in(const std::vector<Item>& items, std::string_view name) {
    const auto found = std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.name == name; });
    if (found == items.end()) return std::nullopt;
    return ListIndex<Item>(found - items.begin());
}

}  // namespace

Mechanism::Mechanism() = default;
Mechanism::Mechanism(const Mechanism&) = default;
Mechanism::Mechanism(Mechanism&&) noexcept = default;
Mechanism& Mechanism::operator=(const Mechanism&) = default;
Mechanism& Mechanism::operator=(Mechanism&&) noexcept = default;
Mechanism::~Mechanism() = default;

std::optional<PointIndex> Mechanism::point_named(std::string_view name) const { return named_in(points, name); }
std::optional<BodyIndex> Mechanism::body_named(std::string_view name) const { return named_in(bodies, name); }

}  // namespace kinegraph
