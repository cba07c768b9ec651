// States behind the public interface (include/kinegraph/), and conversions from the engine's texts and errors to public
// ones. This is the only folder that uses engine, constructions and render together; the command line uses the public
// interface only.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "constructions/positions/named_results.hpp"
#include "engine/file/error.hpp"
#include "engine/mechanism/mechanism.hpp"
#include "engine/sentences/statement.hpp"
#include "engine/solution/solution.hpp"
#include "kinegraph/mechanism.hpp"
#include "kinegraph/sheet.hpp"
#include "kinegraph/solution.hpp"
#include "render/content/sheet_options.hpp"
#include "render/page/page.hpp"
#include "render/text/text.hpp"

namespace kinegraph {

/// Counts the values that share a state.
struct Owned {
    mutable std::atomic<long> owners{1};
};
template <class State>
Shared<State>::Shared(const Shared& other) noexcept : state_(other.state_) {
    if (state_ != nullptr) state_->owners.fetch_add(1, std::memory_order_relaxed);
}
template <class State>
Shared<State>::~Shared() {
    if (state_ != nullptr && state_->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) delete state_;
}

struct MechanismFile::State : Owned {
    std::string text, name;
    std::vector<Setting> set;
    Mechanism mechanism;
};

/// The file that a live page reads again with other parameter values.
struct SourceFile {
    std::string text, name;
    std::vector<Setting> set;
};
struct Solved::State : Owned {
    State(Solution solution, std::optional<SourceFile> source, std::vector<NamedResult> asked);

    Solution solution;
    std::optional<SourceFile> source;  ///< none if the position is not the drawn one of a file
    std::vector<NamedResult> asked;    ///< of a variant: the results asked for
};
Solved solved(Solution solution, std::optional<SourceFile> source = std::nullopt, std::vector<NamedResult> asked = {});

struct Drawing::State : Owned {
    std::vector<render::Page> pages;
    std::vector<Text> remarks;         ///< without that on missing characters
    std::vector<std::string> missing;  ///< characters
};
/// The thread's fonts, opened once. Each call clears the list of missing characters. Error: the font is missing.
Expected<const render::Fonts*> fonts_of_thread();

Text text_of(const Words& words);
/// By tools: the text of lang::tools of the same name, if there is one.
Text text_of(const Message& message, Remedies remedies = Remedies::in_file);
std::vector<Text> texts_of(const std::vector<Words>& all);
std::vector<Solved::Missing> missing_of(const std::vector<Unsolved>& unsolved, Remedies remedies = Remedies::in_file);
Diagnostics diagnostics_of(const Errors& errors);
/// With the message whole and in its two parts.
Diagnostic diagnostic_of(Diagnostic::Kind kind, std::string place, const Words& message);
tl::unexpected<Diagnostics> refused(Diagnostic::Kind kind, const Words& words);

std::vector<Setting> settings_of(const std::vector<ParameterValue>& values);
/// In the file's unit, with the exact value if there is one.
ResultValue value_of(const NamedResult& result, const Solution& solution);

/// Error: the faults of a theme file, or an unknown theme name.
Expected<render::SheetOptions> sheet_options_of(const DrawingOptions& options);
/// With the colours that the file gives its bodies.
render::SheetOptions with_colours_of(render::SheetOptions options, const Mechanism& mechanism);
/// The theme of a live page on dark screens. The built-in colour theme is combined with the dark one; any other choice
/// is used as it is.
std::optional<render::Theme> dark_beside(const DrawingOptions& options);

/// Why something is not drawn, with its place in the file.
Diagnostics not_drawn(const char* place, const Words& why);
/// The same of points too far away to be drawn; none if they are near.
std::optional<Diagnostics> why_points_not_drawn(const Solution& solution);
/// Calls `lay_out` with the options and the thread's fonts, and notes missing characters. Errors: those of
/// sheet_options_of() and of `lay_out`, a missing font.
using LayOut = std::function<Expected<std::vector<render::Page>>(
    const render::SheetOptions& options, const render::Fonts& fonts, std::vector<Text>& remarks)>;
Expected<Drawing> drawing_of(const DrawingOptions& options, const LayOut& lay_out);

/// The whole content of a file, at most 64 MiB.
Expected<std::string> read_file(const std::string& path, const Words& kind);

}  // namespace kinegraph
