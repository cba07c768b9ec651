// From the drawing of PMKS+ to a mechanism file: its names, its units, and a remark on everything that changes.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "app/library/import/pmks_link.hpp"
#include "app/library/state.hpp"
#include "engine/file/json_writer.hpp"
#include "engine/file/units.hpp"
#include "engine/number/exact.hpp"
#include "engine/number/functions.hpp"
#include "lang/keys/imports.hpp"

namespace kinegraph::app {
namespace {

/// The units of a drawing. Masses and forces follow from the unit of length.
struct PmksUnits {
    const char *length, *speed, *acceleration, *mass, *inertia, *force, *moment;
    bool in_pounds;
};
constexpr std::array<PmksUnits, 3> pmks_units{{
    // in the order of PmksDrawing::Length
    {"in", "in/s", "in/s²", "lb", "lb in²", "lbf", "lbf in", true},
    {"cm", "cm/s", "cm/s²", "g", "kg cm²", "N", "N cm", false},
    {"m", "m/s", "m/s²", "kg", "kg m²", "N", "N m", false},
}};

/// 1500 as 1.5.
std::string decimal(Thousandths value) {
    const Thousandths size = value < 0 ? -value : value;
    std::string text = std::to_string(size / 1000);
    if (size % 1000 != 0) {
        const std::string digits = std::to_string(size % 1000);
        text += '.' + std::string(3 - digits.size(), '0') + digits;
        text.erase(text.find_last_not_of('0') + 1);
    }
    return (value < 0 ? "-" : "") + text;
}

/// Two digits of a small length, without an exponent.
std::string two_digits(double value) {
    std::array<char, 64> text{};
    const int decimals = std::clamp(1 - static_cast<int>(std::floor(nearest::log10(value))), 0, 18);
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    return text.data();
}

/// Names as a mechanism file takes them, each once.
class Names {
public:
    /// `remarks` says what was renamed.
    std::string add(const std::string& name, const std::string& id, std::vector<Words>& remarks) {
        const std::string wanted = name.empty() ? id : name;
        std::string taken = add(wanted);
        if (taken != wanted) remarks.emplace_back(lang::imports::is_called_here, quoted(wanted), quoted(taken));
        return taken;
    }
    std::string add(const std::string& wanted) {
        std::string name;
        for (const char letter : wanted) {
            const auto code = static_cast<unsigned char>(letter);
            name += letter == ',' || code < 0x20 || code == 0x7f ? '_' : letter;
        }
        for (std::size_t at = name.find(" on "); at != std::string::npos; at = name.find(" on ", at))
            name.replace(at, 4, "_on_");
        if (names_.insert(name).second) return name;
        for (int number = 2;; ++number) {
            std::string numbered = name + '_' + std::to_string(number);
            if (names_.insert(numbered).second) return numbered;
        }
    }

private:
    std::set<std::string> names_;
};

struct FilePoint {
    std::string name;
    Thousandths x = 0, y = 0;
    std::string form;  ///< JSON, where it is not [x, y]
};
struct FileBody {
    std::string name;
    const PmksLink* link = nullptr;
    std::vector<std::size_t> points;
};
/// A pair of bodies that an input moves: `moved` relative to `reference`.
struct Input {
    std::size_t reference = 0, moved = 0;
    std::string slider;  ///< name of its joint; empty: it turns
};

/// The sections of the file, made one after the other.
class FileOfPmks {
public:
    explicit FileOfPmks(const PmksDrawing& drawing)
        : drawing_(drawing), units_(pmks_units.at(static_cast<std::size_t>(drawing.length))) {}

    /// Error: what makes no file.
    tl::expected<std::string, Words> text() {
        name_all();
        if (auto fault = put_slots_on_lines()) return tl::unexpected(*fault);
        for (std::size_t i = 0; i < drawing_.joints.size(); ++i) add_joint(i);
        add_masses();
        add_loads();
        add_efforts();
        remark_on_what_is_left_out();
        return written();
    }
    const std::vector<Words>& remarks() const { return remarks_; }

private:
    static constexpr std::size_t frame_body = 0;
    static constexpr auto on_lines = JsonWriter::Entries::on_lines;

