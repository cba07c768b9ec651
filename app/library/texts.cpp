// Converts texts, faults and files from the engine's types to public ones.
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "app/library/state.hpp"
#include "kinegraph/version.hpp"
#include "render/page/theme.hpp"
#include "render/text/words.hpp"

namespace kinegraph {

#define KINEGRAPH_QUOTED(part) #part
#define KINEGRAPH_VERSION_TEXT(major, minor, patch) \
    KINEGRAPH_QUOTED(major) "." KINEGRAPH_QUOTED(minor) "." KINEGRAPH_QUOTED(patch)
std::string_view version() {
    return KINEGRAPH_VERSION_TEXT(KINEGRAPH_VERSION_MAJOR, KINEGRAPH_VERSION_MINOR, KINEGRAPH_VERSION_PATCH);
}

std::string code_of(Language language) { return render::code_of(language_of(language)); }
Language language_named(std::string_view code) {
    return render::language_of(code) == render::Language::it ? Language::it : Language::en;
}
Text filled(const Text& pattern, const std::vector<Text>& arguments) {
    std::array<Words, 10> words;
    for (std::size_t i = 0; i < words.size(); ++i)
        words.at(i) = i < arguments.size() ? words_of(arguments[i]) : Words("{" + std::to_string(i) + "}");
    return text_of(Words(pattern.in(Language::en), pattern.in(Language::it), words));
}

render::Language language_of(Language language) {
    return language == Language::it ? render::Language::it : render::Language::en;
}

Words words_of(const Text& text) { return {text.in(Language::en), text.in(Language::it)}; }
Text text_of(const Words& words) { return {{in(words, render::Language::en), in(words, render::Language::it)}}; }
Text text_of(const Message& message) {
    return {{render::tell(message, render::Language::en), render::tell(message, render::Language::it)}};
}

std::vector<Text> texts_of(const std::vector<Words>& all) {
    std::vector<Text> texts;
    for (const Words& each : all) texts.push_back(text_of(each));
    return texts;
}
std::vector<Solved::Missing> missing_of(const std::vector<Unsolved>& unsolved) {
    std::vector<Solved::Missing> all;
    for (const Unsolved& each : unsolved) all.push_back({text_of(each.what), text_of(each.why)});
    return all;
}

Diagnostics diagnostics_of(const Errors& errors) {
    Diagnostics all;
    for (const Error& error : errors) {
        const Diagnostic::Kind kind = error.code == ErrorCode::cannot_meet        ? Diagnostic::Kind::cannot_meet
                                      : error.code == ErrorCode::no_unique_answer ? Diagnostic::Kind::no_unique_answer
                                      : error.code == ErrorCode::output           ? Diagnostic::Kind::output
                                                                                  : Diagnostic::Kind::bad_input;
        all.push_back({kind, error.where, text_of(error.message)});
    }
    return all;
}
tl::unexpected<Diagnostics> refused(Diagnostic::Kind kind, const Words& words) {
    return tl::unexpected(Diagnostics{{kind, "", text_of(words)}});
}

std::vector<Setting> settings_of(const std::vector<ParameterValue>& values) {
    std::vector<Setting> all;
    for (const ParameterValue& each : values) all.push_back({each.name, each.value});
    return all;
}

Expected<std::string> read_file(const std::string& path, const Words& kind) {
    constexpr std::size_t largest = std::size_t{64} << 20;
    const auto cannot_be_read = [&](const std::string& reason) {
        return refused(Diagnostic::Kind::bad_input, Words("the {0} {1} cannot be read: {2}",
                                                          "il {0} {1} non si può leggere: {2}", kind, path, reason));
    };
    const auto close = [](std::FILE* file) { std::fclose(file); };
    const std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "rb"), close);
    if (!file) return cannot_be_read(std::generic_category().message(errno));
    std::string text;
    std::array<char, 1 << 16> part{};
    while (const std::size_t count = std::fread(part.data(), 1, part.size(), file.get())) {
        text.append(part.data(), count);
        if (text.size() > largest)
            return refused(Diagnostic::Kind::bad_input,
                           Words("the {0} {1} is larger than 64 MiB", "il {0} {1} supera 64 MiB", kind, path));
    }
    if (std::ferror(file.get()) != 0) return cannot_be_read(std::generic_category().message(errno));
    return text;
}

}  // namespace kinegraph
