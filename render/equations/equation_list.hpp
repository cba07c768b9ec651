// The list that the text of the closure equations is made of, as it grows: headings, sentences, formulas, tables in
// their order.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "render/equations/equation_text.hpp"

namespace kinegraph::render::closure {

class EquationList {
public:
    explicit EquationList(Language language) : language_(language) {}

    void heading(const Words& words, bool is_apart = false) {
        items_.push_back({EquationItem::Kind::heading, in(words, language_), {}, {}, is_apart});
    }
    void say(const Words& words) { say_text(in(words, language_)); }
    void say_text(std::string words) { items_.push_back({EquationItem::Kind::words, std::move(words), {}, {}}); }
    void set(Formula formula) { items_.push_back({EquationItem::Kind::formula, {}, std::move(formula), {}}); }
    void table(std::vector<std::vector<Formula>> rows) {
        items_.push_back({EquationItem::Kind::table, {}, {}, std::move(rows)});
    }
    std::vector<EquationItem> taken() { return std::move(items_); }

private:
    Language language_;
    std::vector<EquationItem> items_;
};

}  // namespace kinegraph::render::closure
