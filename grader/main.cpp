// The command line of testat: what to do and with which exit code to end (DESIGN.md, Commands).
#include "batch/batch.h"
#include "batch/slurm.h"
#include "bench/command.h"
#include "diff/diff.h"
#include "doctor.h"
#include "grade.h"
#include "json_schema.h"
#include "process/run.h"
#include "report/formats/format.h"
#include "report/text.h"
#include "stress/command.h"
#include "text.h"
#include "theory/theory.h"
#include "watch/watch.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <thread>

namespace {
using namespace testat;

enum Exit { done = 0, different = 1, wrong_usage = 2, not_gradable = 3, interrupted = 130 };

/// --lang, else the language of the environment.
Language language(std::string const& wanted)
{
    if (!wanted.empty())
        return wanted == "de" ? Language::de : Language::en;
    for (char const* name : {"LC_ALL", "LC_MESSAGES", "LANG"})
        if (char const* value = std::getenv(name); value != nullptr && *value != '\0')
            return std::string(value).rfind("de", 0) == 0 ? Language::de : Language::en;
    return Language::en;
}

/// What --format may be.
std::vector<std::string> names_of_formats(std::vector<std::string> names)
{
    for (auto const& format : formats())
        names.push_back(format.name);
    return names;
}

void add_no_sandbox(CLI::App& command, Confinement& confinement)
{
    command.add_flag_callback(
        "--no-sandbox", [&] { confinement = Confinement::none; },
        "Run the file without a cage, with your rights: only for a file of your own");
}

struct GradeCommand {
    GradeOptions options;
    std::vector<std::string> tasks;
    std::vector<std::string> formats{"json"};
    std::string language;
    std::string profile = "tutor";
    bool timing = false;

    void add_to(CLI::App& app)
    {
        auto* command = app.add_subcommand("grade", "Grade one exercise_03.cpp and write a report");
        command->add_option("FILE", options.file, "The file to grade")->required();
        command->add_option("--out", options.out, "Directory of report.json (default: testat-out/<stem>)");
        command->add_option("--tasks", tasks, "Only these tasks, such as a,c")->delimiter(',');
        command->add_option("--seed", options.seed, "Seed of the random inputs")
            ->check(CLI::Range(0.0, 9007199254740991.0))  // what JSON readers keep exactly
            ->capture_default_str();
        command->add_option("--lang", language, "Language of the table")->check(CLI::IsMember({"de", "en"}));
        command->add_option("--profile", profile, "Students see public checks and no expected values")
            ->check(CLI::IsMember({"tutor", "student"}))
            ->capture_default_str();
        command->add_option("--compiler", options.compiler, "Which compiler builds the file")
            ->check(CLI::IsMember({"g++", "clang++"}))
            ->capture_default_str();
        command->add_option("--compiler-flags", options.compiler_flags, "More flags for it: --compiler-flags=-O3,-g")
            ->delimiter(',')
            ->allow_extra_args(false);
        command->add_option("--format", formats, "Formats to write; json is always written")
            ->delimiter(',')
            ->check(CLI::IsMember(names_of_formats({"json"})));
        command->add_flag("--lenient", options.lenient, "Leave out the sheet's rules for whole files");
        command->add_flag("--timing", timing, "Also print where the time went");
        add_no_sandbox(*command, options.confinement);
        command->callback([this] { prepare(); });
    }

    void prepare()
    {
        for (auto const& task : tasks) {
            if (task.size() != 1)
                throw CLI::ValidationError("--tasks", "'" + task + "' is no task of the sheet; tasks are a to f");
            options.tasks.insert(task[0]);
        }
        options.for_tutor = profile == "tutor";
        if (options.out.empty())
            options.out = std::filesystem::path("testat-out") / options.file.stem();
    }

    int run() const
    {
        Stages stages;
        Report const report = grade(options, installation(), stages);
        write_formats(report);
        stages.end("write formats");
        std::cout << report_to_text(report, ::language(language), ink_of_stdout()) << "\n"
                  << one_line((options.out / "report.json").string()) << "\n";
        if (timing)
            std::cout << "\n" << stages.table();
        return report.at("status") == "graded" ? done : not_gradable;
    }

private:
    void write_formats(Report const& report) const
    {
        for (auto const& format : ::testat::formats())
            if (std::find(formats.begin(), formats.end(), format.name) != formats.end())
                write_atomically(options.out / format.file,
                                 format.write({{options.out.filename(), report, options.out}}, ::language(language)));
    }
};

struct RenderCommand {
    std::vector<std::string> reports;
    std::string format = "text";
    std::string language;

