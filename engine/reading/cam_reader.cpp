// The file of a cam: FORMAT "Cams". Its law, base circle and follower; faults are reported as for a mechanism file.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/mechanism/cam.hpp"
#include "engine/reading/file_kind.hpp"
#include "engine/reading/law_reader.hpp"
#include "lang/keys/cams.hpp"
#include "lang/keys/common.hpp"

namespace kinegraph {
namespace {

constexpr std::array cam_unit_rows{
    FormRow("length", {}, values::unit(QuantityKind::length)),
    FormRow("angle", {}, values::unit(QuantityKind::angle)),
    FormRow("angular velocity", {}, values::unit(QuantityKind::angular_velocity)),
};
constexpr Form cam_units{lang::cams::units_of_a_cam, cam_unit_rows};

/// In the order of Follower::Moves and Follower::Face.
constexpr std::array<std::string_view, 2> moves_of_follower{"translating", "oscillating"};
constexpr std::array<std::string_view, 3> faces_of_follower{"roller", "flat", "knife edge"};
constexpr std::array<std::string_view, 2> sides_of_cam{"left", "right"};
constexpr std::array follower_rows{
    FormRow("moves", "…", values::word(moves_of_follower)).needed(lang::cams::translating_or_oscillating),
    FormRow("face", "…", values::word(faces_of_follower)).needed(lang::cams::roller_flat_or_knife_edge),
    FormRow("radius", "r", values::length).positive(),
    FormRow("offset", "e", values::length),
    FormRow("pivot", "[x, y]", values::coordinates),
    FormRow("arm", "l", values::length).positive(),
    FormRow("side", "…", values::word(sides_of_cam))};
constexpr Form follower_form{lang::cams::a_follower, follower_rows};
constexpr std::array cam_rows{
    FormRow("omega", "…", values::angular_velocity).needed(lang::cams::how_fast_the_cam_turns),
    FormRow("base radius", "r", values::length).needed(lang::cams::the_radius_of_the_base_circle).positive(),
    FormRow("follower", "{…}", values::object(follower_form))
        .needed(lang::cams::what_the_cam_moves)
        .called(lang::cams::a_follower),
    FormRow("law", "…", values::number_or_text).needed(lang::cams::how_the_follower_moves_over)};
constexpr Form cam_form{lang::cams::a_cam, cam_rows};
constexpr std::array cam_file_rows{
    FormRow("$schema", "\"…\"", values::text),
    FormRow("kinegraph", "1", values::number).needed(lang::common::write_the_version),
    FormRow("title", "\"…\"", values::texts),
    FormRow("units", "{…}", values::object(cam_units)).called(lang::cams::an_object_of_units_by_quantity),
    FormRow("cam", "{…}", values::object(cam_form))
        .needed(lang::cams::the_cam_its_law_its_base)
        .called(lang::cams::a_cam)};
constexpr Form cam_file{lang::cams::the_file_of_a_cam, cam_file_rows};

class CamReader : private LawReader {
public:
    CamReader(const JsonSource& source, std::string name) : source_(source) { cam_.source = std::move(name); }

