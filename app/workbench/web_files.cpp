#include "app/workbench/web_files.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/workbench/answer.hpp"

namespace kinegraph::app {
namespace {

using Json = nlohmann::ordered_json;

void replace_all(std::string& text, std::string_view place, std::string_view by) {
    for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at + by.size()))
        text.replace(at, place.size(), by);
}

}  // namespace

const WebFile* web_file(std::string_view path) {
    const auto all = web_files();
    const auto found = std::ranges::find(all, path, &WebFile::path);
    return found == all.end() ? nullptr : &*found;
}

std::string media_type_of(std::string_view path) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 5> types{{{".html", "text/html"},
                                                                                  {".css", "text/css"},
                                                                                  {".js", "text/javascript"},
                                                                                  {".svg", "image/svg+xml"},
                                                                                  {".json", "application/json"}}};
    const auto found = std::ranges::find_if(types, [&](const auto& each) { return path.ends_with(each.first); });
    return std::string(found == types.end() ? "text/plain" : found->second) + "; charset=utf-8";
}

std::string examples_json() {
    Json all = Json::array();
    for (const WebFile& each : web_files()) {
        if (!each.path.starts_with("examples/")) continue;
        const Json file = Json::parse(each.text, nullptr, false);
        if (!file.is_object() || !file.contains("kinegraph")) continue;  // data of an example, not a mechanism
        all.push_back({{"path", each.path}, {"title", file.value("title", Json(""))}});
    }
    return all.dump();
}

std::string workbench_page(std::string_view language) {
    std::string page(web_file("index.html")->text);
    const Json answer = Json::parse(workbench_answer(R"({"want": ["policy"]})"));
    const auto allowed = [&](const char* what) { return answer["policy"].value(what, std::string()); };
    replace_all(page, "{script}", allowed("script"));
    replace_all(page, "{style}", allowed("style"));
    replace_all(page, "{language}", language);
    return page;
}

}  // namespace kinegraph::app
