#pragma once

#include <functional>
#include <string>

#include "common/cycle/contact.h"

namespace trocar::contract {

/// How a scene was changed, and so how the answer to it should change.
struct Change {
    std::function<Index(Index)> number = [](Index vertex) { return vertex; };  ///< of a vertex, old to new
    Pose moved{};
    double scaled = 1;  ///< after moving
};

/// The answer that the changed scene should have. Forces stay as long as they are.
Response changed(const Response& original, const Change& change);

/// What is different about two answers, in whatever order they name vertices; empty when nothing is. Lengths
/// may differ by `allowed` (mm), normals by 1e-7, forces by 1e-7 of the largest.
std::string difference(Response expected, Response found, double allowed);

/// Equal to the last bit and in the same order.
bool same_bits(const Response& a, const Response& b);

}  // namespace trocar::contract
