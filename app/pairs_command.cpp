// pairs [FILE]: the catalogue of pairs, or the pairs of a mechanism with its counts and its verdict.
#include "app/commands.hpp"
#include "app/files.hpp"
#include "constructions/degeneracy.hpp"
#include "engine/mechanism.hpp"
#include "engine/pose.hpp"
#include "render/tables/pair_tables.hpp"

namespace kinegraph::app {
Status pairs_command(const PairsRequest& request) {
    if (request.file.empty()) return print(render::pair_catalogue(request.language, request.form), request.language);
    const auto mechanism = mechanism_of(request.file, request.language);
    if (!mechanism) return mechanism.error();
    if (mechanism->problem) {
        say(spoken(request.file), no_mechanism("pairs"), request.language);
        return Status::bad_input;
    }
    const auto pose = draw_pose(*mechanism);
    if (!pose) return say(spoken(request.file), pose.error(), request.language);
    const Mobility mobility = mobility_of(*mechanism, *pose);
    return print(render::pair_report(*mechanism, mobility,
                                     remarks_on_mobility(*mechanism, mobility, degenerate_motion(*mechanism, *pose, mobility)),
                                     request.language, request.form),
                 request.language);
}

}  // namespace kinegraph::app
