#include "app/workbench/answer.hpp"

#include <algorithm>
#include <exception>
#include <vector>

#include <kinegraph/mechanism.hpp>
#include <kinegraph/motion.hpp>
#include <kinegraph/request.hpp>
#include <kinegraph/sheet.hpp>
#include <nlohmann/json.hpp>

#include "app/files/place_in_file.hpp"
#include "app/workbench/sound_part.hpp"
#include "lang/keys/workbench.hpp"

namespace kinegraph::app {
namespace {

using Json = nlohmann::ordered_json;
using Sheet = DrawingOptions::Sheet;

std::string text_in(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}
std::vector<std::string> texts_in(const Json& object, const char* key) {
    std::vector<std::string> texts;
    const auto found = object.find(key);
    if (found != object.end() && found->is_array())
        for (const Json& each : *found)
            if (each.is_string()) texts.push_back(each.get<std::string>());
    return texts;
}

/// The options of a request, by the reader of `kinegraph batch`.
Request options_in(const Json& request) {
    Json options = request.value("options", Json::object());
    if (!options.is_object()) options = Json::object();
    options.erase("file");
    options["mechanism"] = Json::object();
    return Request::parse(options.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// One request while it is answered.
class Answering {
public:
    explicit Answering(const Json& request)
        : text_(text_in(request, "text")),
          name_(text_in(request, "name")),
          want_(texts_in(request, "want")),
          figures_(texts_in(request, "figures")),
          options_(options_in(request)) {}

    Json answer() {
        for (const char* key : {"faults", "remarks", "unsolved"}) answer_[key] = Json::array();
        answer_["title"] = "";
        add_faults(options_.faults, "");
        if (!options_.faults.empty()) return answer_;
        if (wants("words")) add_words();
        if (wants("policy")) add_policy();
        if (text_.empty()) return answer_;
        if (wants("import")) return imported();
        const auto file = MechanismFile::parse(text_, name_, options_.set);
        if (!file) {
            add_faults(file.error(), text_);
            if (wants("position")) add_sound_position(file.error());
            return answer_;
        }
        answer_["title"] = in(file->title());
        const MechanismFile::Counts counts = file->counts();
        answer_["counts"] = {{"bodies", counts.bodies}, {"joints", counts.joints}, {"drivers", counts.drivers}};
        if (!add_position(*file)) return answer_;
        if (wants("mobility")) add_mobility(*file);
        if (const auto remarks = file->check(Remedies::by_tools))
            add_texts("remarks", *remarks);
        else
            add_faults(remarks.error(), text_);
        if (wants("cycle")) add_cycle(*file);
        add_solution(*file);
        return answer_;
    }

private:
    bool wants(std::string_view what) const { return std::find(want_.begin(), want_.end(), what) != want_.end(); }
    bool wants_drawing() const {
        return !figures_.empty() || wants("sheet") || wants("question") || wants("answers") || wants("live") ||
               wants("tex") || wants("geogebra") || wants("sentences") || wants("names");
    }
    const std::string& in(const Text& text) const { return text.in(options_.drawing.language); }

    void add_texts(const char* key, const std::vector<Text>& texts) {
        for (const Text& each : texts)
            if (const std::string& text = in(each);
                std::find(answer_[key].begin(), answer_[key].end(), text) == answer_[key].end())
                answer_[key].push_back(text);
    }
    /// `text`: the file in which the faults are; empty where they have no place in it.
    void add_faults(const Diagnostics& faults, const std::string& text) {
        for (const Diagnostic& each : faults) {
            Json fault{{"where", each.place}};
            if (const auto place = text.empty() ? std::nullopt : place_in_file(text, each.place)) {
                fault["line"] = place->line;
                fault["column"] = place->column;
            }
            fault["text"] = in(each.text);
            if (!each.fault.empty()) fault["fault"] = in(each.fault);
            if (!each.remedy.empty()) fault["remedy"] = in(each.remedy);
            answer_["faults"].push_back(std::move(fault));
        }
    }
    void set_position(const DrawnPosition& position) {
        answer_["length"] = {{"unit", position.length_unit}, {"si", position.metres}};
        Json points = Json::object(), directions = Json::object();
        for (const DrawnPosition::Point& each : position.points) points[each.name] = each.at;
        for (const DrawnPosition::Direction& each : position.directions) directions[each.place] = each.angle;
        answer_["points"] = std::move(points);
        answer_["directions"] = std::move(directions);
    }
    void add_sound_position(const Diagnostics& faults) {
        if (const auto position = sound_position(text_, name_, faults)) set_position(*position);
    }
    /// False where the points cannot be placed; then the faults are in the answer.
    bool add_position(const MechanismFile& file) {
        const auto position = file.drawn_position();
        if (!position) {
            add_faults(position.error(), text_);
            if (wants("position")) add_sound_position(position.error());
            return false;
        }
        if (wants("position")) set_position(*position);
        return true;
    }
    void add_mobility(const MechanismFile& file) {
        answer_["mobility"] = nullptr;
        const auto pairs = file.pairs(TextForm::json, options_.drawing.language);
        if (pairs) answer_["mobility"] = Json::parse(*pairs)["mobility"];
    }

    void add_words() {
        const Language language = options_.drawing.language;
        Json words = Json::object();
        const lang::Section& section = lang::workbench_section;
        for (std::size_t i = 0; i < section.size(); ++i) words[section.name(i)] = section.text(i, language);
        answer_["words"] = std::move(words);
    }
    /// The hashes of the live page's script and style, read from the policy that a live page has.
    void add_policy() {
        const auto smallest =
            MechanismFile::parse(R"({"kinegraph": 1, "points": {}, "bodies": {}, "joints": []})", "page");
        const auto solved = smallest->solve();
        const auto page = solved ? live_page(*solved, options_.drawing) : tl::unexpected(solved.error());
        if (!page) return add_faults(page.error(), "");
        const auto source = [&](const std::string& directive) {
            const std::size_t at = page->html.find(directive + " ") + directive.size() + 1;
            return page->html.substr(at, page->html.find(';', at) - at);
        };
        answer_["policy"] = {{"script", source("script-src")}, {"style", source("style-src")}};
    }

    Json imported() {
        const auto taken = import_pmks(text_);
        if (!taken) {
            add_faults(taken.error(), "");
            return answer_;
        }
        answer_["imported"] = taken->file;
        add_texts("remarks", taken->remarks);
        return answer_;
    }
    void add_cycle(const MechanismFile& file) {
        auto sweep = Sweep::of(file);
        if (!sweep) return add_faults(sweep.error(), text_);
        std::string rows;
        const auto write = [&rows](std::string_view piece) {
            rows += piece;
            return true;
        };
        if (const auto written = sweep->write({{RowsText::Form::csv, write}}); !written)
            return add_faults(written.error(), text_);
        answer_["cycle"] = std::move(rows);
    }

    void add_solution(const MechanismFile& file) {
        if (!wants_drawing() && !wants("results") && !wants("values")) return;
        const auto with = [&](std::string_view what) {
            return std::find(options_.with.begin(), options_.with.end(), what) != options_.with.end();
        };
        options_.drawing.lever = with("joukowsky");
        options_.drawing.theme = options_.theme;
        const auto solved = file.solve({with("equations"), with("virtual work"), wants_drawing()});
        if (!solved) return add_faults(solved.error(), text_);
        add_texts("remarks", solved->remarks(Remedies::by_tools));
        for (const Solved::Missing& each : solved->unsolved(Remedies::by_tools))
            answer_["unsolved"].push_back({{"what", in(each.what)}, {"why", in(each.reason)}});
        if (wants("results")) answer_["results"] = solved->json(options_.exact);
        if (wants("values")) add_values(*solved);
        if (wants("sentences")) {
            answer_["sentences"] = Json::array();
            add_texts_as_they_are("sentences", solved->statements());
        }
        add_drawings(*solved);
    }
    void add_texts_as_they_are(const char* key, const std::vector<Text>& texts) {
        for (const Text& each : texts) answer_[key].push_back(in(each));
    }
    void add_values(const Solved& solved) {
        Json values = Json::array();
        for (const ResultValue& each : solved.values())
            values.push_back({{"name", each.name}, {"value", each.in_file_unit}, {"unit", each.unit}});
        answer_["values"] = std::move(values);
    }
    void add_drawings(const Solved& solved) {
        for (const auto& [key, sheet] : {std::pair("sheet", Sheet::solution), std::pair("question", Sheet::question),
                                         std::pair("answers", Sheet::answers)})
            if (wants(key)) add_pages(solved, key, sheet);
        if (wants("tex"))
            if (const auto drawing = draw(solved, options_.drawing)) answer_["tex"] = drawing->tex();
        if (wants("geogebra")) {
            if (auto construction = geogebra_xml(solved, options_.drawing))
                answer_["geogebra"] = *std::move(construction);
            else
                add_faults(construction.error(), text_);
        }
        if (wants("names") || !figures_.empty()) add_figures(solved);
        if (!wants("live")) return;
        if (const auto page = live_page(solved, options_.drawing))
            answer_["live"] = page->html;
        else
            add_faults(page.error(), text_);
    }
    void add_pages(const Solved& solved, const char* key, Sheet sheet) {
        DrawingOptions drawing = options_.drawing;
        drawing.sheet = sheet;
        const auto drawn = draw(solved, drawing);
        if (!drawn) return add_faults(drawn.error(), text_);
        answer_[key] = drawn->svg();
        add_texts("remarks", drawn->remarks());
    }
    void add_figures(const Solved& solved) {
        const auto names = figure_names(solved, options_.drawing);
        if (!names) return add_faults(names.error(), text_);
        if (wants("names")) answer_["names"] = *names;
        Json figures = Json::object();
        for (const std::string& name : figures_) {
            if (std::find(names->begin(), names->end(), name) == names->end()) continue;
            DrawingOptions drawing = options_.drawing;
            drawing.figure = name;
            const auto drawn = draw(solved, drawing);
            if (!drawn) return add_faults(drawn.error(), text_);
            figures[name] = drawn->svg().front();
        }
        if (!figures_.empty()) answer_["figures"] = std::move(figures);
    }

    std::string text_, name_;
    std::vector<std::string> want_, figures_;
    Request options_;
    Json answer_ = Json::object();
};

std::string printed_answer(const Json& answer) { return answer.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace

std::string workbench_answer(std::string_view request_json) {
    try {
        // Deeper values are left out: writing options recurses.
        constexpr int deepest = 8;
        const Json request = Json::parse(
            request_json, [](int depth, auto, const Json&) { return depth <= deepest; }, false);
        if (request.is_object()) return printed_answer(Answering(request).answer());
        return printed_answer({{"failure", "the request is no JSON object"}});
    } catch (const std::exception& fault) {
        return printed_answer({{"failure", fault.what()}});
    }
}

}  // namespace kinegraph::app
