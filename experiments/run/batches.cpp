#include "experiments/run/batches.h"

#include <algorithm>
#include <map>

#include <sched.h>

#include "experiments/sweep/hash.h"

namespace trocar {

std::vector<CaseInputs> by_scene(std::vector<CaseInputs> cases) {
    std::map<std::string, std::size_t> rank;
    for (const CaseInputs& inputs : cases) rank.try_emplace(inputs.scene_id, rank.size());
    std::ranges::stable_sort(cases, {}, [&](const CaseInputs& inputs) { return rank.at(inputs.scene_id); });
    return cases;
}

std::vector<CaseInputs> spread_out(std::vector<CaseInputs> cases, const std::string& seed) {
    std::map<std::string, std::string> place;
    for (const CaseInputs& inputs : cases) {
        place[inputs.case_id] = hash_of(seed + inputs.scene_id) + hash_of(seed + inputs.case_id);
    }
    std::ranges::stable_sort(cases, {}, [&](const CaseInputs& inputs) { return place.at(inputs.case_id); });
    return cases;
}

std::deque<Batch> batches_of(std::span<const CaseInputs> cases, unsigned workers) {
    // Four batches for each worker keep all of them busy until near the end.
    const std::size_t longest =
        std::max<std::size_t>(1, cases.size() / (std::size_t{4} * std::max(workers, 1U)));
    std::deque<Batch> batches;
    for (std::size_t begin = 0; begin < cases.size();) {
        std::size_t end = begin + 1;
        while (end < cases.size() && end - begin < longest && cases[end].scene_id == cases[begin].scene_id) {
            ++end;
        }
        batches.push_back({.begin = begin, .end = end});
        begin = end;
    }
    return batches;
}

void stay_on_one_core() {
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    if (sched_getaffinity(0, sizeof(allowed), &allowed) != 0) return;
    for (int core = CPU_SETSIZE - 1; core >= 0; --core) {
        if (!CPU_ISSET(core, &allowed)) continue;
        CPU_ZERO(&allowed);
        CPU_SET(core, &allowed);
        sched_setaffinity(0, sizeof(allowed), &allowed);
        return;
    }
}

}  // namespace trocar
