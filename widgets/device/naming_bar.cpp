// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/device/naming_bar.h"

#include "bus/bus_outline.h"
#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "vocabulary/refusal_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace codewheel {

bool isCoupler(const EncoderBus &bus, Place place)
{
    const std::vector<BusNode> nodes = bus.outline().nodes();
    const auto node = std::ranges::find(nodes, place.node, &BusNode::node);
    return node != nodes.end() && node->isCoupler;
}

NamingBar::NamingBar(const Catalog &catalog, QWidget *parent)
    : QWidget(parent)
    , m_catalog(catalog)
    , m_question(new QLabel(this))
    , m_key(describe(new QLineEdit(this), "labelKey", tr("Key on the label"),
                     tr("Type the key on the label of the encoder. Spaces, dots and dashes do not matter.")))
    , m_choice(describe(new QComboBox(this), "makes", tr("Encoder"),
                        tr("The encoders of the catalog with this device code")))
    , m_name(describe(new QPushButton(tr("Name it"), this), "nameIt",
                      tr("Treats the device as this encoder from now on. Nothing is sent; what was known of "
                         "it is forgotten.")))
    , m_reading(new QLabel(this))
    , m_message(new InlineMessage(this))
{
    m_question->setWordWrap(true);
    m_reading->setWordWrap(true);
    m_key->setPlaceholderText(QStringLiteral("OCD-IBA1B-1213-C100-PRI"));
    m_key->setClearButtonEnabled(true);
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);

    auto *fields = new QFormLayout;
    fields->setRowWrapPolicy(QFormLayout::WrapLongRows);
    auto *keyLabel = new QLabel(tr("Label key"), this);
    keyLabel->setBuddy(m_key);
    fields->addRow(keyLabel, m_key);
    auto *choiceLabel = new QLabel(tr("Encoder"), this);
    choiceLabel->setBuddy(m_choice);
    fields->addRow(choiceLabel, m_choice);

    auto *rows = layOut<QVBoxLayout>(this, grid::unit);
    rows->addWidget(m_question);
    rows->addLayout(fields);
    rows->addWidget(m_reading);
    rows->addWidget(m_message);
    rows->addWidget(m_name, 0, Qt::AlignLeft);

    setFocusProxy(m_key);
    m_reading->hide();
    connect(m_key, &QLineEdit::textChanged, this, &NamingBar::read);
    connect(m_key, &QLineEdit::editingFinished, this, &NamingBar::tellProblem);
    connect(m_choice, &QComboBox::activated, m_message, &InlineMessage::withdraw);
    connect(m_name, &QPushButton::clicked, this, &NamingBar::name);
    ask();
    fillChoices();
}

void NamingBar::setPlace(EncoderBus *bus, std::optional<Place> number)
{
    auto device = bus != nullptr && number && !isCoupler(*bus, *number) ? bus->found(*number) : std::nullopt;
    if (m_bus == bus && m_number == number && m_device == device)
        return;
    m_bus = bus;
    m_number = number;
    m_device = std::move(device);
    m_key->clear();
    m_message->withdraw();
    ask();
    fillChoices();
}

void NamingBar::focusKey()
{
    m_key->setFocus();
    m_key->selectAll();
}

void NamingBar::ask()
{
    m_question->setVisible(m_device.has_value());
    if (!m_device)
        return;
    const QString place = m_device->number.toString();
    m_question->setText(m_device->deviceKey.isEmpty()
                            ? tr("Which encoder is %1? The bus tells its device code (%2) but not its make.")
                                  .arg(place, hexCode(m_device->deviceCode, 4))
                            : tr("%1 has been named. Choose \"make not known\" to undo that.").arg(place));
}

void NamingBar::fillChoices()
{
    m_choice->clear();
    if (m_device) {
        m_choice->addItem(tr("make not known"), QString());
        for (const DeviceDescription &device : m_catalog.devices())
            if (!device.isGeneric() && device.deviceCode == m_device->deviceCode)
                m_choice->addItem(device.fullName(), device.key);
        m_choice->setCurrentIndex(std::max(0, m_choice->findData(m_device->deviceKey)));
    }
    m_choice->setEnabled(m_choice->count() > 1);
    m_name->setEnabled(m_choice->count() > 1);
}

// While a key is being typed it is always incomplete, so that is reported only when the typing ends.
void NamingBar::read(const QString &typed)
{
    m_message->withdraw();
    m_matches.clear();
    m_problem.reset();
    if (!typed.trimmed().isEmpty()) {
        if (auto matches = findByLabel(m_catalog, typed))
            m_matches = std::move(*matches);
        else
            m_problem = matches.error();
    }
    if (m_problem && !std::get<QString>(m_problem->arguments.at(1)).isEmpty())
        tellProblem();
    chooseMatch();
    Q_EMIT lookedUp();
}

void NamingBar::tellProblem()
{
    if (m_problem)
        m_message->showMessage(Role::attention, refusalText(*m_problem));
}

void NamingBar::chooseMatch()
{
    m_reading->setVisible(!m_matches.empty());
    if (m_matches.empty())
        return;
    QStringList names;
    for (const LabelMatch &match : m_matches)
        names << match.device->fullName();
    const LabelMatch &first = m_matches.front();
    m_reading->setText(tr("%1: %2 turns, %3 steps per turn")
                           .arg(names.join(tr(" or ")), QLocale().toString(first.turns),
                                QLocale().toString(first.stepsPerTurn)));
    if (!m_number || !m_bus)
        return;
    for (const LabelMatch &match : m_matches)
        if (const int row = m_choice->findData(match.device->key); row >= 0) {
            m_choice->setCurrentIndex(row);
            return;
        }
    if (const auto can = m_bus->canBe(*m_number, *first.device); !can)
        m_message->showMessage(Role::attention, refusalText(can.error()));
}

void NamingBar::name()
{
    if (!m_device || !m_bus)
        return;
    const QString key = m_choice->currentData().toString();
    int turns = 0;
    int stepsPerTurn = 0;
    for (const LabelMatch &match : m_matches)
        if (match.device->key == key) {
            turns = match.turns;
            stepsPerTurn = match.stepsPerTurn;
        }
    const auto named = m_bus->name(*m_number, key, turns, stepsPerTurn);
    if (named)
        m_key->clear();
    else
        m_message->showMessage(Role::attention, refusalText(named.error()));
}

} // namespace codewheel
