#include "constructions/kinematics/planning/inputs.hpp"

#include <algorithm>

namespace kinegraph::planning {
namespace {

void add_inputs(const Locus& locus, Quantities& inputs) {
    if (locus.base != none) inputs.tips.insert(locus.base);
    if (locus.kind == Locus::Kind::image) inputs.spins.insert(locus.body);
    for (const Carry& carry : locus.carries) {
        if (carry.kind == Carry::Kind::image) inputs.spins.insert(carry.body);
    }
}

void add_inputs(const Step& step, Quantities& inputs) {
    switch (step.kind) {
        case Step::Kind::spin_by_joint:
        case Step::Kind::spin_by_driver: inputs.spins.insert(step.other); return;
        case Step::Kind::slide_by_driver:
        case Step::Kind::roll: inputs.tips.insert(step.base); return;
        case Step::Kind::image:
            inputs.tips.insert(step.base);
            inputs.spins.insert(step.body);
            return;
        case Step::Kind::meet:
            add_inputs(step.first, inputs);
            add_inputs(step.second, inputs);
            return;
        case Step::Kind::spin_from_pair: inputs.tips.insert({step.base, step.node}); return;
        case Step::Kind::auxiliary:
        case Step::Kind::spin_from_parallels:
            add_inputs(step.first, inputs);
            add_inputs(step.second, inputs);
            return;
        case Step::Kind::assume:
            if (step.node != none) add_inputs(step.first, inputs);
            for (const Step& inner : step.trial) add_inputs(inner, inputs);
            add_inputs(step.closing, inputs);
            return;
    }
}

bool gives_spin(const Step& step) {
    return step.kind == Step::Kind::spin_by_joint || step.kind == Step::Kind::spin_by_driver ||
           step.kind == Step::Kind::spin_from_pair || step.kind == Step::Kind::spin_from_parallels ||
           (step.kind == Step::Kind::assume && step.node == none);
}

bool gives_any(const Step& step, const Quantities& wanted) {
    return gives_spin(step) ? wanted.spins.contains(step.body) : wanted.tips.contains(step.node);
}

}  // namespace

void add_inputs(const Closing& closing, Quantities& inputs) {
    if (closing.locus) {
        inputs.tips.insert(closing.locus->node);
        add_inputs(*closing.locus, inputs);
    } else {
        inputs.spins.insert({closing.body, closing.other});
    }
}

std::vector<Step> leading_to(Quantities wanted, const std::vector<Step>& steps, std::size_t first) {
    std::vector<Step> kept;
    for (std::size_t i = steps.size(); i-- > first;) {
        if (!gives_any(steps[i], wanted)) continue;
        add_inputs(steps[i], wanted);
        kept.push_back(steps[i]);
    }
    std::reverse(kept.begin(), kept.end());
    return kept;
}

}  // namespace kinegraph::planning
