#include "experiments/run/done_cases.h"

#include <fmt/format.h>

#include "experiments/input_error.h"
#include "results/store.h"

namespace trocar {
namespace {

void add_cases(DoneCases& done, const std::filesystem::path& file, const Contents& contents) {
    for (const Contents::Case& one : contents.cases) {
        done[one.case_id] = {.file = file,
                             .build_id = one.build_id,
                             .status = one.status,
                             .has_series = one.has_series,
                             .has_replay = one.has_replay,
                             .metrics = one.metrics,
                             .attempts = one.attempts,
                             .end = one.end,
                             .machine = one.machine};
    }
}

std::vector<Contents> read_parts(const std::vector<std::filesystem::path>& files) {
    try {
        return read_contents(files);
    } catch (const StoreError& error) {
        throw InputError(fmt::format("{}\nremove this file, and its case is run again", error.what()));
    }
}

Contents read_out(const std::filesystem::path& out) {
    if (!std::filesystem::is_regular_file(out)) {
        throw InputError(fmt::format("{}: exists and is no file; choose another output", out.string()));
    }
    try {
        return read_contents(out);
    } catch (const StoreError& error) {
        throw InputError(fmt::format("{}\n{} exists and is left as it is; choose another output",
                                     error.what(), out.string()));
    }
}

/// Whether two entries of one case are of the same run of it: no machine ends two of them in one millisecond.
bool is_same_run(const DoneCase& one, const DoneCase& other) {
    return !one.end.empty() && one.end == other.end && one.machine == other.machine &&
           one.build_id == other.build_id;
}

}  // namespace

std::filesystem::path parts_folder_of(const std::filesystem::path& out) { return out.string() + ".parts"; }

std::filesystem::path fresh_parts_folder_of(const std::filesystem::path& out) {
    return out.string() + ".fresh.parts";
}

DoneCases find_parts(const std::filesystem::path& folder, const std::string& sweep_hash) {
    DoneCases done;
    std::vector<std::filesystem::path> files;
    std::error_code none;  // no folder, no parts
    for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
        if (entry.path().extension() == ".h5") files.push_back(entry.path());
    }
    const std::vector<Contents> parts = read_parts(files);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].header.sweep_hash != sweep_hash) {
            throw InputError(
                fmt::format("{}: holds cases of another sweep whose run was cut off; finish that "
                            "run, or remove this folder",
                            folder.string()));
        }
        add_cases(done, files[i], parts[i]);
    }
    return done;
}

DoneCases find_fresh_parts(const std::filesystem::path& out, const std::string& sweep_hash) {
    DoneCases parts = find_parts(fresh_parts_folder_of(out), sweep_hash);
    if (parts.empty() || !std::filesystem::exists(out)) return parts;
    DoneCases published;
    add_cases(published, out, read_out(out));
    std::erase_if(parts, [&](const auto& part) {
        const auto found = published.find(part.first);
        return found != published.end() && is_same_run(part.second, found->second);
    });
    return parts;
}

DoneCases find_done_cases(const std::filesystem::path& out, const std::string& sweep_hash) {
    DoneCases done;
    if (std::filesystem::exists(out)) {
        const Contents contents = read_out(out);
        if (contents.header.sweep_hash != sweep_hash) {
            throw InputError(
                fmt::format("{}: holds the results of another sweep; choose another output", out.string()));
        }
        add_cases(done, out, contents);
    }
    for (auto& [id, one] : find_parts(parts_folder_of(out), sweep_hash)) done[id] = std::move(one);
    return done;
}

}  // namespace trocar