    void add_to(CLI::App& app)
    {
        auto* command = app.add_subcommand("render", "Show reports again");
        command->add_option("REPORT", reports, "report.json files")->required();
        command->add_option("--format", format, "text: the table; json: the document, validated; or another one")
            ->check(CLI::IsMember(names_of_formats({"text", "json"})))
            ->capture_default_str();
        command->add_option("--lang", language, "Language of the table")->check(CLI::IsMember({"de", "en"}));
    }

    int run() const
    {
        std::vector<NamedReport> all;
        for (auto const& file : reports)
            all.push_back(read(file));
        for (auto const& other : formats())
            if (other.name == format)
                return print(other, all);
        for (auto const& named : all)
            std::cout << (format == "json" ? to_text(named.report)
                                           : report_to_text(named.report, ::language(language), ink_of_stdout()));
        return done;
    }

private:
    int print(Format const& wanted, std::vector<NamedReport> const& all) const
    {
        if (all.size() > 1 && !wanted.takes_many)
            throw std::invalid_argument("--format " + wanted.name + " takes one report at a time");
        std::cout << wanted.write(all, ::language(language));
        return done;
    }

    /// A file that is no report is wrong usage.
    static NamedReport read(std::string const& file)
    {
        auto const folder = std::filesystem::absolute(file).parent_path();
        try {
            return {folder.filename(), read_report(file, installation().rubric.parent_path() / "report.schema.json"),
                    folder};
        } catch (BadJson const& e) {
            throw std::invalid_argument(e.what());
        }
    }
};

struct StressCommand {
    StressFile options;
    std::string language;

    void add_to(CLI::App& app)
    {
        auto* command = app.add_subcommand("stress", "Ask the functions of a file millions of unkind questions");
        command->add_option("FILE", options.file, "The file to ask")->required();
        command->add_option("--out", options.out, "Directory of stress.json (default: testat-out/<stem>-stress)");
        command
            ->add_option("--questions", options.stress.questions,
                         "Questions to a function; in proportion fewer where one takes long (default: 1048576)")
            ->check(CLI::Range(1, 1 << 24));
        command->add_option("--seed", options.stress.seed, "Seed of the inputs")
            ->check(CLI::Range(0.0, 9007199254740991.0))
            ->capture_default_str();
        command->add_option("--lang", language, "Language of table and plot")->check(CLI::IsMember({"de", "en"}));
        command->add_option("--compiler", options.compiler, "Which compiler builds the file")
            ->check(CLI::IsMember({"g++", "clang++"}))
            ->capture_default_str();
        add_no_sandbox(*command, options.confinement);
        command->add_flag("--contract-only", options.stress.contract_only,
                          "Leave out what the contract does not allow");
        command->callback([this] { prepare(); });
    }

    void prepare()
    {
        if (options.out.empty())
            options.out = std::filesystem::path("testat-out") / (options.file.stem().string() + "-stress");
        options.language = ::language(language);
    }

    int run() const
    {
        std::cout << stress_file(options, installation()) << "\n"
                  << one_line((options.out / "stress.json").string()) << "\n";
        return done;
    }
};

struct BenchCommand {
    bench::BenchFile options;
    std::string language;

    void add_to(CLI::App& app)
    {
        auto* command = app.add_subcommand("bench", "Measure run time and error of texture filters");
        command->add_option("FILE", options.file, "Also those of this file");
        command->add_option("--out", options.out,
                            "Directory of bench.json (default: testat-out/<stem>-bench, or testat-out/bench)");
        command->add_option("--lang", language, "Language of table and chart")->check(CLI::IsMember({"de", "en"}));
        command->add_option("--compiler", options.compiler, "Which compiler builds the file")
            ->check(CLI::IsMember({"g++", "clang++"}))
            ->capture_default_str();
        add_no_sandbox(*command, options.confinement);
        command->add_flag("--quick", options.bench.quick, "Smaller pictures, fewer rounds: to see that it works");
        command->callback([this] { prepare(); });
    }

    void prepare()
    {
        if (options.out.empty())
            options.out = std::filesystem::path("testat-out") /
                          (options.file.empty() ? "bench" : options.file.stem().string() + "-bench");
        options.language = ::language(language);
    }

    int run() const
    {
        std::cout << bench::bench_file(options, installation()) << "\n"
                  << one_line((options.out / "bench.json").string()) << "\n";
        return done;
    }
};

struct BatchCommand {
    BatchOptions options;
    std::string language;
    std::string executor = "local";
    bool no_resume = false;

