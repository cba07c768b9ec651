#include "render/page/label_key.hpp"

#include <algorithm>

#include "render/page/shapes.hpp"

namespace kinegraph::render {
namespace {

constexpr double one_place = 3;      // mm; nearer numbers share one place
constexpr double number_size = 7.5;  // points
constexpr double entry_size = 9;
constexpr double clear_of_point = 1;                 // mm between a number and its object
constexpr double least_ring = 1.9, ring_pen = 0.25;  // of the circle round a body's number, mm
constexpr double after_number = 1.2, between_labels = 2.4, between_entries = 4, between_lines = 0.8;

}  // namespace

RichText LabelKey::number(int count) { return one_piece(std::to_string(count) + ")", Face::bold); }

void LabelKey::take(std::vector<LabelRequest>& requests, const std::vector<std::size_t>& placeless) {
    // The numbers are the last requests, one per entry that has one.
    std::vector<Entry*> numbered;
    for (Entry& entry : entries_)
        if (entry.numbered) numbered.push_back(&entry);
    const std::size_t names = requests.size() - numbered.size();
    for (const std::size_t i : placeless)
        if (i >= names) numbered[i - names]->numbered = false;
    for (const std::size_t i : placeless) {
        if (i >= names) continue;
        const auto near = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
            return entry.numbered && length(entry.anchor - requests[i].anchor) < one_place;
        });
        if (near != entries_.end())
            near->labels.push_back(requests[i]);
        else
            entries_.push_back({requests[i].anchor, {requests[i]}, true});
    }
    std::vector<LabelRequest> left;
    for (std::size_t i = 0; i < names; ++i)
        if (!std::binary_search(placeless.begin(), placeless.end(), i)) left.push_back(std::move(requests[i]));
    requests = std::move(left);
    int count = 0;
    for (const Entry& entry : entries_) {
        if (!entry.numbered) continue;
        LabelRequest request;
        request.text = number(++count);
        request.size = number_size;
        request.colour = entry.labels.front().colour;
        request.anchor = entry.anchor;
        request.clearance = clear_of_point;
        request.statement = entry.labels.front().statement;
        requests.push_back(std::move(request));
    }
}

std::vector<LabelKey::Word> LabelKey::words(double measure) const {
    std::vector<Word> words;
    const auto add = [&](const Entry& entry, const RichText& number) {
        words.push_back({fonts_.shape(number, entry_size), nullptr, between_entries, 0});
        for (std::size_t i = 0; i < entry.labels.size(); ++i) {
            const LabelRequest& label = entry.labels[i];
            Word word{shaped_within(label.text, entry_size, fonts_, 0.9 * measure), &label,
                      i == 0 ? after_number : between_labels, 0};
            if (label.balloon > 0) word.ring = std::max(least_ring, 0.5 * word.shaped.width + 0.6);
            words.push_back(std::move(word));
        }
    };
    int count = 0;
    for (const Entry& entry : entries_)
        if (entry.numbered) add(entry, number(++count));
    for (const Entry& entry : entries_)
        if (!entry.numbered) add(entry, one_piece("–"));
    return words;
}

/// As many words as fit into a line; a number stays with the word after it.
std::size_t LabelKey::end_of_line(const std::vector<Word>& words, std::size_t first, double measure) {
    double x = words[first].width();
    std::size_t end = first + 1;
    for (; end < words.size(); ++end) {
        double more = words[end].before + words[end].width();
        if (!words[end].label && end + 1 < words.size()) more += words[end + 1].before + words[end + 1].width();
        if (x + more > measure && words[end - 1].label) break;
        x += words[end].before + words[end].width();
    }
    return end;
}

/// `origin`: of its letters. `looks`: the label itself, or the label whose number it is.
void LabelKey::set_word(std::vector<Mark>& marks, const Word& word, const LabelRequest& looks, Spot origin) {
    const std::size_t own = marks.size();
    if (word.ring > 0) {
        const Spot middle = origin + Spot{word.shaped.width / 2, (word.shaped.descent - word.shaped.ascent) / 2};
        marks.emplace_back(circle(middle, word.ring, {ring_pen, looks.colour, {}, false}));
    }
    const std::size_t text = marks.size();
    set_text(marks, word.shaped, origin, looks.colour, word.label ? "label" : "text");
    if (word.label) std::get<TextMark>(marks[text]).in_file = word.label->in_file;
    for (std::size_t k = text + 1; k < marks.size(); ++k) std::get<TextMark>(marks[k]).cls = "text";
    belong(marks, own, looks.statement);
}

LabelKey::Lines LabelKey::lines(Spot at, double measure) const {
    const std::vector<Word> words = this->words(measure);
    Lines lines;
    for (std::size_t first = 0; first < words.size();) {
        const std::size_t end = end_of_line(words, first, measure);
        double ascent = 0, descent = 0;
        for (std::size_t i = first; i < end; ++i) {
            const ShapedLine& shaped = words[i].shaped;
            const double more = std::max(0.0, words[i].ring - (shaped.ascent + shaped.descent) / 2);
            ascent = std::max(ascent, shaped.ascent + more);
            descent = std::max(descent, shaped.descent + more);
        }
        double x = 0;
        for (std::size_t i = first; i < end; ++i) {
            const Word& word = words[i];
            if (i > first) x += word.before;
            const Spot origin = at + Spot{x + (word.width() - word.shaped.width) / 2, lines.height + ascent};
            set_word(lines.marks, word, word.label ? *word.label : *words[i + 1].label, origin);
            x += word.width();
        }
        lines.width = std::max(lines.width, x);
        lines.height += ascent + descent + between_lines;
        first = end;
    }
    return lines;
}

}  // namespace kinegraph::render
