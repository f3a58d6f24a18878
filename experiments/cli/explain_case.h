#pragma once

#include <optional>
#include <string>
#include <vector>

namespace trocar {

/// Which vertex of which case to explain.
struct ExplainCase {
    std::string sweep_file;
    std::string case_id;               ///< or its beginning
    std::vector<std::string> filters;  ///< as of `trocar run --only`
    std::optional<long> step;          ///< from 0, as in a replay
    std::optional<long> vertex;
};

/// Runs the case anew up to the step and tells what fuzzy-per-vertex makes of the vertex there, with its
/// displacement. Throws InputError where the sweep has no such case, step or collided vertex, and says which
/// there are.
std::string explain_case(const ExplainCase& asked);

}  // namespace trocar
