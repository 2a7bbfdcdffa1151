#pragma once
#include "report/formats/format.h"

namespace testat {
/// What a page shows of the pictures: `wrong` in full, as submitted and as expected, with a small one of the
/// difference; `right` small. Files that are not there, or no PNG, are left out, and so is what would make the page
/// larger than ILIAS likes.
Report picture_views(NamedReport const& named);
}  // namespace testat
