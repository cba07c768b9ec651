#include "render/geogebra/geogebra.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "engine/number/assert.hpp"
#include "engine/number/functions.hpp"
#include "engine/solution/solution.hpp"
#include "lang/keys/library.hpp"
#include "render/geogebra/construction.hpp"
#include "render/geogebra/placing.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {
namespace {

/// What a stroke is in GeoGebra: a command with the stroke's inputs, or an expression in which {a} and {b} are the
/// inputs and {s} is the scale at which its plane is drawn. Points of a polygon are drawn at its scale, vectors and
/// numbers are values in SI units.
struct VerbCommand {
    Verb verb;
    GeoGebraType type;
    const char* command;     ///< null: the expression
    const char* expression;  ///< null: the verb has a function of its own below, or belongs to forces
};
constexpr std::array verb_commands{
    VerbCommand{Verb::vector_between, GeoGebraType::vector, nullptr, "({b} - {a}) / {s}"},
    VerbCommand{Verb::perpendicular, GeoGebraType::vector, "PerpendicularVector", nullptr},
    VerbCommand{Verb::turn, GeoGebraType::vector, "PerpendicularVector", nullptr},
    VerbCommand{Verb::through, GeoGebraType::line, "Line", nullptr},
    VerbCommand{Verb::join, GeoGebraType::line, "Line", nullptr},
    VerbCommand{Verb::meet, GeoGebraType::point, "Intersect", nullptr},
    VerbCommand{Verb::carry, GeoGebraType::point, nullptr, "{a} + {s} * {b}"},
    VerbCommand{Verb::add, GeoGebraType::vector, nullptr, "{a} + {b}"},
    VerbCommand{Verb::subtract, GeoGebraType::vector, nullptr, "{a} - {b}"},
    VerbCommand{Verb::negate, GeoGebraType::vector, nullptr, "-1 * {a}"},
    VerbCommand{Verb::scale, GeoGebraType::vector, nullptr, "{a} * {b}"},
    VerbCommand{Verb::ratio, GeoGebraType::number, nullptr, "({a} * {b}) / ({b} * {b})"},
    VerbCommand{Verb::product, GeoGebraType::number, nullptr, "{a} * {b}"},
    VerbCommand{Verb::sum, GeoGebraType::number, nullptr, "{a} + {b}"},
    VerbCommand{Verb::difference, GeoGebraType::number, nullptr, "{a} - {b}"},
    VerbCommand{Verb::opposite, GeoGebraType::number, nullptr, "-1 * {a}"},
    VerbCommand{Verb::quotient, GeoGebraType::number, nullptr, "{a} / {b}"},
    VerbCommand{Verb::moment, GeoGebraType::number, nullptr, "x({a}) * y({b}) - y({a}) * x({b})"},
    VerbCommand{Verb::projection, GeoGebraType::number, nullptr, "{a} * {b}"},
    VerbCommand{Verb::arm, GeoGebraType::vector, nullptr, "-{a} / ({b} * {b}) * PerpendicularVector({b})"},
};

std::string filled_expression(std::string_view pattern, const std::string& a, const std::string& b,
                              const std::string& scale) {
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if (pattern[i] != '{') {
            text += pattern[i];
            continue;
        }
        text += pattern[i + 1] == 'a' ? a : pattern[i + 1] == 'b' ? b : scale;
        i += 2;
    }
    return text;
}

/// v_{B}, or with a superscript in the letters of LaTeX.
std::string caption_of(const Symbol& symbol) {
    if (symbol.letter == Symbol::Letter::image || symbol.letter == Symbol::Letter::point) return name_of(symbol);
    const std::string stem = name_of(Symbol{symbol.letter, {}, {}});
    const std::string below = symbol.about.empty() ? "" : "_{" + symbol.about + "}";
    if (symbol.term.empty() || symbol.term == "∞") return stem + below;
    return "$" + stem + below + "^{" + symbol.term + "}$";
}

/// 1, 2 or 5 times a power of ten, at most the value.
double round_below(double value) {
    const double power = nearest::pow(10, std::floor(nearest::log10(value)));
    return (value >= 5 * power ? 5 : value >= 2 * power ? 2 : 1) * power;
}

bool is_motion_plane(Plane plane) { return plane == Plane::velocity || plane == Plane::acceleration; }

class GeoGebraRecord {
public:
    GeoGebraRecord(const Solution& solution, const Theme& theme, Language language)
        : solution_(solution),
          protocol_(solution.protocol),
          program_(solution.protocol.program),
          theme_(theme),
          language_(language),
          construction_(solution.mechanism.title.in(language), {}),
          placing_(construction_, solution.mechanism, solution.pose, shown(theme.text)),
          labels_(program_.strokes.size()) {}

