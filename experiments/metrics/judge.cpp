#include "experiments/metrics/judged.h"

namespace trocar {

struct Judge::Case {
    Case(const Organ& organ, const Tool& tool) : judge(organ, tool), step(organ) {}

    void look(Moment moment, const Cycle& cycle) {
        step.moments[static_cast<std::size_t>(moment)] = judge.look(cycle.positions(), cycle.tool().pose());
    }

    ToolJudge judge;
    Judged step;
};

Judge::Judge(const Organ& organ, const Tool& tool) : case_(std::make_unique<Case>(organ, tool)) {}
Judge::~Judge() = default;

void Judge::before(const Cycle& cycle) { case_->look(Moment::before, cycle); }

void Judge::handled(const Cycle& cycle) {
    case_->look(Moment::handled, cycle);
    case_->step.fallbacks = cycle.response().fallbacks;
}

void Judge::deformed(const Cycle& cycle) { case_->look(Moment::deformed, cycle); }

std::vector<double> Judge::values() const {
    std::vector<double> values;
    for (const Metric& metric : all_metrics()) {
        for (const Moment moment : metric.moments) values.push_back(metric.value(case_->step, moment));
    }
    return values;
}

}  // namespace trocar
