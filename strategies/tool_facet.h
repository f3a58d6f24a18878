#pragma once

#include "strategies/registry.h"

namespace trocar {

/// The strategy `tool-facet`: [15] of the paper, its authors' previous method (Fig. 6a).
StrategyEntry tool_facet_entry();

}  // namespace trocar
