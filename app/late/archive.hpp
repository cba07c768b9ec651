// Archives, for the packages of a learning platform.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "engine/file/words.hpp"

namespace kinegraph::app {

/// One file of an archive.
struct Packed {
    std::string name;
    std::string bytes;
};

/// A ZIP archive: the files stored in this order, not compressed, dated 1 January 1980, so that the same files are the
/// same bytes, whatever compressor, clock and time zone there are. Error: what libzip says.
tl::expected<std::string, Words> packed(const std::vector<Packed>& files);

}  // namespace kinegraph::app
