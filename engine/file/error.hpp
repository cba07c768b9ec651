// Error: a fault of a user's file or of the geometry, as a value. One line for a reader: place, fault, remedy.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "lang/words.hpp"

namespace kinegraph {

enum class ErrorCode {
    bad_input,         ///< the file or the command line is wrong (exit 2)
    cannot_meet,       ///< curves that do not meet (exit 2)
    no_unique_answer,  ///< the mechanism is at a dead point, a change point, locked (exit 3)
    output,            ///< the output can't be written, or a font is missing (exit 4)
};

struct Error {
    ErrorCode code = ErrorCode::bad_input;
    std::string where;  ///< JSON pointer ("/joints/2/bodies/1"), or empty for the whole file
    Words message;      ///< what is wrong and what to do, without the file's name and without a full stop
};
/// All faults of a file at once, in the file's order.
using Errors = std::vector<Error>;

template <class Value>
using Result = tl::expected<Value, Errors>;

inline auto refused(Words why) { return tl::make_unexpected(std::move(why)); }

}  // namespace kinegraph
