// Makes the bands of a solution (given data and centres, polygons of motion, lines of action, one band for each body,
// closed polygon), and their text row by row.
#include "render/content/bands.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>

#include "engine/number/assert.hpp"
#include "engine/solution/problem_solution.hpp"
#include "lang/keys/notation.hpp"
#include "lang/keys/sentences.hpp"
#include "lang/keys/sheet.hpp"
#include "render/equations/chapters.hpp"
#include "render/equations/prose.hpp"
#include "render/figures/figure.hpp"
#include "render/page/shapes.hpp"
#include "render/scene/load_case.hpp"
#include "render/scene/sentences.hpp"
#include "render/tables/answers.hpp"
#include "render/tables/force_tables.hpp"
#include "render/tables/truss_table.hpp"
#include "render/text/formula.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {
namespace {

using Kind = Band::Part::Kind;

/// The text of one band for a given width.
class BandText {
public:
    using Likewise = std::map<std::size_t, std::vector<std::size_t>>;
    BandText(const DrawingContext& context, double measure, bool equations_apart,
             const std::map<std::size_t, int>& steps, const Likewise& likewise, bool with_centres,
             const std::vector<EquationItem>& equations, const std::vector<LineNumbers>& lines, MadeOnce& made,
             const WantedFigures& wanted, const std::string& figures_stand)
        : context_(context),
          solution_(context.solution),
          measure_(measure),
          equations_apart_(equations_apart),
          steps_(steps),
          likewise_(likewise),
          with_centres_(with_centres),
          equations_(equations),
          lines_(lines),
          made_(made),
          wanted_(wanted),
          figures_stand_(figures_stand) {}

    /// The passage of any part except results.
    Passage passage_of(const Band::Part& part, const std::map<std::string, RichText>& on_figures) const {
        switch (part.kind) {
            case Kind::bodies:
                if (!made_.bodies) made_.bodies.emplace(context_);
                return as_table(under(lang::sheet::bodies, made_.bodies->lines(measure_)));
            case Kind::mobility:
                // For a single body no degrees of freedom are counted.
                return under(solution_.instantaneous_motion ? lang::sheet::conventions : lang::sheet::mobility,
                             conventions());
            case Kind::centres:
                if (!made_.centres) made_.centres.emplace(context_);
                return as_table(under(lang::sheet::instant_centres, made_.centres->lines(measure_),
                                      one_piece(solution_.mechanism.units.length.symbol)));
            case Kind::steps: {
                const Topic section = solution_.protocol.statements[part.which.front()].section;
                return under(steps_heading(section), steps(part.which));
            }
            case Kind::reactions: return table_under(lang::sheet::forces, reaction_lines(context_, measure_));
            case Kind::bars: return table_under(lang::sheet::bars, bar_lines(context_, measure_));
            case Kind::lever: return under(lang::sheet::lever, std::vector<Block>{joukowsky_block(context_, measure_)});
            case Kind::equations: return equations(part.which);
            case Kind::answers: return answers();
            case Kind::unsolved: return under(lang::sheet::unsolved, unsolved());
            case Kind::remarks: return under(lang::sheet::remarks, remarks(on_figures));
            case Kind::results: break;
        }
        KG_ASSERT(false, "a part has words of its own");
    }

private:
    Passage under(Key title, std::vector<SharedBlock> rows, const RichText& note = {}) const {
        const std::string words = word(title, context_.language);
        return {heading_block(context_, measure_, words, note), continued(words, note), {}, std::move(rows)};
    }
    Passage under(Key title, std::vector<Block> rows) const {
        Passage passage = under(title, std::vector<SharedBlock>{});
        passage.take_rows(std::move(rows));
        return passage;
    }
    /// A list of short lines: it has no head.
    static Passage as_table(Passage passage) {
        passage.is_table = true;
        return passage;
    }
    /// The first line is the head, which is repeated in the next column.
    Passage table_under(Key title, std::vector<Block> lines) const {
        Passage passage = under(title, std::vector<SharedBlock>{});
        passage.take_table(std::move(lines));
        return passage;
    }
    /// The heading of a continued passage, with the position of its figures.
    SharedBlock continued(const std::string& words, const RichText& note = {}) const {
        return {measure_, heading_height,
                [&context = context_, &stand = figures_stand_, measure = measure_, words, note] {
                    RichText all = note;
                    if (!stand.empty()) append(all, one_piece((note.empty() ? "" : "  ") + stand));
                    return heading_block(context, measure,
                                         words + ", " + word(lang::sheet::continued, context.language), all)
                        .marks;
                }};
    }
    Block paragraph(const RichText& text) const { return paragraph_block(context_, measure_, text); }

