// check FILE: reads and validates a mechanism file, curves that cannot meet included.
#include "app/commands.hpp"
#include "app/files.hpp"
#include "engine/mechanism.hpp"
#include "engine/pose.hpp"
#include "render/text/words.hpp"

namespace kinegraph::app {

std::string spoken(const std::string& file) { return file == "-" ? "standard input" : file; }

std::string bare_name(const std::string& file) {
    const std::string name = spoken(file);
    return name.substr(name.rfind('/') + 1);
}

Status check_command(const std::string& file) {
    const std::string name = spoken(file);
    const auto text = read_whole(file, "mechanism file");
    if (!text) {
        say(name, text.error());
        return Status::bad_input;
    }
    const auto mechanism = read_mechanism(*text, bare_name(file));
    if (!mechanism) return say(name, mechanism.error());
    const auto pose = draw_pose(*mechanism);
    if (!pose) return say(name, pose.error());
    for (const Message& remark : pose->remarks) say(name, "remark: " + render::tell(remark, render::Language::en));
    const auto counted = [](std::size_t count, const char* thing) {
        return std::to_string(count) + ' ' + thing + (count == 1 ? "" : "s");
    };
    const std::string line = one_line(name) + ": in order (" +
                             (mechanism->bodies.size() == 1 ? "one body" : std::to_string(mechanism->bodies.size()) + " bodies") +
                             ", " + counted(mechanism->joints.size(), "joint") + ", " +
                             counted(mechanism->drivers.size(), "driver") + ")\n";
    return print(line);
}

}  // namespace kinegraph::app
