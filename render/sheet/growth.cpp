#include "render/sheet/growth.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "render/sheet/statement_of_marks.hpp"

namespace kinegraph::render {
namespace {

Spot on_the_way(Spot a, Spot b, double share) { return a + share * (b - a); }

/// A curve up to a share of its parameter (de Casteljau).
CurveTo beginning_of(Spot from, const CurveTo& curve, double share) {
    const Spot a = on_the_way(from, curve.control_1, share), b = on_the_way(curve.control_1, curve.control_2, share),
               c = on_the_way(curve.control_2, curve.to, share), ab = on_the_way(a, b, share),
               bc = on_the_way(b, c, share);
    return {a, ab, on_the_way(ab, bc, share)};
}

/// Goes along a path and keeps what lies within its first `part` mm.
class Pacing {
public:
    explicit Pacing(double part) : part_(part) {}

    void operator()(const MoveTo& move) {
        at_ = begin_ = move.to;
        kept_.emplace_back(move);
    }
    void operator()(const LineTo& line) {
        const double share = advance(render::length(line.to - at_));
        kept_.emplace_back(LineTo{on_the_way(at_, line.to, share)});
        at_ = line.to;
    }
    /// Its length is that of sixteen chords: the pace is even enough for the eye.
    void operator()(const CurveTo& curve) {
        constexpr int chords = 16;
        double length = 0;
        Spot last = at_;
        for (int i = 1; i <= chords; ++i) {
            const Spot next = beginning_of(at_, curve, static_cast<double>(i) / chords).to;
            length += render::length(next - last);
            last = next;
        }
        const double share = advance(length);
        kept_.emplace_back(share < 1 ? beginning_of(at_, curve, share) : curve);
        at_ = curve.to;
    }
    void operator()(ArcTo arc) {
        // A line leads to its beginning, unless a path or a part of one begins there.
        const Spot first = arc.centre + arc.radius * polar_spot(arc.from),
                   last = arc.centre + arc.radius * polar_spot(arc.to);
        if (kept_.empty()) at_ = begin_ = first;
        passed_ += render::length(first - at_);
        const double share = advance(arc.radius * std::abs(arc.to - arc.from));
        arc.to = arc.from + share * (arc.to - arc.from);
        kept_.emplace_back(arc);
        at_ = last;
    }
    void operator()(const Close& /*end*/) {
        const double share = advance(render::length(begin_ - at_));
        kept_.emplace_back(share < 1 ? Segment(LineTo{on_the_way(at_, begin_, share)}) : Segment(Close{}));
        at_ = begin_;
    }

    bool is_done() const { return passed_ >= part_; }
    double passed() const { return passed_; }
    std::vector<Segment> take() { return std::move(kept_); }

private:
    /// The share of a segment that lies within the part.
    double advance(double length) {
        const double left = part_ - passed_;
        passed_ += length;
        return length > 0 ? std::clamp(left / length, 0.0, 1.0) : 1;
    }
    double part_;
    double passed_ = 0;
    Spot at_, begin_;
    std::vector<Segment> kept_;
};

/// What is drawn of a mark: its beginning and end on the way along all lines that grow.
struct Span {
    double from = 0, to = 0;
};

/// The spans of the marks that grow, by their place in the figure.
std::map<std::size_t, Span> spans_of(const std::vector<Mark>& marks, const Grows& grows) {
    struct Growing {
        StatementIndex statement;
        std::size_t mark;
        double length;
    };
    std::vector<Growing> all;
    Nesting nesting;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const StatementIndex statement = nesting.enter(marks[i]);
        const auto* const path = std::get_if<Path>(&marks[i]);
        if ((path || std::holds_alternative<TextMark>(marks[i])) && grows(statement))
            all.push_back({statement, i, path ? length_of(*path) : 0});
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Growing& a, const Growing& b) { return a.statement < b.statement; });
    std::map<std::size_t, Span> spans;
    double passed = 0;
    for (const Growing& each : all) {
        spans[each.mark] = {passed, passed + each.length};
        passed += each.length;
    }
    return spans;
}

}  // namespace

double length_of(const Path& path) {
    if (!path.stroked) return 0;
    Pacing pacing(0);
    for (const Segment& each : path.segments) std::visit(pacing, each);
    return pacing.passed();
}

Path beginning_of(const Path& path, double part) {
    Path beginning = path;
    beginning.filled = false;
    Pacing pacing(part);
    for (const Segment& each : path.segments) {
        if (pacing.is_done()) break;
        std::visit(pacing, each);
    }
    beginning.segments = pacing.take();
    return beginning;
}

double length_that_grows(const std::vector<Mark>& marks, const Grows& grows) {
    double length = 0;
    for (const auto& [mark, span] : spans_of(marks, grows)) length = std::max(length, span.to);
    return length;
}

std::vector<Mark> grown(const std::vector<Mark>& marks, const Grows& grows, double share) {
    const std::map<std::size_t, Span> spans = spans_of(marks, grows);
    const double drawn = share * length_that_grows(marks, grows);
    std::vector<Mark> shown;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const auto span = spans.find(i);
        if (span == spans.end() || span->second.to <= drawn) {
            shown.push_back(marks[i]);
        } else if (span->second.from < drawn) {
            shown.emplace_back(beginning_of(std::get<Path>(marks[i]), drawn - span->second.from));
        }
    }
    return shown;
}

}  // namespace kinegraph::render
