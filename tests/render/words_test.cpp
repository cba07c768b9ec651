// Words: every sentence is said in every language, and symbols and numbers are set as textbooks set them.
#include "render/text/words.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/number/assert.hpp"
#include "lang/keys/cams.hpp"
#include "lang/keys/cases.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/drivers.hpp"
#include "lang/keys/exercises.hpp"
#include "lang/keys/expressions.hpp"
#include "lang/keys/files.hpp"
#include "lang/keys/forms.hpp"
#include "lang/keys/joints.hpp"
#include "lang/keys/laws.hpp"
#include "lang/keys/library.hpp"
#include "lang/keys/loads.hpp"
#include "lang/keys/materials.hpp"
#include "lang/keys/phrases.hpp"
#include "lang/keys/points.hpp"
#include "lang/keys/positions.hpp"
#include "lang/keys/sentences.hpp"
#include "lang/keys/sheet.hpp"
#include "lang/keys/tools.hpp"
#include "lang/keys/units.hpp"
#include "lang/keys/wishes.hpp"
#include "lang/pattern.hpp"
#include "render/scene/sentences.hpp"
#include "tests/support/files.hpp"
#include "tests/support/pages.hpp"

namespace words_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;

Message with_all_arguments(Key sentence) {
    return {sentence, {PointName{"A"}, PointName{"B"}, PointName{"C"}, PointName{"D"}, PointName{"E"}}};
}

/// All sentences, then all phrases.
const std::vector<Key>& all_sentences() {
    static const std::vector<Key> all = [] {
        std::vector<Key> found;
        for (const lang::Section* section : {&lang::sentences_section, &lang::phrases_section})
            for (std::size_t i = 0; i < section->size(); ++i) found.push_back({section, i});
        return found;
    }();
    return all;
}

/// The names that follow `lang::sentences::`, `lang::phrases::` or a `using` of them in the sources.
const std::set<std::string>& said_in_sources() {
    static const std::set<std::string> said = [] {
        std::set<std::string> found;
        static const std::regex use("(?:sentences|phrases)::([a-z_]+)");
        // Those that say the same of several subjects are chosen where sentences are told together.
        for (const char* room : {"engine", "constructions", "app", "render/scene"})
            for (const auto& file : std::filesystem::recursive_directory_iterator(
                     std::filesystem::path(KINEGRAPH_TESTS_DIR).parent_path() / room)) {
                if (file.path().extension() != ".cpp") continue;
                std::ifstream source(file.path());
                const std::string text{std::istreambuf_iterator<char>(source), {}};
                for (std::sregex_iterator at(text.begin(), text.end(), use), end; at != end; ++at)
                    found.insert((*at)[1]);
            }
        return found;
    }();
    return said;
}

/// All string literals of the product's sources, without their quotes.
std::set<std::string> literals_of_sources() {
    std::set<std::string> found;
    static const std::regex literal("\"((?:[^\"\\\\\n]|\\\\.)*)\"");
    for (const char* part : {"engine", "constructions", "render", "app"})
        for (const auto& file : std::filesystem::recursive_directory_iterator(
                 std::filesystem::path(KINEGRAPH_TESTS_DIR).parent_path() / part)) {
            if (file.path().extension() != ".cpp" && file.path().extension() != ".hpp") continue;
            const std::string text = tests::contents(file.path());
            for (std::sregex_iterator at(text.begin(), text.end(), literal), end; at != end; ++at)
                found.insert((*at)[1]);
        }
    return found;
}

TEST(Words, OfOtherLanguagesAreInTheirFilesAlone) {
    const std::set<std::string> literals = literals_of_sources();
    ASSERT_GT(literals.size(), 1000U);
    std::size_t looked_at = 0;
    for (const lang::Section* section : lang::all_sections())
        for (std::size_t i = 0; i < section->size(); ++i)
            for (const Language language : languages) {
                const std::string& text = section->text(i, language);
                if (text == section->text(i, Language::en) || text.size() < 8) continue;
                ++looked_at;
                EXPECT_FALSE(literals.contains(text)) << text;
            }
    EXPECT_GT(looked_at, 6000U);
}

