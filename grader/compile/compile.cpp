#include "compile/compile.h"

#include "compile/diagnostics.h"
#include "compile/mend.h"
#include "compile/symbols.h"
#include "process/tree.h"
#include "source/definitions.h"
#include "source/includes.h"
#include "text.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace testat {
namespace {
constexpr char source_name[] = "exercise_03.cpp";
/// The one folder that the compiler can write to.
constexpr char output_name[] = "out";
constexpr char library_name[] = "out/upload.so";
constexpr double compiler_cpu_s = 20;
constexpr double compiler_wall_s = 60;
/// All attempts to mend a file together.
constexpr double mending_cpu_s = 20;
constexpr double mending_wall_s = 30;
constexpr std::size_t compiler_memory = std::size_t(2) << 30;
constexpr std::size_t compiler_file_size = std::size_t(64) << 20;

/// Includes what every upload includes, and is right.
constexpr char trial_text[] = "#include <cglib/rt/object.h>\n#include <cglib/rt/texture.h>\n";

using Arguments = std::vector<std::string>;

void append(Arguments& to, Arguments const& more)
{
    to.insert(to.end(), more.begin(), more.end());
}

bool is_clang(CompileOptions const& options)
{
    return options.compiler.find("clang") != std::string::npos;
}

/// Empty if the file is not there.
std::string text_of(std::filesystem::path const& file)
{
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// Whether the text includes whatever the precompiled header holds. Otherwise the header would make up for an #include
/// that the text lacks, and a file would compile here that does not where it is handed in.
bool may_be_precompiled(Submission const& submission, std::filesystem::path const& header, Installation const& where)
{
    auto const precompiled = included_headers(text_of(header), where.include);
    auto const included = included_headers(submission.text, where.include);
    return std::includes(included.begin(), included.end(), precompiled.begin(), precompiled.end());
}

std::filesystem::path usual_header(CompileOptions const& options, Installation const& where)
{
    return where.headers / options.compiler / options.standard / "submission.h";
}

/// Empty if no header was precompiled for this compiler, its standard and its flags, or if the upload must do without.
Arguments precompiled_header(Submission const& submission, CompileOptions const& options, Installation const& where)
{
    auto const header = usual_header(options, where);
    if (!options.flags.empty() || !may_be_precompiled(submission, header, where))
        return {};
    if (is_clang(options)) {
        auto const pch = header.string() + ".pch";
        return std::filesystem::exists(pch) ? Arguments{"-include-pch", pch} : Arguments{};
    }
    return std::filesystem::exists(header.string() + ".gch") ? Arguments{"-include", header.string()} : Arguments{};
}

Arguments compiler_call(CompileOptions const& options, Installation const& where, Arguments const& header)
{
    // Kept equal to the flags of the precompiled header in grader/CMakeLists.txt.
    Arguments call{options.compiler,
                   "-std=" + options.standard,
                   "-O1",
                   "-fPIC",
                   "-fsemantic-interposition",
                   "-ffp-contract=off",
                   "-DGLM_ENABLE_EXPERIMENTAL",
                   "-D_USE_MATH_DEFINES"};
    append(call, header);
    append(call, {"-I" + where.include.string(), "-fdiagnostics-color=never", "-ftemplate-depth=256",
                  is_clang(options) ? "-ferror-limit=20" : "-fmax-errors=20",
                  // #line could make the compiler quote any file of ours.
                  is_clang(options) ? "-fno-caret-diagnostics" : "-fno-diagnostics-show-caret"});
    append(call, options.flags);
    append(call, {"-shared", "-fuse-ld=mold", "-Wl,-z,defs", "-Wl,--as-needed", source_name, "-o", library_name,
                  (where.libraries / "libtestat_trampolines.so").string(),
                  (where.libraries / "libtestat_framework.so").string()});
    return call;
}

/// A compiler at work on what lies in `directory`.
struct Compiler {
    Installation const& where;
    std::filesystem::path const& directory;
    Cage& cage;

    Finished operator()(Arguments const& call, double cpu_s = compiler_cpu_s, double wall_s = compiler_wall_s) const
    {
        Caged caged{{call, directory, {}, cpu_s, wall_s, compiler_memory, compiler_file_size}, compiler_directories()};
        for (auto const& path : {where.include, where.headers, where.libraries / "libtestat_trampolines.so",
                                 where.libraries / "libtestat_framework.so"})
            caged.sees.push_back(path);
        caged.sees.push_back(directory);
        caged.writes = directory / output_name;
        caged.temporary_files = true;
        return cage.run(caged);
    }
};

/// A full disk is our trouble, whatever the compiler says about it.
void check_space(std::filesystem::path const& directory)
{
    constexpr std::uintmax_t enough = compiler_file_size + (16 << 20);
    if (std::filesystem::space(directory).available < enough)
        throw std::runtime_error("no space left in " + directory.string());
}

void write_source(std::string const& text, std::filesystem::path const& directory)
{
    std::ofstream out(directory / source_name, std::ios::binary);
    out << text;
    if (!out.flush())
        throw std::runtime_error("cannot write " + (directory / source_name).string());
}

/// What lies where the compiler could write: a link would be read with our rights.
bool is_plain_file(std::filesystem::path const& file)
{
    return std::filesystem::symlink_status(file).type() == std::filesystem::file_type::regular;
}

Diagnostic failure_without_message(Finished const& compiler)
{
    std::string const why =
        compiler.timed_out
            ? "the compiler needed more than 20 s of CPU time, 60 s by the clock, or 3 GB, and was stopped"
        : compiler.signal != 0 ? "the compiler crashed or ran out of memory"
                               : "the compiler failed: " + clean_text(compiler.output, 400);
    return {"", 0, 0, "error", why};
}

void note_failure(Finished const& compiler, Submission const& submission, Build& build)
{
    build.diagnostics = parse_diagnostics(compiler.output, source_name, submission.file);
    bool const explained = !build.diagnostics.empty() && build.diagnostics.front().severity != "note";
    if (compiler.timed_out || compiler.signal != 0 || !explained)
        build.diagnostics.insert(build.diagnostics.begin(), failure_without_message(compiler));
}

std::string describe(std::string const& compiler)
{
    std::string const text = run({{compiler, "--version"}, "/", {}, 10, 30}).output;
    return clean_text(std::string_view(text).substr(0, text.find('\n')), 120);
}

std::map<Function, SourceExcerpt> excerpts(std::string_view text, std::vector<Definition> const& definitions)
{
    constexpr std::size_t longest = 20'000;
    std::map<Function, SourceExcerpt> result;
    for (auto const& d : definitions)
        result[d.function] = {d.line, clean_text(text.substr(d.begin, d.end - d.begin), longest)};
    return result;
}

/// Compiles texts until the time for all of them is used up.
CompileText with_time_limit(Arguments const& call, Compiler const& compiler)
{
    return [&call, &compiler, cpu_s = mending_cpu_s, wall_s = mending_wall_s](std::string const& text) mutable {
        Finished finished;
        finished.timed_out = !(cpu_s > 0 && wall_s > 0);
        if (finished.timed_out)
            return finished;
        write_source(text, compiler.directory);
        finished = compiler(call, std::min(cpu_s, compiler_cpu_s), wall_s);
        cpu_s -= finished.cpu_s;
        wall_s -= finished.wall_s;
        return finished;
    };
}

void take_symbols(SymbolReport const& symbols, Build& build)
{
    build.defined = symbols.defined;
    build.broken.insert(symbols.missing.begin(), symbols.missing.end());
    build.left_out.insert(build.left_out.end(), symbols.duplicates.begin(), symbols.duplicates.end());
}

/// The library of a file that does not compile, without the functions that are to blame for it.
void compile_mended(Submission const& submission, Finished const& failed, CompileOptions const& options,
                    Compiler const& compiler, Build& build)
{
    auto const header = usual_header(options, compiler.where);
    MendedFile const file{source_name, submission.file, std::filesystem::exists(header) ? header.string() : ""};
    Arguments const call =
        compiler_call(options, compiler.where, precompiled_header(submission, options, compiler.where));
    build.sources = excerpts(submission.text, recover_definitions(submission.text));
    auto const mended = mend(submission.text, failed, file, with_time_limit(call, compiler));
    if (!mended)
        return;
    auto const library = compiler.directory / library_name;
    auto const symbols = check_symbols(library, submission.file, compiler.where, compiler.cage);
    if (symbols.defined == FunctionSet())
        return;
    build.mended = true;
    build.library = library;
    build.broken = mended->broken;
    build.left_out = mended->left_out;
    build.untouched = same_bodies(mended->text, text_of(compiler.where.exercise_template));
    take_symbols(symbols, build);
}

/// Throws std::runtime_error if not even the framework's headers compile and link: then it is not the upload's fault.
void check_toolchain(Arguments const& call, Compiler const& compiler)
{
    write_source(trial_text, compiler.directory);
    Finished const finished = compiler(call);
    if (finished.exit_code != 0 && !finished.timed_out)
        throw std::runtime_error("the compiler does not work: " + clean_text(finished.output, 400));
}

void run_compiler(Submission const& submission, CompileOptions const& options, Compiler const& compiler, Build& build)
{
    Installation const& where = compiler.where;
    Arguments const header = precompiled_header(submission, options, where);
    long long const kills_before = out_of_memory_kills();
    Finished finished = compiler(compiler_call(options, where, header));
    if (finished.exit_code != 0 && !finished.timed_out && !header.empty())
        finished = compiler(compiler_call(options, where, {}));
    if (finished.exit_code != 0 || !is_plain_file(compiler.directory / library_name)) {
        // What the upload has written must not make a full disk of it.
        std::filesystem::remove(compiler.directory / library_name);
        check_space(compiler.directory);
        // The drivers say so; a text can make them say it, but not the kernel.
        if (finished.output.find("Killed") != std::string::npos && out_of_memory_kills() > kills_before)
            throw std::runtime_error("this machine has too little memory: its kernel killed the compiler");
        if (!finished.timed_out)
            check_toolchain(compiler_call(options, where, header), compiler);
        note_failure(finished, submission, build);
        return compile_mended(submission, finished, options, compiler, build);
    }
    build.library = compiler.directory / library_name;
    auto const symbols = check_symbols(build.library, submission.file, where, compiler.cage);
    take_symbols(symbols, build);
    build.diagnostics = symbols.duplicates;
    for (auto const& [function, error] : symbols.missing)
        build.diagnostics.push_back(error);
    build.ok = build.diagnostics.empty();
}
}  // namespace

Build compile(Submission const& submission, CompileOptions const& options, std::filesystem::path const& directory,
              Installation const& where, Cage& cage)
{
    Build build;
    build.compiler = describe(options.compiler);
    if (submission.refused) {
        build.diagnostics.push_back({submission.file, 0, 0, "error", *submission.refused});
        return build;
    }
    build.sources = excerpts(submission.text, find_definitions(submission.text));
    build.untouched = same_bodies(submission.text, text_of(where.exercise_template));
    write_source(submission.text, directory);
    std::filesystem::create_directory(directory / output_name);
    check_space(directory);
    cage.show(directory);
    cage.hand_over(directory / output_name);
    run_compiler(submission, options, {where, directory, cage}, build);
    return build;
}
}  // namespace testat
