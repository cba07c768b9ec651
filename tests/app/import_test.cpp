// Links of PMKS+ become mechanism files that solve to what vector loops give; what is broken is refused in one line.
#include <kinegraph/kinegraph.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "tests/support/command_line.hpp"

namespace import_test {
namespace {

using namespace kinegraph;
using namespace std::complex_literals;
using Plane = std::complex<double>;

const std::string digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";
std::string with_checksum(const std::string& data) { return data + digits[data.size() % 62]; }

const std::string inverted_slider_crank =
    "2P.Fe.K,0.1011.MA,A,0,0,0.GB,B,0,Fe,0.KC,C,ku,0,0.GD,D,0RF,Oj,0.HP,P,0,Fe,0,CD,C,D.."
    "YRAB,AB,Fe,Fe,0,7q,c5cae9,A,B,,.YRCD,CD,Fe,Fe,9q,CN,303e9f,C,D,,.YPBP,BP,Fe,0,0,0,,B,P,,...N_r";
const std::string slotted_coupler =
    "2P.Fe.K,0.1011.MA,A,0,0,0.GB,B,Fe,0,0.GC,C,d4,ec,0.KD,D,_W,0,0.KE,E,VG,7q,0.GF,F,bo,cO,0.HP,P,bo,cO,0,BC,B,C.."
    "YRAB,AB,Fe,Fe,7q,0,c5cae9,A,B,,.YRBC,BC,Fe,Fe,RM,KJ,303e9f,B,C,,.YRCD,CD,Fe,Fe,oo,KJ,0d125a,C,D,,."
    "YREF,EF,Fe,Fe,YX,N6,B2DFDB,E,F,,.YPFP,FP,Fe,0,0,0,,F,P,,...N_L";
const std::string trammel =
    "2P.Fe.K,0.1011.GA,A,Fe,0,0.GB,B,0,Fe,0.LC,C,Fe,0,0.LD,D,0,Fe,OZ.."
    "YRAB,AB,Fe,Fe,7q,7q,c5cae9,A,B,,.YPAC,AC,Fe,0,0,0,,A,C,,.YPBD,BD,Fe,0,0,0,,B,D,,...N_Q";
const std::string slider_crank =
    "2P.Fe.K,0.1011.MA,A,0,0,0.GB,B,_W,VG,0.GC,C,2xW,0,0.GD,D,4uW,VG,0.LE,E,2xW,0,0.."
    "YRAB,AB,1E8,1a,VG,Fe,c5cae9,A,B,,.YRBCD,BCD,2SG,38,2xW,Kr,303e9f,B,C,D,,.YPCE,CE,Fe,0,0,0,,C,E,,...N_v";
const std::string stephenson =
    "2P.Fe.K,0.1011.MA,A,1jO,_W,0.GB,B,1E8,3w0,0.GC,C,66e,66e,0.KD,D,5dO,2SG,0.GE,E,4PG,8Yu,0.GF,F,AVu,7q0,0."
    "KG,G,A-8,49e,0..YRAB,AB,1E8,1a,1Tm,2SG,c5cae9,A,B,,.YRBCE,BCE,2SG,38,3w0,6Br,303e9f,B,C,E,,."
    "YRCD,CD,1E8,1a,5t0,4HS,0d125a,C,D,,.YREF,EF,2SG,38,7Sa,8BS,B2DFDB,E,F,,.YRFG,FG,1E8,1a,AlW,5_q,26A69A,F,G,,.."
    "2F1,FG,F1,AlW,5_q,A-8,5_q,CDG..N_S";

double cross(Plane a, Plane b) { return (std::conj(a) * b).imag(); }
double dot(Plane a, Plane b) { return (std::conj(a) * b).real(); }

/// x and y with x a + y b = c.
std::array<double, 2> combined(Plane a, Plane b, Plane c) {
    return {cross(c, b) / cross(a, b), cross(a, c) / cross(a, b)};
}

const double omega_2 = -20 * std::numbers::pi / 30;  // clockwise

Imported imported(const std::string& link) {
    auto found = import_pmks(link);
    EXPECT_TRUE(found.has_value()) << (found ? "" : found.error().front().text.in(Language::en));
    return found.value_or(Imported{});
}
Solved solved(const std::string& link) {
    const auto file = MechanismFile::parse(imported(link).file, "imported.json");
    EXPECT_TRUE(file.has_value());
    auto found = file->solve();
    EXPECT_TRUE(found.has_value());
    for (const CheckedValue& each : found->checks())
        EXPECT_NEAR(each.difference, 0, 1e-9 * (1 + std::abs(each.graphical))) << each.name;
    return *found;
}
double value(const Solved& of, const std::string& name) {
    const auto found = of.value(name);
    EXPECT_TRUE(found.has_value()) << name;
    return found ? found->value : 0;
}
std::string said(const std::vector<Text>& remarks) {
    std::string all;
    for (const Text& each : remarks) all += each.in(Language::en) + '\n';
    return all;
}
std::string fault_of(const std::string& link) {
    const auto found = import_pmks(link);
    EXPECT_FALSE(found.has_value()) << link;
    if (found) return {};
    EXPECT_EQ(found.error().size(), 1U);
    EXPECT_FALSE(found.error().front().remedy.empty());
    return found.error().front().text.in(Language::en);
}

TEST(ImportedLinks, InvertedSliderCrankTurnsAsItsLoopSays) {
    const Plane b = 1i, c = 3, r = b - c;
    const Plane v = 1i * omega_2 * b, a = -omega_2 * omega_2 * b;
    const double omega_4 = cross(r, v) / std::norm(r);
    const double along = dot(r, v) / std::abs(r);
    const double alpha_4 = (cross(r, a) / std::abs(r) - 2 * along * omega_4) / std::abs(r);
    const Solved found = solved("https://app.pmksplus.com/?" + inverted_slider_crank);
    EXPECT_NEAR(value(found, "omega CD"), omega_4, 1e-12);
    EXPECT_NEAR(value(found, "omega BP"), omega_4, 1e-12);
    EXPECT_NEAR(value(found, "alpha CD"), alpha_4, 1e-12);
    EXPECT_NEAR(value(found, "vx B"), v.real() / 100, 1e-12);
}

TEST(ImportedLinks, ASlotOfACouplerGuidesAThirdCrank) {
    const Plane b = 1, c = 2.5 + 2.598i, d = 4, e = 2.0 + 0.5i;
    const Plane u = c - b;
    const Plane f = b + dot(u, 2.418 + 2.456i - b) / std::norm(u) * u;  // put on the line of the slot
    // v_B + ω₃ z∧BC = ω₄ z∧DC
    const auto [omega_3, omega_4] = combined(1i * (c - b), -1i * (c - d), -1i * omega_2 * b);
    const Plane carried = 1i * omega_2 * b + 1i * omega_3 * (f - b);
    const double omega_5 = cross(carried, u) / cross(1i * (f - e), u);
    const Solved found = solved(slotted_coupler);
    EXPECT_NEAR(value(found, "omega BC"), omega_3, 1e-12);
    EXPECT_NEAR(value(found, "omega CD"), omega_4, 1e-12);
    EXPECT_NEAR(value(found, "omega EF"), omega_5, 1e-12);
    EXPECT_NE(said(imported(slotted_coupler).remarks).find("P lay 0.000012 cm off the line BC of its slot"),
              std::string::npos);
}

TEST(ImportedLinks, TheTrammelWithoutAnInputHasItsCentre) {
    const Imported file = imported(trammel);
    EXPECT_NE(said(file.remarks).find("the guide of D: 1.571 rad is taken as 90°"), std::string::npos);
    const Solved found = solved(trammel);
    // The normals of the guides at A and B meet in (1, 1) cm.
    EXPECT_NE(found.json().find(R"("0,AB": {"at": [0.01, 0.01]})"), std::string::npos) << found.json();
}

TEST(ImportedLinks, SliderCrankCarriesItsTracerPoint) {
    const Plane b = 4.0 + 2.0i, c = 12, d = 20.0 + 2.0i;
    const Plane v_b = 1i * omega_2 * b;
    const double omega_3 = -v_b.imag() / (c - b).real();
    const Plane v_d = v_b + 1i * omega_3 * (d - b);
    const Plane a_b = -omega_2 * omega_2 * b;
    const double alpha_3 = (-a_b.imag() + omega_3 * omega_3 * (c - b).imag()) / (c - b).real();
    const Solved found = solved(slider_crank);
    EXPECT_NEAR(value(found, "omega BCD"), omega_3, 1e-12);
    EXPECT_NEAR(value(found, "alpha BCD"), alpha_3, 1e-12);
    EXPECT_NEAR(value(found, "vx D"), v_d.real() / 100, 1e-12);
    EXPECT_NEAR(value(found, "vy D"), v_d.imag() / 100, 1e-12);
}

TEST(ImportedLinks, TheForceOnStephensonsChainIsBalancedAtTheInput) {
    const Plane a = 7.0 + 4.0i, b = 5.0 + 16.0i, c = 25.0 + 25.0i, d = 23.0 + 10.0i, e = 18.0 + 35.0i, f = 43.0 + 32.0i,
                g = 45.0 + 17.0i, at = 44.0 + 24.5i;
    const Plane v_b = 1i * omega_2 * (b - a);
    const auto [omega_3, omega_4] = combined(1i * (c - b), -1i * (c - d), -v_b);
    const Plane v_e = v_b + 1i * omega_3 * (e - b);
    const auto [omega_5, omega_6] = combined(1i * (f - e), -1i * (f - g), -v_e);
    const Plane v_at = 1i * omega_6 * (at - g);
    const double couple = -50 * v_at.real() / 100 / omega_2;  // the powers of couple and force cancel
    const Solved found = solved(stephenson);
    EXPECT_NEAR(value(found, "omega CD"), omega_4, 1e-12);
    EXPECT_NEAR(value(found, "omega EF"), omega_5, 1e-12);
    EXPECT_NEAR(value(found, "omega FG"), omega_6, 1e-12);
    EXPECT_NEAR(value(found, "effort M"), couple, 1e-11);
}

// A yoke: the pin of the crank in a slot of CD, which is welded to a block on a horizontal guide. The block's speed is
// the horizontal speed of the pin.
TEST(ImportedLinks, AWeldAtASliderStaysAWeld) {
    const std::string yoke = with_checksum(
        "1.Fe.A,0.2012.6A,A,0,0,0.0B,Pin,7q,Fe,0.8C,C,7q,0Fe,0.0D,D,7q,VG,0.1E,E,7q,Fe,0,CD,C,D.5F,F,7q,0Fe,0.."
        "YRAB,crank,Fe,Fe,0,7q,c5cae9,A,B,,.YRCD,yoke,Fe,Fe,7q,7q,303e9f,C,D,,.YPBE,block,0,0,0,0,,B,E,,."
        "YPCF,slide,0,0,0,0,,C,F,,...N_");
    const Imported file = imported(yoke);
    EXPECT_NE(file.file.find(R"({"weld": "C", "bodies": ["yoke", "slide"]})"), std::string::npos) << file.file;
    const Solved found = solved(yoke);
    const double omega = -10 * std::numbers::pi / 30;
    EXPECT_NEAR(value(found, "v F"), -omega * 1.0, 1e-12);  // metres: v = ω z∧(0.5, 1)
    EXPECT_NEAR(value(found, "omega yoke"), 0, 1e-15);
}

TEST(ImportedLinks, WeldedLinksAreOneBodyAndCarryTheForcesOfTheirParts) {
    const std::string welded = with_checksum(
        "2.Fe.A,0.1011.6A,A,0,0,0.8B,B,Fe,0,0.0C,C,VG,0,0..YRABC,ABC,Fe,Fe,Fe,0,c5cae9,A,B,C,,AB,BC."
        "NRAB,AB,Fe,Fe,7q,0,c5cae9,A,B,,.NRBC,BC,Fe,Fe,Fe,0,c5cae9,B,C,,..2F1,BC,push,VG,0,VG,Fe,3B8..N_");
    const Imported file = imported(welded);
    EXPECT_NE(said(file.remarks).find("welded links are one body, ABC: AB, BC"), std::string::npos);
    EXPECT_EQ(file.file.find("\"BC\""), std::string::npos);
    const Solved found = solved(welded);
    // 13.0 N at 2 cm, and a weight of 1 g at 1 cm; the flag for gravity is set.
    EXPECT_NEAR(value(found, "effort M"), -(13.0 * 0.02 - 9.81e-3 * 0.01), 1e-12);
}

TEST(ImportedLinks, OwnSpeedsAndSlidersDrive) {
    const std::string slider = with_checksum("1.Fe,2SG.A,0.1011.0B,B,0,0,0.7E,E,0,0,C0..YPBE,BE,Fe,0,0,0,,B,E,,...N_");
    const Imported general = imported(slider);
    EXPECT_NE(general.file.find(R"({"joint": "E", "speed": -10})"), std::string::npos) << general.file;
    EXPECT_NE(general.file.find(R"("along": "44°")"), std::string::npos) << general.file;
    const std::string own =
        with_checksum("1.Fe.A,0.1011.6A,A,0,0,0,,,,7q.0B,B,Fe,0,0..YRAB,AB,Fe,Fe,7q,0,c5cae9,A,B,,...N_");
    EXPECT_NE(imported(own).file.find(R"("omega": "0.5 rpm")"), std::string::npos) << imported(own).file;
}

TEST(ImportedLinks, NamesAreKeptOrTheirChangeIsSaid) {
    const std::string named = with_checksum(
        "0.Fe.A,0.1011.6A,O%20on%20top,0,0,0.0B,same,Fe,0,0.0C,same,VG,0,0..YRAB,0,Fe,Fe,7q,0,c5cae9,A,B,C,,...N_");
    // The checksum counts the characters of the decoded text.
    std::string decoded = named.substr(0, named.size() - 1);
    decoded.replace(decoded.find("%20"), 3, " ");
    decoded.replace(decoded.find("%20"), 3, " ");
    const Imported file = imported(named.substr(0, named.size() - 1) + digits[decoded.size() % 62]);
    const std::string remarks = said(file.remarks);
    EXPECT_NE(remarks.find("\"O on top\" is called \"O_on_top\" here"), std::string::npos) << remarks;
    EXPECT_NE(remarks.find("\"same\" is called \"same_2\" here"), std::string::npos) << remarks;
    EXPECT_NE(remarks.find("\"0\" is called \"0_2\" here"), std::string::npos) << remarks;
}

TEST(ImportedLinks, OldAndNewLinksDifferInTheirEndsOnly) {
    std::string data = slider_crank.substr(0, slider_crank.size() - 1);
    const std::string old = data.substr(0, data.size() - 3);  // without the selected object
    EXPECT_EQ(imported(with_checksum(old)).file, imported(slider_crank).file);
    const Imported trailing = imported("?" + with_checksum(data + ".JA,LAB,KB~8e24aa,CGAB.S1,2,3.?x"));
    EXPECT_EQ(trailing.file, imported(slider_crank).file);
    const std::string remarks = said(trailing.remarks);
    for (const char* kind : {"locks", "centres of mass", "synthesis", "colours of joints", "not known"})
        EXPECT_NE(remarks.find(kind), std::string::npos) << kind;
}

TEST(ImportedLinks, UnitsFollowTheLength) {
    std::string data = stephenson.substr(0, stephenson.size() - 1);
    data.replace(data.find("1011"), 4, "0000");
    const Imported inches = imported(with_checksum(data));
    EXPECT_NE(inches.file.find(R"("length": "in")"), std::string::npos);
    EXPECT_NE(inches.file.find(R"("force": "lbf")"), std::string::npos);
    EXPECT_NE(inches.file.find(R"("precision": "0.0005 in")"), std::string::npos);
    data.replace(data.find("0000"), 4, "1000");
    EXPECT_NE(said(imported(with_checksum(data)).remarks).find("forces are taken in N, since lengths are in cm"),
              std::string::npos);
}

TEST(BrokenLinks, AreRefusedInOneLineWithARemedy) {
    const auto changed = [](const std::string& from, const std::string& to) {
        std::string data = inverted_slider_crank.substr(0, inverted_slider_crank.size() - 1);
        const std::size_t at = data.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return with_checksum(data.replace(at, from.size(), to));
    };
    struct Broken {
        std::string link, message;
    };
    const std::vector<Broken> broken{
        {"", "this is no link of PMKS+"},
        {"https://app.pmksplus.com/", "this is no link of PMKS+"},
        {inverted_slider_crank.substr(0, 150), "the link is cut off or changed"},
        {with_checksum(inverted_slider_crank.substr(0, inverted_slider_crank.find(".HP"))), "the link ends too early"},
        {changed("MA,A,0,0,0", "MA,A,0,0"), "joint 1: 4 fields"},
        {changed("MA,A,0,0,0", "MA,A,0,+,0"), "joint 1: \"+\" is no number"},
        {changed("MA,A,0,0,0", "MA,A,0,123456789,0"), "joint 1: \"123456789\" is no number"},
        {changed("MA,A,0,0,0", "!A,A,0,0,0"), "joint 1: \"!\" says no properties"},
        {changed("YRAB", "XRAB"), "link 1: no link of the kind \"XR\""},
        {changed("1011", "7011"), "the units \"7011\" are unknown"},
        {changed("GB,B,", "GA,B,"), "joint \"A\" stands twice"},
        {changed(",A,B,,", ",A,Q,,"), "link \"AB\" refers to joint \"Q\", which is missing"},
        {changed("CD,C,D..", "ZZ,C,D.."), "joint \"P\" refers to link \"ZZ\", which is missing"},
        {changed("CD,C,D..", "CD,C,.."), "two different joints of link \"CD\""},
        {changed("GD,D,0RF,Oj,0", "GD,D,ku,0,0"), "the slot of joint \"P\" has no direction"},
        {std::string(300'000, '.'), "the link is longer than 262144 characters"},
        {with_checksum("2P.Fe.K,0.1011..."), "the drawing has no links and joints"},
    };
    for (const Broken& each : broken) {
        const std::string message = fault_of(each.link);
        EXPECT_NE(message.find(each.message), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos);
    }
}

/// Changes some characters, fields and sections; the checksum is right again.
std::string mutated(std::string data, std::mt19937& random) {
    const auto any = [&](std::size_t below) { return static_cast<std::size_t>(random()) % below; };
    static const std::string letters = digits + ".,,..%?\x80 ";
    for (std::size_t i = 0, count = 1 + any(4); i < count && !data.empty(); ++i) {
        const std::size_t at = any(data.size());
        switch (any(5)) {
            case 0: data[at] = letters[any(letters.size())]; break;
            case 1: data.insert(at, 1, letters[any(letters.size())]); break;
            case 2: data.erase(at, 1 + any(8)); break;
            case 3: data.insert(at, data.substr(any(data.size()), any(40))); break;
            default: data.resize(at); break;
        }
    }
    return any(10) == 0 ? data : with_checksum(data);
}

TEST(BrokenLinks, MutatedLinksGiveAFileOrAFault) {
    std::mt19937 random(7);
    const std::vector<std::string> links{inverted_slider_crank, slotted_coupler, trammel, slider_crank, stephenson};
    int files = 0, faults = 0;
    for (int i = 0; i < 2000; ++i) {
        const std::string& link = links[static_cast<std::size_t>(i) % links.size()];
        const std::string text = mutated(link.substr(0, link.size() - 1), random);
        const auto found = import_pmks(text);
        if (!found) {
            ++faults;
            ASSERT_EQ(found.error().size(), 1U) << text;
            continue;
        }
        ++files;
        const auto file = MechanismFile::parse(found->file, "mutated.json");
        ASSERT_TRUE(file.has_value()) << text;
        if (i % 16 == 0) {
            EXPECT_NO_THROW(file->solve()) << text;
        }
    }
    EXPECT_GT(files, 100);
    EXPECT_GT(faults, 100);
}

}  // namespace
}  // namespace import_test

namespace kinegraph::tests::import_test {
namespace {

using ImportCommand = CommandLine;

const std::string link = "https://app.pmksplus.com/?" + ::import_test::trammel;

TEST_F(ImportCommand, WritesTheFileAndItsRemarks) {
    const Outcome run_on_link = run("import '" + link + "' -o trammel.json");
    EXPECT_EQ(run_on_link.status, 0) << run_on_link.err;
    EXPECT_TRUE(run_on_link.out.empty());
    EXPECT_TRUE(lines_are(run_on_link.err, "the link: remark: .+")) << run_on_link.err;
    EXPECT_EQ(run("check trammel.json").status, 0);
    write("saved.pmks", link + "\n");
    const Outcome run_on_file = run("import saved.pmks");
    EXPECT_EQ(run_on_file.status, 0) << run_on_file.err;
    EXPECT_EQ(run_on_file.out, contents(folder_ / "trammel.json"));
}

TEST_F(ImportCommand, RefusesWhatIsBrokenAndWritesNothing) {
    const Snapshot before = snapshot();
    const Outcome cut_off = run("import '" + link.substr(0, link.size() - 4) + "' -o trammel.json --lang de");
    EXPECT_EQ(cut_off.status, 2);
    EXPECT_TRUE(lines_are(cut_off.err, "der Link: der Link ist abgeschnitten oder verändert.+")) << cut_off.err;
    EXPECT_EQ(run("import missing.pmks -o trammel.json").status, 2);
    EXPECT_EQ(run("import '" + link + "' -o trammel.svg").status, 2);
    EXPECT_EQ(changed_since(before), "");
}

}  // namespace
}  // namespace kinegraph::tests::import_test
