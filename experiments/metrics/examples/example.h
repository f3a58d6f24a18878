#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "common/tool/tool.h"
#include "experiments/metrics/judge/judged_organ.h"
#include "experiments/metrics/judge/shifted_answers.h"
#include "experiments/metrics/metric.h"

namespace trocar {

// NOLINTBEGIN(readability-redundant-member-init): GCC warns where one is left out that has no initializer.

/// What a picture points out: what the metric counts, or the lengths that it measures.
struct Marks {
    std::vector<Index> vertices{};                ///< of the organ
    std::vector<Index> facets{};                  ///< of the organ
    std::vector<std::array<Vec3, 2>> segments{};  ///< mm
    std::vector<Vec3> points{};                   ///< mm
};

/// One view of organ and tool.
struct Panel {
    std::string title{};
    std::vector<Vec3> positions{};  ///< of the organ's vertices, mm
    Pose tool{};
    std::vector<Vec3> from{};  ///< arrows lead from here to `positions`; empty for none
    Marks marks{};
};

/// Where a picture is taken from: a parallel projection, +z upwards.
struct Eye {
    Vec3 towards{0.5, -1, 0.6};      ///< from the scene to the eye
    Vec3 centre{0, 0, 0};            ///< of the picture, mm
    double width = 26, height = 22;  ///< of what each panel shows, mm
    bool cut = false;  ///< a closed organ is left out where y < the centre's, and its section filled
};

/// A made-up step of which a metric's value is known, and how to draw it.
struct Example {
    std::string metric;
    Moment moment{};          ///< the one that is judged
    double expected = 0;      ///< value of the metric then
    double tolerance = 1e-9;  ///< of `expected`
    std::string caption{};    ///< what happens, in a sentence or two

    Organ organ;
    Tool tool;
    Pose start{}, end{};             ///< of the tool, at the step's beginning and from its first look on
    std::vector<Vec3> two_before{};  ///< every vertex as the step before found it, mm; empty: there was none
    std::vector<Vec3> before{}, handled{}, deformed{};  ///< every vertex at the step's moments, mm
    std::vector<Index> region{};                        ///< vertices near the tool's sweep, ascending
    std::int64_t fallbacks = 0;
    ShiftedAnswers shifted{};  ///< of a strategy that has been made up too

    Eye eye{};
    std::vector<Panel> panels{};
};

// NOLINTEND(readability-redundant-member-init)

/// A step in which nothing happens: the organ is at rest, the tool stays at `pose`, every vertex is near it.
Example still_step(std::string metric, Moment moment, Organ organ, Tool tool, const Pose& pose);

/// Takes the example's metric of its step, as a judge does in a run.
Measured judge_example(const Example& example);

/// An example of every metric of all_metrics(), in that order.
const std::vector<Example>& all_examples();

/// The example of a metric. Throws std::invalid_argument for a name that none has, naming the nearest.
const Example& find_example(const std::string& metric);

}  // namespace trocar
