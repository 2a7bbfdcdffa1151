// Makes the envelope of every assignment picture: make_envelopes REFERENCE.so ASSETS OUT
#include "envelopes/envelope.h"
#include "envelopes/perturbed.h"
#include "envelopes/pictures.h"
#include "probe/answer.h"
#include "probe/slots.h"
#include "progress.h"
#include "report/pictures.h"
#include "report/report.h"

#include <cglib/rt/assignment_images.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>

namespace {
using namespace testat;

/// Texels jump, so it takes more renderings to see what may happen.
constexpr std::uint64_t renderings = 24;
constexpr std::uint64_t renderings_of_nearest = 48;

double cpu_ms()
{
    timespec now = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

Picture render(std::string const& name, std::uint64_t seed, AssetLibrary& assets)
{
    set_perturbation_seed(seed);
    Answers answers{picture_group(name), {}, {}};
    answers.status.ended = Ended::answered;
    answers.words.assign(answers.group.answer_size(), unanswered);
    std::uint32_t answered = 0;
    answer(answers.group, {}, assets, answers.words.data(), &answered);
    return read_picture(answers).value();
}

/// The reference's own CPU time, minimum of nine.
double time_reference(std::string const& name, AssetLibrary& assets)
{
    double best = 1e9;
    for (int i = 0; i < 9; ++i) {
        double const start = cpu_ms();
        render(name, 0, assets);
        best = std::min(best, cpu_ms() - start);
    }
    return best;
}

void make(std::string const& name, bool nearest, AssetLibrary& assets, std::filesystem::path const& out)
{
    constexpr std::size_t boxes_of_nearest = 4;
    EnvelopeBuilder builder(nearest ? boxes_of_nearest : 1);
    for (std::uint64_t seed = 0; seed <= (nearest ? renderings_of_nearest : renderings); ++seed)
        builder.add(render(name, seed, assets));
    Envelope const envelope = builder.finish(time_reference(name, assets));
    write_envelope(envelope, out / (name + ".envelope"));
    write_file(out / (name + ".png"), encode_picture(name, envelope.expected));
}
}  // namespace

int main(int argc, char** argv)
{
    if (argc != 4)
        return std::fputs("usage: make_envelopes REFERENCE.so ASSETS OUT\n", stderr), 2;
    try {
        fill_slots(load_library(argv[1]), FunctionSet::all());
        perturb_slots();
        AssetLibrary assets(argv[2]);
        std::filesystem::create_directories(argv[3]);
        Progress progress("Envelopes", assignment_images().size() + 1);
        for (auto const& image : assignment_images()) {
            make(image.name, image.params.tex_filter_mode == NEAREST, assets, argv[3]);
            progress.step(image.name);
        }
        make(miplevels, false, assets, argv[3]);
        progress.step(miplevels);
        return 0;
    } catch (std::exception const& e) {
        std::fprintf(stderr, "make_envelopes: %s\n", e.what());
        return 1;
    }
}