    std::vector<SharedBlock> steps(const std::vector<std::size_t>& statements) const {
        std::vector<SharedBlock> rows;
        for (const std::size_t i : statements) {
            const Statement& statement = solution_.protocol.statements[i];
            auto known = made_.said.find(i);
            if (known == made_.said.end())
                known = made_.said.emplace(i, Said{Paragraph(context_, said(i), indent, std::to_string(steps_.at(i)))})
                            .first;
            std::vector<SharedBlock> equations;
            if (statement.equation && !equations_apart_)
                equations.push_back(equation(known->second, *statement.equation, measure_ - indent));
            const LoadCase loads(solution_, part_of(solution_, StatementIndex(i)));
            for (const FreeBody* body : solved_by(loads, StatementIndex(i)))
                if (Block block = force_equation_block(context_, loads, *body, true, measure_ - indent);
                    block.width > 0)
                    equations.emplace_back(std::move(block));
            const Paragraph& sentence = known->second.sentence;
            double height = sentence.height(measure_);
            for (const SharedBlock& equation : equations) height += equation.height() + under_equation;
            // A paragraph that would fill a page may be divided, before its equations and between its lines.
            constexpr double too_high = 90;
            if (height > too_high) {
                for (const Paragraph::Part& part : sentence.parts(measure_, too_high))
                    rows.emplace_back(measure_, part.height, [&sentence, measure = measure_, part, i] {
                        return step(sentence.set(measure, part), {}, StatementIndex(i));
                    });
                for (const SharedBlock& equation : equations)
                    rows.emplace_back(measure_, equation.height() + under_equation,
                                      [equation, i] { return step({}, {equation}, StatementIndex(i)); });
                continue;
            }
            rows.emplace_back(measure_, height, [&sentence, measure = measure_, equations = std::move(equations), i] {
                return step(sentence.set(measure), equations, StatementIndex(i));
            });
        }
        return rows;
    }
    /// A sentence with its equations below.
    static std::vector<Mark> step(Block sentence, const std::vector<SharedBlock>& equations, StatementIndex statement) {
        for (const SharedBlock& equation : equations) {
            set(sentence.marks, equation.set(), {indent, sentence.height + 0.5});
            sentence.height += equation.height() + under_equation;
        }
        belong(sentence.marks, 0, statement);
        return std::move(sentence.marks);
    }

    /// Cached for all widths that hold it in one row.
    SharedBlock equation(Said& said, const Equation& equation, double most) const {
        if (!said.equation) said.equation = equation_block(context_, equation, std::numeric_limits<double>::infinity());
        return said.equation->width() <= most ? *said.equation : SharedBlock(equation_block(context_, equation, most));
    }

    /// A sentence, followed by the other subjects that it applies to.
    RichText said(std::size_t statement) const {
        const auto& statements = solution_.protocol.statements;
        const Message& own = statements[statement].message;
        std::vector<const Message*> messages;
        if (const auto others = likewise_.find(statement); others != likewise_.end())
            for (const std::size_t i : others->second) messages.push_back(&statements[i].message);
        if (!messages.empty() && may_be_told_together(own, *messages.front())) {
            messages.insert(messages.begin(), &own);
            return say(told_together(messages), context_.language);
        }
        RichText text = say(own, context_.language, [&](const LineReason& reason) {
            std::string number;
            for (const LineNumbers& each : lines_)
                if (number.empty()) number = each.before(StatementIndex(statement), reason);
            return number;
        });
        if (messages.empty()) return text;
        append(text, one_piece(" "));
        append(text, say_likewise(messages, context_.language));
        return text;
    }

    Passage answers() const {
        return table_under(lang::sheet::answers,
                           answer_lines(context_, answers_of(context_, {}, with_centres_), measure_));
    }

    /// A section of the equations with its heading.
    Passage equations(const std::vector<std::size_t>& which) const {
        const std::size_t first = which.front(), end = which.back();
        const std::string& words = equations_[first].words;
        Passage passage{heading_block(context_, measure_, words), continued(words), {}};
        passage.take_rows(equation_blocks(context_,
                                          std::span<const EquationItem>(equations_).subspan(first + 1, end - first - 1),
                                          measure_, made_.natural));
        return passage;
    }

    std::vector<Block> unsolved() const {
        std::vector<Block> rows;
        for (const Unsolved& each : solution_.unsolved) {
            RichText text = say(each.what, context_.language);
            append(text, word(lang::notation::colon, context_.language));
            append(text, say(each.why, context_.language));
            rows.push_back(paragraph(text));
        }
        return rows;
    }
    std::vector<Block> remarks(const std::map<std::string, RichText>& on_figures) const {
        std::vector<Block> rows;
        for (const auto& [figure, text] : on_figures) rows.push_back(paragraph(text));
        for (const Message& each : solution_.remarks) rows.push_back(paragraph(say(each, context_.language)));
        if (solution_.contacts)
            for (const Words& each : solution_.contacts->remarks)
                rows.push_back(paragraph(formula(in(each, context_.language))));
        return rows;
    }

