// Laws of motion as files write them: FORMAT "Laws of motion". For drivers, over time, and for followers, over the
// cam's turn.
#pragma once

#include "engine/mechanism/law.hpp"
#include "engine/reading/form_reader.hpp"

namespace kinegraph {

class LawReader : protected FormReader {
public:
    /// What a law's pieces are measured in: the key and kind of their rise, and of what they go over.
    struct LawTerms {
        std::string_view rise;
        QuantityKind rise_kind;
        std::string_view over;
        QuantityKind over_kind;
    };
    /// One piece, or an array of pieces. What cannot be read is a fault.
    Law law_of_value(JsonValue value, const LawTerms& terms);

private:
    void read_piece(JsonValue value, const LawTerms& terms, Law& law);
};

}  // namespace kinegraph
