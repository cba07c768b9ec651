// The text of a link of PMKS+. Sections are separated by dots, fields by commas; numbers are whole, in base 64.
#include "app/library/import/pmks_link.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "engine/file/units.hpp"
#include "lang/keys/imports.hpp"
#include "render/text/utf8.hpp"

namespace kinegraph::app {
namespace {

constexpr std::string_view base_64 = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";
constexpr std::size_t base_of_checksum = 62;

template <class Value>
using Read = tl::expected<Value, Words>;

tl::unexpected<Words> unreadable(Words why) { return tl::unexpected(std::move(why)); }

std::vector<std::string> parted(std::string_view text, char by) {
    std::vector<std::string> parts(1);
    for (const char letter : text) {
        if (letter == by)
            parts.emplace_back();
        else
            parts.back() += letter;
    }
    return parts;
}

int hex_digit(char letter) {
    if (letter >= '0' && letter <= '9') return letter - '0';
    if (letter >= 'a' && letter <= 'f') return letter - 'a' + 10;
    return letter >= 'A' && letter <= 'F' ? letter - 'A' + 10 : -1;
}

/// With %41 as A. A percent sign without two digits stays.
std::string without_percent_codes(std::string_view text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool coded =
            text[i] == '%' && i + 2 < text.size() && hex_digit(text[i + 1]) >= 0 && hex_digit(text[i + 2]) >= 0;
        plain += coded ? static_cast<char>(hex_digit(text[i + 1]) * 16 + hex_digit(text[i + 2])) : text[i];
        if (coded) i += 2;
    }
    return plain;
}

/// Without the address, line breaks, and the blanks, quotes and angle brackets that mail puts round a link.
std::string data_of(std::string_view text) {
    std::string data(text.substr(text.find('?') == std::string_view::npos ? 0 : text.find('?') + 1));
    std::erase_if(data, [](char letter) { return letter == '\n' || letter == '\r'; });
    constexpr std::string_view round = " \t\"'<>";
    data.erase(0, std::min(data.find_first_not_of(round), data.size()));
    data.erase(data.find_last_not_of(round) + 1);
    return without_percent_codes(data);
}

/// The count of UTF-16 units, by which JavaScript counts; none where the text is no UTF-8.
std::optional<std::size_t> units_of_utf_16(std::string_view text) {
    std::size_t units = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t before = at;
        const char32_t code = render::next_code_point(text, at);
        if (code == render::replacement_character && at - before < 3) return std::nullopt;
        units += code > 0xFFFF ? 2 : 1;
    }
    return units;
}

/// A number of at most eight digits. "0" before further digits stands for a minus.
std::optional<std::int64_t> number_in(std::string_view text) {
    constexpr std::size_t most_digits = 8;
    const bool negative = text.size() > 1 && text[0] == '0';
    const std::string_view digits = text.substr(negative ? 1 : 0);
    if (digits.empty() || digits.size() > most_digits) return std::nullopt;
    std::int64_t value = 0;
    for (const char letter : digits) {
        const std::size_t digit = base_64.find(letter);
        if (digit == std::string_view::npos) return std::nullopt;
        value = value * 64 + static_cast<std::int64_t>(digit);
    }
    return negative ? -value : value;
}

/// Flags, the lowest bit first; the leading zeros of the number are no signs.
std::optional<std::uint32_t> flags_in(std::string_view text) {
    std::uint32_t value = 0;
    if (text.empty() || text.size() > 4) return std::nullopt;
    for (const char letter : text) {
        const std::size_t digit = base_64.find(letter);
        if (digit == std::string_view::npos) return std::nullopt;
        value = value * 64 + static_cast<std::uint32_t>(digit);
    }
    return value;
}
bool has_bit(std::uint32_t flags, int bit) { return (flags >> bit & 1U) != 0; }

/// The fields of one entry. The first fault stays.
class Fields {
public:
    Fields(Words entry, std::string_view text) : entry_(std::move(entry)), fields_(parted(text, ',')) {}

