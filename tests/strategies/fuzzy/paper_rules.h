#pragma once

#include <stdexcept>
#include <string>

#include "strategies/fuzzy/inference.h"
#include "strategies/fuzzy/read_rules.h"
#include "strategies/fuzzy/rules_option.h"

namespace trocar::fuzzy {

/// The rule base that ships.
inline const Inference& paper_inference() {
    static const Inference inference(read_rules(shipped_rules()));
    return inference;
}

/// The rule base that ships, with the first `from` in it replaced. Throws where there is none: a test that
/// changes nothing tests nothing.
inline std::string with(const std::string& from, const std::string& to) {
    std::string text = shipped_rules();
    const auto at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("the rule base that ships has no \"" + from + "\"");
    return text.replace(at, from.size(), to);
}

/// The rule base that ships, with interaction cases that pass into one another smoothly, or all at once.
inline std::string with_cases(const std::string& penetration, const std::string& sliding,
                              const std::string& extraction) {
    std::string text = shipped_rules();
    const auto change = [&](const std::string& from, const std::string& to) {
        text.replace(text.find(from), from.size(), to);
    };
    change("penetration Ramp -0.4142 -1", "penetration " + penetration);
    change("sliding Trapezoid -1 -0.4142 0.4142 1", "sliding " + sliding);
    change("extraction Ramp 0.4142 1", "extraction " + extraction);
    return text;
}

inline std::string smooth_rules() {
    return with_cases("ZShape -1 -0.4142", "PiShape -1 -0.4142 0.4142 1", "SShape 0.4142 1");
}

inline std::string crisp_rules() {
    return with_cases("Rectangle -1 -0.7071", "Rectangle -0.7071 0.7071", "Rectangle 0.7071 1");
}

}  // namespace trocar::fuzzy
