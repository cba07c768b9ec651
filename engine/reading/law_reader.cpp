#include "engine/reading/law_reader.hpp"
#include "lang/keys/laws.hpp"

namespace kinegraph {
namespace {

constexpr FormRow form_of_law =
    FormRow("form", "F",
            values::word(law_form_names).named("lawForm", "How the piece goes from its beginning to its end."))
        .needed(lang::laws::the_form_of_the_motion_cycloidal)
        .called(lang::laws::the_name_of_a_form);
constexpr FormRow span_of_law(std::string_view key, std::string_view letter, const FormValue& value) {
    return FormRow(key, letter, value).needed(lang::laws::in_what_it_does).positive();
}
constexpr FormRow time_of_law = span_of_law("time", "t", values::time),
                  turn_of_cam = span_of_law("turn", "a", values::angle);
/// In this order: the form, the rise, which a rest has not, and what it takes.
constexpr std::array turn_rows{form_of_law, FormRow("turn", "a", values::angle), time_of_law};
constexpr std::array slide_rows{form_of_law, FormRow("slide", "d", values::length), time_of_law};
constexpr std::array lift_rows{form_of_law, FormRow("rise", "h", values::length), turn_of_cam};
constexpr std::array swing_rows{form_of_law, FormRow("rise", "h", values::angle), turn_of_cam};

constexpr FormValue turn_piece_value =
    values::object(forms::turn_piece)
        .named("turnPiece", "A piece of a law: its form, by how much it turns (not in a rest), and in what time.");
constexpr FormValue slide_piece_value =
    values::object(forms::slide_piece)
        .named("slidePiece", "A piece of a law: its form, by how much it slides (not in a rest), and in what time.");
constexpr std::array turn_law_choices{turn_piece_value, values::list(turn_piece_value, 1)};
constexpr std::array slide_law_choices{slide_piece_value, values::list(slide_piece_value, 1)};
constexpr std::string_view what_a_law_is =
    "A law of motion, from which the rates follow: one piece, or several one after the other.";

}  // namespace

constinit const Form forms::turn_piece{lang::laws::a_piece_of_a_law, turn_rows};
constinit const Form forms::slide_piece{lang::laws::a_piece_of_a_law, slide_rows};
constinit const Form forms::piece_of_lift{lang::laws::a_piece_of_a_law, lift_rows};
constinit const Form forms::piece_of_swing{lang::laws::a_piece_of_a_law, swing_rows};
constinit const FormValue forms::turn_law = values::any(turn_law_choices).named("turnLaw", what_a_law_is);
constinit const FormValue forms::slide_law = values::any(slide_law_choices).named("slideLaw", what_a_law_is);

Law LawReader::law_of_value(JsonValue value, const Form& piece_form) {
    Law law;
    law.where = value.pointer();
    if (value.is_object()) {
        read_piece(value, piece_form, law);
    } else if (expect(value, Kind::array, {lang::laws::a_law_or_an_array})) {
        for (const JsonValue piece : value) read_piece(piece, piece_form, law);
        if (value.size() == 0) fault(value, {lang::laws::a_law_has_one_piece});
    }
    return law;
}

void LawReader::read_piece(JsonValue value, const Form& piece_form, Law& law) {
    const std::string_view rise = piece_form.rows[1].key, over = piece_form.rows[2].key;
    if (!expect(value, Kind::object, {piece_form.called})) return;
    const Members form = members(value, piece_form);
    LawPiece piece;
    std::optional<LawForm> known;
    if (const JsonValue name = form.expected("form")) {
        known = law_form_spelt(name.text());
        if (!known) {
            std::string list;
            for (const std::string_view each : law_form_names) list += (list.empty() ? "" : ", ") + std::string(each);
            fault(name, {lang::laws::no_form_of_motion_is_called, quoted(name.text()),
                         did_you_mean(speller_.nearest(name.text(), law_form_names)), list});
        }
    }
    piece.form = known.value_or(LawForm::rest);
    if (known == LawForm::rest) {
        if (form[rise]) fault(form[rise], {lang::laws::in_a_rest_nothing_moves_leave});
    } else {
        required(form, rise, {lang::laws::how_far_it_goes});
        const std::optional<Exact> goes = form.quantity(rise);
        piece.rise = goes.value_or(Exact());
        if (known && goes && goes->is_zero()) fault(form[rise], {lang::laws::it_goes_nowhere_write_form_rest});
    }
    piece.over = form.quantity_or_default(over);
    law.pieces.push_back(std::move(piece));
}

}  // namespace kinegraph
