// Words: every sentence is said in every language, and symbols and numbers are set as textbooks set them.
#include "render/words.hpp"

#include <gtest/gtest.h>

#include "engine/assert.hpp"

namespace {

using namespace kinegraph;
using namespace kinegraph::render;

Message with_all_arguments(Sentence sentence) {
    return {sentence, {PointName{"A"}, PointName{"B"}, PointName{"C"}, PointName{"D"}, PointName{"E"}}};
}

class EverySentence : public testing::TestWithParam<int> {};

TEST_P(EverySentence, IsSaidInBothLanguages) {
    const Message message = with_all_arguments(static_cast<Sentence>(GetParam()));
    const std::string english = plain(say(message, Language::en)), italian = plain(say(message, Language::it));
    for (const std::string& text : {english, italian}) {
        EXPECT_GT(text.size(), 10u);
        EXPECT_EQ(text.find_first_of("{}[]"), std::string::npos) << text;
        EXPECT_EQ(text.back(), '.') << text;
        if (message.sentence == Sentence::superposition_sum) continue;  // of all bodies
        EXPECT_NE(text.find('A'), std::string::npos) << "the subject is named: " << text;
    }
    EXPECT_NE(english, italian);
}

TEST_P(EverySentence, LeavesOutWhatItIsNotTold) {
    const std::string text = plain(say({static_cast<Sentence>(GetParam()), {}}, Language::en));
    EXPECT_EQ(text.find_first_of("{}[]"), std::string::npos) << text;
}

INSTANTIATE_TEST_SUITE_P(Words, EverySentence, testing::Range(0, static_cast<int>(Sentence::count_)));

TEST(Words, AVectorIsBoldItalicWithItsTermUpright) {
    const RichText text = typeset(Symbol{Symbol::Letter::a, "BA", "t"}, Language::en);
    ASSERT_EQ(text.size(), 1u);
    EXPECT_EQ(text[0].face, Face::bold_italic);
    EXPECT_EQ(text[0].sub, "BA");
    EXPECT_EQ(text[0].sup, "t");
    EXPECT_EQ(text[0].sup_face, Face::regular);
}

TEST(Words, AngularAccelerationIsADottedOmegaInItalian) {
    const Symbol alpha{Symbol::Letter::alpha, "3", ""};
    EXPECT_EQ(typeset(alpha, Language::en)[0].text, "α");
    EXPECT_EQ(typeset(alpha, Language::it)[0].text, "ω");
    EXPECT_EQ(typeset(alpha, Language::it)[0].dots, 1);
    EXPECT_EQ(typeset(alpha, Language::it)[0].sub_face, Face::regular) << "digits stand upright";
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

TEST(Words, DirectionsOfLines) {
    EXPECT_EQ(plain(typeset(LineReason{LineReason::Kind::perpendicular_to_segment, "O2", "A"}, Language::en)), "⟂\u00a0O_2A");
    EXPECT_EQ(plain(typeset(LineReason{LineReason::Kind::parallel_to_guide, "B", ""}, Language::it)), "∥\u00a0guida\u00a0B");
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
