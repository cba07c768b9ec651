// Indices into the lists of a mechanism and of its record. Each list has its own index type, so a body's index is not
// accepted for a joint, and no index converts to a number.
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <vector>

namespace kinegraph {

/// The invalid index, for any list.
struct NoIndex {};
inline constexpr NoIndex none;

/// An index into a list of `Of`, in the list's order; `none` sorts before all.
template <class Of>
class ListIndex {
public:
    constexpr ListIndex() = default;
    constexpr ListIndex(NoIndex) {}  // NOLINT(google-explicit-constructor): as std::nullopt
    constexpr explicit ListIndex(std::integral auto number) : number_(static_cast<int>(number)) {}

    constexpr int number() const { return number_; }
    constexpr ListIndex next() const { return ListIndex(number_ + 1); }
    friend constexpr auto operator<=>(ListIndex, ListIndex) = default;  // NOLINT(modernize-use-nullptr)

private:
    int number_ = -1;
};

template <class Of>
constexpr std::size_t at_index(ListIndex<Of> index) {
    return static_cast<std::size_t>(index.number());
}
constexpr std::size_t at_index(int index) { return static_cast<std::size_t>(index); }

/// The range from `first` up to `end`, exclusive.
template <class Index>
class Indices {
public:
    class Iterator {
    public:
        constexpr explicit Iterator(Index at) : at_(at) {}
        constexpr Index operator*() const { return at_; }
        constexpr Iterator& operator++() {
            at_ = at_.next();
            return *this;
        }
        friend constexpr bool operator==(Iterator, Iterator) = default;

    private:
        Index at_;
    };
    constexpr Indices(Index first, Index end) : first_(first), end_(end < first ? first : end) {}
    constexpr Iterator begin() const { return Iterator(first_); }
    constexpr Iterator end() const { return Iterator(end_); }

private:
    Index first_, end_;
};

/// The indices of a list with `count` elements, starting at `first`.
template <class Index>
constexpr Indices<Index> indices(std::size_t count, Index first = Index(0)) {
    return {first, Index(count)};
}
template <class Of>
Indices<ListIndex<Of>> indices_of(const std::vector<Of>& list) {
    return indices<ListIndex<Of>>(list.size());
}

struct NamedPoint;
struct Body;
struct Joint;
struct Stroke;
struct Statement;
/// For the lists of Mechanism, in the file's order.
using PointIndex = ListIndex<NamedPoint>;
using BodyIndex = ListIndex<Body>;
using JointIndex = ListIndex<Joint>;
/// The result of a stroke: its index in both Program::strokes and Protocol::values.
using ElementIndex = ListIndex<Stroke>;
/// Into Protocol::statements. For a drawn item, `none` means that it is present from the beginning.
using StatementIndex = ListIndex<Statement>;

/// The fixed body.
inline constexpr BodyIndex frame{0};

}  // namespace kinegraph
