// Which statement draws a mark: its own, or that of a group round it.
#pragma once

#include <variant>
#include <vector>

#include "render/page/page.hpp"

namespace kinegraph::render {

/// Finds the statement of each mark of a figure in turn.
class Nesting {
public:
    /// The statement of the next mark. Call it for the marks in order.
    StatementIndex enter(const Mark& mark) {
        if (std::holds_alternative<GroupEnd>(mark)) {
            groups_.pop_back();
            return none;
        }
        const StatementIndex own = own_statement(mark);
        const StatementIndex statement = own != none || groups_.empty() ? own : groups_.back();
        if (std::holds_alternative<GroupBegin>(mark)) groups_.push_back(statement);
        return statement;
    }

private:
    static StatementIndex own_statement(const Mark& mark) {
        return std::visit(
            [](const auto& each) {
                if constexpr (requires { each.statement; })
                    return each.statement;
                else
                    return StatementIndex();
            },
            mark);
    }
    std::vector<StatementIndex> groups_;  // open
};

}  // namespace kinegraph::render
