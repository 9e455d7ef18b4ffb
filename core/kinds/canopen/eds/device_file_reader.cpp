// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/device_file_reader.h"

#include "kinds/canopen/eds/file_head.h"
#include "kinds/canopen/eds/file_layout.h"
#include "kinds/canopen/eds/object_reader.h"

namespace codewheel::canopen {

tl::expected<DeviceFile, EdsNote> readDeviceFile(const QByteArray &bytes)
{
    DeviceFile file;
    const IniText text(bytes, file.notes);
    const FileLayout layout = FileLayout::of(text, file.notes);
    readHead(layout, file);
    checkLists(layout, file.notes);
    ObjectReader reader(file);
    for (const auto &[index, sections] : layout.objects)
        if (!reader.read(index, sections))
            return tl::unexpected(EdsNote{sections.main != nullptr ? sections.main->line : 0,
                                          objectName({index, 0}),
                                          EdsFault::tooManyObjects,
                                          {QString::number(ObjectReader::mostObjects)}});
    if (file.objects.empty())
        return tl::unexpected(EdsNote{.fault = EdsFault::noObjects});
    completeIdentity(file);
    file.notes.sort();
    return file;
}

} // namespace codewheel::canopen
