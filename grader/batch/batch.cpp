#include "batch/batch.h"

#include "batch/ilias.h"
#include "batch/overrides.h"
#include "batch/overview.h"
#include "batch/regrade.h"
#include "batch/store.h"
#include "batch/times.h"
#include "batch/written.h"
#include "installation.h"
#include "json_schema.h"
#include "progress.h"
#include "report/formats/format.h"
#include "report/printer.h"
#include "rubric/rubric.h"
#include "sandbox/cage.h"
#include "text.h"

#include <fmt/format.h>
#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <set>
#include <stdexcept>

namespace fs = std::filesystem;

namespace testat {
namespace {
constexpr char store_name[] = ".testat";

/// A folder that is empty, not there yet, or a batch's.
void claim(fs::path const& out)
{
    std::error_code error;
    fs::create_directories(out, error);
    if (!fs::is_directory(out))
        throw std::invalid_argument("--out " + out.string() + ": cannot be made: " + error.message());
    if (!fs::exists(out / store_name) && !fs::is_empty(out))
        throw std::invalid_argument("--out " + out.string() +
                                    ": holds other things than a batch; choose an empty or a new folder");
}

/// Grades files and keeps what comes out. What is not gradable is tried once more.
class Grading {
public:
    Grading(BatchOptions const& options, Store const& store) : options_(options), store_(store) {}

    void grade(std::vector<Job> const& jobs)
    {
        Progress progress("Grading", jobs.size());
        run(jobs, progress);
        std::vector<Job> again;
        for (auto const& job : jobs)
            if (failures_.count(job.key) > 0 && given_up_.count(job.key) == 0)
                again.push_back(job);
        if (again.empty())
            return;
        Progress second("Once more", again.size());
        run(again, second);
    }

    /// Why there is no result.
    std::string failure(std::string const& key) const
    {
        auto const found = failures_.find(key);
        return found == failures_.end() ? "was not graded" : found->second;
    }

private:
    void run(std::vector<Job> const& jobs, Progress& progress)
    {
        Place const place{options_.executor, options_.at_once, options_.out / store_name / "slurm"};
        grade_at(place, jobs, options_.settings, [&](Job const& job, Finished const& finished) {
            settle(job, finished);
            progress.step(one_line(job.name, 40));
        });
    }

    void settle(Job const& job, Finished const& finished)
    {
        failures_.erase(job.key);
        if (finished.exit_code == 0)
            store_.keep(job.key);
        else
            failures_[job.key] = reason(job, finished);
        if (was_given_up(finished))
            given_up_.insert(job.key);
    }

    static std::string reason(Job const& job, Finished const& finished)
    {
        try {
            auto const report = read_json(job.out / "report.json");
            if (report.contains("error"))
                return report.at("error").get<std::string>();
        } catch (std::exception const&) {  // it did not come so far
        }
        return one_line(finished.output, 400);
    }

