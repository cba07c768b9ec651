// Exercises, read.
#include "engine/exercise_reader.hpp"

#include <algorithm>

#include "engine/result_names.hpp"

namespace kinegraph {

void ExerciseReader::read_exercise(const Members& file, Mechanism& mechanism) {
    if (!file["ask"]) return;
    Exercise exercise;
    read_ask(file["ask"], mechanism, exercise);
    // What results go by is known only where all that has them could be read.
    mechanism.exercise = std::make_shared<const Exercise>(std::move(exercise));
}

void ExerciseReader::read_ask(JsonValue ask, const Mechanism& mechanism, Exercise& exercise) {
    const Words wanted("an array of names of results, such as \"omega 3\"", "un array di nomi di risultati, come \"omega 3\"");
    if (!expect(ask, Kind::array, wanted)) return;
    if (ask.size() == 0)
        fault(ask, {"nothing is asked for; take \"ask\" out, or name a result",
                    "non si chiede nulla; togliere \"ask\", o indicare un risultato"});
    const bool knows_names = faults_.empty() && !mechanism.problem;
    const std::vector<Column> known = knows_names ? possible_results(mechanism) : std::vector<Column>();
    for (const JsonValue value : ask) {
        if (!expect(value, Kind::string,
                    {"the name of a result, such as \"omega 3\"", "il nome di un risultato, come \"omega 3\""}))
            continue;
        const std::string_view name = value.text();
        const auto is_it = [&](const auto& each) { return each.name == name; };
        if (std::any_of(exercise.ask.begin(), exercise.ask.end(), is_it))
            fault(value, {"{0} is asked for twice; take one out", "{0} è chiesto due volte; toglierne uno", quoted(name)});
        if (knows_names && name != transmission_angle_name && std::none_of(known.begin(), known.end(), is_it)) {
            std::vector<std::string_view> names{transmission_angle_name};
            for (const Column& each : known) names.emplace_back(each.name);
            fault(value, {"no result is named {0}{1}; names are those of the columns of \"sweep\"",
                          "nessun risultato si chiama {0}{1}; i nomi sono quelli delle colonne di \"sweep\"", quoted(name),
                          did_you_mean(speller_.nearest(name, names))});
        }
        exercise.ask.push_back({std::string(name), value.pointer()});
    }
}

}  // namespace kinegraph
