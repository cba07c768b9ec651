#include "render/backends/dxf_document.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "render/text/utf8.hpp"

namespace kinegraph::render {
namespace {

/// Handles of the frame's own parts.
enum Fixed : std::uint64_t {
    view_table = 1,
    line_kind_table,
    layer_table,
    style_table,
    saved_view_table,
    axes_table,
    application_table,
    dimension_style_table,
    block_table,
    active_view,
    line_by_block,
    line_by_layer,
    line_continuous,
    layer_zero,
    first_style,  // four of them
    style_standard = first_style + 4,
    application_acad,
    application_own,
    dimension_style,
    paper_space,
    model_begin,
    model_end,
    paper_begin,
    paper_end,
    root_dictionary,
    group_dictionary,
    model_is = DxfDocument::model_space,
};
static_assert(group_dictionary < model_is);

struct TextStyle {
    std::string_view name, file, family;
    int traits;  // of the ACAD extension: bold, italic
};
/// In the order of the faces. Times is as wide as STIX, and drafting programs have it or replace it by its like.
constexpr std::array<TextStyle, 4> text_styles_of_faces{
    {{"KG-REGULAR", "times.ttf", "Times New Roman", 0},
     {"KG-ITALIC", "timesi.ttf", "Times New Roman", 1 << 24},
     {"KG-BOLD", "timesbd.ttf", "Times New Roman", 1 << 25},
     {"KG-BOLD-ITALIC", "timesbi.ttf", "Times New Roman", (1 << 24) | (1 << 25)}}};

void begin_table(DxfPairs& out, std::string_view name, std::uint64_t handle, std::size_t entries) {
    out.put(0, "TABLE");
    out.put(2, name);
    out.put_handle(5, handle);
    out.put_handle(330, 0);
    out.put(100, "AcDbSymbolTable");
    out.put(70, static_cast<int>(entries));
}
void end_table(DxfPairs& out) { out.put(0, "ENDTAB"); }

void begin_entry(DxfPairs& out, std::string_view type, std::uint64_t handle, std::uint64_t table,
                 std::string_view subclass, std::string_view name, int handle_code = 5) {
    out.put(0, type);
    out.put_handle(handle_code, handle);
    out.put_handle(330, table);
    out.put(100, "AcDbSymbolTableRecord");
    out.put(100, subclass);
    out.put(2, name);
}

void empty_table(DxfPairs& out, std::string_view name, std::uint64_t handle) {
    begin_table(out, name, handle, 0);
    end_table(out);
}

/// Red, green and blue of AutoCAD's colours 10 to 249: 24 hues, each in five values and two saturations.
Colour palette_colour(int index) {
    constexpr std::array values{255, 189, 129, 104, 79};
    const int hue = (index / 10 - 1) * 15, shade = index % 10;
    const double value = values.at(static_cast<std::size_t>(shade / 2)), pale = shade % 2 == 1 ? 0.5 : 0;
    const auto part = [&](int turn) {
        const int at = (hue + turn) % 360;
        const double full = at < 60 ? at / 60.0 : at < 180 ? 1 : at < 240 ? (240 - at) / 60.0 : 0;
        return static_cast<std::uint8_t>(std::lround(value * (full + pale * (1 - full))));
    };
    return {part(120), part(0), part(240)};
}
constexpr std::array<Colour, 6> palette_greys{
    {{51, 51, 51}, {91, 91, 91}, {132, 132, 132}, {173, 173, 173}, {214, 214, 214}, {255, 255, 255}}};

}  // namespace

void DxfPairs::put_whole(int code, std::int64_t number) {
    bytes_.put_decimal<0>(code);
    bytes_.put('\n');
    bytes_.put_decimal<0>(number);
    bytes_.put('\n');
}
void DxfPairs::put(int code, std::string_view text) {
    bytes_.put_decimal<0>(code);
    bytes_.put('\n');
    bytes_.put(text);
    bytes_.put('\n');
}
void DxfPairs::put(int code, double number) {
    bytes_.put_decimal<0>(code);
    bytes_.put('\n');
    bytes_.put_number<8>(number);
    bytes_.put('\n');
}
void DxfPairs::put_handle(int code, std::uint64_t handle) {
    std::array<char, 20> text{};
    char* const end = std::to_chars(text.data(), text.data() + text.size(), handle, 16).ptr;
    std::transform(text.data(), end, text.data(),
                   [](char c) { return c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c; });
    put(code, std::string_view(text.data(), static_cast<std::size_t>(end - text.data())));
}
void DxfPairs::put_point(int code, Spot at) {
    put(code, at.x);
    put(code + 10, at.y);
    put(code + 20, 0);
}

std::string dxf_text(std::string_view text) {
    std::string value;
    const bool has_codes = text.find("%%") != std::string_view::npos;
    for (const char c : well_formed(text)) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
            value += ' ';
        else if (c == '\\')
            value += "\\U+005C";
        else if (c == '^')
            value += "^ ";
        else if (c == '%' && has_codes)
            value += "%%037";
        else
            value += c;
    }
    return value;
}

