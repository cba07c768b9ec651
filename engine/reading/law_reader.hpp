// Laws of motion as files write them: FORMAT "Laws of motion". For drivers, over time; for followers, over the cam's
// rotation.
#pragma once

#include "engine/mechanism/law.hpp"
#include "engine/reading/form_reader.hpp"

namespace kinegraph {

class LawReader : protected FormReader {
public:
    /// Keys and kinds of the quantities of a piece: its rise, and its independent variable.
    struct LawTerms {
        std::string_view rise;
        QuantityKind rise_kind;
        std::string_view over;
        QuantityKind over_kind;
    };
    /// One piece, or an array of pieces. Reports what is unreadable.
    Law law_of_value(JsonValue value, const LawTerms& terms);

private:
    void read_piece(JsonValue value, const LawTerms& terms, Law& law);
};

}  // namespace kinegraph
