// Words: every sentence, heading and name the sheet says, in English and Italian. Faults of
// files and of the command line carry theirs themselves (engine/file/words.hpp). Terms differ by
// language, not only by translation (instant centre P_ij / centro di istantanea rotazione C_ij; language.hpp).
#pragma once

#include <string>
#include <vector>

#include "engine/mechanism/mechanism.hpp"
#include "engine/motion/mobility.hpp"
#include "engine/sentences/statement.hpp"
#include "render/text/language.hpp"
#include "render/text/text.hpp"

namespace kinegraph::render {

/// A sentence of the solution, symbols set as in the figures.
RichText say(const Message& message, Language language);
/// What such sentences find, of others that say the same: "Likewise ω_4 = 2.5 rad/s, ω_5 = 0."
RichText say_likewise(const std::vector<const Message*>& messages, Language language);
/// The same for the terminal and for files of results: names as the mechanism file has them, symbols by their plain
/// names.
std::string tell(const Message& message, Language language);
/// What programs read is English whatever the sheet speaks.
inline std::string in_english(const Message& message) { return tell(message, Language::en); }
/// A quantity as it is typeset: v_B bold italic with its subscript, ω_3 italic, n and t upright, dots for Italian ω̇_3.
RichText typeset(const Symbol& symbol, Language language);
/// "⟂ O2A", "∥ guide B".
RichText typeset(const LineReason& reason, Language language);
/// A number with `digits` significant digits, true minus, decimal comma in Italian, ×10ⁿ where it is far from 1.
std::string number(double value, int digits, Language language);
/// A fixed number of decimals, for columns.
std::string fixed(double value, int decimals, Language language);
/// "(1.5, 2)" of coordinates as they are written.
std::string pair_of(const std::string& x, const std::string& y, Language language);
/// The shortest decimal that reads back as this double, with a point: data attributes.
std::string shortest(double value);
/// The same for readers: decimal comma in Italian, true minus, powers of ten where it is long.
std::string shortest(double value, Language language);

/// "mechanism", "hyperstatic, 2 times", …: what the rank says of the structure at this pose.
std::string verdict_words(const Mobility& mobility, Language language);

/// Headings and fixed words by key ("velocity polygon", "results", "numeric", …); a key without words is a fault.
std::string word(std::string_view key, Language language);
/// The same with its places {0}, {1} … filled.
RichText word(std::string_view key, const std::vector<RichText>& parts, Language language);

}  // namespace kinegraph::render
