#pragma once
#include "report/png.h"
#include "report/text.h"

#include <filesystem>
#include <string>

/// `testat diff A B`: two reports or two pictures.
namespace testat {
struct Difference {
    bool same = false;
    std::string text;  ///< for people, whether or not they differ
};

/// What two reports (report.json) say otherwise, apart from times: points, verdicts, checks, pictures. Or how far two
/// PNG pictures are apart, in steps of 8 bits. Throws std::invalid_argument for files that are neither or cannot be
/// read, and for one of each.
Difference diff(std::filesystem::path const& a, std::filesystem::path const& b, Language language);

/// Of reports that are valid, and of decoded pictures.
Difference diff_reports(Report const& a, Report const& b, Language language);
Difference diff_pictures(Bitmap const& a, Bitmap const& b, Language language);
}  // namespace testat
