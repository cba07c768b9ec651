#include "app/commands/cache_record.hpp"
#include "lang/keys/command_line.hpp"

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <nlohmann/json.hpp>

#include "app/files/json_text.hpp"

namespace kinegraph::app {
namespace {

constexpr std::string_view before_answer = ", \"answer\": ";

/// Writes each field with its length, so that different fields never give the same text.
class Description {
public:
    Description& operator<<(std::string_view field) {
        text_ += std::to_string(field.size()) + ':';
        text_ += field;
        return *this;
    }
    Description& operator<<(int field) { return *this << std::to_string(field); }
    Description& operator<<(const std::vector<std::string>& fields) {
        *this << static_cast<int>(fields.size());
        for (const std::string& field : fields) *this << field;
        return *this;
    }
    std::string hash() const {
        XXH128_canonical_t canonical;
        XXH128_canonicalFromHash(&canonical, XXH3_128bits(text_.data(), text_.size()));
        constexpr std::string_view digits = "0123456789abcdef";
        std::string hex;
        for (const unsigned char byte : canonical.digest) {
            hex += digits[byte >> 4U];
            hex += digits[byte & 15U];
        }
        return hex;
    }

private:
    std::string text_;
};

struct RecordedFile {
    std::string path;
    std::uintmax_t size = 0;
};
struct Record {
    std::string text, asked, of;
    std::vector<RecordedFile> files;
};

/// None if there is no record, or it was not written by CacheRecord::of.
std::optional<Record> read_record(const std::string& path) {
    if (::access(path.c_str(), R_OK) != 0) return std::nullopt;
    auto text = read_whole(path, {lang::command_line::cache_record});
    if (!text || text->find(before_answer) == std::string::npos) return std::nullopt;
    const auto json = nlohmann::json::parse(*text, nullptr, false);
    const auto member = [](const nlohmann::json& of, const char* key) {
        return of.is_object() ? of.value(key, nlohmann::json()) : nlohmann::json();
    };
    const auto text_of = [](const nlohmann::json& value) {
        return value.is_string() ? value.get<std::string>() : std::string();
    };
    const auto answer = member(json, "answer"), files = member(answer, "files"), sizes = member(json, "sizes");
    if (files.size() != sizes.size()) return std::nullopt;
    Record record{*std::move(text), text_of(member(json, "asked")), text_of(member(answer, "of")), {}};
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (!files.is_array() || !sizes.is_array() || !sizes[i].is_number_unsigned()) return std::nullopt;
        record.files.push_back({text_of(files[i]), sizes[i].get<std::uintmax_t>()});
    }
    return record;
}

}  // namespace

std::string hash_of(const Request& request, const std::string& theme) {
    const DrawingOptions& drawing = request.drawing;
    Description all;
    all << "kinegraph " KINEGRAPH_VERSION << bare_name(request.file) << request.text.value_or("") << theme
        << request.to;
    for (const ParameterValue& each : request.set) all << each.name << each.value;
    all << static_cast<int>(request.set.size());
    for (const Request::Format format : request.want) all << static_cast<int>(format);
    all << static_cast<int>(drawing.language) << static_cast<int>(drawing.paper)
        << static_cast<int>(drawing.orientation) << static_cast<int>(drawing.dimensions)
        << static_cast<int>(drawing.detail) << static_cast<int>(drawing.superposition)
        << static_cast<int>(drawing.sheet) << static_cast<int>(drawing.steps) << static_cast<int>(drawing.slides)
        << static_cast<int>(drawing.grid) << static_cast<int>(request.exact) << request.positions.branch
        << drawing.author << drawing.date << drawing.figure << request.positions.driver << request.positions.at
        << request.with << std::to_string(request.dpi);
    return all.hash();
}

std::string theme_key(const std::string& name, const DrawingOptions& options) {
    return name == "-" || options.theme_file.empty() ? name : name + '\n' + options.theme_file;
}

std::string hash_of(const std::vector<std::string>& fields) {
    Description all;
    all << "kinegraph " KINEGRAPH_VERSION << fields;
    return all.hash();
}

CacheRecord::CacheRecord(const std::string& to, std::string asked) : asked_(std::move(asked)) {
    const std::filesystem::path target(to);
    folder_ = (target.parent_path() / ".kinegraph").string();
    path_ = folder_ + '/' + target.filename().string();
}

std::optional<std::string> CacheRecord::answer() const {
    const auto record = read_record(path_);
    if (!record || record->asked != asked_ || !record->text.ends_with("}\n")) return std::nullopt;
    for (const RecordedFile& file : record->files) {
        std::error_code absent;
        if (std::filesystem::file_size(file.path, absent) != file.size || absent) return std::nullopt;
    }
    const std::size_t begin = record->text.find(before_answer) + before_answer.size();
    return record->text.substr(begin, record->text.size() - begin - 2);
}

std::vector<std::string> CacheRecord::files_of(const std::string& kind, const std::string& same) const {
    const auto record = read_record(path_);
    if (!record || (!same.empty() && record->of == same)) return {};
    std::vector<std::string> found;
    for (const RecordedFile& file : record->files) {
        // Compares the name only: the folder may have been renamed or moved.
        const std::filesystem::path name = std::filesystem::path(file.path).filename();
        if (!name.string().starts_with(kind)) return {};
        const std::string here = (std::filesystem::path(folder_).parent_path() / name).string();
        std::error_code absent;
        if (std::filesystem::file_size(here, absent) == file.size && !absent) found.push_back(here);
    }
    return found;
}

std::optional<NotWritten> CacheRecord::make_room() const {
    if (auto failure = make_folder(folder_)) return failure;
    return take_away(path_);
}

Output CacheRecord::of(const std::vector<Output>& outputs, const std::string& answer) const {
    std::vector<std::string> sizes;
    for (const Output& output : outputs) sizes.push_back(std::to_string(output.bytes.size()));
    JsonLine record;
    record.add("asked", asked_).add_json("sizes", json_list(sizes)).add_json("answer", answer);
    return {path_, record.object() + '\n'};
}

}  // namespace kinegraph::app
