#include "protocol/request.h"

#include <stdexcept>

namespace testat {
namespace {
class Writer {
public:
    template <typename T>
    void value(T const& v)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes(&v, sizeof v);
    }
    template <typename T>
    void list(std::vector<T> const& v)
    {
        value(std::uint64_t(v.size()));
        bytes(v.data(), v.size() * sizeof(T));
    }
    void bytes(void const* data, std::size_t size)
    {
        auto const* begin = static_cast<std::byte const*>(data);
        out.insert(out.end(), begin, begin + size);
    }
    std::vector<std::byte> out;
};

class Reader {
public:
    explicit Reader(std::vector<std::byte> const& bytes) : bytes_(bytes) {}

    template <typename T>
    T value()
    {
        T v;
        std::memcpy(&v, take(sizeof v), sizeof v);
        return v;
    }
    template <typename T>
    std::vector<T> list()
    {
        auto const count = value<std::uint64_t>();
        if (count > remaining() / sizeof(T))
            throw std::runtime_error("request: a list is longer than the message");
        std::vector<T> v(count);
        if (count > 0)
            std::memcpy(v.data(), take(count * sizeof(T)), count * sizeof(T));
        return v;
    }
    std::size_t remaining() const { return bytes_.size() - position_; }

private:
    std::byte const* take(std::size_t size)
    {
        if (size > remaining())
            throw std::runtime_error("request: the message is cut short");
        std::byte const* at = bytes_.data() + position_;
        position_ += size;
        return at;
    }
    std::vector<std::byte> const& bytes_;
    std::size_t position_ = 0;
};

std::vector<char> letters(std::string const& text)
{
    return {text.begin(), text.end()};
}

void write(Writer& out, TextureData const& texture)
{
    out.value(texture.wrap_mode);
    out.value(std::uint64_t(texture.levels.size()));
    for (auto const& level : texture.levels) {
        out.value(level.width);
        out.value(level.height);
        out.list(level.texels);
    }
}

TextureData read_texture(Reader& in)
{
    TextureData texture;
    texture.wrap_mode = in.value<std::uint32_t>();
    auto const levels = in.value<std::uint64_t>();
    for (std::uint64_t i = 0; i < levels; ++i) {
        TextureData::Level level;
        level.width = in.value<std::int32_t>();
        level.height = in.value<std::int32_t>();
        level.texels = in.list<float>();
        texture.levels.push_back(std::move(level));
    }
    return texture;
}

void write(Writer& out, Group const& group)
{
    out.list(letters(group.name));
    out.value(group.from_upload);
    out.value(group.under_test);
    out.value(group.kind);
    out.value(group.count);
    out.value(group.words_per_answer);
    out.value(std::uint32_t(group.culling));
    out.value(group.fill);
    out.value(std::uint32_t(group.twice));
    out.value(group.passes);
    out.list(group.questions);
}

Group read_group(Reader& in)
{
    Group group;
    auto const name = in.list<char>();
    group.name.assign(name.begin(), name.end());
    group.from_upload = in.value<FunctionSet>();
    group.under_test = in.value<Function>();
    group.kind = in.value<Kind>();
    group.count = in.value<std::uint32_t>();
    group.words_per_answer = in.value<std::uint32_t>();
    group.culling = in.value<std::uint32_t>() != 0;
    group.fill = in.value<std::uint32_t>();
    group.twice = in.value<std::uint32_t>() != 0;
    group.passes = in.value<std::uint32_t>();
    group.questions = in.list<std::byte>();
    if (group.kind >= Kind::count || group.fill > 255 || group.passes > most_passes ||
        group.questions.size() != std::size_t(group.count) * question_bytes(group.kind))
        throw std::runtime_error("request: group " + group.name + " is malformed");
    return group;
}
}  // namespace

std::vector<std::byte> serialize(Request const& request, Limits const& limits)
{
    Writer out;
    out.value(limits);
    out.value(request.hanging);
    out.value(std::uint64_t(request.textures.size()));
    for (auto const& texture : request.textures)
        write(out, texture);
    out.value(std::uint64_t(request.groups.size()));
    for (auto const& group : request.groups)
        write(out, group);
    return std::move(out.out);
}

Request parse_request(std::vector<std::byte> const& bytes)
{
    Reader in(bytes);
    Request request;
    request.limits = in.value<Limits>();
    request.hanging = in.value<FunctionSet>();
    auto const textures = in.value<std::uint64_t>();
    for (std::uint64_t i = 0; i < textures; ++i)
        request.textures.push_back(read_texture(in));
    auto const groups = in.value<std::uint64_t>();
    for (std::uint64_t i = 0; i < groups; ++i)
        request.groups.push_back(read_group(in));
    if (in.remaining() != 0)
        throw std::runtime_error("request: bytes are left over at the end");
    return request;
}
}  // namespace testat
