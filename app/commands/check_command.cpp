// check FILE: reads and validates a mechanism file, including curves that cannot meet, and reports likely mistakes; or
// the file of a cam.
#include "app/commands/commands.hpp"
#include "app/files/files.hpp"
#include "lang/keys/command_line.hpp"
#include "lang/keys/common.hpp"

namespace kinegraph::app {

std::string bare_name(const std::string& file) {
    const std::string name = spoken(file).in(Language::en);
    return name.substr(name.rfind('/') + 1);
}

tl::expected<MechanismFile, Status> mechanism_of(const std::string& file, Language language,
                                                 const std::vector<ParameterValue>& set) {
    const auto text = read_whole(file, {lang::common::mechanism_file});
    if (!text) {
        say(spoken(file), text.error(), language);
        return tl::unexpected(Status::bad_input);
    }
    auto mechanism = MechanismFile::parse(*text, bare_name(file), set);
    if (!mechanism) return tl::unexpected(say(spoken(file), mechanism.error(), language));
    return *std::move(mechanism);
}

Words no_mechanism(const char* command) {
    return {lang::command_line::is_for_mechanisms_this_file, std::string(command)};
}

namespace {

/// "one body, 4 joints, 1 driver", or what a file without joints is about.
Words contents_of(const MechanismFile& file) {
    if (!file.has_joints()) {
        const auto solved = file.solve();
        return solved ? Words(solved->subject()) : Words();
    }
    const auto counted = [](std::size_t count, const Words& one, const Words& more) {
        return Words(std::to_string(count) + ' ') + (count == 1 ? one : more);
    };
    const MechanismFile::Counts counts = file.counts();
    return formula_words(
        "{0}, {1}, {2}",
        {counts.bodies == 1 ? Words(lang::command_line::one_body)
                            : counted(counts.bodies, {lang::command_line::body}, {lang::command_line::bodies}),
         counted(counts.joints, {lang::common::joint}, {lang::command_line::joints}),
         counted(counts.drivers, {lang::command_line::driver}, {lang::command_line::drivers})});
}

/// Whether the one fault is that a cam stands in the file.
bool are_of_a_cam(const Diagnostics& faults) { return faults.size() == 1 && faults.front().place == "/cam"; }

Status check_cam(const std::string& text, const CheckRequest& request) {
    const Words name = spoken(request.file);
    const auto cam = CamFile::parse(text, bare_name(request.file));
    if (!cam) return say(name, cam.error(), request.language);
    const Words line(lang::command_line::in_order_a_cam, one_line(in(name, request.language)));
    return print(in(line, request.language), request.language);
}

}  // namespace

Status check_command(const CheckRequest& request) {
    const Language language = request.language;
    const Words name = spoken(request.file);
    const auto text = read_whole(request.file, {lang::common::mechanism_file});
    if (!text) {
        say(name, text.error(), language);
        return Status::bad_input;
    }
    const auto file = MechanismFile::parse(*text, bare_name(request.file), request.set);
    if (!file) return are_of_a_cam(file.error()) ? check_cam(*text, request) : say(name, file.error(), language);
    const auto remarks = file->check();
    if (!remarks) return say(name, remarks.error(), language);
    remark(name, *remarks, language);
    const Words line(lang::command_line::in_order, one_line(in(name, language)), contents_of(*file));
    return print(in(line, language), language);
}

}  // namespace kinegraph::app
