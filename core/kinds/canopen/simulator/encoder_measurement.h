// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/simulator/canopen_encoder_plan.h"
#include "kinds/canopen/simulator/encoder_objects.h"

namespace codewheel::canopen {

// What a simulated encoder measures, and makes of it: position, speed, cams, work area.
class EncoderMeasurement
{
public:
    explicit EncoderMeasurement(const CanopenEncoderPlan &plan);

    TurningShaft &shaft() { return m_shaft; }
    const TurningShaft &shaft() const { return m_shaft; }
    void setQuirks(const NodeQuirks &quirks) { m_plan.quirks = quirks; }

    // Puts it into the objects.
    void refresh(ObjectDictionary &objects);
    // Of 6509h, so that the present position becomes this one.
    tl::expected<std::int64_t, AbortCode> offsetFor(std::int64_t position,
                                                    const ObjectDictionary &objects) const;

private:
    bool isReversed(const ObjectDictionary &objects) const;
    std::int64_t range(const ObjectDictionary &objects) const;
    std::int64_t scaled(const ObjectDictionary &objects) const;
    std::int64_t position(const ObjectDictionary &objects) const;
    double speed(const ObjectDictionary &objects) const;
    std::uint8_t cams(const ObjectDictionary &objects, std::int64_t position);

    CanopenEncoderPlan m_plan;
    TurningShaft m_shaft;
    std::array<bool, camCount> m_isOnCam{};
};

} // namespace codewheel::canopen
