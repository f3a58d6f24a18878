#include "experiments/claims/claims_plan.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/nearest_name.h"
#include "experiments/input_error.h"
#include "experiments/sweep/config.h"
#include "experiments/sweep/entries.h"
#include "experiments/sweep/hash.h"

namespace trocar {
namespace {

namespace fs = std::filesystem;

/// What this side needs to know of a claim.
struct Claim {
    std::string id;
    std::vector<std::string> sweeps;
    bool of_turns = false;
};

struct Confirmation {
    std::vector<std::string> sweeps;
    std::vector<OrganChoice> organs;
};

const ConfigValue& needed(const ConfigTable& table, std::string_view key, Place place) {
    const ConfigValue* value = find(table, key);
    if (value == nullptr) throw PlacedError(place, fmt::format("the key {} is missing", key));
    return *value;
}

std::vector<std::string> texts_of(const ConfigValue& value, std::string_view what) {
    std::vector<std::string> texts;
    for (const ConfigValue& entry : as_list(value, what)) texts.push_back(as_text(entry, what));
    return texts;
}

Claim read_claim(const ConfigValue& value) {
    const ConfigTable& table = as_table(value, "a claim");
    Claim claim{.id = as_text(needed(table, "id", value.place), "id"), .sweeps = {}};
    if (const ConfigValue* sweeps = find(table, "sweeps")) claim.sweeps = texts_of(*sweeps, "sweeps");
    if (const ConfigValue* data = find(table, "data")) claim.of_turns = as_text(*data, "data") == "turns";
    return claim;
}

std::vector<Claim> read_claims(const ConfigTable& table) {
    std::vector<Claim> claims;
    for (const ConfigValue& entry : as_list(needed(table, "claim", {}), "claim")) {
        claims.push_back(read_claim(entry));
    }
    return claims;
}

Confirmation read_confirmation(const ConfigTable& table, const fs::path& meshes) {
    const ConfigValue& value = needed(table, "confirmation", {});
    const ConfigTable& entries = as_table(value, "confirmation");
    Confirmation confirmation{.sweeps = texts_of(needed(entries, "sweeps", value.place), "sweeps"),
                              .organs = {}};
    for (const ConfigValue& organ : as_list(needed(entries, "organs", value.place), "organs")) {
        const std::string& name = as_text(needed(as_table(organ, "an organ"), "file", organ.place), "file");
        if (!fs::exists(meshes / name)) {
            throw InputError(fmt::format("--confirmation {}: lacks {}, an organ of the confirmation set",
                                         meshes.string(), name));
        }
        confirmation.organs.push_back(read_organ_entry(organ, meshes));
    }
    return confirmation;
}

/// What the file of claims says of a sweep.
struct SweepNote {
    std::vector<const Metric*> metrics;
    std::uint64_t quick_seeds = 0;
};

std::vector<const Metric*> read_metrics(const ConfigValue& value) {
    try {
        return choose_metrics(fmt::format("{}", fmt::join(texts_of(value, "metrics"), ",")));
    } catch (const std::invalid_argument& error) {
        throw PlacedError(value.place, error.what());
    }
}

SweepNote read_note(const ConfigValue& value) {
    static const std::array<std::string, 2> known{"metrics", "quick_seeds"};
    const ConfigTable& table = as_table(value, "a sweep");
    check_keys(table, "key of a sweep", known);
    const ConfigValue& seeds = needed(table, "quick_seeds", value.place);
    if (as_whole_number(seeds, "quick_seeds") < 1)
        throw PlacedError(seeds.place, "quick_seeds must be at least 1");
    return {.metrics = read_metrics(needed(table, "metrics", value.place)),
            .quick_seeds = static_cast<std::uint64_t>(as_whole_number(seeds, "quick_seeds"))};
}

/// Of each sweep, by its name in the file of claims.
std::map<std::string, SweepNote> read_notes(const ConfigTable& table) {
    std::map<std::string, SweepNote> notes;
    for (const ConfigEntry& entry : as_table(needed(table, "sweep", {}), "sweep"))
        notes[entry.key] = read_note(entry.value);
    return notes;
}

bool is_chosen(const Claim& claim, const ClaimsWish& wish) {
    return wish.chosen.empty() || std::ranges::find(wish.chosen, claim.id) != wish.chosen.end();
}

void check_chosen(std::span<const std::string> chosen, const std::vector<Claim>& claims) {
    std::vector<std::string> ids;
    for (const Claim& claim : claims) ids.push_back(claim.id);
    for (const std::string& id : chosen) {
        if (std::ranges::find(ids, id) == ids.end()) throw InputError(unknown_name("claim", id, ids));
    }
}

/// A sweep on its way into the plan.
struct Draft {
    ClaimSweep sweep;
    std::uint64_t quick_seeds = 0;
    std::uint64_t seeds = 0;  ///< of it that are wanted now; 0: no chosen claim needs it
};

Draft read_draft(const std::string& name, const fs::path& folder, const std::string& claim,
                 const std::map<std::string, SweepNote>& notes) {
    const fs::path file = folder / name;
    if (!fs::exists(file))
        throw InputError(fmt::format("{}: there is no such file; claim {} names it", file.string(), claim));
    const auto note = notes.find(name);
    if (note == notes.end()) {
        throw InputError(
            fmt::format("claim {} is judged on {}, but there is no [sweep.\"{}\"]", claim, name, name));
    }
    return {.sweep = {.sweep = read_sweep(file), .file = file, .metrics = note->second.metrics, .cases = {}},
            .quick_seeds = note->second.quick_seeds};
}

std::vector<Draft>::iterator find_draft(std::vector<Draft>& drafts, const fs::path& file) {
    return std::ranges::find_if(drafts, [&](const Draft& draft) { return draft.sweep.file == file; });
}

/// The sweeps that claims name, each once, and how many of their seeds are wanted.
std::vector<Draft> read_drafts(const std::vector<Claim>& claims,
                               const std::map<std::string, SweepNote>& notes, const ClaimsWish& wish,
                               const fs::path& folder) {
    std::vector<Draft> drafts;
    for (const Claim& claim : claims) {
        for (const std::string& name : claim.sweeps) {
            auto found = find_draft(drafts, folder / name);
            if (found == drafts.end()) {
                drafts.push_back(read_draft(name, folder, claim.id, notes));
                found = std::prev(drafts.end());
            }
            if (is_chosen(claim, wish))
                found->seeds = wish.is_quick ? found->quick_seeds : std::numeric_limits<std::uint64_t>::max();
        }
    }
    return drafts;
}

void add_confirmation(std::vector<Draft>& drafts, const Confirmation& confirmation, const fs::path& folder) {
    for (const std::string& name : confirmation.sweeps) {
        const auto found =
            std::ranges::find(drafts, folder / name, [](const Draft& draft) { return draft.sweep.file; });
        if (found == drafts.end()) {
            throw InputError(fmt::format("{}: the confirmation set names it, but no claim does",
                                         (folder / name).string()));
        }
        auto& organs = found->sweep.sweep.organs;
        organs.insert(organs.end(), confirmation.organs.begin(), confirmation.organs.end());
    }
}

/// Has all cases of the one sweep measured by what the other's are measured by too.
void add_metrics(ClaimSweep& one, const ClaimSweep& other) {
    for (const Metric* metric : other.metrics) {
        if (std::ranges::find(one.metrics, metric) == one.metrics.end()) one.metrics.push_back(metric);
    }
}

/// Each case belongs to the first sweep that has it, is run when any sweep wants it, and measured as all of
/// them want it.
void share_out_cases(ClaimsPlan& plan, std::vector<Draft> drafts) {
    struct Owned {
        CaseInputs inputs;
        std::size_t sweep;
        bool is_wanted;
    };
    std::vector<Owned> cases;
    std::map<std::string, std::size_t> place;  // in `cases`, of each id
    for (std::size_t k = 0; k < drafts.size(); ++k) {
        SuitedCases all = suited(list_cases(drafts[k].sweep.sweep));
        std::ranges::move(all.left_out, std::back_inserter(plan.left_out));
        for (CaseInputs& inputs : all.cases) {
            const bool is_wanted = inputs.seed <= drafts[k].seeds;
            const auto [known, is_new] = place.try_emplace(inputs.case_id, cases.size());
            if (is_new) {
                inputs.sweep_number = static_cast<std::int64_t>(cases.size()) + 1;
                cases.push_back({std::move(inputs), k, is_wanted});
            } else {
                Owned& owned = cases[known->second];
                owned.is_wanted |= is_wanted;
                add_metrics(drafts[owned.sweep].sweep, drafts[k].sweep);
            }
        }
    }
    for (Draft& draft : drafts) plan.sweeps.push_back(std::move(draft.sweep));
    for (Owned& one : cases) {
        plan.case_order.push_back(one.inputs.case_id);
        if (one.is_wanted) plan.sweeps[one.sweep].cases.push_back(std::move(one.inputs));
    }
}

ClaimsPlan read_plan(const ConfigTable& table, const fs::path& file, const ClaimsWish& wish) {
    const std::vector<Claim> claims = read_claims(table);
    check_chosen(wish.chosen, claims);
    ClaimsPlan plan;
    plan.needs_turns = std::ranges::any_of(
        claims, [&](const Claim& claim) { return claim.of_turns && is_chosen(claim, wish); });
    const fs::path folder = file.parent_path();
    std::vector<Draft> drafts = read_drafts(claims, read_notes(table), wish, folder);
    if (wish.meshes) add_confirmation(drafts, read_confirmation(table, *wish.meshes), folder);
    share_out_cases(plan, std::move(drafts));
    return plan;
}

}  // namespace

ClaimsPlan plan_claims(const fs::path& file, const ClaimsWish& wish) {
    const std::string text = read_bytes(file);
    try {
        ClaimsPlan plan = read_plan(parse_toml(text), file, wish);
        for (const ClaimSweep& one : plan.sweeps) {
            plan.text += fmt::format("# {}\n{}\n", one.file.filename().string(), one.sweep.text);
        }
        return plan;
    } catch (const PlacedError& error) {
        throw InputError(
            fmt::format("{}:{}:{}: {}", file.string(), error.place.line, error.place.column, error.what()));
    }
}

}  // namespace trocar
