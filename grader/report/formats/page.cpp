#include "report/formats/page.h"

#include "text.h"

#include <fmt/format.h>
#include <nettle/base64.h>

#include <kainjow/mustache.hpp>
#include <stdexcept>

namespace testat {
namespace {
namespace mustache = kainjow::mustache;

constexpr char shared_style[] =
#include "report/formats/page.css.inc"
    ;
constexpr char shared_script[] =
#include "report/formats/page.js.inc"
    ;

/// [[Deutsch|English]] becomes an element for each language; style shows one of them.
std::string in_both_languages(std::string_view html)
{
    std::string out;
    for (std::size_t at = 0;;) {
        std::size_t const begin = html.find("[[", at);
        out += html.substr(at, begin - at);
        if (begin == std::string_view::npos)
            return out;
        std::size_t const bar = html.find('|', begin);
        std::size_t const end = html.find("]]", begin);
        if (end == std::string_view::npos || bar > end)
            throw std::logic_error("a template has words in one language only");
        out += fmt::format("<span lang=\"de\">{}</span><span lang=\"en\">{}</span>",
                           html.substr(begin + 2, bar - begin - 2), html.substr(bar + 1, end - bar - 1));
        at = end + 2;
    }
}

std::string hash_source(std::string const& text)
{
    std::string const digits = sha256(text);
    std::string bytes;
    for (std::size_t i = 0; i < digits.size(); i += 2)
        bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
    return "'sha256-" + base64(bytes) + "'";
}

mustache::data to_data(Report const& view)
{
    if (view.is_object()) {
        mustache::data object;
        for (auto const& [key, value] : view.items())
            object[key] = to_data(value);
        return object;
    }
    if (view.is_array()) {
        mustache::data list(mustache::data::type::list);
        for (auto const& value : view)
            list.push_back(to_data(value));
        return list;
    }
    if (view.is_string())
        return view.get_ref<std::string const&>();
    return view.is_number() ? mustache::data(view.dump()) : mustache::data(view.is_boolean() && view.get<bool>());
}
}  // namespace

Page::Page(std::string_view html, std::string const& style, std::string const& script)
    : html_(in_both_languages(html)), style_(shared_style + style), script_(shared_script + script)
{
    policy_ = fmt::format(
        "default-src 'none'; img-src data:; style-src {}; script-src {}; base-uri 'none'; form-action 'none'",
        hash_source(style_), hash_source(script_));
}

std::string Page::render(Report view) const
{
    view["style"] = style_;
    view["script"] = script_;
    view["policy"] = policy_;
    mustache::mustache page(html_);
    std::string out = page.render(to_data(view));
    if (!page.is_valid())
        throw std::logic_error("a template: " + page.error_message());
    return out;
}

std::string base64(std::string_view bytes)
{
    std::string out(BASE64_ENCODE_RAW_LENGTH(bytes.size()), '\0');
    base64_encode_raw(out.data(), bytes.size(), reinterpret_cast<std::uint8_t const*>(bytes.data()));
    return out;
}

std::string url_part(std::string_view name)
{
    std::string out;
    for (char c : name) {
        auto const byte = static_cast<unsigned char>(c);
        bool const plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
        out += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
    }
    return out;
}
}  // namespace testat
