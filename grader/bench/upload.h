#pragma once
#include "bench/measure.h"
#include "installation.h"
#include "model.h"
#include "sandbox/cage.h"

#include <map>

/// The filters of an upload. It runs in the cage, through the probe, which also takes the time; the solution answers
/// the same questions in the same way, because a call through the probe takes longer than one of ours.
namespace testat::bench {
/// What can be asked, by its id.
struct UploadFilter {
    std::string id;  ///< "upload_trilinear", "caged_trilinear" for the solution
    Title title;
    Function function;
    bool is_upload;
};
std::vector<UploadFilter> const& upload_filters();

/// By id; what the upload has not written, or did not finish, is missing. `seconds` comes from the child that runs the
/// upload, and may be a lie: it is finite and not negative, 0 if it is impossible. Colours may be anything.
using UploadMeasured = std::map<std::string, Measured>;

/// One for each of `views`. Throws std::runtime_error when something of ours fails.
std::vector<UploadMeasured> measure_upload(Build const& build, TextureData const& texture,
                                           std::vector<Footprints const*> const& views, int rounds,
                                           Installation const& where, Cage& cage);

/// Worst errors by id, one for each decade; infinite where there is no answer.
std::map<std::string, std::vector<double>> float_errors_of_upload(Build const& build, Installation const& where,
                                                                  Cage& cage);
}  // namespace testat::bench
