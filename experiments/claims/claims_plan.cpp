#include "experiments/claims/claims_plan.h"

#include <algorithm>
#include <set>
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
        confirmation.organs.push_back(read_organ_entry(organ, meshes));
    }
    return confirmation;
}

void check_chosen(std::span<const std::string> chosen, const std::vector<Claim>& claims) {
    std::vector<std::string> ids;
    for (const Claim& claim : claims) ids.push_back(claim.id);
    for (const std::string& id : chosen) {
        if (std::ranges::find(ids, id) == ids.end()) throw InputError(unknown_name("claim", id, ids));
    }
}

/// Adds the sweeps of a claim that are not there yet, and marks those that it needs.
void add_sweeps(ClaimsPlan& plan, const Claim& claim, bool is_chosen, const fs::path& folder) {
    for (const std::string& name : claim.sweeps) {
        const fs::path file = folder / name;
        auto found = std::ranges::find(plan.sweeps, file, &ClaimSweep::file);
        if (found == plan.sweeps.end()) {
            plan.sweeps.push_back({.sweep = read_sweep(file), .file = file, .cases = {}});
            plan.needed.push_back(false);
            found = std::prev(plan.sweeps.end());
        }
        if (is_chosen) plan.needed[static_cast<std::size_t>(found - plan.sweeps.begin())] = true;
    }
}

void add_confirmation(ClaimsPlan& plan, const Confirmation& confirmation, const fs::path& folder) {
    for (const std::string& name : confirmation.sweeps) {
        const auto found = std::ranges::find(plan.sweeps, folder / name, &ClaimSweep::file);
        if (found == plan.sweeps.end()) {
            throw InputError(fmt::format("{}: the confirmation set names it, but no claim does",
                                         (folder / name).string()));
        }
        auto& organs = found->sweep.organs;
        organs.insert(organs.end(), confirmation.organs.begin(), confirmation.organs.end());
    }
}

/// Each case belongs to the first sweep that has it.
void share_out_cases(ClaimsPlan& plan) {
    std::set<std::string> known;
    std::int64_t number = 0;
    for (ClaimSweep& one : plan.sweeps) {
        SuitedCases all = suited(list_cases(one.sweep));
        std::ranges::move(all.left_out, std::back_inserter(plan.left_out));
        for (CaseInputs& inputs : all.cases) {
            if (!known.insert(inputs.case_id).second) continue;
            inputs.sweep_number = ++number;
            one.cases.push_back(std::move(inputs));
        }
    }
}

ClaimsPlan read_plan(const ConfigTable& table, const fs::path& file, std::span<const std::string> chosen,
                     const std::optional<fs::path>& meshes) {
    const std::vector<Claim> claims = read_claims(table);
    check_chosen(chosen, claims);
    ClaimsPlan plan;
    plan.metrics = fmt::format("{}", fmt::join(texts_of(needed(table, "metrics", {}), "metrics"), ","));
    plan.quick_seeds =
        static_cast<std::uint64_t>(as_whole_number(needed(table, "quick_seeds", {}), "quick_seeds"));
    const fs::path folder = file.parent_path();
    for (const Claim& claim : claims) {
        const bool is_chosen = chosen.empty() || std::ranges::find(chosen, claim.id) != chosen.end();
        plan.needs_turns = plan.needs_turns || (is_chosen && claim.of_turns);
        add_sweeps(plan, claim, is_chosen, folder);
    }
    if (meshes) add_confirmation(plan, read_confirmation(table, *meshes), folder);
    share_out_cases(plan);
    return plan;
}

}  // namespace

ClaimsPlan plan_claims(const fs::path& file, std::span<const std::string> chosen,
                       const std::optional<fs::path>& meshes) {
    const std::string text = read_bytes(file);
    try {
        ClaimsPlan plan = read_plan(parse_toml(text), file, chosen, meshes);
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
