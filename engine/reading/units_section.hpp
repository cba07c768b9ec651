// "units" and "scales": what bare numbers are measured in, and how large figures are drawn.
#pragma once

#include "engine/mechanism/mechanism.hpp"
#include "engine/reading/form_reader.hpp"

namespace kinegraph {

class UnitsSection {
public:
    UnitsSection(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism) {}

    void read_units(JsonValue units);
    void read_scales(JsonValue value);

private:
    using Kind = FormReader::Kind;

    void read_unit(JsonValue value, QuantityKind kind);

    FormReader& file_;
    Mechanism& mechanism_;
};

}  // namespace kinegraph