    tl::expected<std::string, Words> xml() {
        find_bounds();
        draw_position();
        choose_scales();
        find_drawn();
        find_needed();
        for (std::size_t i = 0; i < program_.strokes.size(); ++i)
            if (needed_[i]) add_stroke(ElementIndex(i));
        if (placing_.fault()) return tl::unexpected(*placing_.fault());
        const double top = high_ + 0.3 * size_;
        // Of many sentences the last stand below what is seen at first.
        constexpr double height_over_width = 0.6;
        const double bottom = std::min(low_ - 0.3 * size_, top - height_over_width * width());
        return construction_.xml({left_ - 0.2 * size_, left_ - 0.2 * size_ + width(), bottom, top});
    }

private:
    static GeoGebraLook shown(Colour colour, std::string caption = {}, bool dashed = false) {
        return {true, dashed, colour, std::move(caption)};
    }

    /// What is seen: the mechanism and the two polygons beside it.
    double width() const { return right_ - left_ + 3.2 * size_; }
    /// Of the points, and of the centres that are not too far away to be seen beside them.
    void find_bounds() {
        const auto& points = solution_.pose.points;
        size_ = solution_.pose.size.to_double();
        const VectorOf<double> first = to_double(points.front());
        left_ = right_ = first.x;
        low_ = high_ = first.y;
        for (const Vector& point : points) include(to_double(point));
        const double far = 1.2 * size_, left = left_ - far, right = right_ + far, low = low_ - far, high = high_ + far;
        for (const InstantCentre& each : solution_.centres) {
            if (!each.at || each.at->at_infinity()) continue;
            const VectorOf<double> at = to_double(each.at->place());
            if (at.x > left && at.x < right && at.y > low && at.y < high) include(at);
        }
    }
    void include(const VectorOf<double>& at) {
        left_ = std::min(left_, at.x);
        right_ = std::max(right_, at.x);
        low_ = std::min(low_, at.y);
        high_ = std::max(high_, at.y);
    }

    void draw_position() {
        const Mechanism& mechanism = solution_.mechanism;
        for (std::size_t i = 0; i < mechanism.points.size(); ++i) placing_.point(PointIndex(i));
        for (std::size_t i = 1; i < mechanism.bodies.size(); ++i) {
            const Body& body = mechanism.bodies[i];
            const GeoGebraLook look = shown(theme_.colour_of(BodyIndex(i)).line);
            std::vector<std::string> corners;
            for (const PointIndex point : body.points) corners.push_back(placing_.point(point));
            if (corners.size() == 2)
                construction_.command("Segment", corners, GeoGebraType::segment, construction_.label("s"), look);
            if (corners.size() > 2)
                construction_.command("Polygon", corners, GeoGebraType::polygon, construction_.label("t"), look);
        }
        construction_.pause();
    }

    /// The polygons stand to the right of the mechanism, each with its pole and the scale at which it is drawn. Both
    /// can be changed.
    void choose_scales() {
        std::map<Plane, double> longest;
        for (const DrawnVector& each : protocol_.vectors) {
            const Plane plane = plane_of(each);
            if (is_motion_plane(plane)) longest[plane] = std::max(longest[plane], protocol_.modulus_of(each));
        }
        double x = right_ + 0.6 * size_;
        for (const auto& [plane, length] : longest) {
            const double scale = length > 0 ? round_below(0.9 * size_ / length) : 1;
            scales_[plane] =
                construction_.free_number(construction_.label("scale", plane == Plane::velocity ? "v" : "a"), scale);
            poles_[plane] = {x, low_ + 0.5 * (high_ - low_)};
            x += 1.3 * size_;
        }
    }

    Plane plane_of(const DrawnVector& vector) const { return protocol_.polygons[at_index(vector.polygon)].plane; }

