#pragma once

#include <functional>
#include <vector>

#include "common/cycle/contact.h"
#include "experiments/metrics/missing.h"

namespace trocar {

/// What a strategy answers to the same step when the rings N(i) of the collided vertices (Adjacency::ring)
/// begin elsewhere.
struct ShiftedAnswers {
    /// The k-th, from 0: where each of these rings begins k facets after its first one, counted cyclically.
    /// As many as the longest of them has facets.
    std::vector<std::vector<VertexDisplacement>> displacements;
    Missing missing = Missing::no_answer;  ///< why there are none
};

/// Has a strategy asked for them.
using AskShifted = std::function<ShiftedAnswers()>;

}  // namespace trocar
