#pragma once
#include <cstddef>
#include <vector>

namespace testat {
/// The static and global variables of a loaded library, as they were when this was made.
class Variables {
public:
    /// `library` is what dlopen gave.
    explicit Variables(void* library);

    /// Whether they are different now. True also of more than a megabyte, which is not looked at.
    bool have_changed() const;

private:
    struct Part {
        std::byte const* begin;
        std::vector<std::byte> before;
    };
    std::vector<Part> parts_;
    bool too_large_ = false;
};
}  // namespace testat
