#include "experiments/run/merge_results.h"

#include <algorithm>
#include <ranges>
#include <set>

#include <fmt/format.h>

#include "experiments/input_error.h"
#include "experiments/run/origins.h"
#include "experiments/run/parts_folder.h"
#include "experiments/run/provenance.h"
#include "results/store.h"
#include "results/xdmf.h"

namespace trocar {
namespace {

namespace fs = std::filesystem;

/// A case and the number of the input that it is taken from.
struct Taken {
    std::size_t input;
    Contents::Case entry;
};

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".h5" && entry.is_regular_file()) files.push_back(entry.path());
    }
    std::ranges::sort(files);
    if (files.empty()) {
        throw InputError(fmt::format("{}: this folder holds no result file (*.h5)", folder.string()));
    }
    return files;
}

/// The files that the inputs stand for, each once.
std::vector<fs::path> listed_files(std::span<const fs::path> inputs) {
    std::vector<fs::path> files;
    std::set<fs::path> known;
    for (const fs::path& input : inputs) {
        for (const fs::path& file : fs::is_directory(input) ? files_in(input) : std::vector{input}) {
            if (known.insert(fs::weakly_canonical(file)).second) files.push_back(file);
        }
    }
    return files;
}

std::vector<Contents> read_all(const std::vector<fs::path>& files) {
    try {
        return read_contents(files);
    } catch (const StoreError& error) {
        throw InputError(fmt::format("{}\nnothing was merged", error.what()));
    }
}

[[noreturn]] void refuse_other(const fs::path& file, const fs::path& first, std::string_view how) {
    throw InputError(fmt::format("{}: {} than {}; merge only results of one sweep; nothing was merged",
                                 file.string(), how, first.string()));
}

/// The header of the merged file.
CampaignHeader common_header(const std::vector<fs::path>& files, const std::vector<Contents>& contents) {
    CampaignHeader header = contents.front().header;
    std::size_t telling = 0;  // the first input that says which cases the sweep has
    for (std::size_t i = 0; i < files.size(); ++i) {
        const CampaignHeader& other = contents[i].header;
        if (other.sweep_hash != header.sweep_hash)
            refuse_other(files[i], files.front(), "comes from another sweep");
        if (!other.sweep_cases) continue;
        if (!header.sweep_cases) {
            header.sweep_cases = other.sweep_cases;
            telling = i;
        }
        if (other.sweep_cases != header.sweep_cases) {
            refuse_other(files[i], files[telling],
                         "a mesh, rule or motion file that the sweep names was another one");
        }
    }
    header.created_utc = now_utc();
    return header;
}

/// Whether a result has all that another of the same build has, or more.
bool has_all_of(const Contents::Case& one, const Contents::Case& other) {
    const auto names = [](const std::string& metrics) {
        std::set<std::string> set;
        for (const auto name : std::views::split(metrics, ',')) set.emplace(name.begin(), name.end());
        return set;
    };
    return (one.has_series || !other.has_series) && (one.has_replay || !other.has_replay) &&
           std::ranges::includes(names(one.metrics), names(other.metrics));
}

/// Of two results of a case, whether the later input's is taken: a complete one before one that is not; of
/// one build the one that has more, for they are the same bits; else the one that ended last.
bool is_taken(const Contents::Case& later, const Contents::Case& earlier) {
    const bool is_complete = later.status == "complete";
    if (is_complete != (earlier.status == "complete")) return is_complete;
    if (is_complete && later.build_id == earlier.build_id) {
        const bool has_more = has_all_of(later, earlier), has_less = has_all_of(earlier, later);
        if (has_more != has_less) return has_more;
    }
    return later.end >= earlier.end;
}

