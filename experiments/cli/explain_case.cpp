#include "experiments/cli/explain_case.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiments/cli/vertex_story.h"
#include "experiments/input_error.h"
#include "experiments/run/shared_scenes.h"
#include "experiments/sweep/cases.h"
#include "strategies/fuzzy/rules_option.h"
#include "strategies/leave_tool.h"
#include "strategies/motion_vector.h"
#include "strategies/registry.h"

namespace trocar {
namespace {

constexpr const char* explained = "fuzzy-per-vertex";
constexpr std::size_t most_listed = 10;

std::string described(const CaseInputs& inputs) {
    return fmt::format("{}, {}, {}, {}, {} mm/s, seed {}, release {}", inputs.strategy.label,
                       inputs.organ.organ->name, inputs.tool.tool->name, inputs.scene.name, inputs.speed,
                       inputs.seed, release_name(inputs.cycle.release));
}

/// The beginning of a list that may be long.
template <typename T>
std::string listed(const std::vector<T>& all, const char* separator) {
    const auto shown = std::span(all).first(std::min(all.size(), most_listed));
    return fmt::format(
        "{}{}", fmt::join(shown, separator),
        shown.size() < all.size() ? fmt::format("{}… ({} in all)", separator, all.size()) : "");
}

CaseInputs chosen_case(const ExplainCase& asked) {
    std::vector<CaseInputs> cases =
        suited(only(list_cases(read_sweep(asked.sweep_file)), asked.filters)).cases;
    std::erase_if(cases, [&](const CaseInputs& one) { return one.strategy.name != explained; });
    if (cases.empty()) {
        throw InputError(fmt::format("no case of {} is left; explain knows this strategy only", explained));
    }
    std::erase_if(cases, [&](const CaseInputs& one) { return !one.case_id.starts_with(asked.case_id); });
    if (cases.empty()) {
        throw InputError(
            fmt::format("no case of {} has an id that begins with {}", explained, asked.case_id));
    }
    if (cases.size() == 1) return std::move(cases.front());
    std::vector<std::string> lines;
    for (const CaseInputs& one : cases) lines.push_back(fmt::format("{}  {}", one.case_id, described(one)));
    throw InputError(
        fmt::format("explain takes one case; choose by --case or --only among\n  {}", listed(lines, "\n  ")));
}

std::string listed_collided(const Contact& contact) {
    if (contact.collided.empty()) return "no vertex collided in this step";
    return fmt::format("collided vertices: {}",
                       listed(std::vector<Index>(contact.collided.begin(), contact.collided.end()), ", "));
}

double depth_of(const Contact& contact, Index vertex) {
    const Vec3& position = contact.positions[vertex];
    return (contact.tool.closest(position).position - position).norm();
}

/// The vertex asked for, or the deepest.
Index chosen_vertex(const Contact& contact, const ExplainCase& asked) {
    if (!asked.vertex) {
        if (contact.collided.empty()) throw InputError(listed_collided(contact) + "; choose another --step");
        return *std::ranges::max_element(contact.collided, {},
                                         [&](Index one) { return depth_of(contact, one); });
    }
    const auto found = std::ranges::find(contact.collided, *asked.vertex);
    if (found == contact.collided.end()) {
        throw InputError(
            fmt::format("vertex {} did not collide; {}", *asked.vertex, listed_collided(contact)));
    }
    return *found;
}

/// What the strategy itself answers.
std::string told_displacement(const Contact& contact, const CaseInputs& inputs, Index vertex) {
    Response response;
    make_strategy(inputs.strategy.name, inputs.strategy.options)->handle(contact, response);
    const auto answer = std::ranges::find(response.displacements, vertex, &VertexDisplacement::vertex);
    if (answer == response.displacements.end()) return "the vertex stays where it is\n";
    const Vec3& way = answer->displacement;
    return fmt::format("displacement = ({:.9f}, {:.9f}, {:.9f}) mm\n", way.x(), way.y(), way.z());
}

std::string told_vertex(const Contact& contact, const CaseInputs& inputs, const ExplainCase& asked) {
    const Index vertex = chosen_vertex(contact, asked);
    const Vec3& position = contact.positions[vertex];
    std::string text =
        fmt::format("vertex {} of {} that collided, at {} mm, {:.6f} mm inside the tool\n", vertex,
                    contact.collided.size(), vector_text(position), depth_of(contact, vertex));
    const fuzzy::RuleBase rules = fuzzy::rules_of(inputs.strategy.options);
    const fuzzy::VertexReading reading = fuzzy::vertex_reading_of(inputs.strategy.options);
    const auto motion = motion_vector(contact, position);
    std::optional<Vec3> direction;
    if (motion) {
        std::vector<fuzzy::FacetNormal> facets;
        fuzzy::gather_facets(contact, vertex, *motion, reading, facets);
        const VertexStory story = story_of(rules, reading, *motion, facets);
        direction = story.direction;
        text += told(story, rules, reading);
    } else {
        text += "the tool did not move here: there is no v_m\n";
    }
    if (direction) {
        text += fmt::format("exit distance = {:.6f} mm, to {} mm outside the tool\n",
                            contact.tool.exit_distance(position, *direction, contact.clearance),
                            contact.clearance);
    } else {
        text += fmt::format("without a direction: fallback = \"{}\"\n",
                            word(inputs.strategy.options, "fallback"));
    }
    return text + told_displacement(contact, inputs, vertex);
}

}  // namespace

std::string explain_case(const ExplainCase& asked) {
    const CaseInputs inputs = chosen_case(asked);
    const PreparedScene scene = prepare_scene_of(inputs);
    const auto steps = static_cast<long>(scene.poses.size());
    if (!asked.step || *asked.step < 0 || *asked.step >= steps) {
        throw InputError(fmt::format("--step must be from 0 to {} in this case", steps - 1));
    }
    Cycle cycle(*inputs.organ.organ, *inputs.tool.tool, scene.start, inputs.cycle, inputs.springs);
    const auto strategy = make_strategy(inputs.strategy.name, inputs.strategy.options);
    std::string text = fmt::format("case {}\n{}\nstep {}, ", inputs.case_id, described(inputs), *asked.step);
    for (long step = 0; step <= *asked.step; ++step) {
        cycle.move(scene.poses[static_cast<std::size_t>(step)]);
        cycle.detect();
        cycle.handle([&](const Contact& contact, Response& response) {
            if (step == *asked.step) text += told_vertex(contact, inputs, asked);
            strategy->handle(contact, response);
        });
        cycle.deform();
    }
    return text;
}

}  // namespace trocar
