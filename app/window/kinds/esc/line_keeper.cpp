// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/esc/line_keeper.h"

#include "app/window/kinds/esc/line_at_work.h"
#include "kinds/esc/line/line_encoder_session.h"
#include "widgets/project/project_document.h"

#include <algorithm>

namespace codewheel {
namespace {

// The planned encoder at its place; added as it is connected if the line has none there yet.
ProjectDevice &plannedEncoder(std::vector<ProjectDevice> &encoders, const EncoderSession &connected)
{
    const Place number = connected.place();
    const auto place = std::ranges::lower_bound(encoders, number, {}, &ProjectDevice::place);
    if (place != encoders.end() && place->place() == number)
        return *place;
    ProjectDevice encoder;
    encoder.standAt(number);
    encoder.participant.deviceKey = connected.device().key;
    const auto explained = valueOptionsOf(&connected);
    encoder.swapsWarningBytes = explained && explained->swapsWarningBytes;
    return *encoders.insert(place, std::move(encoder));
}

} // namespace

LineKeeper::LineKeeper(const LineAtWork &line, ProjectDocument &project, QObject *parent)
    : QObject(parent)
    , m_line(line)
    , m_project(project)
{}

LinePlan LineKeeper::line() const
{
    const LinePlan *planned = linePlan(m_project.project(), m_line.id());
    return planned ? *planned : m_line.opened();
}

std::vector<ProjectDevice> LineKeeper::encoders() const
{
    const auto planned = devicesOn(m_project.project(), m_line.id());
    return {planned.begin(), planned.end()};
}

void LineKeeper::edit(const LinePlan &after, const QString &what)
{
    Project project = m_project.project();
    setLinePlan(project, m_line.id(), after);
    m_project.edit(std::move(project), what);
}

void LineKeeper::edit(std::vector<ProjectDevice> after, const QString &what)
{
    Project project = m_project.project();
    setLinePlan(project, m_line.id(), line());
    setDevicesOn(project, m_line.id(), std::move(after));
    m_project.edit(std::move(project), what);
}

void LineKeeper::keepPort(const LinePlan &line)
{
    edit(m_line.asOpened(line), tr("Serial line"));
}

void LineKeeper::keepFractionBits(int bits)
{
    if (m_line.training() != nullptr)
        return;
    LinePlan after = line();
    after.settings.fractionBits = bits;
    edit(after, tr("Fraction bits of the scaling factor"));
}

void LineKeeper::keepBaudRate(int baudRate)
{
    LinePlan after = line();
    after.settings.serial.baudRate = baudRate;
    after.settings.timing.character = after.settings.serial.timeOf(1);
    edit(after, tr("Baud rate of the serial line"));
}

void LineKeeper::keepByteOrder(Place number, bool isSwapped)
{
    std::vector<ProjectDevice> after = encoders();
    const auto planned = std::ranges::find(after, number, &ProjectDevice::place);
    const bool isThere = m_line.session() != nullptr && m_line.session()->encoder(number) != nullptr;
    if (const EncoderSession *connected = sessionOf(number))
        plannedEncoder(after, *connected).swapsWarningBytes = isSwapped;
    else if (planned != after.end() && !isThere)
        planned->swapsWarningBytes = isSwapped;
    else
        return;
    edit(std::move(after), tr("Warning bytes of %1").arg(number.shown()));
}

// Also null at the training line.
const EncoderSession *LineKeeper::sessionOf(Place number) const
{
    const bool isKept = m_line.session() != nullptr && m_line.training() == nullptr;
    return isKept ? m_line.session()->encoder(number) : nullptr;
}

void LineKeeper::keepEncoders(const std::vector<Place> &numbers)
{
    if (m_line.training() != nullptr || numbers.empty())
        return;
    std::vector<ProjectDevice> after = encoders();
    for (const Place number : numbers)
        if (const EncoderSession *connected = sessionOf(number))
            plannedEncoder(after, *connected);
    edit(std::move(after), tr("Encoders of the serial line"));
}

void LineKeeper::removeEncoder(Place number)
{
    if (m_line.training() != nullptr || linePlan(m_project.project(), m_line.id()) == nullptr)
        return;
    std::vector<ProjectDevice> after = encoders();
    std::erase_if(after, [number](const ProjectDevice &encoder) { return encoder.place() == number; });
    edit(std::move(after), tr("Remove %1").arg(number.shown()));
}

// What is planned for a training encoder is in no file, but still moves along.
void LineKeeper::moveEncoder(Place from, Place to)
{
    if (m_line.training() == nullptr || findDevice(m_project.project(), from) == nullptr)
        m_project.renumber(from, to, tr("Address of %1 to %2").arg(from.shown(), to.shown()));
}

} // namespace codewheel
