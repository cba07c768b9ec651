// batch: passes lines from standard input to the workers and writes the answers to standard output, in order. The
// answer to a faulty line states the fault. A run ends at the end of its input, by a signal, or when standard output is
// closed.
#include <csignal>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/commands/batch_worker.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/in_order.hpp"
#include "app/files/files.hpp"
#include "app/files/line_reader.hpp"
#include "lang/keys/command_line.hpp"

namespace kinegraph::app {
namespace {

constexpr const char* blanks = " \t\r";

/// Feeds the workers until the input ends or standard output is closed.
LineReader::Event feed(LineReader& lines, InOrder& workers) {
    std::string line;
    while (true) {
        const LineReader::Event event = lines.next(line);
        if (event != LineReader::Event::line) return event;
        if (line.find_first_not_of(blanks) == std::string::npos) continue;
        if (!workers.add(std::move(line))) return LineReader::Event::end;
        line.clear();
    }
}

/// Prints the summary of the run.
void sum_up(const BatchTally& tally, Language language) {
    const auto number = [](long count) { return std::to_string(count); };
    if (tally.resumed > 0)
        refuse({lang::command_line::lines_done_before, number(tally.answered), number(tally.resumed)}, language);
    if (tally.refused > 0)
        refuse({lang::command_line::lines_that_could_not_be_carried, number(tally.answered), number(tally.refused)},
               language);
}

}  // namespace

Status batch_command(const BatchRequest& request) {
    const Language language = request.defaults.language();
    auto answers = Growing::open("-");
    if (!answers) return fail_to_write(answers.error(), language);
    BatchTally tally;
    std::optional<NotWritten> failure;
    std::vector<InOrder::Worker> workers;
    for (int job = 0; job < request.jobs; ++job)
        workers.emplace_back([worker = std::make_shared<BatchWorker>(request, tally)](const std::string& line) {
            return worker->answer(line);
        });
    int signal = 0;
    {
        LineReader lines;
        const auto sink = [&](const std::string& answer) {
            failure = answers->add(answer);
            return !failure;
        };
        InOrder in_order(std::move(workers), sink, [] { return LineReader::signal() != 0; });
        const LineReader::Event end = feed(lines, in_order);
        in_order.finish();
        signal = LineReader::signal();
        if (end == LineReader::Event::failed) {
            say({lang::command_line::standard_input}, lines.why(), language);
            return Status::bad_input;
        }
    }
    sum_up(tally, language);
    if (failure) return fail_to_write(*failure, language);
    if (signal != 0) {
        refuse({lang::command_line::stopped_lines_answered_resume_does, std::to_string(tally.answered)}, language);
        std::raise(signal);
    }
    return Status::done;
}

}  // namespace kinegraph::app
