#include "tests/fuzz/mutate.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <random>
#include <vector>

namespace kinegraph::fuzz {
namespace {

using Tree = nlohmann::ordered_json;

/// Literals that no double holds stand as strings with this mark until the text is written.
constexpr char mark = '\x01';

class Mutation {
public:
    Mutation(Tree& tree, const Tree& donor, std::uint32_t seed) : tree_(tree), donor_(donor), random_(seed) {}

    void run() {
        if (number(2) == 0) return nudge();
        const int count = 1 + number(4);
        for (int i = 0; i < count; ++i) change();
    }

private:
    int number(std::size_t below) { return static_cast<int>(random_() % std::max<std::size_t>(below, 1)); }
    template <class List>
    auto& any_of(List& list) {
        return list[static_cast<std::size_t>(number(list.size()))];
    }

    /// All values of a tree that `wanted` picks, with the keys of members.
    template <class Json, class Wanted>
    static void gather(Json& at, const std::string& key, const Wanted& wanted,
                       std::vector<std::pair<std::string, Json*>>& into) {
        if (wanted(at)) into.emplace_back(key, &at);
        if (at.is_object())
            for (auto& [name, value] : at.items()) gather<Json>(value, name, wanted, into);
        if (at.is_array())
            for (auto& value : at) gather<Json>(value, key, wanted, into);
    }
    template <class Json, class Wanted>
    static std::vector<std::pair<std::string, Json*>> all(Json& tree, const Wanted& wanted) {
        std::vector<std::pair<std::string, Json*>> found;
        gather<Json>(tree, "", wanted, found);
        return found;
    }
    static bool anything(const Tree&) { return true; }
    static bool is_number(const Tree& at) { return at.is_number(); }
    static bool is_text(const Tree& at) { return at.is_string(); }
    static bool is_row(const Tree& at) { return at.is_array() && !at.empty(); }
    static bool is_object(const Tree& at) { return at.is_object(); }

    void change() {
        switch (number(12)) {
            case 0:
            case 1:
            case 2: return change_number();
            case 3:
            case 4: return swap_names();
            case 5: return swap_subtrees();
            case 6: return take_out();
            case 7: return repeat();
            case 8:
            case 9: return take_from_donor();
            case 10: return rename_key();
            default: return grow();
        }
    }

    /// One to three numbers by some percent: mostly a mechanism still, in another position, which is drawn.
    void nudge() {
        auto numbers = all<Tree>(tree_, is_number);
        std::erase_if(numbers, [](const auto& each) {
            const std::string& key = each.first;  // the version of the format, and numbers that are names
            return key == "kinegraph" || key == "frame" || key == "body" || key == "bodies";
        });
        if (numbers.empty()) return change();
        for (int i = 1 + number(3); i > 0; --i) {
            Tree& at = *any_of(numbers).second;
            at = at.get<double>() * (1 + (number(101) - 50) * 1e-3);
        }
    }

    void change_number() {
        auto numbers = all<Tree>(tree_, is_number);
        if (numbers.empty()) return;
        Tree& at = *any_of(numbers).second;
        const double value = at.get<double>();
        static constexpr std::array odd{0.0, 1.0, -1.0, 90.0, 45.0, 180.0, 1e-9, 1e59, 1e-59, 1e61, 0.1, 1e9};
        switch (number(8)) {
            case 0: at = any_of(odd); return;
            case 1: at = -value; return;
            case 2: at = value * 10; return;
            case 3: at = value + (number(2001) - 1000) * 1e-3; return;
            case 4: at = value * (1 + 1e-12); return;
            case 5: {
                std::string digits = mark + std::to_string(number(200)) + '.';
                for (int i = 10 + number(890); i > 0; --i) digits += static_cast<char>('0' + number(10));
                at = digits;
                return;
            }
            case 6: at = std::to_string(value) + any_of(units_); return;
            default: at = *any_of(numbers).second;
        }
    }

    void swap_names() {
        auto texts = all<Tree>(tree_, is_text);
        if (texts.empty()) return;
        Tree other = *any_of(texts).second;
        std::swap(*any_of(texts).second, other);
    }

