// The frame of a DXF file (AutoCAD 2007, AC1021, the first version in UTF-8): header, tables of layers, kinds of line
// and text styles, blocks, objects. Entities are written into it. Knows nothing of marks.
// Source: Autodesk, DXF Reference.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "render/backends/markup.hpp"
#include "render/ink/path.hpp"

namespace kinegraph::render {

/// Pairs of a group code and a value, a line each.
class DxfPairs {
public:
    void put(int code, std::string_view text);
    void put(int code, double number);
    void put(int code, int number) { put_whole(code, number); }
    void put_count(int code, std::size_t count) { put_whole(code, static_cast<std::int64_t>(count)); }
    void put_handle(int code, std::uint64_t handle);
    void put_point(int code, Spot at);  ///< x, y, and z = 0
    std::string_view text() const { return bytes_.text(); }

private:
    void put_whole(int code, std::int64_t number);
    Bytes bytes_;
};

/// A text as a value: without line breaks, and with the signs that DXF reads as commands written so that it does not.
std::string dxf_text(std::string_view text);
/// The colour of AutoCAD's index (1 to 255) that is nearest.
int colour_index(Colour colour);
/// The nearest line width that DXF knows, in hundredths of a millimetre.
int line_weight(double width);

/// What of a dash pattern an entity says: the kind of line by name, and its scale.
struct DxfLineKind {
    std::string name;
    double scale = 1;
};

/// One sheet. Coordinates are mm, y upwards.
class DxfDocument {
public:
    DxfDocument(double width, double height) : width_(width), height_(height) {}

    /// Where entities go, in drawing order.
    DxfPairs& entities() { return entities_; }
    std::uint64_t new_handle() { return next_++; }
    /// The layer, which is in the table from now on.
    const std::string& layer(const std::string& name);
    /// Patterns with the same proportions are one kind of line in several scales.
    DxfLineKind line_kind(const std::vector<double>& dashes);
    /// The text style of one of the four faces.
    static std::string_view text_style(std::uint8_t face);

    /// The layer of what is not ink: the axes of vectors from tail to tip, by which programs measure. It is off.
    static constexpr std::string_view unseen_layer = "axes";
    static constexpr std::uint64_t model_space = 0x20;  ///< handle of the block that owns the entities
    std::string write(std::string_view comment);

private:
    struct LineKind {
        std::string name;
        std::vector<double> dashes;
        double period = 0;
        std::uint64_t handle = 0;
    };
    void header(DxfPairs& out, std::string_view comment) const;
    void tables(DxfPairs& out) const;
    void line_kinds(DxfPairs& out) const;
    void layers(DxfPairs& out) const;
    static void text_styles(DxfPairs& out);
    void view(DxfPairs& out) const;
    static void blocks(DxfPairs& out);
    static void objects(DxfPairs& out);

    double width_, height_;
    DxfPairs entities_;
    std::uint64_t next_ = 0x100;  // handles below are those of the frame
    std::vector<std::pair<std::string, std::uint64_t>> layers_;
    std::map<std::string, std::size_t> layer_of_;
    std::vector<LineKind> line_kinds_;
};

}  // namespace kinegraph::render
