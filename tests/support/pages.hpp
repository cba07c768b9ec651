// Shared by the tests of sheets: solved examples, the text of a page, and a check that nothing is cut off or covered.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "render/page/page.hpp"
#include "render/page/shapes.hpp"
#include "render/sheet/sheet.hpp"
#include "render/text/text.hpp"
#include "tests/support/fonts.hpp"
#include "tests/support/laid_out.hpp"
#include "tests/support/solved.hpp"

namespace kinegraph::pages {

using namespace kinegraph::render;

using tests::example;
using tests::example_names;
using tests::fonts;
using tests::laid_out;
using tests::Look;

inline std::vector<const TextMark*> texts_of(const Page& page) {
    std::vector<const TextMark*> texts;
    for (const Mark& mark : page.marks)
        if (const auto* text = std::get_if<TextMark>(&mark)) texts.push_back(text);
    return texts;
}
/// All text of the pages, one mark on each line.
inline std::string words_of(const std::vector<Page>& pages) {
    std::string words;
    for (const Page& page : pages)
        for (const TextMark* text : texts_of(page)) words += text->words + "\n";
    return words;
}

inline bool says(const Page& page, const std::string& words) {
    for (const TextMark* text : texts_of(page))
        if (text->words.find(words) != std::string::npos) return true;
    return false;
}
inline bool says(const std::vector<Page>& pages, const std::string& words) {
    return std::any_of(pages.begin(), pages.end(), [&](const Page& page) { return says(page, words); });
}

/// The exact ink of a text that is not turned.
inline Box ink_of(const TextMark& text) {
    Box box{{1e300, 1e300}, {-1e300, -1e300}};
    for (const Glyph& glyph : text.glyphs)
        for (const render::Segment& segment : fonts().outline(glyph.face, glyph.index).segments) {
            const auto add = [&](Spot s) {
                const Spot at{glyph.origin.x + glyph.size * s.x, glyph.origin.y - glyph.size * s.y};
                box.min = {std::min(box.min.x, at.x), std::min(box.min.y, at.y)};
                box.max = {std::max(box.max.x, at.x), std::max(box.max.y, at.y)};
            };
            if (const auto* m = std::get_if<MoveTo>(&segment)) add(m->to);
            if (const auto* l = std::get_if<LineTo>(&segment)) add(l->to);
            if (const auto* c = std::get_if<CurveTo>(&segment)) add(c->control_1), add(c->control_2), add(c->to);
        }
    return box;
}

/// `left`, `others`: mm from the edges of the paper to the frame.
inline void expect_clean(const std::vector<Page>& pages, double left = 19.5, double others = 9.5) {
    ASSERT_FALSE(pages.empty());
    for (std::size_t p = 0; p < pages.size(); ++p) {
        SCOPED_TRACE("page " + std::to_string(p + 1));
        const Page& page = pages[p];
        const Box box = box_of(page.marks);
        EXPECT_GE(box.min.x, left);
        EXPECT_GE(box.min.y, others);
        EXPECT_LE(box.max.x, page.width - others);
        EXPECT_LE(box.max.y, page.height - others);
        std::vector<std::pair<Box, std::string>> inks;
        for (const TextMark* text : texts_of(page)) {
            if (text->glyphs.empty() || text->angle != 0 || text->cls != "text") continue;
            const Box ink = ink_of(*text);
            if (ink.min.x > ink.max.x) continue;
            for (const auto& [other, words] : inks) {
                const double x = std::min(ink.max.x, other.max.x) - std::max(ink.min.x, other.min.x);
                const double y = std::min(ink.max.y, other.max.y) - std::max(ink.min.y, other.min.y);
                EXPECT_FALSE(x > 0.1 && y > 0.1) << '"' << text->words << "\" over \"" << words << '"';
            }
            inks.emplace_back(ink, text->words);
        }
        // No prose, caption or table lies on an arrow.
        for (const Mark& mark : page.marks) {
            const auto* axis = std::get_if<Axis>(&mark);
            if (!axis) continue;
            for (int i = 0; i <= 100; ++i) {
                const double t = i / 100.0;
                const Spot at{axis->tail.x + t * (axis->tip.x - axis->tail.x),
                              axis->tail.y + t * (axis->tip.y - axis->tail.y)};
                for (const auto& [ink, words] : inks)
                    EXPECT_FALSE(at.x > ink.min.x && at.x < ink.max.x && at.y > ink.min.y && at.y < ink.max.y) << words;
            }
        }
    }
}

/// Groups open and close in pairs, and ids are unique.
inline void expect_sound_groups(const Page& page) {
    std::set<std::string> ids;
    int depth = 0;
    for (const Mark& mark : page.marks) {
        if (const auto* group = std::get_if<GroupBegin>(&mark)) {
            ++depth;
            EXPECT_TRUE(group->id.empty() || ids.insert(group->id.text()).second) << group->id.text();
        }
        if (std::holds_alternative<GroupEnd>(mark)) --depth;
        EXPECT_GE(depth, 0);
    }
    EXPECT_EQ(depth, 0);
}

}  // namespace kinegraph::pages
