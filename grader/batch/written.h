#pragma once
#include "report/report.h"

#include <functional>
#include <map>
#include <mutex>

namespace testat {
/// What a batch has written already, so that the next one writes only what has changed. Kept as a JSON object: the
/// SHA-256 of all that an output is made from, by the output's name.
class Written {
public:
    explicit Written(std::filesystem::path file);

    /// Calls `write` unless the output is all there and was made from the same before. Several threads may call it for
    /// different outputs.
    void update(std::string const& output, bool is_there, std::string const& made_from,
                std::function<void()> const& write);

    /// What was not updated is forgotten. Throws std::runtime_error.
    void remember() const;

private:
    /// Who is killed while writing has written nothing.
    void forget();

    std::filesystem::path file_;
    Report before_;
    std::mutex mutex_;
    std::map<std::string, std::string> now_;
};
}  // namespace testat
