// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace codewheel {

// The steps of a job, and how far it has got. `OneStep` is a Step with what its driver needs.
template <typename OneStep>
struct JobSteps
{
    std::vector<OneStep> all;
    std::size_t index = 0; // of the current step
    bool begun = false;    // the current step was sent, or is being sent

    bool atEnd() const { return index == all.size(); }
    OneStep &current() { return all[index]; }
    const OneStep &current() const { return all[index]; }
    // From the current one on.
    auto rest() { return all.begin() + static_cast<std::ptrdiff_t>(index); }
    // Those that were sent, answered or not.
    std::span<const OneStep> sent() const
    {
        return std::span(all).first(std::min(all.size(), index + (begun ? 1 : 0)));
    }

    std::span<const OneStep> done() const { return std::span(all).first(std::min(all.size(), index)); }

    void append(const std::vector<OneStep> &more) { all.insert(all.end(), more.begin(), more.end()); }
    void goOn()
    {
        ++index;
        begun = false;
    }
    void dropRest()
    {
        all.resize(index);
        begun = false;
    }
};

} // namespace codewheel
