// What a body is made of, for what presses it: a material by its name, or Young's modulus and Poisson's ratio.
#pragma once

#include "engine/mechanism/problem.hpp"
#include "engine/reading/form_reader.hpp"

namespace kinegraph {

class Materials {
public:
    explicit Materials(FormReader& file) : file_(file) {}

    /// Of a form with "material", or "young" and "poisson".
    void read(const Members& form, HertzBody& body);
    void read_by_name(JsonValue name, HertzBody& body);

private:
    FormReader& file_;
};

}  // namespace kinegraph
