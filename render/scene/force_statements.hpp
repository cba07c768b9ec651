// Force statements: which sentence of the solution gives a line of action, a point of concurrency, a force or a body's polygon.
// Reads the sentences' arguments; computes no statics.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "engine/solution.hpp"

namespace kinegraph::render {

/// All answers are indices into Protocol::statements; −1: it is given, no sentence finds it.
class ForceStatements {
public:
    explicit ForceStatements(const Solution& solution);

    /// After which the line on which a force acts is known; of a given force, after which its line leads to a meet.
    int line(const FreeBody& body, const AppliedForce& applied) const;
    /// After which the force is known.
    int force(const FreeBody& body, const AppliedForce& applied) const;
    /// That finds a point of concurrency.
    int meet(const std::string& name) const;
    /// After which all forces on the body are known.
    int polygon(const FreeBody& body) const;
    /// The bodies whose polygons a sentence closes: nothing of theirs is left to be found by a later one.
    std::vector<const FreeBody*> closed_by(std::size_t statement) const;

private:
    int last_that_closes(const FreeBody& body) const;
    std::set<std::string> names(const FreeBody& body, const AppliedForce& applied) const;

    const Solution& solution_;
    int sum_ = -1;  // that adds parts found apart, or opens the trial that gives all
};

}  // namespace kinegraph::render
