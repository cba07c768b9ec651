// Draws an SVG by rsvg-convert.
#include "app/files/svg_picture.hpp"

#include <cstring>
#include <string>
#include <utility>

#include "app/files/child.hpp"
#include "lang/keys/command_line.hpp"

namespace kinegraph::app {

tl::expected<std::string, NotDrawn> svg_to_png(const std::string& svg, double dpi) {
    const std::string resolution = std::to_string(dpi);
    const std::string* next = &svg;
    auto answer = run_child(
        {"rsvg-convert", "--format", "png", "--accept-language", "en", "--dpi-x", resolution, "--dpi-y", resolution},
        {}, [&] { return std::exchange(next, nullptr); });
    if (!answer)
        return tl::unexpected(
            NotDrawn{Status::output,
                     {lang::command_line::rsvg_convert_cannot_be_started, std::string(std::strerror(answer.error()))}});
    if (answer->is_missing())
        return tl::unexpected(NotDrawn{Status::output, {lang::command_line::an_svg_is_compared_by_means}});
    if (!answer->status) return tl::unexpected(NotDrawn{Status::bad_input, {lang::command_line::is_no_svg}});
    if (*answer->status != 0) {
        std::string& why = answer->messages;
        while (!why.empty() && why.back() == '\n') why.pop_back();
        return tl::unexpected(NotDrawn{Status::bad_input, {lang::command_line::is_no_svg_that_can_be_drawn, why}});
    }
    return std::move(answer->output);
}

}  // namespace kinegraph::app
