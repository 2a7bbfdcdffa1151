#pragma once
#include "answers.h"
#include "checks/random.h"
#include "checks/textures.h"
#include "model.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace testat {
/// One float result against what is right: how far off it is, in units of what is allowed.
struct Deviation {
    double in_bounds = 0;  ///< at most 1 is right; NaN and infinity count as wrong
    std::string measured;
    std::string expected;
    /// False where float may come to any answer, as in a hit that is a graze: only NaN and infinity are wrong there.
    bool decided = true;
};

/// Collects the answers of a check and keeps the worst one.
class Verdict {
public:
    /// Written so that NaN fails.
    void offer(std::uint32_t question, Deviation const& deviation)
    {
        bool const not_finite = !(deviation.in_bounds < HUGE_VAL);
        double const rank = not_finite ? HUGE_VAL : deviation.in_bounds;
        if (rank > error_) {
            question_ = question;
            error_ = rank;
            deviation_ = deviation;
        }
    }
    bool passed() const { return error_ <= 1; }
    double error() const { return error_; }  ///< of the answer that is farthest off, in units of what is allowed
    std::uint32_t question() const { return question_; }
    Deviation const& deviation() const { return deviation_; }

private:
    std::uint32_t question_ = 0;
    double error_ = 0;
    Deviation deviation_;
};

/// A unit check: what it asks, and how it judges the answers.
struct UnitCheck {
    std::string name;  ///< "Subject.Claim": GoogleTest case, rubric key, name of the group
    Function function;
    std::function<Group(Random&, Textures const&)> ask;  ///< fills kind, count, questions and words_per_answer
    std::function<Verdict(Answers const&, Textures const&)> judge;
    bool is_metamorphic = false;
};

/// Every unit check, in the order of the sheet. All but the metamorphic ones ask as many questions again that depend
/// on the upload, or of unknown textures, so that a table of known answers is worth nothing in any of them.
std::vector<UnitCheck> const& unit_checks();

/// Judges question by question: `deviation(question, index)` for each.
template <typename Question, typename DeviationOf>
Verdict judge_each(Answers const& answers, DeviationOf const& deviation)
{
    Verdict verdict;
    for (std::uint32_t i = 0; i < answers.group.count; ++i)
        verdict.offer(i, deviation(question<Question>(answers.group, i), i));
    return verdict;
}

/// When a Deviation is put into words, which takes ten times as long as finding it.
enum class Words { always, for_mistakes };

/// Compares components, each with its bound. NaN and infinity are wrong whatever the bound is.
Deviation compare(std::vector<double> const& measured, std::vector<double> const& expected,
                  std::vector<double> const& bound, Words words = Words::always);

/// "(0.25, -1, 3)"
std::string format_vector(std::vector<double> const& v);

/// The question as a student can try it at home, in names of the framework and so the same in every language.
std::string describe_question(Group const& group, std::uint32_t index, Textures const& textures);

void add_evaluate_nearest_checks(std::vector<UnitCheck>& checks);
void add_wrap_checks(std::vector<UnitCheck>& checks);
void add_evaluate_bilinear_checks(std::vector<UnitCheck>& checks);
void add_create_mipmap_checks(std::vector<UnitCheck>& checks);
void add_compute_uv_aabb_size_checks(std::vector<UnitCheck>& checks);
void add_evaluate_trilinear_checks(std::vector<UnitCheck>& checks);
void add_transform_checks(std::vector<UnitCheck>& checks);
void add_intersect_checks(std::vector<UnitCheck>& checks);
void add_tangent_space_checks(std::vector<UnitCheck>& checks);
}  // namespace testat
