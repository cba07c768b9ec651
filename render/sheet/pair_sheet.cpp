#include "render/sheet/pair_sheet.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "engine/mechanism/pair_catalogue.hpp"
#include "render/content/title_block.hpp"
#include "render/equations/prose.hpp"
#include "render/figures/pair_figures.hpp"
#include "render/page/block.hpp"
#include "render/page/shapes.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

/// A figure with its name above and text below, or only text.
struct Card {
    std::string name;
    std::function<Figure()> draw;  ///< null: only text
    std::vector<RichText> lines;
};
struct Section {
    std::string question;  ///< for `data-question`
    Words heading;
    std::size_t across = 4;  ///< number of cards in a row on landscape paper
    double figure_height = 36;
    std::vector<Card> cards;
    Words closing{};  ///< text below the cards
};

/// Formulas for symbols such as "F_x F_y", with indices.
std::string as_formula(std::string_view symbols) {
    std::string text, symbol;
    const auto put = [&] {
        const bool indexed = symbol.find('_') != std::string::npos;
        text += indexed || symbol == "p" ? "{" + symbol + "}" : symbol;
        symbol.clear();
    };
    for (const char c : symbols) {
        if (c != ' ' && c != ',') {
            symbol += c;
            continue;
        }
        put();
        text += c;
    }
    put();
    // A sign before a symbol is moved out of its braces.
    for (std::size_t at = 0; (at = text.find("{−", at)) != std::string::npos;) text.replace(at, 4, "−{");
    return text;
}

/// What keeps the bodies of a pair in contact.
Words closure_of(const PlanePair& pair) {
    if (pair.meshes()) return {"form, by both flanks of a tooth", "di forma, per i due fianchi di un dente"};
    if (pair.rolls()) return {"force, which also holds by friction", "di forza, che trattiene anche per attrito"};
    if (pair.touches()) return {"force; form in a groove", "di forza; di forma in una scanalatura"};
    return {"form", "di forma"};
}
Words closure_of(const SpacePair& pair) {
    if (pair.key == "planar") return {"force; form between two plates", "di forza; di forma fra due piastre"};
    return {"form", "di forma"};
}

class CatalogueText {
public:
    explicit CatalogueText(const DrawingContext& context) : context_(context) {}

