// verdict: {"broken": {"wrap_clamp": "std::sort(candidates"}, "unofficial": [19, 19]}
// The error is in a header, in a template that only this line uses.
int ImageTexture::wrap_clamp(int val, int size)
{
    struct Candidate {
        int index;
    };
    Candidate candidates[3] = {{0}, {val}, {size - 1}};
    std::sort(candidates, candidates + 3);
    return candidates[1].index;
}
