#include "render/equations/equation_text.hpp"

#include <algorithm>
#include <array>

#include "lang/keys/equations.hpp"
#include "render/equations/equation_chapters.hpp"
#include "render/equations/equation_pen.hpp"
#include "render/text/bound_blank.hpp"
#include "render/text/formula.hpp"
#include "render/text/utf8.hpp"

namespace kinegraph::render {
namespace {

using Kind = EquationItem::Kind;

/// Everything, in the order of a calculation by hand.
std::vector<EquationItem> worked_out(const Solution& solution, Language language) {
    const Equations& equations = *solution.equations;
    const closure::EquationPen pen(equations, solution.mechanism, language);
    closure::EquationList list(language);
    closure::LettersTable(solution, pen, list).write_letters();
    closure::PositionText(solution, pen, list).write_positions();
    if (!equations.unknowns.empty() && !equations.free.empty()) {
        closure::RateText rates(solution, pen, list);
        closure::RatioText ratios(solution, pen, list);
        rates.write_velocities();
        ratios.write_ratios();
        if (equations.by_tangent.empty() && equations.is_regular()) {
            rates.write_accelerations();
            ratios.write_second_ratios();
        }
    }
    closure::ReachText(solution, pen, list).write_reaches();
    if (!equations.free.empty()) closure::DrawnRates(solution, pen, list).write_values();
    closure::DeadPointText(solution, pen, list).write_dead_points();
    return list.taken();
}

/// Without intermediate steps.
std::vector<EquationItem> answered(const Solution& solution, Language language) {
    const Equations& equations = *solution.equations;
    const closure::EquationPen pen(equations, solution.mechanism, language);
    closure::EquationList list(language);
    if (!equations.unknowns.empty() && !equations.free.empty()) {
        closure::RatioText ratios(solution, pen, list);
        ratios.write_ratios();
        if (equations.by_tangent.empty() && equations.is_regular()) ratios.write_second_ratios();
    }
    closure::DeadPointText(solution, pen, list).write_dead_points();
    return list.taken();
}

}  // namespace

std::vector<EquationItem> equation_items(const Solution& solution, Language language) {
    if (!solution.equations) return {};
    if (!solution.equations->why_not.empty())
        return {{EquationItem::Kind::heading, in(Words(lang::equations::closure_equations), language), {}, {}},
                {EquationItem::Kind::words,
                 in(Words(lang::equations::there_are_none, solution.equations->why_not), language),
                 {},
                 {}}};
    return worked_out(solution, language);
}

std::vector<EquationItem> equation_answers(const Solution& solution, Language language) {
    if (!solution.equations || !solution.equations->why_not.empty()) return {};
    return answered(solution, language);
}

namespace {

/// Powers of units for a terminal: "m/s²".
std::string as_words(const RichText& text) {
    std::string words;
    for (const Piece& piece : text) {
        const bool squared = piece.sup == "2";
        Piece own = piece;
        if (squared) own.sup.clear();
        words += plain({own}) + (squared ? "²" : "");
    }
    return words;
}

}  // namespace

std::string as_text(std::span<const EquationItem> items) {
    std::string text;
    for (const EquationItem& item : items) {
        if (item.kind == Kind::heading) text += (text.empty() ? "" : "\n") + item.words + "\n";
        if (item.kind == Kind::words) text += as_words(formula(item.words)) + "\n";
        if (item.kind == Kind::formula) text += "  " + item.formula.plain() + "\n";
        std::vector<std::size_t> wide;
        for (const auto& row : item.rows)
            for (std::size_t c = 0; c < row.size(); ++c) {
                if (wide.size() <= c) wide.push_back(0);
                wide[c] = std::max(wide[c], character_count(row[c].plain()));
            }
        for (const auto& row : item.rows) {
            std::string line = " ";
            for (std::size_t c = 0; c < row.size(); ++c) {
                const std::string cell = row[c].plain();
                line += " " + cell + (c + 1 < row.size() ? std::string(wide[c] - character_count(cell) + 1, ' ') : "");
            }
            text += line + "\n";
        }
    }
    return text;
}

namespace {

/// `heading`: the LaTeX around the words of a heading.
std::string latex_text(std::span<const EquationItem> items, const std::array<const char*, 2>& heading) {
    const auto safe = [](const std::string& words) {
        std::string text;
        for (const char c : words) {
            if (c == '_' || c == '%' || c == '&' || c == '#' || c == '$' || c == '{' || c == '}') text += '\\';
            text += c == bound_blank ? ' ' : c;
        }
        return text;
    };
    std::string text;
    for (const EquationItem& item : items) {
        if (item.kind == Kind::heading) text += heading[0] + safe(item.words) + heading[1];
        if (item.kind == Kind::words) {
            for (const Piece& piece : formula(item.words))
                text += piece.face == Face::italic
                            ? "$" + Formula::letter(letter_spelt(piece.text), piece.sub).latex() + "$"
                            : safe(piece.text) + (piece.sup.empty() ? "" : "$^{" + piece.sup + "}$");
            text += "\n\n";
        }
        if (item.kind == Kind::formula) text += "\\[" + item.formula.latex() + "\\]\n";
        if (item.kind != Kind::table) continue;
        std::string array = "\\begin{array}{" + std::string(item.rows.front().size(), 'l') + "}";
        for (std::size_t r = 0; r < item.rows.size(); ++r)
            for (std::size_t c = 0; c < item.rows[r].size(); ++c)
                array += (c > 0 ? " & " : r > 0 ? " \\\\ " : "") + item.rows[r][c].latex();
        text += "\\[" + array + "\\end{array}\\]\n";
    }
    return text;
}

}  // namespace

std::string as_latex(std::span<const EquationItem> items) {
    return "\\documentclass{article}\n\\usepackage{amsmath}\n\\begin{document}\n" +
           latex_text(items, {"\\section*{", "}\n"}) + "\\end{document}\n";
}
std::string as_formulas(std::span<const EquationItem> items) { return latex_text(items, {"\\[\\textbf{", "}\\]\n"}); }

}  // namespace kinegraph::render
