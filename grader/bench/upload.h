#pragma once
#include "bench/measure.h"
#include "installation.h"
#include "model.h"
#include "sandbox/cage.h"

#include <map>
#include <set>

/// The filters of an upload. It runs in the cage, through the probe, which also takes the time; the solution answers
/// the same questions in the same way, because a call through the probe takes another time than one of ours.
namespace testat::bench {
/// What can be asked, by its id.
struct UploadFilter {
    std::string id;  ///< "upload_trilinear", "caged_trilinear" for the solution
    Title title;
    Function function;
    bool is_upload;
};
std::vector<UploadFilter> const& upload_filters();

using FilterIds = std::set<std::string>;

/// Those that the upload has written and that come to an end with a few of these footprints; of ours, all.
FilterIds answering_filters(Build const& build, TextureData const& texture, Footprints const& footprints,
                            Installation const& where, Cage& cage);

/// By id; what the upload did not finish is missing. `seconds` comes from the child that runs the upload, and may be a
/// lie: it is finite and not negative, 0 if it is impossible. Colours may be anything.
std::map<std::string, Measured> measure_upload(Build const& build, FilterIds const& asked, TextureData const& texture,
                                               Footprints const& footprints, int rounds, Installation const& where,
                                               Cage& cage);

/// Worst errors by id, one for each decade; infinite where there is no answer.
std::map<std::string, std::vector<double>> float_errors_of_upload(Build const& build, FilterIds const& asked,
                                                                  Installation const& where, Cage& cage);
}  // namespace testat::bench
