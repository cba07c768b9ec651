#include "app/editor/faults.hpp"

#include <algorithm>

#include <kinegraph/mechanism.hpp>
#include <kinegraph/motion.hpp>
#include <nlohmann/json.hpp>

#include "app/editor/lines.hpp"
#include "app/files/outline.hpp"

namespace kinegraph::app {
namespace {

class FaultFinder {
public:
    FaultFinder(const std::string& text, Language language)
        : text_(text), outline_(text), lines_(text), language_(language) {}

    bool is_ours(const std::string& name) const {
        return name.ends_with(".kinegraph.json") || outline_.member(outline_.root(), "kinegraph") != Outline::none;
    }

    std::vector<FaultInText> all() {
        const auto file = MechanismFile::parse(text_, "");
        if (!file) {
            const bool is_cam = file.error().size() == 1 && file.error().front().place == "/cam";
            const auto cam = is_cam ? CamFile::parse(text_, "") : tl::unexpected(file.error());
            if (!cam) add(cam.error());
            return found_;
        }
        const auto remarks = file->check();
        if (!remarks) {
            add(remarks.error());
            return found_;
        }
        const std::uint32_t version = outline_.member(outline_.root(), "kinegraph");
        for (const Text& each : *remarks) add(version, each.in(language_), true);
        return found_;
    }

private:
    void add(const Diagnostics& faults) {
        for (const Diagnostic& each : faults) {
            const std::string& words = each.text.in(language_);
            if (!each.place.empty() || !add_syntax(words)) add(outline_.at(each.place), words, false);
        }
    }
    /// Where the text is no JSON: there. The reader of files has the same parser, and names the place in words.
    bool add_syntax(const std::string& words) {
        try {
            return nlohmann::json::parse(text_).is_discarded();
        } catch (const nlohmann::json::parse_error& fault) {
            const std::size_t at = std::min(fault.byte > 0 ? fault.byte - 1 : 0, text_.size());
            found_.push_back({at, std::min(at + 1, text_.size()), words});
            return true;
        } catch (const nlohmann::json::exception&) {
            return false;  // a number too large for the parser, which the reader reads
        }
    }
    /// A member on one line as a whole, otherwise its key; of an element and of the file what stands on the first line.
    void add(std::uint32_t node, const std::string& words, bool is_remark) {
        if (node == Outline::none) return found_.push_back({0, 0, words, is_remark});
        const Outline::Node& value = outline_[node];
        const std::size_t begin = value.has_key() ? value.key_begin : value.begin;
        const std::size_t line = lines_.end_of_line(begin);
        const std::size_t end = value.end <= line ? value.end : value.has_key() ? value.key_end : line;
        found_.push_back({begin, end, words, is_remark});
    }

    const std::string& text_;
    Outline outline_;
    Lines lines_;
    Language language_;
    std::vector<FaultInText> found_;
};

}  // namespace

std::vector<FaultInText> faults_in(const std::string& text, const std::string& name, Language language) {
    FaultFinder finder(text, language);
    return finder.is_ours(name) ? finder.all() : std::vector<FaultInText>{};
}

}  // namespace kinegraph::app
