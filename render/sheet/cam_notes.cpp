#include "render/sheet/cam_notes.hpp"

#include <array>
#include <numbers>
#include <string_view>

#include "render/content/exercise_text.hpp"
#include "render/figures/plot_figure.hpp"
#include "render/mechanism/sketch.hpp"

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
    std::string in_words(std::string_view key) const { return word(key, language_); }
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
    void add(RichText& line, std::string_view key, const RichText& name, const RichText& value) const {
        if (!line.empty()) append(line, "; ");
        append(line, in_words(key) + " ");
        append(line, name);
        append(line, name.empty() ? "" : " = ");
        append(line, value);
    }

    RichText cam_itself() const {
        RichText line;
        add(line, "base circle", symbol("r", "b"), length(cam_.base_circle));
        add(line, cam_.omega.sign() > 0 ? "cam turns counter-clockwise" : "cam turns clockwise",
            symbol("ω", drawn_.bodies[1].name), given_amount(cam_.omega, cam_.units.angular_velocity, language_));
        return line;
    }
    RichText follower() const {
        const Follower& follower = cam_.follower;
        RichText line;
        const bool translates = follower.moves == Follower::Moves::translating;
        switch (follower.face) {
            case Follower::Face::roller:
                add(line, translates ? "translating roller" : "oscillating roller", symbol("r", "r"),
                    length(follower.radius));
                break;
            case Follower::Face::flat:
                line = one_piece(in_words(translates ? "translating flat" : "oscillating flat"));
                break;
            case Follower::Face::knife_edge:
                line = one_piece(in_words(translates ? "translating edge" : "oscillating edge"));
                break;
        }
        const bool is_flat = follower.face == Follower::Face::flat;
        if (translates != is_flat) add(line, "offset", symbol("e", ""), length(follower.offset));
        if (translates) return line;
        const double unit = cam_.units.length.si.to_double();
        const std::string place =
            pair_of(drawing::given_number(follower.pivot.x.to_double() / unit, language_),
                    drawing::given_number(follower.pivot.y.to_double() / unit, language_), language_);
        add(line, "pivot", one_piece("Q", Face::italic), with_powers(place + " " + cam_.units.length.symbol));
        if (!is_flat) add(line, "arm", {}, length(follower.arm));
        return line;
    }
    /// β is not an angle of the drawing, where angles are positive counter-clockwise.
    RichText sign_of_rise() const {
        const bool is_left = geometry_.rises() > 0;
        const std::string& name = drawn_.bodies.back().name;
        RichText line = one_piece(in_words(is_left ? "rise is counter-clockwise" : "rise is clockwise") + " ");
        append(line, symbol("ω", name));
        append(line, std::string(is_left ? " = " : " = −") + in_words("rise angle rate") + ", ");
        append(line, symbol(notation(language_).alpha, name, notation(language_).alpha_dots));
        append(line, std::string(is_left ? " = " : " = −"));
        append(line, with_powers(in_words("rise angle acceleration")));
        return line;
    }
    RichText piece_of_law(const LawPiece& piece, double from, double to) const {
        RichText line = one_piece(degrees(from) + "–" + degrees(to) + ": ");
        if (piece.form == LawForm::rest || piece.rise.is_zero()) {
            append(line, in_words("law rest"));
            return line;
        }
        const Exact by = piece.rise.sign() < 0 ? -piece.rise : piece.rise;
        append(line, in_words(piece.rise.sign() > 0 ? "law rise" : "law return") + " ");
        if (cam_.follower.moves == Follower::Moves::oscillating)
            append(line, degrees(by.to_double()));
        else
            append(line, length(by));
        append(line, ", " + in_words(key_of(piece.form)));
        return line;
    }
    static std::string_view key_of(LawForm form) {
        switch (form) {
            case LawForm::rest: return "law rest";
            case LawForm::constant_speed: return "law constant speed";
            case LawForm::constant_acceleration: return "law constant acceleration";
            case LawForm::harmonic: return "law harmonic";
            case LawForm::cycloidal: return "law cycloidal";
            case LawForm::polynomial_345: return "law 3-4-5";
            case LawForm::modified_trapezoidal: return "law modified trapezoidal";
        }
        return "law rest";
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
    constexpr std::array<std::string_view, 3> of_motion{"rise of the follower", "speed of the follower",
                                                        "acceleration of the follower"};
    for (std::size_t i = 0; i < of_motion.size(); ++i) {
        RichText caption = one_piece(word(of_motion.at(i), language) + "  ");
        append(caption, typeset(table.columns[i + 1], drawn, language));
        notes.captions.push_back(std::move(caption));
    }
    notes.captions.push_back(one_piece(word("pressure angle over the turn", language)));
    return notes;
}

}  // namespace kinegraph::render
