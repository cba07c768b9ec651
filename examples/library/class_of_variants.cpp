// A class of variants, solved and drawn by several threads: class_of_variants FILE COUNT
// Variants are drawn in order by one thread at a time; the sheets, which take most of the time, by all of them.
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <kinegraph/kinegraph.hpp>

int main(int count, char** words) {
    const long wanted = count == 3 ? std::atol(words[2]) : 0;
    if (wanted <= 0) {
        std::cerr << "usage: class_of_variants FILE COUNT\n";
        return 2;
    }
    std::ifstream in(words[1], std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    auto variants = kinegraph::ExerciseVariants::parse(text, words[1], 7);
    if (!variants) {
        std::cerr << variants.error().front().text.in(kinegraph::Language::en) << '\n';
        return 2;
    }
    std::mutex next_variant;
    std::vector<std::string> key;
    std::atomic<std::size_t> bytes = 0;
    std::atomic<bool> failed = false;
    const auto work = [&] {
        while (!failed) {
            std::optional<kinegraph::ExerciseVariant> mine;
            {
                const std::lock_guard lock(next_variant);
                if (key.size() == static_cast<std::size_t>(wanted)) return;
                auto drawn = variants->next();
                if (!drawn || !*drawn) failed = true;
                if (failed) return;
                mine.emplace(**drawn);
                key.push_back(mine->asked.front().name + " = " + std::to_string(mine->asked.front().value));
            }
            const auto sheet = kinegraph::draw(mine->solved);
            if (!sheet) failed = true;
            if (sheet)
                for (const std::string& page : sheet->svg()) bytes += page.size();
        }
    };
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i) threads.emplace_back(work);
    threads.clear();  // waits for them
    for (std::size_t i = 0; i < key.size(); ++i) std::cout << i + 1 << ": " << key[i] << '\n';
    std::cout << bytes << " bytes of sheets\n";
    return failed ? 3 : 0;
}
