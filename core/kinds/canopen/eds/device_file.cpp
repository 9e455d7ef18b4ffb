// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/device_file.h"

#include <algorithm>
#include <array>

namespace codewheel::canopen {

QString fileAccessKey(FileAccess access)
{
    constexpr std::array keys{"ro", "wo", "rw", "const"}; // in the order of FileAccess
    return QLatin1String(keys.at(static_cast<std::size_t>(access)));
}

const FileObject *DeviceFile::find(SdoObject object) const
{
    const auto found = std::ranges::lower_bound(objects, orderOf(object), {},
                                                [](const FileObject &each) { return orderOf(each.object); });
    return found != objects.end() && found->object == object ? &*found : nullptr;
}

QString objectName(SdoObject object)
{
    return QStringLiteral("%1:%2").arg(object.index, 4, 16, QLatin1Char('0')).arg(object.sub).toUpper();
}

} // namespace codewheel::canopen
