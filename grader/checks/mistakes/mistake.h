#pragma once
#include "answers.h"
#include "checks/check.h"
#include "rubric/rubric.h"

#include <functional>
#include <string>
#include <vector>

/// Wrong solutions that students write, as oracles in double. Their words are in the rubric.
namespace testat {
/// One way to make a mistake. It says yes to an answer that comes out when the mistake is made, and nothing else.
struct Model {
    std::function<bool(Answers const&, std::uint32_t index, Textures const&)> explains;
    /// Whether the mistake leaves the language with this question, so that the process may die of it, or the function
    /// throw. Never if empty.
    std::function<bool(Group const&, std::uint32_t index, Textures const&)> may_crash;
};

/// A mistake with a name. Students make the same one in different ways.
struct Mistake {
    std::string id;
    Function function;
    std::vector<Model> models;
};

/// The whole catalogue, in the order of the sheet.
std::vector<Mistake> const& mistakes();

/// The mistake that explains every answer to every check of the function that was asked; empty if none does, or if
/// several do. A check that has ended by a signal or an
/// exception is explained by a model that may crash at the question it ended with.
/// Functions without a failed check have no mistake.
std::map<Function, std::string> name_mistakes(CheckResults const& results, Observations const& observations,
                                              Textures const& textures);

void add_wrap_mistakes(std::vector<Mistake>& mistakes);
void add_evaluate_nearest_mistakes(std::vector<Mistake>& mistakes);
void add_evaluate_bilinear_mistakes(std::vector<Mistake>& mistakes);
void add_create_mipmap_mistakes(std::vector<Mistake>& mistakes);
void add_compute_uv_aabb_size_mistakes(std::vector<Mistake>& mistakes);
void add_evaluate_trilinear_mistakes(std::vector<Mistake>& mistakes);
void add_transform_mistakes(std::vector<Mistake>& mistakes);
void add_intersect_mistakes(std::vector<Mistake>& mistakes);
void add_tangent_space_mistakes(std::vector<Mistake>& mistakes);
}  // namespace testat
