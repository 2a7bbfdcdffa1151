#include "desk/people.h"

#include <fmt/format.h>

#include <iterator>

namespace testat {
namespace {
constexpr std::size_t first_usr_id = 20'001;

struct Name {
    char const* written;
    char const* in_folder;
};

constexpr Name lastnames[] = {{"Müller", "Mueller"},
                              {"Weiß", "Weiss"},
                              {"Schmidt", "Schmidt"},
                              {"von der Höhe", "von_der_Hoehe"},
                              {"O'Brien", "O_Brien"},
                              {"D’Angelo", "D_Angelo"},
                              {"García Núñez", "Garcia_Nunez"},
                              {"Łukasiewicz", "_ukasiewicz"},
                              {"Öztürk", "Oeztuerk"},
                              {"Çelik", "_elik"},
                              {"Schulze-Delitzsch", "Schulze-Delitzsch"},
                              {"Nguyễn", "Nguy_n"},
                              {"王", "_"},
                              {"欧阳", "__"},
                              {"العلي", "_____"},
                              {"Ng", "Ng"}};

constexpr Name firstnames[] = {{"Jörg", "Joerg"}, {"Änne", "Aenne"}, {"Anna", "Anna"},   {"Karl Heinz", "Karl_Heinz"},
                               {"Zoë", "Zo_"},    {"Siân", "Si_n"},  {"Ðoàn", "_oan"},   {"小明", "__"},
                               {"雅", "_"},       {"محمد", "____"},  {"فاطمة", "_____"}, {"N'Golo", "N_Golo"},
                               {"Bert", "Bert"}};

template <std::size_t n>
Name const& draw(std::mt19937_64& random, Name const (&names)[n])
{
    return names[random() % n];
}
}  // namespace

Person make_person(std::mt19937_64& random, std::size_t number)
{
    Name const& last = draw(random, lastnames);
    Name const& first = draw(random, firstnames);
    Person person{last.written, first.written, fmt::format("u{}{:04}", char('a' + random() % 26), number), ""};
    if (random() % 8 == 0)
        person.login += "_x";  // an underscore more, where underscores separate
    person.folder = fmt::format("{}_{}_{}_{}", last.in_folder, first.in_folder, person.login, first_usr_id + number);
    return person;
}
}  // namespace testat
