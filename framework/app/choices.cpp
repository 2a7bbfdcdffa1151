#include "choices.h"

std::map<std::string, TextureFilterMode> const& filter_choices()
{
    static std::map<std::string, TextureFilterMode> const choices = {{"nearest", NEAREST},
                                                                     {"bilinear", BILINEAR},
                                                                     {"trilinear", TRILINEAR},
                                                                     {"debugmip", DEBUG_MIP},
                                                                     {"white", WHITE}};
    return choices;
}

std::map<std::string, TextureWrapMode> const& wrap_choices()
{
    static std::map<std::string, TextureWrapMode> const choices = {
        {"repeat", REPEAT}, {"clamp", CLAMP}, {"zero", ZERO}};
    return choices;
}

std::map<std::string, RenderMode> const& mode_choices()
{
    static std::map<std::string, RenderMode> const choices = {{"recursive", RECURSIVE}, {"desaturate", DESATURATE},
                                                              {"numrays", NUM_RAYS},    {"normal", NORMAL},
                                                              {"time", TIME},           {"dudv", DUDV}};
    return choices;
}

std::vector<Switch> const& switches()
{
    using P = RaytracingParameters;
    static std::vector<Switch> const all = {{"normal_mapping", "Normal mapping", &P::normal_mapping},
                                            {"transform_objects", "Transform objects", &P::transform_objects},
                                            {"shadows", "Shadows", &P::shadows},
                                            {"ambient", "Ambient", &P::ambient},
                                            {"diffuse", "Diffuse", &P::diffuse},
                                            {"specular", "Specular", &P::specular},
                                            {"reflection", "Reflection", &P::reflection},
                                            {"transmission", "Transmission", &P::transmission},
                                            {"fresnel", "Fresnel", &P::fresnel},
                                            {"stratified", "Stratified", &P::stratified}};
    return all;
}
