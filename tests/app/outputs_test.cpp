// Outputs as a pipe or a signal meets them: a full non-blocking pipe is waited for, and a process that a signal ends
// leaves no temporary file.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include "app/files/files.hpp"

namespace kinegraph::outputs_test {
namespace {

namespace fs = std::filesystem;

TEST(Outputs, WaitForAFullNonBlockingPipe) {
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    const int standard_output = ::dup(STDOUT_FILENO);
    ::fflush(stdout);
    ASSERT_EQ(::fcntl(ends[1], F_SETFL, O_NONBLOCK), 0);
    ASSERT_GE(::dup2(ends[1], STDOUT_FILENO), 0);
    const std::string text(1 << 20, 'x');  // more than a pipe holds
    std::string got;
    std::thread reader([&] {
        std::array<char, 4096> part{};
        while (got.size() < text.size()) {
            const ssize_t count = ::read(ends[0], part.data(), part.size());
            if (count <= 0) return;
            got.append(part.data(), static_cast<std::size_t>(count));
        }
    });
    const auto failure = app::write_all({{"-", text}});
    ::dup2(standard_output, STDOUT_FILENO);
    ::close(standard_output);
    ::close(ends[1]);
    reader.join();
    ::close(ends[0]);
    EXPECT_FALSE(failure.has_value());
    EXPECT_EQ(got, text);
}

class Interrupted : public testing::TestWithParam<int> {};

TEST_P(Interrupted, LeavesNoTemporaryFile) {
    const fs::path folder = fs::temp_directory_path() / ("kinegraph-interrupted-" + std::to_string(::getpid()));
    fs::remove_all(folder);
    fs::create_directory(folder);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        auto growing = app::Growing::open(folder / "rows.csv");
        if (!growing || growing->add("a row\n") || fs::is_empty(folder)) ::_exit(1);
        std::raise(GetParam());
        ::_exit(2);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status)) << WEXITSTATUS(status);
    EXPECT_EQ(WTERMSIG(status), GetParam());
    EXPECT_TRUE(fs::is_empty(folder));
    fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupted, testing::Values(SIGINT, SIGTERM, SIGHUP));

}  // namespace
}  // namespace kinegraph::outputs_test
