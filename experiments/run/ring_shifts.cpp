#include "experiments/run/ring_shifts.h"

#include <algorithm>
#include <new>
#include <utility>

#include "common/cycle/check_response.h"

namespace trocar {
namespace {

/// What the strategy makes of the contact with another organ; nothing where it gives no answer that is one.
std::optional<Response> answer_with(const Organ& organ, const Contact& contact, Strategy& strategy) {
    Response response;
    try {
        strategy.handle({.organ = organ,
                         .positions = contact.positions,
                         .velocities = contact.velocities,
                         .tool = contact.tool,
                         .motion = contact.motion,
                         .collided = contact.collided,
                         .crossed = contact.crossed,
                         .near_vertices = contact.near_vertices,
                         .near_facets = contact.near_facets,
                         .clearance = contact.clearance,
                         .dt = contact.dt},
                        response);
        ResponseCheck(contact.positions.size()).check(response);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (...) {
        return std::nullopt;
    }
    return response;
}

std::size_t longest_ring(const Adjacency& around, std::span<const Index> vertices) {
    std::size_t longest = 0;
    for (const Index vertex : vertices) longest = std::max(longest, around.ring(vertex).size());
    return longest;
}

/// Has the rings of the vertices begin so many facets after where they do in `original`.
void shift_rings(const Adjacency& original, std::span<const Index> vertices, std::size_t shift,
                 Adjacency& shifted) {
    for (const Index vertex : vertices) {
        const auto ring = original.ring(vertex);
        if (!ring.empty()) shifted.begin_ring_at(vertex, ring[shift % ring.size()]);
    }
}

}  // namespace

ShiftedAnswers RingShifts::ask(Strategy& strategy, const Description& description, const Contact& contact) {
    if (description.keeps_state) return {.displacements = {}, .missing = Missing::keeps_state};
    ShiftedAnswers answers{.displacements = {}, .missing = Missing::nothing};
    if (contact.collided.empty()) return answers;
    Organ& shifted = shifted_ ? *shifted_ : shifted_.emplace(organ_);
    const auto shift_to = [&](std::size_t shift) {
        shift_rings(organ_.adjacency, contact.collided, shift, shifted.adjacency);
    };
    const std::size_t shifts = longest_ring(organ_.adjacency, contact.collided);
    for (std::size_t shift = 0; shift < shifts; ++shift) {
        shift_to(shift);
        std::optional<Response> response = answer_with(shifted, contact, strategy);
        if (!response) {
            answers = {.displacements = {}, .missing = Missing::no_answer};
            break;
        }
        answers.displacements.push_back(std::move(response->displacements));
    }
    shift_to(0);
    return answers;
}

}  // namespace trocar
