// The time for text and for the back ends, on an A4 sheet fuller than ours: 2000 glyphs in four sizes with subscripts,
// 800 paths.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "render/backends/backends.hpp"

namespace {

using namespace kinegraph::render;

const Colour body_colours[] = {{200, 64, 15},  {230, 168, 23}, {11, 68, 132},
                               {37, 155, 122}, {58, 15, 44},   {107, 107, 115}};

void write(Page& page, const ShapedLine& line, double x, double y, Colour colour) {
    for (const auto& part : line.parts) {
        TextMark mark;
        mark.colour = part.coloured ? part.colour : colour;
        mark.words = line.words;
        mark.cls = "text";
        for (Glyph glyph : part.glyphs) {
            glyph.origin.x += x;
            glyph.origin.y += y;
            mark.glyphs.push_back(glyph);
        }
        page.marks.emplace_back(std::move(mark));
    }
}

Piece piece(const std::string& text, Face face = Face::regular, const std::string& sub = "",
            const std::string& sup = "") {
    Piece made;
    made.text = text;
    made.face = face;
    made.sub = sub;
    made.sup = sup;
    return made;
}

std::vector<RichText> two_hundred_labels() {
    std::vector<RichText> labels;
    for (int i = 0; i < 200; ++i) {
        const std::string number = std::to_string(i);
        switch (i % 4) {
            case 0: labels.push_back({piece("P", Face::italic, number)}); break;
            case 1: labels.push_back({piece("a", Face::bold_italic, "B" + number, "t")}); break;
            case 2: labels.push_back({piece("ω", Face::italic, number), piece(" = ")}); break;
            default: labels.push_back({piece("0." + number + " m/s")}); break;
        }
        labels.back().front().dots = i % 4 == 2 ? 1 : 0;
    }
    return labels;
}

Page full_sheet(const Fonts& fonts, bool coloured) {
    Page page;
    page.title = "A full sheet";
    const Colour ink{27, 27, 31};
    const auto colour = [&](int i) { return coloured ? body_colours[i % 6] : Colour{60, 60, 60}; };
    for (int i = 0; i < 800; ++i) {
        Path path;
        const double a = i * 2.399963;  // the golden angle, so that the directions are spread evenly
        const Spot centre{30.0 + (i * 37) % 240, 25.0 + (i * 53) % 160};
        const double r = 2 + i % 9 * 3;
        if (i % 10 < 6) {
            path.segments = {MoveTo{centre}, LineTo{{centre.x + r * std::cos(a), centre.y + r * std::sin(a)}}};
            path.stroked = true;
        } else if (i % 10 < 8) {
            path.segments = {ArcTo{centre, 1.5, 0, 2 * std::numbers::pi}, Close{}};
            path.stroked = path.filled = true;
            path.fill = {255, 255, 255};
        } else {
            const auto at = [&](double l, double w) {
                return Spot{centre.x + l * std::cos(a) - w * std::sin(a), centre.y + l * std::sin(a) + w * std::cos(a)};
            };
            path.segments = {MoveTo{centre}, LineTo{at(4.6, 0.85)}, LineTo{at(3.8, 0)}, LineTo{at(4.6, -0.85)},
                             Close{}};
            path.filled = true;
            path.fill = colour(i);
        }
        path.pen.width = i % 10 == 0 ? 0.7 : 0.18;
        path.pen.colour = colour(i);
        if (i % 20 == 1) path.pen.dashes = {5, 0.9, 0.6, 0.9};
        page.marks.emplace_back(std::move(path));
    }
    double y = 20;
    for (int i = 0; i < 20; ++i) {
        const RichText sentence = {piece("From O set off v, normal to the rocker, up to the line of "),
                                   piece("a", Face::italic), piece(": ")};
        write(page, fonts.shape(sentence, 9), 20, y += 4.1, ink);
    }
    int i = 0;
    for (const RichText& label : two_hundred_labels()) {
        write(page, fonts.shape(label, i % 3 == 0 ? 12 : 11), 120.0 + i % 10 * 15, 20.0 + i / 10 * 8, colour(i));
        ++i;
    }
    write(page, fonts.shape({piece("Six-link mechanism", Face::bold)}, 15), 100, 200, ink);
    return page;
}

Fonts opened() { return std::move(*Fonts::open()); }

void open_fonts(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(Fonts::open());
}
BENCHMARK(open_fonts)->Unit(benchmark::kMicrosecond);

/// Once in a program: opens the font, shapes the text and loads the outlines.
void shape_200_labels_first(benchmark::State& state) {
    const auto labels = two_hundred_labels();
    for (auto _ : state) {
        const Fonts fonts = opened();
        for (const RichText& label : labels) benchmark::DoNotOptimize(fonts.shape(label, 11));
    }
}
BENCHMARK(shape_200_labels_first)->Unit(benchmark::kMicrosecond);

void shape_200_labels_again(benchmark::State& state) {
    const Fonts fonts = opened();
    const auto labels = two_hundred_labels();
    for (auto _ : state) {
        for (const RichText& label : labels) benchmark::DoNotOptimize(fonts.shape(label, 11));
    }
}
BENCHMARK(shape_200_labels_again)->Unit(benchmark::kMicrosecond);

void wrap_paragraph(benchmark::State& state) {
    const Fonts fonts = opened();
    std::string words;
    for (int i = 0; i < 60; ++i) words += "velocity of the pin ";
    for (auto _ : state) benchmark::DoNotOptimize(fonts.wrap({piece(words)}, 9, 66));
}
BENCHMARK(wrap_paragraph)->Unit(benchmark::kMicrosecond);

void svg(benchmark::State& state) {
    const Fonts fonts = opened();
    const Page page = full_sheet(fonts, true);
    std::size_t bytes = 0;
    for (auto _ : state) bytes = to_svg(page, fonts).size();
    state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(svg)->Unit(benchmark::kMicrosecond);

void png(benchmark::State& state) {
    const Fonts fonts = opened();
    const Page page = full_sheet(fonts, state.range(0) != 0);
    std::size_t bytes = 0;
    for (auto _ : state) bytes = to_png(page, fonts, static_cast<double>(state.range(1))).size();
    state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(png)
    ->ArgNames({"coloured", "dpi"})
    ->Args({1, 150})
    ->Args({0, 150})
    ->Args({1, 300})
    ->Unit(benchmark::kMillisecond);

void pdf(benchmark::State& state) {
    const Fonts fonts = opened();
    const std::vector<Page> pages(static_cast<std::size_t>(state.range(0)), full_sheet(fonts, true));
    std::size_t bytes = 0;
    for (auto _ : state) bytes = to_pdf(pages, fonts).size();
    state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(pdf)->ArgName("pages")->Arg(1)->Arg(8)->Unit(benchmark::kMillisecond);

}  // namespace
