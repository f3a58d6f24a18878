#pragma once

#include <optional>
#include <span>
#include <string>

#include "strategies/fuzzy/rule_base.h"
#include "strategies/fuzzy/vertex_inference.h"

namespace trocar {

/// What the strategy fuzzy-per-vertex makes of one vertex, step by step.
struct VertexStory {
    Vec3 motion;                            ///< v_m
    std::vector<fuzzy::FacetShare> shares;  ///< facet by facet, in the order of the inference
    Vec3 vector;                            ///< d_i
    std::optional<Vec3> direction;          ///< d_i / |d_i|
};

/// Infers it with the strategy's own code.
VertexStory story_of(const fuzzy::RuleBase& rules, const fuzzy::VertexReading& reading, const Vec3& motion,
                     std::span<const fuzzy::FacetNormal> facets);

/// The story for people: facet by facet I_C, its memberships, the rules that fired and how strongly, I, the
/// vector added; then the direction.
std::string told(const VertexStory& story, const fuzzy::RuleBase& rules, const fuzzy::VertexReading& reading);

/// "(x, y, z)", six decimals.
std::string vector_text(const Vec3& vector);

}  // namespace trocar
