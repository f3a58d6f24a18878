#include "experiments/metrics/missing.h"

#include <stdexcept>

namespace trocar {

std::string_view missing_reason(Missing missing) {
    switch (missing) {
        case Missing::nothing:
            return "";
        case Missing::no_vertex_collided:
            return "no vertex collided";
        case Missing::no_vertex_inside:
            return "no vertex inside";
        case Missing::no_vertex_moved:
            return "no vertex moved";
        case Missing::no_edge_collided:
            return "no edge collided";
        case Missing::motion_along_normal:
            return "motion along the normal";
        case Missing::no_direction:
            return "no direction";
        case Missing::keeps_state:
            return "strategy keeps state";
        case Missing::open_organ:
            return "open organ";
        case Missing::empty_region:
            return "empty region";
        case Missing::too_early:
            return "too early";
        case Missing::no_answer:
            return "no answer";
        case Missing::not_sampled:
            return "not sampled";
    }
    throw std::logic_error("a reason without words");
}

}  // namespace trocar
