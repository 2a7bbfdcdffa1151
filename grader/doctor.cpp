#include "doctor.h"

#include "process/run.h"
#include "rubric/rubric.h"
#include "sandbox/cage.h"

#include <fmt/format.h>

#include <functional>
#include <ostream>

namespace testat {
namespace {
struct Finding {
    std::string what;
    std::string problem;  ///< empty if all is well
    std::string remedy;
    bool required = true;
};

std::string problem_of(std::function<void()> const& attempt)
{
    try {
        attempt();
        return "";
    } catch (std::exception const& e) {
        return e.what();
    }
}

Finding find_program(std::string const& program, std::string const& package, bool required)
{
    return {"program " + program, is_in_path(program) ? "" : "not installed", "apt-get install " + package, required};
}

std::string full_disk()
{
    auto const directory = std::filesystem::temp_directory_path();
    constexpr std::uintmax_t enough = 200 << 20;
    auto const free = std::filesystem::space(directory).available;
    return free >= enough ? "" : fmt::format("only {} MB free in {}", free >> 20, directory.string());
}

std::vector<Finding> findings(Installation const& where)
{
    std::string const missing = missing_parts(where);
    CageTrouble const cage = find_cage_trouble();
    return {
        find_program("g++", "g++", true),
        find_program("mold", "mold", true),
        find_program("nm", "binutils", true),
        find_program("clang++", "clang", false),
        {"built parts", missing.empty() ? "" : "missing: " + missing, "remove build/release and run ./testat again"},
        {"rubric", problem_of([&] { read_rubric(where.rubric); }), "mend " + where.rubric.string()},
        {"cage for uploads", cage.problem, cage.remedy},
        {"temporary space", full_disk(), "make room"},
    };
}
}  // namespace

bool doctor(Installation const& where, std::ostream& out)
{
    bool ready = true;
    out << "testat " << where.version << "\n";
    for (auto const& f : findings(where)) {
        char const* mark = f.problem.empty() ? "ok     " : f.required ? "MISSING" : "without";
        out << fmt::format("  {}  {}", mark, f.what);
        if (!f.problem.empty())
            out << fmt::format(": {}; to mend it: {}", f.problem, f.remedy);
        out << "\n";
        ready = ready && (f.problem.empty() || !f.required);
    }
    out << (ready ? "ready\n" : "not ready\n");
    return ready;
}
}  // namespace testat