/// The colons and semicolons after which a text goes on, or ends, and before which there is no space; with what stands
/// before them. Those after a quotation mark are of the file's format.
std::vector<std::string> unspaced_marks(const std::string& text) {
    std::vector<std::string> found;
    static const std::regex mark("[^ ~\"\n]{0,12}([^ ~\"\n])[:;](?= |$|\n)");
    for (std::sregex_iterator at(text.begin(), text.end(), mark), end; at != end; ++at)
        if (!at->str(1).ends_with('\xA0')) found.push_back(at->str());
    return found;
}

TEST(Words, OfFrenchHaveASpaceBeforeAColonAndASemicolon) {
    EXPECT_EQ(unspaced_marks("a\u00A0: b; c").size(), 1U);
    for (const lang::Section* section : lang::all_sections())
        for (std::size_t i = 0; i < section->size(); ++i) {
            const std::string& text = section->text(i, Language::fr);
            EXPECT_EQ(unspaced_marks(text), std::vector<std::string>()) << section->name(i);
            for (const char* mark : {" :", " ;"}) EXPECT_EQ(text.find(mark), std::string::npos) << text;
        }
    std::size_t colons = 0;
    for (const char* name : {"four_bar", "truss_simple", "planetary_train", "sluice_gate", "cam_from_law",
                             "contact/roller_in_ring", "contact/rod_hit_off_centre", "motion/projectile"}) {
        const Solution& solution = tests::example(name);
        std::string said = results_table(solution, Language::fr);
        for (const SheetKind kind : {SheetKind::solution, SheetKind::question}) {
            SheetOptions options = tests::options_of({Language::fr});
            options.kind = kind;
            said += pages::words_of(lay_out(solution, options, tests::fonts()));
        }
        EXPECT_EQ(unspaced_marks(said), std::vector<std::string>()) << name;
        colons += static_cast<std::size_t>(std::count(said.begin(), said.end(), ':'));
    }
    EXPECT_GT(colons, 50U);
}

/// The places of a text: 0, 1 …, also those that a case or a choice of words refers to.
std::set<char> places_of(const std::string& text) {
    std::set<char> places;
    static const std::regex place("\\{([0-9])[ |}]");
    for (std::sregex_iterator at(text.begin(), text.end(), place), end; at != end; ++at)
        places.insert((*at)[1].str().front());
    return places;
}

TEST(Words, OfToolsStandForTextsOfTheSameNameAndQuoteNoFile) {
    const lang::Section& tools = lang::tools_section;
    std::size_t spoken_of_the_file = 0;
    for (const Key& sentence : all_sentences()) {
        std::optional<Key> said;
        for (std::size_t i = 0; i < tools.size(); ++i)
            if (tools.name(i) == sentence.name()) said = Key{&tools, i};
        for (const Language language : languages) {
            const std::string& of_file = sentence.in(language);
            if (of_file.find('"') != std::string::npos) {
                ++spoken_of_the_file;
                EXPECT_TRUE(said) << of_file << " has no text for those who draw";
            }
            if (!said) continue;
            EXPECT_EQ(said->in(language).find('"'), std::string::npos) << said->in(language);
            const std::set<char> has = places_of(of_file);
            for (const char place : places_of(said->in(language))) EXPECT_TRUE(has.contains(place)) << of_file;
        }
    }
    EXPECT_GE(spoken_of_the_file, 5 * languages.size());
    for (std::size_t i = 0; i < tools.size(); ++i)
        EXPECT_TRUE(std::ranges::any_of(all_sentences(), [&](const Key& each) { return each.name() == tools.name(i); }))
            << tools.name(i);
}

