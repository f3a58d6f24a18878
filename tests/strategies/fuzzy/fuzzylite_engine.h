#pragma once

#include <memory>
#include <string>

#include <fl/Headers.h>

#include "strategies/fuzzy/interaction.h"

namespace trocar::fuzzy {

/// A rule base as fuzzylite itself evaluates it: an oracle that shares no code with our inference but the
/// file.
class FuzzyliteEngine {
  public:
    explicit FuzzyliteEngine(const std::string& rules) {
        fl::fuzzylite::setMachEps(1e-15);  // its default of 1e-6 blurs comparisons
        engine_.reset(fl::FllImporter().fromString(rules));
        for (std::size_t k = 0; k < inputs_.size(); ++k) inputs_[k] = engine_->getInputVariable(names_[k]);
        for (std::size_t k = 0; k < outputs_.size(); ++k) {
            outputs_[k] = engine_->getOutputVariable(output_names_[k]);
        }
    }

    Weights evaluate(double collision_index, const Weights& previous, bool first) {
        const std::array<double, 5> values = {collision_index, previous.penetration, previous.sliding,
                                              previous.extraction, first ? 0.0 : 1.0};
        for (std::size_t k = 0; k < inputs_.size(); ++k) inputs_[k]->setValue(values[k]);
        engine_->process();
        return {.penetration = outputs_[0]->getValue(),
                .sliding = outputs_[1]->getValue(),
                .extraction = outputs_[2]->getValue()};
    }

  private:
    static constexpr std::array<const char*, 5> names_ = {"I_C", "previous_P", "previous_S", "previous_E",
                                                          "C_1"};
    static constexpr std::array<const char*, 3> output_names_ = {"I_P", "I_S", "I_E"};
    std::unique_ptr<fl::Engine> engine_;
    std::array<fl::InputVariable*, 5> inputs_{};
    std::array<fl::OutputVariable*, 3> outputs_{};
};

}  // namespace trocar::fuzzy
