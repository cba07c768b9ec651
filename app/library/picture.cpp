#include "kinegraph/picture.hpp"

#include "app/library/state.hpp"
#include "render/backends/picture_difference.hpp"

namespace kinegraph {

struct PngPicture::State : Owned {
    explicit State(render::Picture decoded) : picture(std::move(decoded)) {}
    render::Picture picture;
};
template class Shared<const PngPicture::State>;

bool PngPicture::is_png(std::string_view bytes) { return render::is_png(bytes); }

Expected<PngPicture> PngPicture::decode(std::string_view bytes) {
    auto picture = render::decode_png(bytes);
    if (!picture) return refused(Diagnostic::Kind::bad_input, picture.error());
    return PngPicture(Shared<const State>(new State(*std::move(picture))));
}

int PngPicture::width() const { return state().picture.width; }
int PngPicture::height() const { return state().picture.height; }
std::optional<double> PngPicture::dpi() const { return state().picture.dpi; }

PictureComparison compare_pictures(const PngPicture& expected, const PngPicture& actual, double tolerance, bool draws) {
    const render::Picture &first = expected.state().picture, &second = actual.state().picture;
    const render::PictureDifference found = render::compare(first, second, tolerance);
    PictureComparison comparison{found.width,    found.height, found.differing,
                                 found.forgiven, found.left,   found.right,
                                 found.top,      found.bottom, {}};
    if (draws) comparison.side_by_side = render::encode_png(render::side_by_side(first, second, found));
    return comparison;
}

}  // namespace kinegraph