    BatchOptions const& options_;
    Store const& store_;
    std::map<std::string, std::string> failures_;
    std::set<std::string> given_up_;
};

Report not_gradable_report(Upload const& upload, BatchOptions const& options, std::string const& why)
{
    Submission submission;
    submission.file = upload.file.filename();
    return make_not_gradable(submission, {read_rubric(installation().rubric).version, "", options.settings.seed}, why);
}

/// What was found for one content may be another student's file of another name.
Report as_from(Upload const& upload, Report report)
{
    Report const graded_as = report.at("submission").at("file");
    std::string const name = one_line(upload.file.filename().string());
    report["submission"]["file"] = name;
    for (auto& diagnostic : report.at("build").at("diagnostics"))
        if (diagnostic.at("file") == graded_as)
            diagnostic["file"] = name;
    return report;
}

/// The names by which an override may call whose upload it is: a team's folder is named after whoever was last.
std::vector<std::string> names_of(Upload const& upload)
{
    std::vector<std::string> names = upload.members;
    names.push_back(upload.student);
    return names;
}

/// Overrides of nobody: a misspelt name must not be lost.
std::vector<std::string> lost_overrides(std::vector<Upload> const& uploads, fs::path const& file, Language language)
{
    constexpr Term nobody{"overrides.json: niemand heißt {}", "overrides.json: nobody is called {}"};
    std::set<std::string> known;
    for (auto const& upload : uploads)
        for (auto const& name : names_of(upload))
            known.insert(name);
    std::vector<std::string> lost;
    for (auto const& given : read_overrides(file))
        if (known.count(given.student) == 0)
            lost.push_back(fmt::format(fmt::runtime(say(nobody, language)), one_line(given.student)));
    return lost;
}

std::vector<GradedUpload> grade_all(std::vector<Upload> const& uploads, BatchOptions const& options, Store const& store)
{
    auto const& settings = options.settings;
    GradingBasis const basis = current_basis(settings.compiler, settings.seed, settings.lenient);
    std::vector<GradedUpload> entries;
    std::map<std::string, Job> missing;  // identical files are graded once
    for (auto const& upload : uploads) {
        std::string const key = Store::key(upload.file, basis);
        entries.push_back({upload, key, {}});
        if (!options.resume || !store.find(key))
            missing.emplace(key, Job{key, upload.student, upload.file, store.begin(key)});
    }
    std::vector<Job> jobs;
    for (auto const& [key, job] : missing)
        jobs.push_back(job);
    auto const overrides = read_overrides(options.out / "overrides.json");  // first: mistakes in it are told at once
    Grading grading(options, store);
    if (!jobs.empty())
        grading.grade(jobs);
    for (auto& entry : entries) {
        auto const found = store.find(entry.key);
        if (found)
            entry.graded = fmt::format("{:.2f}", found->at("points").at("earned").get<double>());
        entry.report = found ? apply(overrides, names_of(entry.upload), as_from(entry.upload, *found))
                             : not_gradable_report(entry.upload, options, grading.failure(entry.key));
    }
    return entries;
}

/// Links where the file system can, copies elsewhere: pictures are never changed in place.
void link_or_copy(fs::path const& from, fs::path const& to)
{
    std::error_code error;
    fs::create_hard_link(from, to, error);
    if (error)
        fs::copy_file(from, to, fs::copy_options::overwrite_existing);
}

constexpr char const* files_of_a_student[] = {"report.json", "report.html", "report.txt", "results.json", "pictures"};

bool is_ours(fs::path const& entry)
{
    auto const is_it = [&](char const* name) { return entry.filename() == name; };
    return std::any_of(std::begin(files_of_a_student), std::end(files_of_a_student), is_it);
}

bool is_whole(fs::path const& folder)
{
    auto const is_there = [&](char const* name) { return fs::exists(folder / name); };
    return std::all_of(std::begin(files_of_a_student), std::end(files_of_a_student), is_there);
}

/// All that a student's folder is made from. Times are those of the result that the key names.
std::string basis_of(GradedUpload const& entry, Language language)
{
    Report report = entry.report;
    report.erase("timing");
    report.erase("run_time");
    return fmt::format("{}\n{}\n{}", entry.key, int(language), report.dump());
}

void write_report(GradedUpload const& entry, fs::path const& results, fs::path const& folder, Language language)
{
    fs::path const part = folder.string() + ".part";
    fs::remove_all(part);
    fs::create_directories(part / "pictures");
    if (entry.is_graded() && fs::is_directory(results / entry.key / "pictures"))
        for (auto const& picture : fs::directory_iterator(results / entry.key / "pictures"))
            link_or_copy(picture.path(), part / "pictures" / picture.path().filename());
    write_file(part / "report.json", to_text(entry.report));
    write_file(part / "report.txt", report_to_text(entry.report, language));
    write_file(part / "report.html", to_html({{entry.upload.student, entry.report, part}}, language));
    write_file(part / "results.json", to_gradescope({{entry.upload.student, entry.report}}, language));
    fs::create_directories(folder);  // what a tutor has put there stays where it is
    for (char const* name : files_of_a_student) {
        fs::remove_all(folder / name);
        fs::rename(part / name, folder / name);
    }
    fs::remove(part);
}

/// Students who are no longer in the input keep no report, unless a tutor has put something beside it.
void remove_others(std::vector<GradedUpload> const& entries, fs::path const& reports)
{
    std::set<std::string> names;
    for (auto const& entry : entries)
        names.insert(entry.upload.student);
    for (auto const& folder : fs::directory_iterator(reports)) {
        bool const is_only_ours =
            std::all_of(fs::directory_iterator(folder), {}, [](auto const& entry) { return is_ours(entry.path()); });
        if (names.count(folder.path().filename().string()) == 0 && is_only_ours)
            fs::remove_all(folder.path());
    }
}

void write_outputs(std::vector<GradedUpload> const& entries, std::string const& overview, BatchOptions const& options,
                   Written& written)
{
    fs::path const reports = options.out / "reports";
    fs::create_directories(reports);
    tbb::parallel_for_each(entries, [&](GradedUpload const& entry) {
        fs::path const folder = reports / entry.upload.student;
        written.update("reports/" + entry.upload.student, is_whole(folder), basis_of(entry, options.language),
                       [&] { write_report(entry, options.out / store_name / "results", folder, options.language); });
    });
    std::vector<NamedReport> named;
    for (auto const& entry : entries)
        named.push_back({entry.upload.student, entry.report, fs::path("reports") / entry.upload.student});
    remove_others(entries, reports);
    write_atomically(options.out / "grades.csv", grades_table(entries));
    write_atomically(options.out / "junit.xml", to_junit(named, options.language));
    write_atomically(options.out / "summary.txt", overview);
}

/// What goes back to ILIAS, each file as a whole or not at all. Where some are in teams and some are not, teams have a
/// sheet of their own: its rows are of another shape.
void write_for_ilias(std::vector<GradedUpload> const& entries, std::string const& title, BatchOptions const& options,
                     Written& written)
{
    auto const write = [&](char const* name, auto const& writer) {
        fs::path const part = options.out / (std::string(name) + ".part");
        writer(part);
        fs::rename(part, options.out / name);
    };
    std::string basis = title + "\n" + options.assignment;
    for (auto const& entry : entries)
        basis += fmt::format("\n{}\n{}\n{}", entry.upload.folder, fmt::join(entry.upload.members, "\n"),
                             sha256(basis_of(entry, options.language)));
    written.update("feedback.zip", fs::exists(options.out / "feedback.zip"), basis, [&] {
        write("feedback.zip", [&](fs::path const& file) {
            write_feedback_zip(entries, options.out / "reports", title, options.assignment, file);
        });
    });
    auto const is_team = [](GradedUpload const& entry) { return !entry.upload.team.empty(); };
    bool const teams = std::any_of(entries.begin(), entries.end(), is_team);
    bool const others = !std::all_of(entries.begin(), entries.end(), is_team);
    bool const both = teams && others;
    write("status.xlsx",
          [&](fs::path const& file) { write_status_sheet(entries, teams && !both, options.language, file); });
    if (both)
        write("status_teams.xlsx",
              [&](fs::path const& file) { write_status_sheet(entries, true, options.language, file); });
    else
        fs::remove(options.out / "status_teams.xlsx");
}

/// One upload that sim_c++ cannot read, or for ever, costs the list and nothing else.
std::vector<SimilarPair> write_similarity(Intake const& intake, fs::path const& scratch, BatchOptions const& options)
{
    if (!options.similarity && options.earlier.empty())
        return {};
    std::vector<Upload> earlier;
    for (std::size_t i = 0; i < options.earlier.size(); ++i) {
        auto const before =
            take_in(options.earlier[i], scratch / ("earlier-" + std::to_string(i)), std::nullopt).uploads;
        earlier.insert(earlier.end(), before.begin(), before.end());
    }
    std::vector<SimilarPair> pairs;
    std::string text;
    try {
        pairs = find_similar(intake.uploads, earlier);
        text = similarity_to_text(pairs, options.language);
    } catch (Interrupted const&) {
        throw;
    } catch (std::runtime_error const& e) {
        text = std::string("The uploads were not compared: ") + e.what() + "\n";
        std::cerr << "testat: " << text;
    }
    write_atomically(options.out / "similarity.txt", text);
    return pairs;
}
}  // namespace

bool batch(BatchOptions const& options)
{
    if (CageTrouble const trouble = find_cage_trouble(); !trouble.problem.empty())
        throw std::runtime_error("there is no cage for uploads: " + trouble.problem +
                                 "; to mend it: " + trouble.remedy);
    claim(options.out);
    Store const store(options.out / store_name);
    TemporaryDirectory const scratch(store.work());
    std::string const deadline =
        options.deadline.empty() ? read_rubric(installation().rubric).deadline : options.deadline;
    Intake const intake = take_in(options.input, scratch.path() / "input", parse_deadline(deadline));
    auto const entries = grade_all(intake.uploads, options, store);

    bool const all_graded =
        std::all_of(entries.begin(), entries.end(), [](GradedUpload const& entry) { return entry.is_graded(); });
    Applied const applied(options.out / store_name / "applied.json");
    std::string const changes = applied.changes(entries, options.out / store_name / "results", options.language);
    if (!changes.empty() && !options.apply) {
        std::cout << "Points change though the files are the same:\n"
                  << changes << "Nothing was written; --apply does.\n";
        return all_graded;
    }
    auto remarks = lost_overrides(intake.uploads, options.out / "overrides.json", options.language);
    remarks.insert(remarks.end(), intake.remarks.begin(), intake.remarks.end());
    std::string const overview = summary(entries, remarks, options.language);
    Written written(options.out / store_name / "written.json");
    write_outputs(entries, overview, options, written);
    if (intake.is_ilias)
        write_for_ilias(entries, intake.title, options, written);
    written.remember();
    auto const similar = write_similarity(intake, scratch.path(), options);
    write_atomically(options.out / "overview.html", overview_page(entries, similar, intake.title, options.language));
    applied.remember(entries);
    std::cout << overview << "\n" << one_line((options.out / "grades.csv").string()) << "\n";
    return all_graded;
}
}  // namespace testat
