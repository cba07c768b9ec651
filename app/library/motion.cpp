// Whole cycles and cams for the public interface.
#include "kinegraph/motion.hpp"

#include <utility>

#include "app/library/driver_choice.hpp"
#include "app/library/state.hpp"
#include "constructions/positions/cycle.hpp"
#include "engine/drawing/pose.hpp"
#include "engine/file/units.hpp"
#include "engine/mechanism/cam.hpp"
#include "engine/mechanism/problem.hpp"
#include "engine/number/exact.hpp"

namespace kinegraph {

struct CamFile::State : Owned {
    State(Cam read, const CamGeometry& found) : cam(std::move(read)), geometry(found) {}
    Cam cam;
    CamGeometry geometry;
};
template class Shared<const CamFile::State>;

struct Sweep::State {
    Mechanism mechanism;
    Pose pose;
    std::optional<Cycle> cycle;  ///< refers to both members above, which must not move
    Travel travel;
    long steps = 0;
    std::vector<SweepColumn> columns;
    std::vector<Unsolved> unsolved;
};

Sweep::Sweep(State* state) : state_(state) {}
Sweep::Sweep(Sweep&& other) noexcept : state_(std::exchange(other.state_, nullptr)) {}
Sweep& Sweep::operator=(Sweep&& other) noexcept {
    std::swap(state_, other.state_);
    return *this;
}
Sweep::~Sweep() { delete state_; }

namespace {

/// The requested travel, or the reason why the driver cannot make it.
Expected<Travel> travel_of(const SweepOptions& options, const Mechanism& mechanism, int driver,
                           const Positions& positions) {
    const Law* const law = app::law_of(mechanism, driver);
    std::array<std::optional<double>, 2> ends;
    for (const auto& [text, end] : {std::pair(&options.from, &ends[0]), std::pair(&options.to, &ends[1])}) {
        if (text->empty()) continue;
        const auto read = law != nullptr ? app::time_of(*text) : app::coordinate_of(mechanism, driver, *text);
        if (!read) return refused(Diagnostic::Kind::bad_input, read.error());
        *end = read->to_double();
    }
    if (ends[0] && ends[1] && *ends[0] == *ends[1])
        return refused(Diagnostic::Kind::bad_input, {"a sweep begins and ends in different positions",
                                                     "un ciclo comincia e finisce in posizioni diverse"});
    const auto travel = law != nullptr
                            ? travel_of_law(positions, *law, ends[0], ends[1])
                            : kinegraph::travel_of(positions, app::turns(mechanism, driver), ends[0], ends[1]);
    if (travel) return *travel;
    const std::string name = app::name_of_driver(mechanism, driver);
    if (!travel.error().limit)
        return refused(Diagnostic::Kind::bad_input,
                       Words("driver {0} has no limit; say from where to where it goes",
                             "il movente {0} non ha limiti; dire da dove a dove va", name));
    return refused(Diagnostic::Kind::bad_input,
                   app::out_of_reach(app::coordinate_text(mechanism, driver, travel.error().wanted), name,
                                     app::coordinate_text(mechanism, driver, *travel.error().limit)));
}

}  // namespace

Expected<Sweep> Sweep::of(const MechanismFile& file, const SweepOptions& options) {
    if (!file.has_joints())
        return refused(Diagnostic::Kind::bad_input, {"the file states a problem in place of joints: nothing moves",
                                                     "il file pone un problema al posto delle coppie: nulla si muove"});
    if (options.steps < 2)
        return refused(Diagnostic::Kind::bad_input, {"at least 2 steps are needed", "occorrono almeno 2 passi"});
    Sweep sweep(new State{file.state().mechanism, {}, std::nullopt, {}, options.steps, {}, {}});
    State& state = *sweep.state_;
    const auto driver = app::driver_named(state.mechanism, options.driver, "");
    if (!driver) return refused(Diagnostic::Kind::bad_input, driver.error());
    auto pose = draw_pose(state.mechanism);
    if (!pose) return tl::unexpected(diagnostics_of(pose.error()));
    state.pose = *std::move(pose);
    auto cycle = Cycle::of(state.mechanism, state.pose, app::course_of(*driver, options.branch));
    if (!cycle) return tl::unexpected(diagnostics_of(cycle.error()));
    const auto travel = travel_of(options, state.mechanism, *driver, cycle->positions());
    if (!travel) return tl::unexpected(travel.error());
    state.cycle.emplace(*std::move(cycle));
    state.travel = *travel;
    state.unsolved = state.cycle->begin(state.travel);
    for (const Column& each : state.cycle->columns())
        state.columns.push_back({each.name, std::string(default_unit(each.unit).symbol)});
    return sweep;
}

const std::vector<SweepColumn>& Sweep::columns() const { return state_->columns; }
std::vector<double> Sweep::change_points() const { return state_->travel.change_points; }
std::array<std::optional<double>, 2> Sweep::limits() const {
    const Travel& travel = state_->travel;
    return {travel.starts_at_limit ? std::optional(travel.from) : std::nullopt,
            travel.ends_at_limit ? std::optional(travel.to) : std::nullopt};
}

void Sweep::for_each_row(const std::function<bool(const std::vector<double>& row)>& see) {
    const Travel& travel = state_->travel;
    for (long i = 0; i <= state_->steps; ++i) {
        if ((i == 0 && travel.starts_at_limit) || (i == state_->steps && travel.ends_at_limit)) continue;
        const auto row = state_->cycle->row(travel.at(static_cast<double>(i) / static_cast<double>(state_->steps)));
        if (row && !see({row->begin(), row->end()})) return;
    }
}

std::vector<std::vector<double>> Sweep::rows() {
    std::vector<std::vector<double>> all;
    for_each_row([&](const std::vector<double>& row) {
        all.push_back(row);
        return true;
    });
    return all;
}

std::vector<Solved::Missing> Sweep::unsolved() const {
    std::vector<Solved::Missing> all;
    for (const Unsolved& each : state_->unsolved) all.push_back({text_of(each.what), text_of(each.why)});
    return all;
}

double Sweep::largest_difference() const { return state_->cycle->difference().share; }

Expected<CamFile> CamFile::parse(std::string_view text, std::string name) {
    auto cam = read_cam(text, std::move(name));
    if (!cam) return tl::unexpected(diagnostics_of(cam.error()));
    // The geometry refers to the cam, which must not move after this.
    auto* const state = new State(*std::move(cam), {});
    CamFile file{Shared<const State>(state)};
    auto geometry = CamGeometry::of(state->cam);
    if (!geometry) return tl::unexpected(diagnostics_of(geometry.error()));
    state->geometry = *geometry;
    return file;
}

Expected<CamFile> CamFile::open(const std::string& path) {
    const auto text = read_file(path, {"cam file", "file di camma"});
    if (!text) return tl::unexpected(text.error());
    return parse(*text, path.substr(path.rfind('/') + 1));
}

CamPosition CamFile::at(double turn) const {
    const CamState found = (*state_).geometry.at(turn);
    return {found.turn, found.rise.s, {found.contact.x, found.contact.y}, found.pressure_angle, found.curvature};
}

std::vector<std::array<double, 2>> CamFile::profile(int positions) const {
    std::vector<std::array<double, 2>> places;
    for (const VectorOf<double>& each : working_profile((*state_).cam, (*state_).geometry, positions))
        places.push_back({each.x, each.y});
    return places;
}

std::string CamFile::mechanism_at(double turn) const {
    return mechanism_file_of((*state_).cam, (*state_).geometry, turn);
}

}  // namespace kinegraph
