#include "report/formats/html_pictures.h"

#include "report/formats/page.h"
#include "report/png.h"
#include "report/reading.h"

#include <fstream>
#include <iterator>
#include <map>
#include <mutex>

namespace testat {
namespace {
constexpr std::uint32_t preview_side = 96;
constexpr std::size_t most_bytes_in_full = 5'000'000;

/// Empty if there is none.
std::string read_picture(NamedReport const& named, Report const& file)
{
    if (!file.is_string())
        return "";
    auto const path = named.folder / "pictures" / std::filesystem::path(file.get<std::string>()).filename();
    if (!std::filesystem::is_regular_file(path))
        return "";
    std::ifstream in(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    return is_png(bytes) ? bytes : "";
}

/// Expected pictures are the same in all reports of a batch; they are made smaller once.
class Previews {
public:
    std::string of(std::string const& png)
    {
        {
            std::lock_guard const lock(mutex_);
            if (auto const known = made_.find(png); known != made_.end())
                return known->second;
        }
        std::string preview = make(png);
        std::lock_guard const lock(mutex_);
        if (made_.size() < most)
            made_.emplace(png, preview);
        return preview;
    }

    static std::string make(std::string const& png)
    {
        try {
            return base64(encode_png(shrink(decode_png(png), preview_side)));
        } catch (std::invalid_argument const&) {  // damaged on the way
            return "";
        }
    }

private:
    static constexpr std::size_t most = 32;
    std::mutex mutex_;
    std::map<std::string, std::string> made_;
};

std::string preview(std::string const& png)
{
    static Previews previews;
    return png.empty() ? "" : previews.of(png);
}

void set(Report& view, char const* key, std::string const& data)
{
    if (!data.empty())
        view[key] = data;
}

Report names_of(Report const& functions)
{
    Report names = Report::array();
    for (std::size_t i = 0; i < functions.size(); ++i)
        names.push_back({{"function", functions[i]}, {"another", i + 1 < functions.size()}});
    return names;
}

class PictureViews {
public:
    explicit PictureViews(NamedReport const& named) : named_(named), reading_(named.report) {}

    Report make()
    {
        Report views{{"wrong", Report::array()}, {"right", Report::array()}};
        for (auto const& picture : named_.report.at("pictures"))
            if (reading_.finding(picture, Language::en).empty())
                add_right(views["right"], picture);
            else
                views["wrong"].push_back(wrong(picture));
        return views;
    }

private:
    void add_right(Report& views, Report const& picture)
    {
        Report view{{"picture", picture.at("name")}};
        set(view, "small", preview(read_picture(named_, picture.at("expected_file"))));
        views.push_back(view);
    }

    Report wrong(Report const& picture)
    {
        Report view{{"picture", picture.at("name")}, {"limit", picture.at("limit").dump()}};
        bool const is_explained = picture.contains("explained_by");
        view[is_explained ? "explained" : "concerned"] = {
            {"by", names_of(picture.at(is_explained ? "explained_by" : "functions"))}};
        std::string const english = reading_.finding_alone(picture, Language::en);
        view["apart"] = english.empty()
                            ? Report(nullptr)
                            : Report{{"de", reading_.finding_alone(picture, Language::de)}, {"en", english}};
        // As submitted it may be right, when a function's mistake shows only with the solution around it.
        bool const shows_alone = !is_explained && !picture.at("isolated_file").is_null();
        std::string const mine = read_picture(named_, picture.at(shows_alone ? "isolated_file" : "submitted_file"));
        std::string const expected = read_picture(named_, picture.at("expected_file"));
        set(view, "difference", Previews::make(read_picture(named_, picture.at("difference_file"))));
        bool const fits = bytes_ + mine.size() + expected.size() <= most_bytes_in_full;
        bytes_ += fits ? mine.size() + expected.size() : 0;
        view["in_full"] = fits && !mine.empty() && !expected.empty();
        set(view, "mine", fits ? base64(mine) : Previews::make(mine));
        set(view, "theirs", fits ? base64(expected) : preview(expected));
        return view;
    }

    NamedReport const& named_;
    Reading reading_;
    std::size_t bytes_ = 0;
};
}  // namespace

Report picture_views(NamedReport const& named)
{
    return PictureViews(named).make();
}
}  // namespace testat
