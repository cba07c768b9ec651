// Uses the installed library as its users do: files are solved and drawn in threads of their own, with no call before
// or after. The motion of a point needs GiNaC, a PNG cairo, live text HarfBuzz's subsetter.
#include <iostream>
#include <thread>
#include <vector>

#include <kinegraph/kinegraph.hpp>

namespace {

constexpr const char* projectile = R"({"kinegraph": 1, "motion": {"point": "P", "x": "v*t", "y": "h - g*t^2/2",
    "constants": {"v": "20 m/s", "h": "30 m", "g": "9.81 m/s²"}, "at": "1 s", "from": 0, "to": "2 s"}})";

/// Bytes drawn, 0 where anything fails.
std::size_t drawn() {
    const auto file = kinegraph::MechanismFile::parse(projectile, "projectile");
    if (!file) return 0;
    const auto solved = file->solve();
    if (!solved) return 0;
    const auto sheet = kinegraph::draw(*solved);
    if (!sheet) return 0;
    const auto png = sheet->png(0, 50), pdf = sheet->pdf();
    if (!png || !pdf) return 0;
    return sheet->svg(kinegraph::Lettering::live).front().size() + png->size() + pdf->size();
}

}  // namespace

int main() {
    if (kinegraph::mechanism_schema().empty()) return 1;
    std::vector<std::size_t> bytes(2);
    std::vector<std::thread> threads;
    for (std::size_t& each : bytes) threads.emplace_back([&each] { each = drawn(); });
    for (std::thread& thread : threads) thread.join();
    std::cout << bytes[0] << " bytes\n";
    return bytes[0] > 0 && bytes[0] == bytes[1] ? 0 : 1;
}
