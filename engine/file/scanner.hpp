// Scanner: reads a text from left to right for a grammar; blanks between tokens are skipped.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "engine/file/units.hpp"

namespace kinegraph {

class Scanner {
protected:
    explicit Scanner(std::string_view text) : text_(text) {}

    void skip() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    }
    /// Skips the character; false where the next one is different.
    bool takes(char c) {
        skip();
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    std::string_view rest() const { return text_.substr(std::min(at_, text_.size())); }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace kinegraph
