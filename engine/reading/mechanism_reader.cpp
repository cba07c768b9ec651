// The reader of mechanism files: checks the rules of docs/file.md and builds a Mechanism. Each fault is reported once,
// at its place. Faults that only the drawing shows (curves that do not meet, a misfit) are left to the pose.
#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "engine/file/json_source.hpp"
#include "engine/mechanism/contact.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/mechanism/rounding.hpp"
#include "engine/reading/exercise_reader.hpp"
#include "engine/reading/file_kind.hpp"
#include "engine/reading/problem_section.hpp"
#include "engine/reading/sections.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/mechanism.hpp"

namespace kinegraph {
namespace {

/// Section by section.
class Reader : private ExerciseReader {
public:
    Reader(const JsonSource& source, std::string name, std::span<const Setting> set) : source_(source), set_(set) {
        mechanism_.source = std::move(name);
    }

    Result<Mechanism> read() {
        for (const JsonValue& twice : source_.duplicates()) {
            fault(twice, {lang::mechanism::stands_twice_in_this_object_rename, quoted(twice.key())});
        }
        if (const JsonValue root = source_.root(); !root.is_object()) {
            fault(root, {lang::mechanism::a_mechanism_is_a_json_object, described(root)});
        } else {
            read_file(root);
        }
        if (faults_.empty()) return finished();
        std::stable_sort(faults_.begin(), faults_.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        Errors errors;
        errors.reserve(faults_.size());
        for (auto& [order, error] : faults_) errors.push_back(std::move(error));
        return tl::make_unexpected(std::move(errors));
    }

private:
    /// Roots and sines in formulas are rounded: without a stated or inferred precision, the precision is that of the
    /// roots.
    Mechanism finished() {
        mechanism_.computed = std::move(computed_);
        std::sort(mechanism_.computed.begin(), mechanism_.computed.end());
        if (is_approximate_ && !mechanism_.precision && !looks_rounded(mechanism_))
            mechanism_.precision = precision_of_roots();
        return std::move(mechanism_);
    }

    void read_file(JsonValue root) {
        if (const auto other = fault_of_kind(root, FileKind::mechanism)) return fault(other->first, other->second);
        const Members file = members(root, forms::mechanism());
        read_head(file);
        // A problem names its own bodies and needs no points.
        const bool is_problem = ProblemSection::is_in(file);
        read_points_and_bodies(file, is_problem);
        if (is_problem) {
            mechanism_.problem = problem_.read(file);
        } else {
            joints_.read_joints(file);
            if (LoadedContacts contacts = joints_.take_contacts(); !contacts.empty())
                mechanism_.contacts = std::make_shared<const LoadedContacts>(std::move(contacts));
            file.each("drivers", [&](JsonValue v) { drivers_.read_driver(v); });
            read_forces(file);
            read_wishes(file);
        }
        read_exercise(file, mechanism_);
        if (!is_problem && faults_.empty()) {
            wishes_.check_observed_points();
            wishes_.read_cuts();
        }
    }

    void read_head(const Members& file) {
        if (const JsonValue version = file.value("kinegraph")) read_version(version);
        file.expected("$schema");
        if (file["title"]) mechanism_.title = words(file["title"]);
        units_.read_units(file);
        read_parameters(file["parameters"], set_);
        if (const JsonValue cam = file.expected("position of cam")) mechanism_.cam_file = cam.text();
        if (file["precision"]) mechanism_.precision = file.quantity_or_default("precision");
    }

    void read_points_and_bodies(const Members& file, bool may_be_absent) {
        const auto wanted = [&](std::string_view key, const Words& what) {
            return may_be_absent ? file[key] : required(file, key, what);
        };
        const JsonValue points = wanted("points", {lang::mechanism::an_object_of_points_by_name});
        const JsonValue bodies = wanted("bodies", {lang::mechanism::an_object_of_bodies_by_name});
        if (points && expect(points, Kind::object, {lang::mechanism::an_object_of_points_by_name})) {
            know_points(true);
            for (const JsonValue member : points) points_.register_point(member);
        }
        if (may_be_absent && !points) know_points(true);  // there are none
        const bool bodies_readable =
            bodies && expect(bodies, Kind::object, {lang::mechanism::an_object_of_bodies_by_name});
        know_bodies(bodies_readable);
        bodies_.register_bodies(file["frame"], bodies_readable ? bodies : JsonValue());
        if (points && points_known_) points_.read_points(points);
        if (bodies_readable) bodies_.read_bodies(bodies);
    }

    void read_forces(const Members& file) {
        mechanism_.inertia_forces = file.flag("inertia forces");
        loads_.read_masses(file);
        mechanism_.gravity = file.vector("gravity");
        file.each("loads", [&](JsonValue v) { loads_.read_load(v); });
        if (const JsonValue effort = file["effort"]; effort && effort.is_object()) {
            efforts_.read_effort(effort);
        } else {
            each(effort, {lang::mechanism::an_array_of_efforts}, [&](JsonValue v) { efforts_.read_effort(v); });
        }
    }

    void read_wishes(const Members& file) {
        if (file["motion"]) motion_.read_motion(file["motion"]);
        if (file["find"]) mechanism_.find.stated = true;
        file.each("find", [&](JsonValue v) { wishes_.read_wish(v); });
        units_.read_scales(file);
    }

    void read_version(JsonValue version) {
        const auto number = version.is_number() ? read_decimal(version.text()) : tl::expected<Exact, Words>(Exact());
        if (!number || *number != Exact(1)) {
            fault(version, {lang::mechanism::the_version_of_the_format, described(version)});
        }
    }

    const JsonSource& source_;
    std::span<const Setting> set_;
    Mechanism mechanism_;
    UnitsSection units_{*this, mechanism_};
    PointsSection points_{*this, mechanism_};
    BodiesSection bodies_{*this, mechanism_};
    ProblemSection problem_{*this, mechanism_};
    JointsSection joints_{*this, mechanism_, bodies_};
    DriversSection drivers_{*this, mechanism_, *this, joints_};
    LoadsSection loads_{*this, mechanism_, bodies_, joints_};
    EffortsSection efforts_{*this, mechanism_, joints_};
    MotionSection motion_{*this, mechanism_, bodies_};
    WishesSection wishes_{*this, mechanism_};
};

}  // namespace

Result<Mechanism> read_mechanism(std::string_view text, std::string source, std::span<const Setting> set) {
    const Result<JsonSource> json = JsonSource::read(text);
    if (!json) return tl::make_unexpected(json.error());
    return Reader(*json, std::move(source), set).read();
}

}  // namespace kinegraph
