// Solves a mechanism file, prints two results and writes the worked solution: solve_and_draw FILE OUT.svg
#include <fstream>
#include <iostream>

#include <kinegraph/kinegraph.hpp>

namespace {

int refuse(const kinegraph::Diagnostics& faults) {
    for (const kinegraph::Diagnostic& each : faults)
        std::cerr << each.place << ": " << each.text.in(kinegraph::Language::en) << '\n';
    return 2;
}

}  // namespace

int main(int count, char** words) {
    if (count != 3) {
        std::cerr << "usage: solve_and_draw FILE OUT.svg\n";
        return 2;
    }
    const auto file = kinegraph::MechanismFile::open(words[1]);
    if (!file) return refuse(file.error());
    const auto solved = file->solve();
    if (!solved) return refuse(solved.error());
    for (const kinegraph::ResultValue& each : solved->values())
        if (each.name.starts_with("omega "))
            std::cout << each.name << " = " << each.in_file_unit << ' ' << each.unit
                      << (each.exact ? " (exactly " + each.exact->text() + " rad/s)" : "") << '\n';
    const auto drawing = kinegraph::draw(*solved);
    if (!drawing) return refuse(drawing.error());
    std::ofstream(words[2], std::ios::binary) << drawing->svg().front();
    return 0;
}
