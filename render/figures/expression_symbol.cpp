#include "render/figures/expression_symbol.hpp"

#include "engine/number/assert.hpp"
#include "engine/results/result_names.hpp"
#include "engine/sentences/centre_symbol.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "render/figures/plot_figure.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {
namespace {

using Node = ResultExpression::Node;

/// How tightly a node holds together: a sum less than a product, a product less than a power.
enum class Binding { sum, product, power, single };

class ExpressionPrinter {
public:
    ExpressionPrinter(const ResultExpression& expression, const Mechanism& mechanism, Language language)
        : expression_(expression), mechanism_(mechanism), language_(language) {}

    RichText printed(const Node& of) const {
        switch (of.kind) {
            case Node::Kind::number: return one_piece(decimal_of(of.text));
            case Node::Kind::scalar: return typeset(expression_.parts()[of.x], mechanism_, language_);
            case Node::Kind::vector: {
                const Column& x = expression_.parts()[of.x];
                if (x.quantity.kind == Quantity::Kind::centre)
                    return render::typeset(centre_symbol(mechanism_, x.quantity.body, x.quantity.other, false),
                                           language_);
                return typeset(modulus_column(x, mechanism_), mechanism_, language_);
            }
            case Node::Kind::sum: return sum(of);
            case Node::Kind::product: return product(of);
            case Node::Kind::power: return power(of);
            case Node::Kind::negative: {
                RichText text = one_piece("−");
                append(text, within(of.parts[0], Binding::product));
                return text;
            }
            case Node::Kind::function: return function(of);
        }
        KG_ASSERT(false, "a node is of one kind");
    }

private:
    static Binding binding_of(const Node& of) {
        switch (of.kind) {
            case Node::Kind::sum:
            case Node::Kind::negative: return Binding::sum;
            case Node::Kind::product: return Binding::product;
            case Node::Kind::power: return Binding::power;
            default: return Binding::single;
        }
    }
    /// In brackets where it holds together less tightly.
    RichText within(const Node& of, Binding least) const {
        if (binding_of(of) >= least) return printed(of);
        return in_brackets("(", printed(of), ")");
    }
    static RichText in_brackets(const std::string& open, const RichText& text, const std::string& close) {
        RichText all = one_piece(open);
        append(all, text);
        append(all, close);
        return all;
    }
    std::string decimal_of(std::string text) const {
        const std::size_t point = text.find('.');
        if (point != std::string::npos) text[point] = notation(language_).decimal_mark;
        return text;
    }

    RichText sum(const Node& of) const {
        RichText text = printed(of.parts[0]);
        for (std::size_t i = 1; i < of.parts.size(); ++i) {
            append(text, std::string(of.is_inverse[i] ? " − " : " + "));
            append(text, within(of.parts[i], Binding::product));
        }
        return text;
    }
    RichText product(const Node& of) const {
        RichText text = within(of.parts[0], Binding::product);
        for (std::size_t i = 1; i < of.parts.size(); ++i) {
            append(text, std::string(of.is_inverse[i] ? "/" : " · "));
            append(text, within(of.parts[i], of.is_inverse[i] ? Binding::power : Binding::product));
        }
        return text;
    }
    RichText power(const Node& of) const {
        RichText text = within(of.parts[0], Binding::single);
        if (text.back().sup.empty())
            text.back().sup = of.text;
        else
            append(text, "^" + of.text);
        return text;
    }
    RichText function(const Node& of) const {
        RichText inner;
        for (const Node& part : of.parts) {
            if (!inner.empty()) append(inner, notation(language_).between_numbers + " ");
            append(inner, printed(part));
        }
        if (of.text == "abs") return in_brackets("|", inner, "|");
        return in_brackets((of.text == "sqrt" ? "√" : of.text) + "(", inner, ")");
    }

    const ResultExpression& expression_;
    const Mechanism& mechanism_;
    Language language_;
};

}  // namespace

RichText symbol_of(const ResultExpression& expression, const Mechanism& mechanism, Language language) {
    if (const auto said = expression.column().said) return one_piece(said->in(language));
    if (expression.is_named()) return one_piece(expression.column().name, Face::italic);
    return ExpressionPrinter(expression, mechanism, language).printed(expression.tree());
}

RichText equation_of(const ResultExpression& expression, const Mechanism& mechanism, Language language) {
    RichText text = symbol_of(expression, mechanism, language);
    if (!expression.is_named()) return text;
    append(text, std::string(" = "));
    append(text, ExpressionPrinter(expression, mechanism, language).printed(expression.tree()));
    return text;
}

}  // namespace kinegraph::render