    std::vector<Section> sections() const {
        return {plane_pairs_drawn(), space_pairs_drawn(), closures(), links(), chains(), hinges(), schemes_of_four()};
    }

private:
    std::string say(const Words& words) const { return in(words, context_.language); }
    std::string say_word(const std::string& key) const { return word(key, context_.language); }
    /// Names begin with an ASCII letter in all languages.
    static std::string capital(std::string name) {
        if (name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
        return name;
    }
    /// "class: 1".
    RichText fact(const std::string& name, const std::string& text) const {
        RichText line = one_piece(name + ": ", Face::bold);
        append(line, formula(text));
        return line;
    }
    RichText plain_line(const Words& words) const { return formula(say(words)); }

    Section plane_pairs_drawn() const {
        Section section{"plane-pairs", {say_word("pairs of the plane")}, 4, 40, {}};
        for (const PlanePair& pair : plane_pairs) {
            const std::string key(pair.key);
            Card card{capital(say_word("pair " + key)),
                      [this, kind = pair.kind] { return plane_pair_figure(context_, kind); },
                      {}};
            const std::string freedoms = std::to_string(pair.freedoms());
            card.lines.push_back(fact(say_word("class"),
                                      pair.freedoms() > 0
                                          ? freedoms
                                          : say({"none, the two are one body", "nessuna, i due sono un corpo solo"})));
            card.lines.push_back(
                fact(say_word("freedoms left"),
                     freedoms + (pair.freedoms() > 0 ? " (" + say_word("freedoms " + key) + ")" : "")));
            card.lines.push_back(fact(say_word("reaction"), say_word("reaction " + key)));
            card.lines.push_back(fact(say({"closure", "accoppiamento"}), say(closure_of(pair))));
            section.cards.push_back(std::move(card));
        }
        section.cards.push_back(key_to_arrows());
        return section;
    }
    Card key_to_arrows() const {
        Card card{say({"How to read it", "Come si legge"}), nullptr, {}};
        for (const Words& line :
             {Words("Left the pair with the motions that it allows its bodies against each other: dashed arrows.",
                    "A sinistra la coppia con i moti relativi che consente: frecce tratteggiate."),
              Words("Right one body alone with the reactions that the other transmits to it: full arrows.",
                    "A destra un corpo isolato con le reazioni che l’altro gli trasmette: frecce piene."),
              Words("The class is the number of the freedoms left. In the plane freedoms and components of the "
                    "reaction add up to three, in space to six.",
                    "La classe è il numero delle libertà residue. Nel piano libertà e componenti della reazione sono "
                    "in tutto tre, nello spazio sei."),
              Words("Form closure: the bodies enclose each other. Force closure: a weight or a spring holds them "
                    "together.",
                    "Accoppiamento di forma: i corpi si trattengono per la loro forma. Di forza: li tiene a contatto "
                    "un peso o una molla.")})
            card.lines.push_back(plain_line(line));
        return card;
    }

    Section space_pairs_drawn() const {
        Section section{"space-pairs", {say_word("lower pairs in space")}, 3, 51, {}};
        for (const SpacePair& pair : space_pairs) {
            Card card{capital(say_word("space " + std::string(pair.key))),
                      [this, &pair] { return space_pair_figure(context_, pair); },
                      {}};
            card.lines.push_back(fact(say_word("class"), std::to_string(pair.freedoms)));
            card.lines.push_back(
                fact(say_word("freedoms left"), std::to_string(pair.freedoms) + " (" + as_formula(pair.motions) + ")"));
            card.lines.push_back(fact(say_word("reaction"),
                                      as_formula(pair.reactions) + " (" + std::to_string(pair.reaction_count()) + ")"));
            card.lines.push_back(fact(say({"closure", "accoppiamento"}), say(closure_of(pair))));
            section.cards.push_back(std::move(card));
        }
        section.closing = in_all([](Language language) { return word("axes of pairs", language); }) +
                          Words(" A couple is a vector with two heads.", " Una coppia è un vettore con due punte.");
        return section;
    }

    Section closures() const {
        Section section{"closure", {"Form closure and force closure", "Accoppiamento di forma e di forza"}, 2, 34, {}};
        section.cards.push_back(
            {say({"Form closure", "Accoppiamento di forma"}),
             [this] { return closure_figure(context_, Closure::form); },
             {plain_line({"The slot holds the roller on both sides: the reaction may have either sense.",
                          "La scanalatura trattiene la rotella dai due lati: la reazione può avere i due versi."})}});
        section.cards.push_back({say({"Force closure", "Accoppiamento di forza"}),
                                 [this] { return closure_figure(context_, Closure::force); },
                                 {plain_line({"A spring or a weight presses the roller on one side: the reaction can "
                                              "only push, else the bodies part.",
                                              "Una molla o un peso preme la rotella da un lato: la reazione può solo "
                                              "spingere, altrimenti i corpi si staccano."})}});
        return section;
    }
    Section links() const {
        Section section{
            "links", {"Bodies by the number of their pairs", "Membri secondo il numero delle coppie"}, 3, 25, {}};
        const std::array<Words, 3> names{Words("Binary body", "Membro binario"),
                                         Words("Ternary body", "Membro ternario"),
                                         Words("Quaternary body", "Membro quaternario")};
        for (int pairs = 2; pairs <= 4; ++pairs)
            section.cards.push_back({say(names.at(static_cast<std::size_t>(pairs) - 2)),
                                     [this, pairs] { return link_figure(context_, pairs); },
                                     {plain_line(Words("{0} pairs", "{0} coppie", std::to_string(pairs)))}});
        return section;
    }
    Section chains() const {
        Section section{"chains", {"Open and closed chains", "Catene aperte e chiuse"}, 3, 37, {}};
        const auto card = [&](const Words& name, ChainDrawn chain, const Words& line) {
            section.cards.push_back(
                {say(name), [this, chain] { return chain_figure(context_, chain); }, {plain_line(line)}});
        };
        card({"Open chain", "Catena aperta"}, ChainDrawn::open,
             {"No loop: each body hangs on the one before it, and the last is free.",
              "Nessuna maglia: ogni membro segue il precedente e l’ultimo è libero."});
        card({"Closed chain", "Catena chiusa"}, ChainDrawn::closed,
             {"Loops, and each body has at least two pairs: {l} = {c} − {m} + 1 independent ones, of {c} binary pairs "
              "and {m} bodies.",
              "Maglie, e ogni membro ha almeno due coppie: {l} = {c} − {m} + 1 indipendenti, con {c} coppie binarie e "
              "{m} membri."});
        card({"Mixed chain", "Catena mista"}, ChainDrawn::mixed,
             {"Loops, and bodies that hang on one pair alone.", "Maglie, e membri che hanno una sola coppia."});
        return section;
    }
    Section hinges() const {
        Section section{"hinges", {say_word("multiple hinges")}, 4, 36, {}};
        section.cards.push_back({say({"Hinge of three bodies", "Cerniera di tre corpi"}),
                                 [this] { return triple_hinge_figure(context_, nullptr); },
                                 {fact(say_word("multiplicity"), "2"), formula(say_word("multiplicity rule"))}});
        const std::vector<BinaryScheme> schemes = binary_schemes(3);
        for (std::size_t i = 0; i < schemes.size(); ++i) {
            std::string hinges;
            for (const auto& hinge : schemes[i].hinges)
                hinges += "(" + std::to_string(hinge[0] + 1) + "–" + std::to_string(hinge[1] + 1) + ")";
            section.cards.push_back(
                {say(Words("Equivalent scheme {0}", "Schema equivalente {0}", std::to_string(i + 1))),
                 [this, scheme = schemes[i]] { return triple_hinge_figure(context_, &scheme); },
                 {fact(say({"two binary hinges", "due cerniere binarie"}), hinges)}});
        }
        section.cards.back().lines.push_back(formula(say_word("stars rule")));
        return section;
    }
    Section schemes_of_four() const {
        Section section{"schemes",
                        {"Hinge of four bodies: bodies as dots, binary hinges as lines",
                         "Cerniera di quattro corpi: corpi come punti, cerniere binarie come linee"},
                        8,
                        20,
                        {}};
        const std::vector<BinaryScheme> schemes = binary_schemes(4);
        for (std::size_t i = 0; i < schemes.size(); ++i)
            section.cards.push_back(
                {std::to_string(i + 1), [this, scheme = schemes[i]] { return scheme_figure(context_, scheme); }, {}});
        section.closing = {
            "In all there are {n}^{n − 2} schemes, as many as trees on {n} bodies (Cayley): 1, 3, 16, 125, 1296 for 2, "
            "3, 4, 5, 6 bodies; of these {n} have all hinges on one body.",
            "In tutto gli schemi sono {n}^{n − 2}, quanti gli alberi su {n} corpi (Cayley): 1, 3, 16, 125, 1296 per 2, "
            "3, 4, 5, 6 corpi; fra questi {n} hanno tutte le cerniere su un corpo."};
        return section;
    }

    const DrawingContext& context_;
};

class CatalogueSheet {
public:
    CatalogueSheet(const DrawingContext& context, const SheetOptions& options)
        : context_(context),
          format_(format_of(options.paper, options.orientation)),
          signature_{options.author, options.date} {}

