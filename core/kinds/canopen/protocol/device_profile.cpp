// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/device_profile.h"

#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel::canopen {
namespace {

// The translation context of these texts.
struct DeviceProfileText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::DeviceProfile)
};

struct ProfileRow
{
    std::int64_t profile;
    const char *what;
};

// The titles of CiA 4xx, in short.
constexpr std::array profileRows{
    ProfileRow{401, QT_TRANSLATE_NOOP("codewheel::DeviceProfile", "I/O modules")},
    ProfileRow{402, QT_TRANSLATE_NOOP("codewheel::DeviceProfile", "drives")},
    ProfileRow{404, QT_TRANSLATE_NOOP("codewheel::DeviceProfile", "measuring devices and controllers")},
    ProfileRow{405, QT_TRANSLATE_NOOP("codewheel::DeviceProfile", "programmable controllers")},
    ProfileRow{encoderProfile, QT_TRANSLATE_NOOP("codewheel::DeviceProfile", "encoders")},
    ProfileRow{408, QT_TRANSLATE_NOOP("codewheel::DeviceProfile", "hydraulic valves and drives")},
    ProfileRow{410, QT_TRANSLATE_NOOP("codewheel::DeviceProfile", "inclinometers")},
    ProfileRow{417, QT_TRANSLATE_NOOP("codewheel::DeviceProfile", "lifts")},
    ProfileRow{418, QT_TRANSLATE_NOOP("codewheel::DeviceProfile", "batteries")},
    ProfileRow{419, QT_TRANSLATE_NOOP("codewheel::DeviceProfile", "battery chargers")},
};

} // namespace

QString profileText(std::int64_t profile)
{
    const QString number = QString::number(profile);
    const auto row = std::ranges::find(profileRows, profile, &ProfileRow::profile);
    return row == profileRows.end()
               ? number
               : sentence(QStringLiteral("%1 (%2)"), {number, DeviceProfileText::tr(row->what)});
}

} // namespace codewheel::canopen
