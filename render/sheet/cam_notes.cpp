#include "render/sheet/cam_notes.hpp"

#include <array>
#include <numbers>
#include <string_view>

#include "lang/keys/notation.hpp"
#include "lang/keys/sheet.hpp"
#include "render/content/exercise_text.hpp"
#include "render/figures/plot_figure.hpp"
#include "render/mechanism/sketch.hpp"
#include "render/text/bound_blank.hpp"

namespace kinegraph::render {
namespace {

class CamData {
public:
    CamData(const Cam& cam, const CamGeometry& geometry, const Mechanism& drawn, Language language)
        : cam_(cam), geometry_(geometry), drawn_(drawn), language_(language) {}

    std::vector<RichText> paragraphs() const {
        std::vector<RichText> all{cam_itself(), follower()};
        if (cam_.follower.moves == Follower::Moves::oscillating) all.push_back(sign_of_rise());
        double turn = 0;
        for (const LawPiece& piece : cam_.law.pieces) {
            const double end = turn + piece.over.to_double();
            all.push_back(piece_of_law(piece, turn, end));
            turn = end;
        }
        return all;
    }

private:
    std::string in_words(Key key) const { return word(key, language_); }
    static RichText symbol(std::string letter, std::string index, int dots = 0) {
        RichText text = one_piece(std::move(letter), Face::italic);
        text.back().sub = std::move(index);
        text.back().sub_face = Face::regular;
        text.back().dots = dots;
        return text;
    }
    RichText length(const Exact& si) const { return given_amount(si, cam_.units.length, language_); }
    std::string degrees(double radians) const {
        return drawing::given_number(radians * 180 / std::numbers::pi, language_) + "°";
    }
    /// "; base circle r_b = 45 mm"
    void add(RichText& line, Key key, const RichText& name, const RichText& value) const {
        if (!line.empty()) append(line, in_words(lang::notation::semicolon));
        append(line, in_words(key) + " ");
        append(line, name);
        append(line, name.empty() ? "" : " = ");
        append(line, value);
    }

    RichText cam_itself() const {
        RichText line;
        add(line, lang::sheet::base_circle, symbol("r", "b"), length(cam_.base_circle));
        add(line, cam_.omega.sign() > 0 ? lang::sheet::cam_turns_counter_clockwise : lang::sheet::cam_turns_clockwise,
            symbol("ω", drawn_.bodies[1].name), given_amount(cam_.omega, cam_.units.angular_velocity, language_));
        return line;
    }
    RichText follower() const {
        const Follower& follower = cam_.follower;
        RichText line;
        const bool translates = follower.moves == Follower::Moves::translating;
        switch (follower.face) {
            case Follower::Face::roller:
                add(line, translates ? lang::sheet::translating_roller : lang::sheet::oscillating_roller,
                    symbol("r", "r"), length(follower.radius));
                break;
            case Follower::Face::flat:
                line = one_piece(in_words(translates ? lang::sheet::translating_flat : lang::sheet::oscillating_flat));
                break;
            case Follower::Face::knife_edge:
                line = one_piece(in_words(translates ? lang::sheet::translating_edge : lang::sheet::oscillating_edge));
                break;
        }
        const bool is_flat = follower.face == Follower::Face::flat;
        if (translates != is_flat) add(line, lang::sheet::offset, symbol("e", ""), length(follower.offset));
        if (translates) return line;
        const double unit = cam_.units.length.si.to_double();
        const std::string place =
            pair_of(drawing::given_number(follower.pivot.x.to_double() / unit, language_),
                    drawing::given_number(follower.pivot.y.to_double() / unit, language_), language_);
        add(line, lang::sheet::pivot, one_piece("Q", Face::italic),
            with_powers(bound(place + " " + cam_.units.length.symbol)));
        if (!is_flat) add(line, lang::sheet::arm_of_follower, {}, length(follower.arm));
        return line;
    }
    /// β is not an angle of the drawing, where angles are positive counter-clockwise.
    RichText sign_of_rise() const {
        const bool is_left = geometry_.rises() > 0;
        const std::string& name = drawn_.bodies.back().name;
        RichText line = one_piece(
            in_words(is_left ? lang::sheet::rise_is_counter_clockwise : lang::sheet::rise_is_clockwise) + " ");
        append(line, symbol("ω", name));
        append(line, std::string(is_left ? " = " : " = −") + in_words(lang::sheet::rise_angle_rate) + ", ");
        append(line, symbol(notation(language_).alpha, name, notation(language_).alpha_dots));
        append(line, std::string(is_left ? " = " : " = −"));
        append(line, with_powers(in_words(lang::sheet::rise_angle_acceleration)));
        return line;
    }
    RichText piece_of_law(const LawPiece& piece, double from, double to) const {
        RichText line = one_piece(degrees(from) + "–" + degrees(to) + in_words(lang::notation::colon));
        if (piece.form == LawForm::rest || piece.rise.is_zero()) {
            append(line, in_words(lang::sheet::law_rest));
            return line;
        }
        const Exact by = piece.rise.sign() < 0 ? -piece.rise : piece.rise;
        append(line, in_words(piece.rise.sign() > 0 ? lang::sheet::law_rise : lang::sheet::law_return) + " ");
        if (cam_.follower.moves == Follower::Moves::oscillating)
            append(line, degrees(by.to_double()));
        else
            append(line, length(by));
        append(line, ", " + in_words(key_of(piece.form)));
        return line;
    }
    static Key key_of(LawForm form) {
        switch (form) {
            case LawForm::rest: return lang::sheet::law_rest;
            case LawForm::constant_speed: return lang::sheet::law_constant_speed;
            case LawForm::constant_acceleration: return lang::sheet::law_constant_acceleration;
            case LawForm::harmonic: return lang::sheet::law_harmonic;
            case LawForm::cycloidal: return lang::sheet::law_cycloidal;
            case LawForm::polynomial_345: return lang::sheet::law_3_4_5;
            case LawForm::modified_trapezoidal: return lang::sheet::law_modified_trapezoidal;
        }
        return lang::sheet::law_rest;
    }

    const Cam& cam_;
    const CamGeometry& geometry_;
    const Mechanism& drawn_;
    Language language_;
};

}  // namespace

CamNotes notes_of(const Cam& cam, const CamGeometry& geometry, double drawn_at, const CycleTable& table,
                  const Mechanism& drawn, Language language) {
    CamNotes notes{drawn_at, CamData(cam, geometry, drawn, language).paragraphs(), {}};
    constexpr std::array<Key, 3> of_motion{lang::sheet::rise_of_the_follower, lang::sheet::speed_of_the_follower,
                                           lang::sheet::acceleration_of_the_follower};
    for (std::size_t i = 0; i < of_motion.size(); ++i) {
        RichText caption = one_piece(word(of_motion.at(i), language) + "  ");
        append(caption, typeset(table.columns[i + 1], drawn, language));
        notes.captions.push_back(std::move(caption));
    }
    notes.captions.push_back(one_piece(word(lang::sheet::pressure_angle_over_the_turn, language)));
    return notes;
}

}  // namespace kinegraph::render
