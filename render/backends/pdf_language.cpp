#include "render/backends/live_text.hpp"

#include <charconv>
#include <cstddef>

#include "engine/number/assert.hpp"

namespace kinegraph::render {
namespace {

/// The integer after a word, searched from `from` on.
std::size_t number_behind(std::string_view text, std::string_view word, std::size_t from = 0) {
    std::size_t at = text.find(word, from);
    KG_ASSERT(at != std::string_view::npos, "a PDF of ours has what it refers to");
    at = text.find_first_not_of(" \n\r", at + word.size());
    std::size_t number = 0;
    const auto read = std::from_chars(text.data() + at, text.data() + text.size(), number);
    KG_ASSERT(read.ec == std::errc{}, "a PDF of ours counts in whole numbers");
    return number;
}

std::string ten_digits(std::size_t number) {
    const std::string digits = std::to_string(number);
    return std::string(10 - digits.size(), '0') + digits;
}

}  // namespace

std::string with_language(std::string pdf, std::string_view language) {
    const std::size_t trailer = pdf.rfind("trailer");
    if (trailer == std::string::npos) return pdf;
    const std::size_t table = number_behind(pdf, "startxref", trailer);
    const std::size_t root = number_behind(pdf, "/Root", trailer);
    const std::string head = "\n" + std::to_string(root) + " 0 obj";
    const std::size_t begin = pdf.rfind(head), end = pdf.find("endobj", begin);
    KG_ASSERT(begin != std::string::npos && end != std::string::npos, "a PDF has its catalog");
    std::string catalog = pdf.substr(begin + 1, end - begin - 1);
    const std::size_t close = catalog.rfind(">>");
    KG_ASSERT(close != std::string::npos, "a catalog is a dictionary");
    catalog.insert(close, "   /MarkInfo << /Marked true >>\n   /Lang (" + std::string(language) +
                              ")\n   /ViewerPreferences << /DisplayDocTitle true >>\n");

    const std::size_t size = number_behind(pdf, "/Size", trailer), info = number_behind(pdf, "/Info", trailer);
    const std::size_t at = pdf.size();
    pdf += catalog + "endobj\n";
    const std::size_t second = pdf.size();
    pdf += "xref\n" + std::to_string(root) + " 1\n" + ten_digits(at) + " 00000 n \n";
    pdf += "trailer\n<< /Size " + std::to_string(size) + "\n   /Root " + std::to_string(root) + " 0 R\n   /Info " +
           std::to_string(info) + " 0 R\n   /Prev " + std::to_string(table) + "\n>>\nstartxref\n" +
           std::to_string(second) + "\n%%EOF\n";
    return pdf;
}

}  // namespace kinegraph::render
