// Moodle XML: see quiz_files.hpp. Cloze questions: {1:NUMERICAL:=value:tolerance} is an answer field. Braces of the
// text become character references, so that they cannot form another field.
#include <algorithm>

#include "render/backends/quiz_files.hpp"
#include "render/backends/quiz_html.hpp"
#include "render/text/html.hpp"

namespace kinegraph::render {
namespace {

std::string field_of(const QuizBlank& blank) { return "{1:NUMERICAL:=" + blank.value + ":" + blank.tolerance + "}"; }

/// The content cannot end the CDATA section: XHTML here has no bare ">".
std::string cdata(const std::string& html) { return "<text><![CDATA[" + html + "]]></text>\n"; }

}  // namespace

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
        unsigned bits = 0;
        for (std::size_t i = 0; i < 3; ++i)
            bits = bits << 8U | (i < count ? static_cast<unsigned>(static_cast<unsigned char>(bytes[at + i])) : 0U);
        for (std::size_t i = 0; i < 4; ++i) text += i <= count ? digits[bits >> (18U - 6U * i) & 63U] : '=';
    }
    return text;
}

std::string moodle_head(std::string_view category) {
    std::string name;
    for (const char c : category)
        name += c == '/' ? std::string("//") : std::string(1, c);  // a single slash separates categories
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<quiz>\n<question "
           "type=\"category\">\n<category><text>$course$/top/" +
           xml_text(name) + "</text></category>\n<info format=\"html\"><text></text></info>\n</question>\n";
}

std::string moodle_question(const QuizItem& item, std::string_view png) {
    std::string body = html_of(item.question, false) + figure_html(item, "@@PLUGINFILE@@/" + figure_file(item));
    body += "<h3>" + xml_text(item.blanks_heading) + "</h3>\n<ul>\n";
    for (const QuizBlank& each : item.blanks) body += blank_html(item, each, field_of(each));
    body += "</ul>\n" + notes_html(item);
    return "<question type=\"cloze\">\n<name><text>" + name_html(item) +
           "</text></name>\n<questiontext format=\"html\">\n" + cdata(body) + "<file name=\"" + figure_file(item) +
           "\" path=\"/\" encoding=\"base64\">" + base64(png) +
           "</file>\n</questiontext>\n<generalfeedback format=\"html\">\n" + cdata(html_of(item.solution, true)) +
           "</generalfeedback>\n<penalty>0.3333333</penalty>\n<hidden>0</hidden>\n<idnumber></idnumber>\n</question>\n";
}

std::string moodle_tail() { return "</quiz>\n"; }

}  // namespace kinegraph::render
