// Pair tables: the catalogue of pairs and the pairs of one mechanism, as plain text for the terminal, as Markdown for a
// page, or as JSON for a program (docs/command_line.md).
#pragma once

#include <string>
#include <vector>

#include "engine/mechanism/mechanism.hpp"
#include "engine/motion/mobility.hpp"
#include "render/text/words.hpp"

namespace kinegraph::render {

enum class TextForm { plain, markdown, json };

/// All pairs that a file may use, the lower pairs in space, and the equivalent binary schemes of a multiple hinge.
std::string pair_catalogue(Language language, TextForm form);

/// The pairs of a mechanism, its bodies by number of pairs and the chain they form, Grübler's count both ways, the
/// verdict of the rank, and remarks.
std::string pair_report(const Mechanism& mechanism, const Mobility& mobility, const std::vector<Message>& remarks,
                        Language language, TextForm form);

/// The same as JSON, in English.
std::string pair_catalogue_json();
std::string pair_report_json(const Mechanism& mechanism, const Mobility& mobility, const std::vector<Message>& remarks);

}  // namespace kinegraph::render