TEST(Words, HaveThePlacesOfEnglishInEveryLanguage) {
    ASSERT_GT(lang::all_sections().size(), 30U);
    for (const lang::Section* section : lang::all_sections())
        for (std::size_t i = 0; i < section->size() && section != &lang::cases_section; ++i)
            for (const Language language : languages) {
                // A kind of joint is called by its key in Italian.
                if (section == &lang::joints_section && places_of(section->text(i, Language::en)).empty()) continue;
                EXPECT_EQ(places_of(section->text(i, language)), places_of(section->text(i, Language::en)))
                    << section->name(i) << ": " << section->text(i, language);
            }
}

TEST(Words, OfAFaultHaveTheirRemedyInEveryLanguage) {
    std::size_t remedies = 0;
    for (const lang::Section* section :
         {&lang::cams_section, &lang::drivers_section, &lang::exercises_section, &lang::expressions_section,
          &lang::files_section, &lang::forms_section, &lang::joints_section, &lang::laws_section, &lang::loads_section,
          &lang::materials_section, &lang::points_section, &lang::positions_section, &lang::units_section,
          &lang::wishes_section, &lang::library_section})
        for (std::size_t i = 0; i < section->size(); ++i) {
            const Words message(Key{section, i});
            const bool has_one = !message.in_two(Language::en).remedy.empty();
            remedies += has_one ? 1 : 0;
            for (const Language language : languages)
                EXPECT_EQ(!message.in_two(language).remedy.empty(), has_one)
                    << section->name(i) << ": " << message.in(language);
        }
    EXPECT_GT(remedies, 80U);
}

TEST(Words, OfAFaultAreInTwo) {
    const Words proposal(lang::common::did_you_mean, std::string("\"omega\""));
    const Words unknown(lang::forms::no_point_is_named, std::string("\"a;b\""), proposal);
    EXPECT_EQ(unknown.in_two(Language::en).fault, "no point is named \"a;b\"");
    EXPECT_EQ(unknown.in_two(Language::en).remedy, "did you mean \"omega\"?");
    const Words semicolon(lang::drivers::the_frame_does_not_move_drive);
    EXPECT_EQ(semicolon.in_two(Language::en).fault, "the frame does not move");
    EXPECT_EQ(semicolon.in_two(Language::en).remedy, "drive another body");
    EXPECT_EQ(semicolon.in_two(Language::fr).fault.find(';'), std::string::npos);
    EXPECT_FALSE(semicolon.in_two(Language::fr).fault.ends_with("\u00A0"));
    const Words one(std::string("a file's own text; with a semicolon"));
    EXPECT_EQ(one.in_two(Language::en).fault, "a file's own text; with a semicolon");
    EXPECT_TRUE(one.in_two(Language::en).remedy.empty());
}

class EverySentence : public testing::TestWithParam<Key> {};

TEST_P(EverySentence, IsSaidInEveryLanguage) {
    const Message message = with_all_arguments(GetParam());
    std::set<std::string> all;
    for (const Language language : languages) {
        const std::string text = plain(say(message, language));
        all.insert(text);
        EXPECT_GE(text.size(), 5u);
        EXPECT_EQ(text.find_first_of("{}[]|~"), std::string::npos) << text;
        if (is_phrase(message.sentence)) {
            EXPECT_NE(text.back(), '.') << text;
            continue;
        }
        EXPECT_EQ(text.back(), '.') << text;
        // Of all bodies.
        if (message.sentence == lang::sentences::superposition_sum ||
            message.sentence == lang::sentences::nothing_moves)
            continue;
        EXPECT_NE(text.find('A'), std::string::npos) << "the subject is named: " << text;
    }
    EXPECT_GT(all.size(), 3U);  // French and Spanish, say, may have one word for a thing
}

TEST_P(EverySentence, LeavesOutWhatItIsNotTold) {
    const std::string text = plain(say({GetParam(), {}}, Language::en));
    EXPECT_EQ(text.find_first_of("{}[]|~"), std::string::npos) << text;
}

INSTANTIATE_TEST_SUITE_P(Words, EverySentence, testing::ValuesIn(all_sentences()));

