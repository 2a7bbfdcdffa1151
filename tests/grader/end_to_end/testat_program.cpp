#include "end_to_end/testat_program.h"

#include "source/definitions.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace testat {
namespace {
std::vector<char*> pointers(std::vector<std::string> const& strings)
{
    std::vector<char*> result;
    for (auto const& s : strings)
        result.push_back(const_cast<char*>(s.c_str()));
    result.push_back(nullptr);
    return result;
}

/// The caller's environment with `variables` in place of its own of the same name.
std::vector<std::string> environment_with(std::vector<std::string> const& variables)
{
    std::vector<std::string> result = variables;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        std::string const name = std::string(*variable).substr(0, std::string(*variable).find('=') + 1);
        bool replaced = false;
        for (auto const& v : variables)
            replaced = replaced || v.rfind(name, 0) == 0;
        if (!replaced)
            result.emplace_back(*variable);
    }
    return result;
}

std::vector<std::string> with_front(std::vector<std::string> front, std::vector<std::string> const& rest)
{
    front.insert(front.end(), rest.begin(), rest.end());
    return front;
}

std::filesystem::path const repository = TESTAT_REPOSITORY;
}  // namespace

Running::Running(std::vector<std::string> const& arguments, std::vector<std::string> const& variables,
                 std::filesystem::path const& out, std::filesystem::path const& err)
{
    auto const all = with_front({TESTAT_PROGRAM}, arguments);
    auto const environment = environment_with(variables);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    int const error =
        posix_spawn(&pid_, TESTAT_PROGRAM, &actions, nullptr, pointers(all).data(), pointers(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
        throw std::runtime_error(std::string("cannot start ") + TESTAT_PROGRAM);
}

void Running::send(int signal) const
{
    kill(pid_, signal);
}

int Running::wait() const
{
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

Outcome run_testat(std::vector<std::string> const& arguments, std::vector<std::string> const& variables)
{
    TemporaryDirectory const place;
    Running const program(arguments, variables, place.path() / "out", place.path() / "err");
    int const code = program.wait();
    return {code, read_file(place.path() / "out"), read_file(place.path() / "err")};
}

Graded grade_file(std::filesystem::path const& upload, std::filesystem::path const& out,
                  std::vector<std::string> const& arguments)
{
    auto const all = with_front({"grade", upload.string(), "--out", out.string()}, arguments);
    Graded graded{run_testat(all, {"LC_ALL=C.UTF-8"}), nullptr};
    if (std::filesystem::exists(out / "report.json"))
        graded.report = Json::parse(read_file(out / "report.json"));
    return graded;
}

Graded grade_text(std::string const& text, std::vector<std::string> const& arguments)
{
    TemporaryDirectory const place;
    write_file(place.path() / "exercise_03.cpp", text);
    return grade_file(place.path() / "exercise_03.cpp", place.path() / "out", arguments);
}

std::string read_file(std::filesystem::path const& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in)
        throw std::runtime_error("cannot read " + file.string());
    return {std::istreambuf_iterator<char>(in), {}};
}

void write_file(std::filesystem::path const& file, std::string const& bytes)
{
    std::ofstream out(file, std::ios::binary);
    out << bytes;
    if (!out.flush())
        throw std::runtime_error("cannot write " + file.string());
}

std::filesystem::path reference_file()
{
    return repository / "references/exercise_03.cpp";
}

std::string reference_text()
{
    return read_file(reference_file());
}

std::filesystem::path template_file()
{
    return repository / "submission_template/exercise_03.cpp";
}

std::filesystem::path example_file()
{
    return repository / "tests/submissions/example.cpp";
}

std::string patched_reference(std::string const& patch)
{
    return patch_definitions(reference_text(), patch);
}

std::string endless_text()
{
    return patched_reference(
        "int ImageTexture::wrap_clamp(int val, int size)\n"
        "{\n"
        "    for (volatile int i = val;; i = i + size) {\n"
        "    }\n"
        "}\n");
}

std::string function_table_of(Json const& report)
{
    if (!report.contains("functions"))
        return report.dump(2);
    std::string table;
    for (auto const& [name, function] : report.at("functions").items()) {
        table += fmt::format("  {:<36}{:>5.2f} / {:>5.2f}  {:<10} unit {:.3f}, picture {:.4f}", name,
                             function.at("earned").get<double>(), function.at("max").get<double>(),
                             function.at("verdict").get<std::string>(), function.at("unit").get<double>(),
                             function.at("picture").get<double>());
        for (auto const& check : function.at("checks"))
            if (!check.at("passed").get<bool>())
                table += " !" + check.at("name").get<std::string>();
        table += "\n";
    }
    return table + "  policy " + report.at("policy").dump() + ", build " +
           report.at("build").dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<std::string> compilers()
{
    return {"g++", "clang++"};
}
}  // namespace testat