    /// Of members of one key mostly, so that what comes out may be read.
    void swap_subtrees() {
        auto values = all<Tree>(tree_, anything);
        const auto one = any_of(values), other = any_of(values);
        if (one.first != other.first && number(4) != 0) return swap_subtrees_of(one.first, values);
        *one.second = Tree(*other.second);
    }
    void swap_subtrees_of(const std::string& key, std::vector<std::pair<std::string, Tree*>>& values) {
        std::erase_if(values, [&](const auto& each) { return each.first != key; });
        Tree copy = *any_of(values).second;
        *any_of(values).second = std::move(copy);
    }

    void take_out() {
        auto rows = all<Tree>(tree_, [](const Tree& at) { return is_row(at) || (at.is_object() && !at.empty()); });
        if (rows.empty()) return;
        Tree& at = *any_of(rows).second;
        if (at.is_array()) {
            at.erase(static_cast<std::size_t>(number(at.size())));
        } else {
            auto member = at.begin();
            std::advance(member, number(at.size()));
            at.erase(member.key());
        }
    }

    void repeat() {
        auto rows = all<Tree>(tree_, is_row);
        if (rows.empty()) return;
        Tree& at = *any_of(rows).second;
        at.push_back(Tree(any_of(at)));
    }

    void take_from_donor() {
        const auto values = all<const Tree>(donor_, anything);
        const auto given = any_of(values);
        const std::string& key = given.first;
        const Tree* const value = given.second;
        auto same = all<Tree>(tree_, is_object);
        std::erase_if(same, [&](const auto& each) { return !each.second->contains(key); });
        if (key.empty() || same.empty()) {
            auto objects = all<Tree>(tree_, is_object);
            if (!key.empty() && !objects.empty()) (*any_of(objects).second)[key] = *value;
            return;
        }
        Tree& at = (*any_of(same).second)[key];
        if (at.is_array() && !value->is_array())
            at.push_back(*value);
        else
            at = *value;
    }

    void rename_key() {
        auto objects = all<Tree>(tree_, [](const Tree& at) { return at.is_object() && !at.empty(); });
        const auto others = all<const Tree>(donor_, anything);
        if (objects.empty()) return;
        Tree& at = *any_of(objects).second;
        auto member = at.begin();
        std::advance(member, number(at.size()));
        const Tree value = member.value();
        const std::string key = member.key();
        at.erase(key);
        at[number(2) != 0 ? any_of(others).first + "" : key + std::to_string(number(9))] = value;
    }

    /// Points and bodies more, as a file may have many.
    void grow() {
        for (const char* list : {"points", "bodies"}) {
            if (!tree_.is_object() || !tree_.contains(list) || !tree_[list].is_object() || tree_[list].empty())
                continue;
            auto member = tree_[list].begin();
            std::advance(member, number(tree_[list].size()));
            const Tree value = member.value();
            for (int i = number(12); i > 0; --i) {
                const std::string name = "g" + std::to_string(number(100));
                tree_[list][name] = value;
                if (number(2) != 0 && std::string_view(list) == "points" && tree_.contains("bodies") &&
                    tree_["bodies"].is_object() && !tree_["bodies"].empty()) {
                    auto body = tree_["bodies"].begin();
                    std::advance(body, number(tree_["bodies"].size()));
                    if (body.value().is_array()) body.value().push_back(name);
                }
            }
        }
    }

    static constexpr std::array units_{" mm", " m", " rpm", " rad/s", "°", " N", " kN m", " kg", " mm/s²", " parsec"};
    Tree& tree_;
    const Tree& donor_;
    std::minstd_rand random_;
};

/// "\u0001 3.14…" without quotes.
std::string with_long_literals(std::string text) {
    static const std::string begin = "\"\\u0001";
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
        text.erase(at, begin.size());
        if (const std::size_t end = text.find('"', at); end != std::string::npos) text.erase(end, 1);
    }
    return text;
}

}  // namespace

std::string mutated(std::string_view text, std::string_view donor, std::uint32_t seed) {
    Tree tree = Tree::parse(text, nullptr, false);
    if (tree.is_discarded()) return {};
    Tree other = Tree::parse(donor, nullptr, false);
    if (other.is_discarded()) other = tree;
    Mutation(tree, other, seed).run();
    return with_long_literals(tree.dump(-1, ' ', false, Tree::error_handler_t::replace));
}

}  // namespace kinegraph::fuzz
