#include "reference_answers.h"

#include "installation.h"
#include "probe/answer.h"

namespace testat {
Group questions_of(UnitCheck const& check, std::uint64_t seed, Textures const& textures)
{
    Random random(seed, check.name);
    Group group = check.ask(random, textures);
    group.name = check.name;
    group.under_test = check.function;
    return group;
}

Answers constant_answers(Group const& group, std::uint32_t word)
{
    Answers answers{group, {}, std::vector<std::uint32_t>(group.answer_size(), word)};
    answers.status.ended = Ended::answered;
    answers.status.answered = group.count;
    return answers;
}

Answers reference_answers(Group const& group, Textures const& textures)
{
    Answers answers = constant_answers(group, unanswered);
    AssetLibrary assets(installation().assets.string());
    answer(group, textures, assets, answers.words.data(), &answers.status.answered);
    return answers;
}
}  // namespace testat