    /// Paragraphs that are not divided between columns.
    std::vector<SharedBlock> conventions() const {
        std::vector<Paragraph>& all = made_.conventions;
        if (all.empty()) {
            if (!solution_.instantaneous_motion) all.emplace_back(context_, mobility_words());
            all.emplace_back(context_, axes_words());
            const Mechanism& mechanism = solution_.mechanism;
            if (solution_.protocol.polygons.empty() && mechanism.drivers.empty() && !mechanism.motion)
                all.emplace_back(context_,
                                 one_piece(word(wanted_.shown().has_centres() ? lang::sheet::nothing_driven
                                                                              : lang::sheet::nothing_driven_or_found,
                                                context_.language)));
        }
        double height = 0;
        for (const Paragraph& each : all) height += each.height(measure_);
        std::vector<SharedBlock> rows;
        rows.emplace_back(measure_, height, [&all, measure = measure_] {
            std::vector<Mark> marks;
            double y = 0;
            for (const Paragraph& each : all) {
                Block paragraph = each.set(measure);
                const double own = paragraph.height;
                set(marks, std::move(paragraph), {0, y});
                y += own;
            }
            return marks;
        });
        return rows;
    }
    RichText mobility_words() const {
        const Mobility& m = solution_.mobility;
        const auto n = [](int value) { return std::to_string(value); };
        RichText text;
        const auto italic = [&](const char* letter, const char* sub = "") {
            Piece piece = one_piece(letter, Face::italic).front();
            piece.sub = sub;
            piece.sub_face = Face::regular;
            text.push_back(piece);
        };
        italic("n");
        append(text, one_piece(" = 3("));
        italic("m");
        append(text, one_piece(" − 1) − 2"));
        italic("c", "1");
        append(text, one_piece(" − "));
        italic("c", "2");
        if (m.welds > 0) {
            append(text, one_piece(" − 3"));
            italic("w");
        }
        const auto signed_number = [&](int value) { return (value < 0 ? "−" : "") + n(std::abs(value)); };
        append(text, one_piece(" = 3·" + n(m.bodies - 1) + " − 2·" + n(m.class_1) + " − " + n(m.class_2) +
                               (m.welds > 0 ? " − 3·" + n(m.welds) : "") + " = " + signed_number(m.gruebler) + " " +
                               word(lang::sheet::by_gruebler, context_.language)));
        append(text,
               one_piece(word(lang::notation::semicolon, context_.language) +
                         (m.effective != m.gruebler
                              ? n(m.effective) + " " +
                                    word(m.effective == 1 ? lang::sheet::effective_one : lang::sheet::effective,
                                         context_.language)
                              : word(lang::sheet::at_this_pose, context_.language)) +
                         word(lang::notation::colon, context_.language) + verdict_words(m, context_.language) + "."));
        return text;
    }
    RichText axes_words() const {
        const Key axes = has_forces(solution_) && !has_motion(solution_) ? lang::sheet::axes_forces : lang::sheet::axes;
        return render::say({axes, {}}, context_.language);
    }

    static constexpr double indent = 6;            // of a sentence, for its number
    static constexpr double under_equation = 2.5;  // space above included

    const DrawingContext& context_;
    const Solution& solution_;
    double measure_;
    bool equations_apart_;
    const std::map<std::size_t, int>& steps_;
    const Likewise& likewise_;
    bool with_centres_;
    const std::vector<EquationItem>& equations_;
    const std::vector<LineNumbers>& lines_;
    MadeOnce& made_;
    const WantedFigures& wanted_;
    const std::string& figures_stand_;  // filled in after planning
};

/// Whether statements of this kind can be merged: the number or the body named is enough to distinguish them.
bool may_be_merged(const Message& message) {
    using namespace lang::sentences;
    const auto is_one_of = [&](std::initializer_list<Key> some) {
        return std::find(some.begin(), some.end(), message.sentence) != some.end();
    };
    if (is_one_of({two_force_body, two_force_bar, two_force_guide, zero_forces})) return true;
    if (message.worked_arithmetic.empty()) return false;
    if (is_one_of({omega_from_pair, alpha_from_pair}))
        return message.arguments.size() <= 4;  // otherwise it draws a vector first
    return is_one_of({inertia_force, inertia_couple, second_way});
}

/// Whether a polygon is closed by a force that the sentence of the body finds, or that follows from such a force.
bool leads_to_polygon(const Solution& solution, const FreeBody& body) {
    if (body.statement == none || body.in_parts) return false;
    return std::any_of(solution.free_bodies.begin(), solution.free_bodies.end(), [&](const FreeBody& other) {
        const bool reads = body.statement < other.statement &&
                           std::any_of(other.forces.begin(), other.forces.end(), [&](const AppliedForce& applied) {
                               return applied.force_statement == body.statement;
                           });
        return reads && (has_force_polygon(solution, other) || leads_to_polygon(solution, other));
    });
}

/// Whether it stands where the sentences before it do, whose forces are known by then: it closes no polygon.
bool tells_of_one_equation(Key sentence) {
    using namespace lang::sentences;
    return sentence == moments_give || sentence == components_give || sentence == translation_gives ||
           sentence == virtual_work_gives;
}

/// Whether two polygons show the same relative motion of a point for the same observer.
bool of_one_motion(const Polygon& a, const Polygon& b) {
    return a.point == b.point && a.observer == b.observer && a.translating == b.translating;
}

}  // namespace

