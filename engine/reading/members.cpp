// The values of an object's members, read as the rows of its form say.
#include "engine/number/assert.hpp"
#include "engine/reading/form_reader.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/forms.hpp"

namespace kinegraph {

namespace {

Words noun_of(const FormRow& row) { return row.noun == Key{} ? Words(quoted(row.key)) : Words(row.noun); }

}  // namespace

const FormRow& Members::row(std::string_view key) const {
    const FormRow* const found = form_->row(key);
    KG_ASSERT(found != nullptr, "the form has the key");
    return *found;
}

JsonValue Members::expected(std::string_view key) const {
    using Shape = FormValue::Shape;
    const FormRow& of = row(key);
    const Shape shape = of.value.shape;
    const auto kind = shape == Shape::list                          ? JsonValue::Kind::array
                      : shape == Shape::map || shape == Shape::form ? JsonValue::Kind::object
                                                                    : JsonValue::Kind::string;
    const JsonValue there = value(key);
    return there && file_->expect(there, kind, noun_of(of)) ? there : JsonValue();
}

JsonValue Members::one_of() const {
    std::vector<std::string_view> keys;
    bool needed = false;
    for (const FormRow& each : form_->rows) {
        if (each.need != FormRow::Need::one_of && each.need != FormRow::Need::at_most_one) continue;
        keys.push_back(each.key);
        needed = each.need == FormRow::Need::one_of;
    }
    return file_->one_of(*this, keys, needed);
}

std::string Members::name(std::string_view key) const {
    const JsonValue there = value(key);
    return there ? file_->new_name(there, noun_of(row(key))) : std::string();
}

bool Members::flag(std::string_view key) const {
    const JsonValue there = value(key);
    return there && file_->expect(there, JsonValue::Kind::boolean, {lang::common::true_or_false}) && is_true(there);
}

Exact Members::quantity_or_default(std::string_view key) const {
    const FormRow& of = row(key);
    if (of.sign == FormRow::Sign::positive) return file_->positive(value(key), of.value.kind, noun_of(of));
    Exact number = quantity(key).value_or(Exact());
    if (of.sign == FormRow::Sign::not_negative && number.sign() < 0)
        file_->fault((*this)[key], {lang::forms::must_not_be_negative, noun_of(of)});
    return number;
}

std::optional<Vector> Members::vector(std::string_view key) const {
    return file_->vector(value(key), row(key).value.of->kind, noun_of(row(key)));
}

Place Members::place(std::string_view key) const {
    const JsonValue there = value(key);
    return there ? file_->place(there) : Place();
}

}  // namespace kinegraph