    std::size_t size() const { return fields_.size(); }
    const std::string& text(std::size_t i) const { return fields_[i]; }
    Thousandths number(std::size_t i) {
        const auto value = number_in(fields_[i]);
        if (!value && !fault_) fault_ = Words(lang::imports::is_no_number, entry_, quoted(fields_[i]));
        return value.value_or(0);
    }
    const std::optional<Words>& fault() const { return fault_; }
    Words too_few() const { return {lang::imports::has_fields, entry_, std::to_string(fields_.size())}; }

private:
    Words entry_;
    std::vector<std::string> fields_;
    std::optional<Words> fault_;
};

Read<PmksJoint> joint_in(std::string_view text, std::size_t index) {
    const Words entry(lang::imports::joint_entry, std::to_string(index + 1));
    const auto flags = flags_in(text.substr(0, 1));
    Fields fields(entry, text.substr(1));
    if (fields.size() != 5 && fields.size() != 8 && fields.size() != 9) return unreadable(fields.too_few());
    if (!flags) return unreadable({lang::imports::has_no_flag, entry, quoted(text.substr(0, 1))});
    PmksJoint joint;
    joint.slides = has_bit(*flags, 0);
    joint.is_input = has_bit(*flags, 1);
    joint.is_ground = has_bit(*flags, 2);
    joint.is_welded = has_bit(*flags, 3);
    joint.id = fields.text(0);
    joint.name = fields.text(1);
    joint.x = fields.number(2);
    joint.y = fields.number(3);
    joint.angle = fields.number(4);
    if (fields.size() > 5) {
        joint.carrier = fields.text(5);
        joint.slot_a = fields.text(6);
        joint.slot_b = fields.text(7);
    }
    if (fields.size() == 9) joint.speed = fields.number(8);
    if (fields.fault()) return unreadable(*fields.fault());
    return joint;
}

Read<PmksLink> link_in(std::string_view text, std::size_t index) {
    const Words entry(lang::imports::link_entry, std::to_string(index + 1));
    constexpr std::string_view roots = "YAMG", parts = "Namg", discs = "01234567";
    const char kind = text.empty() ? ' ' : text[0], material = text.size() < 2 ? ' ' : text[1];
    const bool is_known = roots.find(kind) != std::string_view::npos || parts.find(kind) != std::string_view::npos ||
                          discs.find(kind) != std::string_view::npos;
    if (!is_known || (material != 'R' && material != 'P'))
        return unreadable({lang::imports::is_of_no_known_kind, entry, quoted(text.substr(0, 2))});
    Fields fields(entry, text.substr(2));
    if (fields.size() < 8) return unreadable(fields.too_few());
    PmksLink link;
    link.is_piston = material == 'P';
    link.is_part = parts.find(kind) != std::string_view::npos;
    link.id = fields.text(0);
    link.name = fields.text(1);
    link.mass = fields.number(2);
    link.inertia = fields.number(3);
    link.centre_x = fields.number(4);
    link.centre_y = fields.number(5);
    if (fields.fault()) return unreadable(*fields.fault());
    std::size_t i = 7;  // behind the colour
    for (; i < fields.size() && !fields.text(i).empty(); ++i) link.joints.push_back(fields.text(i));
    for (; i < fields.size(); ++i)
        if (!fields.text(i).empty()) link.parts.push_back(fields.text(i));
    return link;
}

Read<PmksForce> force_in(std::string_view text, std::size_t index) {
    const Words entry(lang::imports::force_entry, std::to_string(index + 1));
    const auto flags = flags_in(text.substr(0, 1));
    Fields fields(entry, text.substr(1));
    if (fields.size() != 8) return unreadable(fields.too_few());
    if (!flags) return unreadable({lang::imports::has_no_flag, entry, quoted(text.substr(0, 1))});
    PmksForce force;
    force.turns_with_link = has_bit(*flags, 0);
    force.faces_out = has_bit(*flags, 1);
    force.id = fields.text(0);
    force.link = fields.text(1);
    force.name = fields.text(2);
    force.from_x = fields.number(3);
    force.from_y = fields.number(4);
    force.to_x = fields.number(5);
    force.to_y = fields.number(6);
    force.magnitude = fields.number(7);
    if (fields.fault()) return unreadable(*fields.fault());
    return force;
}

