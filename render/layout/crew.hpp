// Crew: threads that draw figures beside the one that lays out a sheet. What they are given to do depends on nothing
// that they change, so a sheet is the same whoever drew its figures.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace kinegraph::render {

class Crew {
public:
    /// `helpers`: beside the thread that shares out work; fewer, or none, where the machine gives no more. `first`,
    /// `last`: what each does when it begins, and before it ends.
    explicit Crew(int helpers, const std::function<void()>& first = {}, const std::function<void()>& last = {});
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;
    ~Crew();

    /// Calls work(0) to work(count - 1), each once, several at a time and in no order; returns when all are done. Where
    /// some throw, the exception of the first of them by its number comes out. Not to be called by two threads at once,
    /// nor from `work`.
    void share(std::size_t count, const std::function<void(std::size_t)>& work);

private:
    struct Shared;
    std::unique_ptr<Shared> shared_;
};

/// As share(), by the calling thread alone where there is no crew.
void share_out(Crew* crew, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace kinegraph::render
