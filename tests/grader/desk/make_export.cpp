// Writes an ILIAS download of a course that does not exist, with all that such downloads have in them: names of all
// kinds, teams, late and repeated uploads, cut names, the same file from several students, an empty one, a zip in the
// zip, and attacks. The same seed gives the same bytes.
#include "batch/times.h"
#include "batch/zips.h"
#include "desk/people.h"
#include "end_to_end/testat_program.h"
#include "installation.h"
#include "rubric/rubric.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <xlsxwriter.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <clocale>
#include <ctime>
#include <iostream>
#include <set>

namespace fs = std::filesystem;

namespace testat {
namespace {
constexpr std::size_t fewest = 6, most = 3000;  // uploads
constexpr std::size_t most_attacks = 5;
constexpr std::size_t uploads_for_an_attack = 6;
constexpr int percent_of_copies = 30;
constexpr std::int64_t hour = 3600;  // s
constexpr std::int64_t day = 24 * hour;
constexpr char title[] = "Übung 3 Texturen";

struct Settings {
    fs::path out;
    std::size_t uploads = 300;
    std::uint64_t seed = 1;
    std::vector<fs::path> attacks;
};

/// What a student's folder looks like.
enum class Shape { plain, late, repeated, cut, team };

struct Row {
    Person person;
    std::int64_t submitted = 0;
};

std::vector<fs::path> sources_in(fs::path const& folder)
{
    std::vector<fs::path> files;
    for (auto const& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".cpp")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// Whole uploads of the corpus. Those are left out of which two reports may differ: what reads memory that nobody has
/// written to, and what races, has a remark; how far one comes that runs out of time depends on the machine.
std::vector<std::string> corpus_texts()
{
    std::vector<std::string> texts;
    for (char const* folder : {"correct", "wrong", "broken"})
        for (auto const& file : sources_in(fs::path(TESTAT_CORPUS) / folder)) {
            std::string text = read_file(file);
            std::string const verdict = text.substr(0, text.find('\n'));
            auto const says = [&](char const* word) { return verdict.find(word) != std::string::npos; };
            if (!says("\"remarks\"") && !says("\"timed_out\""))
                texts.push_back(std::move(text));
        }
    if (texts.empty())
        throw std::runtime_error("the corpus is not composed: build the target corpus_uploads");
    return texts;
}

/// Files as they are, of folders all in them. Attacks that end the same way each time if none are given.
std::vector<std::string> attack_texts(std::vector<fs::path> const& wanted)
{
    std::vector<fs::path> files;
    for (char const* name : {"ends_with_success", "includes_the_password_file", "kills_its_parents",
                             "prints_escape_sequences", "writes_an_answer_stream"})
        if (wanted.empty())
            files.push_back(fs::path(TESTAT_ATTACKS) / (std::string(name) + ".cpp"));
    for (auto const& path : wanted) {
        auto const found = fs::is_directory(path) ? sources_in(path) : std::vector<fs::path>{path};
        files.insert(files.end(), found.begin(), found.end());
    }
    std::vector<std::string> texts;
    for (auto const& file : files)
        texts.push_back(patched_reference(read_file(file)));
    return texts;
}

class Export {
public:
    explicit Export(Settings const& settings)
        : random_(settings.seed),
          count_(settings.uploads),
          deadline_(parse_deadline(read_rubric(installation().rubric).deadline))
    {
        corpus_ = corpus_texts();
        std::shuffle(corpus_.begin(), corpus_.end(), random_);
        attacks_ = attack_texts(settings.attacks);
        std::shuffle(attacks_.begin(), attacks_.end(), random_);
        attacks_.resize(std::min({attacks_.size(), most_attacks, count_ / uploads_for_an_attack}));
    }

    void write(fs::path const& file)
    {
        auto const texts = make_texts();
        auto const shapes = make_shapes();
        for (std::size_t i = 0; i < count_; ++i)
            add(shapes[i], texts[i]);
        add_zip_in_zip();
        add_row(new_person(), 0);  // has handed in nothing
        std::sort(items_.begin(), items_.end(), [](auto const& a, auto const& b) { return a.name < b.name; });
        items_.insert(items_.begin(), {fmt::format("{0}/{0}.xlsx", title), table(), deadline_ + 7 * day});
        write_zip(file, items_);
        std::size_t const different = std::set<std::string>(texts.begin(), texts.end()).size();
        fmt::print("{}: {} uploads, {} of them different, {} of teams, {} late, {} attacks\n", file.string(), count_,
                   different, teams_, late_, attacks_.size());
    }

private:
    /// Attacks, an empty one, others; then copies of others.
    std::vector<std::string> make_texts()
    {
        std::vector<std::string> texts = attacks_;
        texts.emplace_back();
        std::size_t const first_other = texts.size();
        std::size_t const originals = count_ - count_ * percent_of_copies / 100;
        for (std::size_t i = 0; texts.size() < originals; ++i)
            texts.push_back(fmt::format("{}\n// upload {}\n", corpus_[i % corpus_.size()], i));
        while (texts.size() < count_) {
            std::string const copied = texts[first_other + random_() % (originals - first_other)];
            texts.push_back(copied);
        }
        return texts;
    }

    /// Each at least once.
    std::vector<Shape> make_shapes()
    {
        std::vector<Shape> shapes{Shape::late, Shape::repeated, Shape::cut, Shape::team, Shape::plain};
        while (shapes.size() < count_) {
            auto const percent = random_() % 100;
            shapes.push_back(percent < 10   ? Shape::late
                             : percent < 15 ? Shape::repeated
                             : percent < 18 ? Shape::cut
                             : percent < 26 ? Shape::team
                                            : Shape::plain);
        }
        std::shuffle(shapes.begin(), shapes.end(), random_);
        return shapes;
    }

    Person new_person() { return make_person(random_, persons_++); }
    void add_row(Person const& person, std::int64_t time) { rows_.push_back({person, time}); }

    /// A time before the deadline.
    std::int64_t in_time() { return deadline_ - std::int64_t(random_() % std::uint64_t(3 * day)); }

    static std::string folder_of(Person const& person) { return fmt::format("{}/Abgaben/{}/", title, person.folder); }

    void add(Shape shape, std::string const& text)
    {
        if (shape == Shape::team)
            return add_team(text);
        Person const person = new_person();
        std::string const folder = folder_of(person);
        std::int64_t const time =
            shape == Shape::late ? deadline_ + 1 + std::int64_t(random_() % std::uint64_t(day)) : in_time();
        late_ += shape == Shape::late ? 1 : 0;
        if (shape == Shape::repeated)
            items_.push_back({folder + "exercise_03.cpp", "// not yet\n", time - day});
        char const* const name = shape == Shape::late       ? "Verspätete Abgabe - exercise_03.cpp"
                                 : shape == Shape::repeated ? "exercise_03 (2).cpp"
                                 : shape == Shape::cut      ? "03.cpp"
                                                            : "exercise_03.cpp";
        items_.push_back({folder + name, text, time});
        add_row(person, time);
    }

    /// One of a team hands in for all; sometimes another one had done so before.
    void add_team(std::string const& text)
    {
        std::string const folder = fmt::format("{}/Abgaben/Team {}/", title, 100 + ++teams_);
        std::int64_t const time = in_time();
        std::size_t const members = 2 + random_() % 2;
        for (std::size_t i = 0; i < members; ++i) {
            Person const person = new_person();
            std::string const own = folder + person.folder + "/";
            items_.push_back({own, ""});
            if (i == 0)
                items_.push_back({own + "exercise_03.cpp", text, time});
            else if (random_() % 3 == 0)
                items_.push_back({own + "exercise_03.cpp", "// not yet\n", time - day});
            add_row(person, time);
        }
    }

    void add_zip_in_zip()
    {
        TemporaryDirectory const place;
        fs::path const zip = place.path() / "exercise_03.zip";
        write_zip(zip, {{"exercise_03.cpp", reference_text(), deadline_ - 2 * day}});
        Person const person = new_person();
        std::int64_t const time = in_time();
        items_.push_back({folder_of(person) + "exercise_03.zip", read_file(zip), time});
        add_row(person, time);
    }

    /// As ILIAS writes it: names as they are, times local, no usr_id.
    std::string table() const
    {
        TemporaryDirectory const place;
        fs::path const file = place.path() / "table.xlsx";
        lxw_workbook* const book = workbook_new(file.c_str());
        lxw_doc_properties properties = {};
        properties.created = 1;  // the same bytes each time
        workbook_set_properties(book, &properties);
        lxw_worksheet* const sheet = workbook_add_worksheet(book, nullptr);
        lxw_format* const date = workbook_add_format(book);
        format_set_num_format(date, "dd.mm.yyyy hh:mm:ss");
        lxw_col_t column = 0;
        for (char const* heading : {"Nachname", "Vorname", "Benutzername", "Datum der letzten Abgabe"})
            worksheet_write_string(sheet, 0, column++, heading, nullptr);
        for (std::size_t i = 0; i < rows_.size(); ++i)
            write_row(sheet, static_cast<lxw_row_t>(i + 1), rows_[i], date);
        if (workbook_close(book) != LXW_NO_ERROR)
            throw std::runtime_error("cannot write " + file.string());
        return read_file(file);
    }

    static void write_row(lxw_worksheet* sheet, lxw_row_t row, Row const& who, lxw_format* date)
    {
        worksheet_write_string(sheet, row, 0, who.person.lastname.c_str(), nullptr);
        worksheet_write_string(sheet, row, 1, who.person.firstname.c_str(), nullptr);
        worksheet_write_string(sheet, row, 2, who.person.login.c_str(), nullptr);
        if (who.submitted == 0)
            return;
        std::time_t const seconds = who.submitted;
        std::tm local{};
        localtime_r(&seconds, &local);
        lxw_datetime time{local.tm_year + 1900, local.tm_mon + 1, local.tm_mday,
                          local.tm_hour,        local.tm_min,     double(local.tm_sec)};
        worksheet_write_datetime(sheet, row, 3, &time, date);
    }

    std::mt19937_64 random_;
    std::size_t count_;
    std::int64_t deadline_;
    std::vector<std::string> corpus_, attacks_;
    std::vector<ZipItem> items_;
    std::vector<Row> rows_;
    std::size_t persons_ = 0, teams_ = 0, late_ = 0;
};
}  // namespace
}  // namespace testat

int main(int argc, char** argv)
{
    testing::GTEST_FLAG(throw_on_failure) = true;  // a zip that cannot be written
    std::setlocale(LC_CTYPE, "C.UTF-8");           // names in zips are marked as UTF-8
    testat::Settings settings;
    CLI::App app("Writes a made-up ILIAS download, with all that downloads have in them.", "make_export");
    app.add_option("OUT", settings.out, "The zip to write")->required();
    app.add_option("--uploads", settings.uploads, "How many uploads to grade are in it")
        ->check(CLI::Range(testat::fewest, testat::most))
        ->capture_default_str();
    app.add_option("--seed", settings.seed, "Another course")->capture_default_str();
    app.add_option("--attacks", settings.attacks, "Like tests/attacks: files or folders, of which a few are chosen")
        ->check(CLI::ExistingPath);
    CLI11_PARSE(app, argc, argv);
    try {
        testat::Export(settings).write(settings.out);
        return 0;
    } catch (std::exception const& e) {
        std::cerr << "make_export: " << e.what() << "\n";
        return 1;
    }
}
