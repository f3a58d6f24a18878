#include "experiments/run/run_sweep.h"

#include <algorithm>
#include <iterator>
#include <ranges>
#include <set>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/input_error.h"
#include "experiments/run/batches.h"
#include "experiments/run/done_cases.h"
#include "experiments/run/parts_folder.h"
#include "experiments/run/provenance.h"
#include "experiments/run/run_case.h"
#include "experiments/run/shared_scenes.h"
#include "results/store.h"
#include "results/xdmf.h"

namespace trocar {
namespace {

bool was_taken(const Metric* metric, std::string_view names) {
    return std::ranges::any_of(std::views::split(names, ','),
                               [&](const auto name) { return std::ranges::equal(name, metric->name); });
}

/// What an earlier run of the same build left of the case; nullptr when it left nothing.
const DoneCase* left_of(const CaseInputs& inputs, const DoneCases& done, const RunRequest& request) {
    const auto found = done.find(inputs.case_id);
    return found != done.end() && found->second.build_id == request.build_id ? &found->second : nullptr;
}

bool has_result(const DoneCases& done, const CaseInputs& inputs, const RunRequest& request) {
    const DoneCase* left = left_of(inputs, done, request);
    return left != nullptr && left->has_series && (left->has_replay || !request.options.replay) &&
           std::ranges::all_of(request.options.metrics,
                               [&](const Metric* metric) { return was_taken(metric, left->metrics); });
}

bool is_done(const DoneCases& done, const CaseInputs& inputs, const RunRequest& request) {
    return has_result(done, inputs, request) &&
           (!request.retry_failed || done.at(inputs.case_id).status == status_name(CaseStatus::complete));
}

/// What is asked of the case, and what an earlier run already has of it: running it again takes nothing away.
CaseOptions options_of(const CaseInputs& inputs, const DoneCases& done, const RunRequest& request) {
    CaseOptions options = request.options;
    const auto earlier = done.find(inputs.case_id);
    if (earlier != done.end()) options.earlier_attempts = earlier->second.attempts;
    const DoneCase* left = left_of(inputs, done, request);
    if (left == nullptr) return options;
    options.replay = options.replay || left->has_replay;
    std::vector<const Metric*> both;
    for (const Metric& metric : all_metrics()) {
        const bool asked = std::ranges::find(options.metrics, &metric) != options.metrics.end();
        if (asked || was_taken(&metric, left->metrics)) both.push_back(&metric);
    }
    options.metrics = std::move(both);
    return options;
}

std::vector<CaseInputs> pending_of(const RunRequest& request, const DoneCases& done) {
    std::vector<CaseInputs> pending;
    std::ranges::copy_if(request.cases, std::back_inserter(pending),
                         [&](const CaseInputs& inputs) { return !is_done(done, inputs, request); });
    return pending;
}

std::string text_cell(const CaseRecord& record, std::string_view name) {
    const auto cell = std::ranges::find(record.cells, name, &Cell::name);
    return std::get<std::string>(cell->value);
}

std::string failure_line(const CaseInputs& inputs, const CaseRecord& record) {
    return fmt::format("{}: {}, {}, {}, {}, {} mm/s, seed {}: {}", text_cell(record, "status"),
                       inputs.strategy.label, inputs.organ.organ->name, inputs.tool.tool->name,
                       inputs.scene.name, inputs.speed, inputs.seed, text_cell(record, "reason"));
}

/// Writes the case as a part.
void store_case(CaseRecord& record, const RunRequest& request, const std::filesystem::path& file,
                const std::string& start) {
    record.build_id = request.build_id;
    record.provenance = provenance_row(record.case_id, request.arguments, start, now_utc());
    write_case(file, request.header, record);
}

/// Brings everything that is done into `out`, unless it is there already. What is no case of the sweep a run
/// with --fresh leaves behind; others were refused (see check_known).
void merge_done(const RunRequest& request, const DoneCases& done) {
    std::map<std::filesystem::path, std::set<std::string>> ids_of_file;
    std::vector<std::string> order;
    for (const std::string& id : request.case_order) {
        const auto found = done.find(id);
        if (found == done.end()) continue;
        ids_of_file[found->second.file].insert(id);
        order.push_back(id);
    }
    const bool nothing_new = ids_of_file.size() == 1 && ids_of_file.begin()->first == request.out;
    if (order.empty() || nothing_new) return;
    std::vector<Part> parts;
    parts.reserve(ids_of_file.size());
    for (const auto& [file, ids] : ids_of_file) parts.push_back({.file = file, .case_ids = ids});
    merge(request.out, request.header, parts, order);
}

/// Where the result file holds replays: the file beside it through which ParaView opens them. Else an empty
/// path.
std::filesystem::path write_xdmf_beside(const RunRequest& request, const DoneCases& done) {
    const bool any = std::ranges::any_of(done, [](const auto& entry) { return entry.second.has_replay; });
    if (!any) return {};
    const std::filesystem::path xdmf = std::filesystem::path(request.out).replace_extension(".xdmf");
    write_xdmf(request.out, xdmf);
    return xdmf;
}

/// Throws InputError where something is done that is no case of the sweep: its text is the same, but a file
/// that it names is not. Running would lose it.
void check_known(const RunRequest& request, const DoneCases& done) {
    const std::set<std::string> known(request.case_order.begin(), request.case_order.end());
    const auto lost =
        std::ranges::count_if(done, [&](const auto& entry) { return !known.contains(entry.first); });
    if (lost == 0) return;
    throw InputError(
        fmt::format("{}: holds {} cases that this sweep does not have: a file that it names (a mesh, a "
                    "recording, rules) has changed since; choose another output, or --fresh to start over",
                    request.out.string(), lost));
}

/// What earlier runs left that this one need not do.
DoneCases find_kept_cases(const RunRequest& request) {
    const std::string& sweep = request.header.sweep_hash;
    if (request.fresh) return find_fresh_parts(request.out, sweep);
    DoneCases done = find_done_cases(request.out, sweep);
    check_known(request, done);
    return done;
}

}  // namespace

std::vector<CaseInputs> pending_cases(const RunRequest& request) {
    return pending_of(request, find_kept_cases(request));
}

namespace {

CaseStatus status_of(Loss loss) {
    switch (loss) {
        case Loss::timed_out:
            return CaseStatus::timed_out;
        case Loss::out_of_memory:
            return CaseStatus::out_of_memory;
        case Loss::crashed:
            break;
    }
    return CaseStatus::crashed;
}

/// The pending cases of one run: what a worker does with them, and what the supervisor books.
class PendingRun {
  public:
    PendingRun(const RunRequest& request, DoneCases& done, const std::filesystem::path& parts,
               const std::function<void(std::size_t, std::size_t)>& on_progress)
        : request_(request),
          done_(done),
          parts_(parts),
          on_progress_(on_progress),
          pending_(pending_of(request, done)) {
        pending_ = request.timing ? spread_out(std::move(pending_), request.header.sweep_hash)
                                  : by_scene(std::move(pending_));
        for (const CaseInputs& inputs : pending_) options_.push_back(options_of(inputs, done, request));
    }

