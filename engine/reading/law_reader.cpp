#include "engine/reading/law_reader.hpp"
#include "lang/keys/laws.hpp"

namespace kinegraph {

Law LawReader::law_of_value(JsonValue value, const LawTerms& terms) {
    Law law;
    law.where = value.pointer();
    if (value.is_object()) {
        read_piece(value, terms, law);
    } else if (expect(value, Kind::array, {lang::laws::a_law_or_an_array})) {
        for (const JsonValue piece : value) read_piece(piece, terms, law);
        if (value.size() == 0) fault(value, {lang::laws::a_law_has_one_piece});
    }
    return law;
}

void LawReader::read_piece(JsonValue value, const LawTerms& terms, Law& law) {
    const Words what(lang::laws::a_piece_of_a_law);
    if (!expect(value, Kind::object, what)) return;
    const Members form = members(value, {"form", terms.rise, terms.over}, what);
    LawPiece piece;
    const JsonValue name = required(form, "form", {lang::laws::the_form_of_the_motion_cycloidal});
    std::optional<LawForm> known;
    if (name && expect(name, Kind::string, {lang::laws::the_name_of_a_form})) {
        known = law_form_spelt(name.text());
        if (!known) {
            const std::vector<std::string> names = law_forms();
            std::string list;
            for (const std::string& each : names) list += (list.empty() ? "" : ", ") + each;
            fault(name, {lang::laws::no_form_of_motion_is_called, quoted(name.text()),
                         did_you_mean(speller_.nearest(std::string(name.text()), names)), list});
        }
    }
    piece.form = known.value_or(LawForm::rest);
    if (known == LawForm::rest) {
        if (form[terms.rise]) fault(form[terms.rise], {lang::laws::in_a_rest_nothing_moves_leave});
    } else {
        piece.rise = quantity_or_zero(required(form, terms.rise, {lang::laws::how_far_it_goes}), terms.rise_kind);
        if (known && form[terms.rise] && piece.rise.is_zero())
            fault(form[terms.rise], {lang::laws::it_goes_nowhere_write_form_rest});
    }
    piece.over = positive(required(form, terms.over, {lang::laws::in_what_it_does}), terms.over_kind,
                          "\"" + std::string(terms.over) + "\"");
    law.pieces.push_back(std::move(piece));
}

}  // namespace kinegraph