    std::vector<Page> pages(const std::vector<Section>& sections) {
        y_ = format_.content.min.y;
        sheets_.emplace_back();
        const ShapedLine title = context_.fonts.shape(
            one_piece(title_of(context_.solution, context_.language), Face::bold), context_.theme.title);
        set_text(sheets_.back(), title, {format_.content.min.x, y_ + 4}, context_.theme.text, "text");
        y_ += 9;
        for (const Section& section : sections) put(section);
        std::vector<Page> pages;
        for (std::size_t i = 0; i < sheets_.size(); ++i)
            pages.push_back(
                framed_page(context_, format_, signature_, sheets_[i], std::nullopt, i + 1, sheets_.size(), false));
        return pages;
    }

private:
    Block card_block(const Card& card, double width, double figure_height) const {
        const double text = format_.text_size;
        Block block;
        block.width = width;
        const Block name = scaled(paragraph_block(context_, width / text, one_piece(card.name, Face::bold)), text);
        set(block.marks, name, {0, 0});
        block.height = name.height + 1;
        if (card.draw) {
            Figure figure = card.draw();
            figure.move(0.5 * (width - figure.box.width()) - figure.box.min.x,
                        block.height + 0.5 * (figure_height - figure.box.height()) - figure.box.min.y);
            block.marks.insert(block.marks.end(), figure.marks.begin(), figure.marks.end());
            block.height += std::max(figure_height, figure.box.height()) + 1.5;
        }
        for (const RichText& line : card.lines) {
            const Block words = scaled(paragraph_block(context_, width / text, line), text);
            set(block.marks, words, {0, block.height});
            block.height += words.height + 0.7;
        }
        return block;
    }