    void run(RunOutcome& outcome, const std::stop_token& stop) {
        const unsigned workers = request_.timing ? 1 : request_.jobs;
        outcome.kept = request_.cases.size() - pending_.size();
        const Listener listener{
            .done = [&](std::uint64_t task, const std::string& said) { book(task, said, outcome); },
            .lost = [&](const LostTask& lost) { book(lost.task, store_lost(lost), outcome); }};
        try {
            supervise(
                batches_of(pending_, workers), workers, request_.limits, stop,
                [&](const Batch& batch, const Reports& report) { work(batch, report); }, listener);
        } catch (const WorkerError& error) {
            throw StoreError(error.what());
        }
        outcome.interrupted = outcome.ran < pending_.size();
    }

  private:
    /// In a worker.
    void work(const Batch& batch, const Reports& report) const {
        if (request_.timing) stay_on_one_core();
        SharedScenes scenes{std::span(pending_).subspan(batch.begin, batch.end - batch.begin)};
        const SceneSource scene_of = [&](const CaseInputs& inputs) { return scenes.scene_of(inputs); };
        for (std::uint64_t task = batch.begin; task < batch.end; ++task) {
            const bool is_first = task == batch.begin;
            CaseOptions options = options_[task];
            options.not_asked = is_first ? batch.left_out : 0;
            options.asking = report.part;
            const std::string start = now_utc();
            CaseRecord record = run_one(pending_[task], scene_of, options);
            report.done(store(task, std::move(record), is_first ? batch.attempt : 1, start));
        }
    }

