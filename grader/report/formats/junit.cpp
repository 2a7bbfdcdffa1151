#include "report/formats/format.h"

#include "report/printer.h"

#include <pugixml.hpp>

#include <sstream>

namespace testat {
namespace {
constexpr Term no_build{"Die Datei lässt sich nicht übersetzen oder binden", "The file does not compile or link"};
constexpr Term not_written{"fehlt noch", "is not written yet"};
constexpr Term pixels{"{} Pixel weichen ab, {} dürfen", "{} pixels differ, {} may"};

/// What XML 1.0 cannot hold is left out; texts of ours are clean already.
std::string xml_text(std::string const& text)
{
    std::string out;
    for (char c : text)
        if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t')
            out += c;
    return out;
}

class Suite {
public:
    Suite(bool many, Language language) : many_(many), language_(language)
    {
        root_ = document_.append_child("testsuites");
        suite_ = root_.append_child("testsuite");
        suite_.append_attribute("name") = "testat";
    }

    void add(NamedReport const& named)
    {
        prefix_ = many_ ? named.name + "/" : "";
        Report const& report = named.report;
        if (report.at("status") != "graded")
            return fail(test("Testat.Grades"), "error", report.at("error"));
        folder_ = many_ && !named.folder.empty() ? named.folder.string() + "/" : "";
        builds_ = report.at("build").at("ok").get<bool>();
        add_build(report.at("build"));
        for (auto const& [name, function] : report.at("functions").items())
            add_function(name, function);
        for (auto const& picture : report.at("pictures"))
            add_picture(picture);
    }

    std::string print()
    {
        for (auto node : {root_, suite_}) {
            node.append_attribute("tests") = tests_;
            node.append_attribute("failures") = failures_;
            node.append_attribute("errors") = errors_;
        }
        std::ostringstream out;
        document_.save(out, "  ");
        return out.str();
    }

private:
    pugi::xml_node test(std::string const& name)
    {
        ++tests_;
        std::size_t const dot = name.find('.');
        pugi::xml_node node = suite_.append_child("testcase");
        node.append_attribute("classname") = xml_text(prefix_ + name.substr(0, dot)).c_str();
        node.append_attribute("name") = xml_text(prefix_ + name).c_str();
        return node;
    }

    void fail(pugi::xml_node node, char const* how, std::string const& text)
    {
        ++(std::string(how) == "error" ? errors_ : failures_);
        pugi::xml_node failure = node.append_child(how);
        failure.append_attribute("message") = xml_text(text.substr(0, text.find('\n'))).c_str();
        failure.text() = xml_text(text).c_str();
    }

    void add_build(Report const& build)
    {
        pugi::xml_node node = test("Build.CompilesAndLinks");
        if (build.at("ok").get<bool>())
            return;
        std::string text;
        for (auto const& d : build.at("diagnostics"))
            text += fmt::format("{}:{}: {}: {}\n", d.at("file").get<std::string>(), d.at("line").get<int>(),
                                d.at("severity").get<std::string>(), d.at("message").get<std::string>());
        fail(node, "failure", text);
    }

    void add_function(std::string const& name, Report const& function)
    {
        std::string const verdict = function.at("verdict");
        bool const ended_badly = verdict == "crashed" || verdict == "timed_out";
        for (auto const& check : function.at("checks")) {
            pugi::xml_node node = test(check.at("name"));
            if (!builds_)
                fail(node, "failure", say(no_build, language_));
            else if (verdict == "missing")
                fail(node, "failure", name + " " + say(not_written, language_));
            else if (!check.at("passed").get<bool>())
                fail(node, ended_badly ? "error" : "failure", explain_check(check, language_));
        }
    }

    void add_picture(Report const& picture)
    {
        pugi::xml_node node = test("Pictures." + picture.at("name").get<std::string>());
        if (picture.at("score").is_number() && picture.at("score").get<double>() >= 1)
            return;
        auto const count = [&](char const* key) {
            return picture.at(key).is_number() ? picture.at(key).dump() : std::string("?");
        };
        fail(node, "failure", fmt::format(fmt::runtime(say(pixels, language_)), count("outside"), count("limit")));
        for (char const* file : {"submitted_file", "expected_file", "difference_file"})
            if (picture.at(file).is_string())
                node.append_child("system-out").text() =
                    fmt::format("[[ATTACHMENT|{}{}]]", folder_, picture.at(file).get<std::string>()).c_str();
    }

    bool many_;
    Language language_;
    std::string prefix_;
    std::string folder_;  ///< where the pictures' folder is
    bool builds_ = true;
    pugi::xml_document document_;
    pugi::xml_node root_;
    pugi::xml_node suite_;
    int tests_ = 0;
    int failures_ = 0;
    int errors_ = 0;
};
}  // namespace

std::string to_junit(std::vector<NamedReport> const& reports, Language language)
{
    Suite suite(reports.size() > 1, language);
    for (auto const& report : reports)
        suite.add(report);
    return suite.print();
}
}  // namespace testat