    Result<Cam> read() {
        for (const JsonValue& twice : source_.duplicates())
            fault(twice, {lang::cams::stands_twice_in_this_object_rename, quoted(twice.key())});
        if (const JsonValue root = source_.root(); !root.is_object())
            fault(root, {lang::cams::a_cam_file_is_a_json, described(root)});
        else
            read_file(root);
        if (faults_.empty()) return std::move(cam_);
        std::stable_sort(faults_.begin(), faults_.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        Errors errors;
        for (auto& [order, error] : faults_) errors.push_back(std::move(error));
        return tl::unexpected(std::move(errors));
    }

private:
    void read_file(JsonValue root) {
        if (const auto other = fault_of_kind(root, FileKind::cam)) return fault(other->first, other->second);
        const Members file = members(root, cam_file);
        const JsonValue version = file.value("kinegraph");
        if (version && (!version.is_number() || version.text() != "1"))
            fault(version, {lang::cams::the_version_of_the_format, described(version)});
        if (file["title"]) cam_.title = words(file["title"]);
        read_units(file);
        if (const Members cam = file.form("cam")) read_cam(cam);
    }

    void read_units(const Members& file) {
        if (const Members set = file.form("units")) {
            for (const FormRow& row : cam_unit_rows) {
                const JsonValue value = set[row.key];
                const QuantityKind kind = row.value.kind;
                if (!value || !expect(value, Kind::string, {lang::common::a_unit})) continue;
                const KnownUnit* unit = unit_spelt(value.text());
                if (unit == nullptr || unit->kind != kind)
                    fault(value, unknown_unit_message(value.text(), kind));
                else
                    bare_units_.push_back(unit);
            }
        }
        const auto set = [&](Unit& target, QuantityKind kind) {
            const KnownUnit& unit = bare_unit(kind);
            target = {std::string(unit.symbol), unit.si};
        };
        set(cam_.units.length, QuantityKind::length);
        set(cam_.units.angle, QuantityKind::angle);
        set(cam_.units.angular_velocity, QuantityKind::angular_velocity);
    }

    void read_cam(const Members& form) {
        cam_.omega = form.quantity("omega").value_or(Exact(1));
        if (cam_.omega.is_zero()) {
            fault(form["omega"], {lang::cams::a_cam_that_does_not_turn});
            cam_.omega = 1;
        }
        cam_.base_circle = form.quantity_or_default("base radius");
        if (const Members follower = form.form("follower")) read_follower(follower);
        if (const JsonValue law = form.value("law")) read_law(law);
    }

    /// The place of the member's word among those of its row; the first, with a fault reported, where it is none.
    std::size_t choice(const Members& form, std::string_view key) {
        const JsonValue value = form.value(key);
        if (!value || !expect(value, Kind::string, {lang::cams::a_word})) return 0;
        const auto known = follower_form.row(key)->value.words;
        const auto found = std::find(known.begin(), known.end(), value.text());
        if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
        std::string list;
        for (const std::string_view each : known) list += (list.empty() ? "" : ", ") + quoted(each);
        fault(value,
              {lang::cams::is_none, quoted(value.text()), list, did_you_mean(speller_.nearest(value.text(), known))});
        return 0;
    }

    void read_follower(const Members& form) {
        using Moves = Follower::Moves;
        using Face = Follower::Face;
        Follower& follower = cam_.follower;
        follower.moves = static_cast<Moves>(choice(form, "moves"));
        follower.face = static_cast<Face>(choice(form, "face"));
        const bool oscillates = follower.moves == Moves::oscillating, is_flat = follower.face == Face::flat;
        follower.radius = wanted(form, "radius", follower.face == Face::roller, true, {lang::cams::the_roller_radius},
                                 {lang::cams::only_a_roller_has_a_radius});
        follower.arm = wanted(form, "arm", oscillates && !is_flat, true, {lang::cams::from_the_pivot_to_the_roller},
                              {lang::cams::only_an_oscillating_roller_or_edge});
        follower.offset =
            wanted(form, "offset", oscillates == is_flat, false, {}, {lang::cams::an_offset_is_of_a_translating});
        if (const JsonValue pivot = form["pivot"]; oscillates) {
            const Words where(lang::cams::where_the_follower_turns_x_y);
            follower.pivot = vector(required(form, "pivot", where), QuantityKind::length, where).value_or(Vector{1, 0});
            if (follower.pivot.is_zero()) fault(pivot, {lang::cams::the_pivot_is_the_cam_own});
        } else if (pivot) {
            fault(pivot, {lang::cams::only_an_oscillating_follower});
        }
        if (form["side"]) follower.on_left = choice(form, "side") == 0;
    }

    /// A length that some kinds of follower need and others must not have.
    Exact wanted(const Members& form, std::string_view key, bool has_it, bool is_needed, const Words& meaning,
                 const Words& why_not) {
        const JsonValue value = form[key];
        if (!has_it) {
            if (value) fault(value, why_not);
            return 0;
        }
        if (is_needed) required(form, key, meaning);
        return form.quantity_or_default(key);
    }

    void read_law(JsonValue value) {
        const std::size_t before = faults_.size();
        const bool turning = cam_.follower.moves == Follower::Moves::oscillating;
        cam_.law = law_of_value(value, turning ? forms::piece_of_swing : forms::piece_of_lift);
        if (faults_.size() > before) return;
        Exact turn, end;
        bool sinks = false;
        for (const LawPiece& piece : cam_.law.pieces) {
            turn += piece.over;
            end += piece.rise;
            sinks = sinks || end.sign() < 0;
        }
        constexpr double same = 1e-9;
        const double degrees = (turn * 180 / pi()).to_double();
        if (std::abs(degrees - 360) > same) {
            std::array<char, 32> text{};
            std::snprintf(text.data(), text.size(), "%.9g°", degrees);
            fault(value, {lang::cams::a_cam_law_goes_over, std::string(text.data())});
        }
        if (!end.is_zero()) fault(value, {lang::cams::after_a_whole_turn_the_follower});
        if (sinks) fault(value, {lang::cams::the_law_begins_at_its_lowest});
    }

    const JsonSource& source_;
    Cam cam_;
};

}  // namespace

Result<Cam> read_cam(std::string_view text, std::string source) {
    const Result<JsonSource> json = JsonSource::read(text);
    if (!json) return tl::unexpected(json.error());
    return CamReader(*json, std::move(source)).read();
}

}  // namespace kinegraph
