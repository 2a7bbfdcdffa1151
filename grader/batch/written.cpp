#include "batch/written.h"

#include "text.h"

namespace testat {
Written::Written(std::filesystem::path file) : file_(std::move(file)), before_(read_if_there(file_)) {}

void Written::update(std::string const& output, bool is_there, std::string const& made_from,
                     std::function<void()> const& write)
{
    std::string const hash = sha256(made_from);
    bool const is_new = !is_there || before_.value(output, Report()) != hash;
    if (is_new) {
        forget();
        write();
    }
    std::lock_guard const lock(mutex_);
    now_[output] = hash;
}

void Written::forget()
{
    std::lock_guard const lock(mutex_);
    std::filesystem::remove(file_);
}

void Written::remember() const
{
    write_atomically(file_, to_text(Report(now_)));
}
}  // namespace testat
