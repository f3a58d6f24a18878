#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace trocar {

/// Lists of numbers, one after another in one array.
class NumberLists {
  public:
    NumberLists() : begins_{0} {}

    void add(std::span<const std::uint32_t> list) {
        numbers_.insert(numbers_.end(), list.begin(), list.end());
        begins_.push_back(numbers_.size());
    }
    [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t list) const {
        return {numbers_.data() + begins_[list], begins_[list + 1] - begins_[list]};
    }
    /// Where the numbers of a list begin among those of all lists.
    [[nodiscard]] std::size_t begin(std::size_t list) const { return begins_[list]; }
    [[nodiscard]] std::size_t size() const { return begins_.size() - 1; }
    [[nodiscard]] std::size_t total() const { return numbers_.size(); }

  private:
    std::vector<std::uint32_t> numbers_;
    std::vector<std::size_t> begins_;
};

}  // namespace trocar
