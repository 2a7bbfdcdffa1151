// Pages for the tests of this folder, from made-up reports: make_pages FOLDER writes them and says on stdout how long
// that takes, in milliseconds of processor time.
#include "batch/overview.h"
#include "example_grading.h"
#include "report/formats/format.h"
#include "report/pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <iostream>

namespace fs = std::filesystem;

namespace testat {
namespace {
constexpr int side = 256;
constexpr std::size_t students = 1000;

std::uint32_t scramble(std::uint32_t x)
{
    x = (x ^ (x >> 16)) * 0x7feb352d;
    x = (x ^ (x >> 15)) * 0x846ca68b;
    return x ^ (x >> 16);
}

/// A board with grain, so that its file is as long as those of real pictures.
Picture board(std::uint32_t number, bool shifted)
{
    Picture picture{side, side, {}};
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            int const u = shifted && y > side / 2 ? x + 9 : x;
            float const field = ((u / 24 + y / 24 + int(number)) % 2) != 0 ? 0.7f : 0.25f;
            float const grain = float(scramble(std::uint32_t(u * side + y)) % 64) / 640;
            for (float tint : {1.f, 0.8f, 0.5f})
                picture.rgb.push_back(tint * field + grain);
        }
    return picture;
}

Rendering rendering_of(Picture const& picture, std::size_t outside)
{
    Rendering rendering;
    rendering.ended = Ended::answered;
    rendering.picture = picture;
    rendering.comparison = {outside, 6, outside == 0 ? 1.0 : 0.1, 0.2, 0.4};
    return rendering;
}

void fail(CheckResults& results, std::string const& check, Mismatch const& mismatch)
{
    CheckResult& result = find_result(results, check);
    result.passed = false;
    result.mismatch = mismatch;
    result.detail = mismatch.expected;
}

bool shows_a_mistake(PictureResult const& picture)
{
    return std::any_of(picture.isolated.begin(), picture.isolated.end(), [](IsolatedPicture const& isolated) {
        return isolated.function == Function::wrap_repeat || isolated.function == Function::evaluate_bilinear;
    });
}

/// As many wrong pictures as asked for, and the others right.
void make_pictures(CheckResults& results, std::size_t wrong)
{
    std::stable_partition(results.pictures.begin(), results.pictures.end(), shows_a_mistake);
    for (std::size_t i = 0; i < results.pictures.size(); ++i) {
        PictureResult& picture = results.pictures[i];
        picture.expected = board(std::uint32_t(i), false);
        bool const is_wrong = i < wrong;
        picture.submitted =
            rendering_of(is_wrong ? board(std::uint32_t(i), true) : picture.expected, is_wrong ? 30'000 : 0);
        for (auto& isolated : picture.isolated) {
            isolated.rendering = picture.submitted;
            isolated.score = picture.submitted->comparison.score;
        }
        if (is_wrong)
            picture.explained_by = {"wrap_repeat", "evaluate_bilinear"};
        picture.ms = 20;
        picture.reference_ms = 15;
    }
}

void make_three_mistakes(CheckResults& results)
{
    fail(results, "WrapRepeat.NegativeIndices", {"val = -23, size = 6", "5", "1"});
    fail(results, "EvaluateBilinear.TexelCentres",
         {"W x H = 32 x 32, level = 0, uv = (0.046875, 0.109375)", "(0.4783325, 0.3591919, 0.3112183, 1)",
          "(0.2080078, 0.8183594, 0.4118652, 1) (|error| / bound = 1.15e+05)"});
    fail(results, "TransformPosition.RigidMotions",
         {"transform = [1 0 0 3; 0 1 0 0; 0 0 1 0; 0 0 0 1], p = (8, -8, 8)", "(0.77, -0.45, 0.45)", "(11, -8, 8)"});
    results.mistakes[Function::wrap_repeat] = "repeat_abs";
    results.mistakes[Function::evaluate_bilinear] = "bilinear_without_shift";
}

Build example_build()
{
    Build build = whole_build();
    build.compiler = "g++ (Debian 12.2.0-14+deb12u1) 12.2.0";
    for (std::uint32_t i = 0; i < function_count; ++i)
        build.sources[Function(i)] = {int(20 + 8 * i),
                                      "int ImageTexture::f(int val, int size)\n{\n\treturn abs(val % size);\n}"};
    build.diagnostics = {{"exercise_03.cpp", 70, 9, "warning", "unused variable 'half'"}};
    return build;
}

Build broken_build()
{
    Build build = example_build();
    build.ok = false;
    build.mended = true;
    Diagnostic const error{"exercise_03.cpp", 38, 2, "error", "expected ';' before 'return'"};
    build.broken[Function::wrap_repeat] = error;
    build.defined = FunctionSet::all().without(Function::wrap_repeat);
    build.sources[Function::wrap_repeat] = {
        36, "int ImageTexture::wrap_repeat(int val, int size)\n{\n\tint n = size\n\treturn val % n;\n}"};
    build.diagnostics = {error};
    return build;
}

class Maker {
public:
    explicit Maker(fs::path const& folder)
        : folder_(folder), rubric_(read_rubric(fs::path(TESTAT_REPOSITORY) / "references" / "rubric.json"))
    {
    }

    Report report(Build const& build, CheckResults const& results) const
    {
        Submission submission;
        submission.file = "exercise_03.cpp";
        submission.sha256 = std::string(64, 'a');
        return make_report(submission, build, results, score(results, build, rubric_, false), rubric_,
                           {rubric_.version, std::string(64, 'b'), 1}, {}, {});
    }

    CheckResults results(bool with_mistakes, std::size_t wrong_pictures) const
    {
        CheckResults all = passed_results(rubric_);
        make_pictures(all, wrong_pictures);
        if (with_mistakes)
            make_three_mistakes(all);
        return all;
    }

    /// The page, and how long it takes to make it: the best of three.
    double write_page(std::string const& name, Report const& report, CheckResults const& results,
                      Language language) const
    {
        fs::path const place = folder_ / name;
        fs::path const envelopes = folder_ / "envelopes";
        fs::create_directories(place);
        fs::create_directories(envelopes);
        for (auto const& picture : results.pictures)
            write_file(envelopes / (picture.name + ".png"), encode_picture(picture.name, picture.expected));
        write_pictures(results, place, envelopes);
        double best = 1e9;
        for (int i = 0; i < 3; ++i) {
            std::clock_t const begin = std::clock();
            write_file(place / "report.html", to_html({{name, report, place}}, language));
            best = std::min(best, 1e3 * double(std::clock() - begin) / CLOCKS_PER_SEC);
        }
        return best;
    }

private:
    fs::path folder_;
    Rubric rubric_;
};

/// What somebody may write who wants a browser to run it, in all places at once.
std::string attack(int number)
{
    return fmt::format(
        "<script>owned({0})</script>\"><img src=x onerror=owned({0})>'><svg onload='owned({0})'></style>"
        "</script><script>owned({0})</script></pre></textarea><!-- {{{{{{script}}}}}} [[<b>|</b>]] "
        "javascript:owned({0}) &lt;b&gt;",
        number);
}

bool is_ours(std::string const& key)
{
    for (char const* word : {"status", "verdict", "visibility", "task"})
        if (key == word)
            return true;
    return key.find("_file") != std::string::npos;
}

void poison(Report& value, std::string const& key, int& number)
{
    if (value.is_string() && !is_ours(key))
        value = attack(number++);
    else if (value.is_structured())
        for (auto& [inner, part] : value.items())
            poison(part, value.is_object() ? inner : key, number);
}

GradedUpload upload(std::string const& student, Report const& report)
{
    GradedUpload entry;
    entry.upload.student = student;
    entry.report = report;
    return entry;
}

/// Some are late, cannot be graded, are overridden, have the same mistake.
std::vector<GradedUpload> course(Report const& wrong, Report const& right, Report const& broken)
{
    char const* const names[] = {"Öztürk", "Müller", "Nguyen", "García", "Li", "Weiß", "Schmidt", "Kowalski"};
    char const* const first_names[] = {"Anna", "Bert", "Chloé", "Dan", "Eva", "Franz", "Gül"};
    std::vector<GradedUpload> entries;
    for (std::size_t i = 0; i < students; ++i) {
        std::uint32_t const dice = scramble(std::uint32_t(i));
        std::uint32_t next = dice;
        GradedUpload entry = upload(fmt::format("student_{:04}", i), dice % 5 == 0    ? right
                                                                     : dice % 17 == 0 ? broken
                                                                                      : wrong);
        entry.upload.lastname = fmt::format("{} {}", names[dice / 7 % std::size(names)], i);
        entry.upload.firstname = first_names[dice / 64 % std::size(first_names)];
        entry.upload.login = fmt::format("up{:04}", i);
        entry.upload.late = dice % 13 == 0;
        if (dice % 5 != 0 && dice % 17 != 0) {
            double sum = 0;
            for (auto& task : entry.report["tasks"]) {
                double const steps = 4 * task["max"].get<double>();
                double const points =
                    std::min(steps, double(scramble(next++) % (std::uint32_t(steps) * 3 / 2 + 1))) / 4;
                task["earned"] = points;
                sum += points;
            }
            entry.report["points"]["earned"] = sum;
            entry.report["points"]["passed_60_percent"] = sum >= 12;
            if (dice % 3 == 0)
                entry.report["functions"]["wrap_repeat"].erase("mistake");
        }
        if (dice % 101 == 0)
            entry.report["points"]["override"] = {
                {"points_before", 3.0}, {"reason", "talked"}, {"who", "T"}, {"when", ""}};
        if (dice % 211 == 0)
            entry.report = make_not_gradable({}, {"1", "", 1}, "no space on the disk");
        entries.push_back(entry);
    }
    return entries;
}

std::vector<GradedUpload> hostile_course(Report const& poisoned, int& number)
{
    GradedUpload entry = upload(attack(number), poisoned);
    for (std::string* text : {&entry.upload.lastname, &entry.upload.firstname, &entry.upload.login, &entry.upload.team})
        *text = attack(number++);
    return {entry, upload(attack(number), make_not_gradable({}, {"1", "", 1}, attack(number + 1)))};
}

void make_pages(fs::path const& folder)
{
    Maker const maker(folder);
    CheckResults const three = maker.results(true, 3);
    Report const wrong = maker.report(example_build(), three);
    double const ms = maker.write_page("wrong", wrong, three, Language::de);
    CheckResults const none = maker.results(false, 0);
    Report const right = maker.report(example_build(), none);
    maker.write_page("right", right, none, Language::en);
    CheckResults const all = maker.results(true, 20);
    maker.write_page("all_wrong", maker.report(example_build(), all), all, Language::en);
    Report const broken = maker.report(broken_build(), none);
    maker.write_page("broken", broken, none, Language::en);
    int number = 0;
    Report poisoned = maker.report(broken_build(), three);
    poisoned["remarks"] = {{{"id", "leaks"}, {"functions", {"wrap_repeat"}}, {"de", "de"}, {"en", "en"}}};
    poisoned["points"]["override"] = {{"points_before", 3.0}, {"reason", "talked"}, {"who", "T"}, {"when", ""}};
    Report const tasks = poisoned.at("tasks");
    poison(poisoned, "", number);
    for (std::size_t i = 0; i < tasks.size(); ++i)
        poisoned["tasks"][i]["id"] = tasks[i].at("id");  // ours, and part of names in the page
    maker.write_page("hostile", poisoned, three, Language::en);
    write_file(folder / "hostile.html",
               overview_page(hostile_course(poisoned, number), {}, attack(number), Language::en));
    std::vector<SimilarPair> const similar{{"student_0003", "student_0007", 93, ""}};
    write_file(folder / "overview.html", overview_page(course(wrong, right, broken), similar, "Übung 3", Language::de));
    std::cout << fmt::format("{{\"report_ms\": {:.1f}}}\n", ms);
}
}  // namespace
}  // namespace testat

int main(int argc, char** argv)
{
    try {
        testat::make_pages(argc > 1 ? argv[1] : "pages");
        return 0;
    } catch (std::exception const& e) {
        std::cerr << "make_pages: " << e.what() << "\n";
        return 1;
    }
}
