// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure_editor/insert_panel.h"

#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "ring/id_code.h"
#include "ring/ring_tree.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/structure_editor/plan_row.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QShortcut>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int visibleDevices = 5;
constexpr int codeRole = Qt::UserRole;
constexpr int keyRole = Qt::UserRole + 1;

// "37h", "37", "0x37"
std::optional<unsigned> hexByte(QString text)
{
    text = text.trimmed().toLower();
    if (text.startsWith(QStringLiteral("0x")))
        text.remove(0, 2);
    if (text.endsWith(u'h'))
        text.chop(1);
    bool isNumber = false;
    const unsigned value = text.toUInt(&isNumber, 16);
    return isNumber && value <= 0xFF ? std::optional(value) : std::nullopt;
}

QString offeredText(const Participant &device, const Catalog &catalog)
{
    return QStringLiteral("%1  (%2)").arg(planName(device, catalog), hexCode(device.deviceCode, 4));
}

} // namespace

InsertPanel::InsertPanel(const Catalog &catalog, QWidget *parent)
    : QWidget(parent)
    , m_catalog(catalog)
    , m_search(describe(new QLineEdit(this), "catalogSearch", tr("Search the catalog"),
                        tr("Shows the devices of the catalog that have this text")))
    , m_devices(describe(new QListWidget(this), "catalogDevices", tr("Devices of the catalog"),
                         tr("Enter or a double click inserts the device")))
    , m_idCode(describe(new QLineEdit(this), "insertIdCode", tr("ID code"),
                        tr("The low byte of the device code, hexadecimal: kind and direction")))
    , m_lengthCode(describe(new QLineEdit(this), "insertLengthCode", tr("Length code"),
                            tr("The high byte of the device code, hexadecimal: data width")))
    , m_reading(new QLabel(this))
    , m_where(describe(new QComboBox(this), "insertPlace", tr("Place"),
                       tr("Where the device is inserted, seen from the chosen one")))
    , m_insert(describe(new QPushButton(tr("&Insert device"), this), "insertDevice",
                        tr("Inserts the device at this place")))
    , m_change(describe(new QPushButton(tr("Chan&ge to it"), this), "changeDevice",
                        tr("Makes the chosen device of the bus one of these; station, group and addresses "
                           "stay")))
{
    makeFields();
    fillCatalog();
    setPlace({}, {});
    connect(m_search, &QLineEdit::textChanged, this, &InsertPanel::fillCatalog);
    connect(m_search, &QLineEdit::returnPressed, m_insert, &QPushButton::click);
    connect(m_devices, &QListWidget::currentRowChanged, this, [this] {
        m_byCode = false;
        choose();
    });
    connect(m_devices, &QListWidget::itemActivated, m_insert, &QPushButton::click);
    for (QLineEdit *field : {m_idCode, m_lengthCode}) {
        connect(field, &QLineEdit::textEdited, this, &InsertPanel::readCodes);
        connect(field, &QLineEdit::returnPressed, m_insert, &QPushButton::click);
    }
    connect(m_insert, &QPushButton::clicked, this, [this] {
        if (const auto device = chosen())
            Q_EMIT insertRequested(*device, place());
    });
    connect(m_change, &QPushButton::clicked, this, [this] {
        if (const auto device = chosen())
            Q_EMIT changeRequested(*device);
    });
}

void InsertPanel::makeFields()
{
    m_search->setPlaceholderText(tr("Search the catalog: maker, name, profile or ID code"));
    m_search->setClearButtonEnabled(true);
    m_devices->setFixedHeight(visibleDevices * (fontMetrics().height() + grid::unit) + grid::margin);
    for (QLineEdit *field : {m_idCode, m_lengthCode}) {
        field->setFont(numberFont());
        field->setMaxLength(4);
        field->setFixedWidth(field->fontMetrics().horizontalAdvance(u'0') * 4 + 5 * grid::margin);
    }
    m_idCode->setPlaceholderText(QStringLiteral("BEh"));
    m_lengthCode->setPlaceholderText(QStringLiteral("81h"));
    m_reading->setObjectName(QStringLiteral("insertReading"));
    m_reading->setWordWrap(true);
    m_where->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);

    const auto label = [this](const QString &text, QWidget *buddy) {
        auto *made = new QLabel(text, this);
        made->setBuddy(buddy);
        return made;
    };
    auto *codes = new QHBoxLayout;
    codes->setSpacing(grid::groupGap);
    codes->addWidget(m_idCode);
    codes->addWidget(label(tr("&Length code"), m_lengthCode));
    codes->addWidget(m_lengthCode);
    codes->addWidget(m_reading, 1);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(grid::groupGap);
    buttons->addWidget(m_where, 1);
    buttons->addWidget(m_insert);
    buttons->addWidget(m_change);
    auto *fields = new QGridLayout(this);
    fields->setContentsMargins({});
    fields->setVerticalSpacing(grid::unit);
    fields->addWidget(label(tr("C&atalog"), m_search), 0, 0);
    fields->addLayout(makeSearchRow(), 0, 1);
    fields->addWidget(m_devices, 1, 1);
    fields->addWidget(label(tr("I&D code"), m_idCode), 2, 0);
    fields->addLayout(codes, 2, 1);
    fields->addWidget(label(tr("&Place"), m_where), 3, 0);
    fields->addLayout(buttons, 3, 1);
}

