#include "render/tables/pair_tables.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

#include "engine/mechanism/chain.hpp"
#include "engine/mechanism/pair_catalogue.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/pairs.hpp"
#include "lang/keys/sheet.hpp"
#include "render/text/utf8.hpp"

namespace kinegraph::render {
namespace {

using Cells = std::vector<std::string>;

std::string signed_text(int value) { return (value < 0 ? "−" : "") + std::to_string(std::abs(value)); }

/// Writes headings, tables and lines in either text form.
class Writer {
public:
    Writer(TextForm form, Language language) : form_(form), colon_(kinegraph::in(lang::notation::colon, language)) {}

    void title(const std::string& text) {
        if (text.empty()) return;
        text_ += (form_ == TextForm::markdown ? "# " : "") + text + "\n";
    }
    void heading(const std::string& text) {
        if (!text_.empty() && !text_.ends_with("\n\n")) text_ += "\n";
        text_ += form_ == TextForm::markdown ? "## " + text + "\n\n" : text + "\n";
    }
    void line(const std::string& text) { text_ += (form_ == TextForm::markdown ? "- " : "  ") + text + "\n"; }
    void gap() { text_ += "\n"; }
    void note(const std::string& text) {
        text_ += form_ == TextForm::markdown ? "\n" + text + "\n" : "  " + text + "\n";
    }
    /// Left aligned, with the first row as the head.
    void table(const std::vector<Cells>& rows) {
        std::vector<std::size_t> widths(rows.front().size(), 0);
        for (const Cells& row : rows)
            for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], character_count(row[c]));
        for (std::size_t r = 0; r < rows.size(); ++r) {
            if (form_ == TextForm::markdown) {
                text_ += "|";
                for (const std::string& cell : rows[r]) text_ += " " + escaped(cell) + " |";
                text_ += "\n";
                if (r > 0) continue;
                text_ += "|";
                for (std::size_t c = 0; c < widths.size(); ++c) text_ += " --- |";
                text_ += "\n";
                continue;
            }
            std::string each = " ";
            for (std::size_t c = 0; c < rows[r].size(); ++c)
                each += (c == 0 ? " " : "  ") + rows[r][c] + std::string(widths[c] - character_count(rows[r][c]), ' ');
            each.erase(each.find_last_not_of(' ') + 1);
            text_ += each + "\n";
        }
    }
    /// One item with its properties, each under its own label.
    void entry(const std::string& name, const std::vector<std::array<std::string, 2>>& facts) {
        if (form_ == TextForm::markdown) {
            text_ += "### " + name + "\n\n";
            for (const auto& [word, fact] : facts) text_ += "- " + word + colon_ + fact + "\n";
            text_ += "\n";
            return;
        }
        text_ += "  " + name + "\n";
        std::size_t width = 0;
        for (const auto& fact : facts) width = std::max(width, character_count(fact[0]));
        for (const auto& [word, fact] : facts)
            text_ += "    " + word + std::string(width - character_count(word) + 2, ' ') + fact + "\n";
    }
    std::string code(std::string_view text) const {
        return form_ == TextForm::markdown ? "`" + std::string(text) + "`" : std::string(text);
    }
    std::string finish() {
        while (text_.ends_with("\n\n")) text_.pop_back();
        return std::move(text_);
    }

private:
    static std::string escaped(const std::string& cell) {
        std::string out;
        for (const char c : cell) {
            if (c == '|' || c == '_' || c == '*') out += '\\';
            out += c;
        }
        return out;
    }
    TextForm form_;
    std::string colon_;
    std::string text_;
};

std::string counted(int count, Key one, Key several, Language language) {
    return std::to_string(count) + " " + word(count == 1 ? one : several, language);
}

/// "(2–3)(2–4)": the bodies of each hinge.
std::string spelt(const BinaryScheme& scheme, const std::vector<std::string>& bodies) {
    std::string text;
    for (const auto& hinge : scheme.hinges)
        text +=
            "(" + bodies[static_cast<std::size_t>(hinge[0])] + "–" + bodies[static_cast<std::size_t>(hinge[1])] + ")";
    return text;
}

/// n^(n−2): the number while it is short, otherwise the power.
std::string schemes_of(int bodies) {
    std::size_t count = 1;
    constexpr int longest = 9;  // 9^7 is the last one below ten million
    if (bodies > longest) return std::to_string(bodies) + "^" + std::to_string(bodies - 2);
    for (int i = 0; i < bodies - 2; ++i) count *= static_cast<std::size_t>(bodies);
    return std::to_string(count);
}

