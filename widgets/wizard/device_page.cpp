// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/device_page.h"

#include "bus/buses.h"
#include "catalog/device_description.h"
#include "vocabulary/refusal_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"

#include <QListWidget>

#include <algorithm>

namespace codewheel {

DevicePage::DevicePage(Setup &setup, QWidget *parent)
    : WizardPage(setup, tr("Encoder"), parent)
    , m_list(describe(new QListWidget(this), "encoders", tr("Encoders of the bus"),
                      tr("The encoders of the bus. Nothing is sent by choosing one.")))
    , m_description(wrappedLabel(this))
    , m_problem(new InlineMessage(this))
{
    auto *question = new QLabel(tr("Which en&coder is to be set up?"), this);
    question->setBuddy(m_list);

    layOutColumn(this, {question, {m_list, 1}, m_description, m_problem}, {.spacing = grid::margin});
    setFocusProxy(m_list);
    connect(m_list, &QListWidget::itemSelectionChanged, this, &DevicePage::takeSelected);
}

void DevicePage::enter()
{
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    m_encoders.clear();
    if (m_setup.buses)
        for (const Place number : m_setup.buses->places())
            if (EncoderSession *encoder = m_setup.buses->encoder(number)) {
                m_encoders.push_back(encoder);
                m_list->addItem(new QListWidgetItem(
                    lineIcon(Icon::encoder),
                    QStringLiteral("%1  %2").arg(number.shown(), encoder->device().fullName())));
            }
    const auto current = std::ranges::find(m_encoders, m_setup.encoder.data());
    if (current != m_encoders.end())
        m_list->setCurrentRow(static_cast<int>(current - m_encoders.begin()));
    describeChosen();
}

// A list that gets the focus makes its first row the current one, without selecting it.
void DevicePage::takeSelected()
{
    const QList<QListWidgetItem *> selected = m_list->selectedItems();
    if (!selected.isEmpty())
        Q_EMIT encoderChosen(m_encoders.at(static_cast<std::size_t>(m_list->row(selected.front()))));
    describeChosen();
    Q_EMIT changed();
}

bool DevicePage::mayGoOn() const
{
    return m_setup.encoder && m_setup.encoder->can().writes;
}

void DevicePage::describeChosen()
{
    if (m_encoders.empty()) {
        m_description->setText(tr("There is no encoder on the bus. Start the bus first: Bus > Start."));
        return;
    }
    if (!m_setup.encoder) {
        m_description->setText(tr("Choose one with the arrow keys or the mouse."));
        return;
    }
    const DeviceDescription &device = m_setup.encoder->device();
    QStringList lines{tr("Description: %1").arg(device.manual)};
    if (device.isGeneric())
        lines += tr("The make of this encoder is not known. If you know it, name it in the bus structure: "
                    "then direction and errors are shown by name.");
    if (!device.notes.isEmpty())
        lines += device.notesText();
    m_description->setText(lines.join(QLatin1Char('\n')));
    if (!m_setup.encoder->can().writes)
        m_problem->showMessage(
            Role::attention,
            refusalText({RefusalKind::notSupported, RefusalId::writingNotSupported, {device.fullName()}}));
    else
        m_problem->withdraw();
}

} // namespace codewheel
