#include "json_schema.h"

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include <fstream>

namespace testat {
nlohmann::json read_json(std::filesystem::path const& file)
{
    std::ifstream in(file);
    if (!in || std::filesystem::is_directory(file))
        throw BadJson(file.string() + ": cannot be read");
    try {
        return nlohmann::json::parse(in);
    } catch (nlohmann::json::exception const& e) {
        throw BadJson(file.string() + ": " + e.what());
    }
}

namespace {
/// The first error is the innermost.
std::string describe(valijson::ValidationResults& results)
{
    valijson::ValidationResults::Error error;
    if (!results.popError(error))
        return "breaks its schema";
    std::string place;
    for (auto const& part : error.context)
        place += part;
    return "at " + place + ": " + error.description;
}
}  // namespace

void validate_json(nlohmann::json const& document, std::filesystem::path const& schema_file, std::string const& name)
{
    auto const schema_json = read_json(schema_file);
    valijson::Schema schema;
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(schema_json), schema);
    valijson::ValidationResults results;
    if (!valijson::Validator().validate(schema, valijson::adapters::NlohmannJsonAdapter(document), &results))
        throw BadJson(name + ": " + describe(results));
}
}  // namespace testat