/// "unary", "binary" …; above four only the number.
Words arity(int pairs) {
    static const std::array<Words, 5> names{Words(lang::pairs::bodies_without_pairs), Words(lang::pairs::unary_bodies),
                                            Words(lang::pairs::binary_bodies), Words(lang::pairs::ternary_bodies),
                                            Words(lang::pairs::quaternary_bodies)};
    if (pairs < static_cast<int>(names.size())) return names.at(static_cast<std::size_t>(pairs));
    return {lang::pairs::bodies_with_pairs, std::to_string(pairs)};
}

/// The chain that the pairs form, and its bodies by number of pairs.
void write_chain(Writer& page, const Mechanism& mechanism, Language language) {
    const KinematicChain chain = chain_of(mechanism);
    const Words kind = chain.kind() == KinematicChain::Kind::open     ? Words(lang::pairs::open)
                       : chain.kind() == KinematicChain::Kind::closed ? Words(lang::pairs::closed)
                                                                      : Words(lang::pairs::mixed);
    page.heading(in({lang::pairs::chain}, language));
    page.line(in(Words(lang::pairs::kind, kind), language));
    page.line(in(Words(lang::pairs::independent_loops_c_m_of_c, std::to_string(chain.parts),
                       std::to_string(chain.joints), std::to_string(chain.pairs.size()), std::to_string(chain.loops)),
                 language));
    std::map<int, std::vector<std::string>> by_pairs;
    for (const BodyIndex body : indices_of(mechanism.bodies))
        by_pairs[chain.pairs[at_index(body)]].push_back(mechanism.body(body).name);
    for (const auto& [pairs, bodies] : by_pairs) {
        std::string names;
        for (const std::string& name : bodies) names += (names.empty() ? "" : ", ") + name;
        page.line(in(arity(pairs) + lang::notation::colon, language) + std::to_string(bodies.size()) + " (" + names +
                  ")");
    }
}

}  // namespace

std::string pair_catalogue(Language language, TextForm form) {
    if (form == TextForm::json) return pair_catalogue_json();
    const auto say_word = [&](Key key) { return word(key, language); };
    Writer page(form, language);
    page.title(say_word(lang::sheet::catalogue_of_pairs));
    page.heading(say_word(lang::sheet::pairs_of_the_plane));
    for (const PlanePair& pair : plane_pairs) {
        page.entry(say_word(pair.texts.name),
                   {{say_word(lang::sheet::in_the_file), page.code(pair.form)},
                    {say_word(lang::sheet::freedoms_left),
                     std::to_string(pair.freedoms()) +
                         (pair.freedoms() > 0 ? " (" + say_word(pair.texts.freedoms) + ")" : "")},
                    {say_word(lang::sheet::class_word),
                     pair.freedoms() > 0 ? std::to_string(pair.freedoms()) : say_word(lang::sheet::no_pair)},
                    {say_word(lang::sheet::reaction),
                     say_word(pair.texts.reaction) + " (" +
                         counted(pair.reactions(), lang::sheet::unknown, lang::sheet::unknowns, language) + ")"},
                    {say_word(lang::sheet::fixed), say_word(pair.texts.fixed)},
                    {say_word(lang::sheet::instant_centre), say_word(pair.texts.centre)}});
    }

    page.heading(say_word(lang::sheet::lower_pairs_in_space));
    std::vector<Cells> rows{{say_word(lang::sheet::pair), say_word(lang::sheet::freedoms_left),
                             say_word(lang::sheet::class_word), say_word(lang::sheet::motions),
                             say_word(lang::sheet::reaction), say_word(lang::sheet::components)}};
    for (const SpacePair& pair : space_pairs)
        rows.push_back({say_word(pair.name), std::to_string(pair.freedoms), std::to_string(pair.freedoms),
                        pair.motions.in_words(), pair.reactions.in_words(), std::to_string(pair.reaction_count())});
    page.table(rows);
    page.note(say_word(lang::sheet::axes_of_pairs));

    page.heading(say_word(lang::sheet::multiple_hinges));
    for (const Key key : {lang::sheet::multiplicity_rule, lang::sheet::stars_rule, lang::sheet::trees_rule})
        page.line(say_word(key));
    const std::vector<std::string> bodies{"1", "2", "3"};
    std::string three;
    for (const BinaryScheme& scheme : binary_schemes(3)) three += (three.empty() ? "" : ", ") + spelt(scheme, bodies);
    page.line(say_word(lang::sheet::schemes_of_three) + say_word(lang::notation::colon) + three);
    std::vector<Cells> counts{{say_word(lang::sheet::bodies_at_the_hinge), say_word(lang::sheet::multiplicity),
                               say_word(lang::sheet::stars), say_word(lang::sheet::schemes)}};
    for (int n = 2; n <= 6; ++n)
        counts.push_back({std::to_string(n), std::to_string(n - 1), n == 2 ? "1" : std::to_string(n), schemes_of(n)});
    page.gap();
    page.table(counts);
    return page.finish();
}

