#pragma once
#include "batch/batch.h"
#include "batch/similarity.h"

namespace testat {
/// A page for tutors about the whole batch, in both languages: a table that sorts, filters and searches, histograms,
/// groups of the same mistake, and a link to each report.html in reports/. Needs nothing but itself; `language` is the
/// one it begins with.
std::string overview_page(std::vector<GradedUpload> const& entries, std::vector<SimilarPair> const& similar,
                          std::string const& title, Language language);
}  // namespace testat