/// A sentence that no recipe says is dead; the sources are searched for each by its name.
TEST_P(EverySentence, IsSaidSomewhere) {
    EXPECT_TRUE(said_in_sources().count(GetParam().name()) != 0) << GetParam().name();
}

/// The face of the first piece with this text.
std::optional<render::Face> face_of(const RichText& text, const std::string& words) {
    for (const Piece& each : text)
        if (each.text == words) return each.face;
    return std::nullopt;
}

TEST(Words, SetLettersOfQuantitiesItalicInEveryLanguage) {
    const Symbol force{Symbol::Letter::F, "i3", ""}, couple{Symbol::Letter::M, "i3", ""};
    const Symbol a{Symbol::Letter::a, "G", ""}, alpha{Symbol::Letter::alpha, "3", ""};
    for (const Language language : languages) {
        const RichText of_force =
            say({lang::sentences::inertia_force, {BodyName{"3"}, force, a, PointName{"G"}}}, language);
        const RichText of_couple = say({lang::sentences::inertia_couple, {BodyName{"3"}, couple, alpha}}, language);
        const RichText moved = say({lang::sentences::inertia_moved, {BodyName{"3"}, force, couple}}, language);
        EXPECT_EQ(face_of(of_force, "m"), render::Face::italic) << plain(of_force);
        EXPECT_EQ(face_of(of_couple, "J"), render::Face::italic) << plain(of_couple);
        EXPECT_EQ(face_of(moved, "d"), render::Face::italic) << plain(moved);
    }
}

TEST(Words, OfSubscriptsAreUprightAndNamesItalic) {
    const auto subscript = [](const std::string& name) {
        return typeset(Symbol{Symbol::Letter::F, name, ""}, Language::en).front().sub_face;
    };
    for (const char* word : {"F_cut", "F_gas", "F_hand", "F_Schnitt", "cut", "g2", "12"})
        EXPECT_EQ(subscript(word), render::Face::regular) << word;
    for (const char* name : {"B", "AB", "p", "R4", "β"}) EXPECT_EQ(subscript(name), render::Face::italic) << name;
}

/// Sentences that differ in points alone are one sentence with all of them; what differs otherwise stays apart.
TEST(Words, OfSeveralPointsAreToldTogether) {
    const auto translating = [](const char* body, const char* point) {
        return Message{lang::sentences::translating_velocity,
                       {BodyName{body}, PointName{point}, Symbol{Symbol::Letter::v, point, ""}}};
    };
    const Message b = translating("4", "B"), c = translating("4", "C"), other = translating("5", "D");
    EXPECT_TRUE(may_be_told_together(b, c));
    EXPECT_FALSE(may_be_told_together(b, other));
    EXPECT_FALSE(may_be_told_together(b, {lang::sentences::translating_acceleration, b.arguments}));
    EXPECT_EQ(plain(say(told_together({&b, &c}), Language::en)), "Body 4 translates, so B, C move alike: v_B, v_C.");
    const auto turning = [](const char* point, const char* omega) {
        return Message{lang::sentences::crank_velocity,
                       {BodyName{"2"}, PointName{"O"}, PointName{point}, Symbol{Symbol::Letter::v, point, ""},
                        Symbol{Symbol::Letter::omega, omega, ""}}};
    };
    EXPECT_TRUE(may_be_told_together(turning("A", "2"), turning("B", "2")));
    EXPECT_FALSE(may_be_told_together(turning("A", "2"), turning("B", "3")));
}

TEST(Words, SpeakOfOneOtherwiseThanOfSeveral) {
    const auto repeated = [](int rows) {
        return Message{lang::sentences::repeated_constraints, {PointName{"O2"}, Count{rows}}};
    };
    EXPECT_EQ(tell(repeated(1), Language::it),
              "La coppia O2 ripete 1 vincolo che le altre impongono già in questa configurazione.");
    EXPECT_EQ(tell(repeated(2), Language::it),
              "La coppia O2 ripete 2 vincoli che le altre impongono già in questa configurazione.");
    EXPECT_NE(plain(say(repeated(1), Language::en)).find("Joint O_2 repeats 1 constraint that"), std::string::npos);
}

