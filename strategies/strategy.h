#pragma once

#include <string>
#include <vector>

#include "common/cycle/contact.h"
#include "strategies/options.h"

namespace trocar {

/// What a strategy guarantees, under the options it was made with. The contract tests hold it to each.
struct Promises {
    bool clears_convex_tools = false;  ///< every collided vertex leaves a convex tool, by at least g/2
    bool clears_any_tool = false;      ///< … any tool
    bool facet_order_free = false;     ///< the answer does not depend on how the organ's facets are numbered
    bool moves_collided_only = true;   ///< vertices that are not collided stay where they are
};

/// How a strategy introduces itself.
struct Description {
    std::string name;       ///< as in a sweep file, such as "nearest-face"
    std::string summary;    ///< one line
    std::string reference;  ///< where the method is from: paper, section, equation
    std::vector<OptionSpec> options;
    bool keeps_state = false;    ///< its answer may depend on earlier steps
    bool swept_contact = false;  ///< it may move vertices that are not collided because the tool swept
                                 ///< through them in this step
};

/// A collision-handling strategy: given what detection found in a step, says where organ vertices go.
///
/// One instance serves one run of one case and is called once a step, also when nothing collided. It may keep
/// scratch memory, but no state between calls unless its description says so. One that keeps none may be
/// asked again within a step, for a metric, with an organ whose rings begin elsewhere. It uses no globals, no
/// randomness and no I/O, so that instances run on several threads at once.
class Strategy {
  public:
    Strategy() = default;
    Strategy(const Strategy&) = delete;
    Strategy& operator=(const Strategy&) = delete;
    virtual ~Strategy() = default;

    /// What it guarantees under the options that it was made with.
    [[nodiscard]] virtual Promises promises() const = 0;

    /// Appends its answer to `response`, which is empty.
    virtual void handle(const Contact& contact, Response& response) = 0;
};

}  // namespace trocar
