// Rows of a sweep over a parameter as curves. A value costs a solution, so the rows are the samples; only towards an
// edge, where the file ceases to have an answer, are there more, ever closer to it.
#pragma once

#include <functional>
#include <vector>

#include "constructions/positions/followed_curve.hpp"

namespace kinegraph::app {

/// Some numbers of a row.
struct SampledRow {
    double at = 0;
    FollowedCurve::Values values;
};
/// Where the answers end beside a row.
struct AnswersEnd {
    double row = 0, edge = 0;
};

/// The ends of the answers between neighbouring rows and values without an answer, both in their order, each found to
/// the last digits. At most `most` of them.
std::vector<AnswersEnd> ends_of_answers(const std::vector<double>& rows, const std::vector<double>& without,
                                        const std::function<bool(double)>& has_answer, std::size_t most);

/// Curves through rows, interrupted at gaps, and led on to the ends of the answers; none through fewer than three rows.
std::vector<FollowedCurve> curves_through(const std::vector<SampledRow>& rows, const std::vector<double>& gaps,
                                          const std::vector<AnswersEnd>& ends, const FollowedCurve::Evaluate& evaluate);

}  // namespace kinegraph::app
