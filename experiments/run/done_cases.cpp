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
                             .has_replay = one.has_replay,
                             .metrics = one.metrics};
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

}  // namespace

std::filesystem::path parts_folder_of(const std::filesystem::path& out) { return out.string() + ".parts"; }

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
    const std::filesystem::path parts = parts_folder_of(out);
    if (!std::filesystem::is_directory(parts)) return done;
    for (const auto& entry : std::filesystem::directory_iterator(parts)) {
        if (entry.path().extension() != ".h5") continue;
        const Contents contents = read_contents(entry.path());
        if (contents.header.sweep_hash != sweep_hash) {
            throw InputError(
                fmt::format("{}: holds cases of another sweep whose run was cut off; finish that "
                            "run, or remove this folder",
                            parts.string()));
        }
        add_cases(done, entry.path(), contents);
    }
    return done;
}

}  // namespace trocar