Bands::Bands(const DrawingContext& context, const WantedFigures& wanted, SolutionDetail detail)
    : context_(context), solution_(context.solution), wanted_(wanted), detail_(detail) {
    for (const Wanted& each : wanted_.list)
        if (each.id.kind == FigureKind::velocity_polygon || each.id.kind == FigureKind::acceleration_polygon)
            lines_.emplace_back(wanted_.shown().scene(each.id.of));
    const bool motion = has_motion(solution_) || !has_forces(solution_);
    if (motion) collect_motion();
    if (detail_ == SolutionDetail::full) collect_apart();
    if (solution_.equations) collect_equations();
    if (solution_.truss && solution_.free_bodies.empty())
        collect_truss();
    else if (has_forces(solution_))
        collect_forces();
    if (solution_.displacements) collect_virtual_work();
    Band& given = list.front();
    const bool tells_bodies = !solution_.truss || !solution_.free_bodies.empty();  // bars have their own table
    if (detail_ == SolutionDetail::full) given.parts.insert(given.parts.begin(), {Kind::mobility});
    if (detail_ == SolutionDetail::full && tells_bodies) given.parts.insert(given.parts.begin(), {Kind::bodies});
    number_steps();
    if (detail_ == SolutionDetail::full)
        deal_out_results();
    else
        add("answers", {}).parts.push_back({Kind::answers});
    const bool contact_remarks = solution_.contacts && !solution_.contacts->remarks.empty();
    if (!solution_.unsolved.empty() || !solution_.remarks.empty() || contact_remarks) add_remarks();
}

void Bands::add_remarks() {
    Band& last = add("remarks", {});
    if (!solution_.unsolved.empty()) last.parts.push_back({Kind::unsolved});
    last.parts.push_back({Kind::remarks});
}

bool Bands::remark(const std::string& figure, const RichText& text) {
    if (!remarks_.emplace(figure, text).second) return false;
    if (list.back().parts.empty() || list.back().parts.back().kind != Kind::remarks) add_remarks();
    return true;
}

Band& Bands::add(const std::string& question, const std::vector<FigureId>& figures) {
    Band& band = list.emplace_back();
    band.question = question;
    for (const FigureId id : figures)
        if (const auto index = wanted_.named(id)) band.figures.push_back(*index);
    return band;
}
/// A band whose question has the name of its first figure.
Band& Bands::add(const std::vector<FigureId>& figures) {
    return add(render::name_of(solution_, figures.front()), figures);
}

/// The earlier statement that says the same of another subject. None if this one reads a vector that was drawn in
/// between.
std::optional<std::size_t> Bands::same_before(const Band& band, const Statement& added) const {
    const bool merges = may_be_merged(added.message), is_listed = may_be_told_together(added.message, added.message);
    if (!merges && !is_listed) return std::nullopt;
    const auto says_the_same = [&](const Statement& other) {
        if (is_listed) return !other.equation && may_be_told_together(other.message, added.message);
        return other.message.sentence == added.message.sentence;
    };
    const auto reads_of = [&](std::size_t drawn_by) {
        const std::vector<DrawnVector>& vectors = solution_.protocol.vectors;
        return std::any_of(vectors.begin(), vectors.end(), [&](const DrawnVector& vector) {
            return vector.statement == StatementIndex(drawn_by) &&
                   std::any_of(added.message.arguments.begin(), added.message.arguments.end(),
                               [&](const Argument& argument) {
                                   const auto* symbol = std::get_if<Symbol>(&argument);
                                   return symbol != nullptr && *symbol == vector.symbol;
                               });
        });
    };
    std::vector<std::size_t> told;
    for (const Band::Part& part : band.parts)
        if (part.kind == Kind::steps) told.insert(told.end(), part.which.begin(), part.which.end());
    for (; !told.empty(); told.pop_back()) {
        if (says_the_same(solution_.protocol.statements[told.back()])) return told.back();
        if (reads_of(told.back())) return std::nullopt;
    }
    return std::nullopt;
}

void Bands::add_step(Band& band, std::size_t statement) {
    const Statement& added = solution_.protocol.statements[statement];
    if (told_by_list(added.message.sentence)) return;
    if (!added.equation) {
        if (detail_ == SolutionDetail::brief && is_incidental(solution_.protocol.statements, statement)) return;
        // Merges statements while the merged text fits into a column.
        constexpr std::size_t most_likewise = 16, most_listed = 60;
        const std::size_t most = may_be_told_together(added.message, added.message) ? most_listed : most_likewise;
        if (const auto other = same_before(band, added); other && likewise_[*other].size() < most) {
            likewise_[*other].push_back(statement);
            return;
        }
    }
    if (band.parts.empty() || band.parts.back().kind != Kind::steps) band.parts.push_back({Kind::steps});
    band.parts.back().which.push_back(statement);
}

