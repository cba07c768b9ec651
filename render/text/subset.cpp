#include "render/text/subset.hpp"

#include <hb-subset.h>
#include <hb.h>

#include <memory>

namespace kinegraph::render {
namespace {

struct Release {
    void operator()(hb_blob_t* blob) const { hb_blob_destroy(blob); }
    void operator()(hb_face_t* face) const { hb_face_destroy(face); }
    void operator()(hb_subset_input_t* input) const { hb_subset_input_destroy(input); }
};
template <class T>
using Owned = std::unique_ptr<T, Release>;

}  // namespace

std::string font_subset(std::string_view file, const WantedType& wanted) {
    const Owned<hb_blob_t> blob(
        hb_blob_create(file.data(), static_cast<unsigned>(file.size()), HB_MEMORY_MODE_READONLY, nullptr, nullptr));
    const Owned<hb_face_t> face(hb_face_create(blob.get(), 0));
    const Owned<hb_subset_input_t> input(hb_subset_input_create_or_fail());
    if (!input) return {};
    for (const char32_t character : wanted.characters) hb_set_add(hb_subset_input_unicode_set(input.get()), character);
    for (const std::uint32_t glyph : wanted.glyphs) hb_set_add(hb_subset_input_glyph_set(input.get()), glyph);
    const Owned<hb_face_t> part(hb_subset_or_fail(face.get(), input.get()));
    if (!part) return {};
    const Owned<hb_blob_t> written(hb_face_reference_blob(part.get()));
    unsigned length = 0;
    const char* const bytes = hb_blob_get_data(written.get(), &length);
    return {bytes, length};
}

}  // namespace kinegraph::render