TEST(Words, OfAPinDoNotCallItABody) {
    const Symbol force{Symbol::Letter::F, "1B", ""};
    const auto said = [&](BodyName::As as, Language language) {
        return tell({lang::sentences::single_reaction, {BodyName{"B", as}, force}}, language);
    };
    EXPECT_TRUE(said(BodyName::As::body, Language::en).starts_with("On body B only"));
    EXPECT_TRUE(said(BodyName::As::pin, Language::en).starts_with("On pin B only"));
    EXPECT_TRUE(said(BodyName::As::pin, Language::it).starts_with("Sul perno B"));
}

TEST(Words, OfRollingSayTheTermOfTheirCase) {
    const auto rolls = [](RollingLever lever) {
        return tell({lang::sentences::rolling_point_on_rest_acceleration,
                     {PointName{"P"}, BodyName{"2"}, BodyName{"1"}, Symbol{Symbol::Letter::a, "P", ""}, PointName{"P*"},
                      Symbol{Symbol::Letter::a, "P", ""}, lever}},
                    Language::en);
    };
    EXPECT_NE(rolls(RollingLever::on_straight).find("ω^2 r."), std::string::npos) << rolls(RollingLever::on_straight);
    EXPECT_NE(rolls(RollingLever::outside).find("R r/(R + r)"), std::string::npos);
    EXPECT_NE(rolls(RollingLever::inside).find("R r/(R − r)"), std::string::npos);
}

TEST(Words, HoldAnEquationTogether) {
    const Message message{
        lang::sentences::omega_by_sleeve,
        {Symbol{Symbol::Letter::omega, "3", ""}, Symbol{Symbol::Letter::omega, "4", ""}, PointName{"D"}}};
    EXPECT_NE(plain(say(message, Language::en)).find("\u00A0=\u00A0"), std::string::npos);
    EXPECT_EQ(tell(message, Language::en).find("\u00A0"), std::string::npos) << "files have plain blanks";
}

TEST(Words, RowsAreSeparatedAndLeftOutWhereTheyAreEmpty) {
    const Symbols open{{Symbol::Letter::F, "32", ""}, {Symbol::Letter::M, "C", ""}};
    EXPECT_TRUE(tell({lang::phrases::indeterminate, {Count{2}, Names{"A", "O2"}, open}}, Language::en)
                    .starts_with("statically indeterminate, 2 times: joints A, O2 repeat what"));
    EXPECT_TRUE(
        tell({lang::phrases::effort_without_work, {open}}, Language::en).ends_with("; not determined: F_32, M_C"));
    EXPECT_TRUE(tell({lang::phrases::effort_without_work, {Symbols{}}}, Language::en).ends_with("without limit"));
}

TEST(Words, AVectorIsBoldItalicWithItsTermUpright) {
    const RichText text = typeset(Symbol{Symbol::Letter::a, "BA", "t"}, Language::en);
    ASSERT_EQ(text.size(), 1u);
    EXPECT_EQ(text[0].face, render::Face::bold_italic);
    EXPECT_EQ(text[0].sub, "BA");
    EXPECT_EQ(text[0].sup, "t");
    EXPECT_EQ(text[0].sup_face, render::Face::regular);
}

TEST(Words, AngularAccelerationIsADottedOmegaInItalian) {
    const Symbol alpha{Symbol::Letter::alpha, "3", ""};
    EXPECT_EQ(typeset(alpha, Language::en)[0].text, "α");
    EXPECT_EQ(typeset(alpha, Language::it)[0].text, "ω");
    EXPECT_EQ(typeset(alpha, Language::it)[0].dots, 1);
    EXPECT_EQ(typeset(alpha, Language::it)[0].sub_face, render::Face::regular) << "digits stand upright";
}

