// verdict: {"loses": {"wrap_repeat": [1, 1]}, "says": {"wrap_repeat": "wrong"}, "policy": [], "remarks": ["depends_on_earlier_calls"]}
// State between calls: the sum is never set back to zero.
int ImageTexture::wrap_repeat(int val, int size)
{
    static int sum;
    sum += val % size;
    return (sum % size + size) % size;
}
