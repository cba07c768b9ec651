#include "render/backends/embedded_type.hpp"

#include <array>
#include <cstdint>
#include <string_view>

#include "engine/number/assert.hpp"
#include "render/backends/live_text.hpp"
#include "render/backends/quiz_files.hpp"
#include "render/text/subset.hpp"
#include "render/text/utf8.hpp"

namespace kinegraph::render {
namespace {

constexpr std::size_t face_count = 4;

/// FNV-1a hash, so that equal bytes give equal names.
std::uint32_t mixed(std::uint32_t sum, std::string_view bytes) {
    constexpr std::uint32_t prime = 16777619;
    for (const char c : bytes) sum = (sum ^ static_cast<std::uint8_t>(c)) * prime;
    return sum;
}

std::string in_hex(std::uint32_t number) {
    static constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (int shift = 28; shift >= 0; shift -= 4) text += digits[(number >> shift) & 15U];
    return text;
}

std::array<WantedType, face_count> wanted_by(std::span<const Mark> marks) {
    std::array<WantedType, face_count> wanted;
    for (std::size_t i = 0; i < marks.size();) {
        const LiveLine line = live_line(marks.subspan(i));
        i += std::max<std::size_t>(line.marks.size(), 1);
        for (const LiveRun& run : line.runs) {
            if (run.kind != LiveRun::Kind::set) continue;
            WantedType& of_face = wanted.at(run.letters.front().glyph.face);
            for (const Letter& letter : run.letters) of_face.glyphs.insert(letter.glyph.index);
            for (std::size_t at = 0; at < run.text.size();) of_face.characters.insert(next_code_point(run.text, at));
        }
    }
    for (WantedType& of_face : wanted)
        if (!of_face.glyphs.empty()) of_face.characters.insert(U' ');
    return wanted;
}

}  // namespace

EmbeddedType embedded_type(std::span<const Mark> marks, const Glyphs& glyphs) {
    const auto wanted = wanted_by(marks);
    std::array<std::string, face_count> files;
    std::uint32_t sum = 2166136261U;
    for (std::size_t face = 0; face < face_count; ++face) {
        if (wanted.at(face).glyphs.empty()) continue;
        files.at(face) = font_subset(glyphs.file(static_cast<std::uint8_t>(face)), wanted.at(face));
        KG_ASSERT(!files.at(face).empty(), "a face that can be shaped can be divided");
        sum = mixed(sum, files.at(face));
    }
    EmbeddedType type;
    type.family = "Kinegraph-" + in_hex(sum);
    for (std::size_t face = 0; face < face_count; ++face) {
        if (files.at(face).empty()) continue;
        type.rules += "@font-face{font-family:\"" + type.family + "\";";
        type.rules += face % 2 == 1 ? "font-style:italic;" : "font-style:normal;";
        type.rules += face >= 2 ? "font-weight:bold;" : "font-weight:normal;";
        type.rules += "src:url(\"data:font/otf;base64," + base64(files.at(face)) + "\") format(\"opentype\")}\n";
    }
    return type;
}

}  // namespace kinegraph::render
