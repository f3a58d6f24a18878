#pragma once

#include <cstdint>
#include <vector>

#include "common/cycle/contact.h"

namespace trocar {

/// Looks an answer of a strategy through before anything is done with it.
class ResponseCheck {
  public:
    /// @param vertices of the organ
    explicit ResponseCheck(std::size_t vertices) : named_in_(vertices, 0) {}

    /// Throws std::runtime_error when an answer is not finite, names a vertex that does not exist, or moves
    /// or pushes a vertex twice. Asks for no memory.
    void check(const Response& response);

  private:
    template <typename Entry>
    void demand_distinct_vertices(const std::vector<Entry>& entries, const char* what);

    std::vector<std::uint64_t> named_in_;  // of each vertex, the last list that named it
    std::uint64_t list_ = 0;
};

}  // namespace trocar
