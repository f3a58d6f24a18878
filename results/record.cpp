#include "results/record.h"

namespace trocar {

std::string_view status_name(CaseStatus status) {
    switch (status) {
        case CaseStatus::complete:
            return "complete";
        case CaseStatus::diverged:
            return "diverged";
        case CaseStatus::failed:
            return "failed";
        case CaseStatus::timed_out:
            return "timed_out";
        case CaseStatus::out_of_memory:
            return "out_of_memory";
        case CaseStatus::crashed:
            return "crashed";
    }
    return "failed";
}

}  // namespace trocar
