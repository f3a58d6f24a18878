#pragma once

#include <functional>
#include <memory>
#include <string>

#include "strategies/strategy.h"
#include "tests/strategies/contract_scene.h"

/// What every strategy has to keep, one function a clause. Each answers an empty text when the clause is
/// kept, else what broke it; so the tests can also show that a bad strategy is found out.
namespace trocar::contract {

/// Makes a fresh instance of the strategy under test.
using Maker = std::function<std::unique_ptr<Strategy>()>;

/// Its answer is finite, and names only vertices that exist, each at most once.
std::string violation_of_well_formed(const Maker& make, const Scene& scene);

/// It moves nothing when nothing collided.
std::string violation_of_quiet_without_contact(const Maker& make);

/// What it promises: collided vertices leave the tool by at least g/2; others stay where they are.
std::string violation_of_promises(const Maker& make, const Scene& scene);

/// The same scene moved or scaled gives the same answer moved or scaled.
std::string violation_of_rigid_equivariance(const Maker& make, const Scene& scene, const Pose& by);
std::string violation_of_scale_equivariance(const Maker& make, const Scene& scene, double factor);

/// Numbering vertices anew (and facets, where promised) changes nothing but the numbers.
std::string violation_of_vertex_numbering(const Maker& make, const Scene& scene, std::uint64_t seed);
std::string violation_of_facet_numbering(const Maker& make, const Scene& scene, std::uint64_t seed);

/// The same bits from the same instance again after another scene, from a fresh one, and on eight threads at
/// once.
std::string violation_of_repeatability(const Maker& make, const Scene& scene, const Scene& another);

}  // namespace trocar::contract
