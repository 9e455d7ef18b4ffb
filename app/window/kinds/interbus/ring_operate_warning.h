// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/buses/operate_question.h"
#include "vocabulary/place.h"

namespace codewheel {

// What Operate means for a real ring, and what can move there.
class RingOperateWarning
{
public:
    using Called =
        std::function<QString(Place device, const QString &name)>; // by the name of its description

    RingOperateWarning(const EncoderBus &ring, Called called);

    OperateWarning warning() const;

private:
    QString explanation() const;
    QStringList movable() const; // devices with OUT that are not known as encoders
    QStringList outNotKnown() const;

    const EncoderBus &m_ring;
    const Called m_called;
};

} // namespace codewheel
