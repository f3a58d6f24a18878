#include "strategies/options.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "common/nearest_name.h"

namespace trocar {
namespace {

const char* kind_of(const OptionValue& value) {
    static constexpr std::array names = {"true or false", "a number", "a text"};
    return names[value.index()];
}

void check_value(const OptionSpec& spec, const OptionValue& value) {
    if (value.index() != spec.default_value.index()) {
        throw OptionError(spec.name, fmt::format("option \"{}\" must be {}, not {}", spec.name,
                                                 kind_of(spec.default_value), kind_of(value)));
    }
    if (const auto* text = std::get_if<std::string>(&value)) {
        if (std::ranges::find(spec.choices, *text) != spec.choices.end()) return;
        if (spec.check_contents != nullptr) {
            try {
                spec.check_contents(*text);
                return;
            } catch (const ContentsError& error) {
                throw OptionError(spec.name, fmt::format("option \"{}\", line {} of its contents: {}",
                                                         spec.name, error.line, error.what()));
            }
        }
        throw OptionError(
            spec.name, unknown_name(fmt::format("value of option \"{}\":", spec.name), *text, spec.choices));
    }
    if (const auto* figure = std::get_if<double>(&value)) {
        if (*figure >= spec.low && *figure <= spec.high) return;
        throw OptionError(spec.name, fmt::format("option \"{}\" must be from {} to {}, not {}", spec.name,
                                                 spec.low, spec.high, *figure));
    }
}

}  // namespace

Options resolve_options(const std::vector<OptionSpec>& specs, const Options& given) {
    Options resolved;
    std::vector<std::string> names;
    for (const OptionSpec& spec : specs) {
        resolved[spec.name] = spec.default_value;
        names.push_back(spec.name);
    }
    for (const auto& [name, value] : given) {
        const auto spec = std::ranges::find(specs, name, &OptionSpec::name);
        if (spec == specs.end()) throw OptionError(name, unknown_name("option", name, names));
        check_value(*spec, value);
        resolved[name] = value;
    }
    return resolved;
}

bool flag(const Options& options, const std::string& name) { return std::get<bool>(options.at(name)); }

double number(const Options& options, const std::string& name) { return std::get<double>(options.at(name)); }

const std::string& word(const Options& options, const std::string& name) {
    return std::get<std::string>(options.at(name));
}

}  // namespace trocar
