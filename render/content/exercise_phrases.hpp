// Phrases of an exercise: names, amounts, directions and bodies within sentences. Owns how each is written, not which
// sentences there are.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/content/exercise_text.hpp"

namespace kinegraph::render {

/// The context of a text made of sentences, and the sentences so far.
class ExercisePhrases {
protected:
    explicit ExercisePhrases(const DrawingContext& context)
        : context_(context),
          solution_(context.solution),
          mechanism_(context.solution.mechanism),
          units_(mechanism_.units) {}

    Language language() const { return context_.language; }
    static RichText plain_words(const std::string& words) { return one_piece(words); }
    RichText amount(const Exact& si, const Unit& unit) const { return given_amount(si, unit, language()); }
    RichText scalar(const Symbol& of) const { return letter(of.letter, of.about, of.term); }
    RichText filled(Key key, const std::vector<RichText>& parts) const { return word(key, parts, language()); }
    void say(Key key, const std::vector<RichText>& parts) { rows_.push_back(filled(key, parts)); }
    RichText name(PointIndex point) const;
    RichText number_of(double value) const;
    /// A fraction such as 1/3 if its decimals would not end.
    RichText ratio(const Exact& value) const;
    RichText angle(const Angle& angle) const;
    RichText pair(double x, double y) const;
    RichText vector(const Vector& si, const Unit& unit) const;
    RichText join(PointIndex from, PointIndex to) const;
    RichText bearing(const Bearing& bearing) const;
    RichText place(const kinegraph::Place& place) const;
    static RichText equation(RichText left, const RichText& right);
    /// A bearing, with words where bare numbers would look like a position.
    RichText direction(const Bearing& of) const;
    /// The name in a list of the bodies of a hinge.
    std::string listed(BodyIndex body) const;
    /// "body 2", "bar AB", "the frame"; "of body 2", "of bar AB", "of the frame".
    RichText subject(BodyIndex body) const;
    RichText owner(BodyIndex body) const;
    RichText called(BodyIndex body, Key as_frame, Key as_body) const;
    /// A bearing; words mark its components, which would look like a position otherwise.
    RichText way(const Bearing& of) const;
    /// "along AB", "along 0°".
    RichText course(const Bearing& of) const;
    RichText letter(Symbol::Letter letter, const std::string& about, const std::string& term = "") const;
    RichText symbol_of_force(const std::string& given, Symbol::Letter letter) const;
    /// The name of a bar of a truss, from its pins.
    std::string bar(BodyIndex body) const;
    /// Between points that the file names, otherwise by its angle in the drawn position.
    RichText positive_sense(JointIndex index) const;
    RichText positive_sense(const Bearing& of) const;
    /// "on body 3", "on the frame".
    RichText acting_on(BodyIndex body) const;
    RichText acting_from(BodyIndex body) const;

    const DrawingContext& context_;
    const Solution& solution_;
    const Mechanism& mechanism_;
    const Units& units_;
    std::vector<RichText> rows_;
};

}  // namespace kinegraph::render
