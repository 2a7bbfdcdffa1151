#pragma once
#include "bench/filters.h"
#include "installation.h"
#include "model.h"
#include "sandbox/cage.h"

#include <map>
#include <string>
#include <vector>

/// `testat bench`: run time against error of texture filters.
namespace testat::bench {
struct BenchOptions {
    bool quick = false;  ///< smaller pictures, fewer rounds
};

/// A filter in one picture, or in several.
struct Score {
    double ns = 0;       ///< CPU time of one lookup; 0 if nobody knows
    double rmse = 0;     ///< linear units; not finite if a colour is not
    double delta_e = 0;  ///< mean CIELAB difference; likewise
};

/// A scene with a texture on it.
struct Case {
    std::string scene;  ///< id, as all that follow
    std::string pattern;
    int texture_side = 0;
    std::size_t pixels = 0;
    std::map<std::string, Score> scores;  ///< by id of the filter
};

struct Named {
    std::string id;
    Title title;
    Family family;
};

struct BenchResults {
    int picture_side = 0;
    int rounds = 0;
    std::vector<Named> filters;  ///< in the order in which they are shown
    std::vector<Case> cases;
    std::map<std::string, std::vector<double>> float_errors;  ///< by filter: worst error in bounds, by decade of |u|
};

/// An upload and the cage that it runs in; both null if there is none.
struct CagedUpload {
    Build const* build = nullptr;
    Cage* cage = nullptr;
};

/// Runs everything. Throws std::runtime_error when something of ours fails.
BenchResults run_bench(CagedUpload upload, BenchOptions const& options, Installation const& where);

/// All cases with this pattern, all of them if it is empty: times are weighted with pixels, errors are not (RMSE
/// squared). A filter that is missing in one of them is missing.
std::map<std::string, Score> mean_scores(BenchResults const& results, std::string const& pattern = "");

/// Filters that no other one beats in both time and RMSE; those without a time or a finite error are not among them.
/// From the fastest to the most accurate.
std::vector<std::string> pareto_front(std::map<std::string, Score> const& scores);

/// The two promises of the bench.
struct Ratios {
    double trilinear_speed_up = 0;       ///< time of the reference's trilinear over the fast one's, all cases
    double trilinear_error = 0;          ///< RMSE of the fast one over the reference's, all cases
    double anisotropic_error = 0;        ///< RMSE of 4 probes over trilinear's, all checker cases
    double worst_anisotropic_error = 0;  ///< in the checker case where it is largest
    double anisotropic_time = 0;         ///< time of 4 probes over the fast trilinear's, all checker cases
};
Ratios ratios(BenchResults const& results);
}  // namespace testat::bench