    const std::string& point_name(std::size_t i) const { return points_[i].name; }
    const std::string& body_name(std::size_t i) const { return bodies_[i].name; }
    std::vector<std::string> point_names(const std::vector<std::size_t>& points) const {
        std::vector<std::string> names;
        for (const std::size_t point : points) names.push_back(point_name(point));
        return names;
    }
    Words length_words(double value) const { return decimal_words(two_digits(value) + ' ' + units_.length); }

    void name_all() {
        for (std::size_t i = 0; i < drawing_.joints.size(); ++i) {
            const PmksJoint& joint = drawing_.joints[i];
            points_.push_back({point_names_.add(joint.name, joint.id, remarks_), joint.x, joint.y, {}});
            joint_of_[joint.id] = i;
        }
        bodies_.push_back({body_names_.add("0"), nullptr, {}});
        std::map<std::string, const PmksLink*> links;
        for (const PmksLink& link : drawing_.links) links[link.id] = &link;
        for (const PmksLink& link : drawing_.links) {
            if (link.is_part) continue;
            const std::size_t body = bodies_.size();
            bodies_.push_back({body_names_.add(link.name, link.id, remarks_), &link, {}});
            body_of_[link.id] = body;
            for (const std::string& id : link.joints) bodies_[body].points.push_back(joint_of_[id]);
            std::string parts;
            for (const std::string& id : link.parts) {
                body_of_.emplace(id, body);
                parts += (parts.empty() ? "" : ", ") + (links[id]->name.empty() ? id : links[id]->name);
            }
            if (!parts.empty()) remarks_.emplace_back(lang::imports::are_one_body, parts, bodies_[body].name);
        }
        at_joint_.resize(points_.size());
        for (std::size_t body = 1; body < bodies_.size(); ++body)
            for (const std::size_t point : bodies_[body].points) at_joint_[point].push_back(body);
    }

    bool has_slot(const PmksJoint& joint) const { return joint.slides && body_of_.contains(joint.carrier); }

    /// Three decimals move the point of a slot, and with it the pin of its block, off the slot's line.
    std::optional<Words> put_slots_on_lines() {
        std::set<std::size_t> moved, lines;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const PmksJoint& joint = drawing_.joints[i];
            if (!has_slot(joint)) continue;
            const std::size_t a = joint_of_[joint.slot_a], b = joint_of_[joint.slot_b];
            const auto whole = [](Thousandths value) { return Exact::ratio(value, 1); };
            const Vector from{whole(points_[a].x), whole(points_[a].y)};
            const Vector along = Vector{whole(points_[b].x), whole(points_[b].y)} - from;
            const Vector to = Vector{whole(points_[i].x), whole(points_[i].y)} - from;
            if (along.is_zero())
                return Words(lang::imports::slot_has_no_length, quoted(points_[i].name), quoted(points_[a].name),
                             quoted(points_[b].name));
            const Exact across = cross(along, to);
            if (across.is_zero()) continue;
            constexpr double rounding =
                1.5;  // of the point and of both joints: 0.0005 in x and in y each, with a margin
            const double off = std::abs(across.to_double()) / length(along);
            const std::vector<std::size_t> pins = at_same_place(i);
            const bool is_used = std::any_of(
                pins.begin(), pins.end(), [&](std::size_t pin) { return lines.contains(pin) || pin == a || pin == b; });
            const bool stays = off > rounding || is_used || moved.contains(a) || moved.contains(b);
            remarks_.emplace_back(stays ? lang::imports::lies_off_its_slot : lang::imports::was_put_on_its_slot,
                                  points_[i].name, length_words(off / 1000), points_[a].name, points_[b].name);
            if (stays) continue;
            lines.insert({a, b});
            moved.insert(pins.begin(), pins.end());
            const std::string ratio = (dot(along, to) / squared_length(along)).to_fraction();
            for (const std::size_t pin : pins)
                points_[pin].form = JsonWriter()
                                        .open('{')
                                        .member("from", point_name(a))
                                        .member("to", point_name(b))
                                        .member("ratio", "= " + ratio)
                                        .close()
                                        .take();
        }
        return std::nullopt;
    }
    /// The joint and the other joints of its links at its place: the pin of its block.
    std::vector<std::size_t> at_same_place(std::size_t joint) const {
        std::set<std::size_t> same{joint};
        for (const std::size_t body : at_joint_[joint])
            for (const std::size_t point : bodies_[body].points)
                if (points_[point].x == points_[joint].x && points_[point].y == points_[joint].y) same.insert(point);
        return {same.begin(), same.end()};
    }

