// Implementation of quiz_item.hpp.
#include "render/sheet/handout.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "engine/number/functions.hpp"
#include "engine/solution/problem_solution.hpp"
#include "lang/keys/sheet.hpp"
#include "render/content/exercise_text.hpp"
#include "render/content/title_block.hpp"
#include "render/figures/figure.hpp"
#include "render/layout/drawn_sheet.hpp"
#include "render/layout/page_plan.hpp"
#include "render/problems/problem_sections.hpp"
#include "render/scene/sentences.hpp"
#include "render/sheet/figure_alone.hpp"
#include "render/tables/answers.hpp"
#include "render/text/formula.hpp"

namespace kinegraph::render {
namespace {

/// A decimal number with `decimals` digits, without trailing zeros.
std::string decimal(double value, int decimals) {
    std::array<char, 400> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals).ptr;
    std::string text(digits.data(), end);
    if (text.find('.') != std::string::npos) {
        while (text.ends_with('0')) text.pop_back();
        if (text.ends_with('.')) text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

struct WrittenAnswer {
    std::string value, tolerance;
};
/// The value to a hundredth of its tolerance; the tolerance is rounded up to one digit.
WrittenAnswer written(double value, double tolerance) {
    if (!(tolerance > 0)) return {shortest(value), "0"};
    constexpr int beyond = 2, most = 15;
    const double round = rounded_up(tolerance);
    const int decimals = std::max(0, beyond - static_cast<int>(std::floor(nearest::log10(tolerance))));
    const int of_tolerance = std::max(0, -static_cast<int>(std::floor(nearest::log10(round) + 1e-9)));
    if (decimals > most) return {shortest(value), shortest(round)};
    return {decimal(value, decimals), decimal(round, of_tolerance)};
}

class QuizWriter {
public:
    QuizWriter(const Solution& solution, const SheetOptions& options, const Fonts& fonts)
        : options_(options),
          context_{solution, options.theme, fonts, options.language, options.dimensions},
          solution_(solution),
          is_problem_(stands_for_joints(solution.mechanism)),
          format_(format_of(options.paper, options.orientation)) {}

    QuizItem item(const std::vector<RequestedResult>& asked) {
        item_.title = title_of(solution_, language());
        item_.language = code_of(language());
        item_.blanks_heading = word(lang::sheet::sought, language());
        if (is_problem_)
            tell_problem();
        else
            tell_mechanism();
        add_blanks(asked);
        add_results();
        return std::move(item_);
    }

private:
    Language language() const { return context_.language; }

    // --- mechanisms

    void tell_mechanism() {
        SheetOptions as_solution = options_;
        as_solution.kind = SheetKind::solution;
        drawn_ = draw_solution(solution_, as_solution, context_.fonts).figures;
        answers_ = answers_of(context_, drawn_);
        const Box content = content_of(format_, true);
        item_.figure = page_of_figure(
            context_, exercise_figure(context_, drawn_.front().scale, content.width(), content.height()));
        item_.question.push_back({word(lang::sheet::data, language()), data_of(context_)});
        if (auto scales = scales_of(context_, drawn_, answers_sought(solution_.mechanism, answers_)); !scales.empty())
            item_.question.push_back({word(lang::sheet::scales, language()), std::move(scales)});
        for (const Statement& each : solution_.protocol.statements)
            if (!names_a_pair(each.message.sentence)) section_of(each.section).push_back(sentence(each));
        std::erase_if(item_.solution, [](const QuizSection& each) { return each.paragraphs.empty(); });
    }
    /// Sections in the order in which they begin; a section may be resumed later.
    std::vector<RichText>& section_of(Topic topic) {
        const std::string heading = heading_of(topic, language());
        for (QuizSection& each : item_.solution)
            if (each.heading == heading) return each.paragraphs;
        return item_.solution.emplace_back(QuizSection{heading, {}}).paragraphs;
    }
    /// With its vector equation on a separate line.
    RichText sentence(const Statement& statement) const {
        RichText text = say(statement.message, language());
        if (!statement.equation) return text;
        append(text, std::string("\n"));
        for (std::size_t side = 0; side < statement.equation->sides.size(); ++side) {
            const std::vector<Term>& terms = statement.equation->sides[side];
            for (std::size_t i = 0; i < terms.size(); ++i) {
                if (i > 0 || side > 0) append(text, std::string(i > 0 ? " + " : " = "));
                append(text, typeset(terms[i].symbol, language()));
            }
        }
        return text;
    }

    // --- problems

    void tell_problem() {
        std::vector<ProblemSection> sections = sections_of_problem(context_);
        ProblemSection& given = sections.front();
        constexpr double tallest = 80;
        const ProblemFigure& figure = given.figures.front();
        item_.figure =
            page_of_figure(context_, (figure.as_question ? figure.as_question : figure.draw)(format_.measure, tallest));
        QuizSection data{in(given.heading, language()), {}};
        const std::size_t told = given.sentences.size() - given.found;
        add_paragraphs(data, given, 0, told);
        item_.question.push_back(std::move(data));
        for (const ProblemSection& section : sections) {
            QuizSection solved{in(section.heading, language()), {}};
            add_paragraphs(solved, section, &section == &given ? told : 0, section.sentences.size());
            if (!solved.paragraphs.empty()) item_.solution.push_back(std::move(solved));
        }
    }
    /// Sentences from `first` to before `end`, each with its formulas.
    void add_paragraphs(QuizSection& to, const ProblemSection& of, std::size_t first, std::size_t end) const {
        for (std::size_t i = first; i < end; ++i) {
            to.paragraphs.push_back(said(of.sentences[i]));
            for (const PieceAfter& piece : of.pieces)
                if (piece.after == i + 1 && piece.item.kind == EquationItem::Kind::formula)
                    to.paragraphs.push_back(with_powers(piece.item.formula.plain()));
        }
    }
    RichText said(const Words& words) const { return formula(in(words, language())); }

    // --- answers

    void add_blanks(const std::vector<RequestedResult>& asked) {
        bool turns = false, has_vectors = false;
        for (const RequestedResult& each : asked) {
            const double off = is_problem_
                                   ? 0.01 * std::abs(each.value)
                                   : reading_tolerance(answers_, drawn_, each.column, each.value, solution_.mechanism);
            AskedText text = asked_text(context_, each.column);
            const WrittenAnswer number = written(each.value / each.unit_size, off / each.unit_size);
            item_.blanks.push_back({each.column.name, std::move(text.words), std::move(text.symbol), number.value,
                                    number.tolerance, each.unit});
            const QuantityKind kind = each.column.unit;
            turns = turns || kind == QuantityKind::angle || kind == QuantityKind::angular_velocity ||
                    kind == QuantityKind::angular_acceleration || kind == QuantityKind::moment;
            has_vectors = has_vectors || is_length(each.column);
        }
        if (turns) item_.notes.push_back(one_piece(word(turning_senses(solution_), language())));
        if (has_vectors) item_.notes.push_back(one_piece(word(lang::sheet::quiz_lengths, language())));
        if (!is_problem_) item_.notes.push_back(one_piece(word(lang::sheet::tolerances, language())));
    }
    static bool is_length(const Column& column) {
        const Quantity::Kind kind = column.quantity.kind;
        return column.kind == Column::Kind::result && column.quantity.component == Quantity::Component::whole &&
               (kind == Quantity::Kind::velocity || kind == Quantity::Kind::acceleration ||
                kind == Quantity::Kind::force);
    }
    /// The numerical answers, at the end of the solution.
    void add_results() {
        QuizSection results{word(lang::sheet::answers, language()), {}};
        for (const QuizBlank& each : item_.blanks) {
            RichText line = each.symbol;
            append(line, std::string(" = "));
            append(line, with_powers(number(read(each.value), 4, language())));
            if (each.tolerance != "0") append(line, with_powers(" ± " + shortest(read(each.tolerance), language())));
            const bool close = each.unit.empty() || each.unit == "°";
            append(line, with_powers((close ? "" : " ") + each.unit));
            results.paragraphs.push_back(std::move(line));
        }
        item_.solution.push_back(std::move(results));
    }
    static double read(const std::string& decimal) {
        double value = 0;
        std::from_chars(decimal.data(), decimal.data() + decimal.size(), value);
        return value;
    }

    const SheetOptions& options_;
    DrawingContext context_;
    const Solution& solution_;
    bool is_problem_;
    SheetFormat format_;
    std::vector<Figure> drawn_;
    std::vector<Answer> answers_;
    QuizItem item_;
};

}  // namespace

QuizItem quiz_item_of(const Solution& solution, const std::vector<RequestedResult>& asked, const SheetOptions& options,
                      const Fonts& fonts) {
    return QuizWriter(solution, options, fonts).item(asked);
}

}  // namespace kinegraph::render