void Bands::collect_motion() {
    const Protocol& protocol = solution_.protocol;
    // Up to four bodies the order of the centres is seen without a diagram.
    constexpr std::size_t fewest_with_circle = 5;
    std::vector<FigureId> figures{wanted_.list.front().id};
    if (solution_.mechanism.bodies.size() >= fewest_with_circle) figures.push_back({FigureKind::circle_diagram});
    Band& given = add("given", figures);
    if (wanted_.shown().has_centres()) given.parts.push_back({Kind::centres});
    // Each polygon has a band; the two polygons of a relative motion share one.
    std::map<int, std::size_t> band_of;  // by polygon
    std::map<Topic, std::size_t> last_of{{Topic::centres, 0}};
    for (const auto kind : {Polygon::Kind::motion, Polygon::Kind::relative_motion})
        for (std::size_t p = 0; p < protocol.polygons.size(); ++p) {
            const Polygon& polygon = protocol.polygons[p];
            if (polygon.plane == Plane::force || polygon.kind != kind) continue;
            const bool relative = kind == Polygon::Kind::relative_motion;
            const bool again = relative && p > 0 && of_one_motion(protocol.polygons[p - 1], polygon) &&
                               band_of.contains(static_cast<int>(p) - 1);
            // The figure of an instantaneous motion shows the results of both polygons.
            if (again || solution_.instantaneous_motion)
                list.back().figures.push_back(*wanted_.named(motion_polygon(solution_, static_cast<int>(p))));
            else
                add({motion_polygon(solution_, static_cast<int>(p))});
            band_of[static_cast<int>(p)] = list.size() - 1;
            const Topic topic = relative                               ? Topic::relative_motion
                                : polygon.plane == Plane::acceleration ? Topic::acceleration
                                                                       : Topic::velocity;
            last_of.emplace(topic, list.size() - 1);
        }
    std::map<StatementIndex, int> polygon_of;
    for (const DrawnVector& vector : protocol.vectors) polygon_of.emplace(vector.statement, vector.polygon);
    for (const DrawnLine& drawn : protocol.lines)
        if (drawn.polygon >= 0) polygon_of.emplace(drawn.statement, drawn.polygon);
    std::map<Topic, std::vector<std::size_t>> after;
    std::map<Topic, std::size_t> last_after;  // band
    for (std::size_t i = 0; i < protocol.statements.size(); ++i) {
        const Topic topic = protocol.statements[i].section;
        if (topic == Topic::forces || topic == Topic::curvature) continue;
        const auto polygon = polygon_of.find(StatementIndex(i));
        const auto band = polygon == polygon_of.end() ? band_of.end() : band_of.find(polygon->second);
        if (const auto motion = follows(protocol.statements[i].message.sentence)) {
            after[*motion].push_back(i);
            continue;
        }
        // A statement that draws nothing stands with what was drawn before it.
        if (band != band_of.end() && topic != Topic::centres) last_of[topic] = band->second;
        add_step(list[last_of[topic]], i);
        last_after[topic] = last_of[topic];
    }
    for (const auto& [motion, statements] : after)
        for (const std::size_t i : statements) add_step(list[last_after[motion]], i);
    collect_curvature();
}

/// One band for each body whose pole moves. Statements about other bodies are added to the band before or after.
void Bands::collect_curvature() {
    if (solution_.curvature.empty()) return;
    std::map<BodyIndex, std::size_t> band_of;
    std::size_t first = list.size();
    for (std::size_t i = 0; i < solution_.curvature.size(); ++i)
        if (const FigureId id{FigureKind::curvature, static_cast<int>(i)}; wanted_.named(id)) {
            add({id});
            band_of[solution_.curvature[i].body] = list.size() - 1;
        }
    if (band_of.empty()) add("curvature", {});
    first = std::min(first, list.size() - 1);
    first_of_curvature_ = first;
    end_of_curvature_ = list.size();
    const std::vector<Statement>& statements = solution_.protocol.statements;
    for (std::size_t i = 0; i < statements.size(); ++i) {
        if (statements[i].section != Topic::curvature) continue;
        const auto home = band_of.find(statements[i].bodies.front());
        add_step(list[home == band_of.end() ? first : home->second], i);
    }
}

void Bands::collect_forces() {
    // In brief the mechanism is drawn once. Free bodies show their own lines of action.
    const bool has_strings = std::any_of(solution_.taken_together.begin(), solution_.taken_together.end(),
                                         [](const TakenTogether& together) { return together.funicular.has_value(); });
    const bool drawn_already = detail_ == SolutionDetail::brief && !list.empty() && !solution_.free_bodies.empty() &&
                               !has_strings && !has_meets(solution_, true);
    // Statements about lines of action then stand with the first body.
    const std::size_t at_lines = list.size();
    if (!drawn_already) add({{FigureKind::lines_of_action}});
    const std::vector<std::size_t> parts = collect_superposition();
    collect_bodies();
    if (solution_.truss) add({{FigureKind::truss}, {FigureKind::force_plan}}).parts.push_back({Kind::bars});
    std::size_t home = at_lines;
    for (std::size_t i = 0; i < solution_.protocol.statements.size(); ++i) {
        if (solution_.protocol.statements[i].section != Topic::forces) continue;
        if (const int part = part_of(solution_, StatementIndex(i)); part != all_loads) {
            add_step(list[parts[at_index(part)]], i);
            continue;
        }
        if (solution_.superposition && solution_.superposition->statement == StatementIndex(i)) {
            add_step(list[home_of_sums(parts)], i);
            continue;
        }
        if (!tells_of_one_equation(solution_.protocol.statements[i].message.sentence))
            home = home_of_forces(StatementIndex(i), at_lines);
        add_step(list[home], i);
    }
    if (detail_ == SolutionDetail::full) list[at_lines].parts.push_back({Kind::reactions});
    for (const int p : detail_ == SolutionDetail::full ? closed_polygons(solution_) : std::vector<int>{})
        add({{FigureKind::closed_polygon, p}});
    if (const FigureId lever{FigureKind::lever}; wanted_.named(lever)) add({lever}).parts.push_back({Kind::lever});
}