    /// Opens the pair, which may say more.
    JsonWriter& add_pair(const char* kind, std::size_t point, const std::vector<std::size_t>& bodies) {
        joints_.open('{').member(kind, point_name(point)).key("bodies").open('[');
        for (const std::size_t body : bodies) joints_.value(body_name(body));
        return joints_.close();
    }

    void add_joint(std::size_t i) {
        const PmksJoint& joint = drawing_.joints[i];
        std::vector<std::size_t> bodies;
        if (joint.is_ground && !joint.slides) bodies.push_back(frame_body);
        bodies.insert(bodies.end(), at_joint_[i].begin(), at_joint_[i].end());
        if (joint.slides) {
            add_slider(i, bodies);
        } else {
            if (bodies.size() > 1) connect(i, bodies, joint.is_welded);
            if (joint.is_ground && bodies.size() == 1)
                remarks_.emplace_back(lang::imports::joins_nothing, points_[i].name);
            if (joint.is_input) add_turning_driver(i, bodies);
        }
    }
    /// Bodies on one pin, or welded there.
    void connect(std::size_t point, const std::vector<std::size_t>& bodies, bool welded) {
        if (!welded) add_pair("revolute", point, bodies).close();
        for (std::size_t i = 1; welded && i < bodies.size(); ++i)
            add_pair("weld", point, {bodies[0], bodies[i]}).close();
    }
    void add_slider(std::size_t i, std::vector<std::size_t> bodies) {
        const PmksJoint& joint = drawing_.joints[i];
        const std::size_t carrier = has_slot(joint) ? body_of_[joint.carrier] : frame_body;
        std::erase(bodies, carrier);
        if (bodies.empty()) {
            remarks_.emplace_back(lang::imports::joins_nothing, points_[i].name);
            return;
        }
        JsonWriter& pair = add_pair("prismatic", i, {bodies[0], carrier}).key("along");
        if (has_slot(joint))
            pair.value(point_names({joint_of_[joint.slot_a], joint_of_[joint.slot_b]}));
        else
            pair.value(guide_angle(i));
        pair.close();
        if (bodies.size() > 1) {
            remarks_.emplace_back(lang::imports::several_slide, points_[i].name, bodies_[bodies[0]].name);
            add_pair(joint.is_welded ? "weld" : "revolute", i, {bodies[0], bodies[1]})
                .member("name", point_names_.add(points_[i].name + "_pin"))
                .close();
        }
        if (joint.is_input) add_sliding_driver(i, bodies[0], carrier);
    }
    /// Whole degrees where three decimals of a radian mean them.
    std::string guide_angle(std::size_t i) {
        const Thousandths angle = drawing_.joints[i].angle;
        const double degrees = std::round(static_cast<double>(angle) / 1000 * 180 / std::numbers::pi);
        const double difference = degrees * std::numbers::pi / 180 * 1000 - static_cast<double>(angle);
        std::string radians = decimal(angle) + " rad";
        if (std::abs(difference) > 0.5) return radians;
        std::string whole = std::to_string(static_cast<std::int64_t>(degrees)) + "°";
        if (angle != 0)
            remarks_.emplace_back(lang::imports::angle_is_taken_as, points_[i].name, decimal_words(radians),
                                  decimal_words(whole));
        return whole;
    }

    void add_turning_driver(std::size_t i, const std::vector<std::size_t>& bodies) {
        const PmksJoint& joint = drawing_.joints[i];
        if (bodies.size() < 2 || joint.is_welded) {
            remarks_.emplace_back(lang::imports::moves_nothing, points_[i].name);
            return;
        }
        if (bodies.size() > 2)
            remarks_.emplace_back(lang::imports::which_body_turns, points_[i].name, bodies_[bodies[1]].name);
        const Thousandths general = drawing_.input_speed * 1000 * (drawing_.turns_clockwise ? -1 : 1);
        const Thousandths speed = joint.speed.value_or(0) != 0 ? *joint.speed : general;
        inputs_.push_back({bodies[0], bodies[1], {}});
        drivers_.open('{').member("body", body_name(bodies[1])).member("omega", decimal(speed) + " rpm");
        if (bodies[0] != frame_body) drivers_.member("relative to", body_name(bodies[0]));
        drivers_.close();
    }
    void add_sliding_driver(std::size_t i, std::size_t rider, std::size_t carrier) {
        const PmksJoint& joint = drawing_.joints[i];
        constexpr Thousandths usual = 5000;
        const bool is_own = joint.speed.value_or(0) != 0;
        if (!is_own && !drawing_.slider_speed)
            remarks_.emplace_back(lang::imports::slider_has_no_speed, points_[i].name,
                                  decimal_words(decimal(usual) + ' ' + units_.speed));
        const Thousandths general = drawing_.slider_speed.value_or(usual) * (drawing_.turns_clockwise ? -1 : 1);
        const Thousandths speed = is_own ? *joint.speed : general;
        inputs_.push_back({carrier, rider, points_[i].name});
        drivers_.open('{').member("joint", point_name(i)).key("speed").json(decimal(speed)).close();
    }

