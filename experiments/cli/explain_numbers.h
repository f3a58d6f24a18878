#pragma once

#include <string>
#include <vector>

namespace trocar {

/// A vertex as it is typed in.
struct ExplainNumbers {
    std::string motion;                ///< v_m: "x,y,z", of any length
    std::vector<std::string> normals;  ///< of its facets, in the order of the inference; likewise
    std::vector<std::string> options;  ///< of fuzzy-per-vertex: "key=value"; `rules` may name a file
};

/// Tells what fuzzy-per-vertex makes of it. Throws InputError for what is no vector or no option.
std::string explain_numbers(const ExplainNumbers& asked);

}  // namespace trocar
