// The file of a cam: FORMAT "Cams". Its law, base circle and follower; faults are reported as for a mechanism file.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/file/file_kind.hpp"
#include "engine/mechanism/cam.hpp"
#include "engine/reading/law_reader.hpp"

namespace kinegraph {
namespace {

class CamReader : private LawReader {
public:
    CamReader(const JsonSource& source, std::string name) : source_(source) { cam_.source = std::move(name); }

    Result<Cam> read() {
        for (const JsonValue& twice : source_.duplicates())
            fault(twice,
                  {"{0} stands twice in this object; rename one or take it out",
                   "{0} compare due volte in questo oggetto; rinominare o togliere uno dei due", quoted(twice.key())});
        if (const JsonValue root = source_.root(); !root.is_object())
            fault(root, {"a cam's file is a JSON object, not {0}", "il file di una camma è un oggetto JSON, non {0}",
                         described(root)});
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
        const Members file = members(root, {"$schema", "kinegraph", "title", "units", "cam"},
                                     {"the file of a cam", "il file di una camma"});
        const JsonValue version = required(file, "kinegraph",
                                           {"write \"kinegraph\": 1, the version of the format",
                                            "scrivere \"kinegraph\": 1, la versione del formato"});
        if (version && (!version.is_number() || version.text() != "1"))
            fault(version, {"the version of the format is 1, not {0}", "la versione del formato è 1, non {0}",
                            described(version)});
        if (file["title"]) cam_.title = words(file["title"]);
        read_units(file["units"]);
        const JsonValue cam = required(file, "cam",
                                       {"the cam: its law, its base radius and its follower",
                                        "la camma: la sua legge, il raggio di base e la punteria"});
        if (cam && expect(cam, Kind::object, {"a cam", "una camma"})) read_cam(cam);
    }

    void read_units(JsonValue units) {
        if (units &&
            expect(units, Kind::object, {"an object of units by quantity", "un oggetto con le unità per grandezza"})) {
            const Members set = members(units, {"length", "angle", "angular velocity"},
                                        {"\"units\" of a cam", "\"units\" di una camma"});
            for (const auto& [key, kind] :
                 {std::pair("length", QuantityKind::length), std::pair("angle", QuantityKind::angle),
                  std::pair("angular velocity", QuantityKind::angular_velocity)}) {
                const JsonValue value = set[key];
                if (!value || !expect(value, Kind::string, {"a unit", "un’unità"})) continue;
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
        const Members form = members(value, {"omega", "base radius", "follower", "law"}, {"a cam", "una camma"});
        const JsonValue omega =
            required(form, "omega", {"how fast the cam turns", "quanto velocemente ruota la camma"});
        cam_.omega = quantity(omega, QuantityKind::angular_velocity).value_or(Exact(1));
        if (cam_.omega.is_zero()) {
            fault(omega, {"a cam that does not turn moves nothing", "una camma che non ruota non muove nulla"});
            cam_.omega = 1;
        }
        cam_.base_circle = positive(
            required(form, "base radius", {"the radius of the base circle", "il raggio della circonferenza di base"}),
            QuantityKind::length, std::string("\"base radius\""));
        const JsonValue follower = required(form, "follower", {"what the cam moves", "ciò che la camma muove"});
        if (follower && expect(follower, Kind::object, {"a follower", "una punteria"})) read_follower(follower);
        const JsonValue law = required(
            form, "law",
            {"how the follower moves over a turn of the cam", "come si muove la punteria in un giro della camma"});
        if (law) read_law(law);
    }

    /// The choice of this name; `fallback`, with a fault reported, where there is none.
    template <class Choice, std::size_t count>
    Choice choice(JsonValue value, const std::array<std::pair<std::string_view, Choice>, count>& known) {
        if (!value || !expect(value, Kind::string, {"a word", "una parola"})) return known.front().second;
        for (const auto& [word, meant] : known)
            if (value.text() == word) return meant;
        std::vector<std::string> names;
        std::string list;
        for (const auto& each : known) {
            names.emplace_back(each.first);
            list += (list.empty() ? "" : ", ") + quoted(each.first);
        }
        fault(value, {"{0} is none of {1}{2}", "{0} non è fra {1}{2}", quoted(value.text()), list,
                      did_you_mean(speller_.nearest(value.text(), names))});
        return known.front().second;
    }

    void read_follower(JsonValue value) {
        using Moves = Follower::Moves;
        using Face = Follower::Face;
        const Members form = members(value, {"moves", "face", "radius", "offset", "pivot", "arm", "side"},
                                     {"a follower", "una punteria"});
        Follower& follower = cam_.follower;
        follower.moves = choice(
            required(form, "moves", {"\"translating\" or \"oscillating\"", "\"translating\" oppure \"oscillating\""}),
            std::array{std::pair{std::string_view("translating"), Moves::translating},
                       std::pair{std::string_view("oscillating"), Moves::oscillating}});
        follower.face =
            choice(required(form, "face",
                            {"\"roller\", \"flat\" or \"knife edge\"", "\"roller\", \"flat\" oppure \"knife edge\""}),
                   std::array{std::pair{std::string_view("roller"), Face::roller},
                              std::pair{std::string_view("flat"), Face::flat},
                              std::pair{std::string_view("knife edge"), Face::knife_edge}});
        const bool oscillates = follower.moves == Moves::oscillating, is_flat = follower.face == Face::flat;
        follower.radius = wanted(form, "radius", follower.face == Face::roller, true,
                                 {"the roller's radius", "il raggio della rotella"},
                                 {"only a roller has a radius", "solo una rotella ha un raggio"});
        follower.arm = wanted(form, "arm", oscillates && !is_flat, true,
                              {"from the pivot to the roller's centre, or to the edge",
                               "dal perno al centro della rotella, o al coltello"},
                              {"only an oscillating roller or edge has an arm",
                               "solo una rotella o un coltello oscillante ha un braccio"});
        follower.offset =
            wanted(form, "offset", oscillates == is_flat, false, {},
                   {"an offset is of a translating roller or edge, or of an "
                    "oscillating flat face",
                    "l’eccentricità è di una rotella o di un coltello che trasla, o di un piattello oscillante"});
        if (const JsonValue pivot = form["pivot"]; oscillates) {
            const Words where("where the follower turns, [x, y] from the cam's centre",
                              "dove ruota la punteria, [x, y] dal centro della camma");
            follower.pivot = vector(required(form, "pivot", where), QuantityKind::length, where).value_or(Vector{1, 0});
            if (follower.pivot.is_zero())
                fault(pivot, {"the pivot is the cam's own centre", "il perno è il centro stesso della camma"});
        } else if (pivot) {
            fault(pivot, {"only an oscillating follower has a pivot", "solo una punteria oscillante ha un perno"});
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
            fault(value, {"a cam's law goes over a whole turn; its pieces make {0}",
                          "la legge di una camma copre un giro intero; i suoi "
                          "tratti ne fanno {0}",
                          std::string(text.data())});
        }
        if (!end.is_zero())
            fault(value, {"after a whole turn the follower is where it began: the rises add up to zero",
                          "dopo un giro intero la punteria è dov’era all’inizio: le alzate hanno somma nulla"});
        if (sinks)
            fault(value, {"the law begins at its lowest: no rise leads below it",
                          "la legge inizia dal punto più basso: nessun tratto "
                          "scende sotto di esso"});
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