    void add_to(CLI::App& app)
    {
        auto* command = app.add_subcommand("batch", "Grade a download of many uploads");
        command->add_option("INPUT", options.input, "ILIAS zip, a folder like it, or a folder of files")->required();
        command->add_option("--out", options.out, "Folder of reports, grades.csv, summary.txt")->required();
        options.at_once = std::max(1u, std::thread::hardware_concurrency());
        command->add_option("--jobs", options.at_once, "So many at a time (default: one for each core)")
            ->check(CLI::Range(1, 256));
        command->add_option("--executor", executor, "local: here; slurm: on the cluster, --jobs tasks at a time")
            ->check(CLI::IsMember({"local", "slurm"}))
            ->capture_default_str();
        command->add_option("--deadline", options.deadline, "ISO 8601, instead of the rubric's");
        command->add_flag("--similarity", options.similarity, "List uploads that have much in common");
        command->add_option("--earlier", options.earlier, "Also compare with these inputs of other years");
        command->add_option("--assignment", options.assignment, "ILIAS's number of the exercise, for feedback.zip");
        command->add_flag("--no-resume", no_resume, "Grade all of them again");
        command->add_flag("--apply", options.apply, "Write points that change though the files are the same");
        command->add_option("--lang", language, "Language of texts")->check(CLI::IsMember({"de", "en"}));
        command->add_option("--seed", options.settings.seed, "Seed of the random inputs")
            ->check(CLI::Range(0.0, 9007199254740991.0))
            ->capture_default_str();
        command->add_option("--compiler", options.settings.compiler, "Which compiler builds the files")
            ->check(CLI::IsMember({"g++", "clang++"}))
            ->capture_default_str();
        command->add_flag("--lenient", options.settings.lenient, "Leave out the sheet's rules for whole files");
    }

    int run()
    {
        options.resume = !no_resume;
        options.executor = executor == "slurm" ? Executor::slurm : Executor::local;
        options.language = ::language(language);
        return batch(options) ? done : not_gradable;
    }
};

/// What a task of `batch --executor slurm` runs; not for people.
struct GradePartCommand {
    std::filesystem::path part;

    void add_to(CLI::App& app)
    {
        auto* command = app.add_subcommand("grade-part", "One task of batch --executor slurm")->group("");
        command->add_option("PART", part)->required();
    }

    int run() const
    {
        grade_part(part);
        return done;
    }
};

struct DiffCommand {
    std::string a;
    std::string b;
    std::string language;

    void add_to(CLI::App& app)
    {
        auto* command = app.add_subcommand("diff", "Compare two reports or two PNG pictures");
        command->add_option("A", a, "report.json or picture")->required();
        command->add_option("B", b, "report.json or picture")->required();
        command->add_option("--lang", language, "Language of the text")->check(CLI::IsMember({"de", "en"}));
    }

    int run() const
    {
        Difference const difference = diff(a, b, ::language(language));
        std::cout << difference.text;
        return difference.same ? done : different;
    }
};

struct TheoryCommand {
    std::string file;
    std::string wanted_template;
    std::filesystem::path out;
    bool overwrite = false;
    std::string format = "text";
    std::string language;

    void add_to(CLI::App& app)
    {
        auto* command = app.add_subcommand("theory", "Check answers to the sheet's theory questions; no points");
        command->add_option("ANSWERS", file, "JSON file of answers; --template writes one to fill in");
        command->add_option("--template", wanted_template, "Write a file to fill in, with explanations")
            ->check(CLI::IsMember({"de", "en"}));
        command->add_option("--out", out, "Where the template goes (default: here)");
        command->add_flag("--overwrite", overwrite, "Replace the file of --out if there is one");
        command->add_option("--format", format, "text for people; json: the same for machines, in both languages")
            ->check(CLI::IsMember({"text", "json"}))
            ->capture_default_str();
        command->add_option("--lang", language, "Language of the text")->check(CLI::IsMember({"de", "en"}));
        command->callback([this] { prepare(); });
    }

    void prepare() const
    {
        if (file.empty() == wanted_template.empty())
            throw CLI::ValidationError("theory", "takes either a file of answers or --template de|en");
        if (wanted_template.empty() && (!out.empty() || overwrite))
            throw CLI::ValidationError("--out", "is where a template goes; it needs --template de|en");
    }

