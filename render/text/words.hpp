// Words: the sentences, headings and names of a sheet in a language (lang/*.txt), typeset as in the figures or plain.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/mechanism/mechanism.hpp"
#include "engine/motion/mobility.hpp"
#include "engine/sentences/statement.hpp"
#include "render/text/language.hpp"
#include "render/text/text.hpp"

namespace kinegraph::render {

/// A sentence of the solution, its symbols typeset as in the figures.
RichText say(const Message& message, Language language);
/// Only the results of several sentences of the same form: "Likewise ω_4 = 2.5 rad/s, ω_5 = 0."
RichText say_likewise(const std::vector<const Message*>& messages, Language language);
/// A sentence as plain text, for the terminal and for files of results: names as in the mechanism file, symbols by
/// their plain names.
std::string tell(const Message& message, Language language);
/// Output for programs is English, whatever the language of the sheet.
inline std::string in_english(const Message& message) { return tell(message, Language::en); }
/// A typeset symbol: v_B bold italic with its subscript, ω_3 italic, n and t upright, dots for Italian ω̇_3.
RichText typeset(const Symbol& symbol, Language language);
/// "⟂ O2A", "∥ guide B".
RichText typeset(const LineReason& reason, Language language);
/// A number with `digits` significant digits, a true minus sign, the decimal mark of the language, and ×10ⁿ if it is
/// far from 1.
std::string number(double value, int digits, Language language);
/// A number with a fixed number of decimals, for columns.
std::string fixed(double value, int decimals, Language language);
/// "(1.5, 2)": a pair of formatted coordinates.
std::string pair_of(const std::string& x, const std::string& y, Language language);
/// The shortest decimal that reads back as the same double, with a decimal point; for data attributes.
std::string shortest(double value);
/// The same for readers: the decimal mark of the language, a true minus sign, a power of ten for long numbers.
std::string shortest(double value, Language language);

/// "mechanism", "hyperstatic, 2 times", …: the verdict of the rank on the structure in this pose.
std::string verdict_words(const Mobility& mobility, Language language);

/// A heading or a fixed word.
std::string word(Key key, Language language);
/// The same with its placeholders {0}, {1} … filled.
RichText word(Key key, const std::vector<RichText>& parts, Language language);

/// The prefix of a line's name in a sentence that refers to lines by number ("draw the lines ① ⟂ AB and ② ⟂ O4B"): its
/// number and a space, or an empty string.
using BeforeLine = std::function<std::string(const LineReason&)>;
/// As say(), with prefixes; no line break separates a prefix from its name.
RichText say(const Message& message, Language language, const BeforeLine& before_line);

}  // namespace kinegraph::render
