#include "corpus/uploads.h"

#include <algorithm>
#include <cctype>

namespace testat {
std::vector<Case> cases_in(std::vector<std::string> const& folders)
{
    std::vector<Case> cases;
    for (auto const& folder : folders)
        for (auto const& entry : std::filesystem::directory_iterator(std::filesystem::path(TESTAT_CORPUS) / folder))
            for (auto const& compiler : compilers())
                cases.push_back({entry.path(), compiler});
    std::stable_sort(cases.begin(), cases.end(), [](Case const& a, Case const& b) { return a.file < b.file; });
    return cases;
}

std::string name_of(testing::TestParamInfo<Case> const& info)
{
    std::string const compiler = info.param.compiler == "g++" ? "gcc" : "clang";
    std::string name =
        info.param.file.parent_path().filename().string() + "_" + info.param.file.stem().string() + "_" + compiler;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

Json read_verdict(std::filesystem::path const& file)
{
    std::string const mark = "// verdict: ";
    std::string const text = read_file(file);
    std::string const line = text.substr(0, text.find('\n'));
    std::size_t const at = line.find(mark);
    if (at == std::string::npos)
        throw std::runtime_error(file.string() + ": line 1 holds no verdict");
    return Json::parse(line.substr(at + mark.size()));
}
}  // namespace testat
