// Laws of motion as files write them: FORMAT "Laws of motion". For drivers, over time; for followers, over the cam's
// rotation.
#pragma once

#include "engine/mechanism/law.hpp"
#include "engine/reading/form_reader.hpp"

namespace kinegraph {

class LawReader : protected FormReader {
public:
    /// One piece, or an array of pieces; each has the form, which names the rise and the independent variable. Reports
    /// what is unreadable.
    Law law_of_value(JsonValue value, const Form& piece_form);

private:
    void read_piece(JsonValue value, const Form& piece_form, Law& law);
};

}  // namespace kinegraph
