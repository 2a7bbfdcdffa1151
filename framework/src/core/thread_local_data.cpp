#include <cglib/core/thread_local_data.h>

float ThreadLocalData::rand()
{
    // The output function of PCG-RXS-M-XS 32 (O'Neill 2014), on a linear congruential generator.
    state_ = state_ * 747796405u + 2891336453u;
    std::uint32_t const word = ((state_ >> ((state_ >> 28) + 4)) ^ state_) * 277803737u;
    // 24 bits, as many as a float holds: the largest result is below 1.
    return float(((word >> 22) ^ word) >> 8) * (1.f / 16777216.f);
}
