#pragma once
#include "report/report.h"

#include <string>
#include <string_view>

/// Pages for people: HTML files that need nothing but themselves.
namespace testat {
/// What a page is made of. Its style and its script are the only ones that a browser runs in it: the page's policy
/// names their hashes and forbids everything else, whatever an upload may have put into the texts.
class Page {
public:
    /// `html` is a Mustache template in which [[Deutsch|English]] stands for words in both languages. {{{style}}},
    /// {{{script}}} and {{{policy}}} are what belongs there. Style and script follow those that all pages share.
    Page(std::string_view html, std::string const& style, std::string const& script);

    /// Texts of `view` are escaped, but for {{{...}}}; what is null or false is not there. Throws std::logic_error if
    /// the template is none.
    std::string render(Report view) const;

private:
    std::string html_;
    std::string style_;
    std::string script_;
    std::string policy_;
};

/// Of bytes, as data: addresses and policies want it.
std::string base64(std::string_view bytes);

/// A name as a part of an address: letters and digits, the rest as %XX.
std::string url_part(std::string_view name);
}  // namespace testat