    void put(const Section& section) {
        const double bottom = format_.content.max.y - strip_height;
        const bool narrow = format_.content.width() < 200;
        const std::size_t across = std::max<std::size_t>(1, narrow ? (section.across + 1) / 2 : section.across);
        const double width = (format_.content.width() + gap) / static_cast<double>(across) - gap;
        const Block heading = scaled(heading_block(context_, format_.content.width() / format_.text_size,
                                                   in(section.heading, context_.language)),
                                     format_.text_size);
        bool first = true;
        for (std::size_t from = 0; from < section.cards.size(); from += across) {
            std::vector<Block> row;
            double height = 0;
            for (std::size_t i = from; i < std::min(from + across, section.cards.size()); ++i) {
                row.push_back(card_block(section.cards[i], width, section.figure_height));
                height = std::max(height, row.back().height);
            }
            if (y_ > format_.content.min.y && y_ + height + (first ? heading.height : 0) > bottom) {
                sheets_.emplace_back();
                y_ = format_.content.min.y;
            }
            sheets_.back().emplace_back(GroupBegin{"band", "", "", {{"data-question", section.question}}, none});
            if (first) {
                set(sheets_.back(), heading, {format_.content.min.x, y_});
                y_ += heading.height + 1;
            }
            first = false;
            for (std::size_t i = 0; i < row.size(); ++i)
                set(sheets_.back(), row[i], {format_.content.min.x + static_cast<double>(i) * (width + gap), y_});
            sheets_.back().emplace_back(GroupEnd{});
            y_ += height + 5;
        }
        if (section.closing.empty()) return;
        const double text = format_.text_size;
        const Block words = scaled(
            paragraph_block(context_, format_.content.width() / text, formula(in(section.closing, context_.language))),
            text);
        set(sheets_.back(), words, {format_.content.min.x, y_});
        y_ += words.height + 5;
    }

    const DrawingContext& context_;
    SheetFormat format_;
    Signature signature_;
    std::vector<std::vector<Mark>> sheets_;
    double y_ = 0;
};

}  // namespace

std::vector<Page> lay_out_catalogue(const SheetOptions& options, const Fonts& fonts) {
    Solution solution;
    solution.mechanism.title = in_all([](Language language) { return word("catalogue of pairs", language); });
    const DrawingContext context{solution, options.theme, fonts, options.language, Dimensions::off};
    const CatalogueText text(context);
    return CatalogueSheet(context, options).pages(text.sections());
}

}  // namespace kinegraph::render
