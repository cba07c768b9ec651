// Writes the sentences of a solution of forces: names of bodies, symbols of forces, letters of the points where their
// lines meet.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "constructions/statics/force_model.hpp"
#include "constructions/statics/forces/known_forces.hpp"
#include "constructions/statics/free_bodies.hpp"

namespace kinegraph::statics {

class ForceSentences {
public:
    ForceSentences(const ForceModel& model, Board& board, const Mechanism& mechanism, const KnownForces& known)
        : model_(model), board_(board), mechanism_(mechanism), known_(known) {}

    /// The last sentence.
    StatementIndex last() const { return statement_; }
    /// By member.
    const NamedMeets& meets() const { return meets_; }
    /// The structure taken as one free body is a truss; these are the names of its bars.
    void speak_of_truss(std::map<MemberIndex, std::string> bars) {
        of_truss_ = true;
        bar_names_ = std::move(bars);
    }
    /// Sets the name of the member whose loads act alone from now on; empty: all loads act.
    void set_mark(std::string mark) { mark_ = std::move(mark); }
    bool has_mark() const { return !mark_.empty(); }
    /// Symbol of the resultant of known forces on a group.
    Symbol resultant_symbol(const Group& group) const {
        return with_mark({Symbol::Letter::F, "R" + names_of(group), {}});
    }
    Symbol with_mark(Symbol symbol) const { return marked(std::move(symbol), mark_); }

    /// To rewind an attempt together with the board.
    struct Mark {
        StatementIndex statement = none;
        NamedMeets meets;
        std::vector<NamedMeet> named_meets;
    };
    Mark mark() const { return {statement_, meets_, named_meets_}; }
    void rewind(const Mark& mark);

    void say(Key sentence, std::vector<Argument> arguments, const char* source = "", const Group& group = {});
    /// A sentence about a body, or about several taken together; they become its first argument.
    void say_of(const Group& group, Key sentence, std::vector<Argument> arguments, const char* source = "");
    /// Adds to the last sentence what it says of a couple, which is known only now.
    void add(std::vector<Argument> arguments);
    /// Symbol of a bond's force as it acts on a group.
    Symbol symbol_on(int b, const Group& group) const;
    /// Symbol of its couple.
    Symbol couple_on(int b, const Group& group) const;
    /// The action of a bond on a group.
    Quantity quantity_on(int b, const Group& group) const;
    PointName place_name(int b) const;
    std::string names_of(const Group& group) const;
    /// The letter of a point of concurrency, which the next sentence will find.
    std::string meet_name(const Group& group, PlaceOnDrawing place);
    /// The name of a point of the file at this place, else a new letter.
    std::string name_at(const Group& group, PlaceOnDrawing place);

    /// The guide or tangent of a joint of these members that is parallel to a direction; none if no joint has one.
    std::optional<LineReason> guide_along(const Group& group, DirectionHandle way);

private:
    /// The last member that is a body, not a pin (pins come last).
    MemberIndex last_body_of(const Group& group) const;
    static constexpr std::size_t most_members = 8;  ///< of a group that a sentence names one by one
    std::ptrdiff_t bodies_in(const Group& group) const;
    BodyName::As as_what(const Group& group) const;
    std::string free_letter() const;
    void remember_meets();

    const ForceModel& model_;
    Board& board_;
    const Mechanism& mechanism_;
    const KnownForces& known_;
    bool of_truss_ = false;
    std::map<MemberIndex, std::string> bar_names_;
    std::string mark_;
    StatementIndex statement_ = none;
    NamedMeets meets_;
    std::vector<NamedMeet> named_meets_;                          ///< all, each with its letter
    std::vector<std::pair<Group, std::ptrdiff_t>> unsaid_meets_;  ///< by group; indices in named_meets_
};

}  // namespace kinegraph::statics
