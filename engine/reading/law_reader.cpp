#include "engine/reading/law_reader.hpp"

namespace kinegraph {

Law LawReader::law_of_value(JsonValue value, const LawTerms& terms) {
    Law law;
    law.where = value.pointer();
    if (value.is_object()) {
        read_piece(value, terms, law);
    } else if (expect(value, Kind::array,
                      {"a law, or an array of its pieces", "una legge, o un elenco dei suoi tratti"})) {
        for (const JsonValue piece : value) read_piece(piece, terms, law);
        if (value.size() == 0) fault(value, {"a law has one piece at least", "una legge ha almeno un tratto"});
    }
    return law;
}

void LawReader::read_piece(JsonValue value, const LawTerms& terms, Law& law) {
    const Words what("a piece of a law", "un tratto di una legge");
    if (!expect(value, Kind::object, what)) return;
    const Members form = members(value, {"form", terms.rise, terms.over}, what);
    LawPiece piece;
    const JsonValue name =
        required(form, "form",
                 {"the form of the motion: \"cycloidal\", \"rest\" …", "la forma del moto: \"cycloidal\", \"rest\" …"});
    std::optional<LawForm> known;
    if (name && expect(name, Kind::string, {"the name of a form", "il nome di una forma"})) {
        known = law_form_spelt(name.text());
        if (!known) {
            const std::vector<std::string> names = law_forms();
            std::string list;
            for (const std::string& each : names) list += (list.empty() ? "" : ", ") + each;
            fault(name, {"no form of motion is called {0}{1}; there are {2}",
                         "nessuna forma di moto si chiama {0}{1}; ci sono {2}", quoted(name.text()),
                         did_you_mean(speller_.nearest(std::string(name.text()), names)), list});
        }
    }
    piece.form = known.value_or(LawForm::rest);
    if (known == LawForm::rest) {
        if (form[terms.rise])
            fault(form[terms.rise],
                  {"in a rest nothing moves; leave it out", "in una sosta nulla si muove; toglierlo"});
    } else {
        piece.rise =
            quantity_or_zero(required(form, terms.rise, {"how far it goes", "di quanto si muove"}), terms.rise_kind);
        if (known && form[terms.rise] && piece.rise.is_zero())
            fault(form[terms.rise],
                  {"it goes nowhere; write \"form\": \"rest\"", "non va in alcun luogo; scrivere \"form\": \"rest\""});
    }
    piece.over = positive(required(form, terms.over, {"in what it does so", "in quanto lo fa"}), terms.over_kind,
                          "\"" + std::string(terms.over) + "\"");
    law.pieces.push_back(std::move(piece));
}

}  // namespace kinegraph