TEST(Words, CentresArePInEnglishAndCInItalian) {
    const Symbol centre{Symbol::Letter::centre, "13", ""};
    EXPECT_EQ(plain(typeset(centre, Language::en)), "P_13");
    EXPECT_EQ(plain(typeset(centre, Language::it)), "C_13");
}

TEST(Words, ImagesAreLowerCaseAndPrimedForAccelerations) {
    EXPECT_EQ(plain(typeset(Symbol{Symbol::Letter::image, "A", ""}, Language::en)), "a");
    EXPECT_EQ(plain(typeset(Symbol{Symbol::Letter::image, "A", "'"}, Language::en)), "a′");
    EXPECT_EQ(plain(typeset(Symbol{Symbol::Letter::pole, "v", ""}, Language::en)), "o_v");
}

TEST(Words, TheNumberOfAPointIsLowered) {
    const RichText text = typeset(Symbol{Symbol::Letter::point, "O2", ""}, Language::en);
    ASSERT_EQ(text.size(), 1u);
    EXPECT_EQ(text[0].text, "O");
    EXPECT_EQ(text[0].sub, "2");
}

TEST(Words, NamesHoldNoTypography) {
    EXPECT_EQ(name_of({Symbol::Letter::v, "B", ""}), "v_B");
    EXPECT_EQ(name_of({Symbol::Letter::a, "BA", "t"}), "a_BA_t");
    EXPECT_EQ(name_of({Symbol::Letter::omega, "3", ""}), "omega_3");
    EXPECT_EQ(name_of({Symbol::Letter::centre, "13", "∞"}), "P_13");
    EXPECT_EQ(name_of({Symbol::Letter::image, "B", "'"}), "b'");
    EXPECT_EQ(name_of({Symbol::Letter::point, "O2", ""}), "O2");
}

TEST(Words, AJointsNameIsNoPoint) {
    const LineReason own{LineReason::Kind::parallel_to_guide, "ram", "", true},
        word{LineReason::Kind::parallel_to_guide, "guide 2", "", true};
    EXPECT_EQ(plain(typeset(own, Language::en)), "∥\u00a0guide\u00a0ram");
    EXPECT_EQ(typeset(own, Language::en).back().face, render::Face::regular);
    EXPECT_EQ(plain(typeset(word, Language::en)), "∥\u00a0guide 2");
}

TEST(Words, ACoupleMayHaveASymbolOfItsOwn) {
    const auto set = [](const char* name) { return plain(typeset(Symbol{Symbol::Letter::M, name, ""}, Language::en)); };
    EXPECT_EQ(set("T4"), "T_4");
    EXPECT_EQ(set("M_1"), "M_1");
    EXPECT_EQ(set("C"), "M_C");
    EXPECT_EQ(set("Twist"), "M_Twist");
    EXPECT_EQ(name_of(Symbol{Symbol::Letter::M, "T4", ""}), "T4");
}

/// "F1" and "M4" are how a lecturer writes F₁ and M₄.
TEST(Words, ALoadsNumberIsLowered) {
    const auto set = [](Symbol::Letter letter, const char* name) {
        return plain(typeset(Symbol{letter, name, ""}, Language::it));
    };
    EXPECT_EQ(set(Symbol::Letter::M, "M4"), "M_4");
    EXPECT_EQ(set(Symbol::Letter::F, "F1"), "F_1");
    EXPECT_EQ(set(Symbol::Letter::F, "F12"), "F_12");
    EXPECT_EQ(name_of(Symbol{Symbol::Letter::M, "M4", ""}), "M4");
    // The letter of another kind is none of its own, nor is a word.
    EXPECT_EQ(set(Symbol::Letter::F, "M4"), "F_M4");
    EXPECT_EQ(set(Symbol::Letter::F, "Fan2"), "F_Fan2");
}

