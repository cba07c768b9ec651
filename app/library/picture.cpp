#include "kinegraph/picture.hpp"

#include "app/library/state.hpp"
#include "render/backends/picture_difference.hpp"

namespace kinegraph {

Expected<PictureComparison> compare_pictures(std::string_view expected, std::string_view actual, double tolerance) {
    const auto decoded = [](std::string_view bytes) -> Expected<render::Picture> {
        auto picture = render::decode_png(bytes);
        if (!picture) return refused(Diagnostic::Kind::bad_input, picture.error());
        return *std::move(picture);
    };
    const auto first = decoded(expected), second = decoded(actual);
    if (!first) return tl::unexpected(first.error());
    if (!second) return tl::unexpected(second.error());
    const render::PictureDifference found = render::compare(*first, *second, tolerance);
    return PictureComparison{found.width, found.height, found.differing, found.forgiven,
                             render::encode_png(render::side_by_side(*first, *second, found))};
}

}  // namespace kinegraph