    /// What is shown, by the last stroke that it needs.
    void find_drawn() {
        for (const DrawnVector& each : protocol_.vectors)
            if (is_motion_plane(plane_of(each)) && !each.vanishes)
                vectors_[std::max(each.tail, each.tip)].push_back(&each);
        for (const Image& each : protocol_.images)
            if (is_motion_plane(protocol_.polygons[at_index(each.polygon)].plane))
                captions_.emplace(each.point, shown(theme_.text, caption_of(each.symbol)));
        for (const DrawnLine& each : protocol_.lines) {
            const bool is_of_motion = each.polygon < 0
                                          ? is_of_centres(each.statement)
                                          : is_motion_plane(protocol_.polygons[at_index(each.polygon)].plane);
            if (is_of_motion) captions_.emplace(each.line, shown(theme_.secondary, {}, true));
        }
        for (const InstantCentre& each : solution_.centres) {
            if (!each.at || each.at.element() == none) continue;
            const auto& bodies = solution_.mechanism.bodies;
            const std::string name = bodies[at_index(each.first)].name + bodies[at_index(each.second)].name;
            captions_.emplace(each.at.element(), shown(theme_.accent, "P_{" + name + "}"));
            // Kennedy's two lines, on which it lies.
            const Stroke& stroke = program_.strokes[at_index(each.at.element())];
            if (stroke.verb != Verb::meet || each.how != InstantCentre::How::kennedy) continue;
            for (const ElementIndex line : stroke.inputs) captions_.emplace(line, shown(theme_.faint, {}, true));
        }
        for (std::size_t i = 0; i < solution_.bodies.size(); ++i) {
            const std::string& name = solution_.mechanism.bodies[i].name;
            if (solution_.bodies[i].omega) results_.emplace(solution_.bodies[i].omega.element(), std::pair("ω", name));
            if (solution_.bodies[i].alpha) results_.emplace(solution_.bodies[i].alpha.element(), std::pair("α", name));
        }
        results_.erase(none);
    }
    bool is_of_centres(StatementIndex statement) const {
        return statement != none && protocol_.statements[at_index(statement)].section == Topic::centres;
    }

    /// The strokes of what is drawn and found, without those that hang on forces.
    void find_needed() {
        const std::size_t count = program_.strokes.size();
        std::vector<bool> of_forces(count, false);
        needed_.assign(count, false);
        for (std::size_t i = 0; i < count; ++i) {
            of_forces[i] = program_.strokes[i].plane == Plane::force;
            for (const ElementIndex input : program_.strokes[i].inputs)
                if (input != none && of_forces[at_index(input)]) of_forces[i] = true;
        }
        const auto want = [&](ElementIndex element) {
            if (element != none && !of_forces[at_index(element)]) needed_[at_index(element)] = true;
        };
        for (const auto& [element, all] : vectors_) {
            for (const DrawnVector* each : all) {
                want(each->tail);
                want(each->tip);
            }
        }
        for (const auto& [element, look] : captions_) want(element);
        for (const auto& [element, name] : results_) want(element);
        for (std::size_t i = count; i-- > 0;)
            for (const ElementIndex input : program_.strokes[i].inputs)
                if (needed_[i] && input != none) needed_[at_index(input)] = true;
    }

    const std::string& label(ElementIndex element) const {
        static const std::string no_label;
        return element == none ? no_label : labels_[at_index(element)];
    }
    std::string fresh_label(ElementIndex element, GeoGebraType type) {
        const auto result = results_.find(element);
        if (result != results_.end()) return construction_.label(result->second.first, result->second.second);
        switch (type) {
            case GeoGebraType::point: return construction_.label("K");
            case GeoGebraType::line: return construction_.label("l");
            case GeoGebraType::vector: return construction_.label("u");
            default: return construction_.label("k");
        }
    }
    GeoGebraLook look_of(ElementIndex element) const {
        const auto found = captions_.find(element);
        return found == captions_.end() ? GeoGebraLook{} : found->second;
    }

    void add_stroke(ElementIndex element) {
        const Stroke& stroke = program_.strokes[at_index(element)];
        say_sentence(stroke.statement);
        labels_[at_index(element)] = made(element, stroke);
        const auto vectors = vectors_.find(element);
        if (vectors == vectors_.end()) return;
        for (const DrawnVector* each : vectors->second)
            construction_.command("Vector", {label(each->tail), label(each->tip)}, GeoGebraType::vector,
                                  construction_.label("v"),
                                  shown(theme_.colour_of(each->body).line, caption_of(each->symbol)));
    }

