// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/eds/file_layout.h"

namespace codewheel::canopen {

// Reads the objects of a device file into it.
class ObjectReader
{
public:
    static constexpr std::size_t mostObjects = 65'536; // far more than any encoder has

    explicit ObjectReader(DeviceFile &file)
        : m_file(file)
    {}

    bool read(std::uint16_t index, const ObjectSections &sections); // false: there are too many

private:
    void readGroup(std::uint16_t index, const ObjectSections &sections, const SectionReader &main);
    void readSubs(std::uint16_t index, const ObjectSections &sections);
    void addCompact(const ObjectSections &sections, const SectionReader &main, const FileObject &like,
                    std::uint64_t announced);
    FileObject compactSub(const ObjectSections &sections, const FileObject &like, std::uint8_t sub);
    void addSub(SdoObject object, const IniSection &section);
    FileObject objectIn(SdoObject object, const SectionReader &section);
    void add(FileObject object) { m_file.objects.push_back(std::move(object)); }

    DeviceFile &m_file;
};

} // namespace codewheel::canopen
