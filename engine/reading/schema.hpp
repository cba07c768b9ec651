// The JSON Schema of the mechanism file (draft 7), made from its forms: for editors that complete and check as one
// types. The reader does not validate with it.
#pragma once

#include <string>

#include "engine/reading/form.hpp"

namespace kinegraph {

/// `file`: the form of the whole file.
std::string json_schema_of(const Form& file);

}  // namespace kinegraph
