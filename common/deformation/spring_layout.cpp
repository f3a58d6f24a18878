#include "common/deformation/spring_layout.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace trocar {
namespace {

void number_slots(const SpringNetwork& network, SpringLayout& layout) {
    constexpr auto none = static_cast<std::uint32_t>(-1);
    layout.slot_of.assign(network.rest.size(), none);
    const auto add = [&](Index vertex) {
        std::uint32_t& slot = layout.slot_of.at(vertex);
        if (slot != none) throw std::invalid_argument("a vertex is in two patches");
        slot = static_cast<std::uint32_t>(layout.vertex_of.size());
        layout.vertex_of.push_back(vertex);
        layout.patch_of.push_back(static_cast<std::uint32_t>(layout.patch_begins.size() - 1));
    };
    layout.patch_begins = {0};
    const auto end_patch = [&] {
        layout.patch_begins.push_back(static_cast<std::uint32_t>(layout.vertex_of.size()));
    };
    for (const std::vector<Index>& patch : network.patches) {
        for (const Index vertex : patch) add(vertex);
        end_patch();
    }
    for (std::size_t vertex = 0; vertex < network.rest.size(); ++vertex) {
        if (layout.slot_of[vertex] == none) add(static_cast<Index>(vertex));
    }
    if (layout.vertex_of.size() > layout.patch_begins.back()) end_patch();
}

/// The springs in the network's order.
std::vector<SpringLayout::Spring> springs_with_levels(const SpringNetwork& network,
                                                      const SpringLayout& layout, double h) {
    std::vector<std::uint32_t> highest(network.rest.size(), 0);
    std::vector<SpringLayout::Spring> springs;
    springs.reserve(network.springs.size());
    for (const auto& [a, b, rest_length, stiffness] : network.springs) {
        const std::uint32_t level = 1 + std::max(highest[a], highest[b]);
        highest[a] = highest[b] = level;
        springs.push_back(
            {layout.slot_of[a], layout.slot_of[b], level, rest_length, 1 / (stiffness * h * h)});
    }
    return springs;
}

void sort_out_doubles(std::vector<std::uint32_t>& numbers) {
    std::ranges::sort(numbers);
    const auto repeated = std::ranges::unique(numbers);
    numbers.erase(repeated.begin(), repeated.end());
}

/// What each patch has to know of the springs at its vertices.
void list_by_patch(SpringLayout& layout) {
    std::vector<std::vector<std::uint32_t>> springs_at(layout.patches());
    for (std::size_t k = 0; k < layout.springs.size(); ++k) {
        const auto& spring = layout.springs[k];
        const std::uint32_t at_a = layout.patch_of[spring.a], at_b = layout.patch_of[spring.b];
        springs_at[at_a].push_back(static_cast<std::uint32_t>(k));
        if (at_b != at_a) springs_at[at_b].push_back(static_cast<std::uint32_t>(k));
    }
    for (std::size_t patch = 0; patch < layout.patches(); ++patch) {
        std::vector<std::uint32_t> outer, neighbours;
        for (const std::uint32_t k : springs_at[patch]) {
            for (const std::uint32_t slot : {layout.springs[k].a, layout.springs[k].b}) {
                if (layout.patch_of[slot] != patch) outer.push_back(slot);
            }
        }
        sort_out_doubles(outer);
        for (const std::uint32_t slot : outer) neighbours.push_back(layout.patch_of[slot]);
        sort_out_doubles(neighbours);
        layout.springs_at.add(springs_at[patch]);
        layout.outer.add(outer);
        layout.neighbours.add(neighbours);
    }
}

}  // namespace

SpringLayout lay_out(const SpringNetwork& network, double substep) {
    SpringLayout layout;
    number_slots(network, layout);
    layout.springs = springs_with_levels(network, layout, substep);
    std::ranges::sort(layout.springs, {}, [&](const SpringLayout::Spring& spring) {
        return std::tuple(layout.patch_of[spring.a], spring.level, spring.a);
    });
    list_by_patch(layout);
    return layout;
}

}  // namespace trocar