/// The band of a statement on forces: the polygon that it closes or adds to; otherwise the lines of action, where the
/// resultant of bodies taken together stands, too.
std::size_t Bands::home_of_forces(StatementIndex statement, std::size_t at_lines) const {
    const auto adds = [&](const FreeBody& body) {
        return std::any_of(body.sums.begin(), body.sums.end(),
                           [&](const AppliedForce& sum) { return sum.force_statement == statement; }) ||
               std::any_of(body.arms.begin(), body.arms.end(),
                           [&](const FreeBody::Arm& arm) { return arm.is_shift && arm.statement == statement; });
    };
    const auto band_with = [&](FigureKind kind, std::ptrdiff_t of) {
        for (std::size_t b = at_lines; b < list.size(); ++b)
            if (draws(list[b], {kind, static_cast<int>(of)})) return b;
        return at_lines;
    };
    const std::vector<FreeBody>& bodies = solution_.free_bodies;
    if (const auto closed = closed_by(solution_, statement); !closed.empty())
        return band_with(FigureKind::free_body, closed.front() - bodies.data());
    for (const TakenTogether& together : solution_.taken_together)
        if (together.statement == statement)
            return band_with(FigureKind::forces_together, &together - solution_.taken_together.data());
    for (const FreeBody& body : bodies)
        if (adds(body)) return band_with(FigureKind::free_body, &body - bodies.data());
    return at_lines;
}

/// The band of the statement that adds the parts: that of the sums, or of the first polygon that joins parts.
std::size_t Bands::home_of_sums(const std::vector<std::size_t>& parts) const {
    for (std::size_t b = parts.front(); wanted_.joins_parts() && b < list.size(); ++b)
        for (const FreeBody& body : solution_.free_bodies)
            if (const auto joined = wanted_.joined_parts_of(body); joined && draws(list[b], *joined)) return b;
    return parts.back();
}

/// Bands for each load acting alone, then for their sum. Returns their indices. Where the parts are joined in one
/// polygon a body, a load alone has its lines of action only.
std::vector<std::size_t> Bands::collect_superposition() {
    std::vector<std::size_t> bands;
    if (!solution_.superposition) return bands;
    for (int part = 0; part < parts_of(solution_); ++part) {
        const LoadCase loads(solution_, part);
        bands.push_back(list.size());
        std::vector<FigureId> figures{{FigureKind::lines_of_action, -1, part}};
        if (!wanted_.joins_parts()) {
            for (std::size_t i = 0; i < loads.bodies().size(); ++i)
                figures.push_back({FigureKind::free_body, static_cast<int>(i), part});
            figures.push_back({FigureKind::forces, -1, part});
        }
        add("load-" + loads.load(), figures);
    }
    if (wanted_.joins_parts()) return bands;
    bands.push_back(list.size());
    add({{FigureKind::partial_sums}});
    return bands;
}

/// One band for the truss, its force plan and their text; then one for the bars.
void Bands::collect_truss() {
    std::vector<FigureId> figures{{FigureKind::truss}};
    for (std::size_t i = 0; i < solution_.taken_together.size(); ++i)
        figures.push_back({FigureKind::forces_together, static_cast<int>(i)});
    figures.push_back({FigureKind::force_plan});
    add(figures);
    const std::size_t home = list.size() - 1;
    for (std::size_t i = 0; i < solution_.protocol.statements.size(); ++i)
        if (solution_.protocol.statements[i].section == Topic::forces) add_step(list[home], i);
    list[home].parts.push_back({Kind::bars});
}

/// The figure of the loops with the sections of their equations.
void Bands::collect_equations() {
    add("equations", {{FigureKind::loops}});
    add_items(equation_items(solution_, context_.language), "equations-");
}

/// Adds sections to the last band. A section that stands apart begins a new band unless it is the first item.
void Bands::add_items(std::vector<EquationItem> items, const std::string& pages) {
    int page = 1;
    const std::size_t before = equations_.size();
    for (EquationItem& item : items) {
        const std::size_t i = equations_.size();
        if (item.is_apart && i > before) add(pages + std::to_string(++page), {});
        std::vector<Band::Part>& parts = list.back().parts;
        if (item.kind == EquationItem::Kind::heading) parts.push_back({Kind::equations, {i, i}});
        parts.back().which.back() = i + 1;
        equations_.push_back(std::move(item));
    }
}

/// One band for each relative motion, with its moving axes.
void Bands::collect_apart() {
    for (std::size_t i = 0; i < solution_.relative_motion.size(); ++i) {
        if (!has_moving_axes(solution_.relative_motion[i])) continue;
        const FigureId axes{FigureKind::moving_axes, static_cast<int>(i)};
        add({axes});
        add_items(apart_items(solution_, i, context_.language), render::name_of(solution_, axes) + "-");
    }
}

