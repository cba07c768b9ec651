#include "app/commands/cache_record.hpp"

#include <unistd.h>

#include <filesystem>
#include <system_error>
#include <utility>

#define XXH_INLINE_ALL
#include <xxhash.h>

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

}  // namespace

std::string hash_of(const BatchLine& line, const std::string& theme) {
    const SolveRequest& request = line.request;
    Description all;
    all << "kinegraph " KINEGRAPH_VERSION << bare_name(request.file) << request.text.value_or("") << theme << line.to;
    for (const Setting& setting : request.set) all << setting.name << setting.value;
    all << static_cast<int>(request.set.size());
    for (const Format format : line.want) all << static_cast<int>(format);
    all << static_cast<int>(request.language) << static_cast<int>(request.paper)
        << static_cast<int>(request.orientation) << static_cast<int>(request.dimensions)
        << static_cast<int>(request.detail) << static_cast<int>(request.sheet) << static_cast<int>(request.steps)
        << static_cast<int>(request.grid) << static_cast<int>(request.exact) << request.branch << request.author
        << request.date << request.figure << request.driver << request.at << request.with
        << std::to_string(request.dpi);
    return all.hash();
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
    if (::access(path_.c_str(), R_OK) != 0) return std::nullopt;
    const auto text = read_whole(path_, {"receipt", "ricevuta"});
    if (!text || !text->ends_with("}\n")) return std::nullopt;
    const auto json = JsonSource::read(*text);
    const std::size_t at = text->find(before_answer);
    if (!json || at == std::string::npos || json->root()["asked"].text() != asked_) return std::nullopt;
    const JsonValue files = json->root()["answer"]["files"], sizes = json->root()["sizes"];
    if (files.size() != sizes.size()) return std::nullopt;
    auto size = sizes.begin();
    for (const JsonValue file : files) {
        std::error_code absent;
        const auto here = std::filesystem::file_size(std::string(file.text()), absent);
        if (absent || std::to_string(here) != (*size).text()) return std::nullopt;
        ++size;
    }
    const std::size_t begin = at + before_answer.size();
    return text->substr(begin, text->size() - begin - 2);
}

std::vector<std::string> CacheRecord::files_of(const std::string& kind, const std::string& same) const {
    if (::access(path_.c_str(), R_OK) != 0) return {};
    const auto text = read_whole(path_, {"receipt", "ricevuta"});
    if (!text) return {};
    const auto json = JsonSource::read(*text);
    if (!json) return {};
    const JsonValue answer = json->root()["answer"], files = answer["files"], sizes = json->root()["sizes"];
    if (files.size() != sizes.size() || (!same.empty() && answer["of"] && answer["of"].text() == same)) return {};
    std::vector<std::string> found;
    auto size = sizes.begin();
    for (const JsonValue file : files) {
        // Compares the name only: the folder may have been renamed or moved.
        const std::filesystem::path name = std::filesystem::path(file.text()).filename();
        if (!name.string().starts_with(kind)) return {};
        const std::string here = (std::filesystem::path(folder_).parent_path() / name).string();
        std::error_code absent;
        const auto bytes = std::filesystem::file_size(here, absent);
        if (!absent && std::to_string(bytes) == (*size).text()) found.push_back(here);
        ++size;
    }
    return found;
}

std::optional<NotWritten> CacheRecord::make_room() const {
    if (auto failure = make_folder(folder_)) return failure;
    return take_away(path_);
}

Output CacheRecord::of(const std::vector<Output>& outputs, const std::string& answer) const {
    std::string sizes;
    for (const Output& output : outputs) sizes += (sizes.empty() ? "" : ", ") + std::to_string(output.bytes.size());
    return {path_,
            "{\"asked\": \"" + asked_ + "\", \"sizes\": [" + sizes + "]" + std::string(before_answer) + answer + "}\n"};
}

}  // namespace kinegraph::app
