// The faults of a mechanism file where they stand in its text.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <kinegraph/error.hpp>

namespace kinegraph::app {

struct FaultInText {
    std::size_t begin = 0, end = 0;  ///< bytes; what an editor underlines
    std::string text;
    bool is_remark = false;  ///< something was probably forgotten
};

/// The faults of the file, or what `kinegraph check` remarks. The text is UTF-8. Of a file that does not say that it is
/// one of Kinegraph's, by its key or its name, nothing is said.
std::vector<FaultInText> faults_in(const std::string& text, const std::string& name, Language language);

}  // namespace kinegraph::app
