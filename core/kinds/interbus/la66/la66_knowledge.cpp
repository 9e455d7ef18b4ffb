// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/la66/la66_knowledge.h"

#include "kinds/interbus/words/la66_word.h"

namespace codewheel {

void La66Knowledge::observe(Word in, Instant now)
{
    const bool serviceMode = la66::isServiceMode(in);
    if (serviceMode && !m_serviceMode && la66::isService(in)) // one with the error bit changed nothing
        observeAnswer(in, now);
    m_serviceMode = serviceMode;
}

void La66Knowledge::observeAnswer(Word in, Instant now)
{
    const unsigned service = la66::service(in);
    const bool written = la66::isWrite(in);
    if (written && !m_othersWrite)
        m_values.countEepromWrite();
    const ParameterDescription *parameter =
        written ? findNumber(m_device, service) : findReadOut(m_device, service);
    if (parameter != nullptr)
        m_values.learn(
            {parameter->parameter, la66::data(in), written ? Evidence::echoed : Evidence::read, now});
}

} // namespace codewheel
