// QTI 2.1: see quiz_files.hpp. An item has one text entry per number. A response within the tolerance (limits included)
// scores one point. The solution is shown after the answer.
#include "render/backends/quiz_files.hpp"
#include "render/backends/quiz_html.hpp"
#include "render/text/html.hpp"

namespace kinegraph::render {
namespace {

constexpr std::string_view xml_declaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

std::string identifier_of(const QuizItem& item) { return "variant-" + item.number; }
std::string response(std::size_t i) { return "RESPONSE_" + std::to_string(i + 1); }
std::string base_value(const std::string& type, const std::string& value) {
    return "<baseValue baseType=\"" + type + "\">" + value + "</baseValue>";
}

std::string declarations(const QuizItem& item) {
    std::string xml;
    for (std::size_t i = 0; i < item.blanks.size(); ++i)
        xml += "<responseDeclaration identifier=\"" + response(i) +
               "\" cardinality=\"single\" baseType=\"float\">\n<correctResponse><value>" + item.blanks[i].value +
               "</value></correctResponse>\n</responseDeclaration>\n";
    const auto outcome = [&](const std::string& name, const std::string& type, const std::string& value) {
        xml += "<outcomeDeclaration identifier=\"" + name + "\" cardinality=\"single\" baseType=\"" + type + "\">";
        if (!value.empty()) xml += "<defaultValue><value>" + value + "</value></defaultValue>";
        xml += "</outcomeDeclaration>\n";
    };
    outcome("SCORE", "float", "0");
    outcome("MAXSCORE", "float", std::to_string(item.blanks.size()));
    outcome("FEEDBACK", "identifier", "");
    return xml;
}

std::string body_of(const QuizItem& item) {
    std::string html = "<itemBody>\n" + html_of(item.question, false) + figure_html(item, figure_file(item)) + "<h3>" +
                       xml_text(item.blanks_heading) + "</h3>\n<ul>\n";
    for (std::size_t i = 0; i < item.blanks.size(); ++i)
        html += blank_html(item, item.blanks[i],
                           "<textEntryInteraction responseIdentifier=\"" + response(i) + "\" expectedLength=\"12\"/>");
    return html + "</ul>\n" + notes_html(item) + "</itemBody>\n";
}

std::string processing_of(const QuizItem& item) {
    std::string xml = "<responseProcessing>\n";
    for (std::size_t i = 0; i < item.blanks.size(); ++i) {
        const std::string& off = item.blanks[i].tolerance;
        xml += "<responseCondition><responseIf>\n<equal toleranceMode=\"absolute\" tolerance=\"";
        xml += off + " " + off + "\"><variable identifier=\"" + response(i) + "\"/><correct identifier=\"" +
               response(i) +
               "\"/></equal>\n<setOutcomeValue identifier=\"SCORE\"><sum><variable identifier=\"SCORE\"/>" +
               base_value("float", "1") + "</sum></setOutcomeValue>\n</responseIf></responseCondition>\n";
    }
    return xml + "<setOutcomeValue identifier=\"FEEDBACK\">" + base_value("identifier", "SOLUTION") +
           "</setOutcomeValue>\n</responseProcessing>\n";
}

}  // namespace

std::string qti_file(const QuizItem& item) { return identifier_of(item) + ".xml"; }

std::string qti_item(const QuizItem& item) {
    std::string xml(xml_declaration);
    xml +=
        "<assessmentItem xmlns=\"http://www.imsglobal.org/xsd/imsqti_v2p1\" "
        "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
        "xsi:schemaLocation=\"http://www.imsglobal.org/xsd/imsqti_v2p1 "
        "http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd\" identifier=\"";
    return xml + identifier_of(item) + "\" title=\"" + name_html(item) +
           "\" adaptive=\"false\" timeDependent=\"false\" xml:lang=\"" + item.language + "\">\n" + declarations(item) +
           body_of(item) + processing_of(item) +
           "<modalFeedback outcomeIdentifier=\"FEEDBACK\" identifier=\"SOLUTION\" showHide=\"show\">\n" +
           html_of(item.solution, true) + "</modalFeedback>\n</assessmentItem>\n";
}

std::string qti_manifest(const std::vector<QuizItem>& items) {
    std::string xml(xml_declaration);
    xml +=
        "<manifest xmlns=\"http://www.imsglobal.org/xsd/imscp_v1p1\" "
        "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
        "xsi:schemaLocation=\"http://www.imsglobal.org/xsd/imscp_v1p1 "
        "http://www.imsglobal.org/xsd/qti/qtiv2p1/qtiv2p1_imscpv1p2_v1p0.xsd\" identifier=\"kinegraph-variants\">\n"
        "<metadata><schema>QTIv2.1 "
        "Package</schema><schemaversion>1.0.0</schemaversion></metadata>\n<organizations/>\n<resources>\n";
    for (const QuizItem& item : items)
        xml += "<resource identifier=\"" + identifier_of(item) + "\" type=\"imsqti_item_xmlv2p1\" href=\"" +
               qti_file(item) + "\"><file href=\"" + qti_file(item) + "\"/><file href=\"" + figure_file(item) +
               "\"/></resource>\n";
    return xml + "</resources>\n</manifest>\n";
}

}  // namespace kinegraph::render
