// variants FILE: draws variants of an exercise and writes the sheets, the results and the file of each, and the answer
// key.
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>
#include <system_error>

#include <kinegraph/variants.hpp>

#include "app/commands/cache_record.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/outputs.hpp"
#include "app/files/json_text.hpp"
#include "app/files/roster.hpp"
#include "lang/keys/command_line.hpp"
#include "lang/keys/common.hpp"

namespace kinegraph::app {
namespace {

// --- interruption ---

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): a signal handler can use nothing else
volatile std::sig_atomic_t stop_asked = 0;
void ask_to_stop(int signal) { stop_asked = signal; }

/// While it exists, Ctrl-C only sets a flag, so that the files being written are completed.
class Stopping {
public:
    Stopping() {
        stop_asked = 0;
        for (std::size_t i = 0; i < signals.size(); ++i) before_.at(i) = std::signal(signals.at(i), ask_to_stop);
    }
    ~Stopping() {
        for (std::size_t i = 0; i < signals.size(); ++i) std::signal(signals.at(i), before_.at(i));
    }
    Stopping(const Stopping&) = delete;
    Stopping& operator=(const Stopping&) = delete;
    static int asked() { return stop_asked; }

private:
    static constexpr std::array<int, 2> signals{SIGINT, SIGTERM};
    std::array<void (*)(int), 2> before_{};
};

/// On a terminal: the number of finished variants and the remaining time, if the run takes over a second.
class Countdown {
public:
    Countdown(std::size_t all, Language language)
        : all_(all), language_(language), shows_(::isatty(STDERR_FILENO) != 0) {}
    ~Countdown() {
        if (shown_) std::fputs("\r\x1b[K", stderr);
    }
    Countdown(const Countdown&) = delete;
    Countdown& operator=(const Countdown&) = delete;
    void at(std::size_t done) {
        const auto now = std::chrono::steady_clock::now();
        if (!shows_ || done == 0 || now < next_) return;
        next_ = now + std::chrono::milliseconds(200);
        shown_ = true;
        const std::chrono::duration<double> taken = now - begun_;
        const double left = taken.count() / static_cast<double>(done) * static_cast<double>(all_ - done);
        const Words line(lang::command_line::of_s_left, std::to_string(done), std::to_string(all_),
                         std::to_string(static_cast<long>(left + 1)));
        std::fprintf(stderr, "\r\x1b[K%s", in(line, language_).c_str());
    }

private:
    std::size_t all_;
    Language language_;
    bool shows_, shown_ = false;
    std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now(),
                                          next_ = begun_ + std::chrono::seconds(1);
};

// --- a run ---

/// "007": with the same width whatever the count is.
std::string number_of(std::size_t variant) {
    const std::string digits = std::to_string(variant);
    constexpr std::size_t least = 3;
    return std::string(digits.size() < least ? least - digits.size() : 0, '0') + digits;
}

/// All digits of a number.
std::string digits_of(double value) {
    std::array<char, 32> digits{};
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

class Run {
public:
    Run(const VariantsRequest& request, std::string text, ExerciseVariants variants, std::vector<std::string> names,
        std::size_t count, DrawingOptions options)
        : request_(request),
          text_(std::move(text)),
          variants_(std::move(variants)),
          names_(std::move(names)),
          count_(count),
          options_(std::move(options)),
          bank_(title(), request.seed, options_, wants("moodle") || wants("qti") ? request.dpi : 0) {}

    Status carry_out() {
        const Stopping stopping;
        {
            Countdown countdown(count_, language());
            while (key_.size() < count_ && Stopping::asked() == 0) {
                countdown.at(key_.size());
                const auto variant =
                    variants_.next(number_of(key_.size() + 1) + ".json", [] { return Stopping::asked() != 0; });
                if (!variant) return cannot_draw(spoken(request_.file), variant.error(), language());
                if (!*variant) break;
                if (const auto status = write(**variant)) return *status;
            }
        }
        if (key_.size() > 0)
            if (const auto status = write_key()) return *status;
        if (key_.size() > 0 && Stopping::asked() == 0) take_away_what_no_key_lists();
        return report();
    }

private:
    Language language() const { return request_.sheet.language; }
    void line(const Words& words) const { say(spoken(request_.file), words, language()); }
    std::string path(const std::string& name) const {
        return request_.folder + (request_.folder.ends_with('/') ? "" : "/") + name;
    }

    std::string title() const {
        const std::string given = variants_.title().in(language());
        return given.empty() ? bare_name(request_.file) : given;
    }
    bool wants(const char* platform) const {
        return std::find(request_.platforms.begin(), request_.platforms.end(), platform) != request_.platforms.end();
    }

    /// Writes all files of one variant or none; a status if they cannot be written.
    std::optional<Status> write(const ExerciseVariant& variant) {
        const std::size_t index = key_.size();
        const std::string number = number_of(index + 1), name = index < names_.size() ? names_[index] : "";
        const std::string drawn = hash_of(told_of(number, name, variant));
        const CacheRecord cache_record(path(number), asked_of(number, name, variant));
        // A theme from standard input can be read only once, so it has no cache key.
        const bool is_there = request_.resume && request_.theme != "-" && cache_record.answer();
        std::vector<Output> outputs;
        if (!is_there || request_.merge)
            if (const auto status = add_sheets(variant, number, name, outputs)) return status;
        if (is_there)
            ++there_before_;
        else if (const auto status = put(variant, number, drawn, cache_record, std::move(outputs)))
            return status;
        if (!request_.platforms.empty())
            if (const auto status = add_question(variant, number, name)) return status;
        key_.add(number, name, variant);
        return std::nullopt;
    }
    std::optional<Status> add_sheets(const ExerciseVariant& variant, const std::string& number, const std::string& name,
                                     std::vector<Output>& outputs) {
        DrawingOptions options = options_;
        if (!name.empty()) options.author = name + (options.author.empty() ? "" : "  ·  " + options.author);
        options.sheet = DrawingOptions::Sheet::question;
        if (const auto status = add(draw(variant.solved, options), number + "-question", questions_, outputs))
            return status;
        options.sheet = DrawingOptions::Sheet::solution;
        options.grid = false;
        return add(draw(variant.solved, options), number + "-solution", solutions_, outputs);
    }
    std::optional<Status> put(const ExerciseVariant& variant, const std::string& number, const std::string& drawn,
                              const CacheRecord& cache_record, std::vector<Output> outputs) {
        outputs.push_back({path(number + ".json"), variant.file});
        outputs.push_back({path(number + "-results.json"), variant.solved.json()});
        std::vector<std::string> paths;
        for (const Output& each : outputs) paths.push_back(each.path);
        const std::vector<std::string> before = cache_record.files_of(number, drawn);
        if (const auto failure = cache_record.make_room()) return not_put(*failure);
        outputs.push_back(cache_record.of(outputs, JsonLine().add("files", paths).add("of", drawn).object()));
        if (const auto status = put(outputs)) return status;
        // Removes the sheets that an earlier variant of this number left in another format. Sheets of the same variant
        // stay.
        for (const std::string& each : before)
            if (std::none_of(paths.begin(), paths.end(), [&](const std::string& now) { return same_file(now, each); }))
                take_away(each);
        return std::nullopt;
    }
    /// Removes variants that an earlier run left beyond the last one: they could be handed out although the key does
    /// not list them. Files changed since then stay.
    void take_away_what_no_key_lists() {
        std::error_code trouble;
        std::vector<std::size_t> beyond;
        for (const auto& entry : std::filesystem::directory_iterator(path(".kinegraph"), trouble)) {
            const std::string name = entry.path().filename().string();
            std::size_t number = 0;
            const auto end = std::from_chars(name.data(), name.data() + name.size(), number).ptr;
            if (end == name.data() + name.size() && number > key_.size() && name == number_of(number))
                beyond.push_back(number);
        }
        std::sort(beyond.begin(), beyond.end());
        for (const std::size_t each : beyond) {
            const CacheRecord cache_record(path(number_of(each)), "");
            const std::vector<std::string> files = cache_record.files_of(number_of(each));
            if (files.empty()) continue;
            for (const std::string& file : files) take_away(file);
            take_away(cache_record.path());
            taken_away_.push_back(number_of(each));
        }
    }
    /// The content of a variant, independent of the look of its sheets.
    std::vector<std::string> told_of(const std::string& number, const std::string& name,
                                     const ExerciseVariant& variant) const {
        std::vector<std::string> fields{"variant", number, name, text_};
        for (const std::vector<ParameterValue>* settings : {&variant.values, &request_.set}) {
            fields.push_back(std::to_string(settings->size()));
            for (const ParameterValue& each : *settings) fields.insert(fields.end(), {each.name, each.value});
        }
        return fields;
    }
    /// The fields of the cache key: all that determines the bytes of a variant's files.
    std::string asked_of(const std::string& number, const std::string& name, const ExerciseVariant& variant) const {
        std::vector<std::string> fields = told_of(number, name, variant);
        fields.insert(fields.end(),
                      {theme_key(request_.theme, options_), request_.format, std::to_string(request_.dpi)});
        for (const int each : {static_cast<int>(options_.paper), static_cast<int>(options_.language),
                               static_cast<int>(options_.orientation), static_cast<int>(options_.dimensions),
                               static_cast<int>(options_.detail), static_cast<int>(options_.grid),
                               static_cast<int>(request_.merge), static_cast<int>(options_.even_pages)})
            fields.push_back(std::to_string(each));
        fields.insert(fields.end(), {options_.author, options_.date, bare_name(request_.file)});
        if (options_.scales)
            for (const auto& [figure, scale] : options_.scales->of_figures)
                fields.insert(fields.end(), {figure, digits_of(scale)});
        return hash_of(fields);
    }
    std::optional<Status> add_question(const ExerciseVariant& variant, const std::string& number,
                                       const std::string& name) {
        const std::string ending = "." + request_.format;
        QuestionBank::Files files{number + "-question" + ending, number + "-solution" + ending,
                                  number + "-results.json", number + ".json"};
        if (request_.merge) files.question = "questions.pdf", files.solution = "solutions.pdf";
        const auto unreadable = bank_.add(number, name, variant, files);
        if (!unreadable) return not_drawn(unreadable.error());
        std::string names;
        for (const std::string& each : *unreadable) names += (names.empty() ? "" : ", ") + each;
        if (!names.empty()) line({lang::command_line::at_the_scales_of_its_figures, number, names});
        return std::nullopt;
    }

    Status not_drawn(const Diagnostics& faults) const { return cannot_draw(spoken(request_.file), faults, language()); }
    /// Adds a sheet to the outputs, or to those that are merged.
    std::optional<Status> add(const Expected<Drawing>& drawing, const std::string& name, std::vector<Drawing>& merged,
                              std::vector<Output>& outputs) {
        if (drawing && request_.merge) {
            missing_.insert(drawing->missing_characters().begin(), drawing->missing_characters().end());
            merged.push_back(*drawing);
            return std::nullopt;
        }
        return add(drawing, {path(name + "." + request_.format), format()}, outputs);
    }
    std::optional<Status> add(const Expected<Drawing>& drawing, const Target& target, std::vector<Output>& outputs) {
        if (!drawing) return not_drawn(drawing.error());
        missing_.insert(drawing->missing_characters().begin(), drawing->missing_characters().end());
        std::vector<Text> remarks;
        return print(*drawing, target, {language(), Lettering::outlines, request_.dpi}, outputs, remarks);
    }
    Format format() const {
        return request_.format == "svg" ? Format::svg : request_.format == "png" ? Format::png : Format::pdf;
    }

    std::optional<Status> put(const std::vector<Output>& outputs) {
        for (const Output& each : outputs) {
            if (same_file(each.path, request_.file) || same_file(each.path, request_.roster))
                return refuse({lang::command_line::would_be_written_over_choose_another, each.path}, language());
        }
        const auto failure = write_all(outputs);
        return failure ? not_put(*failure) : std::nullopt;
    }
    /// Reports what could not be written, what was written, and how to continue.
    std::optional<Status> not_put(const NotWritten& failure) const {
        const Status status = fail_to_write(failure, language());
        const bool one = count_ == 1;
        line({one ? lang::command_line::one_variant_is_whole : lang::command_line::variants_are_whole,
              std::to_string(key_.size()), std::to_string(count_), request_.folder});
        return status;
    }

    std::optional<Status> write_key() {
        std::vector<Output> outputs{{path("key.csv"), key_.csv()}};
        const auto add_pdf = [&](const Expected<Drawing>& drawing, const char* name) {
            return add(drawing, {path(name), Format::pdf}, outputs);
        };
        if (const auto status = add_pdf(key_.drawing(title(), options_), "key.pdf")) return status;
        if (request_.merge) {
            if (const auto status = add_pdf(joined(questions_), "questions.pdf")) return status;
            if (const auto status = add_pdf(joined(solutions_), "solutions.pdf")) return status;
        }
        if (wants("moodle")) outputs.push_back({path("moodle.xml"), bank_.moodle()});
        if (wants("qti")) {
            auto package = bank_.qti();
            if (!package) return fail_to_write({path("qti.zip"), package.error().front().text}, language());
            outputs.push_back({path("qti.zip"), *std::move(package)});
        }
        if (wants("csv")) outputs.push_back({path("answers.csv"), bank_.csv()});
        return put_key(std::move(outputs));
    }
    /// Removes what an earlier run has written with its key and this one does not write: it is of other variants.
    std::optional<Status> put_key(std::vector<Output> outputs) {
        const CacheRecord cache_record(path("key"), "");
        const std::vector<std::string> before = cache_record.files_of("");
        std::vector<std::string> paths;
        for (const Output& each : outputs) paths.push_back(each.path);
        if (const auto failure = cache_record.make_room()) return not_put(*failure);
        outputs.push_back(cache_record.of(outputs, "{\"files\": " + json_quoted(paths) + "}"));
        if (const auto status = put(outputs)) return status;
        for (const std::string& each : before)
            if (std::none_of(paths.begin(), paths.end(),
                             [&](const std::string& now) { return same_file(now, each); })) {
                take_away(each);
                line({lang::command_line::files_of_an_earlier_run, std::filesystem::path(each).filename().string()});
            }
        return std::nullopt;
    }

    static Words variants(std::size_t count) {
        return {count == 1 ? lang::command_line::one_variant : lang::command_line::variants, std::to_string(count)};
    }
    Words combinations() const {
        const std::uint64_t count = variants_.combinations();
        return {count == 1 ? lang::command_line::one_combination : lang::command_line::combinations,
                std::to_string(count)};
    }

    Status report() const {
        if (!missing_.empty())
            remark(spoken(request_.file), {remark_on_missing({missing_.begin(), missing_.end()})}, language());
        const bool one = variants_.looked_at() == 1;
        line({one ? lang::command_line::one_was_looked : lang::command_line::were_looked, variants(key_.size()),
              request_.folder, std::to_string(variants_.looked_at()), combinations()});
        if (there_before_ == 1)
            line({lang::command_line::one_of_them_was_there_whole});
        else if (there_before_ > 0)
            line({lang::command_line::of_them_were_there_whole, std::to_string(there_before_)});
        if (taken_away_.size() == 1)
            line({lang::command_line::of_an_earlier_run_is_taken, taken_away_.front()});
        else if (!taken_away_.empty())
            line({lang::command_line::to_of_an_earlier_run, taken_away_.front(), taken_away_.back()});
        for (const ExerciseVariants::Rejection& each : variants_.rejections())
            line({each.count == 1 ? lang::command_line::one_rejected : lang::command_line::rejected,
                  std::to_string(each.count), each.why});
        if (const int signal = Stopping::asked(); signal != 0) {
            line({lang::command_line::stopped_what_is_there_is_whole});
            std::signal(signal, SIG_DFL);
            std::raise(signal);
        }
        if (key_.size() == count_) return Status::done;
        const Words wanted(count_ == 1 ? lang::command_line::one_was_asked : lang::command_line::were_asked,
                           std::to_string(count_));
        if (variants_.looked_at() == variants_.combinations())
            line({lang::command_line::the_conditions_leave, std::to_string(key_.size()), combinations(), wanted});
        else
            line({lang::command_line::the_conditions_leave_too_few_found, std::to_string(key_.size()),
                  std::to_string(ExerciseVariants::most_in_a_row), wanted});
        return Status::unsolved;
    }

    const VariantsRequest& request_;
    std::string text_;
    ExerciseVariants variants_;
    std::vector<std::string> names_;
    std::size_t count_;
    DrawingOptions options_;
    AnswerKey key_;
    QuestionBank bank_;
    std::size_t there_before_ = 0;
    std::vector<std::string> taken_away_;  ///< numbers of removed variants, ascending
    std::vector<Drawing> questions_, solutions_;
    std::set<std::string> missing_;  ///< characters that the font lacks
};

/// The names of the roster; empty without a roster. A status after an error was reported.
tl::expected<std::vector<std::string>, Status> names_of(const VariantsRequest& request) {
    if (request.roster.empty()) return std::vector<std::string>();
    const auto text = read_whole(request.roster, {lang::command_line::roster});
    const auto names = text ? read_roster(*text) : tl::unexpected(text.error());
    if (names) return *names;
    say(spoken(request.roster), names.error(), request.sheet.language);
    return tl::unexpected(Status::bad_input);
}

/// The scales at which the figures of all variants have room. A status after an error was reported.
tl::expected<FigureScales, Status> scales_of_class(const VariantsRequest& request, ExerciseVariants variants,
                                                   std::size_t count, const DrawingOptions& options) {
    const Stopping stopping;
    const auto fails = [&](const Diagnostics& faults) {
        return tl::unexpected(cannot_draw(spoken(request.file), faults, request.sheet.language));
    };
    FigureScales all;
    for (std::size_t i = 0; i < count && Stopping::asked() == 0; ++i) {
        const auto variant = variants.next({}, [] { return Stopping::asked() != 0; });
        if (!variant) return fails(variant.error());
        if (!*variant) break;
        const auto own = figure_scales((*variant)->solved, options);
        if (!own) return fails(own.error());
        all.add(*own);
    }
    return all;
}

/// Checks that the folder exists and can be written into; a status after an error was reported.
std::optional<Status> folder_fails(const VariantsRequest& request) {
    std::error_code trouble;
    std::filesystem::create_directories(request.folder, trouble);
    if (!trouble && !std::filesystem::is_directory(request.folder, trouble))
        trouble = std::make_error_code(std::errc::not_a_directory);
    if (!trouble && ::access(request.folder.c_str(), W_OK) != 0) trouble = {errno, std::generic_category()};
    if (!trouble) return std::nullopt;
    return fail_to_write({Words(request.folder), Words(trouble.message())}, request.sheet.language);
}

}  // namespace

Status variants_command(const VariantsRequest& request) {
    const Language language = request.sheet.language;
    if (request.merge && request.format != "pdf")
        return refuse({lang::command_line::merge_makes_pdf_take_format_out, request.format}, language);
    if (request.file == "-" && request.roster == "-")
        return refuse({lang::command_line::standard_input_can_be_the_mechanism_file}, language);
    const auto names = names_of(request);
    if (!names) return names.error();
    const std::size_t count = request.count > 0 ? static_cast<std::size_t>(request.count) : names->size();
    if (count == 0) return refuse({lang::command_line::how_many_variants_give_count}, language);
    if (count < names->size())
        return refuse(
            {lang::command_line::count_is_fewer_than_the_names, std::to_string(count), std::to_string(names->size())},
            language);
    DrawingOptions options = request.sheet;
    if (const auto status = set_theme(options, request.theme, request.file)) return *status;
    auto text = read_whole(request.file, {lang::common::mechanism_file});
    if (!text) {
        say(spoken(request.file), text.error(), language);
        return Status::bad_input;
    }
    auto variants = ExerciseVariants::parse(*text, bare_name(request.file), request.seed, request.set, options);
    if (!variants) return say(spoken(request.file), variants.error(), language);
    for (const std::string& varied : variants->parameters())
        if (std::any_of(request.set.begin(), request.set.end(),
                        [&](const ParameterValue& each) { return each.name == varied; }))
            return refuse({lang::command_line::set_varies_in_this_exercise, varied}, language);
    if (const auto status = folder_fails(request)) return *status;
    if (request.is_class) {
        options.even_pages = true;
        auto again = ExerciseVariants::parse(*text, bare_name(request.file), request.seed, request.set, options);
        auto scales = scales_of_class(request, *std::move(again), count, options);
        if (!scales) return scales.error();
        options.scales = *std::move(scales);
    }
    return Run(request, *std::move(text), *std::move(variants), *names, count, std::move(options)).carry_out();
}

}  // namespace kinegraph::app
