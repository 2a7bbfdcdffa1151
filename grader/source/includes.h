#pragma once
#include <filesystem>
#include <set>
#include <string>
#include <string_view>

namespace testat {
/// The framework's headers that a text includes, directly or through one another, by their names below `include_root`.
/// Only includes that nothing can change count (see Lexed).
std::set<std::string> included_headers(std::string_view text, std::filesystem::path const& include_root);
}  // namespace testat
