// Pair tables: the catalogue of pairs and the pairs of one mechanism, as plain text for the terminal or as Markdown for a page.
#pragma once

#include <string>
#include <vector>

#include "engine/mechanism.hpp"
#include "engine/mobility.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

enum class TextForm { plain, markdown };

/// All pairs that a file may use, the lower pairs in space, and the binary schemes of a multiple hinge.
std::string pair_catalogue(Language language, TextForm form);

/// The pairs of a mechanism, Grübler's count both ways, the verdict of the rank, and what there is to remark.
std::string pair_report(const Mechanism& mechanism, const Mobility& mobility, const std::vector<Message>& remarks,
                        Language language, TextForm form);

}  // namespace kinegraph::render
