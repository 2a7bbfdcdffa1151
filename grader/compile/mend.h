#pragma once
#include "model.h"
#include "process/run.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace testat {
/// A text that compiles because what does not is left out. Lines keep their numbers.
struct Mended {
    std::string text;
    std::map<Function, Diagnostic> broken;  ///< the first error of each function left out
    std::vector<Diagnostic> left_out;       ///< the first error of each other declaration or #include left out
};

/// Compiles and links a text; `timed_out` if there is no time left for it.
using CompileText = std::function<Finished(std::string const& text)>;

/// What stays the same while a text is mended.
struct MendedFile {
    std::string source;  ///< the file name that the compiler is given
    std::string shown;   ///< the one to report
    std::string header;  ///< stands in for an #include left out, whose name may be misspelt; may be empty
};

/// Leaves out the function that the first error belongs to, or else the #include or the declaration at namespace scope,
/// and compiles again, until there is no error: at most once for each of the eleven, eight times for the others, and
/// once more if there are #line directives, which are blanked. What uses something left out is to blame next. `failed`
/// is how compiling `text` ended. Nothing if an error belongs to none of these, or if the compiler crashes or runs out
/// of time.
std::optional<Mended> mend(std::string const& text, Finished const& failed, MendedFile const& file,
                           CompileText const& compile);

/// The text with its #line directives blanked: they would have errors blamed on the wrong lines.
std::string without_line_directives(std::string text);
}  // namespace testat