int colour_index(Colour colour) {
    const auto apart = [&](Colour other) {
        const int red = colour.red - other.red, green = colour.green - other.green, blue = colour.blue - other.blue;
        return red * red + green * green + blue * blue;
    };
    int best = 10;
    int least = apart(palette_colour(best));
    const auto take = [&](int index, Colour other) {
        if (apart(other) >= least) return;
        least = apart(other);
        best = index;
    };
    for (int index = 11; index < 250; ++index) take(index, palette_colour(index));
    for (std::size_t i = 0; i < palette_greys.size(); ++i) take(250 + static_cast<int>(i), palette_greys.at(i));
    return best;
}

int line_weight(double width) {
    constexpr std::array weights{5,  9,  13, 15, 18,  20,  25,  30,  35,  40,  50, 53,
                                 60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211};
    const double wanted = 100 * width;
    return *std::min_element(weights.begin(), weights.end(),
                             [&](int a, int b) { return std::abs(a - wanted) < std::abs(b - wanted); });
}

const std::string& DxfDocument::layer(const std::string& name) {
    const auto [found, fresh] = layer_of_.try_emplace(name, layers_.size());
    if (fresh) layers_.emplace_back(name, new_handle());
    return layers_[found->second].first;
}

DxfLineKind DxfDocument::line_kind(const std::vector<double>& dashes) {
    double period = 0;
    for (const double dash : dashes) period += dash;
    if (!(period > 0)) return {"Continuous", 1};
    const auto same = [&](const LineKind& other) {
        if (other.dashes.size() != dashes.size()) return false;
        for (std::size_t i = 0; i < dashes.size(); ++i)
            if (std::abs(other.dashes[i] / other.period - dashes[i] / period) > 1e-6) return false;
        return true;
    };
    auto kind = std::find_if(line_kinds_.begin(), line_kinds_.end(), same);
    if (kind == line_kinds_.end()) {
        const char* const stem = dashes.size() <= 2 ? "DASHED" : dashes.size() <= 4 ? "DASHDOT" : "DASHDOTDOT";
        const auto before = std::count_if(line_kinds_.begin(), line_kinds_.end(), [&](const LineKind& other) {
            return other.name == stem || other.name.starts_with(std::string(stem) + "-");
        });
        std::string name = before == 0 ? stem : stem + ("-" + std::to_string(before + 1));
        line_kinds_.push_back({std::move(name), dashes, period, new_handle()});
        kind = line_kinds_.end() - 1;
    }
    return {kind->name, period / kind->period};
}

std::string_view DxfDocument::text_style(std::uint8_t face) { return text_styles_of_faces.at(face).name; }

void DxfDocument::header(DxfPairs& out, std::string_view comment) const {
    out.put(999, comment);
    out.put(0, "SECTION");
    out.put(2, "HEADER");
    const auto variable = [&](std::string_view name) { out.put(9, name); };
    variable("$ACADVER");
    out.put(1, "AC1021");
    variable("$DWGCODEPAGE");
    out.put(3, "ANSI_1252");
    variable("$INSBASE");
    out.put_point(10, {0, 0});
    variable("$EXTMIN");
    out.put_point(10, {0, 0});
    variable("$EXTMAX");
    out.put_point(10, {width_, height_});
    variable("$LIMMIN");
    out.put(10, 0.0);
    out.put(20, 0.0);
    variable("$LIMMAX");
    out.put(10, width_);
    out.put(20, height_);
    variable("$LTSCALE");
    out.put(40, 1.0);
    variable("$LWDISPLAY");
    out.put(290, 1);
    variable("$INSUNITS");  // millimetres
    out.put(70, 4);
    variable("$MEASUREMENT");
    out.put(70, 1);
    variable("$TEXTSTYLE");
    out.put(7, "Standard");
    variable("$CLAYER");
    out.put(8, "0");
    variable("$HANDSEED");
    out.put_handle(5, next_);
    out.put(0, "ENDSEC");
}

