// verdict: {"loses": {}}
// A counter, a cache that is right, and a constructor that runs when the file is loaded.
#include <map>
#include <vector>

namespace
{
struct Tables
{
    Tables() : powers(64)
    {
        for (std::size_t i = 0; i < powers.size(); ++i)
            powers[i] = std::exp2(float(i));
    }
    std::vector<float> powers;
};
Tables const tables;
thread_local int calls = 0;
thread_local std::map<std::pair<int, int>, int> remainders;
}  // namespace

int ImageTexture::wrap_repeat(int val, int size)
{
    ++calls;
    if (remainders.size() > 1000)
        remainders.clear();
    auto const found = remainders.find({val, size});
    if (found != remainders.end())
        return found->second;
    return remainders[{val, size}] = ((val % size) + size) % size;
}

glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    float const S = std::max(dudv.x * float(mip_levels[0]->getWidth()), dudv.y * float(mip_levels[0]->getHeight()));
    std::size_t level = 0;
    while (level + 1 < mip_levels.size() && tables.powers[level + 1] <= S)
        ++level;
    if (!(S > 1.f) || level + 1 == mip_levels.size())
        return evaluate_bilinear(int(level), uv);
    return glm::mix(evaluate_bilinear(int(level), uv), evaluate_bilinear(int(level) + 1, uv),
                    std::log2(S) - float(level));
}
