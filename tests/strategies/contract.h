#pragma once

#include <functional>
#include <memory>
#include <string>

#include "strategies/strategy.h"
#include "tests/strategies/contract_scene.h"

/// What every strategy has to keep, one function a clause. Each answers an empty text when the clause is
/// kept, else what broke it; so the tests can also show that a bad strategy is found out.
namespace trocar::contract {

/// The strategy under test.
struct Subject {
    Description description;
    std::function<std::unique_ptr<Strategy>()> make;  ///< a fresh instance
};

/// Its answer is finite, and names only vertices that exist, each at most once.
std::string violation_of_well_formed(const Subject& subject, const Scene& scene);

/// It does nothing when nothing collided. One that declares swept contact: when nothing is near the sweep.
std::string violation_of_quiet_without_contact(const Subject& subject, const Scene& scene);

/// Where it promises so, every collided vertex leaves the tool, by at least g/2.
std::string violation_of_clearing(const Subject& subject, const Scene& scene);

/// Where it promises so, its answer names no vertex that is not collided.
std::string violation_of_leaving_others(const Subject& subject, const Scene& scene);

/// The same scene moved or scaled gives the same answer moved or scaled. Forces are not compared when the
/// scene is scaled: how they scale is the material's affair.
std::string violation_of_rigid_equivariance(const Subject& subject, const Scene& scene, const Pose& by);
std::string violation_of_scale_equivariance(const Subject& subject, const Scene& scene, double factor);

/// Numbering vertices anew (and facets, where promised) changes nothing but the numbers.
std::string violation_of_vertex_numbering(const Subject& subject, const Scene& scene, std::uint64_t seed);
std::string violation_of_facet_numbering(const Subject& subject, const Scene& scene, std::uint64_t seed);

/// The same bits from the same instance again after another scene (unless it declares to keep state), from a
/// fresh one, and on eight threads at once.
std::string violation_of_repeatability(const Subject& subject, const Scene& scene, const Scene& another);

}  // namespace trocar::contract
