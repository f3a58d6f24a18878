#include "experiments/metrics/paths.h"

namespace trocar {

Paths::Paths(const JudgedState& start) : positions_(start.positions()), pose_(start.pose()) {}

void Paths::move(const JudgedState& before) { pose_ = before.pose(); }

void Paths::handle(const JudgedState& handled) { positions_ = handled.positions(); }

void Paths::deform(const JudgedState& deformed) { positions_ = deformed.positions(); }

std::size_t Paths::crossings(const JudgedState&) const { return 0; }

}  // namespace trocar
