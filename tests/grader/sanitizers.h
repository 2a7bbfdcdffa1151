#pragma once

namespace testat {
/// Whether a sanitizer brings a heap, a stack layout and signals of its own.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool is_sanitized = true;
#else
constexpr bool is_sanitized = false;
#endif
}  // namespace testat