/// Each case once, in the order in which the inputs name it; counts those left out.
std::vector<Taken> newest_cases(const std::vector<Contents>& contents, std::size_t& left_out) {
    std::vector<Taken> taken;
    std::map<std::string, std::size_t> position;
    for (std::size_t input = 0; input < contents.size(); ++input) {
        for (const Contents::Case& entry : contents[input].cases) {
            const auto [known, is_new] = position.try_emplace(entry.case_id, taken.size());
            if (is_new) {
                taken.push_back({.input = input, .entry = entry});
                continue;
            }
            ++left_out;
            Taken& other = taken[known->second];
            if (is_taken(entry, other.entry)) other = {.input = input, .entry = entry};
        }
    }
    return taken;
}

/// Throws InputError unless what `out` holds is among the cases taken, each with its series where it has
/// them.
void check_replaceable(const fs::path& out, const CampaignHeader& header, const std::vector<Taken>& taken,
                       Merged what) {
    if (!fs::exists(out)) return;
    if (!fs::is_regular_file(out))
        throw InputError(fmt::format("{}: exists and is no file; choose another output", out.string()));
    const Contents before = read_all({out}).front();
    if (before.header.sweep_hash != header.sweep_hash) {
        throw InputError(
            fmt::format("{}: holds the results of another sweep; choose another output", out.string()));
    }
    std::map<std::string, bool> ids;  // and whether the series is taken
    for (const Taken& one : taken)
        ids[one.entry.case_id] = one.entry.has_series && what == Merged::everything;
    const auto lost = std::ranges::count_if(
        before.cases, [&](const Contents::Case& one) { return !ids.contains(one.case_id); });
    if (lost > 0) {
        throw InputError(
            fmt::format("{}: holds {} cases that no input holds; name it among the inputs too, or choose "
                        "another output",
                        out.string(), lost));
    }
    const auto stripped = std::ranges::count_if(
        before.cases, [&](const Contents::Case& one) { return one.has_series && !ids.at(one.case_id); });
    if (stripped > 0) {
        throw InputError(
            fmt::format("{}: holds the series of {} cases, which would be lost; choose another output",
                        out.string(), stripped));
    }
}

void write_merged(const fs::path& out, const CampaignHeader& header, const std::vector<fs::path>& files,
                  const std::vector<Taken>& taken, Merged what) {
    std::vector<Part> all;
    for (const fs::path& file : files) all.push_back({.file = file, .case_ids = {}});
    std::vector<std::string> order;
    for (const Taken& one : taken) {
        all[one.input].case_ids.insert(one.entry.case_id);
        order.push_back(one.entry.case_id);
    }
    // To merge, a part without names stands for all of its cases.
    std::erase_if(all, [](const Part& part) { return part.case_ids.empty(); });
    merge(out, header, all, order, what);
}

}  // namespace

MergeOutcome merge_results(std::span<const fs::path> inputs, const fs::path& out, Merged what) {
    const PartsFolder alone(out, PartsOf::any_run);
    const std::vector<fs::path> files = listed_files(inputs);
    const std::vector<Contents> contents = read_all(files);
    const CampaignHeader header = common_header(files, contents);
    MergeOutcome outcome;
    outcome.files = files.size();
    std::vector<Taken> taken = newest_cases(contents, outcome.left_out);
    check_replaceable(out, header, taken, what);

    const auto number = [](const Taken& one) { return one.entry.sweep_number; };
    outcome.in_order = std::ranges::all_of(taken, [&](const Taken& one) { return number(one) > 0; });
    if (outcome.in_order) std::ranges::stable_sort(taken, {}, number);
    write_merged(out, header, files, taken, what);

    outcome.cases = taken.size();
    if (header.sweep_cases) outcome.sweep_cases = static_cast<std::size_t>(header.sweep_cases->count);
    std::vector<Contents::Case> entries;
    for (const Taken& one : taken) {
        ++outcome.by_status[one.entry.status];
        entries.push_back(one.entry);
    }
    outcome.warnings = mixed_origins(entries);
    if (what == Merged::everything && std::ranges::any_of(entries, &Contents::Case::has_replay)) {
        outcome.xdmf = fs::path(out).replace_extension(".xdmf");
        write_xdmf(out, outcome.xdmf);
    }
    return outcome;
}

}  // namespace trocar
