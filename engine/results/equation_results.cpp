// The closure equations and virtual work in the results file.
#include <variant>

#include "engine/equations/equations.hpp"
#include "engine/results/results.hpp"
#include "engine/solution/displacements.hpp"
#include "engine/solution/solution.hpp"

namespace kinegraph {
namespace {

/// The equations by name: variables are named by body or joint, equations are written in letters.
class EquationResults {
public:
    EquationResults(const Equations& equations, JsonWriter& json) : e_(equations), json_(json) {}

    void write() const {
        json_.open('{', JsonWriter::Entries::on_lines);
        names("unknowns", e_.unknowns);
        names("free", e_.free);
        json_.member("jacobian", e_.jacobian).member("drive", e_.drive).member("rank", e_.rank);
        json_.member("determinant", e_.determinant);
        ratios();
        if (!e_.second_ratios.empty()) second_ratios();
        if (!e_.cannot_be_driven.empty()) names("cannot be driven", e_.cannot_be_driven);
        json_.key("loops").open('[');
        for (const Equations::Loop& loop : e_.loops) json_.value(spelt(e_, loop));
        json_.close();
        if (!e_.laws.empty()) {
            json_.key("laws").open('[');
            for (const Equations::Law& law : e_.laws) json_.value(spelt(e_, law));
            json_.close();
        }
        letters();
        json_.close();
    }

private:
    const std::string& name(Equations::LetterIndex index) const { return e_.letter(index).name; }
    void names(std::string_view key, const std::vector<Equations::LetterIndex>& which) const {
        json_.key(key).open('[');
        for (const auto index : which) json_.value(name(index));
        json_.close();
    }
    void ratios() const {
        json_.key("velocity ratios").open('{');
        for (std::size_t j = 0; j < e_.unknowns.size(); ++j) {
            json_.key(name(e_.unknowns[j])).open('{');
            for (std::size_t k = 0; k < e_.free.size(); ++k) json_.member(name(e_.free[k]), e_.ratios[j][k]);
            json_.close();
        }
        json_.close();
    }
    /// By the drivers' names; for two drivers, joined with a comma.
    void second_ratios() const {
        json_.key("second ratios").open('{');
        for (std::size_t j = 0; j < e_.unknowns.size(); ++j) {
            json_.key(name(e_.unknowns[j])).open('{');
            for (std::size_t k = 0; k < e_.free.size(); ++k)
                for (std::size_t l = k; l < e_.free.size(); ++l) {
                    const std::string& first = name(e_.free[k]);
                    json_.member(l == k ? first : first + ", " + name(e_.free[l]), e_.second_ratios[j][k][l]);
                }
            json_.close();
        }
        json_.close();
    }
    void letters() const {
        json_.key("letters").open('{');
        for (const Equations::Letter& letter : e_.letters) {
            json_.key(spelt(letter)).open('{');
            if (!letter.name.empty()) json_.member("of", letter.name);
            json_.member("value", letter.value);
            if (letter.role != Equations::Letter::Role::given)
                json_.member("rate", letter.rate).member("second rate", letter.acceleration);
            json_.close();
        }
        json_.close();
    }

    const Equations& e_;
    JsonWriter& json_;
};

/// Virtual work: the displacements, the work per unit of them, and the efforts.
class DisplacementResults {
public:
    DisplacementResults(const Mechanism& mechanism, const Displacements& found, JsonWriter& json)
        : mechanism_(mechanism), found_(found), json_(json) {}

    void write() const {
        json_.open('{', JsonWriter::Entries::on_lines).key("freedoms").open('[');
        for (const Displacements::Freedom& freedom : found_.freedoms) write(freedom);
        json_.close().key("effort").open('{');
        for (const Displacements::Effort& effort : found_.efforts) json_.member(name(effort.given), effort.value);
        json_.close().key("effort by velocity ratios").open('{');
        for (const Displacements::Effort& effort : found_.efforts) json_.member(name(effort.given), effort.ratio);
        json_.close().member("balanced", found_.balanced).close();
    }

private:
    std::string name(int effort) const {
        return std::visit([](const auto& given) { return given.name; }, mechanism_.efforts[at_index(effort)]);
    }
    void write(const Displacements::Freedom& freedom) const {
        const VirtualWork& work = *freedom.moved->virtual_work;
        json_.open('{').member("displaced", coordinate_name(mechanism_, freedom.driver));
        json_.member("chosen", freedom.chosen).key("points").open('{');
        for (const PointMotion& point : freedom.moved->points)
            if (point.bodies.front() != frame && point.velocity) json_.member(point.label, *point.velocity);
        json_.close().key("turns").open('{');
        for (const BodyIndex body : mechanism_.moving_bodies())
            if (const auto& turn = freedom.moved->bodies[at_index(body)].omega)
                json_.member(mechanism_.body(body).name, *turn);
        json_.close().key("works").open('[');
        for (const VirtualWork::Entry& entry : work.entries) {
            json_.open('{').member("of", name_of(entry.symbol)).member("on", mechanism_.body(entry.body).name);
            json_.member("work", entry.power).member("by velocity ratios", work_by_ratios(*freedom.equations, entry));
            json_.close();
        }
        json_.close().member("given", work.total).key("unit efforts").open('{');
        for (const VirtualWork::Share& share : work.shares) json_.member(name(share.effort), *share.power);
        json_.close().close();
    }

    const Mechanism& mechanism_;
    const Displacements& found_;
    JsonWriter& json_;
};

}  // namespace

void write_displacements(const Mechanism& mechanism, const Displacements& displacements, JsonWriter& json) {
    DisplacementResults(mechanism, displacements, json).write();
}

void write_equations(const Equations& equations, JsonWriter& json) { EquationResults(equations, json).write(); }

}  // namespace kinegraph
