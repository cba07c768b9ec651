// ZIP archives, for the packages of learning platforms.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "lang/words.hpp"

namespace kinegraph::render {

/// One file of an archive.
struct Packed {
    std::string name;
    std::string bytes;
};

/// A ZIP archive of the files in this order, not compressed and dated 1 January 1980, so that the same files give the
/// same bytes on every machine. Error: the message of libzip.
tl::expected<std::string, Words> packed(const std::vector<Packed>& files);

}  // namespace kinegraph::render
