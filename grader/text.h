#pragma once
#include <string>
#include <string_view>

/// The one place where text that an upload can influence becomes text that we print or store.
namespace testat {
/// At most `max_bytes` of valid UTF-8: invalid bytes become U+FFFD, control characters other than newline and tab
/// (and with them terminal escape sequences) and bidirectional overrides are dropped, and a cut is marked with "...".
std::string clean_text(std::string_view bytes, std::size_t max_bytes);

/// The same on a single line, for names and messages: newlines and tabs become spaces.
std::string one_line(std::string_view bytes, std::size_t max_bytes = 4096);

/// The same for a char array that may lack its terminator.
template <std::size_t size>
std::string clean_text(char const (&bytes)[size])
{
    return clean_text(std::string_view(bytes, size).substr(0, std::string_view(bytes, size).find('\0')), size);
}

/// SHA-256 as 64 hexadecimal digits.
std::string sha256(std::string_view bytes);
}  // namespace testat
