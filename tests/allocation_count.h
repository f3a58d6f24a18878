#pragma once

#include <cstdint>

namespace trocar::testing_support {

/// Counts the blocks of memory that this thread asks operator new for, from the object's beginning. Only in a
/// program that is linked with allocation_count.cpp, which replaces operator new.
class AllocationCount {
  public:
    AllocationCount();
    [[nodiscard]] std::int64_t so_far() const;

  private:
    std::int64_t before_;
};

}  // namespace trocar::testing_support