    /// The strategy is made and gone before the case is reported, so that what it does then is its own
    /// case's.
    static CaseRecord run_one(const CaseInputs& inputs, const SceneSource& scene_of,
                              const CaseOptions& options) {
        const auto unmade = [&](const std::string& reason) {
            return lost_case(inputs, options, CaseStatus::failed,
                             fmt::format("the strategy cannot be made: {}", reason), 0);
        };
        std::unique_ptr<Strategy> strategy;
        try {
            strategy = options.make(inputs.strategy);
        } catch (const std::exception& error) {
            return unmade(error.what());
        } catch (...) {
            return unmade("something that is no std::exception was thrown");
        }
        std::optional<CaseRecord> record = run_case(inputs, scene_of, *strategy, options, {});
        if (!record) throw std::logic_error("a case stopped that nobody asked to stop");
        return std::move(*record);
    }

    std::string store_lost(const LostTask& lost) const {
        return store(lost.task,
                     lost_case(pending_[lost.task], options_[lost.task], status_of(lost.loss), lost.reason,
                               lost.seconds),
                     lost.attempt, now_utc());
    }

    /// Writes the record as a part, and says what the supervisor must know of it.
    std::string store(std::uint64_t task, CaseRecord record, std::uint64_t attempt,
                      const std::string& start) const {
        std::ranges::find(record.cells, "attempts", &Cell::name)->value =
            options_[task].earlier_attempts + static_cast<std::int64_t>(attempt);
        store_case(record, request_, part_of(task), start);
        const std::string status = text_cell(record, "status");
        const bool complete = status == status_name(CaseStatus::complete);
        return nlohmann::json{{"status", status},
                              {"failure", complete ? "" : failure_line(pending_[task], record)}}
            .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    }

    void book(std::uint64_t task, const std::string& said, RunOutcome& outcome) {
        const nlohmann::json report = nlohmann::json::parse(said);
        done_[pending_[task].case_id] = {.file = part_of(task),
                                         .build_id = request_.build_id,
                                         .status = report.at("status"),
                                         .has_series = true,
                                         .has_replay = options_[task].replay,
                                         .metrics = metric_names(options_[task].metrics),
                                         .end = {},
                                         .machine = {}};
        if (const std::string failure = report.at("failure"); !failure.empty()) {
            outcome.failures.push_back(failure);
        }
        on_progress_(++outcome.ran, pending_.size());
    }

    [[nodiscard]] std::filesystem::path part_of(std::uint64_t task) const {
        return parts_ / (pending_[task].case_id + ".h5");
    }

    const RunRequest& request_;
    DoneCases& done_;
    const std::filesystem::path& parts_;
    const std::function<void(std::size_t, std::size_t)>& on_progress_;
    std::vector<CaseInputs> pending_;
    std::vector<CaseOptions> options_;  // of each of them
};

}  // namespace

RunOutcome run_sweep(const RunRequest& request,
                     const std::function<void(std::size_t, std::size_t)>& on_progress,
                     const std::stop_token& stop) {
    const PartsFolder parts(request.out, request.fresh ? PartsOf::fresh_run : PartsOf::any_run);
    DoneCases done = find_kept_cases(request);
    const DoneCases before = request.fresh ? find_done_cases(request.out, request.header.sweep_hash) : done;
    RunOutcome outcome;
    PendingRun(request, done, parts.path(), on_progress).run(outcome, stop);
    std::ranges::sort(outcome.failures);
    for (const CaseInputs& inputs : request.cases) {
        if (has_result(done, inputs, request)) ++outcome.by_status[done.at(inputs.case_id).status];
    }
    outcome.merged = !(request.fresh && outcome.interrupted);
    if (!outcome.merged) return outcome;
    done.insert(before.begin(), before.end());  // cases that a fresh run was not asked for
    merge_done(request, done);
    parts.clear();
    outcome.xdmf = write_xdmf_beside(request, done);
    return outcome;
}

}  // namespace trocar