    std::string made(ElementIndex element, const Stroke& stroke) {
        switch (stroke.verb) {
            case Verb::given_point: return placing_.point(PointIndex(program_.givens[at_index(stroke.given)].index));
            case Verb::given_vector:
            case Verb::given_scalar: return given(element, stroke);
            case Verb::pole: {
                const auto [x, y] = poles_[stroke.plane];
                return construction_.free_point(construction_.label("O"), x, y, look_of(element));
            }
            case Verb::point_at_infinity: return label(stroke.inputs[0]);  // its direction stands for it
            case Verb::direction_of_line: return direction_of_line(stroke.inputs[0]);
            case Verb::meet_at_infinity:
                return direction_of_line(stroke.inputs[is_at_infinity(program_, stroke.inputs[0]) ? 1 : 0]);
            default: break;
        }
        if (is_at_infinity(program_, element)) return {};  // the line at infinity
        const auto row = std::find_if(verb_commands.begin(), verb_commands.end(),
                                      [&](const VerbCommand& each) { return each.verb == stroke.verb; });
        KG_ASSERT(row != verb_commands.end(), "every other verb has a row");
        std::string a = label(stroke.inputs[0]), b = label(stroke.inputs[1]);
        // A line is given by a point and a second point or a direction, in this order.
        if (stroke.verb == Verb::join && is_at_infinity(program_, stroke.inputs[0])) std::swap(a, b);
        std::string own = fresh_label(element, row->type);
        if (row->command != nullptr) {
            std::vector<std::string> inputs{a};
            if (!b.empty()) inputs.push_back(b);
            return construction_.command(row->command, inputs, row->type, std::move(own), look_of(element));
        }
        if (stroke.plane == Plane::drawing && stroke.verb == Verb::vector_between)
            return construction_.command("Vector", {a, b}, row->type, std::move(own), look_of(element));
        const auto scale = scales_.find(stroke.plane);
        return construction_.expression(
            filled_expression(row->expression, a, b, scale == scales_.end() ? "1" : scale->second), row->type,
            std::move(own), look_of(element));
    }

    /// A result that is given, such as the speed of the driver, has its name, too.
    std::string given(ElementIndex element, const Stroke& stroke) {
        std::string value = placing_.given(program_.givens[at_index(stroke.given)]);
        if (value.empty() || !results_.contains(element)) return value;
        return construction_.expression(value, GeoGebraType::number, fresh_label(element, GeoGebraType::number));
    }

    /// The sense in which the board takes it: against the vector or from the second point to the first.
    std::string direction_of_line(ElementIndex line) {
        const Stroke& stroke = program_.strokes[at_index(line)];
        const ElementIndex a = stroke.inputs[0], b = stroke.inputs[1];
        const bool second = stroke.verb == Verb::through || is_at_infinity(program_, b);
        const std::string text = second                        ? "-1 * " + label(b)
                                 : is_at_infinity(program_, a) ? "-1 * " + label(a)
                                                               : "1 * (" + label(a) + " - " + label(b) + ')';
        return construction_.expression(text, GeoGebraType::vector, construction_.label("u"));
    }

    /// The sentence of the strokes that follow, below the mechanism; GeoGebra's protocol pauses before it.
    void say_sentence(StatementIndex statement) {
        if (statement == none || statement == last_statement_) return;
        last_statement_ = statement;
        if (!said_.insert(statement).second) return;
        construction_.pause();
        ++texts_;
        constexpr double row = 0.017;  // of the width: lines of 20 pixels on a screen of 1200
        construction_.text(
            std::to_string(texts_) + ". " + tell(protocol_.statements[at_index(statement)].message, language_), left_,
            low_ - 0.3 * size_ - row * texts_ * width());
    }

    const Solution& solution_;
    const Protocol& protocol_;
    const Program& program_;
    const Theme& theme_;
    Language language_;
    GeoGebraConstruction construction_;
    GeoGebraPlacing placing_;
    double left_ = 0, right_ = 0, low_ = 0, high_ = 0, size_ = 1;
    std::map<Plane, std::string> scales_;
    std::map<Plane, std::pair<double, double>> poles_;
    std::map<ElementIndex, std::vector<const DrawnVector*>> vectors_;  ///< by the later of tail and tip
    std::map<ElementIndex, GeoGebraLook> captions_;                    ///< of points and lines that are shown
    std::map<ElementIndex, std::pair<const char*, std::string>> results_;
    std::vector<bool> needed_;
    std::vector<std::string> labels_;  ///< by element; of a point at infinity that of its direction
    std::set<StatementIndex> said_;
    StatementIndex last_statement_ = none;
    int texts_ = 0;
};

}  // namespace

tl::expected<std::string, Words> geogebra_xml(const Solution& solution, const Theme& theme, Language language) {
    if (solution.problem || solution.mechanism.points.empty())
        return tl::unexpected(Words(lang::library::geogebra_takes_mechanisms));
    return GeoGebraRecord(solution, theme, language).xml();
}

}  // namespace kinegraph::render
