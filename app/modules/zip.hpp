// The seam between the program and kinegraph_zip.so, the module that packs archives. libzip brings compressors and
// ciphers along, which other runs do without.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

namespace kinegraph::app {

/// One file of an archive.
struct Packed {
    std::string name;
    std::string bytes;
};

/// What the module exports, under the name `kinegraph_zip`. Error: what libzip says.
struct ZipFunctions {
    /// Stored in this order, not compressed, dated 1 January 1980: the same files are the same bytes, whatever
    /// compressor, clock and time zone there are.
    tl::expected<std::string, std::string> (*packed)(const std::vector<Packed>& files);
};

}  // namespace kinegraph::app