/// The sections of a link, in their order.
class Sections {
public:
    explicit Sections(std::string_view data) : sections_(parted(data, '.')) {}

    bool at_end() const { return next_ == sections_.size(); }
    const std::string& take() { return sections_[next_++]; }
    std::size_t left() const { return sections_.size() - next_; }

    /// The entries up to an empty one. `needs_end`: the empty one must be there.
    template <class Entry>
    std::optional<Words> list(Read<Entry> (*read)(std::string_view, std::size_t), std::vector<Entry>& entries,
                              bool needs_end) {
        while (!at_end() && !sections_[next_].empty()) {
            auto entry = read(take(), entries.size());
            if (!entry) return entry.error();
            entries.push_back(*std::move(entry));
        }
        if (at_end()) return needs_end ? std::optional(Words(lang::imports::sections_are_missing)) : std::nullopt;
        take();
        return std::nullopt;
    }

private:
    std::vector<std::string> sections_;
    std::size_t next_ = 0;
};

std::optional<Words> read_settings(Sections& sections, PmksDrawing& drawing) {
    constexpr std::size_t settings = 4;
    if (sections.left() < settings) return Words(lang::imports::sections_are_missing);
    const Words entry(lang::imports::settings);
    const std::string& flag_text = sections.take();
    const auto flags = flags_in(flag_text);
    if (!flags) return Words(lang::imports::has_no_flag, entry, quoted(flag_text));
    drawing.turns_clockwise = has_bit(*flags, 0);
    drawing.has_gravity = has_bit(*flags, 1);
    Fields decimals(entry, sections.take());
    if (decimals.size() > 1) drawing.slider_speed = decimals.number(1);
    Fields integers(entry, sections.take());
    drawing.input_speed = integers.number(0);
    for (const Fields* each : {&decimals, &integers})
        if (each->fault()) return each->fault();
    const std::string& units = sections.take();
    const char length = units.empty() ? ' ' : units[0], force = units.size() < 3 ? ' ' : units[2];
    if (length < '0' || length > '2' || (force != '0' && force != '1'))
        return Words(lang::imports::units_are_unknown, quoted(units));
    drawing.length = static_cast<PmksDrawing::Length>(length - '0');
    drawing.forces_in_pounds = force == '0';
    return std::nullopt;
}

void read_trailing(Sections& sections, PmksLeftOut& left_out) {
    if (!sections.at_end()) sections.take();  // what was selected
    while (!sections.at_end()) {
        const std::string& section = sections.take();
        if (section.starts_with('S')) {
            ++left_out.poses;
            continue;
        }
        for (const std::string& entry : parted(section, ',')) {
            if (entry.starts_with("CG") || entry.starts_with("CJ"))
                ++left_out.anchors;
            else if (entry.starts_with('J') || entry.starts_with('L') || entry.starts_with('F'))
                ++left_out.locks;
            else if (entry.starts_with('K'))
                ++left_out.colours;
            else if (!entry.empty())
                ++left_out.unknown;
        }
    }
}

/// That ids are there once and that what refers to them finds them.
class References {
public:
    explicit References(const PmksDrawing& drawing) : drawing_(drawing) {
        for (const PmksJoint& each : drawing.joints)
            need(!each.id.empty() && joints_.insert(each.id).second,
                 {lang::imports::stands_twice, Words(lang::imports::joint_named, quoted(each.id))});
        for (const PmksLink& each : drawing.links)
            need(!each.id.empty() && links_.emplace(each.id, &each).second,
                 {lang::imports::stands_twice, Words(lang::imports::link_named, quoted(each.id))});
    }

