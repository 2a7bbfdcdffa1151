#pragma once
#include "model.h"

#include <optional>

namespace testat {
/// What went wrong in a group besides its values, in words for students: crash, time-out, exception, exit, a library
/// that does not load; or, where all went well, that the function prints. Nothing if there is nothing to say.
std::optional<Phrase> describe_trouble(GroupStatus const& status);

/// How a group ended instead of answering, in a word that is the same in every language: "SIGSEGV", "exit(0)",
/// "timeout", "exception: ...".
std::string name_end(GroupStatus const& status);
}  // namespace testat
