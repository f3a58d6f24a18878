#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

/// A scene on an organ that has no place for it, with some tools or with all.
struct LeftOut {
    std::string what;
    std::vector<std::string> tools;
    std::size_t cases;
    std::string reason;  // with the first of the tools
};

void add(std::vector<LeftOut>& all, const CaseInputs& inputs, const std::string& reason) {
    const std::string what = fmt::format("{} on {}", inputs.scene.name, inputs.organ.organ->name);
    auto found = std::ranges::find(all, what, &LeftOut::what);
    if (found == all.end()) {
        found = all.insert(all.end(), {.what = what, .tools = {}, .cases = 0, .reason = reason});
    }
    const std::string& tool = inputs.tool.tool->name;
    if (std::ranges::find(found->tools, tool) == found->tools.end()) found->tools.push_back(tool);
    ++found->cases;
}

}  // namespace

SuitedCases suited(std::vector<CaseInputs> cases) {
    std::map<Combination, std::string> reasons;  // empty: suited
    std::vector<LeftOut> left_out;
    SuitedCases result;
    for (CaseInputs& inputs : cases) {
        const Combination combination{inputs.organ.organ.get(), inputs.tool.tool.get(),
                                      inputs.scene.identity};
        const auto [entry, fresh] = reasons.try_emplace(combination);
        if (fresh) entry->second = unsuited_case(inputs);
        if (entry->second.empty()) {
            result.cases.push_back(std::move(inputs));
        } else {
            add(left_out, inputs, entry->second);
        }
    }
    for (const LeftOut& one : left_out) {
        result.left_out.push_back(fmt::format("not run: {} with {} ({} cases): {}", one.what,
                                              fmt::join(one.tools, ", "), one.cases, one.reason));
    }
    return result;
}

}  // namespace trocar
