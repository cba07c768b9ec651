// equations FILE: the closure equations as solved by hand, or the derivatives of the position of a point, as text,
// LaTeX or JSON.
#include "app/commands/commands.hpp"
#include "app/files/files.hpp"

namespace kinegraph::app {

Status equations_command(const EquationsRequest& request) {
    const auto file = mechanism_of(request.file, request.language, request.set);
    if (!file) return file.error();
    if (!file->has_equations()) {
        say(spoken(request.file), no_mechanism("equations"), request.language);
        return Status::bad_input;
    }
    const auto text = file->equations(request.format == "latex"  ? TextForm::latex
                                      : request.format == "json" ? TextForm::json
                                                                 : TextForm::plain,
                                      request.language);
    return text ? print(*text, request.language) : say(spoken(request.file), text.error(), request.language);
}

}  // namespace kinegraph::app
