#pragma once

#include <optional>

#include "common/cycle/contact.h"
#include "strategies/options.h"

namespace trocar {

/// What becomes of a collided vertex for which a strategy finds no direction (◇).
enum class Fallback {
    nearest_face,  ///< it goes where the strategy nearest-face sends it
    stay,          ///< it stays inside the tool
};

/// The option `fallback` of strategies that may find no direction.
OptionSpec fallback_option();
/// Its value.
Fallback fallback_of(const Options& resolved);

/// Answers that collided `vertex` goes along the unit vector `direction` to its exit from the tool. Without a
/// direction it does what `fallback` says, which is counted in the response.
void leave_tool(const Contact& contact, Index vertex, const std::optional<Vec3>& direction, Fallback fallback,
                Response& response);

}  // namespace trocar
