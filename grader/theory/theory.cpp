#include "theory/theory.h"

#include "text.h"
#include "theory/barycentric.h"
#include "theory/matrices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>

namespace testat::theory {
namespace {
char const* word(Verdict verdict)
{
    constexpr char const* words[] = {"right", "wrong", "unreadable", "unanswered"};
    return words[int(verdict)];
}

std::string read_bytes(std::filesystem::path const& file)
{
    if (!std::filesystem::is_regular_file(file))
        throw std::invalid_argument(file.string() +
                                    ": there is no such file; testat theory --template en --out FILE "
                                    "writes one to fill in");
    if (std::filesystem::file_size(file) > largest_answers)
        throw std::invalid_argument(file.string() + ": too large for a file of answers (over 1 MB)");
    std::ifstream in(file, std::ios::binary);
    if (!in)
        throw std::invalid_argument(file.string() + ": cannot be read");
    return {std::istreambuf_iterator<char>(in), {}};
}

void append(Report& document, char const* question, Judgement const& judgement)
{
    Report findings = Report::array();
    for (auto const& finding : judgement.findings)
        findings.push_back({{"id", finding.id}, {"de", finding.text.de}, {"en", finding.text.en}});
    document["answers"].push_back({{"question", question},
                                   {"id", judgement.id},
                                   {"verdict", word(judgement.verdict)},
                                   {"answer", clean_text(judgement.answer, 2000)},
                                   {"findings", findings}});
}

/// Misspelt names would look like answers that are missing.
void note_unknown(Report const& object, std::string const& path, std::set<std::string> const& known, Report& notes)
{
    constexpr std::size_t most_notes = 10;
    for (auto const& [key, value] : object.items())
        if (known.count(key) == 0 && key != "explanation" && notes.size() < most_notes)
            notes.push_back(path + one_line(key, 40));
}

Report unknown_names(Report const& answers)
{
    Report notes = Report::array();
    note_unknown(answers, "", {"transformation", "barycentric"}, notes);
    auto const section = [&](Report const& parent, char const* name, std::string const& path,
                             std::set<std::string> const& known) {
        if (parent.is_object() && parent.contains(name) && parent.at(name).is_object())
            note_unknown(parent.at(name), path + name + ".", known, notes);
    };
    section(answers, "transformation", "", {"M", "factors"});
    section(answers, "barycentric", "", {"areas", "lambda", "P'"});
    if (answers.contains("barycentric")) {
        Report const& barycentric = answers.at("barycentric");
        section(barycentric, "areas", "barycentric.", {"F1", "F2", "F3"});
        section(barycentric, "lambda", "barycentric.", {"A", "B", "C"});
        section(barycentric, "P'", "barycentric.", {"u", "v"});
    }
    return notes;
}

/// The sheet lets the product stand: M or its factors may be left out if the other one is there.
bool is_optional(std::vector<Judgement> const& transformation, std::size_t i)
{
    return i == 0 && transformation[0].verdict == Verdict::unanswered &&
           transformation[1].verdict != Verdict::unanswered;
}
}  // namespace

Report parse_answers(std::string const& bytes, std::string const& name)
{
    auto const refuse_depth = [&](int depth, Report::parse_event_t, Report const&) {
        if (depth > deepest_answers)
            throw std::invalid_argument(name + fmt::format(": lists within lists, more than {} deep", deepest_answers));
        return true;
    };
    try {
        Report answers = Report::parse(bytes, refuse_depth);
        if (!answers.is_object())
            throw std::invalid_argument(name + ": no file of answers: it must be an object, {\"transformation\": ...}");
        return answers;
    } catch (Report::exception const& e) {
        throw std::invalid_argument(name + ": this is not JSON: " + e.what());
    }
}

Report read_answers(std::filesystem::path const& file)
{
    return parse_answers(read_bytes(file), file.string());
}

Report judge(Report const& answers)
{
    Report document{{"answers", Report::array()}, {"right", 0}, {"asked", 0}, {"not_read", unknown_names(answers)}};
    auto const transformation = judge_transformation(answers.value("transformation", Report()));
    for (std::size_t i = 0; i < transformation.size(); ++i)
        if (!is_optional(transformation, i))
            append(document, "transformation", transformation[i]);
    for (auto const& judgement : judge_barycentric(answers.value("barycentric", Report())))
        append(document, "barycentric", judgement);
    auto const& all = document["answers"];
    document["right"] =
        std::count_if(all.begin(), all.end(), [](Report const& a) { return a.at("verdict") == "right"; });
    document["asked"] = all.size();
    return document;
}

std::string answers_template(Language language, Installation const& where)
{
    auto const file =
        where.rubric.parent_path() / "theory" / (language == Language::de ? "antworten.json" : "answers.json");
    std::ifstream in(file, std::ios::binary);
    if (!in)
        throw std::runtime_error(file.string() + ": cannot be read: " + std::strerror(errno));
    return {std::istreambuf_iterator<char>(in), {}};
}
}  // namespace testat::theory
