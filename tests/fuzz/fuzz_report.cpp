// A report.json from anywhere is refused, or can be shown.
#include "file_in_memory.h"
#include "json_schema.h"
#include "report/report.h"
#include "report/text.h"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    FileInMemory const file(data, size);
    try {
        testat::Report const report =
            testat::read_report(file.path(), TESTAT_REPOSITORY "/references/report.schema.json");
        testat::report_to_text(report, testat::Language::de);
        testat::to_text(report);
    } catch (testat::BadJson const&) {  // as it says
    }
    return 0;
}
