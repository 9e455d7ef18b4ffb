// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_sheet.h"

#include "cams/check_cams.h"

namespace codewheel {

CamSheet::CamSheet(ProjectDocument &project, QObject *parent)
    : QObject(parent)
{
    setDocument(*new CamDocument(project, {}, this));
}

void CamSheet::setDocument(CamDocument &document, const CamAbilities &abilities)
{
    if (m_document == &document && m_abilities == abilities)
        return;
    if (m_document)
        m_document->disconnect(this);
    m_document = &document;
    m_abilities = abilities;
    m_current = std::min(m_current, abilities.cams - 1);
    connect(m_document, &CamDocument::programChanged, this, &CamSheet::programChanged);
    Q_EMIT documentChanged();
}

void CamSheet::setNumber(unsigned number)
{
    if (number == m_number)
        return;
    m_number = number;
    Q_EMIT numberChanged(number);
}

void CamSheet::setCurrent(std::size_t cam)
{
    if (cam == m_current)
        return;
    m_current = cam;
    Q_EMIT currentChanged(cam);
}

void CamSheet::setLargest(std::optional<std::int64_t> largest)
{
    if (largest == m_largest)
        return;
    m_largest = largest;
    Q_EMIT largestChanged();
}

std::int64_t CamSheet::largest() const
{
    return m_largest.value_or(largestCamPosition);
}

Result<void> CamSheet::check(std::size_t number, const Cam &cam) const
{
    return codewheel::check(cam, number, m_abilities, largest());
}

void CamSheet::setKnown(const KnownPrograms &known)
{
    const KnownPrograms before = std::exchange(m_known, known);
    for (unsigned number = 1; number <= CamProgram::programs; ++number)
        if (before.at(number - 1) != known.at(number - 1))
            Q_EMIT programChanged(number);
}

std::optional<CamProgram> CamSheet::known(unsigned number) const
{
    const auto &known = m_known.at(number - 1);
    return known ? std::optional(known->program) : std::nullopt;
}

QString CamSheet::howKnown(unsigned number) const
{
    const auto &known = m_known.at(number - 1);
    return known ? known->how : QString();
}

std::optional<bool> CamSheet::differs(unsigned number) const
{
    const auto encoder = known(number);
    return encoder ? std::optional(*encoder != m_document->program(number)) : std::nullopt;
}

void CamSheet::setLive(const CamLive &live)
{
    if (live == m_live)
        return;
    const bool wasOld = std::exchange(m_live, live).isOld;
    Q_EMIT liveChanged();
    if (wasOld == isOld())
        return;
    for (unsigned number = 1; number <= CamProgram::programs; ++number)
        if (known(number))
            Q_EMIT programChanged(number);
}

std::optional<bool> CamSheet::isOn(std::size_t cam) const
{
    return m_live.on.at(cam);
}

void CamSheet::setCam(std::size_t cam, const Cam &value, const QString &what, Gesture gesture)
{
    if (!m_abilities.isCyclic && value.start > value.stop)
        return;
    CamProgram changed = program();
    changed.cam.at(cam) = value;
    m_document->setProgram(changed, what, gesture);
}

void CamSheet::setActive(std::size_t cam, bool active)
{
    Cam changed = this->cam(cam);
    changed.active = active;
    setCam(cam, changed, (active ? tr("Activate cam %1") : tr("Deactivate cam %1")).arg(cam));
}

void CamSheet::clear(std::size_t cam)
{
    setCam(cam, Cam(), tr("Clear cam %1").arg(cam));
}

void CamSheet::setShift(unsigned shift, Gesture gesture)
{
    CamProgram changed = program();
    changed.shift = shift;
    m_document->setProgram(changed, tr("Shift the position"), gesture);
}

} // namespace codewheel
