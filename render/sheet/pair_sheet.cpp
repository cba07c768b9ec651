#include "render/sheet/sheet.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include "engine/mechanism/pair_catalogue.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/pairs.hpp"
#include "lang/keys/sheet.hpp"
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
    if (pair.meshes()) return {lang::pairs::form_by_both_flanks};
    if (pair.rolls()) return {lang::pairs::force_which_also_holds_by_friction};
    if (pair.touches()) return {lang::pairs::force_form_in_a_groove};
    return {lang::pairs::form};
}
Words closure_of(const SpacePair& pair) {
    if (pair.key == "planar") return {lang::pairs::force_form_between_two_plates};
    return {lang::pairs::form};
}

class CatalogueText {
public:
    explicit CatalogueText(const DrawingContext& context) : context_(context) {}

    std::vector<Section> sections() const {
        return {plane_pairs_drawn(), space_pairs_drawn(), closures(), links(), chains(), hinges(), schemes_of_four()};
    }

private:
    std::string say(const Words& words) const { return in(words, context_.language); }
    std::string say_word(Key key) const { return word(key, context_.language); }
    /// Names begin with an ASCII letter in all languages.
    static std::string capital(std::string name) {
        if (name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
        return name;
    }
    /// "class: 1".
    RichText fact(const std::string& name, const std::string& text) const {
        RichText line = one_piece(name + say_word(lang::notation::colon), Face::bold);
        append(line, formula(text));
        return line;
    }
    RichText plain_line(const Words& words) const { return formula(say(words)); }

    Section plane_pairs_drawn() const {
        Section section{"plane-pairs", {say_word(lang::sheet::pairs_of_the_plane)}, 4, 40, {}};
        for (const PlanePair& pair : plane_pairs) {
            Card card{capital(say_word(pair.texts.name)),
                      [this, kind = pair.kind] { return plane_pair_figure(context_, kind); },
                      {}};
            const std::string freedoms = std::to_string(pair.freedoms());
            card.lines.push_back(fact(say_word(lang::sheet::class_word),
                                      pair.freedoms() > 0 ? freedoms : say({lang::pairs::none_the_two_are_one_body})));
            card.lines.push_back(
                fact(say_word(lang::sheet::freedoms_left),
                     freedoms + (pair.freedoms() > 0 ? " (" + say_word(pair.texts.freedoms) + ")" : "")));
            card.lines.push_back(fact(say_word(lang::sheet::reaction), say_word(pair.texts.reaction)));
            card.lines.push_back(fact(say({lang::pairs::closure}), say(closure_of(pair))));
            section.cards.push_back(std::move(card));
        }
        section.cards.push_back(key_to_arrows());
        return section;
    }
    Card key_to_arrows() const {
        Card card{say({lang::pairs::how_to_read}), nullptr, {}};
        for (const Words& line :
             {Words(lang::pairs::left_the_pair_with_the_motions), Words(lang::pairs::right_one_body_alone),
              Words(lang::pairs::the_class_is_the_number), Words(lang::pairs::form_closure_the_bodies_enclose_each)})
            card.lines.push_back(plain_line(line));
        return card;
    }

    Section space_pairs_drawn() const {
        Section section{"space-pairs", {say_word(lang::sheet::lower_pairs_in_space)}, 3, 51, {}};
        for (const SpacePair& pair : space_pairs) {
            Card card{capital(say_word(pair.name)), [this, &pair] { return space_pair_figure(context_, pair); }, {}};
            card.lines.push_back(fact(say_word(lang::sheet::class_word), std::to_string(pair.freedoms)));
            card.lines.push_back(
                fact(say_word(lang::sheet::freedoms_left),
                     std::to_string(pair.freedoms) + " (" + as_formula(pair.motions.in_words()) + ")"));
            card.lines.push_back(
                fact(say_word(lang::sheet::reaction),
                     as_formula(pair.reactions.in_words()) + " (" + std::to_string(pair.reaction_count()) + ")"));
            card.lines.push_back(fact(say({lang::pairs::closure}), say(closure_of(pair))));
            section.cards.push_back(std::move(card));
        }
        section.closing = Words(lang::sheet::axes_of_pairs) + Words(lang::pairs::a_couple_is_a_vector);
        return section;
    }

    Section closures() const {
        Section section{"closure", {lang::pairs::form_closure_and_force_closure}, 2, 34, {}};
        section.cards.push_back({say({lang::pairs::form_closure}),
                                 [this] { return closure_figure(context_, Closure::form); },
                                 {plain_line({lang::pairs::the_slot_holds_the_roller})}});
        section.cards.push_back({say({lang::pairs::force_closure}),
                                 [this] { return closure_figure(context_, Closure::force); },
                                 {plain_line({lang::pairs::a_spring_or_a_weight_presses})}});
        return section;
    }
    Section links() const {
        Section section{"links", {lang::pairs::bodies_by_the_number_of_their}, 3, 25, {}};
        const std::array<Words, 3> names{Words(lang::pairs::binary_body), Words(lang::pairs::ternary_body),
                                         Words(lang::pairs::quaternary_body)};
        for (int pairs = 2; pairs <= 4; ++pairs)
            section.cards.push_back({say(names.at(static_cast<std::size_t>(pairs) - 2)),
                                     [this, pairs] { return link_figure(context_, pairs); },
                                     {plain_line(Words(lang::pairs::pairs, std::to_string(pairs)))}});
        return section;
    }
    Section chains() const {
        Section section{"chains", {lang::pairs::open_and_closed_chains}, 3, 37, {}};
        const auto card = [&](const Words& name, ChainDrawn chain, const Words& line) {
            section.cards.push_back(
                {say(name), [this, chain] { return chain_figure(context_, chain); }, {plain_line(line)}});
        };
        card({lang::pairs::open_chain}, ChainDrawn::open, {lang::pairs::no_loop_each_body_hangs});
        card({lang::pairs::closed_chain}, ChainDrawn::closed, {lang::pairs::loops_and_each_body});
        card({lang::pairs::mixed_chain}, ChainDrawn::mixed, {lang::pairs::loops_and_bodies_that_hang});
        return section;
    }
    Section hinges() const {
        Section section{"hinges", {say_word(lang::sheet::multiple_hinges)}, 4, 36, {}};
        section.cards.push_back(
            {say({lang::pairs::hinge_of_three_bodies}),
             [this] { return triple_hinge_figure(context_, nullptr); },
             {fact(say_word(lang::sheet::multiplicity), "2"), formula(say_word(lang::sheet::multiplicity_rule))}});
        const std::vector<BinaryScheme> schemes = binary_schemes(3);
        for (std::size_t i = 0; i < schemes.size(); ++i) {
            std::string hinges;
            for (const auto& hinge : schemes[i].hinges)
                hinges += "(" + std::to_string(hinge[0] + 1) + "–" + std::to_string(hinge[1] + 1) + ")";
            section.cards.push_back({say(Words(lang::pairs::equivalent_scheme, std::to_string(i + 1))),
                                     [this, scheme = schemes[i]] { return triple_hinge_figure(context_, &scheme); },
                                     {fact(say({lang::pairs::two_binary_hinges}), hinges)}});
        }
        section.cards.back().lines.push_back(formula(say_word(lang::sheet::stars_rule)));
        return section;
    }
    Section schemes_of_four() const {
        Section section{"schemes", {lang::pairs::hinge_of_four_bodies_bodies}, 8, 20, {}};
        const std::vector<BinaryScheme> schemes = binary_schemes(4);
        for (std::size_t i = 0; i < schemes.size(); ++i)
            section.cards.push_back(
                {std::to_string(i + 1), [this, scheme = schemes[i]] { return scheme_figure(context_, scheme); }, {}});
        section.closing = {lang::pairs::in_all_there_are_n_n};
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
            sheets_.back().emplace_back(GroupBegin{"band", {}, "", {{"data-question", section.question}}, none});
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
    solution.mechanism.title = Words(lang::sheet::catalogue_of_pairs);
    const DrawingContext context{solution, options.theme, fonts, options.language, Dimensions::off};
    const CatalogueText text(context);
    return CatalogueSheet(context, options).pages(text.sections());
}

}  // namespace kinegraph::render
