#pragma once

#include <cstdio>
#include <string>

#include <fmt/format.h>

namespace trocar {

/// Writes a message for people to stderr. Where that is not possible (closed, or a log on a full disk)
/// nothing happens: no result hangs on it.
template <typename... Args>
void say(fmt::format_string<Args...> format, Args&&... args) {
    const std::string text = fmt::format(format, std::forward<Args>(args)...);
    static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

}  // namespace trocar