namespace {

/// "M: multiplicity 2, 3 equivalent schemes: …".
std::string multiple_hinge_line(const Joint& joint, const std::vector<std::string>& bodies, Language language) {
    const auto n = static_cast<int>(bodies.size());
    const std::string colon = word(lang::notation::colon, language);
    std::string line = joint.name + colon + word(lang::sheet::multiplicity, language) + " " + std::to_string(n - 1) +
                       ", " + schemes_of(n) + " " + word(lang::sheet::equivalent_schemes, language);
    constexpr int listed_bodies = 4;  // 16 schemes
    if (n > listed_bodies) return line;
    std::string all;
    for (const BinaryScheme& scheme : binary_schemes(n)) all += (all.empty() ? colon : ", ") + spelt(scheme, bodies);
    return line + all;
}

void write_pairs(Writer& page, const Mechanism& mechanism, Language language) {
    const auto say_word = [&](Key key) { return word(key, language); };
    page.heading(say_word(lang::sheet::pairs));
    std::vector<Cells> rows{{say_word(lang::common::joint), say_word(lang::sheet::kind_of_pair),
                             say_word(lang::sheet::bodies_of_a_pair), say_word(lang::sheet::class_word)}};
    std::vector<std::string> multiple;
    for (const Joint& joint : mechanism.joints) {
        const PlanePair& pair = joint.pair();
        std::vector<std::string> names;
        std::string bodies;
        for (const BodyIndex body : joint.bodies) {
            names.push_back(mechanism.bodies[at_index(body)].name);
            bodies += (bodies.empty() ? "" : ", ") + names.back();
        }
        rows.push_back({joint.name, say_word(pair.texts.name), bodies,
                        pair.freedoms() > 0 ? std::to_string(pair.freedoms()) : "–"});
        if (names.size() >= 3) multiple.push_back(multiple_hinge_line(joint, names, language));
    }
    page.table(rows);
    if (multiple.empty()) return;
    page.heading(say_word(lang::sheet::multiple_hinges));
    for (const std::string& line : multiple) page.line(line);
}

void write_count(Writer& page, const Mobility& m, Language language) {
    const std::string moving = signed_text(m.bodies - 1), c1 = signed_text(m.class_1), c2 = signed_text(m.class_2),
                      welds = signed_text(m.welds), n = signed_text(m.gruebler);
    page.heading(word(lang::sheet::count, language));
    page.line("n = 3(m − 1) − 2c₁ − c₂" + std::string(m.welds > 0 ? " − 3w" : "") + " = 3·" + moving + " − 2·" + c1 +
              " − " + c2 + (m.welds > 0 ? " − 3·" + welds : "") + " = " + n);
    page.line("n = 3n_c − n₁ − 2n₂ − 3n₃ = 3·" + moving + " − " + c2 + " − 2·" + c1 + " − 3·" + welds + " = " + n);
    page.note(word(lang::sheet::symbols_of_the_first_count, language));
    page.note(word(lang::sheet::symbols_of_the_second_count, language));
}

void write_verdict(Writer& page, const Mobility& m, Language language) {
    const auto say_word = [&](Key key) { return word(key, language); };
    page.heading(say_word(lang::sheet::at_this_position));
    const int freedoms = 3 * (m.bodies - 1);
    page.line(say_word(lang::sheet::rank) + say_word(lang::notation::colon) + std::to_string(freedoms - m.effective) +
              " = " + std::to_string(freedoms - m.gruebler) + " " + say_word(lang::sheet::constraints) + " − " +
              std::to_string(m.repeated()) + " " + say_word(lang::sheet::repeated) +
              say_word(lang::notation::semicolon) + signed_text(m.effective) + " " +
              say_word(m.effective == 1 ? lang::sheet::effective_one : lang::sheet::effective));
    page.line(say_word(lang::sheet::verdict) + say_word(lang::notation::colon) + verdict_words(m, language));
}

}  // namespace

std::string pair_report(const Mechanism& mechanism, const Mobility& mobility, const std::vector<Message>& remarks,
                        Language language, TextForm form) {
    if (form == TextForm::json) return pair_report_json(mechanism, mobility, remarks);
    Writer page(form, language);
    page.title(in(mechanism.title, language));
    write_pairs(page, mechanism, language);
    write_chain(page, mechanism, language);
    write_count(page, mobility, language);
    write_verdict(page, mobility, language);
    if (!remarks.empty()) {
        page.heading(word(lang::sheet::remarks, language));
        for (const Message& remark : remarks) page.line(tell(remark, language));
    }
    return page.finish();
}

}  // namespace kinegraph::render
