#pragma once

#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>

#include "experiments/scenes/prepared_scene.h"
#include "experiments/sweep/cases.h"

namespace trocar {

/// The scene of a case. Throws what prepare_scene throws.
PreparedScene prepare_scene_of(const CaseInputs& inputs);

/// Scenes that are prepared once and shared by all cases that differ only in their strategy or in the
/// release. Each is kept from the first of these cases to the last. Safe on several threads.
class SharedScenes {
  public:
    /// @param cases that will ask, each once
    explicit SharedScenes(std::span<const CaseInputs> cases);

    /// Throws what prepare_scene throws, to each of the cases.
    std::shared_ptr<const PreparedScene> scene_of(const CaseInputs& inputs);

  private:
    struct Shared {
        std::size_t cases_to_come = 0;
        std::shared_future<std::shared_ptr<const PreparedScene>> scene;
    };
    std::mutex guard_;
    std::map<std::string, Shared> scenes_;  // by scene_id
};

}  // namespace trocar
