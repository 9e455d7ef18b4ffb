// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/line_keeper.h"

#include "app/window/serial_line.h"
#include "widgets/project/project_document.h"

#include <algorithm>

namespace codewheel {
namespace {

DeviceNumber numberOf(const ProjectDevice &encoder)
{
    return encoder.participant.number;
}

ProjectDevice plannedEncoder(DeviceNumber number, const QString &deviceKey)
{
    ProjectDevice encoder;
    encoder.participant.number = number;
    encoder.participant.deviceKey = deviceKey;
    return encoder;
}

} // namespace

LineKeeper::LineKeeper(const SerialLine &line, ProjectDocument &project, QObject *parent)
    : QObject(parent)
    , m_line(line)
    , m_project(project)
{}

ProjectLine LineKeeper::line() const
{
    return m_project.project().line.value_or(ProjectLine());
}

void LineKeeper::edit(const ProjectLine &after, const QString &what)
{
    Project project = m_project.project();
    project.line = after;
    m_project.edit(std::move(project), what);
}

void LineKeeper::keepPort(const ProjectLine &line)
{
    edit(m_line.asOpened(line), tr("Serial line"));
}

void LineKeeper::keepFractionBits(int bits)
{
    if (m_line.training() != nullptr)
        return;
    ProjectLine after = line();
    after.wish.fractionBits = bits;
    edit(after, tr("Fraction bits of the scaling factor"));
}

void LineKeeper::keepBaudRate(int baudRate)
{
    ProjectLine after = line();
    after.wish.line.baudRate = baudRate;
    after.wish.timing.character = after.wish.line.timeOf(1);
    edit(after, tr("Baud rate of the serial line"));
}

void LineKeeper::keepByteOrder(DeviceNumber number, bool isSwapped)
{
    if (m_line.training() != nullptr)
        return;
    Project after = m_project.project();
    ProjectDevice *encoder = findDevice(after, number);
    if (encoder == nullptr)
        return;
    encoder->swapsWarningBytes = isSwapped;
    m_project.edit(std::move(after), tr("Warning bytes of %1").arg(number.toString()));
}

void LineKeeper::keepEncoders(const std::vector<DeviceNumber> &numbers, const QString &deviceKey)
{
    if (m_line.training() != nullptr || numbers.empty())
        return;
    ProjectLine after = line();
    for (const DeviceNumber number : numbers)
        if (findDevice(m_project.project(), number) == nullptr)
            after.encoders.push_back(plannedEncoder(number, deviceKey));
    std::ranges::sort(after.encoders, {}, numberOf);
    edit(after, tr("Encoders of the serial line"));
}

void LineKeeper::removeEncoder(DeviceNumber number)
{
    if (m_line.training() != nullptr || !m_project.project().line)
        return;
    ProjectLine after = line();
    std::erase_if(after.encoders,
                  [number](const ProjectDevice &encoder) { return numberOf(encoder) == number; });
    edit(after, tr("Remove %1").arg(number.toString()));
}

// What is planned for a training encoder is in no file; it goes along all the same.
void LineKeeper::moveEncoder(DeviceNumber from, DeviceNumber to)
{
    if (m_line.training() == nullptr || findDevice(m_project.project(), from) == nullptr)
        m_project.renumber(from, to, tr("Address of %1 to %2").arg(from.toString(), to.toString()));
}

} // namespace codewheel
