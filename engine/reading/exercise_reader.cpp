#include "engine/reading/exercise_reader.hpp"

#include <algorithm>
#include <array>

#include "engine/mechanism/problem.hpp"
#include "engine/mechanism/variation.hpp"
#include "engine/results/operands.hpp"
#include "engine/results/result_expression.hpp"
#include "engine/results/result_names.hpp"
#include "engine/sentences/result_catalogue.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/exercises.hpp"
#include "lang/keys/expressions.hpp"

namespace kinegraph {
namespace {

constexpr std::string_view crank_phrase = "crank turns fully";
constexpr std::array polygon_phrases{
    std::pair{std::string_view("velocity polygon readable"), Condition::Polygon::velocity},
    std::pair{std::string_view("acceleration polygon readable"), Condition::Polygon::acceleration},
    std::pair{std::string_view("force polygon readable"), Condition::Polygon::force},
};

constexpr std::array variation_rows{
    FormRow("from", "…", values::number_or_text).needed(lang::exercises::the_first_value_or_give_choose),
    FormRow("to", "…", values::number_or_text).needed(lang::exercises::the_last_value),
    FormRow("step", "…", values::number_or_text).needed(lang::exercises::from_one_value_to_the_next),
    FormRow("choose", "[…]", values::list(values::number_or_text, 1), "The values.")
        .called(lang::exercises::an_array_of_values)};
constexpr std::array variation_choices{
    Form::Choice{"From a first value to a last one, step by step.", {"from", "to", "step"}},
    Form::Choice{"One of these.", {"choose"}}};
constexpr Form variation_form{lang::exercises::what_a_parameter_may, variation_rows, {}, {}, variation_choices};
constexpr std::array variation_objects{values::object(variation_form)};

std::string_view trimmed(std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    return text;
}

struct Sign {
    std::string_view spelt;
    Condition::Relation relation;
};
/// Longer ones first.
constexpr std::array signs{Sign{">=", Condition::Relation::at_least}, Sign{"<=", Condition::Relation::at_most},
                           Sign{"≥", Condition::Relation::at_least},  Sign{"≤", Condition::Relation::at_most},
                           Sign{">", Condition::Relation::greater},   Sign{"<", Condition::Relation::less},
                           Sign{"=", Condition::Relation::equal}};
/// Comparison signs of other languages, which are rejected.
constexpr std::array<std::string_view, 7> foreign_signs{"!=", "≠", "<>", "==", "=>", "=<", "=!"};

/// The first sign of a text, and where.
std::optional<std::pair<Sign, std::size_t>> sign_in(std::string_view text, std::size_t from = 0) {
    for (std::size_t at = from; at < text.size(); ++at)
        for (const Sign& sign : signs)
            if (text.substr(at).starts_with(sign.spelt)) return std::pair{sign, at};
    return std::nullopt;
}

/// By the sign of left − right.
bool holds_by(Condition::Relation relation, int order) {
    switch (relation) {
        case Condition::Relation::less: return order < 0;
        case Condition::Relation::at_most: return order <= 0;
        case Condition::Relation::equal: return order == 0;
        case Condition::Relation::at_least: return order >= 0;
        case Condition::Relation::greater: return order > 0;
    }
    return false;
}

}  // namespace

constinit const FormValue forms::variation = values::any(variation_objects);

void ExerciseReader::read_exercise(const Members& file, Mechanism& mechanism) {
    for (const std::string_view name : parameter_names_)
        if (const Parameter& each = parameters_.at(name); each.state == Parameter::State::read)
            mechanism.parameters.push_back({std::string(name), in_si(each.value).to_double(), each.value.dimension});
    if (!file["ask"] && !file["vary"] && !file["require"]) return;
    // Names of results are known only if everything that has results was readable.
    knows_results_ = faults_.empty() && !stands_for_joints(mechanism);
    if (knows_results_) results_ = possible_results(mechanism);
    parameter_columns_ = parameter_columns(mechanism);
    // A value that replaces a formula hides the dependencies of the formula.
    knows_uses_ =
        faults_.empty() && std::none_of(parameters_.begin(), parameters_.end(), [](const auto& each) {
            return !each.second.set.empty() && each.second.at.is_string() && is_formula(each.second.at.text());
        });
    Exercise exercise;
    exercise.comes_to = std::move(comes_to_);
    if (const JsonValue ask = file.expected("ask")) read_ask(ask, exercise);
    if (const JsonValue vary = file.expected("vary")) read_vary(vary, exercise);
    file.each("require", [&](JsonValue value) { read_require(value, mechanism, exercise); });
    mechanism.find.curvature = mechanism.find.curvature || (knows_results_ && needs_curvature(exercise));
    mechanism.exercise = std::make_shared<const Exercise>(std::move(exercise));
}

bool ExerciseReader::needs_curvature(const Exercise& exercise) const {
    std::vector<std::string> texts = exercise.expressions;
    for (const AskedResult& each : exercise.ask) texts.push_back(each.name);
    for (const Condition& each : exercise.require)
        for (const Operand* side : {&each.left, &each.right, &each.upper}) texts.push_back(side->result);
    std::vector<Column> known = results_;
    known.insert(known.end(), parameter_columns_.begin(), parameter_columns_.end());
    const std::vector<Column> used = operands_in(texts, known);
    return std::any_of(used.begin(), used.end(),
                       [](const Column& each) { return result_kind(each.quantity).is_of_curvature(); });
}

const Column* ExerciseReader::result_named(std::string_view name) const {
    static const Column transmission = transmission_column();
    if (name == transmission.name) return &transmission;
    for (const std::vector<Column>* columns : {&results_, &expressions_})
        for (const Column& each : *columns)
            if (each.name == name) return &each;
    return nullptr;
}

tl::expected<Column, Words> ExerciseReader::add_expression(std::string_view text, Exercise& exercise) {
    Column column{Column::Kind::named, {}, std::string(named_expression(text).name), QuantityKind::dimensionless};
    if (knows_results_) {
        std::vector<Column> known = results_;
        known.push_back(transmission_column());
        known.insert(known.end(), expressions_.begin(), expressions_.end());
        known.insert(known.end(), parameter_columns_.begin(), parameter_columns_.end());
        const auto read = ResultExpression::read(text, known);
        if (!read) return tl::make_unexpected(read.error());
        column = read->column();
    }
    if (std::find(exercise.expressions.begin(), exercise.expressions.end(), text) == exercise.expressions.end())
        exercise.expressions.emplace_back(text);
    expressions_.push_back(column);
    return column;
}

// ----- ask

void ExerciseReader::read_ask(JsonValue ask, Exercise& exercise) {
    if (ask.size() == 0) fault(ask, {lang::exercises::nothing_is_asked_for_take_ask});
    for (const JsonValue value : ask) {
        if (!expect(value, Kind::string, {lang::exercises::the_name_of_a_result_such})) continue;
        std::string_view name = value.text();
        const bool expresses = result_named(name) == nullptr && is_expression(name);
        if (expresses) name = named_expression(name).name;
        if (std::any_of(exercise.ask.begin(), exercise.ask.end(),
                        [&](const AskedResult& each) { return each.name == name; }))
            fault(value, {lang::exercises::is_asked_for_twice_take, quoted(name)});
        if (expresses) {
            if (auto read = add_expression(value.text(), exercise); !read) fault(value, std::move(read.error()));
        } else if (knows_results_ && result_named(name) == nullptr) {
            std::vector<std::string_view> names{transmission_angle_name};
            for (const Column& each : results_) names.emplace_back(each.name);
            fault(value, {lang::exercises::no_result_is_named_names, quoted(name),
                          did_you_mean(speller_.nearest(name, names))});
        }
        exercise.ask.push_back({std::string(name), value.pointer()});
    }
}

// ----- vary

void ExerciseReader::read_vary(JsonValue vary, Exercise& exercise) {
    if (vary.size() == 0) fault(vary, {lang::exercises::nothing_varies_take_vary_out});
    for (const JsonValue member : vary) read_variation(member, exercise);
}

void ExerciseReader::read_variation(JsonValue member, Exercise& exercise) {
    const auto found = parameters_.find(member.key());
    const Measured* own = nullptr;
    std::optional<Measured> of_the_file;
    if (found == parameters_.end()) {
        fault(member, {lang::exercises::no_parameter_is_named_what_varies, quoted(member.key()),
                       did_you_mean(speller_.nearest(member.key(), parameter_names_))});
    } else if (knows_uses_ && !is_used(member.key())) {
        fault(member,
              {lang::exercises::nothing_hangs_on_copies_that_differ, quoted(member.key()), std::string(member.key())});
    } else if (found->second.at.is_string() && is_formula(found->second.at.text())) {
        fault(member, {lang::exercises::is_a_formula_and_what_varies, quoted(member.key())});
    } else {
        own = own_value(member.key(), found->second, of_the_file);
    }
    const Words wanted(lang::exercises::from_to_step_or_choose);
    if (!expect(member, Kind::object, wanted)) return;
    const Members form = members(member, variation_form);
    Variation variation;
    variation.parameter = member.key();
    variation.where = member.pointer();
    const std::size_t before = faults_.size();
    if (form["choose"]) {
        for (const std::string_view key : {"from", "to", "step"})
            if (form[key]) fault(form[key], {lang::exercises::and_choose_exclude_each_other_take, quoted(key)});
        if (const JsonValue choose = form.expected("choose")) read_choices(choose, own, variation);
    } else {
        read_steps(form, own, variation);
    }
    const auto same = [&](const Variation& each) { return each.parameter == variation.parameter; };
    if (faults_.size() == before && std::none_of(exercise.vary.begin(), exercise.vary.end(), same))
        exercise.vary.push_back(std::move(variation));
    if (!Lattice::size(exercise.vary)) fault(member, {lang::exercises::more_combinations_than_can_be_counted});
}

const Measured* ExerciseReader::own_value(std::string_view name, const Parameter& parameter,
                                          std::optional<Measured>& of_the_file) {
    if (parameter.state != Parameter::State::read) return nullptr;
    if (parameter.set.empty()) return &parameter.value;
    auto read = read_measured(parameter.at.text(), [this](std::string_view other) { return look_up_parameter(other); });
    if (!read) return nullptr;
    of_the_file = *std::move(read);
    const Measured& set = parameter.value;
    if (set.is_bare != of_the_file->is_bare || !(set.dimension == of_the_file->dimension))
        faults_.emplace_back(0, Error{ErrorCode::bad_input,
                                      {},
                                      {lang::exercises::set_is_the_file_own_value, std::string(name),
                                       shown(parameter.set, 40), described(set), described(*of_the_file)}});
    return &*of_the_file;
}

std::optional<Measured> ExerciseReader::value_of_parameter(JsonValue value, const Measured* own) {
    const Words wanted(lang::exercises::a_number_or_a_quantity);
    if (!value) return std::nullopt;
    if (!value.is_number() && !expect(value, Kind::string, wanted)) return std::nullopt;
    if (value.is_string() && is_formula(value.text())) {
        fault(value, {lang::exercises::a_number_or_a_quantity_is});
        return std::nullopt;
    }
    auto read = read_measured(value.text(), {});
    if (read && value.is_string() && read->is_bare)
        read = tl::make_unexpected(Words(lang::common::has_no_unit, quoted(value.text())));
    if (read && own != nullptr && (read->is_bare != own->is_bare || !(read->dimension == own->dimension)))
        read = tl::make_unexpected(Words(lang::exercises::is_the_parameter_own_value, shown(value.text(), 40),
                                         described(*read), described(*own)));
    if (read) return *std::move(read);
    fault(value, std::move(read.error()));
    return std::nullopt;
}

void ExerciseReader::read_choices(JsonValue choose, const Measured* own, Variation& variation) {
    if (choose.size() == 0) fault(choose, {lang::exercises::there_is_nothing_to_choose});
    std::vector<Exact> values;
    for (const JsonValue value : choose) {
        const auto read = value_of_parameter(value, own);
        if (!read) continue;
        if (std::find(values.begin(), values.end(), read->value) != values.end())
            fault(value, {lang::exercises::stands_twice_two_copies, shown(value.text(), 40)});
        values.push_back(read->value);
        variation.choices.emplace_back(value.text());
    }
    variation.count = variation.choices.size();
}

void ExerciseReader::read_steps(const Members& form, const Measured* own, Variation& variation) {
    constexpr int most = 1'000'000;
    const auto from = value_of_parameter(form.value("from"), own);
    const auto to = value_of_parameter(form.value("to"), own);
    const auto step = value_of_parameter(form.value("step"), own);
    if (!from || !to || !step) return;
    for (const auto& [key, value] : {std::pair("to", &*to), std::pair("step", &*step)})
        if (value->is_bare != from->is_bare || !(value->dimension == from->dimension)) {
            fault(form[key], {lang::common::do_not_go_together, described(*from), described(*value)});
            return;
        }
    if (step->value.sign() <= 0) {
        fault(form["step"], {lang::common::must_be_positive, quoted("step")});
        return;
    }
    if (to->value < from->value) {
        fault(form["to"], {lang::exercises::to_lies_before_from_exchange_them});
        return;
    }
    const Exact steps = (to->value - from->value) / step->value;
    if (steps >= Exact(most)) {
        fault(form["step"], {lang::exercises::more_than_values_take_a_larger, std::to_string(most)});
        return;
    }
    variation.count =
        static_cast<std::uint64_t>(mpz_class(steps.rational().get_num() / steps.rational().get_den()).get_ui()) + 1;
    // In the unit of the first value, or in the step's if only that one gives finite decimals for all values.
    for (const std::string_view key : {"from", "step"}) {
        Exact size = 1;
        if (form[key].is_string()) {
            const auto written = read_quantity(form[key].text(), QuantityKind::dimensionless);
            variation.unit = written->unit->symbol;
            const Exact& base = key == "from" ? from->value : step->value;
            if (!written->value.is_zero())
                size = base / written->value;
            else
                size = read_measured("1 " + variation.unit, {})->value;
        }
        variation.from = from->value / size;
        variation.step = step->value / size;
        if (decimal_text(variation.from) && decimal_text(variation.step)) return;
    }
}

// ----- require

void ExerciseReader::read_require(JsonValue value, const Mechanism& mechanism, Exercise& exercise) {
    if (!expect(value, Kind::string, {lang::exercises::a_condition_such_as_omega_3})) return;
    if (auto read = condition(value, mechanism, exercise)) exercise.require.push_back(*std::move(read));
}

std::optional<Condition> ExerciseReader::phrase(JsonValue value, std::string_view text, const Mechanism& mechanism) {
    Condition read;
    if (text == crank_phrase) {
        read.kind = Condition::Kind::crank_turns_fully;
        const auto* spin = mechanism.drivers.empty() ? nullptr : std::get_if<SpinDriver>(&mechanism.drivers.front());
        if (spin == nullptr && (knows_results_ || stands_for_joints(mechanism))) {
            fault(value, {lang::exercises::no_body_is_driven_that_could});
            return std::nullopt;
        }
        return read;
    }
    for (const auto& [spelt, polygon] : polygon_phrases) {
        if (text != spelt) continue;
        read.kind = Condition::Kind::polygon_readable;
        read.polygon = polygon;
        if (stands_for_joints(mechanism)) {
            fault(value, {lang::exercises::this_problem_has_no_such_polygon});
            return std::nullopt;
        }
        return read;
    }
    std::vector<std::string_view> known{crank_phrase};
    for (const auto& each : polygon_phrases) known.push_back(each.first);
    fault(value, {lang::exercises::is_no_condition_write_a_comparison, quoted(text),
                  did_you_mean(speller_.nearest(text, known))});
    return std::nullopt;
}

std::optional<Condition> ExerciseReader::condition(JsonValue value, const Mechanism& mechanism, Exercise& exercise) {
    constexpr std::string_view between_word = " between ", and_word = " and ";
    const std::string_view text = trimmed(value.text());
    for (const std::string_view foreign : foreign_signs) {
        if (text.find(foreign) == std::string_view::npos) continue;
        fault(value, {lang::exercises::is_not_among_the_comparisons_they, std::string(foreign)});
        return std::nullopt;
    }
    const std::size_t between = text.find(between_word);
    const auto sign = between == std::string_view::npos ? sign_in(text) : std::nullopt;
    std::optional<Condition> read = Condition{};
    std::array<std::string_view, 3> sides;
    if (sign) {
        sides = {text.substr(0, sign->second), text.substr(sign->second + sign->first.spelt.size()), {}};
        read->relation = sign->first.relation;
        if (sign_in(sides[1])) {
            fault(value, {lang::exercises::one_comparison_at_a_time_write});
            return std::nullopt;
        }
    } else if (between != std::string_view::npos) {
        const std::size_t last = text.rfind(and_word);
        if (last == std::string_view::npos || last < between + between_word.size()) {
            fault(value, {lang::exercises::between_wants_two_limits});
            return std::nullopt;
        }
        read->kind = Condition::Kind::lies_between;
        sides = {text.substr(0, between),
                 text.substr(between + between_word.size(), last - between - between_word.size()),
                 text.substr(last + and_word.size())};
    } else {
        read = phrase(value, text, mechanism);
    }
    if (!read) return std::nullopt;
    read->text = text;
    read->where = value.pointer();
    const bool is_problem = stands_for_joints(mechanism);
    const std::size_t wanted = read->kind == Condition::Kind::compares       ? 2
                               : read->kind == Condition::Kind::lies_between ? 3
                                                                             : 0;
    const std::array<Operand*, 3> operands{&read->left, &read->right, &read->upper};
    bool whole = true;
    for (std::size_t i = 0; i < wanted; ++i) {
        auto side = operand(value, trimmed(sides.at(i)), is_problem, exercise);
        whole = whole && side.has_value();
        if (side) *operands.at(i) = *std::move(side);
    }
    if (!whole) return std::nullopt;
    if (wanted > 0) match_sides(value, *read);
    return read;
}

std::optional<Operand> ExerciseReader::operand(JsonValue at, std::string_view text, bool is_problem,
                                               Exercise& exercise) {
    Operand side;
    side.text = text;
    if (text.empty()) {
        fault(at, {lang::exercises::a_side_of_the_condition});
        return std::nullopt;
    }
    std::string_view name = text;
    if (text.size() > 2 && text.starts_with('|') && text.ends_with('|'))
        name = trimmed(text.substr(1, text.size() - 2));
    if (text.starts_with("abs(") && text.ends_with(')')) name = trimmed(text.substr(4, text.size() - 5));
    const bool absolute = name.size() != text.size();
    if (result_named(name) != nullptr) {
        side.result = name;
        side.absolute = absolute;
        return side;
    }
    auto value =
        evaluate("= " + std::string(text), [this](std::string_view other) { return look_up_parameter(other); });
    if (value) {
        side.measured = *std::move(value);
        return side;
    }
    // Already reported as the parameter's own fault; or undecidable, because the rest of the file is faulty.
    if (value.error().empty() || (!knows_results_ && !is_problem)) return std::nullopt;
    if (is_expression(text)) {
        const auto read = add_expression(text, exercise);
        if (read) {
            side.result = read->name;
            return side;
        }
        const auto is_in_text = [&](const Column& each) { return text.find(each.name) != std::string_view::npos; };
        if (std::any_of(results_.begin(), results_.end(), is_in_text)) {
            fault(at, read.error());
            return std::nullopt;
        }
    }
    if (is_problem) {  // its solution decides whether there is one
        side.result = name;
        side.absolute = absolute;
        return side;
    }
    std::vector<std::string_view> names{transmission_angle_name};
    for (const Column& each : results_) names.emplace_back(each.name);
    for (const std::string_view parameter : parameter_names_) names.push_back(parameter);
    const Words meant = did_you_mean(speller_.nearest(name, names));
    fault(at, meant.empty() ? Words(lang::exercises::is_no_result, quoted(text), value.error())
                            : Words(lang::exercises::is_neither_a_result_nor, quoted(text), meant));
    return std::nullopt;
}

std::optional<int> ExerciseReader::compared(JsonValue at, const Operand& left, const Operand& right) {
    const auto difference = evaluate("= (" + left.text + ") - (" + right.text + ")",
                                     [this](std::string_view name) { return look_up_parameter(name); });
    if (!difference) {
        if (!difference.error().empty()) fault(at, difference.error());
        return std::nullopt;
    }
    // A difference within the error of roots and sines is zero.
    const Exact size = abs(left.measured->value) + abs(right.measured->value);
    if (difference->is_approximate && abs(difference->value) <= Exact::power_of_two(-160) * size) return 0;
    return difference->value.sign();
}

void ExerciseReader::match_sides(JsonValue at, Condition& condition) {
    const bool is_between = condition.kind == Condition::Kind::lies_between;
    const std::size_t before = faults_.size();
    hold_sides_together(at, condition);
    if (!is_between || faults_.size() > before || !never_holds(condition)) return;
    fault(at, {lang::exercises::never_holds_for_is_more, quoted(condition.right.text), quoted(condition.upper.text)});
}

bool ExerciseReader::never_holds(const Condition& condition) const {
    const auto without_parameters = [](const Operand& side) {
        const auto none_is = [](std::string_view) {
            return tl::expected<Measured, Words>(tl::make_unexpected(Words()));
        };
        return side.result.empty() && evaluate("= " + side.text, none_is).has_value();
    };
    if (!without_parameters(condition.right) || !without_parameters(condition.upper)) return false;
    const Measured &lower = *condition.right.measured, &upper = *condition.upper.measured;
    const Column* column = condition.left.result.empty() ? nullptr : result_named(condition.left.result);
    if (column != nullptr) {
        const auto from = as_quantity(lower, column->unit, bare_unit(column->unit));
        const auto to = as_quantity(upper, column->unit, bare_unit(column->unit));
        return from && to && from->in_si() > to->in_si();
    }
    return lower.is_bare == upper.is_bare && lower.dimension == upper.dimension && lower.value > upper.value;
}

void ExerciseReader::hold_sides_together(JsonValue at, Condition& condition) {
    const bool is_between = condition.kind == Condition::Kind::lies_between;
    std::vector<const Operand*> sides{&condition.left, &condition.right};
    if (is_between) sides.push_back(&condition.upper);
    const Operand* result = nullptr;
    for (const Operand* side : sides)
        if (result == nullptr && !side->result.empty()) result = side;
    if (result == nullptr) {
        const auto first = compared(at, condition.left, condition.right);
        if (!first) return;
        if (!is_between) {
            condition.holds = holds_by(condition.relation, *first);
            return;
        }
        const auto second = compared(at, condition.left, condition.upper);
        if (second) condition.holds = *first >= 0 && *second <= 0;
        return;
    }
    const Column* column = result_named(result->result);
    if (column == nullptr || !knows_results_) return;  // a problem: its solution decides
    if (!column->si_unit.empty())
        return fault(at, {lang::expressions::cannot_be_compared, quoted(column->name), column->si_unit});
    for (const Operand* side : sides) {
        if (side->result.empty()) {
            const auto read = as_quantity(*side->measured, column->unit, bare_unit(column->unit));
            if (!read)
                fault(at, {lang::common::is_and, quoted(result->result), with_article(column->unit), quoted(side->text),
                           described(*side->measured)});
        } else if (const Column* other = result_named(side->result); other != nullptr && other->unit != column->unit) {
            fault(at, {lang::common::is_and, quoted(result->result), with_article(column->unit), quoted(side->result),
                       with_article(other->unit)});
        }
    }
}

}  // namespace kinegraph