QHBoxLayout *InsertPanel::makeSearchRow()
{
    auto *close = describe(new QToolButton(this), "closeInsert", tr("Close the insert panel"),
                           tr("Closes this panel (Esc)"));
    close->setIcon(lineIcon(Icon::cancel));
    close->setAutoRaise(true);
    connect(close, &QToolButton::clicked, this, &InsertPanel::closeRequested);
    auto *escape = new QShortcut(Qt::Key_Escape, this);
    escape->setContext(Qt::WidgetWithChildrenShortcut);
    connect(escape, &QShortcut::activated, this, &InsertPanel::closeRequested);
    auto *row = new QHBoxLayout;
    row->setSpacing(grid::unit);
    row->addWidget(m_search, 1);
    row->addWidget(close);
    return row;
}

void InsertPanel::focusSearch()
{
    m_search->setFocus();
    m_search->selectAll();
}

void InsertPanel::fillCatalog()
{
    m_devices->clear();
    const auto add = [this](const Participant &device) {
        const QString text = offeredText(device, m_catalog);
        if (!text.contains(m_search->text().trimmed(), Qt::CaseInsensitive))
            return;
        auto *item = new QListWidgetItem(text, m_devices);
        item->setData(codeRole, device.deviceCode);
        item->setData(keyRole, device.deviceKey);
    };
    add(deviceOf(busTerminalIdCode));
    for (const DeviceDescription &device : m_catalog.devices()) {
        if (device.profile == Profile::esc)
            continue; // no bus
        Participant participant = deviceOf(device.deviceCode);
        participant.inWords = device.inWords;
        participant.outWords = device.outWords;
        participant.deviceKey = device.isGeneric() ? QString() : device.key;
        add(participant);
    }
    if (m_devices->count() > 0)
        m_devices->setCurrentRow(0);
    choose();
}

void InsertPanel::readCodes()
{
    m_byCode = !m_idCode->text().isEmpty() || !m_lengthCode->text().isEmpty();
    choose();
}

std::optional<Participant> InsertPanel::chosen() const
{
    if (m_byCode) {
        const auto id = hexByte(m_idCode->text());
        const auto length =
            hexByte(m_lengthCode->text().isEmpty() ? QStringLiteral("0") : m_lengthCode->text());
        return id && length ? std::optional(deviceOf(*length << 8 | *id)) : std::nullopt;
    }
    const QListWidgetItem *item = m_devices->currentItem();
    if (item == nullptr)
        return std::nullopt;
    Participant device = deviceOf(item->data(codeRole).toUInt());
    device.deviceKey = item->data(keyRole).toString();
    if (const DeviceDescription *described = m_catalog.find(device.deviceKey)) {
        device.inWords = described->inWords;
        device.outWords = described->outWords;
    }
    return device;
}

// What will be inserted, in words.
void InsertPanel::choose()
{
    const auto device = chosen();
    m_insert->setEnabled(device.has_value());
    m_change->setEnabled(device && m_current);
    if (!device)
        m_reading->setText(m_byCode ? tr("Codes are two hexadecimal digits, such as BEh and 81h.")
                                    : QString());
    else
        m_reading->setText(tr("%1: %2, words: IN %3, OUT %4")
                               .arg(hexCode(device->deviceCode, 4), planName(*device, m_catalog))
                               .arg(device->inWords)
                               .arg(device->outWords));
    if (device)
        preferPlace();
}

void InsertPanel::setPlace(const RingStructure &structure, std::optional<std::size_t> current)
{
    m_structure = structure;
    m_current = current;
    fillPlaces();
    choose();
}

void InsertPanel::fillPlaces()
{
    m_where->clear();
    m_places.clear();
    const auto add = [this](const QString &text, const RingPlace &place) {
        m_where->addItem(text);
        m_places.push_back(place);
    };
    if (!m_current) {
        add(tr("At the end"), {.terminal = {}, .onLocalBus = false, .row = m_structure.size()});
        return;
    }
    const QString number = m_structure[*m_current].number.toString();
    RingPlace behind = placeOf(m_structure, *m_current);
    const RingPlace before = behind;
    ++behind.row;
    add(tr("Behind %1").arg(number), behind);
    add(tr("Before %1").arg(number), before);
    if (m_structure[*m_current].idCode != busTerminalIdCode)
        return;
    const RingTree tree = ringTree(m_structure);
    const RingTree::Node &terminal = tree.nodes[*m_current];
    add(tr("On the local bus of %1").arg(number),
        {.terminal = m_current, .onLocalBus = true, .row = terminal.localBus.size()});
    add(tr("In the branch of %1").arg(number),
        {.terminal = m_current, .onLocalBus = false, .row = terminal.branch.size()});
}

// A device of a local bus behind a bus terminal is meant for that one's.
void InsertPanel::preferPlace()
{
    const auto device = chosen();
    const auto local = std::ranges::find_if(
        m_places, [this](const RingPlace &place) { return place.onLocalBus && place.terminal == m_current; });
    if (!device || local == m_places.end())
        return;
    const int localRow = static_cast<int>(local - m_places.begin());
    if (prefersLocalBus(*device))
        m_where->setCurrentIndex(localRow);
    else if (m_where->currentIndex() == localRow)
        m_where->setCurrentIndex(0);
}

RingPlace InsertPanel::place() const
{
    return m_places.at(static_cast<std::size_t>(m_where->currentIndex()));
}

} // namespace codewheel
