#pragma once

#include <memory>
#include <optional>

#include "experiments/run/run_case.h"
#include "experiments/run/shared_scenes.h"
#include "strategies/registry.h"

namespace trocar {

/// Runs one case with the given strategy and a scene of its own.
inline std::optional<CaseRecord> run_alone(const CaseInputs& inputs, Strategy& strategy,
                                           const CaseOptions& options, const std::stop_token& stop = {}) {
    const SceneSource scene_of = [](const CaseInputs& of) {
        return std::make_shared<const PreparedScene>(prepare_scene_of(of));
    };
    return run_case(inputs, scene_of, strategy, options, stop);
}

inline std::optional<CaseRecord> run_alone(const CaseInputs& inputs, Strategy& strategy, bool with_replay,
                                           const std::stop_token& stop = {}) {
    CaseOptions options;
    options.replay = with_replay;
    return run_alone(inputs, strategy, options, stop);
}

/// The same with the strategy that the inputs name.
inline CaseRecord run_alone(const CaseInputs& inputs, bool with_replay) {
    const auto strategy = make_strategy(inputs.strategy.name, inputs.strategy.options);
    return run_alone(inputs, *strategy, with_replay).value();
}

}  // namespace trocar
