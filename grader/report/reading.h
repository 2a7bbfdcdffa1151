#pragma once
#include "report/printer.h"

#include <optional>

namespace testat {
/// What a reader should do first: the mistake that costs most.
struct FirstFix {
    std::string function;  ///< bare name; empty where it is the file
    int line = 0;          ///< of the function or the error; 0 if nobody knows
    Phrase what;           ///< what is wrong
    Phrase hint;           ///< what to do; may be empty
    double lost = 0;       ///< points of the function; of the file if there is no function
};

/// What all ways of showing a graded report to people ask of it.
class Reading {
public:
    explicit Reading(Report const& report) : report_(report) {}

    bool builds() const { return report_.at("build").at("ok").get<bool>(); }
    bool has_unofficial() const { return report_.contains("unofficial"); }
    bool was_run() const { return has_unofficial() || !report_.at("run_time").empty() || builds(); }
    bool is_public_only() const;
    bool applies(char const* policy) const;

    /// The function as the table shows it, unofficial where there is that; null if it is broken.
    Report const* graded(std::string const& name) const;
    double earned_by(std::string const& name) const;
    double earned_in(Report const& task) const;
    double lost_by(std::string const& name) const;
    Term word_for(std::string const& name) const;

    /// What is not as it should be with a picture as submitted or in isolation; empty if all is well.
    std::string finding(Report const& picture, Language language) const;

    /// The part of it that does not depend on other functions of the file: how far the picture is off in isolation.
    std::string finding_alone(Report const& picture, Language language) const;

    /// What tutors have changed, a line each: "wrap_repeat: 0.50 -> 1.00, reason (who, when)".
    std::vector<std::string> by_hand() const;

    /// Nothing if there is nothing to fix.
    std::optional<FirstFix> first_fix() const;

private:
    bool is_unwritten(Report const& picture) const;
    bool is_missing(std::string const& name) const;
    bool costs_everything(std::string const& name) const;
    FirstFix fix_of_build() const;
    FirstFix fix_of(std::string const& name) const;
    std::optional<std::string> function_to_fix() const;

    Report const& report_;
};

/// "a, b"
std::string join(Report const& names);

/// The first check that has something to say; null if none has.
Report const* first_hint(Report const& function);
}  // namespace testat
