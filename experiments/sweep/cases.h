#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "experiments/sweep/sweep.h"

namespace trocar {

/// Everything that decides a case's results. Two cases of equal inputs have the same id.
struct CaseInputs {
    std::string case_id;  ///< 128-bit hash of everything below but the label
    StrategyChoice strategy;
    OrganChoice organ;
    ToolChoice tool;
    std::string scene;
    double speed;  ///< mm/s
    std::uint64_t seed;
    CycleSettings cycle;
    SpringSettings springs;
};

/// Every case of the sweep, in the order of its lists: the seed changes fastest, then speed, scene, tool,
/// organ, strategy.
std::vector<CaseInputs> list_cases(const Sweep& sweep);

/// The hash of the case's inputs, written as JSON with sorted keys. The label, and where a mesh file lies,
/// are not among them.
std::string case_id_of(const CaseInputs& inputs);

/// Resolved options as one line of JSON, keys sorted.
std::string options_json(const Options& options);

/// Keeps the cases that match `key=value` filters: filters of one key are alternatives, different keys must
/// all match. Keys: strategy (name or label), organ, tool, scene, speed, seed. Throws InputError for a filter
/// that is no key=value, for an unknown key, and for a value that no case has, naming the nearest one.
std::vector<CaseInputs> only(std::vector<CaseInputs> cases, std::span<const std::string> filters);

/// The word of a sweep file: "contact" or "step".
std::string release_name(Release release);

}  // namespace trocar
