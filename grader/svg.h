#pragma once
#include <fmt/format.h>

#include <string>

namespace testat {
/// Writes SVG without anything from elsewhere, line by line.
class Svg {
public:
    /// Text as it may stand in an element or an attribute.
    static std::string escaped(std::string const& text)
    {
        std::string safe;
        for (char c : text)
            safe += c == '&'   ? "&amp;"
                    : c == '<' ? "&lt;"
                    : c == '>' ? "&gt;"
                    : c == '"' ? "&quot;"
                               : std::string(1, c);
        return safe;
    }

protected:
    template <typename... Arguments>
    void add(fmt::format_string<Arguments...> format, Arguments&&... arguments)
    {
        out_ += fmt::format(format, std::forward<Arguments>(arguments)...) + "\n";
    }

    /// `anchor`: start, middle or end. `more`: further attributes, with a space before each.
    void label(double x, double y, char const* anchor, std::string const& text, char const* more = "")
    {
        add(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}"{}>{}</text>)", x, y, anchor, more, escaped(text));
    }

    void line(double x0, double y0, double x1, double y1, char const* style)
    {
        add(R"(<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}" {}/>)", x0, y0, x1, y1, style);
    }

    /// 10 to a power, as people write it.
    void power_of_ten(double x, double y, char const* anchor, int exponent)
    {
        add(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">10<tspan dy="-5" font-size="10">{}{}</tspan></text>)", x, y,
            anchor, exponent < 0 ? "−" : "", exponent < 0 ? -exponent : exponent);
    }

    std::string out_;
};
}  // namespace testat
