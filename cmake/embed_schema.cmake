# cmake -DINPUT=mechanism.schema.json -DOUTPUT=mechanism_schema.cpp -P embed_schema.cmake: embeds the schema as text.
file(READ ${INPUT} text)
if(text MATCHES "\\)schema\"")
    message(FATAL_ERROR "${INPUT} holds )schema\", which would end the literal")
endif()
file(WRITE ${OUTPUT} "// Made from engine/reading/mechanism.schema.json by cmake/embed_schema.cmake.
#include \"engine/reading/mechanism_schema.hpp\"

namespace kinegraph {

constinit const std::string_view mechanism_schema_text = R\"schema(${text})schema\";

}  // namespace kinegraph
")
