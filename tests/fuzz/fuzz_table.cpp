// The sheet of an xlsx from anywhere has rows, or is refused; any rows can be joined.
#include "batch/table.h"

#include <cstdlib>
#include <stdexcept>

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    std::vector<std::string> const persons = {"Name_Vorname_login", "M_ller_J_rg_b_c", "____", ""};
    std::string const xml(reinterpret_cast<char const*>(data), size);
    try {
        std::string const strings = "<sst><si><t>Vorname</t></si><si><t>login</t></si></sst>";
        testat::Joined const joined = testat::join(testat::read_sheet(xml, strings), persons);
        if (joined.submitters.size() != persons.size())
            std::abort();
    } catch (std::invalid_argument const&) {  // as it says
    }
    return 0;
}
