// Recorded: a value of the solution with the element of the record that holds it. Used like std::optional.
#pragma once

#include <optional>
#include <utility>

#include "engine/number/assert.hpp"
#include "engine/number/index.hpp"

namespace kinegraph {

/// Recipes store the element; the value is read from the record once it is finished. A value shown to vanish has no
/// element.
template <class T>
class Recorded {
public:
    Recorded() = default;
    /// A value that is not in the record.
    // NOLINTNEXTLINE(google-explicit-constructor): as std::optional
    Recorded(T value) : known_(true), value_(std::move(value)) {}
    Recorded(std::nullopt_t) {}  // NOLINT(google-explicit-constructor)
    static Recorded at(ElementIndex element) {
        Recorded found;
        found.known_ = true;
        found.element_ = element;
        return found;
    }
    static Recorded zero() { return T{}; }

    bool has_value() const { return known_; }
    explicit operator bool() const { return known_; }
    const T& value() const {
        KG_ASSERT(known_, "the value of what was not found");
        return value_;
    }
    T value_or(T otherwise) const { return known_ ? value_ : std::move(otherwise); }
    const T& operator*() const { return value(); }
    const T* operator->() const { return &value(); }
    /// None where it vanishes or is unknown.
    ElementIndex element() const { return element_; }

    /// Applies `see(element, value)` to both: it renumbers the element or reads the value.
    template <class See>
    void visit(See& see) {
        if (known_ && element_ != none) see(element_, value_);
    }

    friend bool operator==(const Recorded& a, const Recorded& b) {
        return a.known_ == b.known_ && (!a.known_ || a.value_ == b.value_);
    }

private:
    bool known_ = false;
    ElementIndex element_ = none;
    T value_{};
};

}  // namespace kinegraph
