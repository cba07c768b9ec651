// Archives by libzip.
#include "render/backends/archive.hpp"

#include <zip.h>

#include <cstdint>
#include <memory>

namespace kinegraph::render {
namespace {

using Bytes = tl::expected<std::string, Words>;

tl::unexpected<Words> failure(std::string text) { return tl::unexpected(Words(std::move(text))); }

tl::unexpected<Words> failure(zip_error_t& error) {
    std::string text = zip_error_strerror(&error);
    zip_error_fini(&error);
    return failure(std::move(text));
}

/// Adds one file; false where libzip refuses.
bool add(zip_t* archive, const Packed& file) {
    constexpr std::uint16_t midnight = 0, first_of_1980 = (1U << 5U) | 1U;
    zip_source_t* const source = zip_source_buffer(archive, file.bytes.data(), file.bytes.size(), 0);
    if (source == nullptr) return false;
    const zip_int64_t index = zip_file_add(archive, file.name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
        zip_source_free(source);
        return false;
    }
    const auto at = static_cast<zip_uint64_t>(index);
    return zip_set_file_compression(archive, at, ZIP_CM_STORE, 0) == 0 &&
           zip_file_set_dostime(archive, at, midnight, first_of_1980, 0) == 0 &&
           zip_file_set_external_attributes(archive, at, 0, ZIP_OPSYS_DOS, 0) == 0;
}

/// Reads all that was written into a source.
Bytes read_back(zip_source_t* source) {
    const auto fails = [&] { return failure(zip_error_strerror(zip_source_error(source))); };
    zip_stat_t stat;
    if (zip_source_stat(source, &stat) != 0 || zip_source_open(source) != 0) return fails();
    std::string bytes(stat.size, '\0');
    const zip_int64_t got = zip_source_read(source, bytes.data(), bytes.size());
    if (got < 0 || static_cast<zip_uint64_t>(got) != stat.size) return fails();
    zip_source_close(source);
    return bytes;
}

}  // namespace

Bytes packed(const std::vector<Packed>& files) {
    zip_error_t error;
    zip_error_init(&error);
    const std::unique_ptr<zip_source_t, void (*)(zip_source_t*)> whole(zip_source_buffer_create(nullptr, 0, 0, &error),
                                                                       zip_source_free);
    if (!whole) return failure(error);
    zip_source_keep(whole.get());  // the archive releases one reference; we read through the other
    zip_t* const archive = zip_open_from_source(whole.get(), ZIP_CREATE | ZIP_TRUNCATE, &error);
    if (archive == nullptr) {
        zip_source_free(whole.get());
        return failure(error);
    }
    for (const Packed& file : files) {
        if (add(archive, file)) continue;
        std::string why = zip_strerror(archive);
        zip_discard(archive);
        return failure(std::move(why));
    }
    if (zip_close(archive) != 0) {
        std::string why = zip_strerror(archive);
        zip_discard(archive);
        return failure(std::move(why));
    }
    return read_back(whole.get());
}

}  // namespace kinegraph::render
