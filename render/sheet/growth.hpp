// Lines that grow: what of a figure stands on a picture between two steps of a film.
#pragma once

#include <functional>
#include <vector>

#include "render/page/page.hpp"

namespace kinegraph::render {

/// Tells whether the marks of a statement (or of none) are those that grow.
using Grows = std::function<bool(StatementIndex)>;

/// The length of the lines that grow, mm.
double length_that_grows(const std::vector<Mark>& marks, const Grows& grows);
/// The marks of a figure when a share (0 to 1) of that length is drawn. Lines are drawn in the order of their
/// statements, then in that of the figure, at one speed; letters and fillings appear when the lines before them are
/// done. What does not grow is all there.
std::vector<Mark> grown(const std::vector<Mark>& marks, const Grows& grows, double share);

/// The first `part` mm of a path, without its filling.
Path beginning_of(const Path& path, double part);
/// The length of its strokes, mm; 0 of a path that is only filled.
double length_of(const Path& path);

}  // namespace kinegraph::render
