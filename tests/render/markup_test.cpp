// Markup: the bytes are those that pugixml writes of the same tree, and numbers are the shortest decimals of what they
// are snapped to.
#include "render/backends/markup.hpp"

#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <random>
#include <sstream>
#include <string>

namespace kinegraph::render::markup_test {
namespace {

/// The same tree twice: said to Markup, and kept for pugixml.
class Twice {
public:
    explicit Twice(unsigned seed) : random_(seed) {
        pugi::xml_node declaration = tree_.append_child(pugi::node_declaration);
        declaration.append_attribute("version").set_value("1.0");
        declaration.append_attribute("encoding").set_value("UTF-8");
        grow(tree_, 0);
    }
    std::string written() const { return std::string(markup_.text()) + "\n"; }
    std::string by_pugixml() const {
        std::ostringstream out;
        tree_.save(out, " ", pugi::format_indent, pugi::encoding_utf8);
        return out.str();
    }

private:
    int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }
    std::string words() {
        static const std::string letters[] = {"a", "<", ">", "&", "\"", "'", " ", "\n", "\t", "ω", "]]>"};
        std::string text;
        for (int i = below(6); i >= 0; --i) text += letters[below(11)];
        return text;
    }
    void grow(pugi::xml_node parent, int depth) {
        static const char* const names[] = {"g", "path", "text"};
        const char* name = names[below(3)];
        pugi::xml_node node = parent.append_child(name);
        markup_.begin(name);
        for (const char* attribute : {"id", "d"})
            if (below(2) == 0) {
                const std::string value = words();
                node.append_attribute(attribute).set_value(value.c_str());
                markup_.attribute(attribute, value);
            }
        const bool mixed = below(3) == 0;  // words and elements side by side
        for (int i = depth < 4 ? below(4) : 0; i > 0; --i) {
            if (mixed && below(2) == 0) {
                const std::string text = words();
                node.append_child(pugi::node_pcdata).set_value(text.c_str());
                markup_.words(text);
            } else {
                grow(node, depth + 1);
            }
        }
        markup_.end();
    }

    std::mt19937 random_;
    pugi::xml_document tree_;
    Markup markup_;
};

TEST(Markup, is_what_a_tree_is_saved_as) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        const Twice tree(seed);
        ASSERT_EQ(tree.written(), tree.by_pugixml()) << seed;
    }
}

std::string number(double value) {
    Bytes bytes;
    bytes.put_number<8>(value);
    return std::string(bytes.text());
}

TEST(Markup, numbers_are_short) {
    EXPECT_EQ(number(0), "0");
    EXPECT_EQ(number(-1e-9), "0");
    EXPECT_EQ(number(1), "1");
    EXPECT_EQ(number(-0.5), "-0.5");
    EXPECT_EQ(number(12.34), "12.34");
    EXPECT_EQ(number(100), "100");
    EXPECT_EQ(number(297.00000001), "297.00000001");
    EXPECT_EQ(number(0.1 + 0.2), "0.3");
    EXPECT_EQ(number(-1234567.8901), "-1234567.8901");
}

TEST(Markup, numbers_are_read_back) {
    std::mt19937 random(7);
    for (int i = 0; i < 1000; ++i) {
        const double units = std::floor(static_cast<double>(random()) * 7.3) * (i % 2 == 0 ? 1 : -1),
                     value = units / 1e8;
        EXPECT_EQ(std::stod(number(value)), value);
    }
}

}  // namespace
}  // namespace kinegraph::render::markup_test
