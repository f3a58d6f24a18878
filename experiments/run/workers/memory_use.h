#pragma once

#include <cstdint>
#include <optional>

#include <sys/types.h>

namespace trocar {

/// The memory that a process has written to and holds, bytes (RssAnon and VmSwap of /proc/PID/status). None
/// when the process is gone, or the system does not say.
std::optional<std::uint64_t> memory_use(pid_t process);

/// The memory that the system can give out without swapping, bytes (MemAvailable of /proc/meminfo); 0 where
/// it does not say.
std::uint64_t available_memory();

}  // namespace trocar
