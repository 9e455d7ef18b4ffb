// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/esc/esc_line_keeper.h"

#include "app/window/kinds/esc/esc_line_at_work.h"
#include "kinds/esc/protocol/esc_forms.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "project/bus_kind.h"
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
    const KindData explained = connected.valueOptions();
    const auto *options = explained.as<EscValueOptions>();
    encoder.set(EscEncoderSettings{.swapsWarningBytes = options != nullptr && options->swapsWarningBytes});
    return *encoders.insert(place, std::move(encoder));
}

} // namespace

EscLineKeeper::EscLineKeeper(const EscLineAtWork &line, ProjectDocument &project, QObject *parent)
    : QObject(parent)
    , m_line(line)
    , m_project(project)
{}

EscLinePlan EscLineKeeper::line() const
{
    const EscLinePlan *planned = linePlan(m_project.project(), m_line.id());
    return planned ? *planned : m_line.openedPlan();
}

std::vector<ProjectDevice> EscLineKeeper::encoders() const
{
    const auto planned = devicesOn(m_project.project(), m_line.id());
    return {planned.begin(), planned.end()};
}

void EscLineKeeper::edit(const EscLinePlan &after, const QString &what)
{
    Project project = m_project.project();
    setLinePlan(project, m_line.id(), after);
    m_project.edit(std::move(project), what);
}

void EscLineKeeper::edit(std::vector<ProjectDevice> after, const QString &what)
{
    Project project = m_project.project();
    setLinePlan(project, m_line.id(), line());
    setDevicesOn(project, m_line.id(), std::move(after));
    m_project.edit(std::move(project), what);
}

void EscLineKeeper::keepPort(const EscLinePlan &line)
{
    edit(m_line.asOpened(line), tr("Serial line"));
}

void EscLineKeeper::keepFractionBits(int bits)
{
    if (m_line.training() != nullptr)
        return;
    EscLinePlan after = line();
    after.settings.fractionBits = bits;
    edit(after, tr("Fraction bits of the scaling factor"));
}

void EscLineKeeper::keepBaudRate(int baudRate)
{
    EscLinePlan after = line();
    after.settings.serial.baudRate = baudRate;
    after.settings.timing.character = after.settings.serial.timeOf(1);
    edit(after, tr("Baud rate of the serial line"));
}

void EscLineKeeper::keepByteOrder(Place number, bool isSwapped)
{
    const EscEncoderSettings settings{.swapsWarningBytes = isSwapped};
    std::vector<ProjectDevice> after = encoders();
    const auto planned = std::ranges::find(after, number, &ProjectDevice::place);
    const bool isThere = m_line.session() != nullptr && m_line.session()->encoder(number) != nullptr;
    if (const EncoderSession *connected = sessionOf(number))
        plannedEncoder(after, *connected).set(settings);
    else if (planned != after.end() && !isThere)
        planned->set(settings);
    else
        return;
    edit(std::move(after), tr("Warning bytes of %1").arg(number.shown()));
}

// Also null at the training line.
const EncoderSession *EscLineKeeper::sessionOf(Place number) const
{
    const bool isKept = m_line.session() != nullptr && m_line.training() == nullptr;
    return isKept ? m_line.session()->encoder(number) : nullptr;
}

void EscLineKeeper::keepEncoders(const std::vector<Place> &numbers)
{
    if (m_line.training() != nullptr || numbers.empty())
        return;
    std::vector<ProjectDevice> after = encoders();
    for (const Place number : numbers)
        if (const EncoderSession *connected = sessionOf(number))
            plannedEncoder(after, *connected);
    edit(std::move(after), tr("Encoders of the serial line"));
}

void EscLineKeeper::removeEncoder(Place number)
{
    if (m_line.training() != nullptr || linePlan(m_project.project(), m_line.id()) == nullptr)
        return;
    std::vector<ProjectDevice> after = encoders();
    std::erase_if(after, [number](const ProjectDevice &encoder) { return encoder.place() == number; });
    edit(std::move(after), tr("Remove %1").arg(number.shown()));
}

// At the training line only if the project's own is not at a port. What is planned for a training encoder is
// in no file, but still moves along.
void EscLineKeeper::moveEncoder(Place from, Place to)
{
    const Project &project = m_project.project();
    const bool isProjects = m_line.training() == nullptr || plansTraining(project, m_line.id());
    if (!isProjects && findDevice(project, from) != nullptr)
        return;
    const ParameterValue reached{Parameter::lineAddress, EscLineAddress::of(to.node).value};
    m_project.renumber(from, to, tr("Address of %1 to %2").arg(from.shown(), to.shown()),
                       [&](ProjectDevice &device) { std::erase(device.wanted, reached); });
}

} // namespace codewheel
