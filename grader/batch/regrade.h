#pragma once
#include "batch/batch.h"

namespace testat {
/// What the outputs of a batch were made of, so that the next one can say whose points change for another reason than a
/// new upload. Kept beside the results.
class Applied {
public:
    /// Of the outputs as they are; nothing if there are none.
    explicit Applied(std::filesystem::path file);

    /// Lines of "student: 12.00 -> 11.50" with what is different beneath, for students whose file is the same as then.
    /// Empty if nobody's points change.
    std::string changes(std::vector<GradedUpload> const& entries, std::filesystem::path const& results,
                        Language language) const;

    /// Remembers the outputs that have been written.
    void remember(std::vector<GradedUpload> const& entries) const;

private:
    std::filesystem::path file_;
    Report before_;
};
}  // namespace testat