    std::optional<Words> fault() {
        for (const PmksLink& each : drawing_.links) check_link(each);
        for (const PmksJoint& each : drawing_.joints) check_slot(each);
        for (const PmksForce& each : drawing_.forces)
            need(links_.contains(each.link),
                 {lang::imports::names_what_is_missing, Words(lang::imports::force_named, quoted(each.id)),
                  Words(lang::imports::link_named, quoted(each.link))});
        return fault_;
    }

private:
    void need(bool holds, const Words& message) {
        if (!holds && !fault_) fault_ = message;
    }
    void check_link(const PmksLink& link) {
        const Words name(lang::imports::link_named, quoted(link.id));
        std::set<std::string> seen;
        for (const std::string& id : link.joints) {
            const Words joint(lang::imports::joint_named, quoted(id));
            need(joints_.contains(id), {lang::imports::names_what_is_missing, name, joint});
            need(seen.insert(id).second, {lang::imports::stands_twice, joint});
        }
        for (const std::string& id : link.parts)
            need(links_.contains(id) && id != link.id,
                 {lang::imports::names_what_is_missing, name, Words(lang::imports::link_named, quoted(id))});
    }
    void check_slot(const PmksJoint& joint) {
        if (joint.carrier.empty() && joint.slot_a.empty() && joint.slot_b.empty()) return;
        const Words name(lang::imports::joint_named, quoted(joint.id));
        const auto carrier = links_.find(joint.carrier);
        need(carrier != links_.end(),
             {lang::imports::names_what_is_missing, name, Words(lang::imports::link_named, quoted(joint.carrier))});
        if (carrier == links_.end()) return;
        const auto carries = [&](const std::string& id) {
            const std::vector<std::string>& joints = carrier->second->joints;
            return std::find(joints.begin(), joints.end(), id) != joints.end();
        };
        need(carries(joint.slot_a) && carries(joint.slot_b) && joint.slot_a != joint.slot_b &&
                 joint.slot_a != joint.id && joint.slot_b != joint.id,
             {lang::imports::slot_has_no_line, name, quoted(joint.carrier)});
    }

    const PmksDrawing& drawing_;
    std::set<std::string> joints_;
    std::map<std::string, const PmksLink*> links_;
    std::optional<Words> fault_;
};

Read<std::string> checked_data(std::string_view text) {
    std::string data = data_of(text);
    constexpr std::size_t least_dots = 5;
    if (static_cast<std::size_t>(std::count(data.begin(), data.end(), '.')) < least_dots)
        return unreadable({lang::imports::is_no_link});
    constexpr std::size_t most = std::size_t{1} << 18;
    if (data.size() > most) return unreadable({lang::imports::is_too_long, std::to_string(most)});
    const char last = data.back();
    data.pop_back();
    const auto units = units_of_utf_16(data);
    if (!units) return unreadable({lang::imports::is_no_utf_8});
    const char wanted = base_64[*units % base_of_checksum];
    if (last != wanted)
        return unreadable({lang::imports::checksum_differs, std::to_string(*units), std::string(1, wanted),
                           quoted(std::string_view(&last, 1))});
    return data;
}

}  // namespace

tl::expected<PmksDrawing, Words> read_pmks(std::string_view text) {
    const auto data = checked_data(text);
    if (!data) return tl::unexpected(data.error());
    Sections sections(*data);
    PmksDrawing drawing;
    if (auto fault = read_settings(sections, drawing)) return tl::unexpected(*fault);
    if (auto fault = sections.list(joint_in, drawing.joints, true)) return tl::unexpected(*fault);
    if (auto fault = sections.list(link_in, drawing.links, true)) return tl::unexpected(*fault);
    if (auto fault = sections.list(force_in, drawing.forces, false)) return tl::unexpected(*fault);
    read_trailing(sections, drawing.left_out);
    if (drawing.links.empty() || drawing.joints.empty()) return tl::unexpected(Words(lang::imports::has_no_links));
    if (auto fault = References(drawing).fault()) return tl::unexpected(*fault);
    std::set<std::string> parts;
    for (const PmksLink& each : drawing.links) parts.insert(each.parts.begin(), each.parts.end());
    for (PmksLink& each : drawing.links) each.is_part = each.is_part || parts.contains(each.id);
    return drawing;
}

}  // namespace kinegraph::app
