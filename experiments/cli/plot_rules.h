#pragma once

#include <string>

namespace trocar {

/// Has the analysis draw a rule base into memberships.svg, memberships.png, response.svg and response.png of
/// a folder, which is made: its terms (the paper's Fig. 2), and the weights over I_C at the first facet and
/// after feedback. Throws InputError for a rule base that cannot be read.
/// @returns the exit code of the analysis
int plot_rules(const std::string& rules, const std::string& folder);

}  // namespace trocar
