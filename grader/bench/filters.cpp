#include "bench/filters.h"

namespace testat::bench {
std::vector<Filter> const& filters()
{
    static std::vector<Filter> const all = {
        {"reference_nearest",
         {"nearest, Referenz", "nearest, reference"},
         Family::reference,
         prepare_reference_nearest},
        {"reference_bilinear",
         {"bilinear, Referenz", "bilinear, reference"},
         Family::reference,
         prepare_reference_bilinear},
        {"reference_trilinear",
         {"trilinear, Referenz", "trilinear, reference"},
         Family::reference,
         prepare_reference_trilinear},
        {"fast_nearest", {"nearest, SSE", "nearest, SSE"}, Family::fast, prepare_fast_nearest},
        {"fast_bilinear", {"bilinear, SSE", "bilinear, SSE"}, Family::fast, prepare_fast_bilinear},
        {"fast_trilinear", {"trilinear, SSE", "trilinear, SSE"}, Family::fast, prepare_fast_trilinear},
        {"ripmap", {"Ripmap", "ripmap"}, Family::beyond, prepare_ripmap},
        {"anisotropic_4",
         {"anisotrop, 4 Proben", "anisotropic, 4 probes"},
         Family::beyond,
         [](TextureData const& t) { return prepare_anisotropic(t, 4); }},
        {"anisotropic_16",
         {"anisotrop, 16 Proben", "anisotropic, 16 probes"},
         Family::beyond,
         [](TextureData const& t) { return prepare_anisotropic(t, 16); }},
        {"ewa", {"EWA", "EWA"}, Family::beyond, prepare_ewa},
        {"supersampling_4",
         {"Überabtastung, 4", "supersampling, 4"},
         Family::beyond,
         [](TextureData const& t) { return prepare_supersampling(t, 2); }},
        {"supersampling_16",
         {"Überabtastung, 16", "supersampling, 16"},
         Family::beyond,
         [](TextureData const& t) { return prepare_supersampling(t, 4); }},
    };
    return all;
}
}  // namespace testat::bench
