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
        const Members file =
            members(root, {"$schema", "kinegraph", "title", "units", "cam"}, {lang::cams::the_file_of_a_cam});
        const JsonValue version = required(file, "kinegraph", {lang::common::write_the_version});
        if (version && (!version.is_number() || version.text() != "1"))
            fault(version, {lang::cams::the_version_of_the_format, described(version)});
        if (file["title"]) cam_.title = words(file["title"]);
        read_units(file["units"]);
        const JsonValue cam = required(file, "cam", {lang::cams::the_cam_its_law_its_base});
        if (cam && expect(cam, Kind::object, {lang::cams::a_cam})) read_cam(cam);
    }

    void read_units(JsonValue units) {
        if (units && expect(units, Kind::object, {lang::cams::an_object_of_units_by_quantity})) {
            const Members set = members(units, {"length", "angle", "angular velocity"}, {lang::cams::units_of_a_cam});
            for (const auto& [key, kind] :
                 {std::pair("length", QuantityKind::length), std::pair("angle", QuantityKind::angle),
                  std::pair("angular velocity", QuantityKind::angular_velocity)}) {
                const JsonValue value = set[key];
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

    void read_cam(JsonValue value) {
        const Members form = members(value, {"omega", "base radius", "follower", "law"}, {lang::cams::a_cam});
        const JsonValue omega = required(form, "omega", {lang::cams::how_fast_the_cam_turns});
        cam_.omega = quantity(omega, QuantityKind::angular_velocity).value_or(Exact(1));
        if (cam_.omega.is_zero()) {
            fault(omega, {lang::cams::a_cam_that_does_not_turn});
            cam_.omega = 1;
        }
        cam_.base_circle = positive(required(form, "base radius", {lang::cams::the_radius_of_the_base_circle}),
                                    QuantityKind::length, std::string("\"base radius\""));
        const JsonValue follower = required(form, "follower", {lang::cams::what_the_cam_moves});
        if (follower && expect(follower, Kind::object, {lang::cams::a_follower})) read_follower(follower);
        const JsonValue law = required(form, "law", {lang::cams::how_the_follower_moves_over});
        if (law) read_law(law);
    }

    /// The choice of this name; `fallback`, with a fault reported, where there is none.
    template <class Choice, std::size_t count>
    Choice choice(JsonValue value, const std::array<std::pair<std::string_view, Choice>, count>& known) {
        if (!value || !expect(value, Kind::string, {lang::cams::a_word})) return known.front().second;
        for (const auto& [word, meant] : known)
            if (value.text() == word) return meant;
        std::vector<std::string> names;
        std::string list;
        for (const auto& each : known) {
            names.emplace_back(each.first);
            list += (list.empty() ? "" : ", ") + quoted(each.first);
        }
        fault(value,
              {lang::cams::is_none, quoted(value.text()), list, did_you_mean(speller_.nearest(value.text(), names))});
        return known.front().second;
    }

    void read_follower(JsonValue value) {
        using Moves = Follower::Moves;
        using Face = Follower::Face;
        const Members form =
            members(value, {"moves", "face", "radius", "offset", "pivot", "arm", "side"}, {lang::cams::a_follower});
        Follower& follower = cam_.follower;
        follower.moves = choice(required(form, "moves", {lang::cams::translating_or_oscillating}),
                                std::array{std::pair{std::string_view("translating"), Moves::translating},
                                           std::pair{std::string_view("oscillating"), Moves::oscillating}});
        follower.face = choice(required(form, "face", {lang::cams::roller_flat_or_knife_edge}),
                               std::array{std::pair{std::string_view("roller"), Face::roller},
                                          std::pair{std::string_view("flat"), Face::flat},
                                          std::pair{std::string_view("knife edge"), Face::knife_edge}});
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
        if (const JsonValue side = form["side"])
            follower.on_left = choice(side, std::array{std::pair{std::string_view("left"), true},
                                                       std::pair{std::string_view("right"), false}});
    }

    /// A length that some kinds of follower need and others must not have.
    Exact wanted(const Members& form, std::string_view key, bool has_it, bool is_needed, const Words& meaning,
                 const Words& why_not) {
        const JsonValue value = form[key];
        if (!has_it) {
            if (value) fault(value, why_not);
            return 0;
        }
        if (is_needed) return positive(required(form, key, meaning), QuantityKind::length, quoted(key));
        return quantity_or_zero(value, QuantityKind::length);
    }

    void read_law(JsonValue value) {
        const std::size_t before = faults_.size();
        const bool turning = cam_.follower.moves == Follower::Moves::oscillating;
        cam_.law = law_of_value(
            value, {"rise", turning ? QuantityKind::angle : QuantityKind::length, "turn", QuantityKind::angle});
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
