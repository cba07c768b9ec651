// Receipts: by which work that was done is known again. Beside the files of DIR/NAME lies DIR/.kinegraph/NAME, written
// with them and last of them: the hash of what was asked, the sizes of the files, the answer.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/batch_line.hpp"
#include "app/files/files.hpp"
#include "render/page/theme.hpp"

namespace kinegraph::app {

/// 128 bits in hexadecimal over all that decides the bytes of the files: the mechanism file's text, parameters,
/// options, the theme's text, what is wanted and where, the program's version. Not the line's id.
std::string hash_of(const BatchLine& line, const std::string& theme);

/// The same over any fields, one after the other, and the program's version.
std::string hash_of(const std::vector<std::string>& fields);

class Receipt {
public:
    /// Of the files that go to `to`, for what has the hash `asked`.
    Receipt(const std::string& to, std::string asked);

    /// The answer, where the same was asked before and its files are there as they were.
    std::optional<std::string> answer() const;
    /// The files of whatever was asked before, as far as they are there with the sizes that they were written with, and
    /// nothing where this is the receipt of something else than `kind`, which the names of its files begin with.
    /// Nothing, too, where the answer says that they are of `same`.
    std::vector<std::string> files_of(const std::string& kind, const std::string& same = {}) const;
    /// Makes the folder, and takes away the receipt of what was asked before. What cannot be written, if it cannot.
    std::optional<NotWritten> make_room() const;
    const std::string& path() const { return path_; }
    /// The receipt as an output, to be written after `outputs`.
    Output of(const std::vector<Output>& outputs, const std::string& answer) const;

private:
    std::string folder_, path_, asked_;
};

}  // namespace kinegraph::app
