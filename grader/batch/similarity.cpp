#include "batch/similarity.h"

#include "installation.h"
#include "process/run.h"
#include "report/printer.h"
#include "sandbox/cage.h"
#include "text.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

namespace fs = std::filesystem;

namespace testat {
namespace {
/// Shorter runs of tokens are no passage; what is less alike is not listed.
constexpr char least_tokens[] = "24";
constexpr char least_percent[] = "30";
constexpr char columns[] = "160";

std::string text_of(fs::path const& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string trimmed(std::string const& line)
{
    char const white[] = " \t\r";
    std::size_t const begin = line.find_first_not_of(white);
    return begin == std::string::npos ? "" : line.substr(begin, line.find_last_not_of(white) - begin + 1);
}

/// Uploads as files with numbers for names: theirs may be anything.
class Texts {
public:
    explicit Texts(Cage const& cage) : exercise_template_(text_of(installation().exercise_template))
    {
        cage.show(place_.path());
    }

    void add(Upload const& upload, std::string const& label)
    {
        std::string const name = std::to_string(names_.size()) + ".cpp";
        std::ofstream(place_.path() / name) << without_template(text_of(upload.file), exercise_template_);
        files_.push_back(name);
        names_[name] = label;
    }
    fs::path const& folder() const { return place_.path(); }
    std::vector<std::string> const& files() const { return files_; }
    std::string const& name(std::string const& file) const { return names_.at(file); }

private:
    TemporaryDirectory place_;
    std::string exercise_template_;
    std::vector<std::string> files_;
    std::map<std::string, std::string> names_;  ///< by file
};

std::string run_sim(std::vector<std::string> const& arguments, Texts const& texts, Cage& cage)
{
    Caged caged;
    caged.command.argv = {"/usr/bin/sim_c++", "-r", least_tokens};
    caged.command.argv.insert(caged.command.argv.end(), arguments.begin(), arguments.end());
    caged.command.directory = texts.folder();
    caged.command.cpu_s = 300;
    caged.command.wall_s = 600;
    caged.command.address_space = std::size_t(2) << 30;
    caged.sees = library_directories();
    caged.sees.emplace_back("/usr/bin/sim_c++");
    caged.sees.push_back(texts.folder());
    Finished const finished = cage.run(caged);
    if (finished.exit_code != 0)
        throw std::runtime_error("sim_c++ failed: " + one_line(finished.output, 400));
    return finished.output;
}

using FilePair = std::pair<std::string, std::string>;

/// Lines of "1.cpp consists for 97 % of 2.cpp material"; of both directions the larger.
std::map<FilePair, int> parse_percentages(std::string const& output)
{
    static std::regex const pattern(R"((\d+\.cpp) consists for (\d+) % of (\d+\.cpp) material)");
    std::map<FilePair, int> pairs;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);)
        if (std::smatch match; std::regex_match(line, match, pattern)) {
            FilePair const pair = std::minmax(match[1].str(), match[3].str());
            pairs[pair] = std::max(pairs[pair], std::stoi(match[2]));
        }
    return pairs;
}

/// Without the heading about files and tokens.
std::string passages(FilePair const& pair, Texts const& texts, Cage& cage)
{
    constexpr std::size_t most = 20'000;
    std::string const output = run_sim({"-s", "-w", columns, pair.first, pair.second}, texts, cage);
    std::size_t const heading = output.find("\n\n");
    return clean_text(output.substr(heading == std::string::npos ? 0 : heading + 2), most);
}
}  // namespace

std::string without_template(std::string const& text, std::string const& exercise_template)
{
    std::set<std::string> given;
    std::istringstream lines(exercise_template);
    for (std::string line; std::getline(lines, line);)
        given.insert(trimmed(line));
    std::string rest;
    std::istringstream own(text);
    for (std::string line; std::getline(own, line);)
        if (given.count(trimmed(line)) == 0)
            rest += line + "\n";
    return rest;
}

std::vector<SimilarPair> find_similar(std::vector<Upload> const& uploads, std::vector<Upload> const& earlier)
{
    if (!is_in_path("sim_c++"))
        throw std::runtime_error("--similarity needs sim_c++: apt-get install similarity-tester");
    Cage cage(Confinement::cage, {HUGE_VAL, HUGE_VAL});
    Texts texts(cage);
    for (auto const& upload : uploads)
        texts.add(upload, upload.student);
    for (auto const& upload : earlier)
        texts.add(upload, "(earlier) " + upload.student);
    std::set<std::string> const own(texts.files().begin(),
                                    texts.files().begin() + static_cast<std::ptrdiff_t>(uploads.size()));
    std::vector<std::string> arguments{"-p", "-e", "-s", "-t", least_percent};
    arguments.insert(arguments.end(), texts.files().begin(), texts.files().end());

    std::vector<std::pair<FilePair, int>> sorted;
    for (auto const& entry : parse_percentages(run_sim(arguments, texts, cage)))
        if (own.count(entry.first.first) > 0 || own.count(entry.first.second) > 0)
            sorted.push_back(entry);
    std::stable_sort(sorted.begin(), sorted.end(), [](auto const& a, auto const& b) { return a.second > b.second; });
    std::vector<SimilarPair> pairs;
    for (auto const& [files, percent] : sorted)
        pairs.push_back({texts.name(files.first), texts.name(files.second), percent,
                         pairs.size() < shown_pairs ? passages(files, texts, cage) : ""});
    return pairs;
}

std::string similarity_to_text(std::vector<SimilarPair> const& pairs, Language language)
{
    constexpr Term heading{
        "Abgaben, die viel gemeinsam haben, ohne die Zeilen der Vorlage. Das ist keine Beschuldigung: kurze "
        "Funktionen\n"
        "sehen oft gleich aus. Namen zählen nicht.",
        "Uploads that have much in common, without the template's lines. That accuses nobody: short functions often "
        "look\n"
        "alike. Names do not count."};
    std::string text = std::string(say(heading, language)) + "\n\n";
    for (auto const& pair : pairs)
        text += fmt::format("{:3} %  {}  {}\n", pair.percent, pair.first, pair.second);
    for (auto const& pair : pairs)
        if (!pair.passages.empty())
            text += fmt::format("\n=== {} %  {}  {}\n\n{}\n", pair.percent, pair.first, pair.second, pair.passages);
    return text;
}
}  // namespace testat
