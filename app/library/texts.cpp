// Converts texts, faults and files from the engine's types to public ones.
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "app/library/state.hpp"
#include "kinegraph/version.hpp"
#include "lang/keys/library.hpp"
#include "lang/keys/tools.hpp"
#include "render/page/theme.hpp"
#include "render/text/words.hpp"

namespace kinegraph {

#define KINEGRAPH_QUOTED(part) #part
#define KINEGRAPH_VERSION_TEXT(major, minor, patch) \
    KINEGRAPH_QUOTED(major) "." KINEGRAPH_QUOTED(minor) "." KINEGRAPH_QUOTED(patch)
std::string_view version() {
    return KINEGRAPH_VERSION_TEXT(KINEGRAPH_VERSION_MAJOR, KINEGRAPH_VERSION_MINOR, KINEGRAPH_VERSION_PATCH);
}

Text filled(const Text& pattern, const std::vector<Text>& arguments) {
    const std::vector<Words> words(arguments.begin(), arguments.end());
    Text text;
    for (const Language language : languages)
        text.by_language.at(static_cast<std::size_t>(language)) =
            formula_words(pattern.in(language), words).in(language);
    return text;
}

Text text_of(const Words& words) { return words; }
Text text_of(const Message& message, Remedies remedies) {
    if (remedies == Remedies::by_tools)
        for (std::size_t i = 0; i < lang::tools_section.size(); ++i)
            if (lang::tools_section.name(i) == message.sentence.name())
                return text_of(Message{Key{&lang::tools_section, i}, message.arguments, message.worked_arithmetic});
    return render::in_all([&](Language language) { return render::tell(message, language); });
}

std::vector<Text> texts_of(const std::vector<Words>& all) {
    std::vector<Text> texts;
    for (const Words& each : all) texts.push_back(text_of(each));
    return texts;
}
std::vector<Solved::Missing> missing_of(const std::vector<Unsolved>& unsolved, Remedies remedies) {
    std::vector<Solved::Missing> all;
    for (const Unsolved& each : unsolved) all.push_back({text_of(each.what), text_of(each.why, remedies)});
    return all;
}

Diagnostics diagnostics_of(const Errors& errors) {
    Diagnostics all;
    for (const Error& error : errors) {
        const Diagnostic::Kind kind = error.code == ErrorCode::cannot_meet        ? Diagnostic::Kind::cannot_meet
                                      : error.code == ErrorCode::no_unique_answer ? Diagnostic::Kind::no_unique_answer
                                      : error.code == ErrorCode::output           ? Diagnostic::Kind::output
                                                                                  : Diagnostic::Kind::bad_input;
        all.push_back(diagnostic_of(kind, error.where, error.message));
    }
    return all;
}
Diagnostic diagnostic_of(Diagnostic::Kind kind, std::string place, const Words& message) {
    Diagnostic made{kind, std::move(place), text_of(message)};
    for (const Language language : languages) {
        Words::InTwo two = message.in_two(language);
        made.fault.by_language.at(static_cast<std::size_t>(language)) = std::move(two.fault);
        made.remedy.by_language.at(static_cast<std::size_t>(language)) = std::move(two.remedy);
    }
    return made;
}
tl::unexpected<Diagnostics> refused(Diagnostic::Kind kind, const Words& words) {
    return tl::unexpected(Diagnostics{diagnostic_of(kind, "", words)});
}

std::vector<Setting> settings_of(const std::vector<ParameterValue>& values) {
    std::vector<Setting> all;
    for (const ParameterValue& each : values) all.push_back({each.name, each.value});
    return all;
}

Expected<std::string> read_file(const std::string& path, const Words& kind) {
    constexpr std::size_t largest = std::size_t{64} << 20;
    const auto cannot_be_read = [&](const std::string& reason) {
        return refused(Diagnostic::Kind::bad_input, Words(lang::library::the_cannot_be_read, kind, path, reason));
    };
    const auto close = [](std::FILE* file) { std::fclose(file); };
    const std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "rb"), close);
    if (!file) return cannot_be_read(std::generic_category().message(errno));
    std::string text;
    std::array<char, 1 << 16> part{};
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), file.get())) {
        text.append(part.data(), count);
        if (text.size() > largest)
            return refused(Diagnostic::Kind::bad_input, Words(lang::library::the_is_larger_than_64_mib, kind, path));
    }
    if (std::ferror(file.get()) != 0) return cannot_be_read(std::generic_category().message(errno));
    return text;
}

}  // namespace kinegraph
