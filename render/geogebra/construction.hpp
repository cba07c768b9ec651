// A construction of GeoGebra as XML: free objects, commands and expressions in their order, each with its look. Owns
// labels and the form of the file; knows no mechanism.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "render/ink/path.hpp"

namespace kinegraph::render {

class Markup;

enum class GeoGebraType { point, line, vector, number, segment, polygon, circle, text };

/// How an object looks. Hidden ones are the construction's auxiliary objects.
struct GeoGebraLook {
    bool is_shown = false;
    bool is_dashed = false;
    Colour colour;
    std::string caption = {};  ///< shown beside it; empty: none
};

class GeoGebraConstruction {
public:
    GeoGebraConstruction(std::string title, std::string author)
        : title_(std::move(title)), author_(std::move(author)) {}

    /// A label that no object has: letters of `stem`, and `index` below them, as far as GeoGebra takes it.
    std::string label(std::string_view stem, std::string_view index);
    std::string label(std::string_view stem);

    /// An object that the user may move or change.
    std::string free_point(std::string label, double x, double y, GeoGebraLook look = {});
    std::string free_number(std::string label, double value);
    std::string command(std::string_view name, const std::vector<std::string>& inputs, GeoGebraType type,
                        std::string label, GeoGebraLook look = {});
    std::string expression(std::string text, GeoGebraType type, std::string label, GeoGebraLook look = {});
    void text(std::string_view words, double x, double y);
    /// Whether the construction's protocol pauses behind the object made last.
    void pause();

    /// The part of the plane that is seen.
    struct View {
        double left = 0, right = 1, low = 0, high = 1;
    };
    /// geogebra.xml.
    std::string xml(const View& view) const;

    /// A number as GeoGebra reads it.
    static std::string number(double value);

private:
    struct Object {
        GeoGebraType type = GeoGebraType::point;
        std::string label, command, text;  ///< with a command the text is empty
        std::vector<std::string> inputs;
        GeoGebraLook look;
        double x = 0, y = 0;
        bool is_free = false, pauses = false;
    };
    std::string add(Object object);
    static void write(Markup& xml, const Object& each);

    std::string title_, author_;
    std::vector<Object> objects_;
    std::set<std::string> labels_;
};

}  // namespace kinegraph::render
