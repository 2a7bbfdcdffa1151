// Tries all attacks, or those named, and prints how each ended; says what did not end as the first line of its file
// demands. For ci/attacks.sh.
#include "attacks/attack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iostream>

namespace {
using namespace testat;

void print_row(Attack const& attack, Trial const& trial)
{
    fmt::print("{:<46}{:<9}{:<13}{:>7.2f}{:>9.2f}{:>9.1f}  {}\n", attack.name,
               attack.expected.at("at").get<std::string>(), trial.ended, trial.points, trial.points_without,
               trial.containment_s, trial.changes.empty() ? "no" : "YES");
    for (auto const& complaint : trial.complaints)
        fmt::print("    {}\n", complaint);
    std::fflush(stdout);
}

bool is_wanted(std::string const& name, std::vector<std::string> const& wanted)
{
    return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
}

int count_failures(std::vector<std::string> const& wanted)
{
    Json const before = grade_next_upload();
    int failed = 0;
    fmt::print("{:<46}{:<9}{:<13}{:>7}{:>9}{:>9}  host\n{:<46}{:<9}{:<13}{:>7}{:>9}{:>9}  changed\n", "", "", "", "",
               "points", "seconds", "attack", "at", "ended", "points", "without", "longer");
    for (auto const& attack : all_attacks()) {
        if (!is_wanted(attack.name, wanted))
            continue;
        Trial const trial = try_attack(attack);
        print_row(attack, trial);
        failed += trial.complaints.empty() ? 0 : 1;
    }
    bool const same = grade_next_upload() == before;
    fmt::print("{} not as line 1 says; the next upload is graded {}\n", failed, same ? "as before" : "OTHERWISE");
    return failed + (same ? 0 : 1);
}
}  // namespace

int main(int argc, char** argv)
{
    try {
        return count_failures({argv + 1, argv + argc}) == 0 ? 0 : 1;
    } catch (std::exception const& e) {
        std::cerr << "attack_table: " << e.what() << "\n";
        return 3;
    }
}