void DxfDocument::view(DxfPairs& out) const {
    begin_table(out, "VPORT", view_table, 1);
    begin_entry(out, "VPORT", active_view, view_table, "AcDbViewportTableRecord", "*ACTIVE");
    out.put(70, 0);
    const auto pair = [&](int code, double x, double y) {
        out.put(code, x);
        out.put(code + 10, y);
    };
    pair(10, 0, 0);
    pair(11, 1, 1);
    pair(12, width_ / 2, height_ / 2);
    pair(13, 0, 0);
    pair(14, 10, 10);
    pair(15, 10, 10);
    out.put(16, 0.0);
    out.put(26, 0.0);
    out.put(36, 1.0);
    out.put_point(17, {0, 0});
    out.put(40, 1.05 * height_);
    out.put(41, width_ / height_);
    out.put(42, 50.0);
    end_table(out);
}

void DxfDocument::line_kinds(DxfPairs& out) const {
    begin_table(out, "LTYPE", line_kind_table, line_kinds_.size() + 3);
    const auto entry = [&](std::string_view name, std::uint64_t handle, std::string_view words,
                           const std::vector<double>& dashes, double period) {
        begin_entry(out, "LTYPE", handle, line_kind_table, "AcDbLinetypeTableRecord", name);
        out.put(70, 0);
        out.put(3, words);
        out.put(72, 65);
        out.put(73, static_cast<int>(dashes.size()));
        out.put(40, period);
        for (std::size_t i = 0; i < dashes.size(); ++i) {
            out.put(49, i % 2 == 0 ? dashes[i] : -dashes[i]);
            out.put(74, 0);
        }
    };
    entry("ByBlock", line_by_block, "", {}, 0);
    entry("ByLayer", line_by_layer, "", {}, 0);
    entry("Continuous", line_continuous, "Solid line", {}, 0);
    for (const LineKind& kind : line_kinds_) {
        const std::string_view words = kind.dashes.size() <= 2   ? "Dashed _ _ _ _"
                                       : kind.dashes.size() <= 4 ? "Dash dot __ . __ . __"
                                                                 : "Dash dot dot __ . . __ . . __";
        entry(kind.name, kind.handle, words, kind.dashes, kind.period);
    }
    end_table(out);
}

void DxfDocument::layers(DxfPairs& out) const {
    begin_table(out, "LAYER", layer_table, layers_.size() + 1);
    const auto entry = [&](std::string_view name, std::uint64_t handle) {
        const bool is_unseen = name == unseen_layer;
        begin_entry(out, "LAYER", handle, layer_table, "AcDbLayerTableRecord", name);
        out.put(70, 0);
        out.put(62, is_unseen ? -7 : 7);  // a negative colour: the layer is off
        out.put(6, "Continuous");
        if (is_unseen) out.put(290, 0);  // nor is it plotted
        out.put(370, 18);
    };
    entry("0", layer_zero);
    for (const auto& [name, handle] : layers_) entry(name, handle);
    end_table(out);
}

void DxfDocument::text_styles(DxfPairs& out) {
    begin_table(out, "STYLE", style_table, text_styles_of_faces.size() + 1);
    const auto entry = [&](std::string_view name, std::uint64_t handle, const TextStyle& style) {
        begin_entry(out, "STYLE", handle, style_table, "AcDbTextStyleTableRecord", name);
        out.put(70, 0);
        out.put(40, 0.0);
        out.put(41, 1.0);
        out.put(50, 0.0);
        out.put(71, 0);
        out.put(42, 2.5);
        out.put(3, style.file);
        out.put(4, "");
        out.put(1001, "ACAD");
        out.put(1000, style.family);
        out.put(1071, style.traits);
    };
    entry("Standard", style_standard, text_styles_of_faces.front());
    for (std::size_t i = 0; i < text_styles_of_faces.size(); ++i)
        entry(text_styles_of_faces.at(i).name, first_style + i, text_styles_of_faces.at(i));
    end_table(out);
}

