// The sections of a file that make an exercise of it: "ask". Each fault where it stands.
#pragma once

#include "engine/exercise.hpp"
#include "engine/problem_reader.hpp"

namespace kinegraph {

/// What the reader of a mechanism file is built on, beside the problems.
class ExerciseReader : protected ProblemReader {
protected:
    /// To be read last, when all that has results is known.
    void read_exercise(const Members& file, Mechanism& mechanism);

private:
    void read_ask(JsonValue ask, const Mechanism& mechanism, Exercise& exercise);
};

}  // namespace kinegraph
