#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/geometry/organ_shapes.h"
#include "common/tool/tool_shapes.h"
#include "experiments/cli/commands.h"
#include "experiments/metrics/metric.h"
#include "experiments/run/case_series.h"
#include "experiments/scenes/scene.h"
#include "experiments/sweep/cases.h"
#include "strategies/registry.h"

namespace trocar {
namespace {

constexpr const char* footer =
    "Exit codes: 0 done; 2 bad usage.\n"
    "Example:\n"
    "  trocar list strategies";

using Row = std::vector<std::string>;

void print_aligned(const std::vector<Row>& rows, std::string_view indent) {
    std::vector<std::size_t> widths;
    for (const Row& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    for (const Row& row : rows) {
        std::string line(indent);
        for (std::size_t i = 0; i + 1 < row.size(); ++i) line += fmt::format("{:<{}}  ", row[i], widths[i]);
        fmt::print("{}{}\n", line, row.back());
    }
}

/// Of anything with a name and a summary.
template <typename Entry>
void print_named(const std::vector<Entry>& entries) {
    std::vector<Row> rows;
    rows.reserve(entries.size());
    for (const Entry& entry : entries) rows.push_back({entry.name, entry.summary});
    print_aligned(rows, "  ");
}

/// As a sweep file has it.
std::string value_text(const OptionValue& value) {
    const std::string text = option_text(value);
    return std::holds_alternative<std::string>(value) ? fmt::format("\"{}\"", text) : text;
}

std::string range_text(const OptionSpec& option) {
    if (std::holds_alternative<std::string>(option.default_value)) {
        return fmt::format("{}{}", fmt::join(option.choices, " | "),
                           option.check_contents == nullptr ? "" : " | a file");
    }
    if (std::holds_alternative<bool>(option.default_value)) return "true | false";
    return fmt::format("{} to {}", option.low, option.high);
}

void list_strategies() {
    for (const StrategyEntry& entry : all_strategies()) {
        const Description& strategy = entry.description;
        print_aligned({{strategy.name, strategy.summary}}, "  ");
        fmt::print("    from: {}\n", strategy.reference);
        std::vector<Row> rows;
        for (const OptionSpec& option : strategy.options) {
            rows.push_back(
                {option.name, value_text(option.default_value), range_text(option), option.summary});
        }
        if (!rows.empty()) rows.insert(rows.begin(), {"option", "default", "allowed", "what it does"});
        print_aligned(rows, "    ");
    }
}

void list_organs() {
    print_named(all_organ_shapes());
    fmt::print(
        "  With @ and the length of an edge: sphere@4mm. Or a mesh file: {{ file = \"organ.off\", size = 100 "
        "}}\n");
}

void list_metrics() {
    std::vector<Row> rows{{"name", "unit", "taken", "better", "definition"}};
    for (const Metric& metric : all_metrics()) {
        std::vector<std::string> moments;
        for (const Moment moment : metric.moments) {
            if (moment == Moment::before) moments.emplace_back("before");
            if (moment == Moment::handled) moments.emplace_back("H");
            if (moment == Moment::deformed) moments.emplace_back("D");
            if (moment == Moment::end) moments.emplace_back("end");
        }
        rows.push_back({metric.name, metric.units, fmt::format("{}", fmt::join(moments, ", ")), metric.better,
                        metric.definition});
    }
    for (const Series& time : empty_series({}).times) {
        rows.push_back({time.name, time.units, "step", "low", time.long_name});
    }
    print_aligned(rows, "  ");
    fmt::print(
        "  before: as the step found the organ; H: after handling; D: after deformation; end: after the last "
        "step.\n"
        "  Pages with formulas, pictures and limits: experiments/metrics/README.md\n");
}

struct Section {
    std::string name;
    void (*print)();
};

const std::vector<Section>& sections() {
    static const std::vector<Section> all{
        {"strategies", list_strategies},
        {"organs", list_organs},
        {"tools", [] { print_named(all_tool_shapes()); }},
        {"scenes", [] { print_named(all_scenes()); }},
        {"metrics", list_metrics},
    };
    return all;
}

void list(const std::string& asked) {
    for (const Section& section : sections()) {
        if (!asked.empty() && section.name != asked) continue;
        fmt::print("{}\n", section.name);
        section.print();
    }
}

}  // namespace

void add_list(CLI::App& app, Program& program) {
    auto asked = std::make_shared<std::string>();
    std::vector<std::string> names;
    for (const Section& section : sections()) names.push_back(section.name);
    CLI::App* command = app.add_subcommand("list", "List what a sweep can name, and what is measured");
    command->footer(footer);
    command->add_option("WHAT", *asked, "one of these only")->check(CLI::IsMember(names));
    command->callback([asked, &program] {
        list(*asked);
        program.exit_code = ExitCode::done;
    });
}

}  // namespace trocar
