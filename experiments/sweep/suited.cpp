#include <map>
#include <tuple>

#include <fmt/format.h>

#include "experiments/scenes/placement.h"
#include "experiments/sweep/cases.h"

namespace trocar {
namespace {

/// What decides whether a scene has a place.
using Combination = std::tuple<const Organ*, const Tool*, std::string>;

std::string unsuited_case(const CaseInputs& inputs) {
    return unsuited(*inputs.scene.entry, {.organ = *inputs.organ.organ,
                                          .organ_queries = *inputs.organ.queries,
                                          .tool = *inputs.tool.tool,
                                          .speed = inputs.speed,
                                          .dt = inputs.cycle.dt(),
                                          .seed = inputs.seed,
                                          .recording = inputs.scene.recording.get()});
}

}  // namespace

SuitedCases suited(std::vector<CaseInputs> cases) {
    struct Answer {
        std::string reason;  // empty: suited
        std::string what;
        std::size_t cases = 0;
    };
    std::map<Combination, Answer> answers;
    std::vector<Combination> order;
    SuitedCases result;
    for (CaseInputs& inputs : cases) {
        const Combination combination{inputs.organ.organ.get(), inputs.tool.tool.get(),
                                      inputs.scene.identity};
        const auto [entry, fresh] = answers.try_emplace(combination);
        Answer& answer = entry->second;
        if (fresh) {
            order.push_back(combination);
            answer.reason = unsuited_case(inputs);
            answer.what = fmt::format("{} on {} with {}", inputs.scene.name, inputs.organ.organ->name,
                                      inputs.tool.tool->name);
        }
        ++answer.cases;
        if (answer.reason.empty()) result.cases.push_back(std::move(inputs));
    }
    for (const Combination& combination : order) {
        const Answer& answer = answers.at(combination);
        if (answer.reason.empty()) continue;
        result.left_out.push_back(
            fmt::format("not run: {} ({} cases): {}", answer.what, answer.cases, answer.reason));
    }
    return result;
}

}  // namespace trocar
