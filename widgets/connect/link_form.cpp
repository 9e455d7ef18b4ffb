// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/connect/link_form.h"

#include <QSignalBlocker>

#include <utility>

namespace codewheel {

void LinkForm::makeFields()
{
    if (std::exchange(m_hasFields, true))
        return;
    {
        const QSignalBlocker nobodyHasEdited(this);
        addFields();
        if (m_ports)
            showPorts(m_ports->rows, m_ports->trouble);
    }
    m_ports.reset();
    Q_EMIT fieldsMade();
}

void LinkForm::setPorts(const std::vector<PortRow> &ports, const Trouble &trouble)
{
    if (m_hasFields)
        showPorts(ports, trouble);
    else
        m_ports = Ports{ports, trouble};
}

} // namespace codewheel
