#include "render/problems/contact_pages.hpp"

#include <algorithm>
#include <deque>
#include <iterator>
#include <utility>

#include "engine/solution/problem_solution.hpp"
#include "lang/keys/common.hpp"
#include "lang/keys/contacts.hpp"
#include "render/problems/problem_sheet.hpp"

namespace kinegraph::render {
namespace {

/// A contact as a problem of its own: the same bodies, named by what they are.
Solution alone(const Solution& solution, const SolvedContact& contact) {
    Solution result;
    result.mechanism = solution.mechanism;
    result.mechanism.problem = contact.stated;
    for (const BodyIndex body : indices_of(result.mechanism.bodies)) {
        Words& label = result.mechanism.bodies[at_index(body)].label;
        if (!label.empty()) continue;
        label = body == frame ? Words(lang::common::frame)
                              : Words(lang::contacts::body, solution.mechanism.body(body).name);
    }
    ProblemSolution found = *contact.found;
    found.subject = Words(lang::common::contact_at, solution.mechanism.joint(contact.joint).name);
    result.problem = std::make_shared<const ProblemSolution>(std::move(found));
    return result;
}
/// The contacts by their joint, in the order of the file. A deque, because figures refer to its elements.
std::deque<std::pair<JointIndex, Solution>> contacts_of(const Solution& solution) {
    std::deque<std::pair<JointIndex, Solution>> all;
    if (!solution.contacts) return all;
    for (const SolvedContact& contact : solution.contacts->at_joints)
        all.emplace_back(contact.joint, alone(solution, contact));
    return all;
}

}  // namespace

std::vector<Page> with_contacts(const Solution& solution, const SheetOptions& options, const Fonts& fonts,
                                LayOutProblem contact,
                                const std::function<BoundPages(const SheetOptions&)>& mechanism) {
    const auto contacts = contacts_of(solution);
    SheetOptions numbered = options;
    numbered.pages_before = 1;  // only the first page has the title block
    std::vector<std::size_t> counts;
    for (const auto& [joint, each] : contacts) {
        counts.push_back(contact(each, numbered, fonts).size());
        numbered.pages_after += counts.back();
    }
    numbered.pages_before = 0;
    BoundPages bound = mechanism(numbered);
    std::vector<Page> pages = std::move(bound.pages);
    numbered.figures_before = bound.figures;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        numbered.pages_before = static_cast<std::size_t>(std::count_if(
            pages.begin(), pages.end(), [](const Page& page) { return !page.step || !page.step->grows; }));
        numbered.pages_after -= counts[i];
        std::vector<Page> more = contact(contacts[i].second, numbered, fonts);
        const DrawingContext context{contacts[i].second, options.theme, fonts, options.language, options.dimensions};
        numbered.figures_before += static_cast<int>(problem_figure_names(context).size());
        std::move(more.begin(), more.end(), std::back_inserter(pages));
    }
    return pages;
}

std::vector<ContactFigure> contact_figures(const Solution& solution, const SheetOptions& options, const Fonts& fonts) {
    std::vector<ContactFigure> all;
    for (const auto& [joint, each] : contacts_of(solution))
        for (const std::string& figure :
             problem_figure_names({each, options.theme, fonts, options.language, options.dimensions}))
            all.push_back({figure + "-" + solution.mechanism.joint(joint).name, joint});
    return all;
}
std::optional<Figure> contact_figure(const Solution& solution, const SheetOptions& options, const Fonts& fonts,
                                     const std::string& name, Spot room) {
    for (const auto& [joint, each] : contacts_of(solution)) {
        const DrawingContext context{each, options.theme, fonts, options.language, options.dimensions};
        for (const std::string& figure : problem_figure_names(context))
            if (figure + "-" + solution.mechanism.joint(joint).name == name)
                return problem_figure(context, figure, room.x, room.y);
    }
    return std::nullopt;
}

std::string contact_tables(const Solution& solution, Language language) {
    std::string text;
    auto contacts = contacts_of(solution);
    for (auto& [joint, each] : contacts) {
        each.mechanism.title = {};
        text += "\n" + problem_table(each, language);
    }
    return text;
}

}  // namespace kinegraph::render