    int run() const
    {
        if (!wanted_template.empty())
            return write_template();
        Report const judged = theory::judge(theory::read_answers(file));
        std::string const name = one_line(std::filesystem::path(file).filename().string(), 60);
        std::cout << (format == "json" ? to_text(judged) : theory::to_text(judged, name, ::language(language)));
        return done;
    }

private:
    int write_template() const
    {
        std::string const text = theory::answers_template(::language(wanted_template), installation());
        if (out.empty())
            std::cout << text;
        else if (std::filesystem::exists(out) && !overwrite)
            throw std::invalid_argument(out.string() + ": is there already; --overwrite replaces it");
        else
            write_atomically(out, text);
        return done;
    }
};

struct WatchCommand {
    WatchOptions options;
    std::string tasks;
    std::string profile = "student";
    std::string compiler = "g++";
    std::string language;
    bool no_sandbox = false;

    void add_to(CLI::App& app)
    {
        auto* command =
            app.add_subcommand("watch", "Grade a file on each save and say what has changed; Ctrl-C ends it");
        command->add_option("FILE", options.file, "The file to watch")->required();
        command->add_option("--out", options.out, "Directory of report.json (default: testat-out/<stem>)");
        command->add_option("--tasks", tasks, "Only these tasks, such as a,c");
        command->add_option("--lang", language, "Language of the text")->check(CLI::IsMember({"de", "en"}));
        command->add_option("--profile", profile, "Tutors see hidden checks and expected values, too")
            ->check(CLI::IsMember({"tutor", "student"}))
            ->capture_default_str();
        command->add_option("--compiler", compiler, "Which compiler builds the file")
            ->check(CLI::IsMember({"g++", "clang++"}))
            ->capture_default_str();
        command->add_flag("--no-sandbox", no_sandbox,
                          "Run the file without a cage, with your rights: only for a file of your own");
    }

    int run()
    {
        options.program = std::filesystem::canonical("/proc/self/exe");
        options.language = ::language(language);
        if (options.out.empty())
            options.out = std::filesystem::path("testat-out") / options.file.stem();
        options.grade_options = {"--profile", profile, "--compiler", compiler};
        if (!tasks.empty())
            options.grade_options.insert(options.grade_options.end(), {"--tasks", tasks});
        if (no_sandbox)
            options.grade_options.emplace_back("--no-sandbox");
        watch(options, installation(), std::cout);
    }
};

struct Commands {
    BatchCommand batch;
    BenchCommand bench;
    DiffCommand diff;
    GradeCommand grade;
    GradePartCommand grade_part;
    RenderCommand render;
    StressCommand stress;
    TheoryCommand theory;
    WatchCommand watch;
};

int run_command(CLI::App const& app, Commands& commands)
{
    if (app.got_subcommand("batch"))
        return commands.batch.run();
    if (app.got_subcommand("bench"))
        return commands.bench.run();
    if (app.got_subcommand("diff"))
        return commands.diff.run();
    if (app.got_subcommand("stress"))
        return commands.stress.run();
    if (app.got_subcommand("grade"))
        return commands.grade.run();
    if (app.got_subcommand("grade-part"))
        return commands.grade_part.run();
    if (app.got_subcommand("render"))
        return commands.render.run();
    if (app.got_subcommand("theory"))
        return commands.theory.run();
    if (app.got_subcommand("watch"))
        return commands.watch.run();
    return doctor(installation(), std::cout) ? done : not_gradable;
}

int complain(std::exception const& e, Exit code)
{
    std::cerr << "testat: " << one_line(e.what()) << "\n";
    return code;
}

/// What was printed must have arrived before we say that all is well.
int finish(int code)
{
    if (!std::cout.flush())
        throw std::runtime_error("the output could not be written");
    return code;
}
}  // namespace

int main(int argc, char** argv)
{
    CLI::App app("Testat grades exercise_03.cpp of the texture mapping exercise.", "testat");
    app.require_subcommand(1);
    app.set_version_flag("--version", installation().version);
    Commands commands;
    commands.batch.add_to(app);
    commands.bench.add_to(app);
    commands.diff.add_to(app);
    commands.grade.add_to(app);
    commands.grade_part.add_to(app);
    commands.render.add_to(app);
    commands.stress.add_to(app);
    commands.theory.add_to(app);
    commands.watch.add_to(app);
    app.add_subcommand("doctor", "Say whether this machine can grade, and what is missing");

    catch_interrupts();
    try {
        app.parse(argc, argv);
        return finish(run_command(app, commands));
    } catch (CLI::ParseError const& e) {
        return app.exit(e) == 0 ? done : wrong_usage;
    } catch (Interrupted const& e) {
        return complain(e, interrupted);
    } catch (UnreadableInput const& e) {
        return complain(e, wrong_usage);
    } catch (std::invalid_argument const& e) {
        return complain(e, wrong_usage);
    } catch (std::exception const& e) {
        return complain(e, not_gradable);
    }
}
