// A rubric.json from anywhere is refused, or makes sense.
#include "json_schema.h"
#include "process/run.h"
#include "report/report.h"
#include "rubric/rubric.h"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    namespace fs = std::filesystem;
    static testat::TemporaryDirectory const place;  // its schema lies beside a rubric
    fs::path const schema = place.path() / "rubric.schema.json";
    if (!fs::exists(schema))
        fs::copy_file(TESTAT_REPOSITORY "/references/rubric.schema.json", schema);
    fs::path const file = place.path() / "rubric.json";
    testat::write_file(file, std::string(reinterpret_cast<char const*>(data), size));
    try {
        testat::only_public(testat::read_rubric(file));
    } catch (testat::BadJson const&) {
    } catch (testat::BadRubric const&) {  // as they say
    }
    return 0;
}