    /// The point of the body there, which is added where there is none.
    std::size_t point_at(std::size_t body, Thousandths x, Thousandths y, const std::string& name) {
        for (const std::size_t point : bodies_[body].points)
            if (points_[point].x == x && points_[point].y == y && points_[point].form.empty()) return point;
        points_.push_back({point_names_.add(name), x, y, {}});
        bodies_[body].points.push_back(points_.size() - 1);
        return points_.size() - 1;
    }

    void add_masses() {
        for (std::size_t body = 1; body < bodies_.size(); ++body) {
            const PmksLink& link = *bodies_[body].link;
            if (link.mass == 0 && link.inertia == 0) continue;
            if (link.mass < 0 || link.inertia < 0 || (link.is_piston && bodies_[body].points.empty())) {
                remarks_.emplace_back(lang::imports::mass_is_left_out, bodies_[body].name);
                continue;
            }
            const std::size_t centre = link.is_piston
                                           ? bodies_[body].points.front()
                                           : point_at(body, link.centre_x, link.centre_y, "G_" + bodies_[body].name);
            masses_.key(body_name(body)).open('{').key("mass").json(decimal(link.mass));
            masses_.member("centre", point_name(centre));
            if (link.inertia > 0 && !link.is_piston) masses_.key("inertia").json(decimal(link.inertia));
            masses_.close();
        }
    }

    void add_loads() {
        for (const PmksForce& force : drawing_.forces) {
            const std::string name = load_names_.add(force.name, force.id, remarks_);
            const Thousandths sense = force.faces_out ? 1 : -1;
            const Thousandths dx = sense * (force.to_x - force.from_x), dy = sense * (force.to_y - force.from_y);
            const auto found = body_of_.find(force.link);
            if (found == body_of_.end() || (dx == 0 && dy == 0)) {
                remarks_.emplace_back(lang::imports::force_is_left_out, name);
                continue;
            }
            const std::size_t body = found->second, at = point_at(body, force.from_x, force.from_y, "P_" + name);
            loads_.open('{').member("force", name).member("body", body_name(body)).member("at", point_name(at));
            loads_.key("magnitude").json(decimal(force.magnitude)).key("along");
            if (force.turns_with_link)
                loads_.value(point_names({at, point_at(body, force.from_x + dx, force.from_y + dy, "Q_" + name)}));
            else
                loads_.open('[').json(decimal(dx)).json(decimal(dy)).close();
            loads_.close();
        }
        if (drawing_.forces_in_pounds != units_.in_pounds && !loads_.is_empty())
            remarks_.emplace_back(lang::imports::forces_are_in, std::string(units_.length), std::string(units_.force));
    }
    /// An input that forces act against has a couple or a force of its own.
    void add_efforts() {
        if (loads_.is_empty() && (!drawing_.has_gravity || masses_.is_empty())) return;
        for (const Input& input : inputs_) {
            const bool turns = input.slider.empty();
            efforts_.open('{').member(turns ? "couple" : "force", load_names_.add(turns ? "M" : "F"));
            efforts_.member(turns ? "body" : "joint", turns ? body_name(input.moved) : input.slider);
            if (turns && input.reference != frame_body) efforts_.member("from", body_name(input.reference));
            efforts_.close();
        }
    }