void DxfDocument::tables(DxfPairs& out) const {
    out.put(0, "SECTION");
    out.put(2, "TABLES");
    view(out);
    line_kinds(out);
    layers(out);
    text_styles(out);
    empty_table(out, "VIEW", saved_view_table);
    empty_table(out, "UCS", axes_table);
    begin_table(out, "APPID", application_table, 2);
    begin_entry(out, "APPID", application_acad, application_table, "AcDbRegAppTableRecord", "ACAD");
    out.put(70, 0);
    begin_entry(out, "APPID", application_own, application_table, "AcDbRegAppTableRecord", "KINEGRAPH");
    out.put(70, 0);
    end_table(out);
    begin_table(out, "DIMSTYLE", dimension_style_table, 1);
    out.put(100, "AcDbDimStyleTable");
    out.put(71, 0);
    // Its handle has a code of its own, since 5 was taken.
    begin_entry(out, "DIMSTYLE", dimension_style, dimension_style_table, "AcDbDimStyleTableRecord", "Standard", 105);
    out.put(70, 0);
    end_table(out);
    begin_table(out, "BLOCK_RECORD", block_table, 2);
    begin_entry(out, "BLOCK_RECORD", model_space, block_table, "AcDbBlockTableRecord", "*Model_Space");
    out.put(70, 4);
    begin_entry(out, "BLOCK_RECORD", paper_space, block_table, "AcDbBlockTableRecord", "*Paper_Space");
    out.put(70, 4);
    end_table(out);
    out.put(0, "ENDSEC");
}

void DxfDocument::blocks(DxfPairs& out) {
    const auto block = [&](std::string_view name, std::uint64_t owner, std::uint64_t begin, std::uint64_t end) {
        const auto head = [&](std::string_view type, std::uint64_t handle, std::string_view subclass) {
            out.put(0, type);
            out.put_handle(5, handle);
            out.put_handle(330, owner);
            out.put(100, "AcDbEntity");
            out.put(8, "0");
            out.put(100, subclass);
        };
        head("BLOCK", begin, "AcDbBlockBegin");
        out.put(2, name);
        out.put(70, 0);
        out.put_point(10, {0, 0});
        out.put(3, name);
        out.put(1, "");
        head("ENDBLK", end, "AcDbBlockEnd");
    };
    out.put(0, "SECTION");
    out.put(2, "BLOCKS");
    block("*Model_Space", model_space, model_begin, model_end);
    block("*Paper_Space", paper_space, paper_begin, paper_end);
    out.put(0, "ENDSEC");
}

void DxfDocument::objects(DxfPairs& out) {
    const auto dictionary = [&](std::uint64_t handle, std::uint64_t owner) {
        out.put(0, "DICTIONARY");
        out.put_handle(5, handle);
        out.put_handle(330, owner);
        out.put(100, "AcDbDictionary");
        out.put(281, 1);
    };
    out.put(0, "SECTION");
    out.put(2, "OBJECTS");
    dictionary(root_dictionary, 0);
    out.put(3, "ACAD_GROUP");
    out.put_handle(350, group_dictionary);
    dictionary(group_dictionary, root_dictionary);
    out.put(0, "ENDSEC");
}

std::string DxfDocument::write(std::string_view comment) {
    DxfPairs before, after;
    header(before, comment);
    before.put(0, "SECTION");
    before.put(2, "CLASSES");
    before.put(0, "ENDSEC");
    tables(before);
    blocks(before);
    before.put(0, "SECTION");
    before.put(2, "ENTITIES");
    after.put(0, "ENDSEC");
    objects(after);
    after.put(0, "EOF");
    std::string text(before.text());
    text += entities_.text();
    text += after.text();
    return text;
}

}  // namespace kinegraph::render