TEST(Words, DirectionsOfLines) {
    EXPECT_EQ(plain(typeset(LineReason{LineReason::Kind::perpendicular_to_segment, "O2", "A"}, Language::en)),
              "⟂\u00a0O_2A");
    EXPECT_EQ(plain(typeset(LineReason{LineReason::Kind::parallel_to_guide, "B", ""}, Language::it)),
              "∥\u00a0guida\u00a0B");
}

TEST(Numbers, HaveATrueMinusAndTheCommaOfTheirLanguage) {
    EXPECT_EQ(number(-1.25, 3, Language::en), "−1.25");
    EXPECT_EQ(number(-1.25, 3, Language::it), "−1,25");
    EXPECT_EQ(number(0.318, 4, Language::en), "0.3180");
    EXPECT_EQ(number(0, 4, Language::en), "0");
}

TEST(Numbers, FarFromOneHavePowersOfTen) {
    EXPECT_EQ(number(1.5e-7, 2, Language::en), "1.5 × 10⁻⁷");
    EXPECT_EQ(number(2.5e9, 2, Language::it), "2,5 × 10⁹");
    EXPECT_EQ(number(12345, 5, Language::en), "12345");
}

TEST(Numbers, NeverSayMinusZero) {
    EXPECT_EQ(fixed(-0.001, 2, Language::en), "0.00");
    EXPECT_EQ(fixed(-0.006, 2, Language::en), "−0.01");
    EXPECT_EQ(fixed(3.14159, 2, Language::it), "3,14");
}

TEST(Words, PartsOfARelativeMotionHaveTheLettersOfTheLanguage) {
    const auto set = [](const char* term, Language language) {
        return plain(typeset(Symbol{Symbol::Letter::v, "B", term}, language));
    };
    EXPECT_EQ(set("tr", Language::en), "v_B^tr");
    EXPECT_EQ(set("tr", Language::fr), "v_B^e");
    EXPECT_EQ(set("rel,2", Language::fr), "v_B^r,2");
    EXPECT_EQ(set("tr", Language::de), "v_B^F");
    EXPECT_EQ(set("cor", Language::de), "v_B^C");
    EXPECT_EQ(set("tr", Language::es), "v_B^arr");
    EXPECT_EQ(set("n", Language::fr), "v_B^n");
    EXPECT_EQ(name_of(Symbol{Symbol::Letter::v, "B", "tr"}), "v_B_tr") << "names in files have no language";
}

TEST(Patterns, HavePlacesForArgumentsAlone) {
    const auto place = lang::place_at("a {3 of} b", 2);
    ASSERT_TRUE(place);
    EXPECT_EQ(place->argument, 3U);
    EXPECT_EQ(place->grammatical_case, "of");
    EXPECT_EQ(place->end, 8U);
    const auto choice = lang::place_at("{1|is|are}", 0);
    ASSERT_TRUE(choice);
    EXPECT_TRUE(choice->chooses);
    EXPECT_EQ(choice->one, "is");
    EXPECT_EQ(choice->several, "are");
    for (const char* const text : {"{E_1}", "{0", "{0x}", "{", "0}", "{}"})
        EXPECT_FALSE(lang::place_at(text, 0)) << text;
    EXPECT_EQ(formula_words("{ω_{0}} = {1}{2}", {std::string("3"), std::string("5")}).in(Language::en), "{ω_3} = 5{2}");
}

TEST(Words, AreSaidInARowAndWithinEachOther) {
    Words row(std::string("1 "));
    row += Words(lang::sheet::body);
    EXPECT_EQ(row.in(Language::en), "1 body");
    EXPECT_EQ(row.in(Language::it), "1 corpo");
    EXPECT_EQ(formula_words("({0}, {0})", {row}).in(Language::it), "(1 corpo, 1 corpo)");
    EXPECT_EQ(row, Words(std::string("1 ")) + lang::sheet::body);
    EXPECT_TRUE((Words() + Words()).empty());
}

}  // namespace
}  // namespace words_test
