// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <cmath>

namespace codewheel {

// Mean and deviation of values that each stood for some time. Parts are put together as Chan, Golub and
// LeVeque do ("Updating formulae and a pairwise algorithm for computing sample variances", 1979), which loses
// nothing where the values are large and lie close together.
class Moments
{
public:
    Moments() = default;
    // Of values given by their distances from `base`: how long they stood in all, in microseconds, and the
    // sums of distance and squared distance, each times how long it stood.
    Moments(double base, double stood, double sum, double squares)
        : m_stood(stood)
        , m_mean(stood > 0 ? base + sum / stood : 0)
        , m_squares(stood > 0 ? squares - sum * sum / stood : 0)
    {}

    void add(const Moments &other)
    {
        if (other.m_stood <= 0)
            return;
        const double all = m_stood + other.m_stood;
        const double off = other.m_mean - m_mean;
        m_squares += other.m_squares + off * off * m_stood / all * other.m_stood;
        m_mean += off * other.m_stood / all;
        m_stood = all;
    }
    void add(std::int64_t value, Instant stood)
    {
        add({static_cast<double>(value), static_cast<double>(stood.count()), 0, 0});
    }

    Instant stood() const { return Instant(std::llround(m_stood)); }
    double mean() const { return m_mean; }
    double deviation() const { return m_stood > 0 ? std::sqrt(std::max(m_squares, 0.0) / m_stood) : 0; }

private:
    double m_stood = 0; // microseconds
    double m_mean = 0;
    double m_squares = 0; // of the distances from the mean, each times how long it stood
};

} // namespace codewheel
