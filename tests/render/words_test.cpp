// Words: every sentence is said in every language, and symbols and numbers are set as textbooks set them.
#include "render/text/words.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/number/assert.hpp"

namespace words_test {
namespace {

using namespace kinegraph;
using namespace kinegraph::render;

Message with_all_arguments(Sentence sentence) {
    return {sentence, {PointName{"A"}, PointName{"B"}, PointName{"C"}, PointName{"D"}, PointName{"E"}}};
}

/// The names of the enumeration, in order, as the header spells them.
const std::vector<std::string>& sentence_names() {
    static const std::vector<std::string> names = [] {
        std::ifstream header(KINEGRAPH_TESTS_DIR "/../engine/sentences/statement.hpp");
        std::vector<std::string> found;
        std::string line;
        bool inside = false;
        while (std::getline(header, line)) {
            if (line.starts_with("enum class Sentence")) inside = true;
            if (line.starts_with("};")) inside = false;
            std::smatch match;
            static const std::regex name("^    ([a-z_]+),?( .*)?$");
            if (inside && std::regex_match(line, match, name)) found.push_back(match[1]);
        }
        if (found.empty()) throw std::runtime_error("the list of sentences is not where it was");
        return found;
    }();
    return names;
}
std::string name_in_sources(int sentence) { return sentence_names().at(static_cast<std::size_t>(sentence)); }

/// What follows `Sentence::` in the sources, where the sentences are said and not where they are worded.
const std::set<std::string>& said_in_sources() {
    static const std::set<std::string> said = [] {
        std::set<std::string> found;
        static const std::regex use("Sentence::([a-z_]+)");
        for (const char* room : {"engine", "constructions", "app"})
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

class EverySentence : public testing::TestWithParam<int> {};

TEST_P(EverySentence, IsSaidInBothLanguages) {
    const Message message = with_all_arguments(static_cast<Sentence>(GetParam()));
    const std::string english = plain(say(message, Language::en)), italian = plain(say(message, Language::it));
    for (const std::string& text : {english, italian}) {
        EXPECT_GE(text.size(), 5u);
        EXPECT_EQ(text.find_first_of("{}[]|~"), std::string::npos) << text;
        if (is_phrase(message.sentence)) {
            EXPECT_NE(text.back(), '.') << text;
            continue;
        }
        EXPECT_EQ(text.back(), '.') << text;
        // Of all bodies.
        if (message.sentence == Sentence::superposition_sum || message.sentence == Sentence::nothing_moves) continue;
        EXPECT_NE(text.find('A'), std::string::npos) << "the subject is named: " << text;
    }
    EXPECT_NE(english, italian);
}

TEST_P(EverySentence, LeavesOutWhatItIsNotTold) {
    const std::string text = plain(say({static_cast<Sentence>(GetParam()), {}}, Language::en));
    EXPECT_EQ(text.find_first_of("{}[]|~"), std::string::npos) << text;
}

INSTANTIATE_TEST_SUITE_P(Words, EverySentence, testing::Range(0, static_cast<int>(Sentence::count_)));

/// A sentence that no recipe says is dead; the sources are searched for each by its name.
TEST_P(EverySentence, IsSaidSomewhere) {
    EXPECT_TRUE(said_in_sources().count(name_in_sources(GetParam())) != 0) << name_in_sources(GetParam());
}

TEST(Words, SpeakOfOneOtherwiseThanOfSeveral) {
    const auto repeated = [](int rows) {
        return Message{Sentence::repeated_constraints, {PointName{"O2"}, Count{rows}}};
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
        return tell({Sentence::single_reaction, {BodyName{"B", as}, force}}, language);
    };
    EXPECT_TRUE(said(BodyName::As::body, Language::en).starts_with("On body B only"));
    EXPECT_TRUE(said(BodyName::As::pin, Language::en).starts_with("On pin B only"));
    EXPECT_TRUE(said(BodyName::As::pin, Language::it).starts_with("Sul perno B"));
}

TEST(Words, OfRollingSayTheTermOfTheirCase) {
    const auto rolls = [](RollingLever lever) {
        return tell({Sentence::rolling_point_on_rest_acceleration,
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
        Sentence::omega_by_sleeve,
        {Symbol{Symbol::Letter::omega, "3", ""}, Symbol{Symbol::Letter::omega, "4", ""}, PointName{"D"}}};
    EXPECT_NE(plain(say(message, Language::en)).find("\u00A0=\u00A0"), std::string::npos);
    EXPECT_EQ(tell(message, Language::en).find("\u00A0"), std::string::npos) << "files have plain blanks";
}

TEST(Words, RowsAreSeparatedAndLeftOutWhereTheyAreEmpty) {
    const Symbols open{{Symbol::Letter::F, "32", ""}, {Symbol::Letter::M, "C", ""}};
    EXPECT_TRUE(tell({Sentence::indeterminate, {Count{2}, Names{"A", "O2"}, open}}, Language::en)
                    .starts_with("statically indeterminate, 2 times: joints A, O2 repeat what"));
    EXPECT_TRUE(tell({Sentence::effort_without_work, {open}}, Language::en).ends_with("; not determined: F_32, M_C"));
    EXPECT_TRUE(tell({Sentence::effort_without_work, {Symbols{}}}, Language::en).ends_with("without limit"));
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

TEST(Words, AKeyWithoutWordsIsAFaultOfOurs) {
    EXPECT_THROW(word("no such key", Language::en), Fault);
    EXPECT_EQ(word("velocity polygon", Language::it), "Poligono delle velocità");
}

TEST(Words, ALanguageThatATitleLacksIsServedByTheOther) {
    EXPECT_EQ(in(Words{"Crank", ""}, Language::it), "Crank");
    EXPECT_EQ(in(Words{"Crank", "Manovella"}, Language::it), "Manovella");
}

}  // namespace
}  // namespace words_test
