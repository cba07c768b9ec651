// diff EXPECTED ACTUAL: reads two pictures, compares them, says by how much they differ and shows it.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "app/commands.hpp"
#include "app/files.hpp"
#include "app/svg_picture.hpp"
#include "render/backends/picture_difference.hpp"

namespace kinegraph::app {
namespace {

using render::Picture;
using render::PictureDifference;

/// Begins like XML, perhaps after a byte order mark.
bool may_be_svg(std::string_view bytes) {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && bytes[first] == '<';
}

/// One of the two: its bytes, and the picture as soon as it is known.
struct Side {
    std::string name, bytes;
    std::optional<Picture> picture;
};

Status fails(const Side& side, const std::string& why, Status status = Status::bad_input) {
    say(side.name, why);
    return status;
}

/// The bytes, and what they show if that is a PNG.
Status read(Side& side, const std::string& path) {
    side.name = spoken(path);
    auto bytes = read_whole(path, "picture");
    if (!bytes) return fails(side, bytes.error());
    side.bytes = *std::move(bytes);
    if (!render::is_png(side.bytes)) {
        if (!may_be_svg(side.bytes)) return fails(side, "is neither PNG nor SVG");
        return Status::done;
    }
    auto picture = render::decode_png(side.bytes);
    if (!picture) return fails(side, picture.error());
    side.picture = *std::move(picture);
    return Status::done;
}

Status draw(Side& side, double dpi) {
    const auto png = svg_to_png(side.bytes, dpi);
    if (!png) return fails(side, png.error().why, png.error().status);
    auto picture = render::decode_png(*png);
    if (!picture) return fails(side, "drawn at " + std::to_string(std::lround(dpi)) + " dpi " + picture.error());
    side.picture = *std::move(picture);
    return Status::done;
}

/// Up to six decimals, the same in every locale.
std::string digits(double value) {
    char text[32];
    std::string written(text, std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 6).ptr);
    written.erase(written.find_last_not_of('0') + 1);
    if (written.ends_with('.')) written.pop_back();
    return written;
}

std::string size_of(const Picture& picture) { return std::to_string(picture.width) + " × " + std::to_string(picture.height); }

/// What was found, as one line.
std::string verdict(const Side& expected, const Side& actual, const PictureDifference& difference, double threshold) {
    std::string line = one_line(expected.name) + ", " + one_line(actual.name) + ": ";
    const Picture &a = *expected.picture, &b = *actual.picture;
    if (a.width != b.width || a.height != b.height) line += size_of(a) + " pixels became " + size_of(b) + "; ";
    if (difference.differing == 0) {
        line += "the same";
        if (difference.forgiven > 0) line += " but for antialiasing (" + std::to_string(difference.forgiven) + " pixels)";
    } else {
        line += digits(100 * difference.share()) + " % of the pixels differ (" + std::to_string(difference.differing) + " of " +
                std::to_string(difference.verdicts.size()) + "), columns " + std::to_string(difference.left) + " to " +
                std::to_string(difference.right) + ", rows " + std::to_string(difference.top) + " to " +
                std::to_string(difference.bottom);
        if (difference.forgiven > 0) line += "; " + std::to_string(difference.forgiven) + " more by antialiasing alone";
        if (threshold > 0) line += "; " + digits(100 * threshold) + " % may";
    }
    return line + '\n';
}

}  // namespace

Status diff_command(const DiffRequest& request) {
    if (request.expected == "-" && request.actual == "-") {
        say("kinegraph", "standard input can be one of the two pictures only");
        return Status::bad_input;
    }
    if (request.output == "-") {
        say("kinegraph", "the difference picture needs a file: standard output carries the verdict");
        return Status::bad_input;
    }
    for (const std::string& picture : {request.expected, request.actual})
        if (!request.output.empty() && same_file(request.output, picture)) {
            say("kinegraph", "-o " + request.output + " would overwrite a picture that is compared");
            return Status::bad_input;
        }
    Side expected, actual;
    if (const Status status = read(expected, request.expected); status != Status::done) return status;
    if (const Status status = read(actual, request.actual); status != Status::done) return status;
    double dpi = request.dpi;
    for (const Side* side : {&expected, &actual})
        if (dpi == 0 && side->picture && side->picture->dpi) dpi = std::min(*side->picture->dpi, 1200.0);
    if (dpi == 0) dpi = 150;
    for (Side* side : {&expected, &actual})
        if (!side->picture)
            if (const Status status = draw(*side, dpi); status != Status::done) return status;

    const PictureDifference difference = render::compare(*expected.picture, *actual.picture, request.tolerance);
    std::vector<Output> outputs{{"-", verdict(expected, actual, difference, request.threshold)}};
    if (!request.output.empty())
        outputs.push_back({request.output, encode_png(render::side_by_side(*expected.picture, *actual.picture, difference))});
    if (const auto failure = write_all(outputs)) {
        say(failure->path == "-" ? "standard output" : failure->path, "cannot be written: " + failure->why);
        return Status::output;
    }
    const bool same_size = expected.picture->width == actual.picture->width && expected.picture->height == actual.picture->height;
    return same_size && difference.share() <= request.threshold ? Status::done : Status::difference;
}

}  // namespace kinegraph::app
