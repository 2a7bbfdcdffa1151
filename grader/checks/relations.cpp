#include "checks/relations.h"

#include <fmt/format.h>

#include <numeric>
#include <set>

namespace testat {
Random unknown_stream(Textures const& textures, std::string_view name)
{
    auto const& texels = at(textures, TestTexture::unknown).levels.at(0).texels;
    std::string key(reinterpret_cast<char const*>(texels.data()), texels.size() * sizeof(float));
    return {0, key.append(name)};
}

std::vector<std::uint32_t> unknown_order(Textures const& textures, std::size_t count)
{
    Random random = unknown_stream(textures, "order");
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    for (std::size_t i = count; i > 1; --i)  // Fisher and Yates
        std::swap(order[i - 1], order[std::size_t(random.integer(0, int(i) - 1))]);
    return order;
}

Deviation variety(Answers const& answers, std::vector<std::uint32_t> const& places)
{
    std::size_t const words = answers.group.words_per_answer;
    std::set<std::vector<std::uint32_t>> different;
    for (std::uint32_t place : places) {
        auto const* begin = &answers.words[place * words];
        different.insert({begin, begin + words});
    }
    return {2 * different.size() > places.size() ? 0 : HUGE_VAL,
            fmt::format("{} different answers to {} questions", different.size(), places.size()),
            fmt::format("more than {} different answers", places.size() / 2)};
}

std::function<Group(Random&, Textures const&)> twice(std::string const& name,
                                                     std::function<Group(Random&, Textures const&)> const& ask)
{
    return [=](Random& known, Textures const& textures) {
        Group group = ask(known, textures);
        Random unknown = unknown_stream(textures, name);
        Group const more = ask(unknown, textures);
        group.count += more.count;
        group.questions.insert(group.questions.end(), more.questions.begin(), more.questions.end());
        return group;
    };
}

Deviation worst_of(std::initializer_list<Deviation> deviations)
{
    Deviation worst;
    for (auto const& d : deviations)
        if (!(d.in_bounds <= worst.in_bounds))
            worst = d;
    return worst;
}
}  // namespace testat
