#include "bench/bench.h"

#include "bench/errors.h"
#include "bench/float_error.h"
#include "bench/measure.h"
#include "bench/scenes.h"
#include "bench/truth_cache.h"
#include "bench/upload.h"
#include "progress.h"

#include <algorithm>

namespace testat::bench {
namespace {
struct Picture {
    Scene const* scene;
    View view;
    std::vector<Truth> truths;  ///< one for each sheet
};

Score score(Measured const& measured, Truth const& truth)
{
    return {1e9 * measured.seconds / double(truth.size()), rmse(measured.colours, truth),
            mean_delta_e(measured.colours, truth)};
}

std::vector<LookUp> prepare(TextureData const& texture)
{
    std::vector<LookUp> prepared;
    for (auto const& filter : filters())
        prepared.push_back(filter.prepare(texture));
    return prepared;
}

class Bench {
public:
    Bench(CagedUpload upload, BenchOptions const& options, Installation const& where)
        : upload_(upload), where_(where), sheets_(make_sheets())
    {
        results_.picture_side = options.quick ? 64 : 128;
        results_.rounds = options.quick ? 3 : 9;
        for (auto const& filter : filters())
            results_.filters.push_back({filter.id, filter.title, filter.family});
        if (upload_.build != nullptr)
            for (auto const& filter : upload_filters())
                results_.filters.push_back({filter.id, filter.title, Family::upload});
    }

    BenchResults run()
    {
        Progress progress("Bench", scenes().size() + sheets_.size() + 1);
        for (auto const& scene : scenes()) {
            View view = look_at(scene, results_.picture_side);
            std::vector<Truth> truths = truth_of(scene, view, sheets_, truth_directory());
            pictures_.push_back({&scene, std::move(view), std::move(truths)});
            progress.step(scene.id);
        }
        for (std::size_t i = 0; i < sheets_.size(); ++i) {
            measure_sheet(i);
            progress.step(sheets_[i].pattern);
        }
        find_float_errors();
        progress.step("float");
        return std::move(results_);
    }

private:
    void measure_sheet(std::size_t number)
    {
        Sheet const& sheet = sheets_[number];
        std::vector<LookUp> const prepared = prepare(sheet.texture);
        std::size_t const first = results_.cases.size();
        for (auto const& picture : pictures_) {
            Case found{picture.scene->id, sheet.pattern, sheet.side(), picture.view.pixels.size(), {}};
            auto const measured = measure(prepared, picture.view.footprints, results_.rounds);
            for (std::size_t i = 0; i < measured.size(); ++i)
                found.scores[filters()[i].id] = score(measured[i], picture.truths[number]);
            results_.cases.push_back(std::move(found));
        }
        if (upload_.build != nullptr)
            measure_upload_on(number, first);
    }

    /// All pictures of a texture at once, because every group makes its textures anew; they share their mean time.
    void measure_upload_on(std::size_t number, std::size_t first_case)
    {
        Footprints all;
        for (auto const& picture : pictures_)
            all.insert(all.end(), picture.view.footprints.begin(), picture.view.footprints.end());
        TextureData const& texture = sheets_[number].texture;
        if (number == 0)
            asked_ = answering_filters(*upload_.build, texture, all, where_, *upload_.cage);
        auto const measured =
            measure_upload(*upload_.build, asked_, texture, all, results_.rounds, where_, *upload_.cage);
        for (auto const& [id, one] : measured)
            split(id, one, number, first_case);
        // What has not come to an end once has no score, and is not waited for again.
        for (auto const& filter : upload_filters())
            if (measured.count(filter.id) == 0)
                asked_.erase(filter.id);
    }

    void split(std::string const& id, Measured const& all, std::size_t number, std::size_t first_case)
    {
        auto begin = all.colours.begin();
        for (std::size_t i = 0; i < pictures_.size(); ++i) {
            Truth const& truth = pictures_[i].truths[number];
            auto const end = begin + std::ptrdiff_t(truth.size());
            double const share = double(truth.size()) / double(all.colours.size());
            results_.cases[first_case + i].scores[id] = score({all.seconds * share, Colours(begin, end)}, truth);
            begin = end;
        }
    }

    void find_float_errors()
    {
        for (auto const& filter : filters()) {
            bool const trilinear = filter.id.find("trilinear") != std::string::npos;
            bool const bilinear = filter.id.find("bilinear") != std::string::npos;
            if (!trilinear && !bilinear)
                continue;
            for (int decade = 0; decade < decades; ++decade) {
                auto const far =
                    far_lookups(trilinear ? Function::evaluate_trilinear : Function::evaluate_bilinear, decade);
                results_.float_errors[filter.id].push_back(
                    worst_error(ask(filter.prepare(far.textures[0]), far.group), far.textures));
            }
        }
        if (upload_.build != nullptr)
            results_.float_errors.merge(float_errors_of_upload(*upload_.build, asked_, where_, *upload_.cage));
    }

    CagedUpload upload_;
    Installation const& where_;
    std::vector<Sheet> sheets_;
    std::vector<Picture> pictures_;
    FilterIds asked_;  ///< of the upload
    BenchResults results_;
};
}  // namespace

BenchResults run_bench(CagedUpload upload, BenchOptions const& options, Installation const& where)
{
    return Bench(upload, options, where).run();
}
}  // namespace testat::bench
