// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/esc/esc_line_keeper.h"

#include "app/window/kinds/esc/esc_line_at_work.h"
#include "kinds/esc/protocol/esc_forms.h"
#include "kinds/esc/protocol/esc_line_address.h"
#include "project/bus_kind.h"
#include "widgets/project/project_document.h"

#include <algorithm>

namespace codewheel {

EscLineKeeper::EscLineKeeper(const EscLineAtWork &line, QObject *parent)
    : AskedBusKeeper(line, {tr("Serial line"), tr("Encoders of the serial line")}, parent)
    , m_line(line)
{}

void EscLineKeeper::takeUp(ProjectDevice &encoder, const EncoderSession &connected) const
{
    const KindData explained = connected.valueOptions();
    const auto *options = explained.as<EscValueOptions>();
    encoder.set(EscEncoderSettings{.swapsWarningBytes = options != nullptr && options->swapsWarningBytes});
}

void EscLineKeeper::keepFractionBits(int bits)
{
    if (m_line.training() != nullptr)
        return;
    EscLinePlan after = line();
    after.settings.fractionBits = bits;
    edit(KindData(after), tr("Fraction bits of the scaling factor"));
}

void EscLineKeeper::keepBaudRate(int baudRate)
{
    EscLinePlan after = line();
    after.settings.serial.baudRate = baudRate;
    after.settings.timing.character = after.settings.serial.timeOf(1);
    edit(KindData(after), tr("Baud rate of the serial line"));
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

// At the training line only if the project's own is not at a port. What is planned for a training encoder is
// in no file, but still moves along.
void EscLineKeeper::moveEncoder(Place from, Place to)
{
    const Project &project = m_line.project().project();
    const bool isProjects = m_line.training() == nullptr || plansTraining(project, m_line.id());
    if (!isProjects && findDevice(project, from) != nullptr)
        return;
    const ParameterValue reached{Parameter::lineAddress, EscLineAddress::of(to.node).value};
    m_line.project().renumber(from, to, tr("Address of %1 to %2").arg(from.shown(), to.shown()),
                              [&](ProjectDevice &device) { std::erase(device.wanted, reached); });
}

} // namespace codewheel
