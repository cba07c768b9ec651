// pairs [FILE]: the catalogue of pairs, or the pairs of a mechanism with its counts and its verdict.
#include "app/commands.hpp"
#include "app/files.hpp"
#include "constructions/degeneracy.hpp"
#include "engine/mechanism.hpp"
#include "engine/pose.hpp"
#include "render/tables/pair_tables.hpp"

namespace kinegraph::app {
Status pairs_command(const PairsRequest& request) {
    if (request.file.empty()) return print(render::pair_catalogue(request.language, request.form));
    const std::string name = spoken(request.file);
    const auto text = read_whole(request.file, "mechanism file");
    if (!text) {
        say(name, text.error());
        return Status::bad_input;
    }
    const auto mechanism = read_mechanism(*text, bare_name(request.file));
    if (!mechanism) return say(name, mechanism.error());
    const auto pose = draw_pose(*mechanism);
    if (!pose) return say(name, pose.error());
    const Mobility mobility = mobility_of(*mechanism, *pose);
    return print(render::pair_report(*mechanism, mobility,
                                     remarks_on_mobility(*mechanism, mobility, degenerate_motion(*mechanism, *pose, mobility)),
                                     request.language, request.form));
}

}  // namespace kinegraph::app