    void remark_on_what_is_left_out() {
        const PmksLeftOut& left = drawing_.left_out;
        struct Kind {
            int count;
            Key remark;
        };
        for (const Kind& each :
             {Kind{left.locks, lang::imports::locks_left_out}, Kind{left.anchors, lang::imports::anchors_left_out},
              Kind{left.poses, lang::imports::synthesis_left_out}, Kind{left.colours, lang::imports::colours_left_out},
              Kind{left.unknown, lang::imports::entries_left_out}})
            if (each.count > 0) remarks_.emplace_back(each.remark);
        for (const PmksLink& each : drawing_.links)
            if (each.is_part && !body_of_.contains(each.id))
                remarks_.emplace_back(lang::imports::part_is_left_out, each.name.empty() ? each.id : each.name);
        remarks_.emplace_back(lang::imports::look_is_left_out);
    }

    /// Where the drawing is too small for it, the reader would refuse a precision of half a thousandth.
    std::optional<std::string> precision() {
        const auto [left, right] =
            std::minmax_element(points_.begin(), points_.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
        const auto [low, high] =
            std::minmax_element(points_.begin(), points_.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
        constexpr Thousandths least_size = 50;
        const std::string rounding = std::string("0.0005 ") + units_.length;
        const bool fits = std::max(right->x - left->x, high->y - low->y) >= least_size;
        remarks_.insert(remarks_.begin(), Words(fits ? lang::imports::has_three_decimals : lang::imports::is_too_small,
                                                decimal_words(rounding)));
        return fits ? std::optional(rounding) : std::nullopt;
    }

    std::string written() {
        JsonWriter json;
        json.open('{', on_lines).member("kinegraph", 1).key("units").open('{').member("length", units_.length);
        json.member("velocity", units_.speed).member("acceleration", units_.acceleration);
        json.member("mass", units_.mass).member("inertia", units_.inertia).member("force", units_.force);
        json.member("moment", units_.moment).close();
        if (const auto rounding = precision()) json.member("precision", *rounding);
        json.member("frame", body_name(frame_body)).key("points").open('{', on_lines);
        for (const FilePoint& each : points_) {
            json.key(each.name);
            if (each.form.empty())
                json.open('[').json(decimal(each.x)).json(decimal(each.y)).close();
            else
                json.json(each.form);
        }
        json.close().key("bodies").open('{', on_lines);
        for (std::size_t body = 1; body < bodies_.size(); ++body)
            json.member(body_name(body), point_names(bodies_[body].points));
        json.close().member("joints", joints_.close());
        if (!drivers_.is_empty()) json.member("drivers", drivers_.close());
        if (!masses_.is_empty()) json.member("masses", masses_.close());
        if (drawing_.has_gravity) json.key("gravity").open('[').values(0, "-9.81 m/s²").close();
        if (!loads_.is_empty()) json.member("loads", loads_.close());
        if (!efforts_.is_empty()) json.member("effort", efforts_.close());
        return json.close().take() + '\n';
    }

    /// A section of the file, open.
    static JsonWriter section(char bracket) {
        return JsonWriter(JsonWriter::Style::document, 1).open(bracket, on_lines);
    }

    const PmksDrawing& drawing_;
    const PmksUnits& units_;
    std::vector<Words> remarks_;
    Names point_names_, body_names_, load_names_;
    std::vector<FilePoint> points_;                   ///< of joints first, by their index
    std::vector<FileBody> bodies_;                    ///< the frame first
    std::map<std::string, std::size_t> joint_of_;     ///< by id
    std::map<std::string, std::size_t> body_of_;      ///< by id of a link, or of one welded into it
    std::vector<std::vector<std::size_t>> at_joint_;  ///< by joint: its bodies, in the order of the links
    std::vector<Input> inputs_;
    JsonWriter joints_ = section('['), drivers_ = section('['), masses_ = section('{'), loads_ = section('['),
               efforts_ = section('[');
};

}  // namespace
}  // namespace kinegraph::app

namespace kinegraph {

Expected<Imported> import_pmks(std::string_view link) {
    const auto drawing = app::read_pmks(link);
    if (!drawing) return refused(Diagnostic::Kind::bad_input, drawing.error());
    app::FileOfPmks file(*drawing);
    auto text = file.text();
    if (!text) return refused(Diagnostic::Kind::bad_input, text.error());
    if (const auto read = MechanismFile::parse(*text, {}); !read)
        return refused(Diagnostic::Kind::bad_input, Words(lang::imports::makes_no_file, read.error().front().place,
                                                          Words(read.error().front().text)));
    return Imported{*std::move(text), texts_of(file.remarks())};
}

}  // namespace kinegraph
