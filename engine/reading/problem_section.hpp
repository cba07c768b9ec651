// The section of a mechanism file that states a problem in place of joints (engine/solution/problem_kind.hpp). Each
// kind of problem reads its own section.
#pragma once

#include <array>
#include <memory>

#include "engine/mechanism/problem.hpp"
#include "engine/reading/form_reader.hpp"
#include "lang/keys/problems.hpp"

namespace kinegraph {

// ----- The "bodies" of a problem in place of joints: an object by name. A body that the file does not list is added.

class ProblemBodies {
public:
    ProblemBodies(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism) {}

    /// The row of "bodies" in the form of a problem; `body` is what each of them is.
    static constexpr FormRow row(const FormValue& body) {
        return FormRow("bodies", "{…}", values::map(body, 2, 2), "The two bodies by name.")
            .needed(lang::problems::an_object_of_two_bodies)
            .called(lang::problems::an_object_of_two_bodies);
    }
    /// The two members of "bodies", or "not there".
    std::array<JsonValue, 2> two(const Members& section);
    /// The body of a member's name, added where the file has none.
    BodyIndex body(JsonValue member);

private:
    FormReader& file_;
    Mechanism& mechanism_;
};

// ----- The section of a file that states a problem in place of joints. Owns which sections may be combined.

class ProblemSection {
public:
    ProblemSection(FormReader& file, Mechanism& mechanism) : file_(file), mechanism_(mechanism) {}

    static bool is_in(const Members& file);
    /// Null where the file has none or it is unreadable. Adds its bodies to the mechanism.
    std::shared_ptr<const Problem> read(const Members& file);

private:
    FormReader& file_;
    Mechanism& mechanism_;
};

}  // namespace kinegraph
