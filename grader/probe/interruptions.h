#pragma once

namespace testat {
/// As long as it lives, the calling thread stops for a moment again and again, wherever it is, so that others overtake
/// it: races show even where there is one processor, or a busy one. One at a time for each thread; must end on the
/// thread that it began on. Throws std::system_error.
class Interruptions {
public:
    Interruptions();
    ~Interruptions();
    Interruptions(Interruptions const&) = delete;
    Interruptions& operator=(Interruptions const&) = delete;
};
}  // namespace testat