/// Displacements and virtual work.
void Bands::collect_virtual_work() {
    std::vector<FigureId> figures;
    for (std::size_t i = 0; i < solution_.displacements->freedoms.size(); ++i)
        figures.push_back({FigureKind::displacements, static_cast<int>(i)});
    add("virtual-work", figures);
    add_items(virtual_work_items(solution_, context_.language), "virtual-work-");
}

/// In the order of solving: free body and polygon, and bodies taken together where they are solved. Bodies with two
/// forces share a band.
void Bands::collect_bodies() {
    constexpr std::size_t most_in_a_row = 4;
    struct Cut {
        FigureId free;
        const FreeBody* body;  ///< none: of bodies taken together
        int solved;
    };
    std::vector<Cut> order;
    for (const TakenTogether& each : solution_.taken_together)
        order.push_back({{FigureKind::forces_together, static_cast<int>(&each - solution_.taken_together.data())},
                         nullptr,
                         each.statement.number()});
    for (const FreeBody& body : solution_.free_bodies) {
        const bool apart = body.statement == none || body.in_parts;
        order.push_back({{FigureKind::free_body, static_cast<int>(&body - solution_.free_bodies.data())},
                         &body,
                         apart ? 1 << 30 : body.statement.number()});
    }
    std::stable_sort(order.begin(), order.end(), [](const Cut& a, const Cut& b) { return a.solved < b.solved; });
    // Bars share one band, after their forces are known. A bar whose sentence finds a force that a polygon needs stands
    // before that polygon.
    if (detail_ == SolutionDetail::brief)
        std::stable_partition(order.begin(), order.end(), [&](const Cut& cut) {
            return cut.body == nullptr || has_force_polygon(solution_, *cut.body) ||
                   leads_to_polygon(solution_, *cut.body);
        });
    bool of_two_forces = false;
    for (const auto& [free, body, solved] : order) {
        if (body == nullptr) {
            add({free});
            of_two_forces = false;
            continue;
        }
        const auto joined = wanted_.joined_parts_of(*body);
        const bool has_polygon = joined || has_force_polygon(solution_, *body);
        if (!has_polygon && of_two_forces && list.back().figures.size() < most_in_a_row)
            list.back().figures.push_back(*wanted_.named(free));
        else
            add({free, joined.value_or(FigureId{FigureKind::forces_of_body, free.of})});
        of_two_forces = !has_polygon;
    }
}

void Bands::number_steps() {
    for (const Band& band : list)
        for (const Band::Part& part : band.parts)
            if (part.kind == Kind::steps)
                for (const std::size_t statement : part.which)
                    step_.emplace(statement, static_cast<int>(step_.size()) + 1);
}

std::vector<ResultRow> Bands::results_on(const std::vector<Figure>& drawn) const {
    std::vector<ResultRow> rows = result_rows(context_, drawn);
    for (ResultRow& row : force_rows(context_, drawn, detail_ == SolutionDetail::full, bodies_with_polygons()))
        rows.push_back(std::move(row));
    return rows;
}

std::vector<const FreeBody*> Bands::bodies_with_polygons() const {
    std::vector<const FreeBody*> bodies;
    for (const Band& band : list)
        for (const std::size_t figure : band.figures)
            if (const FigureId& id = wanted_.list[figure].id; id.kind == FigureKind::free_body && id.part == all_loads)
                if (const FreeBody& body = solution_.free_bodies[static_cast<std::size_t>(id.of)];
                    has_force_polygon(solution_, body))
                    bodies.push_back(&body);
    return bodies;
}

bool Bands::draws(const Band& band, FigureId id) const {
    return std::any_of(band.figures.begin(), band.figures.end(),
                       [&](std::size_t figure) { return wanted_.list[figure].id == id; });
}
bool Bands::draws_curvature(const Band& band, BodyIndex body) const {
    for (std::size_t i = 0; i < solution_.curvature.size(); ++i)
        if (solution_.curvature[i].body == body && draws(band, {FigureKind::curvature, static_cast<int>(i)}))
            return true;
    return false;
}

