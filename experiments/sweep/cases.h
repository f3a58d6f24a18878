#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "experiments/sweep/sweep.h"

namespace trocar {

/// Everything that decides a case's results. Two cases of equal inputs have the same id.
struct CaseInputs {
    std::string case_id;   ///< 128-bit hash of everything below but the label
    std::string scene_id;  ///< the same without strategy and release: cases that start from the same state
    StrategyChoice strategy;
    OrganChoice organ;
    ToolChoice tool;
    SceneChoice scene;
    double speed;  ///< mm/s; of a recording its root mean square
    std::uint64_t seed;
    CycleSettings cycle;
    SpringSettings springs;
    std::int64_t sweep_number;  ///< place in list_cases, from 1; no part of what the case does
};

/// Every case of the sweep, in the order of its lists: the seed changes fastest, then speed, scene, tool,
/// organ, stiffness, rate, release, strategy.
std::vector<CaseInputs> list_cases(const Sweep& sweep);

/// The hash of the case's inputs, written as JSON with sorted keys. The label, and where a file lies, are not
/// among them.
std::string case_id_of(const CaseInputs& inputs);

/// Cases whose scene has a place on their organ, such as `cutting` on a cleft only.
struct SuitedCases {
    std::vector<CaseInputs> cases;
    std::vector<std::string>
        left_out;  ///< one line for each scene on an organ that has no place for it, with why
};

/// Keeps the cases whose scene has a place on their organ.
SuitedCases suited(std::vector<CaseInputs> cases);

/// Resolved options as one line of JSON, keys sorted.
std::string options_json(const Options& options);

/// A value of an option as a short text, such as "sum", "true" or "0.5"; of a file's contents the first line
/// that is no comment.
std::string option_text(const OptionValue& value);

/// Keeps the cases that match `key=value` filters: filters of one key are alternatives, different keys must
/// all match. Keys: strategy (name or label), organ, tool, scene, speed, seed, rate, release, edge_stiffness,
/// rest_stiffness, and every option of the cases' strategies; a case whose strategy does not have the option
/// does not match. Throws InputError for a filter that is no key=value, for an unknown key, and for a value
/// that no case has, naming the nearest one.
std::vector<CaseInputs> only(std::vector<CaseInputs> cases, std::span<const std::string> filters);

/// The word of a sweep file: "contact" or "step".
std::string release_name(Release release);

}  // namespace trocar
