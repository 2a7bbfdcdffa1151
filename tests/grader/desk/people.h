#pragma once
#include <random>
#include <string>

/// Invented students with names as there are in courses, and the names of their folders as ILIAS makes them.
namespace testat {
struct Person {
    std::string lastname, firstname, login;
    std::string
        folder;  ///< <Lastname>_<Firstname>_<login>_<usr_id>; letters outside ASCII transliterated, or underscores
};

/// All persons of one course have another number, from which login and usr_id are made.
Person make_person(std::mt19937_64& random, std::size_t number);
}  // namespace testat
