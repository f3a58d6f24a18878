#pragma once

namespace trocar::testing_support {

/// Whether this build is under AddressSanitizer. It has memory of its own, so that none can be limited, and
/// turns some signals into an exit.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool address_sanitizer = true;
#else
inline constexpr bool address_sanitizer = false;
#endif

}  // namespace trocar::testing_support
