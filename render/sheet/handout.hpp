// Handouts: the question as it is handed out, and the key, with figure 1 where the solution's sheet has it. Owns how
// they are laid out; what they say is exercise_text's and the answers'.
#pragma once

#include <vector>

#include "render/sheet/sheet.hpp"
#include "render/tables/answers.hpp"

namespace kinegraph::render {

/// Of the kind that the options say, which is not the solution. `asked`: the results asked for; without them a question
/// does not say at which joint a transmission angle is asked for.
std::vector<Page> lay_out_handout(const Solution& solution, const SheetOptions& options, const Fonts& fonts,
                                  const std::vector<AskedValue>& asked = {});

/// The key with what is to be said of it.
struct Key {
    std::vector<Page> pages;
    std::vector<RichText> remarks;  ///< on what no reading tells; on the pages, too
};
/// `asked`: the values of what the file asks for by name; without them the key has those that a vector, ω, α, a couple
/// or an effort of the solution holds whole.
Key lay_out_key_of(const Solution& solution, const std::vector<AskedValue>& asked, const SheetOptions& options,
                   const Fonts& fonts);

}  // namespace kinegraph::render