/// Each row of results goes to the band whose figure it is measured on; if no figure shows it, to the last band of its
/// kind.
void Bands::deal_out_results() {
    const std::vector<ResultRow>& rows = results_ = results_on({});
    const auto home_of = [&](const ResultRow& row) {
        std::size_t home = list.size() - 1;
        for (std::size_t b = list.size(); b-- > 0;) {
            const Band& band = list[b];
            for (const Polygon& polygon : solution_.protocol.polygons) {
                const auto index = static_cast<int>(&polygon - solution_.protocol.polygons.data());
                if (polygon.plane == Plane::force || !draws(band, motion_polygon(solution_, index))) continue;
                const bool acceleration = polygon.plane == Plane::acceleration;
                if (row.group.polygon >= 0
                        ? row.group.polygon == index
                        : polygon.kind == Polygon::Kind::motion &&
                              row.group.section == (acceleration ? Topic::acceleration : Topic::velocity))
                    return b;
            }
            if (row.group.section == Topic::curvature && b >= first_of_curvature_ && b < end_of_curvature_) {
                if (home == list.size() - 1 || draws_curvature(band, row.quantity.body)) home = b;
                continue;
            }
            if (row.group.section != Topic::forces) continue;
            for (const FreeBody& body : solution_.free_bodies)
                if (draws(band, {FigureKind::free_body, static_cast<int>(&body - solution_.free_bodies.data())}) &&
                    has_force_polygon(solution_, body))
                    for (const AppliedForce& applied : body.forces)
                        if (are_one_action(quantity_of(body, applied), row.quantity)) home = b;
        }
        return home;
    };
    std::map<std::size_t, std::vector<std::size_t>> rows_of;  // by band
    for (std::size_t i = 0; i < rows.size(); ++i) rows_of[home_of(rows[i])].push_back(i);
    for (auto& [band, which] : rows_of) list[band].parts.push_back({Kind::results, std::move(which)});
}

Block Bands::equations(const Band& band, double most) const {
    constexpr std::size_t most_equations = 2;
    constexpr double between = 4;
    Block all;
    std::size_t count = 0;
    for (const Band::Part& part : band.parts)
        for (const std::size_t i : part.kind == Kind::steps ? part.which : std::vector<std::size_t>{}) {
            const Statement& statement = solution_.protocol.statements[i];
            if (!statement.equation) continue;
            if (++count > most_equations) return {};
            Block block = equation_block(context_, *statement.equation, most);
            belong(block.marks, 0, StatementIndex(i));
            if (all.height > 0) all.height += between;
            set(all.marks, block, {0, all.height});
            all.width = std::max(all.width, block.width);
            all.height += block.height;
        }
    return all;
}

void Bands::tell_figures(const std::string& question, int first, int last, std::size_t page) {
    std::string& words = figures_stand_[question];
    words = word(lang::sheet::figure, context_.language) + " " + std::to_string(first);
    if (last > first) words += "–" + std::to_string(last);
    words += ", " + word(lang::sheet::on_sheet, context_.language) + " " + std::to_string(page + 1);
}

/// That of the first band with this part; a continuation refers to it.
const std::string& Bands::question_of(const Band::Part& part) const {
    const auto is_said = [&](const Band& band) {
        return std::any_of(band.parts.begin(), band.parts.end(),
                           [&](const Band::Part& own) { return own.kind == part.kind && own.which == part.which; });
    };
    const auto found = std::find_if(list.begin(), list.end(), is_said);
    KG_ASSERT(found != list.end(), "a part is some band's");
    return found->question;
}

Passage Bands::text(const Band::Part& part, double measure, bool equations_apart,
                    const std::vector<ResultRow>& results) const {
    if (part.kind == Kind::results) return table(part.which, results, measure);
    const BandText writer(context_, measure, equations_apart, step_, likewise_, wanted_.shown().has_centres(),
                          equations_, lines_, made_, wanted_, figures_stand_[question_of(part)]);
    return writer.passage_of(part, remarks_);
}

/// The width of the columns does not depend on the measure.
Passage Bands::table(const std::vector<std::size_t>& which, const std::vector<ResultRow>& results,
                     double measure) const {
    const auto made = [&] {
        std::vector<ResultRow> rows;
        for (const std::size_t i : which) rows.push_back(results[i]);
        return ResultsTable(context_, rows);
    };
    Passage passage;
    if (&results != &results_) {
        passage.take_table(made().lines(measure));
        return passage;
    }
    auto known = tables_.find(which.front());
    if (known == tables_.end()) known = tables_.emplace(which.front(), made()).first;
    passage.take_table(known->second.lines(measure));
    return passage;
}

void Passage::take_rows(std::vector<Block> blocks) {
    rows.assign(std::make_move_iterator(blocks.begin()), std::make_move_iterator(blocks.end()));
}
void Passage::take_table(std::vector<Block> lines) {
    take_table(std::vector<SharedBlock>(std::make_move_iterator(lines.begin()), std::make_move_iterator(lines.end())));
}
void Passage::take_table(std::vector<SharedBlock> lines) {
    if (lines.empty()) return;
    is_table = true;
    head = std::move(lines.front());
    rows.assign(std::make_move_iterator(lines.begin() + 1), std::make_move_iterator(lines.end()));
}

std::vector<Passage> own_rows(const std::vector<Passage>& text, const Band& band) {
    std::vector<Passage> own;
    std::size_t before = 0;
    for (const Passage& passage : text) {
        const std::size_t count = passage.rows.size();
        const std::size_t first = std::clamp(band.first_row, before, before + count) - before;
        const std::size_t end = std::clamp(band.end_row, before, before + count) - before;
        before += count;
        if (first >= end) continue;
        const auto rows = passage.rows.begin();
        own.push_back({first > 0 ? passage.heading_again : passage.heading,
                       passage.heading_again,
                       passage.head,
                       {rows + static_cast<std::ptrdiff_t>(first), rows + static_cast<std::ptrdiff_t>(end)},
                       passage.is_table});
    }
    return own;
}

}  // namespace kinegraph::render
