// A record of finished work, to skip it in a later run: beside the files DIR/NAME.* it writes, last,
// DIR/.kinegraph/NAME with the hash of the request, the sizes of the files and the answer.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/files/files.hpp"

namespace kinegraph::app {

/// The cache key: 128 bits in hexadecimal over all that determines the bytes of the files: text of the mechanism file,
/// parameters, options, text of the theme, formats, paths, version of the program. The id of the line is not part of
/// it. `theme`: from theme_key().
std::string hash_of(const Request& request, const std::string& theme);

/// For the cache key: the name of the theme, and its content if set_theme() has read it from a file of that name.
std::string theme_key(const std::string& name, const DrawingOptions& options);

/// The same over any sequence of fields, and the program's version.
std::string hash_of(const std::vector<std::string>& fields);

class CacheRecord {
public:
    /// The record for files that go to `to`; `asked`: the hash of the request.
    CacheRecord(const std::string& to, std::string asked);

    /// The answer, if an earlier run had the same request and its files still have the recorded sizes.
    std::optional<std::string> answer() const;
    /// The files of an earlier run, whatever its request, that still have their recorded sizes. Empty if the record is
    /// not of `kind` (the prefix of its file names), or if its answer says that the files are of `same`.
    std::vector<std::string> files_of(const std::string& kind, const std::string& same = {}) const;
    /// Creates the folder and removes the old record. Returns what cannot be written, if anything.
    std::optional<NotWritten> make_room() const;
    const std::string& path() const { return path_; }
    /// The record as an output; write it after `outputs`.
    Output of(const std::vector<Output>& outputs, const std::string& answer) const;

private:
    std::string folder_, path_, asked_;
};

}  // namespace kinegraph::app
