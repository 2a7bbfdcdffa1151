// verdict: {"loses": {"evaluate_bilinear": [3, 3], "create_mipmap": [1.5, 1.5], "evaluate_trilinear": [1.5, 2], "transform_direction_to_object_space": [2, 2]}, "says": {"evaluate_bilinear": "partial", "create_mipmap": "partial", "evaluate_trilinear": "wrong", "transform_direction_to_object_space": "wrong"}, "policy": [], "by_hand": 11.75, "mistake": {"evaluate_bilinear": "bilinear_is_nearest", "create_mipmap": "mipmap_leaves_levels_empty", "evaluate_trilinear": "trilinear_of_nearest", "transform_direction_to_object_space": "tangent_inverse_rotation"}}
// By GRADING's table of mistakes, the middle where it gives a range:
// evaluate_bilinear is the nearest texel: 3 of 4. create_mipmap does not fill its levels: 1.5 of 2. evaluate_trilinear looks up
// without bilinear: 1.5 to 2 of 2. transform_direction_to_object_space is the inverse rotation: 2 of 2.
// 20 - 3 - 1.5 - 1.75 - 2 = 11.75
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    return evaluate_nearest(level, uv);
}

void ImageTexture::create_mipmap()
{
    int width = mip_levels[0]->getWidth();
    int height = mip_levels[0]->getHeight();
    while (width > 1 || height > 1) {
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        mip_levels.push_back(std::make_shared<Image>(width, height));
    }
}

glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    int const last = int(mip_levels.size()) - 1;
    float const width = float(mip_levels[0]->getWidth());
    float const height = float(mip_levels[0]->getHeight());
    float const S = std::max(dudv.x * width, dudv.y * height);
    if (!(S > 1.f))
        return evaluate_nearest(0, uv);
    float const T = std::log2(S);
    if (T >= float(last))
        return evaluate_nearest(last, uv);
    int const finer = int(std::floor(T));
    return glm::mix(evaluate_nearest(finer, uv), evaluate_nearest(finer + 1, uv), T - float(finer));
}

glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)
{
    return glm::normalize(glm::transpose(glm::mat3(tangent, normal, bitangent)) * d);
}
