// Uses the installed library: a header, a function and the embedded schema must be there and link.
#include <iostream>

#include "engine/number/exact.hpp"
#include "engine/reading/mechanism_schema.hpp"

int main() {
    const auto tenth = kinegraph::Exact::from_decimal("0.1");
    if (!tenth || tenth->to_fraction() != "1/10") return 1;
    if (kinegraph::mechanism_schema_text.empty()) return 1;
    std::cout << tenth->to_fraction() << '\n';
    return 0;
}
