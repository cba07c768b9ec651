// diff EXPECTED ACTUAL: compares two pictures, reports by how much they differ and draws the difference.
#include <kinegraph/picture.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>

#include "app/commands/commands.hpp"
#include "app/files/files.hpp"
#include "app/files/svg_picture.hpp"
#include "lang/keys/command_line.hpp"
#include "lang/keys/notation.hpp"

namespace kinegraph::app {
namespace {

/// True if the text begins like XML, possibly after a byte order mark.
bool may_be_svg(std::string_view bytes) {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && bytes[first] == '<';
}

/// One of the two inputs: its bytes, and the picture once decoded.
struct Side {
    Words name;
    std::string bytes;
    std::optional<PngPicture> picture;
    Language language = Language::en;
};

Status fails(const Side& side, const Words& why, Status status = Status::bad_input) {
    say(side.name, why, side.language);
    return status;
}

/// Reads the bytes, and decodes them if they are a PNG.
Status read_side(Side& side, const std::string& path) {
    side.name = spoken(path);
    auto bytes = read_whole(path, {lang::command_line::picture});
    if (!bytes) return fails(side, bytes.error());
    side.bytes = *std::move(bytes);
    if (!PngPicture::is_png(side.bytes)) {
        if (!may_be_svg(side.bytes)) return fails(side, {lang::command_line::is_neither_png_nor_svg});
        return Status::done;
    }
    auto picture = PngPicture::decode(side.bytes);
    if (!picture) return fails(side, picture.error().front().text);
    side.picture = *std::move(picture);
    return Status::done;
}

Status draw(Side& side, double dpi) {
    const auto png = svg_to_png(side.bytes, dpi);
    if (!png) return fails(side, png.error().why, png.error().status);
    auto picture = PngPicture::decode(*png);
    if (!picture)
        return fails(
            side, {lang::command_line::drawn_at_dpi, std::to_string(std::lround(dpi)), picture.error().front().text});
    side.picture = *std::move(picture);
    return Status::done;
}

/// At most six decimals, independent of the locale.
std::string digits(double value) {
    char text[32];
    std::string written(text, std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 6).ptr);
    written.erase(written.find_last_not_of('0') + 1);
    if (written.ends_with('.')) written.pop_back();
    return written;
}

std::string size_of(const PngPicture& picture) {
    return std::to_string(picture.width()) + " × " + std::to_string(picture.height());
}

bool have_same_size(const PngPicture& a, const PngPicture& b) {
    return a.width() == b.width() && a.height() == b.height();
}

/// The result as one line.
std::string verdict(const Side& expected, const Side& actual, const PictureComparison& difference, double threshold) {
    const Language language = expected.language;
    Words line(one_line(in(expected.name, language)) + ", " + one_line(in(actual.name, language)));
    line += lang::notation::colon;
    const PngPicture &a = *expected.picture, &b = *actual.picture;
    const auto text = [](auto number) { return std::to_string(number); };
    if (!have_same_size(a, b)) line += {lang::command_line::pixels_became, size_of(a), size_of(b)};
    if (difference.differing == 0) {
        line += {lang::command_line::the_same};
        if (difference.forgiven > 0)
            line += {lang::command_line::but_for_antialiasing_pixels, text(difference.forgiven)};
    } else {
        line += {lang::command_line::of_the_pixels_differ_of_columns,
                 decimal_words(digits(100 * difference.share())),
                 text(difference.differing),
                 text(static_cast<long>(difference.width) * difference.height),
                 text(difference.left),
                 text(difference.right),
                 text(difference.top),
                 text(difference.bottom)};
        if (difference.forgiven > 0)
            line += {lang::command_line::more_by_antialiasing_alone, text(difference.forgiven)};
        if (threshold > 0) line += {lang::command_line::share_allowed, digits(100 * threshold)};
    }
    return in(line, language) + '\n';
}

}  // namespace

Status diff_command(const DiffRequest& request) {
    const Language language = request.language;
    if (request.expected == "-" && request.actual == "-")
        return refuse({lang::command_line::standard_input_can_be_one_of}, language);
    if (request.output == "-") return refuse({lang::command_line::the_difference_picture_needs_a_file}, language);
    if (const auto ending = std::filesystem::path(request.output).extension(); !ending.empty() && ending != ".png")
        return refuse({lang::command_line::the_difference_picture_is_a_png, request.output}, language);
    for (const std::string& picture : {request.expected, request.actual})
        if (!request.output.empty() && same_file(request.output, picture))
            return refuse({lang::command_line::o_would_overwrite_a_picture, request.output}, language);
    Side expected, actual;
    expected.language = actual.language = language;
    if (const Status status = read_side(expected, request.expected); status != Status::done) return status;
    if (const Status status = read_side(actual, request.actual); status != Status::done) return status;
    double dpi = request.dpi;
    for (const Side* side : {&expected, &actual})
        if (dpi == 0 && side->picture && side->picture->dpi()) dpi = std::min(*side->picture->dpi(), 1200.0);
    if (dpi == 0) dpi = 150;
    for (Side* side : {&expected, &actual})
        if (!side->picture)
            if (const Status status = draw(*side, dpi); status != Status::done) return status;

    const PictureComparison difference =
        compare_pictures(*expected.picture, *actual.picture, request.tolerance, !request.output.empty());
    std::vector<Output> outputs{{"-", verdict(expected, actual, difference, request.threshold)}};
    if (!request.output.empty()) outputs.push_back({request.output, difference.side_by_side});
    if (const auto failure = write_all(outputs)) return fail_to_write(*failure, language);
    return have_same_size(*expected.picture, *actual.picture) && difference.share() <= request.threshold
               ? Status::done
               : Status::difference;
}

}  // namespace kinegraph::app
