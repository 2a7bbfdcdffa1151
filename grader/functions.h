#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace testat {
/// The functions a student writes, numbered in the order of the sheet.
enum class Function : std::uint32_t {
#define FUNCTION(index, name, symbol, task) name = (index),  // NOLINT(bugprone-macro-parentheses): a name
#include "functions.def"
#undef FUNCTION
};

struct FunctionInfo {
    std::string_view name;    ///< bare name: key of the rubric and of reports
    std::string_view symbol;  ///< mangled name in an upload (Itanium C++ ABI)
    char task;                ///< 'a' to 'f'
};

constexpr FunctionInfo function_table[] = {
#define FUNCTION(index, name, symbol, task) {#name, #symbol, #task[0]},
#include "functions.def"
#undef FUNCTION
};
constexpr std::uint32_t function_count = std::size(function_table);

constexpr FunctionInfo const& info(Function function)
{
    return function_table[static_cast<std::uint32_t>(function)];
}

/// The function of that bare name, if it is one of the eleven.
constexpr std::optional<Function> find_function(std::string_view name)
{
    for (std::uint32_t i = 0; i < function_count; ++i)
        if (function_table[i].name == name)
            return static_cast<Function>(i);
    return std::nullopt;
}

/// A set of the eleven, one bit each.
class FunctionSet {
public:
    constexpr FunctionSet() = default;
    constexpr explicit FunctionSet(std::uint32_t bits) : bits_(bits) {}
    static constexpr FunctionSet all() { return FunctionSet((1u << function_count) - 1); }
    static constexpr FunctionSet only(Function f) { return FunctionSet(1u << static_cast<std::uint32_t>(f)); }

    constexpr bool has(Function f) const { return (bits_ & only(f).bits_) != 0; }
    constexpr FunctionSet with(Function f) const { return FunctionSet(bits_ | only(f).bits_); }
    constexpr FunctionSet without(Function f) const { return FunctionSet(bits_ & ~only(f).bits_); }
    constexpr bool is_subset_of(FunctionSet other) const { return (bits_ & ~other.bits_) == 0; }
    constexpr bool meets(FunctionSet other) const { return (bits_ & other.bits_) != 0; }
    constexpr FunctionSet operator&(FunctionSet other) const { return FunctionSet(bits_ & other.bits_); }
    constexpr FunctionSet operator|(FunctionSet other) const { return FunctionSet(bits_ | other.bits_); }
    constexpr std::uint32_t bits() const { return bits_; }
    constexpr bool operator==(FunctionSet other) const { return bits_ == other.bits_; }
    constexpr bool operator!=(FunctionSet other) const { return bits_ != other.bits_; }

private:
    std::uint32_t bits_ = 0;
};

/// All eleven, for range-for.
constexpr auto every_function()
{
    std::array<Function, function_count> all{};
    for (std::uint32_t i = 0; i < function_count; ++i)
        all[i] = static_cast<Function>(i);
    return all;
}
}  // namespace testat
